"""Near leaves as geometry in the page that flies trees, in a browser: beside Python's pictures, and if files fail."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.serve._server import Server
from tests.support.browser import open_page
from tests.support.flown_page import (
    SIZE,
    Pose,
    grabbed,
    holes,
    likeness,
    link,
    open_flight,
    page_camera,
    problems,
    rendered,
)
from tests.support.range_server import serve_folder

pytestmark = pytest.mark.slow

NEAR: Pose = {"position": [3.0, 14.0, 34.0], "yaw": 0.5, "pitch": -0.2}
STREET: Pose = {"position": [20.0, 3.0, 22.0], "yaw": 0.7, "pitch": 0.25}
WALL: Pose = {"position": [0.0, 3.0, 9.0], "yaw": 0.2, "pitch": -0.1}


@pytest.mark.parametrize(("pose", "least", "samples"), [(STREET, 0.99, 1), (NEAR, 0.99, 4)])
def test_pictures_equal_render_with_geometry(
    chromium: Any, city: nf.orthoview.OrthoTree, pose: Pose, least: float, samples: int
) -> None:
    with Server.of_bundle(city.path) as server, open_page(chromium, *SIZE) as page:
        told = open_flight(page, f"{server.url}?samples={samples}{link(pose)}")
        found = grabbed(page)
        assert page.printed == []
        assert problems(page) == []
    frame = rendered(city, pose, samples, geometry=True)
    assert told["views"] == frame.stats["views"]
    assert told["leaves"] >= frame.stats["leaves"] > 0
    assert told["triangles"] > 0
    assert told["standIns"] == told["holes"] == 0
    assert likeness(found, frame) > least
    assert likeness(found, frame) > likeness(found, rendered(city, pose, samples)) + 0.02
    assert holes(found, frame) < 0.001


def test_textures_and_colours_are_drawn(chromium: Any, textured: nf.orthoview.OrthoTree) -> None:
    with serve_folder(Path(textured.path)) as server, open_page(chromium, *SIZE) as page:
        told = open_flight(page, f"{server.url}index.html{link(WALL)}")
        found = grabbed(page)
        assert problems(page) == []
    # Leaves share it, and the server sends no cache headers.
    assert told["leaves"] >= 2
    assert [count for (_, name, _), count in server.answers.items() if "images/" in name] == [1]
    frame = rendered(textured, WALL, geometry=True)
    assert frame.stats["views"] == 0
    off = np.abs(frame.to_image().astype(int) - found).max(axis=-1)
    assert (off <= 3).mean() > 0.97
    assert len(np.unique(found.reshape(-1, 3), axis=0)) > 500


def test_damaged_geometry_is_reported_and_replaced_by_views(
    chromium: Any, city: nf.orthoview.OrthoTree, copied_city: Path
) -> None:
    place = city.cut(page_camera(NEAR)).leaf_places(in_picture=True)[0]
    (file,) = copied_city.glob(f"geometry/content/*/{'/'.join(map(str, place))}.glb")
    with Server.of_bundle(copied_city) as server, open_page(chromium, *SIZE) as page:
        file.write_bytes(file.read_bytes()[:-3] + b"abc")
        told = open_flight(page, f"{server.url}{link(NEAR)}")
        (listed,) = problems(page)
        found = grabbed(page)
    assert file.name in listed
    assert "record" in listed
    assert told["leaves"] > 0
    assert told["views"] > city.render(page_camera(NEAR)).stats["views"]
    assert told["holes"] == told["waiting"] == 0
    assert holes(found, rendered(city, NEAR)) < 0.02
