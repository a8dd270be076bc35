"""Reduced scenes in the browser: the page's pictures compared with `ReducedScene.render`, and the divider."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.serve._server import Server
from tests.support.browser import open_page, still, wait_for_ring
from tests.support.page_pictures import camera, of_one_face, off
from tests.support.stepped_page import SteppedPage

pytestmark = pytest.mark.slow

SIZE = (360, 240)
CENTER = (3.0, 1.7, -2.0)
R1, R2 = 14.0, 40.0
POSES = (((0.8, 0.1, -0.4), 0.3), ((-2.5, 0.0, 1.9), 2.0), ((0.0, 0.0, 0.0), 4.4))
PITCH = -0.1
SHARE = 0.5
"""Share of the width left of the divider."""


@pytest.fixture(scope="module", params=["blend", "cylinder"])
def saved(
    request: pytest.FixtureRequest, city: nf.Scene, tmp_path_factory: pytest.TempPathFactory
) -> tuple[Path, nf.ReducedScene]:
    """The folder of a reduced scene with moving cars, and the scene loaded from there."""
    folder = tmp_path_factory.mktemp("view") / "light"
    nf.reduce(city, center=CENTER, r1=R1, r2=R2, face_size=256, samples=4, morph=request.param).save(folder)
    return folder, nf.ReducedScene.load(folder)


@pytest.fixture(scope="module")
def page(chromium: Any, saved: tuple[Path, nf.ReducedScene]) -> Iterator[SteppedPage]:
    with Server.of_bundle(saved[0]) as server, open_page(chromium, *SIZE) as shown:
        shown.goto(f"{server.url}?aa=0&strategy=clovrd")
        assert wait_for_ring(shown, 1) == ""
        yield SteppedPage(shown)
        assert shown.printed == []


def check(drawn: nf.ReducedScene, found: Any, view: nf.Camera, least: float, part: slice = slice(None)) -> None:
    """Check that some columns show the scene: `least` of the pixels within a face, 99 % of all."""
    frame = drawn.render(view, channels=("color", "face_id"))
    worst, inner = off(frame, found)[:, part], of_one_face(frame.require("face_id"))[:, part]
    assert inner.mean() > 0.4
    assert (worst[inner] <= 2).mean() >= least
    assert (worst <= 2).mean() >= 0.99 or least < 0.999


def test_pictures_equal_the_reduced_scene(page: SteppedPage, saved: tuple[Path, nf.ReducedScene]) -> None:
    for strength in (1.0, 0.4):
        drawn = saved[1].with_growth(None, strength)
        for away, yaw in POSES:
            eye = np.add(CENTER, away).tolist()
            pose = {"position": eye, "yaw": yaw, "pitch": PITCH}
            found = still(page.page, {"ring": 1, "radius": R2, "strength": strength}, pose)
            check(drawn, found, camera(eye, yaw, PITCH, SIZE), 0.999)
    # Ring 1 begins with everything shown from the centre.
    pose = {"position": np.add(CENTER, (0.6, 0.0, -0.5)).tolist(), "yaw": 2.0, "pitch": PITCH}
    found = still(page.page, {"ring": 1, "radius": R2, "strength": 0.0}, pose)
    check(saved[1], found, camera(CENTER, 2.0, PITCH, SIZE), 0.99)


def test_each_side_of_the_divider_shows_its_method(page: SteppedPage, saved: tuple[Path, nf.ReducedScene]) -> None:
    page.page.evaluate("(share) => window.nearfar.viewer.setDivider(share)", SHARE)
    middle = round(SHARE * SIZE[0])
    for away, yaw in POSES[:2]:
        eye = np.add(CENTER, away).tolist()
        pose, view = {"position": eye, "yaw": yaw, "pitch": PITCH}, camera(eye, yaw, PITCH, SIZE)
        page.load(pose, 0.1)
        shown, found = page.picture(pose, 0.1)
        assert shown["shown"]["grown"] == {"radius": R2, "strength": 1}
        check(saved[1].with_morph("none"), found, view, 0.999, slice(0, middle))
        check(saved[1], found, view, 0.999, slice(middle, None))
        # Each method's picture is wrong on the other side, so swapped sides would be detected.
        other = off(saved[1].render(view, channels=("color",)), found)[:, : middle - 1]
        assert (other <= 2).mean() < 0.95
