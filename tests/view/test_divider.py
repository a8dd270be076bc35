"""The divider: left of it the conventional method, right of it the continuous one, both as nearfar renders them."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.serve._server import Server
from tests.support import need
from tests.support.browser import opened, started, wait_for_ring
from tests.support.page_pictures import camera, of_one_face, off
from tests.support.stepped_page import SteppedPage

pytestmark = pytest.mark.slow

SIZE = (360, 240)
CENTER = (3.0, 1.7, -2.0)
R1, R2 = 14.0, 40.0
SHARE = 0.5
POSES = (((0.8, 0.1, -0.4), 0.3), ((-2.5, 0.0, 1.9), 2.0))
PITCH = -0.1


@pytest.fixture(scope="module")
def saved(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, nf.ReducedScene]:
    """The folder of a reduced scene with cars that move, and the scene as it is read from there."""
    folder = tmp_path_factory.mktemp("divider") / "light"
    scene = nf.datasets.city(blocks=3, detail=1)
    nf.reduce(scene, center=CENTER, r1=R1, r2=R2, face_size=256, samples=4).save(folder)
    return folder, nf.ReducedScene.load(folder)


@pytest.fixture(scope="module")
def page(saved: tuple[Path, nf.ReducedScene]) -> Iterator[SteppedPage]:
    """The page with all of the scene, grown."""
    need("browser")
    with started() as program, Server.of_bundle(saved[0]) as server, opened(program, *SIZE) as shown:
        shown.goto(f"{server.url}?aa=0&strategy=clovrd")
        assert wait_for_ring(shown, 1) == ""
        yield SteppedPage(shown)
        assert shown.printed == []


@pytest.mark.parametrize(("away", "yaw"), POSES)
def test_each_side_is_the_picture_of_its_method(
    page: SteppedPage, saved: tuple[Path, nf.ReducedScene], away: Any, yaw: float
) -> None:
    eye = np.add(CENTER, away).tolist()
    pose = {"position": eye, "yaw": yaw, "pitch": PITCH}
    page.page.evaluate("(share) => window.nearfar.viewer.setDivider(share)", SHARE)
    page.load(pose, 0.1)
    shown, found = page.picture(pose, 0.1)
    assert shown["shown"]["grown"] == {"radius": R2, "strength": 1}
    middle = round(SHARE * SIZE[0])
    sides = {"none": slice(0, middle), "blend": slice(middle, None)}
    seen = camera(eye, yaw, PITCH, SIZE)
    for morph, side in sides.items():
        frame = saved[1].with_morph(morph).render(seen, channels=("color", "face_id"))
        worst, inner = off(frame, found)[:, side], of_one_face(frame.require("face_id"))[:, side]
        assert (worst[inner] <= 2).mean() >= 0.999
        assert (worst <= 2).mean() >= 0.99
    # Each method's picture is wrong on the other side, so that sides which were exchanged would be seen.
    other = off(saved[1].with_morph("blend").render(seen, channels=("color",)), found)[:, : middle - 1]
    assert (other <= 2).mean() < 0.95
