"""Planar polygons with holes in space: normals by Newell's method, triangulation in their own plane."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nearfar import _core

_THIN = 1e-12
"""Area relative to the squared extent below which a polygon counts as a line: float64 has 16 digits."""


@dataclass(frozen=True)
class Surfaces:
    """Polygons in flat arrays; each has at least one ring: the outer one first, then its holes."""

    corners: NDArray[np.float64]
    """Corners (C, 3), metres; polygons do not share corners."""
    rings: NDArray[np.int64]
    """Offsets (R + 1,) into the corners, without empty rings."""
    surfaces: NDArray[np.int64]
    """Offsets (S + 1,) into the rings, without empty surfaces."""

    def area_vectors(self) -> NDArray[np.float64]:
        """Newell's normals (R, 3) of the rings, with the area as length."""
        if not len(self.corners):
            return np.zeros((len(self.rings) - 1, 3))
        corners = self.local()
        next_numbers = np.arange(1, len(corners) + 1)
        next_numbers[self.rings[1:] - 1] = self.rings[:-1]
        return np.add.reduceat(np.cross(corners, corners[next_numbers]), self.rings[:-1]) / 2

    def local(self) -> NDArray[np.float64]:
        """Corners relative to the first one of their polygon."""
        first = self.rings[self.surfaces]
        return self.corners - self.corners[first[:-1]].repeat(np.diff(first), axis=0)

    def triangles(self) -> tuple[NDArray[np.uint32], NDArray[np.int64]]:
        """Triangulate: faces (F, 3) of corner numbers, oriented like the outer rings, and offsets (S + 1,) of polygons.

        Polygons without area have no faces. Corners are projected onto the plane of the outer ring's Newell normal.
        """
        if not len(self.corners):
            return np.zeros((0, 3), np.uint32), np.zeros(len(self.surfaces), np.int64)
        normals = self.area_vectors()[self.surfaces[:-1]]
        local, first = self.local(), self.rings[self.surfaces]
        area = np.linalg.norm(normals, axis=1)
        extent = np.maximum.reduceat(np.abs(local).max(axis=1), first[:-1])
        has_area = area > _THIN * extent**2
        unit = np.divide(normals, area[:, None], out=np.zeros_like(normals), where=has_area[:, None])
        axis_u = np.cross(np.eye(3)[np.abs(unit).argmin(axis=1)], unit)
        axis_u /= np.maximum(np.linalg.norm(axis_u, axis=1, keepdims=True), 0.5)
        counts = np.diff(first)
        planar = [
            np.einsum("ij,ij->i", local, axis.repeat(counts, axis=0)) for axis in (axis_u, np.cross(unit, axis_u))
        ]
        return _core.triangulate_polygons(np.stack(planar, axis=-1), self.rings, self.surfaces)


def offsets(counts: NDArray[np.int64] | list[int]) -> NDArray[np.int64]:
    """Offsets (N + 1,) of runs with these lengths."""
    ends = np.zeros(len(counts) + 1, np.int64)
    np.cumsum(counts, out=ends[1:])
    return ends


def rows_of(starts: NDArray[np.int64], lengths: NDArray[np.int64]) -> NDArray[np.int64]:
    """Row numbers of runs, concatenated."""
    ends = np.cumsum(lengths)
    total = int(ends[-1]) if len(ends) else 0
    return np.arange(total) + (starts - ends + lengths).repeat(lengths)
