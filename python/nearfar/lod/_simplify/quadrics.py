"""Simplification by fast-simplification's quadrics, which moves vertices, and transfer of attributes to them."""

from __future__ import annotations

import threading
from functools import cached_property
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar.lod._simplify.normals import sorted_edges, unit
from nearfar.lod._simplify.surface import Surface, box_of, charts_of, first_alike

EXTENT = 100.0
"""Longest side of the bounding box passed to fast-simplification, in its units. The package has absolute thresholds: in
a small box the first threshold would collapse everything in list order; in a large box low triangle counts would never
be reached."""

FIN_HEIGHT = 0.5123
"""Height of a fin as a share of its edge; not a round number, so that its apex never coincides with a vertex of a
regular grid."""

_MAX_RUNS = 3
"""Maximum number of runs of the package per level."""

_COUNT_TOLERANCE = 0.005
"""Relative deviation from the requested triangles up to which no further run is made."""

_PACKAGE_LOCK = threading.Lock()
"""Lock for fast-simplification, which uses global variables."""

TOLERANCE = {"uvs": 1 / 2048, "colors": 2.0, "normals": 0.02}
"""Differences up to which corners at one place share a vertex: half a texel of 1024², two 8-bit steps, about 1°."""


class QuadricSimplifier:
    """Simplifies one base with the quadrics of Garland and Heckbert by fast-simplification.

    Vertices are first welded by place, so that seams do not open. Fins keep open borders and seams of charts in place.
    They are triangles on these edges, perpendicular to the surface; their planes are part of the quadrics.
    """

    def __init__(self, surface: Surface, places: NDArray[np.uint32]) -> None:
        self._package = _package()
        self._surface = surface
        faces, self._origin = _distinct(places[surface.faces])
        used, welded = np.unique(faces, return_inverse=True)
        self._faces = welded.reshape(-1, 3).astype(np.int32)
        self._positions = surface.positions[used]
        points = self._positions.astype(np.float64)
        low, extent = box_of(points)
        self._middle, self._scale = low + extent / 2, EXTENT / extent
        self._points = (points - self._middle) * self._scale
        _, seams = charts_of(surface, *("uvs",) * ("uvs" in surface.attributes))
        self._fins = fins(self._points, self._faces, seams[self._origin])

    @cached_property
    def _transfer(self) -> AttributeTransfer:
        return AttributeTransfer(self._surface)

    def level(self, target: int) -> Surface:
        """Simplify the surface to about `target` triangles, with its attributes."""
        if target >= len(self._surface.faces):
            return self._surface
        if target >= len(self._faces):
            # Only duplicates and faces without area are removed.
            return self._transfer.interpolate(self._positions, self._faces.astype(np.uint32), self._origin)
        points, faces = self._points, self._faces
        apexes, feet = self._fins
        apex_numbers = np.arange(len(points), len(points) + len(apexes), dtype=np.int32)
        all_points = np.concatenate([points, apexes])
        all_faces = np.concatenate([faces, np.column_stack([feet, apex_numbers])])
        run_target = target
        for _ in range(_MAX_RUNS):
            new_points, roots = self._run(all_points, all_faces, run_target)
            positions = (new_points / self._scale + self._middle).astype(np.float32)
            # Flat parts collapse onto existing corners: such faces are degenerate.
            collapsed = first_alike(positions)[roots][faces]
            remaining = np.flatnonzero(_is_triangle(collapsed))
            missing = target - len(remaining)
            # The package also counts the remaining fins, whose number is known only after a run.
            if abs(missing) <= _COUNT_TOLERANCE * target or not 0 < run_target + missing < len(all_faces):
                break
            run_target += missing
        used, renumbered = np.unique(collapsed[remaining], return_inverse=True)
        triangles = np.ascontiguousarray(renumbered.reshape(-1, 3), np.uint32)
        return self._transfer.interpolate(positions[used], triangles, self._origin[remaining])

    def _run(
        self, points: NDArray[np.float64], faces: NDArray[np.int32], target: int
    ) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
        """Return the new positions of points, and for each point the number of the point into which it was merged."""
        try:
            with _PACKAGE_LOCK:
                new_points, new_faces, merged = self._package.simplify(
                    points, faces, target_count=target, return_collapses=True
                )
        except MemoryError:
            # The package's own message is "std::bad_alloc".
            reason = f"simplifying {len(faces):,} triangles needs more memory than there is"
            raise MemoryError(f"mesh: {reason}") from None
        roots = np.arange(len(points), dtype=np.int32)
        if len(merged):
            # Each point is merged at most once; pointer doubling finds the final point.
            roots[merged[:, 1]] = merged[:, 0]
            while not np.array_equal(further := roots[roots], roots):
                roots = further
        # Faces that still have three distinct corners remain, in list order.
        expected = roots[faces]
        expected = expected[_is_triangle(expected)]
        moved = points.copy()
        moved[expected] = new_points[new_faces]
        return moved, roots


def _package() -> ModuleType:
    try:
        import fast_simplification
    except ModuleNotFoundError:
        raise ModuleNotFoundError(
            "method 'fast' needs the Python package fast-simplification: pip install fast-simplification",
            name="fast_simplification",
        ) from None
    module: ModuleType = fast_simplification
    return module


def _is_triangle(faces: NDArray[Any]) -> NDArray[np.bool_]:
    a, b, c = faces.T
    return np.asarray((a != b) & (b != c) & (c != a))


def _distinct(faces: NDArray[np.uint32]) -> tuple[NDArray[np.uint32], NDArray[np.int64]]:
    """Return the faces with three distinct corners, without duplicates, and their numbers in the list."""
    rows = np.flatnonzero(_is_triangle(faces))
    corners = np.ascontiguousarray(np.sort(faces[rows], axis=1), np.uint32)
    first = _core.first_alike(corners.view(np.uint8).reshape(len(rows), -1)) if len(rows) else rows
    rows = rows[first == np.arange(len(rows))]
    return faces[rows], rows


def fins(
    points: NDArray[np.float64], faces: NDArray[np.int32], charts: NDArray[np.uint32]
) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
    """Make fins on edges with one face and on edges between charts: return apexes (K, 3) and numbers of feet (K, 2).

    Collapsing an apex costs nothing, so fins disappear early. But their planes, perpendicular to the surface, stay in
    the quadrics of their feet.
    """
    ends, is_reversed, order = sorted_edges(faces)
    sides = np.stack([charts, np.roll(charts, -1, axis=1)], axis=2).reshape(-1, 2)
    sides = np.where(is_reversed[:, None], sides[:, ::-1], sides)[order]
    edges = ends[order]
    starts = np.flatnonzero(np.append(True, (edges[1:] != edges[:-1]).any(axis=1)))
    counts = np.diff(np.append(starts, len(edges)))
    number = np.repeat(np.arange(len(starts)), counts)
    differs = (sides != sides[starts[number]]).any(axis=1)
    has_fin = (counts == 1) | (np.bincount(number, differs, len(starts)) > 0)
    edge = order[starts[has_fin]]
    feet = np.where(is_reversed[edge, None], ends[edge], ends[edge, ::-1])
    corners = points[faces[edge // 3]]
    normal = unit(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]))
    first, second = points[feet[:, 0]], points[feet[:, 1]]
    apexes = (first + second) / 2 + normal * FIN_HEIGHT * np.linalg.norm(second - first, axis=1, keepdims=True)
    has_area = normal.any(axis=1)
    return apexes[has_area], feet[has_area].astype(np.int32)


class AttributeTransfer:
    """Finds the nearest place on the base for each corner of a level, and interpolates the attributes there.

    Each triangle of a level descends from a face of the base. The search for its corners starts from that face and
    never crosses a seam, so a corner stays on its side of the seam, even if both sides belong to one chart.
    """

    def __init__(self, surface: Surface) -> None:
        self._surface = surface
        self._charts = {}
        for key in surface.attributes:
            rows, faces = charts_of(surface, key)
            self._charts[key] = np.ascontiguousarray(surface.positions[rows]), faces

    def interpolate(
        self, positions: NDArray[np.float32], faces: NDArray[np.uint32], source: NDArray[np.int64]
    ) -> Surface:
        """Return a level with attributes, given positions (V, 3), faces (F, 3) and the base's face of each (F,)."""
        base = self._surface
        materials = np.ascontiguousarray(base.materials[source])
        positions, corners = np.ascontiguousarray(positions), faces.ravel()
        if not base.attributes or not len(faces):
            return Surface(positions, faces, materials, {key: value[:0] for key, value in base.attributes.items()})
        values = {key: self._interpolate_corners(key, positions[faces], source) for key in base.attributes}
        scaled = np.concatenate([rows / TOLERANCE[key] for key, rows in values.items()], axis=1)
        shared = group_equal_corners(corners, scaled)
        used, renumbered = np.unique(shared, return_inverse=True)
        return Surface(
            np.ascontiguousarray(positions[corners[used]]),
            np.ascontiguousarray(renumbered.reshape(-1, 3), np.uint32),
            materials,
            {key: _round_attribute(key, rows[used], base.attributes[key].dtype) for key, rows in values.items()},
        )

    def _interpolate_corners(
        self, key: str, corners: NDArray[np.float32], source: NDArray[np.int64]
    ) -> NDArray[np.float64]:
        """Return the attribute of each corner (3 F, …)."""
        positions, faces = self._charts[key]
        begin = np.ascontiguousarray(source, np.uint32)
        face, weights = _core.carry(positions, faces, np.ascontiguousarray(corners), begin)
        rows = self._surface.attributes[key][self._surface.faces[face]].astype(np.float64)
        u, v = weights.T[:, :, None]
        values: NDArray[np.float64] = rows[:, 0] + u * (rows[:, 1] - rows[:, 0]) + v * (rows[:, 2] - rows[:, 0])
        return values


def _round_attribute(key: str, rows: NDArray[np.float64], dtype: np.dtype[Any]) -> NDArray[Any]:
    if key == "normals":
        rows = unit(rows)
    elif key == "colors":
        rows = np.rint(rows)
    return np.ascontiguousarray(rows, dtype)


def group_equal_corners(corners: NDArray[np.uint32], values: NDArray[np.float64]) -> NDArray[np.int64]:
    """Return for each corner the index of the first corner at its vertex whose values differ by at most 1."""
    first = np.full(len(corners), -1)
    remaining = np.arange(len(corners))
    while len(remaining):
        _, leader, group = np.unique(corners[remaining], return_index=True, return_inverse=True)
        leaders = remaining[leader][group]
        # NaN differs from everything, even from itself.
        alike = (np.abs(values[remaining] - values[leaders]) <= 1).all(axis=1) | (leaders == remaining)
        first[remaining[alike]] = leaders[alike]
        remaining = remaining[~alike]
    return first
