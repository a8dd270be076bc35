"""Tests of the measurement of a viewer's velocity and rotation, and of their extrapolation."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
import trimesh
from hypothesis import given, strategies as st
from numpy.typing import NDArray

import nearfar as nf
from nearfar._camera.rotation import rotation
from nearfar.orthoview._pilot import MAX_TURN, WINDOW, Motion

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
