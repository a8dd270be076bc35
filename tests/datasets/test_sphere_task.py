"""Tests of the ball task: where the methods show its flight, and what occludes it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy import ndimage

import nearfar as nf
from nearfar.datasets import SphereTask, sphere_task
from tests.support.study_cases import ASIDE, HOW, USERS, Array, Ids, reduce_task

BALL_FOV, BALL_SIZE = nf.Fov.symmetric(45, 16 / 9), (640, 360)
BALL_FOCAL = 320 / np.tan(np.radians(22.5))
RATE = 30.0
"""Pictures per second of the flying ball."""


@pytest.fixture(scope="module")
def ball() -> tuple[nf.ReducedScene, SphereTask]:
    scene, task = sphere_task(0, straight=False)
    return reduce_task(scene, task, 2048), task


def ball_view(task: SphereTask, user: tuple[float, float, float]) -> nf.Camera:
    eye = np.add(task.center, user)
    return nf.Camera.look_at(eye, eye + np.array([0.0, 5.0, -80.0]), fov=BALL_FOV, size=BALL_SIZE)


def ball_ids(reduced: nf.ReducedScene, task: SphereTask, view: nf.Camera, t: float, **how: Any) -> Ids:
    return reduced.render(view, at={"ball": task.pose(t)}, channels=("object_id",), **how).require("object_id")


def ball_path(reduced: nf.ReducedScene, task: SphereTask, view: nf.Camera, times: Array, **how: Any) -> Array:
    """Return the centroid of the ball's pixels at each time."""
    number = reduced.scene.object_names.index("ball")
    path = []
    for t in times:
        rows, columns = np.nonzero(ball_ids(reduced, task, view, t, **how) == number)
        path.append([columns.mean() + 0.5, rows.mean() + 0.5])
    return np.array(path)


def jump(path: Array) -> float:
    """Return the greatest change of the step between pictures, pixels."""
    return float(np.linalg.norm(np.diff(path, n=2, axis=0), axis=1).max())


@pytest.mark.slow
@pytest.mark.parametrize(("user", "method"), [((8.0, 0.0, 0.0), "vertex"), ((-4.0, 0.0, -5.0), "exact")])
def test_the_ball_jumps_with_the_conventional_method_only(
    ball: tuple[nf.ReducedScene, SphereTask], user: tuple[float, float, float], method: str
) -> None:
    reduced, task = ball
    view = ball_view(task, user)
    times = np.arange(0.0, task.duration, 1.0 / RATE)
    places = np.array([task.position(t) for t in times])
    away = np.hypot(places[:, 0], places[:, 2])
    # From before r₁ to where the crossbar partly hides it.
    times, places = times[(away > 27.0) & (away < 60.0)], places[(away > 27.0) & (away < 60.0)]
    shown = nf.morph(places, user=view.position, center=task.center, r1=task.r1, r2=task.r2)
    expected = view.project(shown)[:, :2]
    # The picture turns from the user's to the centre's over 20 m, which begins at 30 m at once; what the flight itself
    # adds is 1 px, and what the rounding to pixels adds to three middles of a disc is 1 px.
    step = np.hypot(task.velocity[0], task.velocity[2]) / RATE
    bend = np.hypot(user[0], user[2]) / task.r1 * step / (task.r2 - task.r1) * BALL_FOCAL + 2.0
    path = ball_path(reduced, task, view, times, method=method)
    # The ball's outline is symmetric about its middle up to rim pixels and the morph's stretching of half a metre.
    assert np.linalg.norm(path - expected, axis=1).max() < 1.0
    assert jump(path) < bend < 14.0
    torn = ball_path(reduced.with_morph("none"), task, view, times, method=method)
    # At 50 m the user's and the centre's view differ by what the user strayed sideways. A ball that is cut in two
    # at r₂, which happens in one picture at most, jumps in two steps.
    assert jump(torn) > 0.5 * abs(user[0]) / task.r2 * BALL_FOCAL > 3.0 * jump(path)


@pytest.mark.parametrize(("seed", "straight"), [(0, False), (1, True)])
def test_the_ball_lands_on_the_right_box(seed: int, straight: bool) -> None:
    scene, task = sphere_task(seed, straight=straight)
    reduced = reduce_task(scene, task, 1024)
    names = scene.object_names
    for user in USERS[::3]:
        view = ball_view(task, user)
        for how in HOW:
            ids = ball_ids(reduced, task, view, task.duration, **how)
            rows, columns = np.nonzero(ids == names.index("ball"))
            lowest = rows.max()
            below = ids[lowest + 1, columns[rows == lowest]]
            assert {names[i] for i in below} == {task.answer}, (user, how)


@pytest.mark.slow
def test_the_published_conventional_ball_flies_evenly_onto_a_wrong_box() -> None:
    scene, task = sphere_task(1)
    conventional, names = reduce_task(scene, task, 1024).with_morph("none"), scene.object_names
    for user in ASIDE:
        view, how = ball_view(task, user), {"conventional_dynamic": "user"}
        times = np.linspace(0.35, 1.0, 12) * task.duration
        path = ball_path(conventional, task, view, times, **how)
        expected = view.project(np.array([task.position(t) for t in times]))[:, :2]
        assert np.linalg.norm(path - expected, axis=1).max() < 1.0
        ids = ball_ids(conventional, task, view, task.duration, **how)
        rows, columns = np.nonzero(ids == names.index("ball"))
        lowest = rows.max()
        below = ids[lowest + 1, columns[rows == lowest]]
        assert task.answer not in {names[i] for i in below if i >= 0}, user


@pytest.mark.slow
def test_the_ball_is_hidden_by_the_same_pixels_as_in_the_ideal_picture(
    ball: tuple[nf.ReducedScene, SphereTask],
) -> None:
    reduced, task = ball
    view, names = ball_view(task, (-4.0, 0.0, -5.0)), reduced.scene.object_names
    number, bar = names.index("ball"), names.index("crossbar")
    counts = []
    for t in np.linspace(task.duration - 0.6, task.duration, 19):
        ideal = ball_ids(reduced, task, view, t, method="exact", env=False)
        # A texel is 0.75 px, and the range that hides is that of the texels around: two pixels along the bar's edges.
        hidden = ideal == bar
        edge = ndimage.binary_dilation(hidden, np.ones((3, 3)), 2) & ~ndimage.binary_erosion(hidden, np.ones((3, 3)), 2)
        for method in ("vertex", "exact"):
            wrong = (ball_ids(reduced, task, view, t, method=method) == number) ^ (ideal == number)
            assert not (wrong & ~edge).any(), (t, method)
        counts.append(int((ideal == number).sum()))
    # The ball passes behind the bar and reappears: less than half of it remains visible in between.
    middle = int(np.argmin(counts))
    assert 2 * counts[middle] < min(counts[0], counts[-1])
    assert 0 < middle < len(counts) - 1


def test_the_ball_rests_before_and_after_its_flight() -> None:
    scene, task = sphere_task(3)
    np.testing.assert_array_equal(task.position(-1.0), task.start)
    np.testing.assert_array_equal(task.position(99.0), task.position(task.duration))
    np.testing.assert_array_equal(scene.transform("ball"), task.pose(0.0))
