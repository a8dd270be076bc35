"""`nearfar.datasets.world`: a landscape that is generated where it is queried."""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass
from typing import SupportsFloat

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar._scene.scene import Scene
from nearfar.datasets._buildings import Kind
from nearfar.datasets._random import Floats, length, xyz
from nearfar.datasets._shapes import Indexed
from nearfar.datasets._stage import placements
from nearfar.datasets._world import forest, houses, lattice, road_shapes, roads, sites, streets, tiles
from nearfar.datasets._world.parts import Parts
from nearfar.datasets._world.relief import SEA_BED, SUMMIT

_MAX_TILES = 8_192
_MAX_KM = 10_000
_SEEDS = 2**63
_MARGIN = 100.0
"""Greatest height of objects above the ground, and greatest one of the ground above the natural relief, metres."""

_CROWN = 7.0
"""Greatest horizontal distance of a plant's parts from its stem, metres."""
_NO_ROADS, _NO_STREETS = 25.0, 8.0
"""Errors of the ground, metres, from which roads and streets are left out: roads are up to 23 m above the ground."""
_CARS, _HOUSES = (0.4, 0.8), (1.6, 3.6)
"""Greatest distances, metres, of the shapes at detail 1 and at detail 0 from the shape at detail 2."""


class World:
    """A landscape of towns, roads, fields, forests, mountains and sea; `query` makes parts of it.

    A part depends only on the seed and the place. The last tiles are cached. Create it with `world`.
    """

    def __init__(self, km: int = 10, seed: int = 0) -> None:
        self._km = check.integer("km", km, 1, _MAX_KM)
        self._seed = check.integer("seed", seed, 0, _SEEDS - 1)

    def __repr__(self) -> str:
        return f"nearfar.datasets.world(km={self._km}, seed={self._seed})"

    @property
    def bounds(self) -> NDArray[np.float64]:
        """Least and greatest corner (2, 3), metres, y up: a box that contains the world, not the smallest one."""
        half = 500.0 * self._km
        return np.array([[-half, SEA_BED - _MARGIN, -half], [half, SUMMIT + _MARGIN, half]])

    def query(self, aabb: ArrayLike, detail: SupportsFloat = 0.0) -> Scene:
        """Make the part of the world that touches a box; arguments and errors are those of `nearfar.SceneSource.query`.

        Half of `detail` is the error of the ground: a grid of 3.9 m times a power of two. The other half is that of the
        objects on it: simpler shapes, and objects smaller than that are left out. ValueError for a box with more than
        8,192 tiles of 64 × 64 cells at this `detail`.

        Plants, houses, cars and lamps are instances. Objects are called "land_0_3_-2" and "water_0_3_-2" (level, column
        and row of a tile), "oak_3_-2_17" and so on, "house_0_0_12" (column and row of a town), "streets_0_0",
        "road_0_0_to_1_0".
        """
        corners = check.box("aabb", aabb)
        detail = check.at_least_zero("detail", detail)
        low, high = np.maximum(corners[0], self.bounds[0]), np.minimum(corners[1], self.bounds[1])
        parts = Parts(low, high, self.bounds[1][0])
        if (low > high).any():
            return parts.scene()
        accuracy = _Accuracy(self._seed, self._level(detail), 0.5 * detail)
        columns, rows = _spans(parts, tiles.COUNT * lattice.spacing(accuracy.level))
        if (count := len(columns) * len(rows)) > _MAX_TILES:
            raise ValueError(
                f"aabb: expected at most {_MAX_TILES:,} tiles of the world at detail {detail:g}, "
                f"got {count:,}; take a smaller box or a larger detail"
            )
        for add in (_add_ground, _add_plants, _add_towns, _add_roads):
            add(parts, accuracy)
        return parts.scene().query(corners)

    def _level(self, detail: float) -> int:
        """Coarsest level of the ground within an error in metres whose grid ends at the world's border."""
        # A grid of 500 m fits every world, a grid of 1 km fits worlds of an even number of kilometres, and so on.
        coarsest = min(lattice.TOP, 7 + (self._km & -self._km).bit_length() - 1)
        return max(level for level in range(coarsest + 1) if level == 0 or lattice.error(level) <= 0.5 * detail)


def world(km: int = 10, seed: int = 0) -> World:
    """Make an Earth-like landscape of any size, as a source that is queried box by box.

    Continents, mountains, valleys with rivers, coasts; forests by climate, slope and water; a town in most squares of
    3 km, with fields around it and roads to its neighbours. A town lies at the origin. Water is at y = 0. Parts are
    generated on demand, and are the same in every query. Returns a source with `bounds` and `query(aabb, detail)`.
    ValueError for numbers out of range.

    Parameters
    ----------
    km
        Side of the square in kilometres, 1 to 10,000; its middle is the origin. Smaller worlds are the middles of
        larger ones.
    seed
        0 to 2⁶³ − 1.
    """
    return World(km, seed)


@dataclass(frozen=True)
class _Accuracy:
    """A level of the ground, and the error budget in metres for shapes on it, in the world of a seed."""

    seed: int
    level: int
    budget: float

    def coarsest_detail(self, errors: tuple[float, float], size: float = 1.0) -> int:
        """Return the coarsest detail 0 … 2 within the budget; `errors` are for details 1 and 0, at size 1."""
        return 2 - sum(error * size <= self.budget for error in errors)


def _box_of(parts: Parts, margin: float) -> tuple[float, float, float, float]:
    """Return the box of a query seen from above, widened by a margin: x0, x1, z0, z1."""
    low, high = parts.low, parts.high
    return low[0] - margin, high[0] + margin, low[2] - margin, high[2] + margin


def _spans(parts: Parts, side: float, margin: float = 0.0) -> tuple[range, range]:
    """Columns i and rows j of squares that touch a query's box, seen from above, and lie in the world."""
    x0, x1, z0, z1 = _box_of(parts, margin)
    end = math.ceil(parts.half / side)
    # A closed box that ends at a square's border touches the square beyond.
    columns, rows = (
        range(max(-end, math.ceil(low / side) - 1), min(end, math.floor(high / side) + 1))
        for low, high in ((x0, x1), (z0, z1))
    )
    return columns, rows


def _add_ground(parts: Parts, accuracy: _Accuracy) -> None:
    """Add ground and water."""
    columns, rows = _spans(parts, tiles.COUNT * lattice.spacing(accuracy.level))
    for j, i in itertools.product(rows, columns):
        parts.tile(tiles.tile(accuracy.seed, accuracy.level, i, j))


def _add_plants(parts: Parts, accuracy: _Accuracy) -> None:
    """Add trees, bushes and rocks that are not too small."""
    greatest_sizes = [low + spread for low, spread in forest.SIZES]
    if all(reach * size <= accuracy.budget for reach, size in zip(forest.REACHES, greatest_sizes, strict=True)):
        return
    by_shape: dict[tuple[int, int], list[tuple[Floats, list[str]]]] = {}
    columns, rows = _spans(parts, tiles.COUNT * lattice.SPACING, _CROWN)
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


def _add_towns(parts: Parts, accuracy: _Accuracy) -> None:
    """Add streets and houses, and along the streets cars, lamps and trees."""
    for town in sites.near(accuracy.seed, _box_of(parts, 0.0), sites.EDGE):
        if accuracy.budget < _NO_STREETS:
            parts.once(road_shapes.street_shape(accuracy.seed, town), town.x, town.z, f"streets_{town.name}")
        placed: dict[tuple[str, int | Kind], list[tuple[int, float, float, float, float]]] = {}
        for things in (streets.layout(accuracy.seed, town).houses, streets.street_things(accuracy.seed, town)):
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


def _shape(accuracy: _Accuracy, name: str, variant: int | Kind) -> tuple[Indexed, int]:
    """Shape of a house or of a street object, and its detail."""
    if isinstance(variant, Kind):
        detail = accuracy.coarsest_detail(_HOUSES)
        return houses.shape(accuracy.seed, variant, detail), detail
    if name == streets.TREE:
        detail = accuracy.coarsest_detail(forest.COARSER[forest.OAK])
        return forest.shape(accuracy.seed, forest.OAK, variant, detail), detail
    detail = accuracy.coarsest_detail(_CARS)
    return streets.thing_shape(name, variant, detail), detail


def _add_roads(parts: Parts, accuracy: _Accuracy) -> None:
    """Add roads; on coarse ground they are raised by a quarter of its error, so that less of them is buried."""
    if accuracy.budget < _NO_ROADS:
        lift = 0.25 * lattice.error(accuracy.level)
        for road in roads.near(accuracy.seed, _box_of(parts, roads.HALF + 1.0), 0.0):
            shape, x, z = road_shapes.road_shape(road, lift)
            parts.once(shape, x, z, f"road_{road.name}")
