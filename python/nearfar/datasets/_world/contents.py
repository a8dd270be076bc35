"""Adds the contents of a query's box: ground and water, plants, towns and roads, at a level of detail."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from nearfar.datasets._buildings import Kind
from nearfar.datasets._draw import Floats
from nearfar.datasets._shapes import Indexed
from nearfar.datasets._stage import placements
from nearfar.datasets._world import (
    forest,
    houses,
    lattice,
    road_shapes,
    roads,
    sites,
    street_shapes,
    street_things,
    streets,
    tiles,
)
from nearfar.datasets._world.parts import Parts

_CROWN = 7.0
"""Greatest horizontal distance of a plant's parts from its stem, metres."""
_NO_ROADS, _NO_STREETS = 25.0, 8.0
"""Errors in metres from which roads, and streets, are left out: roads are up to 23 m above the ground or water."""
_CARS, _HOUSES = (0.4, 0.8), (1.6, 3.6)
"""Greatest distance in metres between the shapes at detail 1, and 0, and the shape at detail 2."""


@dataclass(frozen=True)
class Wanted:
    """A level of the ground, and the error budget in metres for shapes on it."""

    seed: int
    level: int
    budget: float

    def coarse(self, errors: tuple[float, float], size: float = 1.0) -> int:
        """Return the coarsest detail 0 … 2 within the budget; `errors` are for details 1 and 0, at size 1."""
        return 2 - sum(error * size <= self.budget for error in errors)


def box_of(parts: Parts, margin: float) -> tuple[float, float, float, float]:
    """Return the box of a query seen from above, widened by a margin: x0, x1, z0, z1."""
    low, high = parts.low, parts.high
    return low[0] - margin, high[0] + margin, low[2] - margin, high[2] + margin


def spans(parts: Parts, side: float, margin: float = 0.0) -> tuple[range, range]:
    """Columns i and rows j of squares that touch a query's box, seen from above, and lie in the world."""
    x0, x1, z0, z1 = box_of(parts, margin)
    least, most = int(np.floor(-parts.half / side)), int(np.ceil(parts.half / side))
    # A closed box that ends at a square's border touches the square beyond.
    rows = [
        range(max(least, int(np.ceil(a / side)) - 1), min(most, int(np.floor(b / side)) + 1))
        for a, b in ((x0, x1), (z0, z1))
    ]
    return rows[0], rows[1]


def add_ground(parts: Parts, wanted: Wanted) -> None:
    """Add ground and water."""
    columns, rows = spans(parts, tiles.COUNT * lattice.spacing(wanted.level))
    for j in rows:
        for i in columns:
            parts.tile(tiles.tile(wanted.seed, wanted.level, i, j))


def add_plants(parts: Parts, wanted: Wanted) -> None:
    """Add trees, bushes and rocks that are not too small."""
    limits = [low + spread for low, spread in forest.SIZES]
    kept = [k for k, size in enumerate(limits) if forest.REACHES[k] * size > wanted.budget]
    if not kept:
        return
    found: dict[tuple[int, int], list[tuple[Floats, list[str]]]] = {}
    columns, rows = spans(parts, tiles.COUNT * lattice.SPACING, _CROWN)
    for j in rows:
        for i in columns:
            plants = forest.plants(wanted.seed, i, j)
            mine = np.flatnonzero(plants.reach > wanted.budget)
            if not len(mine):
                continue
            feet = np.stack([plants.x, tiles.foot(wanted.seed, wanted.level, plants.x, plants.z), plants.z], -1)
            mine = mine[parts.near(feet[mine], plants.reach[mine])]
            where = _placements(feet[mine], plants.turn[mine], plants.size[mine])
            keys = 16 * plants.kind[mine] + plants.variant[mine]
            for key in np.unique(keys).tolist():
                chosen = np.flatnonzero(keys == key)
                name = f"{forest.NAMES[key // 16]}_{i}_{j}_"
                names = [name + str(number) for number in plants.number[mine[chosen]].tolist()]
                found.setdefault(divmod(key, 16), []).append((where[chosen], names))
    for (kind, variant), placed in sorted(found.items(), key=lambda item: item[0]):
        detail = wanted.coarse(forest.COARSER[kind], limits[kind])
        shape = forest.shape(wanted.seed, kind, variant, detail)
        every = [name for _, names in placed for name in names]
        parts.many((forest.NAMES[kind], variant, detail), shape, np.concatenate([where for where, _ in placed]), every)


def add_towns(parts: Parts, wanted: Wanted) -> None:
    """Add streets and houses, and along the streets cars, lamps and trees."""
    for town in sites.near(wanted.seed, box_of(parts, 0.0), sites.EDGE):
        if wanted.budget < _NO_STREETS:
            parts.once(street_shapes.shape(wanted.seed, town), town.x, town.z, f"streets_{town.name}")
        plan = streets.layout(wanted.seed, town)
        placed: dict[tuple[str, object], list[tuple[int, float, float, float, float]]] = {}
        for number, house in enumerate(plan.houses):
            name = "church" if house.kind.form == houses.CHURCH else "house"
            placed.setdefault((name, house.kind), []).append((number, house.x, house.z, house.turn, 1.0))
        for number, thing in enumerate(street_things.things(wanted.seed, town)):
            row = (number, thing.x, thing.z, thing.turn, thing.size)
            placed.setdefault((thing.kind, thing.variant), []).append(row)
        for (name, variant), rows in placed.items():
            shape, detail = _shape(wanted, name, variant)
            number, x, z, turn, size = np.array(rows).T
            reach = _reach(shape) * size
            feet = np.stack([x, np.full(len(x), town.height), z], -1)
            mine = np.flatnonzero(parts.near(feet, reach) & (reach > wanted.budget))
            where = _placements(feet[mine], turn[mine], size[mine])
            names = [f"{name}_{town.name}_{k}" for k in number[mine].astype(int).tolist()]
            parts.many((name, variant, detail), shape, where, names)


def _shape(wanted: Wanted, name: str, variant: object) -> tuple[Indexed, int]:
    """Shape of a house or of a street object, and its detail."""
    if isinstance(variant, Kind):
        detail = wanted.coarse(_HOUSES)
        return houses.shape(wanted.seed, variant, detail), detail
    assert isinstance(variant, int)
    if name == street_things.TREE:
        detail = wanted.coarse(forest.COARSER[forest.OAK])
        return forest.shape(wanted.seed, forest.OAK, variant, detail), detail
    detail = wanted.coarse(_CARS)
    return street_things.shape(name, variant, detail), detail


def _placements(feet: Floats, turn: Floats, size: Floats) -> Floats:
    return placements(feet[:, 0], feet[:, 1], feet[:, 2], turn, size)


def _reach(shape: Indexed) -> float:
    """Greatest distance of a shape from its foot, metres."""
    points = shape.positions.astype(np.float64)
    return float(np.sqrt((points * points).sum(1).max()))


def add_roads(parts: Parts, wanted: Wanted) -> None:
    """Add roads; above coarse ground they are raised by a quarter of its error, so that less of them is buried."""
    if wanted.budget < _NO_ROADS:
        lift = 0.25 * lattice.error(wanted.level)
        for road in roads.near(wanted.seed, box_of(parts, roads.HALF + 1.0), 0.0):
            shape, x, z = road_shapes.shape(road, lift)
            parts.once(shape, x, z, f"road_{road.name}")
