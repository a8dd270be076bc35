"""Bounding volumes of tiles: boxes, spheres and regions of the Earth; their subdivision and bounding boxes."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from nearfar._base.errors import UnusableError
from nearfar._scene.entries import coordinates, typed
from nearfar._scene.frames import EQUATOR, Floats, earth_centred

_STEP_COUNT = 8
"""Subdivisions of a region's sides for its bounding box."""

_MAX_CURVATURE_RADIUS = 1.02 * EQUATOR
"""Upper bound of the ellipsoid's radii of curvature at height 0, metres."""


@dataclass(frozen=True)
class Box:
    """An oriented box in the frame of its tile."""

    middle: Floats
    """Centre (3,)."""
    axes: Floats
    """Half edges (3, 3), one per row."""

    @classmethod
    def of_extremes(cls, box: Floats) -> Box:
        """Return the box along the axes with these least and greatest coordinates (2, 3)."""
        return cls(box.mean(axis=0), np.diag(np.ptp(box, axis=0) / 2))

    def bounds(self, to_scene: Floats) -> Floats:
        """Bounding box (2, 3) in the scene's frame; `to_scene` (4, 4) is the transform tile→scene."""
        middle = to_scene[:3, :3] @ self.middle + to_scene[:3, 3]
        half = np.abs(to_scene[:3, :3] @ self.axes.T).sum(axis=1)
        return np.array([middle - half, middle + half])

    def part(self, level: int, cell: tuple[int, ...]) -> Box:
        """Box of a cell after each of the axes in `cell` is divided into 2**level parts."""
        scale, shift = np.ones(3), np.zeros(3)
        scale[: len(cell)] = 0.5**level
        shift[: len(cell)] = (2 * np.array(cell) + 1) * 0.5**level - 1
        return Box(self.middle + shift @ self.axes, self.axes * scale[:, None])


@dataclass(frozen=True)
class Sphere:
    """A sphere in the frame of its tile."""

    middle: Floats
    radius: float

    def bounds(self, to_scene: Floats) -> Floats:
        """Bounding box (2, 3) in the scene's frame; a transform may make the sphere an ellipsoid."""
        middle = to_scene[:3, :3] @ self.middle + to_scene[:3, 3]
        half = self.radius * np.sqrt((to_scene[:3, :3] ** 2).sum(axis=1))
        return np.array([middle - half, middle + half])


@dataclass(frozen=True)
class Region:
    """A part of the Earth between longitudes, latitudes (radians) and heights, always in the Earth's frame."""

    west: float
    south: float
    east: float
    """At least `west`; above π if the region crosses the date line."""
    north: float
    low: float
    high: float

    @cached_property
    def _corners(self) -> tuple[Floats, float]:
        """Earth-centred grid points (N, 3) on the lowest and the highest surface, and the margin beyond them."""
        grid = np.meshgrid(
            np.linspace(self.west, self.east, _STEP_COUNT + 1),
            np.linspace(self.south, self.north, _STEP_COUNT + 1),
            [self.low, self.high],
            indexing="ij",
        )
        steps = ((self.east - self.west) ** 2 + (self.north - self.south) ** 2) / _STEP_COUNT**2
        radius = _MAX_CURVATURE_RADIUS + max(abs(self.low), abs(self.high))
        # Between grid points a surface deviates from its bilinear interpolant by at most 1/8 of its second derivatives.
        return earth_centred(np.stack(grid, axis=-1)).reshape(-1, 3), steps * radius / 8

    def bounds(self, to_scene: Floats) -> Floats:
        """Bounding box (2, 3) in the scene's frame; `to_scene` (4, 4), rigid, is the transform Earth→scene."""
        points, margin = self._corners
        placed = points @ to_scene[:3, :3].T + to_scene[:3, 3]
        return np.array([placed.min(axis=0) - margin, placed.max(axis=0) + margin])

    @property
    def middle(self) -> Floats:
        """Centre (3,) in the Earth's frame."""
        middle = [(self.west + self.east) / 2, (self.south + self.north) / 2, (self.low + self.high) / 2]
        return earth_centred(np.array(middle))

    def part(self, level: int, cell: tuple[int, ...]) -> Region:
        """Region of a cell after longitude, latitude and, given three numbers, height are divided by 2**level."""
        spans = [(self.west, self.east), (self.south, self.north), (self.low, self.high)]
        for axis, number in enumerate(cell):
            start, end = spans[axis]
            width = (end - start) * 0.5**level
            spans[axis] = (start + number * width, start + (number + 1) * width)
        (west, east), (south, north), (low, high) = spans
        return Region(west, south, east, north, low, high)


Volume = Box | Sphere | Region


def read(json_path: str, volume_entry: Any) -> Volume:
    """Read a volume from a document; if several are stated, the most exact one."""
    volume_entry = typed(volume_entry, dict, json_path)
    if "box" in volume_entry:
        rows = coordinates(volume_entry["box"], 12, f"{json_path}.box").reshape(4, 3)
        return Box(rows[0], rows[1:])
    if "region" in volume_entry:
        return _region(f"{json_path}.region", coordinates(volume_entry["region"], 6, f"{json_path}.region").tolist())
    if "sphere" in volume_entry:
        *middle, radius = coordinates(volume_entry["sphere"], 4, f"{json_path}.sphere").tolist()
        if radius < 0:
            raise UnusableError(f"{json_path}.sphere: expected a radius of at least 0, got {radius:g}")
        return Sphere(np.array(middle), radius)
    keys = [*volume_entry.get("extensions", {}), *volume_entry]
    raise UnusableError(f"{json_path}: expected a box, a region or a sphere, got {', '.join(keys[:3]) or 'nothing'}")


def _region(json_path: str, sides: list[float]) -> Region:
    west, south, east, north, low, high = sides
    # Radians rounded to seven digits may slightly exceed the exact limits.
    if not (-6.4 <= west <= 6.4 and -6.4 <= east <= 6.4 and -1.571 <= south <= north <= 1.571 and low <= high):
        raise UnusableError(f"{json_path}: expected west, south, east, north in radians, and two heights, got {sides}")
    return Region(west, south, east if east >= west else east + 2 * np.pi, north, low, high)
