"""Tests of the regions of a walk: centres, changes with hysteresis, predicted jumps, and background work."""

from __future__ import annotations

import functools
import itertools
import math
import threading
import time
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import nearfar as nf
from tests.support.reduce_cases import Array, street

SMALL: dict[str, Any] = {"face_size": 8, "samples": 1, "backend": "cpu"}
PATH = np.array([[-30.0, 1.7, 5.0], [40.0, 1.7, 5.0], [60.0, 2.2, 30.0]])


@pytest.fixture(scope="module")
def scene() -> nf.Scene:
    return street()


@pytest.fixture
def regions(scene: nf.Scene) -> nf.Regions:
    return nf.regions(scene, PATH, r2=50.0, **SMALL)


def places_along(path: Array, step: float = 0.25) -> Array:
    """Places along a path, a step apart."""
    pieces = [
        start + np.linspace(0.0, 1.0, 1 + math.ceil(np.linalg.norm(end - start) / step))[:, None] * (end - start)
        for start, end in itertools.pairwise(path)
    ]
    return np.concatenate(pieces)


def distances(regions: nf.Regions, place: Array) -> Array:
    return np.asarray(np.hypot(*(regions.centers - place)[:, [0, 2]].T))


def wait(regions: nf.Regions, number: int) -> None:
    """Wait until a region is computed."""
    deadline = time.monotonic() + 60
    while not regions.ready(number) and time.monotonic() < deadline:
        time.sleep(0.001)
    assert regions.ready(number)


@functools.cache
def whole_area() -> nf.Regions:
    return nf.regions(street(), area=[(-40, -5), (70, 40)], r2=50.0, **SMALL)


WALKS = st.lists(st.tuples(st.floats(-200, 200), st.floats(1.0, 2.5), st.floats(-200, 200)), min_size=1, max_size=5)


@settings(max_examples=15)
@given(WALKS, st.sampled_from([(8.0, 1.0, 50.0), (8.0, 0.0, 16.5), (3.0, 2.5, 20.0), (20.0, 4.0, 200.0)]))
def test_every_place_of_the_path_is_near_a_centre_and_unfolded(
    listed: list[tuple[float, float, float]], sizes: tuple[float, float, float]
) -> None:
    reach, band, r2 = sizes
    path = np.array(listed)
    if reach == 8.0 and band == 0.0:
        # The least r2 for this reach has no margin for other heights.
        path[:, 1] = 1.7
    regions = nf.regions(street(), path, r2=r2, reach=reach, hysteresis=band, **SMALL)
    radii = regions.radii
    assert (regions.reach, regions.hysteresis, radii.r2) == (reach, band, r2)
    assert regions.spacing == pytest.approx(math.sqrt(3) * (reach - band))
    places = places_along(path, 2.0) if len(path) > 1 else path
    offsets = []
    for place in places:
        away = distances(regions, place)
        number = regions.index(place)
        assert number == away.argmin()
        assert away[number] <= (reach - band) * (1 + 1e-9)
        offset = place - regions.centers[number]
        offsets.append((float(np.hypot(offset[0], offset[2])), float(offset[1])))
    # Two places suffice for the margins: the farthest and highest, and the farthest and lowest.
    for height in {sign * max(sign * y for _, y in offsets) for sign in (1.0, -1.0)}:
        farthest = max(away for away, _ in offsets), height, 0.0
        # Without hysteresis the farthest place may be just at the fold, which is known to 1e-4 (r2 − r1).
        assert nf.fold_margin(farthest, center=(0, 0, 0), r1=radii.r1, r2=radii.r2) > (0.0 if band else -1e-3)
    if len(path) > 1:
        # Every centre has a part of the path in its cell, even if shorter than a step.
        apart = [np.hypot(*(places_along(path, 0.2) - center)[:, [0, 2]].T).min() for center in regions.centers]
        assert max(apart) <= (reach - band) + 0.2


def test_an_area_is_covered_an_eye_above_the_ground(scene: nf.Scene) -> None:
    corners = np.array([(-40.0, -10.0), (30.0, -15.0), (20.0, 40.0), (0.0, 5.0)])
    regions = nf.regions(scene, area=corners, r2=50.0, eye_height=1.6, **SMALL)
    np.testing.assert_allclose(regions.centers[:, 1], 1.6, atol=1e-4)
    for x, z in places_along(np.insert(np.concatenate([corners, corners[:1]]), 1, 0.0, axis=1), 1.0)[:, [0, 2]]:
        assert distances(regions, np.array([x, 0.0, z])).min() <= 7.0 + 1e-9
    # A rectangle is given by two corners; it needs about its area divided by that of a cell.
    square = nf.regions(scene, area=[(-50, -50), (50, 50)], r2=50.0, **SMALL)
    cell = math.sqrt(3) / 2 * square.spacing**2
    assert 100**2 / cell <= len(square) <= (100 + 4 / math.sqrt(3) * square.spacing) ** 2 / cell
    apart = np.linalg.norm(square.centers[:, None] - square.centers, axis=-1)
    np.testing.assert_allclose(np.sort(apart, axis=1)[:, 1], square.spacing, rtol=1e-5)


def test_regions_are_numbered_as_the_path_visits_them(regions: nf.Regions) -> None:
    first = [regions.index(place) for place in places_along(PATH, 0.01)]
    assert list(dict.fromkeys(first)) == list(range(len(regions)))
    np.testing.assert_allclose(
        np.linalg.norm(np.diff(regions.centers, axis=0), axis=1).min(), regions.spacing, rtol=0.01
    )


def test_the_budget_is_kept_around_every_centre(scene: nf.Scene) -> None:
    city = nf.datasets.city(blocks=3, detail=0)
    path = [(-60.0, 1.7, 0.0), (60.0, 1.7, 0.0)]
    budget = city.triangle_count // 3
    regions = nf.regions(city, path, budget=budget, reach=4.0, **SMALL)
    radii = regions.radii
    counts = [nf.load_curve(city, center=center).count(radii.r2) for center in regions.centers]
    assert max(counts) <= budget
    more = [nf.load_curve(city, center=center).radius(budget) for center in regions.centers]
    assert radii.r2 == min(more)
    assert radii == nf.choose_radii(city, regions.centers[int(np.argmin(more))], budget=budget, reach=4.0)


@settings(max_examples=15)
@given(st.lists(st.tuples(st.floats(-35, 65), st.floats(0, 35)), min_size=2, max_size=40))
def test_regions_stay_within_reach_and_changes_are_metres_apart(listed: list[tuple[float, float]]) -> None:
    regions = whole_area()
    steps = places_along(np.insert(np.array(listed), 1, 1.7, axis=1), 0.1)
    current: int | None = None
    since = math.inf
    for before, place in itertools.pairwise(steps):
        since += float(np.linalg.norm(place - before))
        number = regions.index(place, current)
        away = distances(regions, place)
        if current is not None and away[current] <= regions.reach:
            assert number == current
        else:
            assert away[number] == away.min()
            assert away[number] <= regions.reach - regions.hysteresis + 1e-9
            assert since >= regions.hysteresis - 0.2
            since = 0.0
        current = number


def test_the_documented_predicted_jump(scene: nf.Scene) -> None:
    regions = nf.regions(scene, PATH[:2], r2=50.0, hysteresis=0.0, **SMALL)
    fov = nf.Fov.symmetric(90, 16 / 9)
    across = nf.Camera.look_at((0, 1.7, 0), (0, 1.7, 1), fov=fov, size=(960, 540))
    assert regions.jump(0, 1, across) == pytest.approx(480 * math.sqrt(3) * 8 / 50)
    assert round(regions.jump(0, 1, across, distance=50)) == 133
    assert regions.jump(0, 1, across, distance=100) == pytest.approx(regions.jump(1, 0, across) / 2)
    # Straight ahead nothing jumps, and at 60° to the path only the component across the line of sight counts.
    ahead = nf.Camera.look_at((0, 1.7, 0), (1, 1.7, 0), fov=fov, size=(960, 540))
    assert regions.jump(0, 1, ahead) == pytest.approx(0.0, abs=1e-6)
    aside = nf.Camera.look_at((0, 1.7, 0), (0.5, 1.7, math.sqrt(0.75)), fov=fov, size=(960, 540))
    assert regions.jump(0, 1, aside) == pytest.approx(133.02 * math.sqrt(0.75), rel=1e-3)
    cube = nf.Camera((0, 1.7, 0), fov=nf.CubeFace(4), size=(960, 960))
    assert regions.jump(0, 1, cube) == pytest.approx(regions.jump(0, 1, across))
    parallel = nf.Camera((0, 1.7, 0), fov=nf.Orthographic(-1, 1, -1, 1), size=(8, 8))
    with pytest.raises(ValueError, match="camera: expected a perspective view"):
        regions.jump(0, 1, parallel)


@pytest.mark.parametrize("turn", [0.3, 1.4, 2.5, 4.4])
def test_far_points_jump_as_predicted(scene: nf.Scene, turn: float) -> None:
    """A far point is shown at U + P − O. In the middle of the picture it moves by the prediction, to second order."""
    regions = nf.regions(scene, PATH, r2=50.0, **SMALL)
    start, end = regions.centers[0], regions.centers[1]
    user = 0.5 * (start + end)
    toward = np.array([math.cos(turn), 0.1, math.sin(turn)])
    view = nf.Camera.look_at(user, user + toward, fov=nf.Fov.symmetric(90, 16 / 9), size=(960, 540))
    for distance in (60.0, 500.0):
        point = start + distance * toward / np.linalg.norm(toward)
        shown = [
            nf.morph([point], user=user, center=center, r1=regions.radii.r1, r2=regions.radii.r2)
            for center in (start, end)
        ]
        (x0, y0, _), (x1, y1, _) = (view.project(place)[0] for place in shown)
        measured = math.hypot(x1 - x0, y1 - y0)
        step = float(np.linalg.norm(end - start))
        assert measured == pytest.approx(regions.jump(0, 1, view, distance), rel=1.2 * step / distance)


def test_regions_are_computed_on_request_and_the_last_are_kept(scene: nf.Scene, regions: nf.Regions) -> None:
    assert (regions.memory, regions.bytes.sum(), regions.ready(0)) == (0, 0, False)
    first = regions.reduced(0)
    assert isinstance(first, nf.ReducedScene)
    assert first is regions.reduced(0)
    assert first.scene is scene
    radii = regions.radii
    afresh = nf.reduce(scene, center=regions.centers[0], r1=radii.r1, r2=radii.r2, **SMALL)
    assert first.env is not None
    assert afresh.env is not None
    np.testing.assert_array_equal(first.env.color, afresh.env.color)
    assert first.stats == afresh.stats
    assert regions.bytes[0] == first.stats["map_bytes"] + first.stats["near_bytes"] > 0
    for number in (1, 2, 0, 3):
        regions.reduced(number)
    # Region 1 is the least recently used.
    assert [regions.ready(number) for number in range(5)] == [True, False, True, True, False]
    assert regions.memory == regions.bytes[[0, 2, 3]].sum()
    assert (regions.bytes[:4] > 0).all()
    assert regions.bytes[4] == 0
    assert regions.reduced(0) is first


def test_the_region_ahead_is_computed_in_the_background(monkeypatch: pytest.MonkeyPatch, regions: nf.Regions) -> None:
    threads: dict[int, int] = {}
    original = nf.Regions._make

    def noted(self: nf.Regions, number: int) -> Any:
        threads[number] = threading.get_ident()
        return original(self, number)

    monkeypatch.setattr(nf.Regions, "_make", noted)
    here = regions.centers[1]
    assert regions.prefetch(here, (0.0, 0.0, 0.0)) is None
    assert regions.prefetch(here, (0.0, 3.0, 0.0)) is None
    # The user would leave the corridor of regions here.
    assert regions.prefetch(here, (0.0, 0.0, 1.0), 1) in (None, 0, 2)
    assert regions.prefetch(here, (1.4, 0.0, 0.0), 1) == 2
    wait(regions, 2)
    assert threads[2] != threading.get_ident()
    assert regions.prefetch(here, (-1.4, 0.0, 0.0), 1) == 0
    wait(regions, 0)
    assert regions.reduced(2).center == pytest.approx(regions.centers[2])
    assert list(threads).count(2) == 1
    # Outside the reach of a region the next one is the one at the user.
    far = regions.centers[4]
    assert regions.prefetch(far, (1.4, 0.0, 0.0), 1) in (None, 4, 5)


def test_background_failures_are_raised_on_request(monkeypatch: pytest.MonkeyPatch, regions: nf.Regions) -> None:
    def fail(self: nf.Regions, number: int) -> nf.ReducedScene:
        raise MemoryError("map: no room")

    with monkeypatch.context() as patch:
        patch.setattr(nf.Regions, "_make", fail)
        assert regions.prefetch(regions.centers[0], (1.0, 0.0, 0.0), 0) == 1
        wait(regions, 1)
        assert regions.prefetch(regions.centers[0], (1.0, 0.0, 0.0), 0) == 1
        with pytest.raises(MemoryError, match="no room"):
            regions.reduced(1)
    assert regions.reduced(1).nbytes > 0


def test_a_failed_region_is_tried_once_and_does_not_block_others(
    monkeypatch: pytest.MonkeyPatch, regions: nf.Regions
) -> None:
    tried: list[int] = []

    def fail(self: nf.Regions, number: int) -> nf.ReducedScene:
        tried.append(number)
        raise MemoryError("map: no room")

    monkeypatch.setattr(nf.Regions, "_make", fail)
    for velocity, expected in ((1.0, [3]), (1.0, [3]), (-1.0, [3, 1])):
        following = regions.prefetch(regions.centers[2], (velocity, 0.0, 0.0), 2)
        assert following == expected[-1]
        wait(regions, following)
        assert tried == expected


WRONG: list[tuple[dict[str, Any], str]] = [
    ({"reach": 60}, "reach: expected less than r2 = 50 m, where the map begins, got 60"),
    ({"path": [(0, 1.7, 0), (3000, 1.7, 0), (0, 1.7, 2001)]}, r"path: .* within the scene, which has x from -2000 to"),
    ({"path": None, "area": [(0, 0), (0, -2001)]}, "area: expected places within the scene.*got 1 outside"),
    ({"r2": 12}, r"r2: expected an r2 of at least 16.46 m for a reach of 8 m, because the picture would fold"),
    ({"path": [(0, 1.7, 0), (4, 31.7, 0)], "r2": 17}, r"path: .* 15 m above or below the centre .*would fold; use"),
    ({"path": None, "area": [(0, 0)]}, "area: expected 2 to 1000 corners, got 1"),
    ({"hysteresis": 8}, "hysteresis: expected less than the reach of 8 m, got 8"),
    ({"reach": 1e-6, "hysteresis": 0}, "reach: expected reach − hysteresis large enough for at most 100,000 regions"),
    ({"path": None, "area": [(-1999, -1999), (1999, 1999)], "reach": 1.1}, "reach: .*at most 100,000 regions"),
]


@pytest.mark.parametrize(("wrong", "match"), WRONG)
def test_wrong_arguments_are_named(scene: nf.Scene, wrong: dict[str, Any], match: str) -> None:
    with pytest.raises(ValueError, match=match):
        nf.regions(scene, **{"path": PATH, "r2": 50, **SMALL, **wrong})


def test_a_budget_too_small_for_the_reach_is_refused(scene: nf.Scene) -> None:
    with pytest.raises(ValueError, match=r"budget: expected an r2 of at least 16\.46 m"):
        nf.regions(scene, PATH, budget=2, **SMALL)
