"""Tests of the hexagonal grid: nearest centres, cells on a path or in an area, heights of the ground."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
from hypothesis import example, given, settings, strategies as st
from numpy.typing import NDArray

import nearfar as nf
from nearfar._reduce.walk.folds import height_differences, walkable_distance
from nearfar._reduce.walk.grid import Grid, grids
from nearfar._reduce.walk.plan import ground_heights
from nearfar._scene.builder import SceneBuilder
from tests.support.reduce_cases import Array, box

GRID = Grid((3.0, -2.0), 0.3, 10.0)
ALL = np.stack(np.meshgrid(np.arange(-20, 21), np.arange(-20, 21), indexing="ij"), axis=-1).reshape(-1, 2)
NUMBERS = st.floats(-60.0, 60.0, allow_nan=False)
POINTS = st.tuples(NUMBERS, st.floats(0.0, 9.0), NUMBERS)


STEP = 0.1


def dense(path: Array, step: float = STEP) -> Array:
    """Points of a path at most a step apart."""
    pieces = [path[:1]]
    for start, end in itertools.pairwise(path):
        shares = np.linspace(0.0, 1.0, 2 + int(np.linalg.norm(end - start) / step))
        pieces.append(start + shares[:, None] * (end - start))
    return np.concatenate(pieces)


def owners(points: Array, grid: Grid = GRID) -> Array:
    """Indices in `ALL` of the centres nearest to points (N, 2), by brute force, and margins to the second nearest."""
    away = np.linalg.norm(points[:, None] - grid.centers(ALL), axis=-1)
    two = np.partition(away, 1, axis=1)
    return np.column_stack([away.argmin(axis=1), two[:, 1] - two[:, 0], two[:, 0]])


def in_polygon(points: Array, corners: Array) -> NDArray[np.bool_]:
    """Whether points are in a polygon: whether a ray along z crosses an odd number of its sides, one by one."""
    inside = []
    for x, z in points:
        crossed = 0
        for (x0, z0), (x1, z1) in zip(corners, np.roll(corners, -1, axis=0), strict=True):
            crossed += (x0 <= x < x1 or x1 <= x < x0) and z0 + (x - x0) / (x1 - x0) * (z1 - z0) > z
        inside.append(crossed % 2 == 1)
    return np.array(inside, bool)


def test_neighbours_are_a_spacing_apart_and_cells_have_the_radius() -> None:
    places = GRID.centers(ALL)
    away = np.linalg.norm(places - GRID.centers(np.array([[0, 0]])), axis=1)
    np.testing.assert_allclose(np.sort(away)[1:7], GRID.spacing)
    points = np.random.default_rng(0).uniform(-40, 40, (5000, 2))
    nearest = owners(points)[:, 2]
    assert nearest.max() <= GRID.spacing / math.sqrt(3)
    assert nearest.max() > 0.95 * GRID.spacing / math.sqrt(3)


def test_the_nearest_centre_is_found() -> None:
    points = np.random.default_rng(1).uniform(-60, 60, (5000, 2))
    found = owners(points)
    chosen = GRID.nearest(points)
    clear = found[:, 1] > 1e-9
    np.testing.assert_array_equal(chosen[clear], ALL[found[clear, 0].astype(int)])


@pytest.mark.slow
@given(st.lists(POINTS, min_size=1, max_size=6))
def test_cells_of_a_path_contain_its_points(listed: list[tuple[float, float, float]]) -> None:
    path = np.array(listed)
    cells, facts = GRID.cells_of_path(path)
    points = dense(path)
    found = owners(points[:, [0, 2]])
    expected = found[found[:, 1] > 1e-6]
    numbers = [int(np.flatnonzero((cell == ALL).all(axis=1))[0]) for cell in cells]
    assert len(set(numbers)) == len(numbers)
    assert set(expected[:, 0].astype(int)) <= set(numbers)
    for number, (low, high, first) in zip(numbers, facts, strict=True):
        mine = found[:, 0] == number
        if not mine.any():
            # Less than a step of the path lies in the cell.
            begin = path[int(first)] + (first % 1) * (path[min(int(first) + 1, len(path) - 1)] - path[int(first)])
            away = np.linalg.norm(begin[[0, 2]] - GRID.centers(ALL[[number]]))
            assert away <= GRID.spacing / math.sqrt(3) + 1e-6
        else:
            heights = points[mine, 1]
            assert low - 1e-9 <= heights.min()
            assert heights.max() <= high + 1e-9
            # The path may pass a corner of the cell by less than a step, between two points beside it.
            away = np.linalg.norm(points[:, [0, 2]] - GRID.centers(ALL[[number]]), axis=1)
            around = points[away <= found[:, 2] + 2.0 * STEP, 1]
            assert around.min() <= low + STEP
            assert high - STEP <= around.max()
    assert (np.diff(facts[:, 2]) >= 0).all()


@pytest.mark.slow
@settings(max_examples=20)
@example([(0.0, 0.0), (0.0, 0.0), (1.0, 5e-324)])
@example([(0.0, 0.0), (0.0, 0.0), (0.0, 5e-324)])
@given(st.lists(st.tuples(NUMBERS, NUMBERS), min_size=3, max_size=6))
def test_cells_of_an_area_contain_its_points(corners: list[tuple[float, float]]) -> None:
    outline = np.array(corners)
    cells = {tuple(cell) for cell in GRID.cells_of_area(outline).tolist()}
    axis = np.arange(-60.0, 60.5, 2.5)
    points = np.stack(np.meshgrid(axis, axis), axis=-1).reshape(-1, 2) + 0.01
    inside = points[in_polygon(points, outline)]
    border = dense(np.insert(np.concatenate([outline, outline[:1]]), 1, 0.0, axis=1))[:, [0, 2]]
    found = owners(np.concatenate([inside, border]))
    expected = {tuple(ALL[int(n)]) for n in found[found[:, 1] > 1e-6, 0]}
    assert expected <= cells
    # No centre is farther away than its own radius.
    places = GRID.centers(np.array(sorted(cells)))
    reach = np.concatenate([inside, border, places[in_polygon(places, outline)]])
    away = np.linalg.norm(places[:, None] - reach, axis=-1).min(axis=1)
    assert away.max() <= GRID.spacing / math.sqrt(3) + STEP


def test_a_straight_path_needs_the_fewest_centres() -> None:
    """A cell covers at most 2 c of a straight path, and √3 c of it if the next one is to follow without a gap."""
    path = np.array([[-40.0, 1.7, 7.0], [60.0, 1.7, 80.0]])
    counts = [len(grid.cells_of_path(path)[0]) for grid in grids(path[:, [0, 2]], 10.0)]
    assert min(counts) == math.ceil(np.hypot(100, 73) / 10.0) + 1 - math.ceil(np.hypot(100, 73) / 10.0) % 2
    assert len(GRID.cells_of_path(path)[0]) > min(counts)


def walled() -> nf.Scene:
    """A slope with a house and a thin roof on it; beyond x = 50 m there is no ground, but a house."""
    build = SceneBuilder()
    slope = [[-50, -10, -50], [-50, -10, 50], [50, 10, 50], [50, 10, -50]]
    build.instance(build.mesh(slope, [[0, 1, 2], [0, 2, 3]]), name="slope")
    build.instance(build.mesh(*box((-5, -5, -5), (3, 20, 3))), name="house")
    build.instance(build.mesh(*box((70, 4, -4), (78, 30, 4))), name="lone house")
    return build.build()


def test_the_ground_is_found_next_to_roofs_and_without_ground() -> None:
    places = np.array([[20.0, 20.0], [-30.0, 10.0], [0.0, 0.0], [74.0, 0.0], [68.0, 0.0], [120.0, 0.0]])
    heights = ground_heights(walled(), places, 7.0)
    # On the slope, its own height; under the house and next to the lone one, the lowest surface near it.
    np.testing.assert_allclose(heights[:2], [4.0, -6.0], atol=1e-4)
    assert -1.4 - 1e-4 <= heights[2] <= 0.0
    np.testing.assert_allclose(heights[3:], [4.0, 4.0, -10.0], atol=1e-4)


@given(st.lists(POINTS, min_size=1, max_size=5), st.lists(POINTS, min_size=1, max_size=3), st.floats(1.0, 30.0))
def test_climbs_cover_the_points_within_reach(
    listed: list[tuple[float, float, float]], middles: list[tuple[float, float, float]], reach: float
) -> None:
    path, centers = np.array(listed), np.array(middles)
    points = dense(path)
    for center, climb in zip(centers, height_differences(path, centers, reach), strict=True):
        away = np.hypot(*(points - center)[:, [0, 2]].T)
        for radius, sign in ((reach - STEP, 1.0), (reach + STEP, -1.0)):
            near = np.abs(points[away <= radius, 1] - center[1])
            # At least that of points clearly within reach, at most that of points nearly within it.
            assert sign * climb >= sign * near.max(initial=0.0) - STEP


def test_the_quick_margin_is_conservative() -> None:
    for height in (0.0, 0.1, 0.34, 2.0, -0.0):
        exact = nf.fold_margin((0, height, 0), center=(0, 0, 0), r1=8.0, r2=17.0)
        rounded = walkable_distance("blend", 8.0, 17.0, height)
        assert exact - 0.05 < rounded <= exact
    assert walkable_distance("blend", 8.0, 17.0, 2.0 + 1e-9) == walkable_distance("blend", 8.0, 17.0, 2.0)
    assert walkable_distance("none", 8.0, 17.0, 5.0) == math.inf
    assert walkable_distance("blend", 8.0, 17.0, 1e300) == -math.inf
    assert walkable_distance("cylinder", 8.0, 17.0, 3.0) == pytest.approx(8.0, abs=1e-3)
