"""What stands along the streets and in the parks: trees, lamps, benches, parked and moving cars."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar.datasets import _furniture as furniture
from nearfar.datasets import _vegetation as vegetation
from nearfar.datasets import _vehicles as vehicles
from nearfar.datasets._draw import Draw, Floats
from nearfar.datasets._ground import FLAT
from nearfar.datasets._layout import AVENUE, KERB, Grid
from nearfar.datasets._shapes import Soup
from nearfar.datasets._stage import Stage, placements

_TREES = 9
_PARKED = 14
_CLEAR = 2.2
"""No street furniture stands nearer to the origin than this, metres."""


@dataclass(frozen=True)
class Side:
    """A block's edge along a street: positions count from its left end as seen from the street's far side."""

    block: int
    number: int
    length: float
    start: tuple[float, float]
    quarter: int
    """Quarter turns from +z to the direction that faces the street."""
    half: float
    """Half the width of the carriageway before it."""

    def at(self, along: ArrayLike, inward: ArrayLike) -> tuple[Floats, Floats]:
        """World x and z of places along the kerb and inward from it."""
        t, o = np.asarray(along, np.float64), np.asarray(inward, np.float64)
        x, z = self.start
        along_x, along_z = ((1.0, 0.0), (0.0, -1.0), (-1.0, 0.0), (0.0, 1.0))[self.quarter]
        in_x, in_z = ((0.0, -1.0), (-1.0, 0.0), (0.0, 1.0), (1.0, 0.0))[self.quarter]
        return x + along_x * t + in_x * o, z + along_z * t + in_z * o


def sides(grid: Grid) -> list[Side]:
    """All edges of all blocks."""
    found = []
    for j in range(grid.blocks):
        for i in range(grid.blocks):
            x0, x1, z0, z1 = grid.block(i, j)
            starts = ((x0, z1), (x1, z1), (x1, z0), (x0, z0))
            streets = (j + 1, i + 1, j, i)
            for quarter, (start, street) in enumerate(zip(starts, streets, strict=True)):
                length = x1 - x0 if quarter % 2 == 0 else z1 - z0
                number = j * grid.blocks + i
                found.append(Side(number, quarter, length, start, quarter, grid.half(street)))
    return found


class Places:
    """Gathers where things of one sort stand."""

    def __init__(self) -> None:
        self._rows: list[Floats] = []

    def add(self, x: ArrayLike, y: ArrayLike, z: ArrayLike, turn: ArrayLike, size: ArrayLike = 1.0) -> None:
        """Places with their turns (fractions) and sizes."""
        self._rows.append(
            np.stack(np.broadcast_arrays(*(np.atleast_1d(np.asarray(v, float)) for v in (x, y, z, turn, size))), -1)
        )

    def rows(self, *, clear: float = 0.0) -> Floats:
        """All of them (K, 5), without those nearer than `clear` to the vertical axis."""
        rows = np.concatenate(self._rows) if self._rows else np.zeros((0, 5))
        return rows[rows[:, 0] * rows[:, 0] + rows[:, 2] * rows[:, 2] >= clear * clear]


def spread(stage: Stage, rows: Floats, prototypes: int, make: Callable[[int], Soup], name: str, draw: Draw) -> None:
    """Place things, each one of several prototypes; objects are numbered through all of them."""
    chosen = draw.integers(len(rows), prototypes)
    for variant in range(prototypes):
        mine = np.flatnonzero(chosen == variant)
        if len(mine):
            stage.many(make(variant), placements(*rows[mine].T), [f"{name}_{k}" for k in mine])


def dress(stage: Stage, grid: Grid, seed: int, detail: int) -> None:
    """Everything but buildings, ground and moving cars."""
    trees, lamps, benches, bins, parked, lights, bollards = (Places() for _ in range(7))
    for side in sides(grid):
        draw = Draw(seed, 30, side.block, side.number)
        _street_trees(side, trees, draw, detail)
        _posts(side, lamps, benches, bins, draw)
        _corner(side, lights, bollards)
        _parked(side, parked, draw)
    for j in range(grid.blocks):
        for i in range(grid.blocks):
            _inside(grid, i, j, grid.use(i, j, seed), trees, benches, Draw(seed, 31, i, j), detail)
    _outskirts(grid, trees, Draw(seed, 32), detail)

    def tree(variant: int) -> Soup:
        return vegetation.broadleaf(seed, variant, detail)

    def parked_car(variant: int) -> Soup:
        body = vehicles.BODIES[variant % len(vehicles.BODIES)]
        return vehicles.car(body, vehicles.PAINTS[(variant * 3 + 1) % len(vehicles.PAINTS)], detail)

    spread(stage, trees.rows(clear=_CLEAR + 3.0), _TREES, tree, "tree", Draw(seed, 33))
    if detail < 2:
        return
    spread(stage, parked.rows(clear=_CLEAR + 3.0), _PARKED, parked_car, "parked_car", Draw(seed, 34))
    for places, soup, name in (
        (lamps, furniture.lamp_post(detail), "lamp_post"),
        (benches, furniture.bench(detail), "bench"),
        (bins, furniture.litter_bin(detail), "litter_bin"),
        (lights, furniture.traffic_light(detail), "traffic_light"),
        (bollards, furniture.bollard(detail), "bollard"),
    ):
        stage.many(soup, placements(*places.rows(clear=_CLEAR).T), name)


def _street_trees(side: Side, trees: Places, draw: Draw, detail: int) -> None:
    if side.half < AVENUE and not draw.chance(0.62):
        return
    step = 8.0 if detail >= 3 else 16.0
    along = np.arange(13.0, side.length - 12.0, step)
    keep = draw.uniform(len(along)) < 0.9
    x, z = side.at(along[keep], 1.1)
    trees.add(x, KERB, z, draw.uniform(len(x)), draw.uniform(len(x), 0.72, 1.05))


def _posts(side: Side, lamps: Places, benches: Places, bins: Places, draw: Draw) -> None:
    along = np.arange(9.0, side.length - 6.0, 24.0)
    x, z = side.at(along, 0.6)
    lamps.add(x, KERB, z, 0.25 * side.quarter)
    for places, inward, chance, turn in ((benches, 2.6, 0.35, 0.5), (bins, 0.8, 0.3, 0.0)):
        spots = np.arange(17.0, side.length - 14.0, 18.0)
        keep = draw.uniform(len(spots)) < chance
        x, z = side.at(spots[keep], inward - (1.9 if turn else 0.0))
        places.add(x, KERB, z, 0.25 * side.quarter + turn)


def _corner(side: Side, lights: Places, bollards: Places) -> None:
    """A signal at one end of each side, bollards around both ends."""
    x, z = side.at(0.8, 0.8)
    lights.add(x, KERB, z, 0.25 * side.quarter - 0.25)
    x, z = side.at([6.2, side.length - 6.2], 0.45)
    bollards.add(x, KERB, z, 0.0)


def _parked(side: Side, parked: Places, draw: Draw) -> None:
    along = np.arange(15.0, side.length - 14.0, 6.0)
    keep = draw.uniform(len(along)) < 0.42
    nudge = draw.uniform(len(along), -0.3, 0.3)
    x, z = side.at((along + nudge)[keep], -1.2)
    # Traffic keeps to the right, so the block is on the driver's right hand.
    parked.add(x, 0.0, z, 0.25 * side.quarter + 0.75)


def _inside(grid: Grid, i: int, j: int, use: str, trees: Places, benches: Places, draw: Draw, detail: int) -> None:
    """Trees and benches of a park, a plaza or a courtyard."""
    x0, x1, z0, z1 = grid.block(i, j)
    x, z = 0.5 * (x0 + x1), 0.5 * (z0 + z1)
    if use == "rows":
        count = 5 if detail >= 3 else 3
        trees.add(
            x + draw.uniform(count, -28.0, 28.0), KERB, z + draw.uniform(count, -2.2, 2.2), draw.uniform(count),
            draw.uniform(count, 0.45, 0.7),
        )  # fmt: skip
        return
    if use == "towers":
        spots = np.array([(a, b) for a in (-30.0, -2.5, 2.5, 30.0) for b in (-20.0, 20.0)])
        trees.add(x + spots[:, 0], KERB, z + spots[:, 1], draw.uniform(len(spots)), draw.uniform(len(spots), 0.6, 0.85))
        return
    count = 150 if detail >= 3 else 60
    at_x, at_z = draw.uniform(count, -30.5, 30.5), draw.uniform(count, -20.5, 20.5)
    keep = (np.abs(at_x) > 3.2) & (np.abs(at_z) > 3.2) & (at_x * at_x + at_z * at_z > 100.0)
    trees.add(
        x + at_x[keep], KERB, z + at_z[keep], draw.uniform(int(keep.sum())), draw.uniform(int(keep.sum()), 0.7, 1.25)
    )
    spots = np.arange(-26.0, 27.0, 7.0)
    spots = spots[np.abs(spots) > 9.0]
    benches.add(x + spots, KERB, z - 2.1, 0.0)
    benches.add(x + spots, KERB, z + 2.1, 0.5)


def _outskirts(grid: Grid, trees: Places, draw: Draw, detail: int) -> None:
    """Groves on the level land around the city."""
    groves = (10, 30, 90, 220)[detail]
    low = np.array([grid.x[0], grid.z[0]]) - 25.0
    high = np.array([grid.x[-1], grid.z[-1]]) + 25.0
    for center in low - FLAT + 30.0 + draw.uniform(2 * groves).reshape(-1, 2) * (high - low + 2.0 * FLAT - 60.0):
        count = 3 + int(draw.integers(1, 12)[0])
        x = center[0] + draw.uniform(count, -16.0, 16.0) * (0.4 + draw.uniform(count))
        z = center[1] + draw.uniform(count, -16.0, 16.0) * (0.4 + draw.uniform(count))
        turns, sizes = draw.uniform(count), draw.uniform(count, 0.8, 1.5)
        outside = (x < low[0]) | (x > high[0]) | (z < low[1]) | (z > high[1])
        off_road = (np.abs(x) > AVENUE + 4.0) & (np.abs(z) > AVENUE + 4.0)
        keep: NDArray[np.bool_] = outside & off_road
        trees.add(x[keep], 0.0, z[keep], turns[keep], sizes[keep])


# The moving cars: (runs along z, offset from the middle of the avenue, metres along it, body, paint).
_TRAFFIC = (
    (True, 1.7, -17.0, 0, 3), (True, 4.5, -41.0, 5, 0), (True, -1.7, -28.0, 1, 6), (False, 1.7, 34.0, 2, 4),
    (True, -4.5, -64.0, 0, 1), (False, -1.7, -23.0, 3, 2), (True, 1.7, 26.0, 4, 7), (False, 4.5, -52.0, 1, 5),
)  # fmt: skip


def moving_cars(stage: Stage, grid: Grid, detail: int) -> list[str]:
    """Cars on the two avenues, each an object that can be posed; returns their names."""
    names = []
    for number, (along_z, offset, along, body, paint) in enumerate(_TRAFFIC):
        soup = vehicles.car(vehicles.BODIES[body], vehicles.PAINTS[paint], detail)
        if along_z:
            where = placements(offset, 0.0, along, 0.5 if offset > 0 else 0.0)
        else:
            where = placements(along, 0.0, offset, 0.25 if offset > 0 else 0.75)
        names.append(f"car_{number}")
        stage.many(soup, where, names[-1:], moves=True)
    return names
