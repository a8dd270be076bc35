"""Cells of the octree, cubes of which eight form a cell of the next level; directions of their views."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import SupportsIndex

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import check

Place = tuple[int, int, int]
"""Index of a cell along each axis, from 0."""

MAX_CELLS = 1 << 31
"""Maximum number of leaf cells in a tree's box."""

_ROUNDING = 1e-9
"""Tolerance, in cells, for worlds that end on a side of a cell except for rounding."""

_VISIBLE_MARGIN = 8 * float(np.finfo(np.float32).eps)
"""A cell shows surfaces that lie beyond its sides by at most this share of the greatest coordinate."""

OCTANTS: tuple[Place, ...] = tuple((x, y, z) for x, y, z in itertools.product((0, 1), repeat=3))
"""Places of children in their parent, in build order."""


@dataclass(frozen=True)
class Grid:
    """Cells of a world. Level 0 has the leaves, the last level a single cell."""

    origin: tuple[float, float, float]
    """Least corner of leaf (0, 0, 0), world, metres."""
    cell: float
    """Side of a leaf, metres."""
    counts: Place
    """Number of leaves along each axis."""

    @classmethod
    def from_bounds(cls, bounds: NDArray[np.float64], cell: float) -> Grid:
        """Return the grid over a finite world box.

        Horizontally, cells begin at multiples of their side, so that the cells of several trees coincide. Vertically,
        they begin at the whole metre below the box, so that a flat world at any height has one layer of leaves.
        """
        with np.errstate(over="ignore", invalid="ignore"):  # a side near 0 gives infinitely many cells
            low = np.floor(bounds[0] / cell) * cell
            # Rounding may put the product beyond the world's side.
            low = np.where(low > bounds[0], low - cell, low)
            low[1] = np.floor(bounds[0, 1])
            # A world that ends on a cell's side except for rounding needs no further cell: cells include their sides.
            counts = np.maximum(np.ceil((bounds[1] - low) / cell - _ROUNDING), 1)
            total = counts.prod()
        if not total <= MAX_CELLS:
            raise ValueError(f"cell: expected a side with at most {MAX_CELLS:,} leaves, got {cell:g} m, {total:.3g}")
        x, y, z = low.tolist()
        columns, layers, rows = counts.astype(np.int64).tolist()
        return cls((x, y, z), cell, (columns, layers, rows))

    @classmethod
    def fits(cls, bounds: NDArray[np.float64], cell: float) -> bool:
        """Whether a grid over a world box has at most `MAX_CELLS` leaves."""
        try:
            cls.from_bounds(bounds, cell)
        except ValueError:
            return False
        return True

    @property
    def levels(self) -> int:
        return (max(self.counts) - 1).bit_length() + 1

    @property
    def bounds(self) -> NDArray[np.float64]:
        """World box (2, 3) of all leaves, metres."""
        low = np.array(self.origin)
        return np.array([low, low + np.array(self.counts) * self.cell])

    def counts_at(self, level: int) -> Place:
        """Number of cells of a level along each axis."""
        x, y, z = (-(-count // (1 << level)) for count in self.counts)
        return x, y, z

    def side(self, level: int) -> float:
        """Side of a level's cells, metres."""
        return self.cell * (1 << level)

    def corner(self, level: int, place: Place) -> tuple[float, float, float]:
        """Least corner of a cell, world, metres."""
        x, y, z = (low + number * self.side(level) for low, number in zip(self.origin, place, strict=True))
        return x, y, z

    def box(self, level: int, place: Place) -> NDArray[np.float64]:
        """World box (2, 3) of a cell; neighbours share their sides bit by bit."""
        return np.array([self.corner(level, place), self.corner(level, (place[0] + 1, place[1] + 1, place[2] + 1))])

    def touches(self, level: int, place: Place, aabb: NDArray[np.float64]) -> bool:
        """Whether surfaces in a box may be visible in a cell."""
        box = self.box(level, place)
        reach = _VISIBLE_MARGIN * np.abs(box).max()
        return bool((box[0] - reach <= aabb[1]).all() and (aabb[0] <= box[1] + reach).all())

    def leaves(self, level: int, place: Place) -> int:
        """Number of leaves of the grid in a cell."""
        side = 1 << level
        parts = (min((n + 1) * side, count) - n * side for n, count in zip(place, self.counts, strict=True))
        return math.prod(max(part, 0) for part in parts)

    def children(self, level: int, place: Place) -> Iterator[tuple[Place, Place]]:
        """Octants of a cell's children and their places on the level below, in build order."""
        counts = self.counts_at(level - 1)
        for octant in OCTANTS:
            x, y, z = (2 * number + part for number, part in zip(place, octant, strict=True))
            if x < counts[0] and y < counts[1] and z < counts[2]:
                yield octant, (x, y, z)

    def descendants(
        self, level: int, place: Place, lower: int, is_visited: Callable[[int, Place], bool] = lambda level, place: True
    ) -> Iterator[Place]:
        """Places of a cell's descendants on a lower level, in build order; descends only into visited cells."""
        if level == lower:
            yield place
            return
        for _, child in self.children(level, place):
            if is_visited(level - 1, child):
                yield from self.descendants(level - 1, child, lower, is_visited)


def name_of(place: Place) -> str:
    """Name of a cell within its level."""
    return "_".join(map(str, place))


def place_of(name: str) -> Place:
    """Parse the name of a cell."""
    x, y, z = map(int, name.split("_"))
    return x, y, z


def places_of(rows: NDArray[np.integer]) -> list[Place]:
    """Convert rows (N, 3) to places."""
    return [(x, y, z) for x, y, z in rows.tolist()]


Direction = tuple[int, int, int]
"""Direction from a cell to the viewer: −1, 0 or 1 along each axis."""

_SIDES: list[Direction] = [(0, 0, 1), (1, 0, 0), (0, 0, -1), (-1, 0, 0)]
_TOP: list[Direction] = [(0, 1, 0)]
_EDGES: list[Direction] = [(x, 1, z) for x, _, z in _SIDES]
_CORNERS: list[Direction] = [(1, 1, 1), (1, 1, -1), (-1, 1, -1), (-1, 1, 1)]
_BELOW: list[Direction] = [(0, -1, 0), *((x, -1, z) for x, _, z in (*_SIDES, *_CORNERS))]
_UPRIGHT: list[Direction] = [(x, 0, z) for x, _, z in _CORNERS]

_ALL = [*_SIDES, *_TOP, *_EDGES, *_CORNERS, *_UPRIGHT, *_BELOW]

COUNTS = (5, 9, 13, 26)
"""Sizes of the sets: the four sides and the top; with the upper edges; with the upper corners; all directions."""


def directions_of(count: SupportsIndex) -> tuple[Direction, ...]:
    """Return the directions of a set; ValueError or TypeError if there is no set of that size."""
    number = check.integer("directions", count, 1, len(_ALL))
    if number not in COUNTS:
        raise ValueError(f"directions: expected one of {COUNTS}, got {number}")
    return tuple(_ALL[:number])


def widest(directions: Iterable[Direction]) -> float:
    """Width or height of a cell's widest view, in sides of the cell."""
    return float(max(max(_core.orthoview_axes(direction)[1][:2]) for direction in directions))
