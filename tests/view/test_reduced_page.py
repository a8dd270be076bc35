"""Reduced scenes in the browser: the page's pictures beside those of `ReducedScene.render`."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.serve._server import Server
from tests.support.browser import opened, still, wait_for_ring
from tests.support.page_pictures import camera, of_one_face, off

pytestmark = pytest.mark.slow

SIZE = (360, 240)
CENTER = (3.0, 1.7, -2.0)
R1, R2 = 14.0, 40.0
POSES = (((0.8, 0.1, -0.4), 0.3), ((-2.5, 0.0, 1.9), 2.0), ((0.0, 0.0, 0.0), 4.4))
PITCH = -0.1


@pytest.fixture(scope="module", params=["blend", "cylinder"])
def saved(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, nf.ReducedScene]:
    """The folder of a reduced scene with cars that move, and the scene as it is read from there."""
    folder = tmp_path_factory.mktemp("view") / "light"
    scene = nf.datasets.city(blocks=3, detail=1)
    reduced = nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=256, samples=4, morph=request.param)
    reduced.save(folder)
    return folder, nf.ReducedScene.load(folder)


@pytest.fixture(scope="module")
def page(chromium: Any, saved: tuple[Path, nf.ReducedScene]) -> Iterator[Any]:
    with Server.of_bundle(saved[0]) as server, opened(chromium, *SIZE) as shown:
        shown.goto(f"{server.url}?aa=0")
        assert wait_for_ring(shown, 1) == ""
        yield shown
        assert shown.printed == []


@pytest.mark.parametrize(("away", "yaw"), POSES)
@pytest.mark.parametrize("strength", [1.0, 0.4])
def test_pictures_are_those_of_the_reduced_scene(
    page: Any, saved: tuple[Path, nf.ReducedScene], away: Any, yaw: float, strength: float
) -> None:
    eye = np.add(CENTER, away).tolist()
    picture = {"ring": 1, "radius": R2, "strength": strength}
    found = still(page, picture, {"position": eye, "yaw": yaw, "pitch": PITCH})
    drawn = saved[1].with_growth(None, strength)
    frame = drawn.render(camera(eye, yaw, PITCH, SIZE), channels=("color", "face_id"))
    worst, inner = off(frame, found), of_one_face(frame.require("face_id"))
    assert inner.mean() > 0.4
    assert (worst[inner] <= 2).mean() >= 0.999
    assert (worst <= 2).mean() >= 0.99


def test_ring_0_is_what_the_centre_sees_and_ring_1_begins_as_that(
    page: Any, saved: tuple[Path, nf.ReducedScene]
) -> None:
    pose = {"position": np.add(CENTER, (0.6, 0.0, -0.5)).tolist(), "yaw": 2.0, "pitch": PITCH}
    with_ring_1 = still(page, {"ring": 1, "radius": R2, "strength": 0.0}, pose)
    frame = saved[1].render(camera(CENTER, 2.0, PITCH, SIZE), channels=("color", "face_id"))
    worst, inner = off(frame, with_ring_1), of_one_face(frame.require("face_id"))
    assert (worst[inner] <= 2).mean() >= 0.99


def test_a_reduced_scene_grows_by_strength(chromium: Any, saved: tuple[Path, nf.ReducedScene]) -> None:
    with Server.of_bundle(saved[0]) as server, opened(chromium, *SIZE) as shown:
        shown.goto(f"{server.url}?aa=0&rings=1")
        assert wait_for_ring(shown, 1) == ""
        begun = "() => window.nearfar.viewer.facts.shown.grown.strength > 0"
        shown.wait_for_function(begun)
        grown = shown.evaluate("() => window.nearfar.viewer.facts.shown.grown")
        assert grown["radius"] == R2
        assert grown["strength"] < 1
        shown.wait_for_function(begun.replace("> 0", "> " + str(grown["strength"])))
