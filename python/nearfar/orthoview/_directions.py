"""Canonical view directions of cells."""

from __future__ import annotations

from collections.abc import Iterable
from typing import SupportsIndex

from nearfar import _core
from nearfar._base import check

Direction = tuple[int, int, int]
"""Side of a cell that the viewer is on: −1, 0 or 1 along each axis."""

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
