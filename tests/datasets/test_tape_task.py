"""Tests of the tape task: only with the continuous method does the tape lead to the right rectangle."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.datasets import TapeTask, tape_task
from tests.support.study_cases import ASIDE, HOW, USERS, Array, Ids, pieces, reduce_task

# 40° across 960 pixels are 24 a degree, between a headset's 15 and the eye's 60.
FOV, SIZE = nf.Fov.symmetric(40, 16 / 9), (960, 540)
Reduced = tuple[nf.ReducedScene, TapeTask]


@pytest.fixture(scope="module")
def tape() -> Reduced:
    """The published task: a tape that ends inside r₂."""
    scene, task = tape_task(3)
    return reduce_task(scene, task, 1024), task


@pytest.fixture(scope="module")
def torn_tape() -> Reduced:
    """A seed whose correct answer has neighbours on both sides, so that a wrong answer is possible."""
    scene, task = tape_task(1, 7, ends="far")
    return reduce_task(scene, task, 1024), task


def middles_of(ids: Ids, number: int) -> list[tuple[Array, Array]]:
    """Return rows and the tape's centre in each, of every connected piece of tape, the uppermost first."""
    found: list[tuple[Array, Array]] = []
    for mask in pieces(ids, number):
        rows = np.flatnonzero(mask.any(axis=1))
        middles = [float(np.flatnonzero(mask[row]).mean()) for row in rows]
        found.append((np.asarray(rows, np.float64) + 0.5, np.array(middles, np.float64) + 0.5))
    return found


def leads_to(ids: Ids, names: tuple[str, ...], rows: Array, middles: Array) -> str | None:
    """Return the rectangle at whose foot a piece's last eight rows arrive when extended; None beside all of them."""
    fit = np.polyfit(rows[:8], middles[:8], 1)
    rectangles = [number for number, name in enumerate(names) if name.startswith("rectangle")]
    foot = int(np.flatnonzero(np.isin(ids, rectangles).any(axis=1)).max())
    # Feet differ by two rows across the picture.
    for row in range(int(rows[0]) - 1, foot - 3, -1):
        column = int(np.polyval(fit, row + 0.5))
        if not 0 <= column < ids.shape[1]:
            return None
        name = names[ids[row, column]] if ids[row, column] >= 0 else ""
        if name.startswith("rectangle"):
            return name
    return None


def render_row(
    reduced: nf.ReducedScene, task: TapeTask, user: tuple[float, float, float], **how: Any
) -> tuple[Any, Ids]:
    """Render the view of a user who looks in the direction from the centre to the row."""
    eye = np.add(task.center, user)
    view = nf.Camera.look_at(eye, eye + np.subtract(task.target, task.center), fov=FOV, size=SIZE)
    return view, reduced.render(view, channels=("object_id",), **how).require("object_id")


def middle_picture(view: nf.Camera, task: TapeTask, morphed: bool) -> Array:
    """Return the pixels (N, 2) at which the tape's centre line is shown, far end first, from the formula."""
    along = np.linspace(1.0, 0.0, 400)[:, None]
    points = np.add(task.start, along * np.subtract(task.end, task.start))
    if morphed:
        points = nf.morph(points, user=view.position, center=task.center, r1=task.r1, r2=task.r2)
    return view.project(points)[:, :2]


@pytest.mark.parametrize("how", HOW, ids=lambda how: " ".join(str(v) for v in how.values()))
def test_the_published_tape_leads_to_the_right_rectangle_if_it_is_morphed(tape: Reduced, how: dict[str, Any]) -> None:
    reduced, task = tape
    names = reduced.scene.object_names
    for user in USERS[HOW.index(how) :: 3]:
        view, ids = render_row(reduced, task, user, **how)
        ((rows, middles),) = middles_of(ids, names.index("tape"))
        shown = middle_picture(view, task, morphed=True)
        # The first and the last row of a slanted tape show a corner of it, and the picture's edge cuts its near part.
        expected = np.interp(rows[2:-2], shown[:, 1], shown[:, 0])
        inside = np.abs(middles[2:-2] - 0.5 * SIZE[0]) < 0.5 * SIZE[0] - 80.0
        assert np.abs(middles[2:-2] - expected)[inside].max() < 1.0, user
        assert leads_to(ids, names, rows[2:], middles[2:]) == task.answer, user


def test_the_published_tape_stays_whole_and_misleads_conventionally(tape: Reduced) -> None:
    reduced, task = tape
    conventional, names = reduced.with_morph("none"), reduced.scene.object_names
    others = set()
    for user in ASIDE:
        for method in ("vertex", "exact"):
            view, ids = render_row(conventional, task, user, method=method)
            ((rows, middles),) = middles_of(ids, names.index("tape"))
            # The tape is displayed where the user sees it, as far as its end.
            shown = middle_picture(view, task, morphed=False)
            assert abs(rows[0] - shown[0, 1]) < 1.5
            expected = np.interp(rows[2:-2], shown[:, 1], shown[:, 0])
            inside = np.abs(middles[2:-2] - 0.5 * SIZE[0]) < 0.5 * SIZE[0] - 80.0
            assert np.abs(middles[2:-2] - expected)[inside].max() < 1.0, (user, method)
            answer = leads_to(ids, names, rows[2:], middles[2:])
            assert answer != task.answer, (user, method)
            others.add(answer)
    # Users who moved towards the row's middle name a neighbour; beyond the outermost rectangle there is none to name.
    assert others - {None}


@pytest.mark.parametrize("how", HOW, ids=lambda how: " ".join(str(v) for v in how.values()))
def test_the_continuous_tape_leads_across_both_radii(torn_tape: Reduced, how: dict[str, Any]) -> None:
    reduced, task = torn_tape
    names = reduced.scene.object_names
    for user in USERS[HOW.index(how) :: 3]:
        view, ids = render_row(reduced, task, user, **how)
        # A single piece: every row shows the tape, and the runs of neighbouring rows touch.
        ((rows, middles),) = middles_of(ids, names.index("tape"))
        morphing: dict[str, Any] = {"center": task.center, "r1": task.r1, "r2": task.r2}
        end = view.project(nf.morph(np.array([task.end]), user=view.position, **morphing))[0]
        # The end is cut at right angles to the tape, not to the view: half its width, 6 px, times their angle, plus a
        # texel of the map, 2.6 px.
        assert np.hypot(rows[0] - end[1], middles[0] - end[0]) < 6.0, user
        assert leads_to(ids, names, rows, middles) == task.answer, user


def test_the_conventional_tape_breaks_and_misleads(torn_tape: Reduced) -> None:
    reduced, task = torn_tape
    conventional, names = reduced.with_morph("none"), reduced.scene.object_names
    # Image position at which the tape's middle crosses r₂: the sampling is exact to less than a centimetre, 0.3 px.
    along = np.array(task.start) + np.linspace(0.0, 1.0, 10_001)[:, None] * np.subtract(task.end, task.start)
    crossing = along[np.argmin(np.abs(np.hypot(along[:, 0], along[:, 2]) - task.r2))]
    answers = []
    # Users who moved sideways; users who moved forwards or backwards see a tape of the wrong length instead.
    for user in ASIDE:
        for method in ("vertex", "exact"):
            view, ids = render_row(conventional, task, user, method=method)
            far, near = middles_of(ids, names.index("tape"))
            # The tape's point at r₂ is shown where the user sees it, and just beyond where the centre sees it.
            ends = view.project(np.stack([crossing, crossing + user]))[:, :2]
            torn = np.linalg.norm(ends[1] - ends[0])
            measured = np.hypot(far[1][-1] - near[1][0], far[0][-1] - near[0][0])
            # A tape that is cut obliquely along a circle has its last rows on one side: twice half its width, 8 px.
            assert abs(measured - torn) < 16.0, (user, method)
            # 5 m to the side are 118 px from 56 m, where the furthest sees it.
            assert measured > 118.0 - 16.0, (user, method)
            answers.append(leads_to(ids, names, *near))
    # A tape seen 5 m or 6 m to the side of the row leads to another rectangle or between two: they are 4 m apart and
    # 2.4 m wide.
    assert task.answer not in answers
    assert len(set(answers) - {None}) > 1
