"""The page on a scene whose regions are made on demand: coarse and full maps, walking on, jumps, refusals."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar._trace import viewpoint
from nearfar.serve._scene import LoadedScene
from nearfar.serve._server import Server
from nearfar.serve._site import Site
from nearfar.stream._on_demand import OnDemand
from tests.support.browser import opened, wait_until
from tests.support.stepped_page import SteppedPage

pytestmark = pytest.mark.slow

SIZE = (360, 240)
SETTINGS: dict[str, Any] = {"grid": 2.0, "radii": (10.0, 22.0, 63.0), "face_size": 768, "samples": 1}
RINGS = len(SETTINGS["radii"])
NEAR_SHARE = 0.7
START = (3.0, 1.75, -2.0)
MESSAGE = "() => document.querySelector('#message').textContent"
PLACE = "() => [...document.querySelectorAll('dt')].find((line) => line.textContent === 'Place').nextSibling.textContent"


@pytest.fixture(scope="module")
def city() -> nf.Scene:
    return nf.datasets.city(blocks=3, detail=1)


@pytest.fixture(scope="module")
def server(city: nf.Scene, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    scene = LoadedScene(lambda: city, title="city", start=lambda _: viewpoint.facing(START, (3, 1.75, -9)), **SETTINGS)
    with Server({"": Site.of_scene(scene, tmp_path_factory.mktemp("regions"))}) as running:
        yield running


def pose(x: float, z: float, yaw: float = 0.3) -> dict[str, Any]:
    return {"position": [x, START[1], z], "yaw": yaw, "pitch": -0.1}


def link(place: dict[str, Any]) -> str:
    return f"#p={','.join(map(str, place['position']))}&yaw={place['yaw']}&pitch={place['pitch']}"


def until(page: SteppedPage, place: dict[str, Any], happened: Callable[[dict[str, Any]], bool]) -> dict[str, Any]:
    """Draw frames until one of them tells what is asked for; returns what it tells."""
    told: dict[str, Any] = {}

    def has_happened() -> bool:
        nonlocal told
        told = page.frame(place, 0.05)
        return happened(told)

    wait_until(page.page, has_happened)
    return told


def is_refined(told: dict[str, Any]) -> bool:
    """All rings are shown, and the maps of full size after them."""
    shown = told["shown"]
    return not told["isLoading"] and told["leaving"] is None and shown is not None and shown["fading"] is None


def grown(page: SteppedPage, place: dict[str, Any]) -> tuple[dict[str, Any], NDArray[np.uint8]]:
    """What is told, and the picture, when nothing changes any more."""
    until(page, place, is_refined)
    for _ in range(8):
        page.frame(place, 60.0)
    return page.picture(place, 0.0)


def test_coarse_maps_come_first_and_then_the_picture_of_the_bundle(
    chromium: Any, city: nf.Scene, server: Server, tmp_path: Path
) -> None:
    here = pose(3.4, -2.6)
    asked: list[str] = []
    with opened(chromium, *SIZE) as shown:
        shown.on("request", lambda request: asked.append(request.url))
        shown.goto(f"{server.url}?aa=0{link(here)}")
        page = SteppedPage(shown)
        told = until(page, here, lambda told: told["shown"] is not None)
        # Complete with ring 0 alone: no pixel is blank.
        assert (told["arrived"], told["shown"]["ring"]) == (0, 0)
        _, coarse = page.picture(here, 0.0)
        assert (coarse.max(axis=-1) > 0).mean() > 0.999
        told, refined = grown(page, here)
        assert told["shown"]["ring"] == told["arrived"] == RINGS + 1
        assert told["shown"]["grown"] == {"radius": SETTINGS["radii"][-1], "strength": 1}
        assert shown.printed == []
    assert [url for url in asked if "/at/" in url] == [f"{server.url}at/4,1.75,-2/parts"]
    nf.stream.export(city, tmp_path / "out", center=(4, 1.75, -2), **{**SETTINGS, "grid": None})
    with Server.of_bundle(tmp_path / "out") as bundle, opened(chromium, *SIZE) as shown:
        shown.goto(f"{bundle.url}?aa=0{link(here)}")
        told, expected = grown(SteppedPage(shown), here)
        assert told["shown"]["ring"] == RINGS
    off = np.abs(refined.astype(int) - expected).max(axis=-1)
    assert (off <= 2).mean() >= 0.999
    assert np.abs(coarse.astype(int) - expected).max(axis=-1).mean() > 1
