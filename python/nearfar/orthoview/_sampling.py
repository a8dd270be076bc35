"""Samples leaves spread over a world without visiting each leaf."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from nearfar._base import random
from nearfar._scene.scene import Scene
from nearfar._source.protocol import SceneSource, may_touch
from nearfar.orthoview._grid import Grid, Place, places_of

CELLS_PER_LEVEL = 48
"""Number of cells of each level into which the descent continues."""

UNIFORM_LEAVES = 128
"""Number of leaves sampled if the source has no `touches`."""

TRIANGLES = 4096
"""Number of triangles sampled from a scene in memory."""

_MAX_TRIANGLES = 100_000_000
"""Greatest triangle count of a scene whose triangles are sampled; sampling takes a byte for each."""

_SEED = 0

_EVENLY, _NUMBERS, _POINTS, _ORDER, _DESCENT = range(5)
"""Keys of the streams of random numbers; the descent uses one stream for each level."""


def spread_leaves(source: SceneSource, grid: Grid) -> list[Place]:
    """Leaves that may contain something, spread over the world, in a random but reproducible order."""
    return _sample_evenly(grid) if getattr(source, "touches", None) is None else _descend(source, grid)


def expected_leaves(source: SceneSource, grid: Grid) -> int:
    """Estimate the number of leaves that may contain something; exact for at most `CELLS_PER_LEVEL` on each level.

    Multiplies, over all levels, the mean number of such children of the level's sampled cells (Knuth, Estimating the
    efficiency of backtrack programs, 1975). Without `touches` it is the number of all leaves.
    """
    if getattr(source, "touches", None) is None:
        return math.prod(grid.counts)
    places: list[Place] = [(0, 0, 0)]
    count = float(may_touch(source, grid.box(grid.levels - 1, (0, 0, 0))))
    for level in reversed(range(grid.levels - 1)):
        if not places:
            return 0
        children = _touched_children(source, grid, level, places)
        count *= len(children) / len(places)
        places = _shuffle(children, grid, level)
    return round(count)


def leaves(source: SceneSource, grid: Grid) -> Iterator[Place]:
    """Leaves that may contain something, in a random but reproducible order, without duplicates.

    Scenes in memory are sampled by triangle, because most leaves of most worlds are empty or flat and look the same
    from all directions. Other sources are sampled level by level among the cells that they touch, or uniformly if they
    have no `touches`.
    """
    sampled: set[Place] = set()
    for place in _candidates(source, grid):
        if place not in sampled:
            sampled.add(place)
            yield place


def _candidates(source: SceneSource, grid: Grid) -> Iterator[Place]:
    if isinstance(source, Scene) and 0 < source.triangle_count <= _MAX_TRIANGLES:
        yield from _leaves_of_triangles(source, grid)
    yield from spread_leaves(source, grid)


def _leaves_of_triangles(scene: Scene, grid: Grid) -> Iterator[Place]:
    """Leaves of the grid that hold random points of random triangles."""
    total = scene.triangle_count
    is_chosen = np.zeros(total, bool)
    is_chosen[(random.uniform(_SEED, _NUMBERS, np.arange(TRIANGLES)) * total).astype(np.int64)] = True
    a, b, c = np.moveaxis(scene._core.subset_of_triangles(is_chosen).triangles().astype(np.float64), 1, 0)
    first, second = random.uniform(_SEED, _POINTS, np.arange(2 * len(a))).reshape(2, -1, 1)
    # The square root of one number spreads points evenly over a triangle (Turk, Generating random points in triangles).
    root = np.sqrt(first)
    points = scene.origin + a + root * ((1 - second) * (b - a) + second * (c - a))
    order = np.argsort(random.uniform(_SEED, _ORDER, np.arange(len(points))), kind="stable")
    places = np.floor((points[order] - grid.origin) / grid.cell)
    is_inside = ((places >= 0) & (places < grid.counts)).all(axis=1)
    yield from places_of(places[is_inside].astype(np.int64))


def _sample_evenly(grid: Grid) -> list[Place]:
    total = math.prod(grid.counts)
    uniform = random.uniform(_SEED, _EVENLY, np.arange(min(total, UNIFORM_LEAVES)))
    numbers = np.argsort(uniform, kind="stable") if total <= UNIFORM_LEAVES else (uniform * total).astype(np.int64)
    return places_of(np.column_stack(np.unravel_index(numbers, grid.counts)))


def _descend(source: SceneSource, grid: Grid) -> list[Place]:
    """Sample leaves that a source may touch; `touches` is called for children of `CELLS_PER_LEVEL` cells a level."""
    places: list[Place] = [(0, 0, 0)]
    for level in reversed(range(grid.levels - 1)):
        places = _shuffle(_touched_children(source, grid, level, places), grid, level)
    return places


def _touched_children(source: SceneSource, grid: Grid, level: int, places: list[Place]) -> list[Place]:
    """Children, on a level, of cells of the level above that may contain something."""
    children = [child for place in places for _, child in grid.children(level + 1, place)]
    return [child for child in children if may_touch(source, grid.box(level, child))]


def _shuffle(places: list[Place], grid: Grid, level: int) -> list[Place]:
    """Shuffle cells of a level and keep at most `CELLS_PER_LEVEL`; a cell's random key depends on the cell alone."""
    numbers = np.array([np.ravel_multi_index(place, grid.counts_at(level)) for place in places], np.uint64)
    order = np.argsort(random.uniform(_SEED, _DESCENT + level, numbers), kind="stable")
    return [places[number] for number in order[:CELLS_PER_LEVEL].tolist()]
