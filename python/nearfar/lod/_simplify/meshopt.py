"""Simplification by meshoptimizer, which keeps a subset of the base's vertices."""

from __future__ import annotations

import functools

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import background
from nearfar.lod._simplify.surface import Surface, box_of, charts_of

_COUNT_TOLERANCE = 1.01
"""Triangle count, as a multiple of the requested one, at or below which nothing more is given up for a level."""

_WEIGHTS = {"normals": 0.1, "colors": 0.1, "uvs": 0.5}
"""Error, in extents of the surface, that is equivalent to a difference of 1 in an attribute. Differences of texture
coordinates are first converted to the distance by which the texture moves over the surface, also in extents."""


class MeshoptSimplifier:
    """meshoptimizer's simplifier: vertices of levels are vertices of the base, with all their attributes."""

    def __init__(self, surface: Surface, places: NDArray[np.uint32]) -> None:
        keys = tuple(surface.attributes)
        rows, faces = charts_of(surface, *keys)
        used, renumbered = np.unique(faces, return_inverse=True)
        self._faces = np.ascontiguousarray(renumbered.reshape(-1, 3), np.uint32)
        self._surface = surface
        self._vertices = rows[used]
        self._material = np.zeros(len(used), np.int32)
        self._material[self._faces] = surface.materials[:, None]
        self._positions = np.ascontiguousarray(surface.positions[self._vertices] + np.float32(0))
        self._weights = self._weigh()
        _, chart_faces = charts_of(surface, *("uvs",) * ("uvs" in keys))
        self._is_seam = self._seams(places, chart_faces)

    def _seams(self, places: NDArray[np.uint32], chart_faces: NDArray[np.uint32]) -> NDArray[np.bool_]:
        """Find the vertices at places where charts or materials meet."""
        corner_places = places[self._surface.faces].ravel().astype(np.int64)
        # Both numbers in one integer: for rows NumPy would compare structured types, which turns Ctrl-C into TypeError.
        pairs = np.unique(corner_places << 32 | chart_faces.ravel())
        meet = np.bincount(pairs >> 32, minlength=len(places)) > 1
        return np.ascontiguousarray(meet[places[self._vertices]])

    def _weigh(self) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        surface, columns, weights = self._surface, [], []
        _, extent = box_of(surface.positions[self._vertices].astype(np.float64))
        for key, values in surface.attributes.items():
            rows = values[self._vertices].astype(np.float32)
            weight = _WEIGHTS[key]
            if key == "colors":
                rows /= np.float32(255)
            elif key == "uvs":
                weight = weight * _stretch(surface) / extent
            columns.append(rows)
            weights += [weight] * rows.shape[1]
        table = np.concatenate(columns, axis=1) if columns else np.zeros((len(self._vertices), 0), np.float32)
        table = np.nan_to_num(table, posinf=0.0, neginf=0.0)
        return np.ascontiguousarray(table, np.float32), np.array(weights, np.float32)

    def level(self, target: int) -> Surface:
        """Simplify the surface to about `target` triangles; if necessary, give up some seams and small parts."""
        if target >= len(self._faces):
            return self._surface
        vertices, remaining = (self._positions, *self._weights, self._is_seam), self._faces
        for sacrifice in ("nothing", "seams", "parts"):
            faces, _ = background.run(functools.partial(_core.collapse, vertices, self._faces, target, sacrifice))
            remaining = min(remaining, faces, key=len)
            if len(faces) <= _COUNT_TOLERANCE * target:
                break
        used, renumbered = np.unique(remaining, return_inverse=True)
        return self._surface.with_vertices(self._vertices[used], renumbered, self._material[remaining[:, 0]])


def _stretch(surface: Surface) -> float:
    """Return the metres of surface per unit of texture coordinates."""
    corners, uvs = surface.positions[surface.faces].astype(np.float64), surface.attributes["uvs"][surface.faces]
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum()
    first_side, second_side = (uvs[:, 1] - uvs[:, 0]).astype(np.float64), (uvs[:, 2] - uvs[:, 0]).astype(np.float64)
    texture_area = np.abs(first_side[:, 0] * second_side[:, 1] - first_side[:, 1] * second_side[:, 0])
    texture_area = texture_area[np.isfinite(texture_area)].sum()
    return float(np.sqrt(area / texture_area)) if texture_area > 0 else 0.0
