"""The page in a browser: its pictures beside those of `nearfar.render`, and what it says of damage."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

import nearfar as nf
from nearfar.serve._server import Server
from tests.support.browser import opened, still, wait_for_ring
from tests.support.page_pictures import camera, off

pytestmark = pytest.mark.slow

SIZE = (360, 240)
CENTER = (3.0, 1.7, -2.0)
RADII = (10.0, 22.0, 63.0)
PITCH = -0.1


@pytest.fixture(scope="module")
def bundle(tmp_path_factory: pytest.TempPathFactory) -> nf.stream.Bundle:
    folder = tmp_path_factory.mktemp("view") / "bundle"
    scene = nf.datasets.city(blocks=3, detail=1)
    settings: dict[str, Any] = {"face_size": 256, "quality": None, "pixels_per_degree": None}
    return nf.stream.export(scene, folder, center=CENTER, radii=RADII, **settings)


def test_ring_0_is_the_map_and_what_moves(chromium: Any, bundle: nf.stream.Bundle) -> None:
    with Server.of_bundle(bundle._reader.place) as server, opened(chromium, *SIZE) as shown:
        # No file of ring 1 ever comes.
        shown.route("**/*.bin", lambda route: route.abort())
        shown.goto(f"{server.url}?aa=0&rings=1")
        assert wait_for_ring(shown, 0) == ""
        picture = {"ring": 0, "radius": 0.0, "strength": 0.0}
        found = still(shown, picture, {"position": list(CENTER), "yaw": 0.3, "pitch": PITCH})
    frame = bundle.at(0).render(camera(CENTER, 0.3, PITCH, SIZE), channels=("color",))
    assert (off(frame, found) <= 2).mean() > 0.95


@pytest.mark.parametrize("damage", ["cut", "missing", "newer"])
def test_damage_is_told(chromium: Any, bundle: nf.stream.Bundle, damage: str) -> None:
    place = Path(bundle._reader.place)
    manifest = json.loads((place / "manifest.json").read_text())
    name = manifest["regions"][0]["rings"][2]["geometry"]
    with Server.of_bundle(place) as server, opened(chromium, *SIZE) as shown:
        if damage == "newer":
            shown.route("**/manifest.json", lambda route: route.fulfill(body=json.dumps({**manifest, "version": 2})))
        elif damage == "missing":
            shown.route(f"**/{name}", lambda route: route.fulfill(status=404))
        else:
            content = (place / name).read_bytes()
            shown.route(f"**/{name}", lambda route: route.fulfill(body=content[:-5] + b"12345"))
        shown.goto(server.url)
        told = wait_for_ring(shown, len(RADII))
        assert ("newer nearfar" if damage == "newer" else name) in told
        if damage != "newer":
            # The picture before stays on the screen.
            assert shown.evaluate("() => window.nearfar.viewer.facts.arrived") == 1
