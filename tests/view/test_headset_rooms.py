"""Rooms in an emulated headset: both eyes see where another user points, and controllers and hands point."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar.serve._limits import Rooms
from nearfar.serve._server import Server
from nearfar.serve._site import Site
from tests.support import need
from tests.support.browser import wait_until
from tests.support.headset import (
    HEADSETS,
    Quaternion,
    Vector,
    about,
    capture,
    empty_hands,
    eyes,
    floor_of,
    frames,
    look,
    point,
    squeeze,
    times,
    worn,
)
from tests.support.room_pages import HEAR, ends, has_changed, reach_beyond

pytestmark = pytest.mark.slow

SIZE = (200, 200)
CENTER: Vector = (3.0, 1.7, -2.0)
RADIUS = 22.0
START: Vector = (3.4, 1.7, -1.3)
YAW = -0.6
HEAD: Vector = (0.1, 1.6, 0.0)
STRAIGHT: Quaternion = (0.0, 0.0, 0.0, 1.0)
GUEST = 7


@pytest.fixture(scope="module")
def page(chromium: Any, city: nf.Scene, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    """A page in the headset and in a room."""
    need("web")
    folder = tmp_path_factory.mktemp("rooms") / "bundle"
    nf.stream.export(city, folder, center=CENTER, radii=(RADIUS,), face_size=64)
    place = ",".join(map(str, START))
    with Server({"": Site.of_bundle(folder)}, rooms=Rooms()) as server:
        url = f"{server.url}?strategy=clovrd&aa=0&room=eyes#p={place}&yaw={YAW}&pitch=0"
        with worn(chromium, url, "quest3", SIZE, 1) as shown:
            wait_until(shown, lambda: shown.evaluate("() => window.nearfar.room?.connection.state.kind") == "here")
            look(shown, HEAD, STRAIGHT)
            yield shown
            assert shown.printed == []


def pixel_in(eye: nf.Camera, target: NDArray[np.float64]) -> NDArray[np.float64]:
    """Column and row at which an eye's picture shows a point of the world."""
    shown = nf.morph([target], user=eye.position, center=CENTER, r1=0.7 * RADIUS, r2=RADIUS)
    return np.asarray(eye.project(shown)[0, :2], np.float64)


def test_each_eye_sees_another_users_pointer_end_at_its_target(page: Any, city: nf.Scene) -> None:
    empty_hands(page)
    begin, ahead = np.array([2.2, 1.5, -3.5]), np.array([0.643, 0.03, -0.766])
    ahead /= np.linalg.norm(ahead)
    length = float(nf.cast_rays(city, [begin], [ahead]).t_hit[0])
    end = begin + length * ahead
    # In the zone of the morph, where the eyes see it in directions that no single picture has.
    assert 0.7 * RADIUS < np.hypot(*(end - CENTER)[[0, 2]]) < RADIUS
    yaw, pitch = np.arctan2(-ahead[0], -ahead[2]), np.arcsin(ahead[1])
    right = {"position": begin.tolist(), "rotation": times(about((0, 1, 0), yaw), about((1, 0, 0), pitch))}
    head = {"position": [2.0, 1.7, -3.5], "rotation": STRAIGHT}
    pointer = {"begin": "right", "length": length}
    page.evaluate(HEAR, [GUEST, {"head": head, "left": None, "right": right, "pointer": pointer}])
    mute = "(isMuted) => window.nearfar.room.presence.mute(7, isMuted)"
    frames(page, 3)
    found = capture(page, "true")
    page.evaluate(mute, True)
    frames(page, 3)
    without = capture(page, "true")
    cameras = eyes(floor_of(page, CENTER), (HEAD, STRAIGHT), HEADSETS["quest3"], SIZE)
    for side in ("left", "right"):
        pictures = [np.asarray(getattr(each, side), np.int16) for each in (found, without)]
        mask = np.abs(pictures[0] - pictures[1]).max(axis=-1) > 12
        places = [pixel_in(cameras[side], begin + share * (end - begin)) for share in (0.3, 0.6, 0.9, 1.0)]
        assert all(has_changed(mask, place, 1.5) for place in places), side
        assert reach_beyond(mask, *places[2:]) < 5
    page.evaluate("() => window.nearfar.room.presence.hear({ kind: 'left', user: 7 }, 0)")


def body(page: Any) -> dict[str, Any]:
    """The body that the user sends to others."""
    frames(page, 4)
    return dict(page.evaluate("() => window.nearfar.room.body"))


def check_pointer(page: Any, city: nf.Scene) -> None:
    """Check that the right hand's pointer ends where its ray meets the scene."""
    found = body(page)
    assert found["pointer"] is not None
    assert found["pointer"]["begin"] == "right"
    begin, end = ends(found)
    length = found["pointer"]["length"]
    hit = float(nf.cast_rays(city, [begin], [(end - begin) / length]).t_hit[0])
    assert length == pytest.approx(hit, abs=0.01)


def test_controllers_point_by_grip_and_hands_by_index_finger(page: Any, city: nf.Scene) -> None:
    grip = "(value) => window.emulated.device.controllers.right.updateButtonValue('squeeze', value)"
    point(page, "right", (0.3, 1.3, -0.3), about((1, 0, 0), -0.15))
    assert body(page)["pointer"] is None
    page.evaluate(grip, 1)
    check_pointer(page, city)
    page.evaluate(grip, 0)
    assert body(page)["pointer"] is None

    pose = "(name) => { window.emulated.device.hands.right.poseId = name; }"
    page.evaluate("() => { window.emulated.device.primaryInputMode = 'hand'; }")
    point(page, "right", (0.3, 1.3, -0.3), about((1, 0, 0), -0.15), "hands")
    assert body(page)["pointer"] is None
    page.evaluate(pose, "point")
    check_pointer(page, city)
    page.evaluate(pose, "default")
    assert body(page)["pointer"] is None
    before = floor_of(page, CENTER).position
    # A pinch still jumps.
    point(page, "right", (0.3, 1.2, -0.3), about((1, 0, 0), -0.7), "hands")
    squeeze(page, "right", 1, "hands")
    assert body(page)["pointer"] is None
    squeeze(page, "right", 0, "hands")
    wait_until(page, lambda: np.abs(floor_of(page, CENTER).position - before).max() > 0.5)
