"""Objects along the streets and in the parks: trees, lamps, benches, parked cars."""

from __future__ import annotations

import functools
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar.datasets import _furniture as furniture, _vegetation as vegetation, _vehicles as vehicles
from nearfar.datasets._ground import FLAT
from nearfar.datasets._layout import AVENUE, KERB, Grid, Plot
from nearfar.datasets._random import Floats, RandomStream
from nearfar.datasets._shapes import Soup
from nearfar.datasets._stage import Stage, placements

_FURNITURE: dict[str, Callable[[int], Soup]] = {
    "lamp_post": furniture.lamp_post,
    "bench": furniture.bench,
    "litter_bin": furniture.litter_bin,
    "traffic_light": furniture.traffic_light,
    "bollard": furniture.bollard,
    "bus_stop": furniture.shelter,
    "planter": vegetation.planter,
}
_TREES = 9
_PARKED = 14
_CLEAR = 2.2
"""Least distance of street furniture from the origin, metres."""


@dataclass(frozen=True)
class Side:
    """A block's edge along a street; positions count from its left end as seen from across the street."""

    block: int
    length: float
    start: tuple[float, float]
    quarter: int
    """Quarter turns from +z to the direction that faces the street."""
    half: float
    """Half the width of the carriageway in front of it, metres."""

    def world_position(self, along: ArrayLike, inward: ArrayLike) -> tuple[Floats, Floats]:
        """World x and z of positions along the kerb and inward from it, metres."""
        u, v = np.asarray(along, np.float64), np.asarray(inward, np.float64)
        x, z = self.start
        along_x, along_z = ((1.0, 0.0), (0.0, -1.0), (-1.0, 0.0), (0.0, 1.0))[self.quarter]
        in_x, in_z = ((0.0, -1.0), (-1.0, 0.0), (0.0, 1.0), (1.0, 0.0))[self.quarter]
        return x + along_x * u + in_x * v, z + along_z * u + in_z * v


def sides(grid: Grid) -> list[Side]:
    """List all edges of all blocks."""
    edges = []
    for block, (i, j) in enumerate(grid.numbers()):
        x0, x1, z0, z1 = grid.block(i, j)
        starts = ((x0, z1), (x1, z1), (x1, z0), (x0, z0))
        for quarter, (start, street) in enumerate(zip(starts, (j + 1, i + 1, j, i), strict=True)):
            length = x1 - x0 if quarter % 2 == 0 else z1 - z0
            edges.append(Side(block, length, start, quarter, grid.half(street)))
    return edges


class Places:
    """Collects the positions of objects of one kind."""

    def __init__(self) -> None:
        self._rows: list[Floats] = []

    def add(self, x: ArrayLike, y: ArrayLike, z: ArrayLike, turn: ArrayLike, size: ArrayLike = 1.0) -> None:
        """Add positions in metres with turns (fractions of a full turn) and sizes (factors)."""
        rows = np.broadcast_arrays(*(np.atleast_1d(np.asarray(v, np.float64)) for v in (x, y, z, turn, size)))
        self._rows.append(np.stack(rows, -1))

    def line(self, side: Side, spots: ArrayLike, inward: float, turn: ArrayLike, size: ArrayLike = 1.0) -> None:
        """Add positions on the pavement along a side, `inward` metres from the kerb."""
        x, z = side.world_position(spots, inward)
        self.add(x, KERB, z, turn, size)

    def rows(self, *, clear: float = 0.0) -> Floats:
        """Return rows (K, 5) of x, y, z, turn, size; objects within `clear` metres of the y axis are left out."""
        rows = np.concatenate(self._rows) if self._rows else np.zeros((0, 5))
        return rows[rows[:, 0] * rows[:, 0] + rows[:, 2] * rows[:, 2] >= clear * clear]


def dress(stage: Stage, grid: Grid, plots: Sequence[Plot], seed: int, detail: int) -> None:
    """Add everything except buildings, ground and moving cars; nothing stands on `plots`."""
    things: dict[str, Places] = {name: Places() for name in (*_FURNITURE, "tree", "far_tree", "parked_car")}
    for side in sides(grid):
        random = RandomStream(seed, 30, side.block, side.quarter)
        _street_trees(side, things["tree"], random, detail)
        _furnish_side(side, things, random)
        _parked(side, things["parked_car"], random)
    by_block: dict[int, list[Plot]] = {}
    for plot in plots:
        by_block.setdefault(plot.block, []).append(plot)
    for block, (i, j) in enumerate(grid.numbers()):
        _furnish_block(
            grid, i, j, grid.use(i, j, seed), by_block.get(block, []), things, RandomStream(seed, 31, i, j), detail
        )
    _outskirts(grid, things["far_tree"], RandomStream(seed, 32), detail)

    def parked_car(variant: int) -> Soup:
        body = vehicles.BODIES[variant % len(vehicles.BODIES)]
        return vehicles.car(body, vehicles.PAINTS[(variant * 3 + 1) % len(vehicles.PAINTS)], detail)

    tree = functools.partial(vegetation.broadleaf, seed, detail=detail)
    far_tree = functools.partial(vegetation.broadleaf, seed, detail=detail if detail >= 3 else 1)
    near, far = placements(*things["tree"].rows(clear=_CLEAR + 3.0).T), placements(*things["far_tree"].rows().T)
    stage.mixed(tree, RandomStream(seed, 33).integers(len(near), _TREES), near, "tree")
    stage.mixed(far_tree, RandomStream(seed, 35).integers(len(far), _TREES), far, "tree", len(near))
    if detail < 2:
        return
    parked = placements(*things["parked_car"].rows(clear=_CLEAR + 3.0).T)
    stage.mixed(parked_car, RandomStream(seed, 34).integers(len(parked), _PARKED), parked, "parked_car")
    for name, make in _FURNITURE.items():
        stage.many(make(detail), placements(*things[name].rows(clear=_CLEAR).T), name)


def _street_trees(side: Side, trees: Places, random: RandomStream, detail: int) -> None:
    if side.half < AVENUE and not random.chance(0.62):
        return
    step = 8.0 if detail >= 3 else 16.0
    along = np.arange(13.0, side.length - 12.0, step)
    spots = along[random.uniform(len(along)) < 0.9]
    trees.line(side, spots, 1.1, random.uniform(len(spots)), random.uniform(len(spots), 0.72, 1.05))


def _furnish_side(side: Side, things: dict[str, Places], random: RandomStream) -> None:
    """Add lamps, benches, bins, signals and bollards of a side; stops and planters on avenues."""
    turn, end = 0.25 * side.quarter, side.length
    things["lamp_post"].line(side, np.arange(9.0, end - 6.0, 24.0), 0.6, turn)
    # Benches turn their backs to the street.
    table = (("bench", 17.0, 0.75, 0.35, 0.5), ("litter_bin", 23.0, 0.8, 0.5, 0.0))
    for name, first, inward, chance, fraction in table:
        spots = np.arange(first, end - 14.0, 18.0)
        things[name].line(side, spots[random.uniform(len(spots)) < chance], inward, turn + fraction)
    things["traffic_light"].line(side, 0.8, 0.8, turn - 0.25)
    things["bollard"].line(side, [6.2, end - 6.2], 0.45, 0.0)
    if side.half == AVENUE:
        if random.chance(0.3):
            things["bus_stop"].line(side, 37.6, 2.3, turn)
        spots = np.arange(20.0, end - 14.0, 11.0)
        spots = spots[random.uniform(len(spots)) < 0.4]
        things["planter"].line(side, spots, 3.3, random.uniform(len(spots)))


def _parked(side: Side, parked: Places, random: RandomStream) -> None:
    along = np.arange(15.0, side.length - 14.0, 6.0)
    keep = random.uniform(len(along)) < 0.36
    nudge = random.uniform(len(along), -0.3, 0.3)
    x, z = side.world_position((along + nudge)[keep], -1.2)
    # Traffic keeps to the right, so the block is on the driver's right hand.
    parked.add(x, 0.0, z, 0.25 * side.quarter + 0.75)


def _furnish_block(
    grid: Grid,
    i: int,
    j: int,
    use: str,
    plots: Sequence[Plot],
    things: dict[str, Places],
    random: RandomStream,
    detail: int,
) -> None:
    """Add trees and benches of a park, a plaza or a courtyard, where nothing is built."""
    x0, x1, z0, z1 = grid.block(i, j)
    x, z = 0.5 * (x0 + x1), 0.5 * (z0 + z1)
    if use == "park":
        count, sizes = (150 if detail >= 3 else 60), (0.7, 1.25)
        trees = np.stack([random.uniform(count, -30.5, 30.5), random.uniform(count, -20.5, 20.5)], -1)
        trees = trees[(np.abs(trees) > 3.2).all(1) & ((trees * trees).sum(1) > 100.0)]
        spots = np.arange(-26.0, 27.0, 7.0)
        spots = spots[np.abs(spots) > 9.0]
        things["bench"].add(x + spots, KERB, z - 2.1, 0.0)
        things["bench"].add(x + spots, KERB, z + 2.1, 0.5)
    elif use == "towers":
        sizes = (0.6, 0.85)
        trees = np.array([(a, b) for a in (-30.0, -24.0, -2.5, 2.5, 24.0, 30.0) for b in (-20.0, 20.0)])
    else:
        count, sizes = (5 if detail >= 3 else 3), (0.45, 0.7)
        trees = np.stack([random.uniform(count, -28.0, 28.0), random.uniform(count, -2.2, 2.2)], -1)
    trees = np.add(trees, [x, z])
    for plot in plots if use == "towers" else ():
        reach = np.array([plot.kind.width, plot.kind.depth]) * 0.05 + 2.4
        trees = trees[(np.abs(trees - [plot.x, plot.z]) > reach).any(1)]
    # Trees of courtyards are always seen from afar, so they are simple ones.
    turns, factors = random.uniform(len(trees)), random.uniform(len(trees), *sizes)
    things["far_tree" if use == "rows" else "tree"].add(trees[:, 0], KERB, trees[:, 1], turns, factors)


def _outskirts(grid: Grid, trees: Places, random: RandomStream, detail: int) -> None:
    """Add groves on the level land around the city."""
    groves = (10, 30, 90, 220)[detail]
    low = np.array([grid.x[0], grid.z[0]]) - 25.0
    high = np.array([grid.x[-1], grid.z[-1]]) + 25.0
    for center in low - FLAT + 30.0 + random.uniform(2 * groves).reshape(-1, 2) * (high - low + 2.0 * FLAT - 60.0):
        count = 3 + int(random.integers(1, 12)[0])
        x = center[0] + random.uniform(count, -16.0, 16.0) * (0.4 + random.uniform(count))
        z = center[1] + random.uniform(count, -16.0, 16.0) * (0.4 + random.uniform(count))
        turns, sizes = random.uniform(count), random.uniform(count, 0.8, 1.5)
        outside = (x < low[0]) | (x > high[0]) | (z < low[1]) | (z > high[1])
        off_road = (np.abs(x) > AVENUE + 4.0) & (np.abs(z) > AVENUE + 4.0)
        keep: NDArray[np.bool_] = outside & off_road
        trees.add(x[keep], 0.0, z[keep], turns[keep], sizes[keep])
