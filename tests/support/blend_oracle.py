"""Blending levels by the definition: pixel after pixel, with positions computed in space."""

from __future__ import annotations

import functools
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import random
from nearfar.orthoview._grid import Grid, Place
from tests.support import orthoview_oracle
from tests.support.orthoview_oracle import Axes, Triple

pixel_points = functools.cache(orthoview_oracle.pixel_points)
Key = tuple[int, Place, int]
"""Level, place and number of the direction of a view."""


def luck(level: int, place: Place, direction: int, pixel: int) -> float:
    """A random number from 0 to 1 of a pixel, which depends only on the pixel's position."""
    x, y, z = place
    return float(random.uniform(256 * level + direction, x + 2**21 * y + 2**42 * z, [pixel])[0])


@dataclass
class Blend:
    """Views of a tree, of which those in `partial` are drawn in part."""

    grid: Grid
    directions: Sequence[Triple]
    depths: Mapping[Key, NDArray[Any]]
    """Steps of each pixel of the drawn views (q, q), 0 where empty."""
    partial: set[tuple[int, Place]]
    steps: int
    apparent: Callable[[NDArray[np.float64]], float]
    """Apparent distance of a point."""
    reach: float
    band: float

    def drawn_pixels(self, key: Key) -> NDArray[np.bool_]:
        """Pixels of a view that are drawn (q, q)."""
        depths = self.depths[key]
        found = np.zeros(depths.shape, bool)
        for row, column in np.argwhere(depths):
            pixel = (int(row), int(column))
            found[pixel] = self.is_coarse(key, pixel) and not self.is_covered(key, pixel)
        return found

    @functools.cached_property
    def points(self) -> dict[Key, NDArray[np.float64]]:
        """Surfaces of the views' pixels, in the middle of their steps (q, q, 3)."""
        return {key: self._points(key) for key in self.depths}

    def _points(self, key: Key) -> NDArray[np.float64]:
        level, place, number = key
        direction, side, depths = self.directions[number], self.grid.side(level), self.depths[key]
        front = pixel_points(self.grid.corner(level, place), side, direction, len(depths))
        axes = Axes.from_direction(direction)
        behind = (depths[..., None] - 0.5) * axes.extents[2] * side / self.steps
        points: NDArray[np.float64] = front - behind * axes.toward
        return points

    def is_coarse(self, key: Key, pixel: tuple[int, int]) -> bool:
        level, place, _ = key
        if (level, place) not in self.partial:
            return True
        return self.is_far(key, pixel, self.points[key][pixel])

    def is_far(self, key: Key, pixel: tuple[int, int], point: NDArray[np.float64]) -> bool:
        """Whether a surface that a pixel may show is far enough for it."""
        size = len(next(iter(self.depths.values())))
        own = luck(*key, pixel[0] * size + pixel[1])
        return bool(self.apparent(point) >= 2 ** key[0] * self.reach * (1 + self.band * own))

    def is_covered(self, key: Key, pixel: tuple[int, int]) -> bool:
        """Whether the parent's pixel that contains a pixel is drawn, or covered itself."""
        level, (x, y, z), number = key
        parent = (level + 1, (x // 2, y // 2, z // 2))
        if parent not in self.partial:
            return False
        above, at = (*parent, number), self.pixel_above(key, pixel)
        if above not in self.depths:
            return self.is_far(above, at, self.points[key][pixel])
        return self.is_coarse(above, at) or self.is_covered(above, at)

    def pixel_above(self, key: Key, pixel: tuple[int, int]) -> tuple[int, int]:
        """The parent's pixel whose square contains the centre of a pixel."""
        level, (x, y, z), number = key
        axes, size = Axes.from_direction(self.directions[number]), len(self.depths[key])
        side = self.grid.side(level)
        front = pixel_points(self.grid.corner(level, (x, y, z)), side, self.directions[number], size)
        center = self.grid.corner(level + 1, (x // 2, y // 2, z // 2)) + np.full(3, side)
        offset = front[pixel] - center
        width, height = axes.extents[:2] * 2 * side
        column = (offset @ axes.right / width + 0.5) * size
        row = (0.5 - offset @ axes.up / height) * size
        return int(np.floor(row)), int(np.floor(column))
