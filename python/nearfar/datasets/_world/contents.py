"""Adds the contents of a query's box: ground and water, plants, towns and roads, at a level of detail."""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass

import numpy as np

from nearfar.datasets._buildings import Kind
from nearfar.datasets._draw import Floats, length, xyz
from nearfar.datasets._shapes import Indexed
from nearfar.datasets._stage import placements
from nearfar.datasets._world import forest, houses, lattice, road_shapes, roads, sites, street_things, streets, tiles
from nearfar.datasets._world.parts import Parts

_CROWN = 7.0
"""Greatest horizontal distance of a plant's parts from its stem, metres."""
_NO_ROADS, _NO_STREETS = 25.0, 8.0
"""Errors in metres from which roads, and streets, are left out: roads are up to 23 m above the ground or water."""
_CARS, _HOUSES = (0.4, 0.8), (1.6, 3.6)
"""Greatest distance in metres between the shapes at detail 1, and 0, and the shape at detail 2."""


@dataclass(frozen=True)
class Accuracy:
    """A level of the ground, and the error budget in metres for shapes on it, in the world of a seed."""

    seed: int
    level: int
    budget: float

    def coarsest_detail(self, errors: tuple[float, float], size: float = 1.0) -> int:
        """Return the coarsest detail 0 … 2 within the budget; `errors` are for details 1 and 0, at size 1."""
        return 2 - sum(error * size <= self.budget for error in errors)


def box_of(parts: Parts, margin: float) -> tuple[float, float, float, float]:
    """Return the box of a query seen from above, widened by a margin: x0, x1, z0, z1."""
    low, high = parts.low, parts.high
    return low[0] - margin, high[0] + margin, low[2] - margin, high[2] + margin


def spans(parts: Parts, side: float, margin: float = 0.0) -> tuple[range, range]:
    """Columns i and rows j of squares that touch a query's box, seen from above, and lie in the world."""
    x0, x1, z0, z1 = box_of(parts, margin)
    end = math.ceil(parts.half / side)
    # A closed box that ends at a square's border touches the square beyond.
    columns, rows = (
        range(max(-end, math.ceil(low / side) - 1), min(end, math.floor(high / side) + 1))
        for low, high in ((x0, x1), (z0, z1))
    )
    return columns, rows


def add_ground(parts: Parts, accuracy: Accuracy) -> None:
    """Add ground and water."""
    columns, rows = spans(parts, tiles.COUNT * lattice.spacing(accuracy.level))
    for j, i in itertools.product(rows, columns):
        parts.tile(tiles.tile(accuracy.seed, accuracy.level, i, j))


def add_plants(parts: Parts, accuracy: Accuracy) -> None:
    """Add trees, bushes and rocks that are not too small."""
    greatest_sizes = [low + spread for low, spread in forest.SIZES]
    if all(reach * size <= accuracy.budget for reach, size in zip(forest.REACHES, greatest_sizes, strict=True)):
        return
    by_shape: dict[tuple[int, int], list[tuple[Floats, list[str]]]] = {}
    columns, rows = spans(parts, tiles.COUNT * lattice.SPACING, _CROWN)
    for j, i in itertools.product(rows, columns):
        plants = forest.plants(accuracy.seed, i, j)
        near = np.flatnonzero(plants.reach > accuracy.budget)
        if not len(near):
            continue
        feet = xyz(plants.x, tiles.foot(accuracy.seed, accuracy.level, plants.x, plants.z), plants.z)
        near = near[parts.near(feet[near], plants.reach[near])]
        x, y, z = feet[near].T
        transforms = placements(x, y, z, plants.turn[near], plants.size[near])
        keys = 16 * plants.kind[near] + plants.variant[near]
        for key in np.unique(keys).tolist():
            of_shape = np.flatnonzero(keys == key)
            kind, variant = divmod(key, 16)
            names = [f"{forest.NAMES[kind]}_{i}_{j}_{number}" for number in plants.number[near[of_shape]].tolist()]
            by_shape.setdefault((kind, variant), []).append((transforms[of_shape], names))
    for (kind, variant), placed in sorted(by_shape.items(), key=lambda item: item[0]):
        detail = accuracy.coarsest_detail(forest.COARSER[kind], greatest_sizes[kind])
        shape = forest.shape(accuracy.seed, kind, variant, detail)
        names = [name for _, part in placed for name in part]
        parts.many((forest.NAMES[kind], variant, detail), shape, np.concatenate([part for part, _ in placed]), names)


def add_towns(parts: Parts, accuracy: Accuracy) -> None:
    """Add streets and houses, and along the streets cars, lamps and trees."""
    for town in sites.near(accuracy.seed, box_of(parts, 0.0), sites.EDGE):
        if accuracy.budget < _NO_STREETS:
            parts.once(road_shapes.street_shape(accuracy.seed, town), town.x, town.z, f"streets_{town.name}")
        placed: dict[tuple[str, int | Kind], list[tuple[int, float, float, float, float]]] = {}
        for things in (streets.layout(accuracy.seed, town).houses, street_things.things(accuracy.seed, town)):
            for number, thing in enumerate(things):
                row = (number, thing.x, thing.z, thing.turn, thing.size)
                placed.setdefault((thing.name, thing.variant), []).append(row)
        for (name, variant), rows in placed.items():
            shape, detail = _shape(accuracy, name, variant)
            number, x, z, turn, size = np.array(rows).T
            reach = float(length(shape.positions.astype(np.float64)).max()) * size
            near = np.flatnonzero(parts.near(xyz(x, town.height, z), reach) & (reach > accuracy.budget))
            names = [f"{name}_{town.name}_{k}" for k in number[near].astype(int).tolist()]
            transforms = placements(x[near], town.height, z[near], turn[near], size[near])
            parts.many((name, variant, detail), shape, transforms, names)


def _shape(accuracy: Accuracy, name: str, variant: int | Kind) -> tuple[Indexed, int]:
    """Shape of a house or of a street object, and its detail."""
    if isinstance(variant, Kind):
        detail = accuracy.coarsest_detail(_HOUSES)
        return houses.shape(accuracy.seed, variant, detail), detail
    if name == street_things.TREE:
        detail = accuracy.coarsest_detail(forest.COARSER[forest.OAK])
        return forest.shape(accuracy.seed, forest.OAK, variant, detail), detail
    detail = accuracy.coarsest_detail(_CARS)
    return street_things.shape(name, variant, detail), detail


def add_roads(parts: Parts, accuracy: Accuracy) -> None:
    """Add roads; above coarse ground they are raised by a quarter of its error, so that less of them is buried."""
    if accuracy.budget < _NO_ROADS:
        lift = 0.25 * lattice.error(accuracy.level)
        for road in roads.near(accuracy.seed, box_of(parts, roads.HALF + 1.0), 0.0):
            shape, x, z = road_shapes.road_shape(road, lift)
            parts.once(shape, x, z, f"road_{road.name}")
