"""Collects the surfaces of a city model, triangulates all of them at once, and makes a shape for each owner."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base.errors import UnusableError
from nearfar._scene.city.outlines import offsets, select_runs
from nearfar._scene.content import Shape
from nearfar._scene.entries import flattened
from nearfar._scene.materials import BaseColor

CROSSING = "with rings that cross drawn with gaps or overlaps"
"""Complement of a note on polygons whose rings cross themselves or each other, overlap, or leave the outer ring."""

_THIN = 1e-12
"""Area, relative to the squared extent, below which a polygon counts as a line; float64 has 16 digits."""


@dataclass(frozen=True)
class Part:
    """Owner of a geometry's surfaces, and its place in the document for messages."""

    owner: str
    json_path: str


class Collector:
    """Collects surfaces whose corners are vertex indices.

    Call `add_vertices`, then `add_surfaces` for each geometry that refers to these vertices.
    """

    def __init__(self) -> None:
        self._vertices: list[NDArray[np.float64]] = [np.zeros((0, 3))]
        self._base = self._count = 0
        self._parts: list[Part] = []
        self._part_surfaces: list[int] = []
        self._indices: list[NDArray[np.int64]] = []
        self._ring_sizes: list[int] = []
        self._surface_rings: list[int] = []
        self._colors: list[BaseColor] = []

    def add_vertices(self, rows: NDArray[np.float64]) -> None:
        """Add vertices (V, 3) for the geometries that follow."""
        self._base += self._count
        self._count = len(rows)
        self._vertices.append(rows)

    def add_surfaces(self, part: Part, surfaces: list[Any], colors: list[BaseColor]) -> None:
        """Add surfaces, lists of rings of vertex indices, each with a colour; UnusableError for anything else."""
        rings = flattened(surfaces, 1, part.json_path)
        corners = flattened(rings, 1, part.json_path)
        if wrong_types := sorted(kind.__name__ for kind in set(map(type, corners)) - {int}):
            raise UnusableError(f"{part.json_path}: expected numbers of vertices, got {wrong_types[0]} among them")
        if corners and not (min(corners) >= 0 and max(corners) < self._count):
            unknown = next(corner for corner in corners if not 0 <= corner < self._count)
            raise UnusableError(f"{part.json_path}: it refers to vertex {unknown} of {self._count}")
        self._indices.append(np.array(corners, np.int64) + self._base)
        self._ring_sizes += map(len, rings)
        self._surface_rings += map(len, surfaces)
        self._parts.append(part)
        self._part_surfaces.append(len(surfaces))
        self._colors += colors

    def shapes(self, *, drop: bool) -> tuple[dict[str, tuple[Shape, NDArray[np.float64]]], Counter[str]]:
        """Make each owner's shape relative to a point (3,) in whole metres; also count surfaces drawn wrongly or not.

        Shapes are rotated from z up to y up. Surfaces with rings of fewer than three corners are left out with `drop`,
        else an UnusableError names the first one. The keys of the counts are complements of notes.
        """
        surfaces, numbers, unusable_count = self._usable_surfaces(drop)
        faces, face_offsets, crossing_count = surfaces.triangles()
        colors = {id(color): color for color in self._colors}
        color_numbers = {key: number for number, key in enumerate(colors)}
        color = np.array([color_numbers[id(self._colors[row])] for row in numbers.tolist()], np.int32)
        part_of = np.arange(len(self._parts)).repeat(self._part_surfaces)[numbers]
        starts = np.searchsorted(part_of, np.arange(len(self._parts) + 1))
        rows: dict[str, list[NDArray[np.int64]]] = {}
        for part, start, end in zip(self._parts, starts[:-1], starts[1:], strict=True):
            rows.setdefault(part.owner, []).append(np.arange(start, end))
        shapes = {
            owner: _shape(surfaces, faces, face_offsets, np.concatenate(ranges), color, list(colors.values()))
            for owner, ranges in rows.items()
        }
        return shapes, Counter(
            {"with rings of fewer than three corners left out": unusable_count, CROSSING: crossing_count}
        )

    def _usable_surfaces(self, drop: bool) -> tuple[Surfaces, NDArray[np.int64], int]:
        """Return the usable surfaces, their numbers, and the count of unusable ones."""
        ring_sizes = np.array(self._ring_sizes, np.int64)
        surface_rings = np.array(self._surface_rings, np.int64)
        is_usable = surface_rings > 0
        owner = np.arange(len(surface_rings)).repeat(surface_rings)
        is_usable[owner[ring_sizes < 3]] = False
        if not drop and not is_usable.all():
            self._raise_for(int(np.argmin(is_usable)), surface_rings, ring_sizes)
        numbers = np.flatnonzero(is_usable)
        rings, surface_offsets = select_runs(offsets(surface_rings), numbers)
        corners, ring_offsets = select_runs(offsets(ring_sizes), rings)
        indices = np.concatenate([np.zeros(0, np.int64), *self._indices])[corners]
        surfaces = Surfaces(np.concatenate(self._vertices)[indices], ring_offsets, surface_offsets)
        return surfaces, numbers, len(is_usable) - len(numbers)

    def _raise_for(self, surface: int, surface_rings: NDArray[np.int64], ring_sizes: NDArray[np.int64]) -> None:
        ends = np.cumsum(self._part_surfaces)
        part = int(np.searchsorted(ends, surface, side="right"))
        number = surface - (int(ends[part - 1]) if part else 0)
        sizes = ring_sizes[offsets(surface_rings)[surface] :][: surface_rings[surface]]
        flaw = f"a ring of {sizes.min()} corners" if len(sizes) else "no rings"
        raise UnusableError(
            f"{self._parts[part].json_path}: surface {number} has {flaw}; on_invalid='drop' leaves such surfaces out"
        )


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
        """Corners relative to the first corner of their polygon."""
        first = self.rings[self.surfaces]
        return self.corners - self.corners[first[:-1]].repeat(np.diff(first), axis=0)

    def triangles(self) -> tuple[NDArray[np.uint32], NDArray[np.int64], int]:
        """Return triangles (F, 3) of corner numbers, oriented like the outer rings, and offsets (S + 1,) of polygons.

        Also returns the number of polygons whose rings cross, including bow ties, whose halves cancel. Polygons without
        area have no faces. Corners are projected onto the plane of the outer ring's Newell normal.
        """
        if not len(self.corners):
            return np.zeros((0, 3), np.uint32), np.zeros(len(self.surfaces), np.int64), 0
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
        faces, offsets, crossing_count = _core.triangulate_polygons(
            np.stack(planar, axis=-1), self.rings, self.surfaces
        )
        outer_rings = zip(first[:-1][~has_area], extent[~has_area], strict=True)
        bows = (_has_corners_off_a_line(local[start : self._end_of_ring(start)], size) for start, size in outer_rings)
        return faces, offsets, crossing_count + sum(bows)

    def _end_of_ring(self, start: int) -> int:
        return int(self.rings[np.searchsorted(self.rings, start, side="right")])


def _has_corners_off_a_line(corners: NDArray[np.float64], extent: float) -> bool:
    """Return whether corners (C, 3) relative to the first one span an area, whatever its sign."""
    return bool((np.abs(np.cross(corners[:-1], corners[1:])) > _THIN * extent**2).any())


def _shape(
    surfaces: Surfaces,
    faces: NDArray[np.uint32],
    face_offsets: NDArray[np.int64],
    numbers: NDArray[np.int64],
    color: NDArray[np.int32],
    palette: list[BaseColor],
) -> tuple[Shape, NDArray[np.float64]]:
    """Make a shape of the surfaces with these numbers, with the materials that it uses, relative to a point (3,)."""
    first = surfaces.rings[surfaces.surfaces]
    corner_rows, starts = select_runs(first, numbers)
    corners = surfaces.corners[corner_rows]
    counts = np.diff(face_offsets)[numbers]
    triangles = faces[select_runs(face_offsets, numbers)[0]].astype(np.int64)
    # Indices shrink by the number of omitted corners before their surface.
    triangles -= (first[numbers] - starts[:-1]).repeat(counts)[:, None]
    base = np.rint(corners.min(axis=0) / 2 + corners.max(axis=0) / 2) if len(corners) else np.zeros(3)
    used, face_material = np.unique(color[numbers].repeat(counts), return_inverse=True)
    shape = Shape(
        z_up_to_y_up(corners - base),
        triangles,
        materials=[palette[number] for number in used.tolist()],
        face_material=face_material.astype(np.int32) if len(used) > 1 else None,
    )
    return shape, z_up_to_y_up(base)


def z_up_to_y_up(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Turn points (…, 3) from x east, y north, z up to x east, y up, z south."""
    return np.stack([points[..., 0], points[..., 2], -points[..., 1]], axis=-1)
