"""A bundle of large files that are drawn quickly, and pages that exchange its files."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from tests.support.browser import SMALL, open_page, wait_until

RADII = (4.0, 7.0)
PANELS = 3
"""Panels that begin in each ring."""

TOLD = """() => {
  const { room, viewer } = window.nearfar ?? {};
  if (!room) return null;
  const { refusal, open, dropped, counts } = room.peers;
  return { user: room.connection.state.user ?? null, refusal: refusal === undefined ? 'unknown' : refusal, open,
    dropped: Object.fromEntries(dropped), ...counts, arrived: viewer.facts.arrived,
    hasAll: viewer.facts.arrived >= 0 && viewer.facts.received >= viewer.facts.expected };
}"""


def panels(texels: int = 320) -> nf.Scene:
    """A floor and panels around the origin, each with a picture of incompressible noise."""
    draw = np.random.default_rng(3)
    builder = nf.SceneBuilder()
    uvs = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
    faces = [[0, 1, 2], [0, 2, 3]]
    builder.instance(builder.mesh([[-20, 0, -20], [-20, 0, 20], [20, 0, 20], [20, 0, -20]], faces), name="floor")
    for number in range(PANELS * len(RADII)):
        image = np.full((texels, texels, 4), 255, np.uint8)
        image[..., :3] = draw.integers(0, 256, (texels, texels, 3))
        corners = np.column_stack([uvs * (1.2, 1.2) + (-0.6, 1.0), np.zeros(4)])
        mesh = builder.mesh(corners, faces, material=builder.material(texture=image), uvs=uvs)
        turn, away = 2.4 * number, RADII[number // PANELS] - 1.5
        place = np.eye(4)
        place[:3, :3] = [[np.cos(turn), 0, np.sin(turn)], [0, 1, 0], [-np.sin(turn), 0, np.cos(turn)]]
        place[:3, 3] = -away * np.sin(turn), 0, -away * np.cos(turn)
        builder.instance(mesh, place, name=f"panel {number}")
    return builder.build()


def export(folder: Path) -> nf.stream.Bundle:
    """The bundle of the panels: its pictures are separate files."""
    settings: dict[str, Any] = {"quality": None, "pixels_per_degree": None, "samples": 1, "face_size": 64}
    return nf.stream.export(panels(), folder, center=(0.0, 1.7, 0.0), radii=RADII, **settings)


class PeerPage:
    """A page that has opened a room, and the cost of its files."""

    def __init__(self, page: Any) -> None:
        self.page = page
        self.files: list[str] = []
        """Names of files requested from the server."""
        page.on("request", lambda request: self._count(request.url))

    def _count(self, url: str) -> None:
        found = re.search(r"/(files/[\w.]+)$", url)
        if found:
            self.files.append(found[1])

    def open(self, url: str, room: str, more: str = "") -> None:
        """Go to a room without waiting."""
        self.page.goto(f"{url}?aa=0&strategy=clovrd&room={room}{more}", wait_until="commit")

    def facts(self) -> dict[str, Any] | None:
        """Facts of the exchange; None before the page is in the room."""
        found = self.page.evaluate(TOLD)
        return None if found is None else dict(found)

    def wait(self, ring: int = len(RADII)) -> dict[str, Any]:
        """Wait until a ring is shown; returns the facts then."""
        wait_until(self.page, lambda: (self.facts() or {"arrived": -1})["arrived"] >= ring)
        assert self.page.evaluate("() => document.querySelector('#message').textContent") == ""
        return self.facts() or {}

    def wait_for_files(self) -> dict[str, Any]:
        """Wait until the first picture and all files are loaded, drawn or not; returns the facts then."""
        wait_until(self.page, lambda: (self.facts() or {"hasAll": False})["hasAll"])
        return self.facts() or {}

    def rest(self) -> None:
        """Stop drawing, and continue everything else: browsers that draw in software leave no time for other pages."""
        self.page.evaluate("() => window.nearfar.viewer.renderer.setAnimationLoop(null)")


@contextmanager
def peer_page(chromium: Any, size: tuple[int, int] = SMALL) -> Iterator[PeerPage]:
    """A page in a separate context, which shares no cache with others."""
    with open_page(chromium, *size) as page:
        yield PeerPage(page)


def bytes_of(folder: Path, pages: list[PeerPage]) -> int:
    """Bytes of the bundle's files in a folder that were requested from the server."""
    return sum((folder / name).stat().st_size for page in pages for name in page.files)
