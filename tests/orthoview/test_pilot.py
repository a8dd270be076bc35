"""Tests of the parts that a client wants at each moment, and of coarser pictures at high speed."""

from __future__ import annotations

import math
from itertools import chain
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.orthoview._cut import GEOMETRY, RECORD, Part, Settings
from nearfar.orthoview._meter import HALF_LIFE, LinkTotals, Meter
from nearfar.orthoview._pilot import HYSTERESIS, RATE_SHARE, RENEWED_TURN, Pilot, PrefetchSettings
from nearfar.orthoview._prefetch import queue
from tests.support.flight_cases import FOV, parts_of
from tests.support.orthoview_cases import CORNER

Tree = nf.orthoview.OrthoTree

MIDDLE = CORNER + 40.0
SIZE = (64, 48)


def camera_at(offset: Any, yaw: float = 0.0) -> nf.Camera:
    position = tuple((MIDDLE + np.array(offset)).tolist())
    return nf.Camera(position, (0.0, math.sin(yaw / 2), 0.0, math.cos(yaw / 2)), fov=FOV, size=SIZE)


def nothing(_: Part) -> bool:
    return False


def everything(_: Part) -> bool:
    return True


def pilot_of(tree: Tree, settings: Settings | None = None, **ahead: Any) -> Pilot:
    """A pilot that knows all records."""
    cutter = tree._open_store().viewer.cutter
    for height in (0.0, 500.0):
        cutter.complete_cut(camera_at((0, height, 0)), Settings(error_px=1e-3), around=True)
    return Pilot(cutter, settings or Settings(), PrefetchSettings(**ahead))


def fly(pilot: Pilot, offset: Any, velocity: Any, time: float = 10.0) -> None:
    """Two looks of a viewer on a straight path, the last one at an offset."""
    pilot.look(camera_at(np.array(offset) - 0.2 * np.array(velocity)), time - 0.2)
    pilot.look(camera_at(offset), time)


def measured(pilot: Pilot, rate: float, view: int = 1000, leaf: int = 5000) -> None:
    """The meter after a second in which views and leaves arrived."""
    count = round(rate) // (view + leaf)
    pilot.meter.note(0.0, LinkTotals(), had_requests=False)
    pilot.meter.note(1.0, LinkTotals(count, count * view, count, count * leaf), had_requests=True)
    assert pilot.meter.rate == pytest.approx(count * (view + leaf))


def test_a_plan_needs_a_look(tree: Tree) -> None:
    with pytest.raises(RuntimeError, match="a look before a plan"):
        pilot_of(tree).plan(nothing)


def test_a_plan_wants_the_cut_of_the_picture(tree: Tree) -> None:
    pilot = pilot_of(tree, prefetch=False)
    camera = camera_at((3, 5, 30), 0.4)
    pilot.look(camera, 0.0)
    plan = pilot.plan(nothing)
    cut = tree.cut(camera)
    keys, leaves = cut.keys(in_picture=True), cut.leaf_places(in_picture=True)
    with_guests = tree._viewer.cutter.with_guests
    expected = {(0, leaf): [(0, one, GEOMETRY) for one in with_guests([leaf])] for leaf in leaves}
    for level, place, direction in keys:
        expected.setdefault((level, place), []).append((level, place, direction))
    assert list(plan.wanted.items()) == list(expected.items())
    assert leaves
    assert keys
    coarsest = tree.cut(camera, error_px=1e30, geometry=False, around=True).keys()
    assert plan.order == list(dict.fromkeys([*coarsest, *chain(*expected.values())]))
    assert plan.error_px == 1.0


def test_unknown_records_come_first(tree: Tree) -> None:
    pilot = Pilot(tree._open_store().viewer.cutter, Settings(), PrefetchSettings())
    pilot.look(camera_at((0, 0, 0)), 0.0)
    plan = pilot.plan(nothing)
    assert [part[2] for part in plan.order] == [RECORD]
    assert plan.wanted == {}


def test_plans_look_ahead(tree: Tree) -> None:
    """Parts all around here and ahead follow those of the picture; a margin excludes parts behind."""
    camera = camera_at((3, 5, 30))
    orders = {}
    for name, settings in {
        "no": PrefetchSettings(prefetch=False),
        "some": PrefetchSettings(),
        "all": PrefetchSettings(margin=None),
    }.items():
        pilot = pilot_of(tree)
        pilot._prefetch_settings = settings
        pilot.look(camera, 0.0)
        orders[name] = pilot.plan(nothing).order
        assert len(set(orders[name])) == len(orders[name])
        assert orders[name][: len(orders["no"])] == orders["no"]
    assert set(orders["no"]) < set(orders["some"]) < set(orders["all"])
    paper = tree.prefetch_queue(camera.position, camera=camera)
    assert set(orders["all"]) == {*orders["no"], *paper.needed, *paper.soon}


def test_queues_are_renewed_after_movement_or_rotation(tree: Tree, monkeypatch: pytest.MonkeyPatch) -> None:
    pilot = pilot_of(tree, adapt=False)
    made: list[nf.orthoview.PrefetchQueue] = []

    def noted(*given: Any) -> nf.orthoview.PrefetchQueue:
        made.append(queue(*given))
        return made[-1]

    monkeypatch.setattr("nearfar.orthoview._pilot.queue", noted)
    ahead = tree.prefetch_queue(camera_at((0, 0, 0)).position, camera=camera_at((0, 0, 0))).ahead
    times = iter(np.arange(1000.0) * 1e5)  # So slow that the viewer counts as resting.

    def count(offset: Any, yaw: float = 0.0) -> int:
        before = len(made)
        pilot.look(camera_at(offset, yaw), next(times))
        pilot.plan(nothing)
        return len(made) - before

    assert [count((0, 0, 0)), count((0, 0, 0))] == [1, 0]
    assert count((0.099 * ahead, 0, 0)) == 0
    assert count((0.101 * ahead, 0, 0)) == 1
    assert count((0.101 * ahead, 0, 0), 0.99 * RENEWED_TURN) == 0
    assert count((0.101 * ahead, 0, 0), 1.01 * RENEWED_TURN) == 1
    pilot.switch_to(tree._open_store().viewer.cutter)
    assert count((0.101 * ahead, 0, 0), 1.01 * RENEWED_TURN) == 1


@pytest.mark.parametrize("height", [10.0, 200.0])
def test_the_speed_limit_follows_from_the_link(tree: Tree, height: float) -> None:
    """The speed in m/s at which new parts need a share of the link's bytes per second, for the sizes received."""
    pilot = pilot_of(tree, margin=None)
    measured(pilot, 60_000)
    offset, velocity = np.array([0.0, height, 0.0]), np.array([30.0, 0.0, 0.0])
    fly(pilot, offset, velocity)
    pilot.plan(everything)
    camera = camera_at(offset)
    ahead = min(tree.prefetch_queue(camera.position, camera=camera).ahead, 30.0)
    new = set(parts_of(tree, camera_at(offset + np.array([ahead, 0, 0])))) - set(parts_of(tree, camera))
    assert new
    size = sum(5000 if part[2] == GEOMETRY else 1000 for part in new)
    assert pilot.speed_limit == pytest.approx(RATE_SHARE * 60_000 * ahead / size)


def test_the_speed_limit_grows_with_the_height(tree: Tree) -> None:
    limits = []
    for height in (0.0, 100.0, 300.0):
        pilot = pilot_of(tree, margin=None)
        measured(pilot, 60_000)
        fly(pilot, (0, height, 0), (25, 0, 0))
        pilot.plan(everything)
        limits.append(pilot.speed_limit)
    assert limits == sorted(limits)
    assert limits[0] < limits[1] < limits[2]


def test_without_a_course_or_a_measurement_there_is_no_speed_limit(tree: Tree) -> None:
    for is_measured, velocity, adapt in ((False, (30, 0, 0), True), (True, (0, 0, 0), True), (True, (30, 0, 0), False)):
        pilot = pilot_of(tree, adapt=adapt)
        if is_measured:
            measured(pilot, 6_000)
        fly(pilot, (0, 10, 0), velocity)
        assert pilot.plan(everything).error_px == 1.0
        assert pilot.speed_limit == math.inf
        assert pilot.settings.error_px == 1.0


def fast(tree: Tree, held: Any, rate: float = 60_000) -> tuple[Pilot, Any]:
    """A pilot above the speed limit of the link, with its plan."""
    pilot = pilot_of(tree, margin=None)
    measured(pilot, rate)
    fly(pilot, (0, 10, 0), (400, 0, 0))
    return pilot, pilot.plan(held)


def test_a_fast_viewer_requests_a_coarser_picture(tree: Tree) -> None:
    """The least error, in steps of √2, at which the link can deliver the parts of the path."""
    pilot, _ = fast(tree, everything)
    offset = np.array([0.0, 10.0, 0.0])
    camera = camera_at(offset)
    ahead = min(tree.prefetch_queue(camera.position, camera=camera).ahead, 400.0)
    limits = []
    for step in range(11):
        error = 2.0 ** (step / 2)
        places = (camera, camera_at(offset + np.array([ahead, 0, 0])))
        here, there = (set(parts_of(tree, place, error_px=error)) for place in places)
        size = sum(5000 if part[2] == GEOMETRY else 1000 for part in there - here)
        limits.append(RATE_SHARE * 60_000 * ahead / size if size else math.inf)
    assert pilot.speed_limit == pytest.approx(limits[0])
    assert limits[0] < 400
    step = next((n for n, limit in enumerate(limits) if limit >= 400), 10)
    assert step > 0
    assert pilot._target_error == pytest.approx(2.0 ** (step / 2))


def test_a_coarser_picture_is_shown_when_loaded_or_when_the_finer_one_is_missing(tree: Tree) -> None:
    for held, is_coarse in ((everything, True), (nothing, True)):
        pilot, plan = fast(tree, held)
        assert (plan.error_px > 1.0) == is_coarse
        assert plan.error_px == pilot._target_error
    # While only the finer picture is loaded, it stays; the coarser one is read before parts ahead.
    own = set(tree.cut(camera_at((0, 10, 0))).keys(in_picture=True))
    leaves = tree.cut(camera_at((0, 10, 0))).leaf_places(in_picture=True)
    own |= {(0, place, GEOMETRY) for place in tree._viewer.cutter.with_guests(leaves)}
    pilot, plan = fast(tree, own.__contains__)
    assert plan.error_px == 1.0 < pilot._target_error
    coming = tree.cut(camera_at((0, 10, 0)), error_px=pilot._target_error).keys(in_picture=True)
    assert set(chain(*plan.wanted.values())) <= own
    assert set(coming) <= set(plan.order)
    wanted = [*chain(*plan.wanted.values())]
    base = tree.cut(camera_at((0, 10, 0)), error_px=1e30, geometry=False, around=True).keys()
    first = list(dict.fromkeys([*base, *wanted]))
    assert set(plan.order[: len(first)]) == set(first)
    assert set(coming) <= set(plan.order[: len(set(first) | set(coming)) + len(leaves) * 30])


def test_a_finer_picture_is_shown_when_loaded(tree: Tree) -> None:
    pilot, plan = fast(tree, everything)
    coarse = plan.error_px
    assert coarse > 1.0
    held = set(chain(*plan.wanted.values()))
    for time in (11.0, 12.0, 13.0):  # The viewer stops.
        pilot.look(camera_at((0, 10, 0)), time)
        plan = pilot.plan(held.__contains__)
        assert plan.error_px == coarse
        assert pilot._target_error == 1.0
    fine = tree.cut(camera_at((0, 10, 0))).keys(in_picture=True)
    assert set(fine) <= set(plan.order)
    pilot.look(camera_at((0, 10, 0)), 14.0)
    plan = pilot.plan(everything)
    assert plan.error_px == 1.0
    assert set(fine) == {part for part in chain(*plan.wanted.values()) if part[2] != GEOMETRY}


def test_a_picture_becomes_finer_with_slack_only(tree: Tree) -> None:
    """Just below the speed limit a coarser picture stays coarser, and a finer one stays finer."""
    speed = 40.0
    for error_px, is_coarse in ((1.0, False), (4.0, True), (1.0, False)):
        pilot = pilot_of(tree, margin=None)
        measured(pilot, 6_000_000)
        pilot._error = pilot._target_error = error_px
        fly(pilot, (0, 10, 0), (speed, 0, 0), 30.0)
        pilot.plan(nothing)
        assert pilot._target_error == 1.0 or speed < pilot.speed_limit < HYSTERESIS * speed
        assert (pilot._target_error > 1.0) == is_coarse
        speed = pilot.speed_limit / 1.2  # On a path of the same length, since it is longer than the smallest cell.


def test_parts_of_the_other_eye_are_wanted(tree: Tree) -> None:
    pilot = pilot_of(tree, prefetch=False)
    camera, other = camera_at((3, 5, 30), 0.4), camera_at((3, 5, 30), 2.4)
    pilot.look(camera, 0.0, [other])
    plan = pilot.plan(nothing)
    (further,) = plan.further_pictures
    cut = tree.cut(other)
    assert {part for part in chain(*further.values()) if part[2] >= 0} == set(cut.keys(in_picture=True))
    assert set(chain(*further.values())) <= set(plan.order)
    pilot.look(camera, 1.0)
    assert pilot.plan(nothing).further_pictures == []


def test_meters_forget_old_measurements(tree: Tree) -> None:
    meter = Meter()
    assert meter.rate == math.inf
    assert meter.bytes_of((0, (0, 0, 0), 3)) == meter.bytes_of((0, (0, 0, 0), GEOMETRY)) == 0
    meter.note(1.0, LinkTotals(), had_requests=True)
    assert meter.rate == math.inf
    notes = [(1.5, 700, 1), (2.5, 700, 0), (3.0, 900, 1), (3.1, 900, 1), (5.1, 1900, 1)]
    weight, count, time, views, before = 1.0, 0.0, 1.0, 0, 0
    for now, received, busy in notes:
        meter.note(now, LinkTotals(views := views + 1, received), had_requests=bool(busy))
        if busy:
            fade = 0.5 ** ((now - time) / HALF_LIFE)
            weight, count = weight * fade + now - time, count * fade + received - before
        time, before = now, received
        assert meter.rate == pytest.approx(count / weight)
        assert meter.bytes_of((0, (0, 0, 0), 3)) == received / views
    meter.note(5.1, LinkTotals(views, 5000), had_requests=True)
    assert meter.rate == pytest.approx(count / weight)
    meter.note(6.1, LinkTotals(2, 1000, 4, 8000), had_requests=False)
    assert meter.bytes_of((0, (0, 0, 0), GEOMETRY)) == 2000
