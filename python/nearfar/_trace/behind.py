"""Detects rays that hit surfaces from behind, as they do inside solids."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nearfar._scene.scene import Scene


def is_hit_from_behind(
    scene: Scene, triangles: NDArray[np.int64], directions: NDArray[np.float64]
) -> NDArray[np.bool_]:
    """Return whether rays with directions (N, 3) hit the back of their triangle, (…, N) numbers, −1 for none."""
    is_hit = triangles >= 0
    hit_triangles = np.unique(triangles[is_hit])
    if not len(hit_triangles):
        return np.zeros(triangles.shape, bool)
    mask = np.zeros(scene.triangle_count, bool)
    mask[hit_triangles] = True
    corners = scene._core.subset_of_triangles(mask).triangles().astype(np.float64)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    hit_normals = normals[np.searchsorted(hit_triangles, np.where(is_hit, triangles, hit_triangles[0]))]
    return np.asarray(((hit_normals * directions).sum(axis=-1) > 0.0) & is_hit)
