"""Tests of the measurement of a viewer's motion and its extrapolation, and of motion blur."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
import trimesh
from hypothesis import given, strategies as st
from numpy.typing import NDArray

import nearfar as nf
from nearfar import _core
from nearfar._camera.rotation import rotation
from nearfar._render.ranged import ranged
from nearfar.orthoview._pilot import MAX_TURN, WINDOW, Motion
from nearfar.orthoview._steady import pose_between
from tests.support.steady_oracle import averaged

transforms = trimesh.transformations
Turn = NDArray[np.float64]


def turn_about(angle: float, axis: Any) -> Turn:
    """A rotation about a world axis (3, 3)."""
    return np.asarray(transforms.rotation_matrix(angle, axis)[:3, :3])


def camera_at(position: Any, turn: Turn | None = None) -> nf.Camera:
    whole = np.eye(4)
    whole[:3, :3] = np.eye(3) if turn is None else turn
    w, x, y, z = transforms.quaternion_from_matrix(whole).tolist()
    return nf.Camera(tuple(position), (x, y, z, w), fov=nf.Fov.symmetric(60), size=(32, 24))


def rotation_of(camera: nf.Camera) -> Turn:
    """The camera's axes as columns (3, 3)."""
    x, y, z, w = camera.orientation
    return np.asarray(transforms.quaternion_matrix([w, x, y, z])[:3, :3])


def motion_of(*seen: tuple[float, nf.Camera]) -> Motion:
    motion = Motion()
    for time, camera in seen:
        motion.add(camera, time)
    return motion


def test_a_viewer_seen_once_is_at_rest() -> None:
    camera = camera_at((1, 2, 3), turn_about(0.4, (0, 1, 0)))
    motion = motion_of((5.0, camera))
    assert motion.velocity.tolist() == motion.turn.tolist() == [0, 0, 0]
    after = motion.extrapolate(3.0, np.zeros(3))
    assert after.position == camera.position
    np.testing.assert_allclose(rotation_of(after), rotation_of(camera), atol=1e-15)
    assert (after.fov, after.size) == (camera.fov, camera.size)


def test_velocity_is_displacement_over_the_time_of_the_window() -> None:
    """The window begins with the last sample that is at least a quarter of a second old."""
    times = [0.0, 0.1, 0.2, 0.3, 0.4, 0.5]
    places = [np.array([time**2, 3 * time, -(time**3)]) for time in times]
    motion = Motion()
    for number, (time, place) in enumerate(zip(times, places, strict=True)):
        motion.add(camera_at(place), time)
        past = [n for n in range(number + 1) if times[n] <= time - WINDOW]
        first = max(past, default=0)
        right = (place - places[first]) / (time - times[first]) if number else np.zeros(3)
        np.testing.assert_allclose(motion.velocity, right, atol=1e-12)


def test_two_samples_are_kept_at_any_interval() -> None:
    motion = motion_of((0.0, camera_at((0, 0, 0))), (60.0, camera_at((30, 0, -60))))
    np.testing.assert_allclose(motion.velocity, [0.5, 0, -1])


@pytest.mark.parametrize("time", [2.0, 1.0, -7.0])
def test_times_that_do_not_increase_reset_the_motion(time: float) -> None:
    motion = motion_of((1.9, camera_at((0, 0, 0))), (2.0, camera_at((1, 0, 0), turn_about(0.1, (0, 1, 0)))))
    assert np.linalg.norm(motion.velocity) > 0 < np.linalg.norm(motion.turn)
    motion.add(camera_at((9, 9, 9)), time)
    assert motion.velocity.tolist() == motion.turn.tolist() == [0, 0, 0]
    assert motion.extrapolate(0.0, np.zeros(3)).position == (9, 9, 9)
    motion.add(camera_at((9, 9, 10)), time + 0.5)
    np.testing.assert_allclose(motion.velocity, [0, 0, 2])


angles = st.floats(-3.1, 3.1)
parts = st.tuples(*[st.floats(-1, 1)] * 3).filter(lambda axis: np.linalg.norm(axis) > 0.1)


@given(angles, parts, angles, parts, st.floats(0.01, 2.0))
def test_rotations_lead_from_one_view_to_the_other(
    angle: float, axis: Any, start: float, other: Any, time: float
) -> None:
    first = turn_about(start, other)
    last = turn_about(angle, axis) @ first
    motion = motion_of((0.0, camera_at((0, 0, 0), first)), (time, camera_at((0, 0, 0), last)))
    expected = angle * np.array(axis) / np.linalg.norm(axis) / time
    np.testing.assert_allclose(motion.turn, expected, atol=1e-6 / time)


def test_a_quaternion_and_its_negative_are_the_same_rotation() -> None:
    """Quaternions of both signs represent one view."""
    one = camera_at((0, 0, 0), turn_about(0.2, (0, 1, 0)))
    x, y, z, w = one.orientation
    other = nf.Camera(one.position, (-x, -y, -z, -w), fov=one.fov, size=one.size)
    before = camera_at((0, 0, 0))
    for seen in (one, other):
        np.testing.assert_allclose(motion_of((0.0, before), (0.5, seen)).turn, [0, 0.4, 0], atol=1e-12)


@given(st.floats(-2.0, 2.0), parts, angles, parts, st.floats(0.0, 2.0))
def test_the_rotation_is_extrapolated_up_to_a_right_angle(
    rate: float, axis: Any, start: float, other: Any, seconds: float
) -> None:
    first = turn_about(start, other)
    unit = np.array(axis) / np.linalg.norm(axis)
    seen = turn_about(rate * 0.25, unit) @ first
    motion = motion_of((0.0, camera_at((1, 2, 3), first)), (0.25, camera_at((1, 2, 3), seen)))
    offset = np.array([4.0, -1.0, 0.5])
    after = motion.extrapolate(seconds, offset)
    assert after.position == (5.0, 1.0, 3.5)
    angle = np.clip(rate * seconds, -MAX_TURN, MAX_TURN)
    np.testing.assert_allclose(rotation_of(after), turn_about(angle, unit) @ seen, atol=1e-6)
    assert abs(math.hypot(*after.orientation) - 1) < 1e-12


def test_axes_equal_the_cameras() -> None:
    turn = turn_about(1.1, (1, 2, -3))
    camera = camera_at((0, 0, 0), turn)
    axes = rotation(camera.orientation).T
    np.testing.assert_allclose(axes, turn.T, atol=1e-12)
    # A point to the right and one above appear there.
    ahead = -10 * axes[2]
    middle, right, above = camera.project([ahead, ahead + axes[0], ahead + axes[1]])[:, :2]
    assert right[0] > middle[0] + 1
    assert above[1] < middle[1] - 1


# Motion blur ----------------------------------------------------------------------------------------------------------
FOVS: dict[str, Any] = {
    "perspective": nf.Fov(-0.7, 0.5, -0.4, 0.6),
    "cube": nf.CubeFace(5),
    "parallel": nf.Orthographic(-3, 4, -3, 3),
}


def picture(fov: Any, size: int = 18) -> nf.Frame:
    rng = np.random.default_rng(2)
    color = rng.uniform(0, 1, (size, size, 3)).astype(np.float32)
    distance = 8 + rng.uniform(0, 0.5, (size, size))
    distance[5:12, 4:9] = 3.0
    distance[:4] = np.inf
    camera = nf.Camera((10.0, 2.0, -7.0), fov=fov, size=(size, size))
    return nf.Frame(camera, color=color, range=distance.astype(np.float32))


@pytest.mark.parametrize("name", FOVS)
def test_blur_equals_loops(name: str) -> None:
    frame = picture(FOVS[name])
    turned = nf.Camera(
        (10.6, 1.8, -7.4), (0.0, float(np.sin(0.02)), 0.0, float(np.cos(0.02))), fov=FOVS[name], size=(18, 18)
    )
    poses = [pose_between(frame.camera, turned, share) for share in (0.1, 0.5, 1.0)]
    found = _core.blur_motion(ranged("frame", frame), [pose._core for pose in poses])
    np.testing.assert_allclose(found, averaged(frame, poses), atol=2e-6)
    # The eye has moved by 0.72 m, about the width of a pixel at 10 m.
    assert np.abs(found - frame.require("color")).mean() > 0.05


def test_a_blurred_wall_is_the_mean_of_shifted_pictures() -> None:
    rng = np.random.default_rng(2)
    color = rng.uniform(0, 1, (8, 40, 3)).astype(np.float32)
    camera = nf.Camera((0.0, 0.0, 0.0), fov=nf.Orthographic(-20, 20, -4, 4), size=(40, 8))
    frame = nf.Frame(camera, color=color, range=np.full((8, 40), 5.0, np.float32))
    before = nf.Camera((-8.0, 0.0, 0.0), fov=camera.fov, size=camera.size)
    # Poses are at 1/8, 3/8, 5/8 and 7/8 of the way of 8 pixels; half of the time at half of them.
    for shutter, shifts in ((1.0, (1, 3, 5, 7)), (0.5, (1, 3))):
        blurred = nf.orthoview.motion_blur(frame, before, shutter=shutter, poses=len(shifts)).require("color")
        expected = np.mean([np.roll(color, shift, axis=1) for shift in shifts], axis=0)
        np.testing.assert_allclose(blurred[:, 8:], expected[:, 8:], atol=1e-6)
        # At the left only some poses show the wall.
        np.testing.assert_allclose(blurred[:, 1:3], color[:, 0:2], atol=1e-6)
        np.testing.assert_array_equal(blurred[:, 0], color[:, 0])


@pytest.mark.parametrize("name", FOVS)
def test_a_still_camera_blurs_nothing(name: str) -> None:
    frame = picture(FOVS[name])
    blurred = nf.orthoview.motion_blur(frame, frame.camera)
    np.testing.assert_allclose(blurred.require("color"), frame.require("color"), atol=1e-6)
    np.testing.assert_array_equal(blurred.require("range"), frame.require("range"))


def test_poses_are_interpolated() -> None:
    """A quarter of a rotation by 90° about y is one by 22.5°."""
    half = np.sqrt(0.5)
    camera = nf.Camera((0.0, 0.0, 0.0), fov=nf.Fov.symmetric(60), size=(4, 4))
    for sign in (1.0, -1.0):
        other = nf.Camera((4.0, 8.0, 0.0), (0.0, sign * half, 0.0, sign * half), fov=camera.fov, size=(4, 4))
        between = pose_between(camera, other, 0.25)
        assert between.position == (1.0, 2.0, 0.0)
        angle = np.radians(22.5) / 2
        np.testing.assert_allclose(between.orientation, (0.0, np.sin(angle), 0.0, np.cos(angle)), atol=1e-12)
    assert pose_between(camera, camera, 0.3) == camera


def test_invalid_input_of_motion_blur_is_refused() -> None:
    frame = picture(FOVS["perspective"])
    with pytest.raises(ValueError, match=r"frame: .*color"):
        nf.orthoview.motion_blur(nf.Frame(frame.camera, range=frame.range), frame.camera)
