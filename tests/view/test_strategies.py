"""The page's strategy vis1: the picture while its files arrive, and at the end."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import nearfar as nf
from nearfar.serve._server import Server
from tests.support.browser import open_page, wait_until
from tests.support.bundled_scenes import bundled_scenes
from tests.support.page_pictures import camera, off
from tests.support.stepped_page import SteppedPage

pytestmark = pytest.mark.slow

SIZE = (300, 200)
CENTER = (3.0, 1.7, -2.0)
POSE = {"position": list(CENTER), "yaw": 0.0, "pitch": 0.0}


def test_vis1_shows_objects_as_they_arrive_and_the_map_last(chromium: Any, tmp_path: Path) -> None:
    settings: dict[str, Any] = {"face_size": 256, "quality": None, "by_footprint": True}
    bundle = nf.stream.export(bundled_scenes()["city"], tmp_path / "b", center=CENTER, radii=(10.0, 40.0), **settings)
    entry = bundle._manifest["regions"][0]["by_footprint"]
    # The ring that represents the map.
    last, held = len(entry["portions"]) + 1, list[Any]()
    with Server.of_bundle(bundle._reader.location) as server, open_page(chromium, *SIZE) as shown:
        shown.route(f"**/{entry['map']['color'][3]}", lambda route: held.append(route))
        shown.goto(f"{server.url}?strategy=vis1&aa=0")
        page = SteppedPage(shown)
        wait_until(shown, lambda: page.frame(POSE, 0.1)["arrived"] == last - 1)
        # Where there is no near object, nothing is shown.
        is_black = (page.picture(POSE, 0.1)[1] == 0).all(axis=-1)
        assert 0.05 < is_black.mean() < 0.9
        held[0].continue_()
        wait_until(shown, lambda: page.frame(POSE, 0.1)["arrived"] == last)
        whole = page.picture(POSE, 0.1)[1]
        assert shown.printed == []
    assert (whole == 0).all(axis=-1).mean() < 0.01
    # The last ring as its centre sees it, where objects without a footprint are hidden.
    frame = bundle.at(bundle.count).render(camera(CENTER, 0.0, 0.0, SIZE), channels=("color",))
    assert (off(frame, whole) <= 3).mean() > 0.97
