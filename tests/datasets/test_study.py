"""Tests of the user study's tasks: only the continuous method shows tape and ball correctly."""

from __future__ import annotations

import hashlib
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy import ndimage

import nearfar as nf
from nearfar.datasets import SphereTask, TapeTask, sphere_task, tape_task

Array = NDArray[np.float64]
Ids = NDArray[np.int32]

# 40° across 960 pixels are 24 a degree, between a headset's 15 and the eye's 60.
TAPE_FOV, TAPE_SIZE = nf.Fov.symmetric(40, 16 / 9), (960, 540)
BALL_FOV, BALL_SIZE = nf.Fov.symmetric(45, 16 / 9), (640, 360)
BALL_FOCAL = 320 / np.tan(np.radians(22.5))
RATE = 30.0
"""Pictures per second of the flying ball."""

USERS = [
    (d * np.cos(k * np.pi / 4), 0.05 * k, d * np.sin(k * np.pi / 4)) for k, d in enumerate([5.0, 8.0, 6.0, 7.0] * 2)
]
"""Positions all around the centre, standing and stretching."""


def light(scene: nf.Scene, task: TapeTask | SphereTask, face_size: int) -> nf.ReducedScene:
    channels = ("color", "object_id")
    where: dict[str, Any] = {"center": task.center, "r1": task.r1, "r2": task.r2}
    return nf.reduce(scene, **where, face_size=face_size, samples=1, channels=channels)


@pytest.fixture(scope="module", params=[1, 3])
def tape(request: pytest.FixtureRequest) -> tuple[nf.ReducedScene, TapeTask]:
    """Two seeds whose correct answers have neighbours on both sides, so that a wrong answer is possible."""
    scene, task = tape_task(request.param)
    return light(scene, task, 1024), task


@pytest.fixture(scope="module")
def ball() -> tuple[nf.ReducedScene, SphereTask]:
    scene, task = sphere_task(0)
    return light(scene, task, 2048), task


# the tape -------------------------------------------------------------------------------------------------------------
def pieces(ids: Ids, number: int) -> list[tuple[Array, Array]]:
    """Rows and the tape's middle in each, of every connected piece of tape, the uppermost first."""
    labels, count = ndimage.label(ids == number, np.ones((3, 3)))
    found: list[tuple[Array, Array]] = []
    for label in range(1, count + 1):
        mask = labels == label
        rows = np.flatnonzero(mask.any(axis=1))
        middles = [float(np.flatnonzero(mask[row]).mean()) for row in rows]
        found.append((np.asarray(rows, np.float64) + 0.5, np.array(middles, np.float64) + 0.5))
    return found


def leads_to(ids: Ids, names: tuple[str, ...], rows: Array, middles: Array) -> str | None:
    """The rectangle that a piece's last stretch, eight rows, meets when it is extended; None between and beyond."""
    fit = np.polyfit(rows[:8], middles[:8], 1)
    for row in range(int(rows[0]) - 1, -1, -1):
        column = int(np.polyval(fit, row + 0.5))
        if not 0 <= column < ids.shape[1]:
            return None
        name = names[ids[row, column]] if ids[row, column] >= 0 else ""
        if name.startswith("rectangle"):
            return name
    return None


def seen(reduced: nf.ReducedScene, task: TapeTask, user: tuple[float, float, float], **how: Any) -> tuple[Any, Ids]:
    """Render the view of a user who looks in the direction from the centre to the row."""
    eye = np.add(task.center, user)
    view = nf.Camera.look_at(eye, eye + np.subtract(task.target, task.center), fov=TAPE_FOV, size=TAPE_SIZE)
    return view, reduced.render(view, channels=("object_id",), **how).require("object_id")


HOW: list[dict[str, Any]] = [{"method": "vertex"}, {"method": "exact"}, {"method": "exact", "env": False}]


@pytest.mark.parametrize("how", HOW, ids=lambda how: " ".join(str(v) for v in how.values()))
def test_the_continuous_tape_leads_to_the_right_rectangle(
    tape: tuple[nf.ReducedScene, TapeTask], how: dict[str, Any]
) -> None:
    reduced, task = tape
    names = reduced.scene.object_names
    for user in USERS:
        view, ids = seen(reduced, task, user, **how)
        # A single piece: every row shows the tape, and the runs of neighbouring rows touch.
        ((rows, middles),) = pieces(ids, names.index("tape"))
        morphing: dict[str, Any] = {"center": task.center, "r1": task.r1, "r2": task.r2}
        end = view.project(nf.morph(np.array([task.end]), user=view.position, **morphing))[0]
        # The end is cut at right angles to the tape, not to the view: half its width, 6 px, times their angle, plus a
        # texel of the map, 2.6 px.
        assert np.hypot(rows[0] - end[1], middles[0] - end[0]) < 6.0, user
        assert leads_to(ids, names, rows, middles) == task.answer, user


def test_the_conventional_tape_breaks_and_misleads(tape: tuple[nf.ReducedScene, TapeTask]) -> None:
    reduced, task = tape
    conventional, names = reduced.with_morph("none"), reduced.scene.object_names
    # Image position at which the tape's middle crosses r₂: the sampling is exact to less than a centimetre, 0.3 px.
    along = np.array(task.start) + np.linspace(0.0, 1.0, 10_001)[:, None] * np.subtract(task.end, task.start)
    crossing = along[np.argmin(np.abs(np.hypot(along[:, 0], along[:, 2]) - task.r2))]
    answers = []
    # Users who moved sideways; users who moved forwards or backwards see a tape of the wrong length instead.
    for user in [user for user in USERS if abs(user[0]) > 3.0]:
        for method in ("vertex", "exact"):
            view, ids = seen(conventional, task, user, method=method)
            far, near = pieces(ids, names.index("tape"))
            # The tape's point at r₂ is shown where the user sees it, and just beyond where the centre sees it.
            ends = view.project(np.stack([crossing, crossing + user]))[:, :2]
            torn = np.linalg.norm(ends[1] - ends[0])
            measured = np.hypot(far[1][-1] - near[1][0], far[0][-1] - near[0][0])
            # A tape that is cut obliquely along a circle has its last rows on one side: twice half its width, 8 px.
            assert abs(measured - torn) < 16.0, (user, method)
            # 5 m to the side are 118 px from 56 m, where the furthest sees it.
            assert measured > 118.0 - 16.0, (user, method)
            answers.append(leads_to(ids, names, *near))
    # A tape seen 5 m or 6 m to the side of the row leads to another rectangle: they are 4 m apart and 2.4 m wide.
    assert None not in answers
    assert task.answer not in answers


# the ball -------------------------------------------------------------------------------------------------------------
def ball_view(task: SphereTask, user: tuple[float, float, float]) -> nf.Camera:
    eye = np.add(task.center, user)
    return nf.Camera.look_at(eye, eye + np.array([0.0, 5.0, -80.0]), fov=BALL_FOV, size=BALL_SIZE)


def ball_ids(reduced: nf.ReducedScene, task: SphereTask, view: nf.Camera, t: float, **how: Any) -> Ids:
    return reduced.render(view, at={"ball": task.pose(t)}, channels=("object_id",), **how).require("object_id")


def ball_path(reduced: nf.ReducedScene, task: SphereTask, view: nf.Camera, times: Array, **how: Any) -> Array:
    """Middle of the ball's pixels at each time."""
    number = reduced.scene.object_names.index("ball")
    path = []
    for t in times:
        rows, columns = np.nonzero(ball_ids(reduced, task, view, t, **how) == number)
        path.append([columns.mean() + 0.5, rows.mean() + 0.5])
    return np.array(path)


def jump(path: Array) -> float:
    """Greatest change of the step between pictures, pixels."""
    return float(np.linalg.norm(np.diff(path, n=2, axis=0), axis=1).max())


@pytest.mark.parametrize(("user", "method"), [((8.0, 0.0, 0.0), "vertex"), ((-4.0, 0.0, -5.0), "exact")])
def test_the_ball_jumps_with_the_conventional_method_only(
    ball: tuple[nf.ReducedScene, SphereTask], user: tuple[float, float, float], method: str
) -> None:
    reduced, task = ball
    view = ball_view(task, user)
    times = np.arange(0.0, task.duration, 1.0 / RATE)
    places = np.array([task.position(t) for t in times])
    away = np.hypot(places[:, 0], places[:, 2])
    # From before r₁ to where the crossbar hides some of it.
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


@pytest.mark.parametrize("seed", [0, 1])
def test_the_ball_lands_on_the_right_box(seed: int) -> None:
    scene, task = sphere_task(seed)
    reduced = light(scene, task, 1024)
    names = scene.object_names
    for user in USERS[::3]:
        view = ball_view(task, user)
        for how in HOW:
            ids = ball_ids(reduced, task, view, task.duration, **how)
            rows, columns = np.nonzero(ids == names.index("ball"))
            lowest = rows.max()
            below = ids[lowest + 1, columns[rows == lowest]]
            assert {names[i] for i in below} == {task.answer}, (user, how)


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


# the scenes -----------------------------------------------------------------------------------------------------------
def digest(scene: nf.Scene) -> str:
    return hashlib.sha256(np.ascontiguousarray(scene.triangles()).tobytes()).hexdigest()[:16]


def test_the_same_seed_gives_the_same_bytes() -> None:
    assert (digest(tape_task(7)[0]), digest(sphere_task(7)[0])) == ("a4698fea2597285f", "7604fa7b245a7311")
    assert tape_task(7)[1] == tape_task(7)[1] != tape_task(8)[1]


@pytest.mark.parametrize("count", [2, 7, 15])
def test_every_answer_is_asked_for_and_is_the_one(count: int) -> None:
    asked: list[set[str]] = [set(), set()]
    for seed in range(12 * count):
        task = tape_task(seed, count)[1]
        start, end = np.array(task.start), np.array(task.end)
        met = start + (task.target[2] - start[2]) / (end - start)[2] * (end - start)
        # Rectangles are 4 m apart.
        assert task.rectangles[round(met[0] / 4.0 + 0.5 * (count - 1))] == task.answer
        assert np.hypot(*start[[0, 2]]) < task.r1 < task.r2 < np.hypot(*end[[0, 2]])
        asked[0].add(task.answer)
        thrown = sphere_task(seed, count)[1]
        # Boxes are 5 m apart and 2 m high.
        landed = thrown.position(thrown.duration)
        assert thrown.boxes[round(landed[0] / 5.0 + 0.5 * (count - 1))] == thrown.answer
        # Rounding of a flight of 70 m.
        assert landed[1] - thrown.radius == pytest.approx(2.0, abs=1e-12)
        asked[1].add(thrown.answer)
    assert [len(one) for one in asked] == [count, count]


def test_the_ball_rests_before_and_after_its_flight() -> None:
    scene, task = sphere_task(3)
    np.testing.assert_array_equal(task.position(-1.0), task.start)
    np.testing.assert_array_equal(task.position(99.0), task.position(task.duration))
    np.testing.assert_array_equal(scene.transform("ball"), task.pose(0.0))
    with pytest.raises(ValueError, match="t: expected"):
        task.pose(np.nan)


@pytest.mark.parametrize("make", [tape_task, sphere_task])
def test_bad_arguments_are_named(make: Any) -> None:
    name = "rectangles" if make is tape_task else "boxes"
    for arguments, said in [((-1,), "seed"), ((2**63,), "seed"), ((0, 1), name), ((0, 16), name)]:
        with pytest.raises(ValueError, match=f"^{said}"):
            make(*arguments)
    with pytest.raises(TypeError, match=f"^{name}"):
        make(0, 2.5)
