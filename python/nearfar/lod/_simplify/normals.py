"""Smooth normals for meshes without normals; hard edges stay hard."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core

CREASE_COSINE = np.cos(np.radians(60.0))
"""Cosine of the angle between two faces' normals below which their common edge is hard."""


def smoothed(
    positions: NDArray[np.float32], faces: NDArray[np.uint32], places: NDArray[np.uint32]
) -> tuple[NDArray[np.int64], NDArray[np.float32]]:
    """Normals of the corners of faces (F, 3), averaged over smooth edges with the corners' angles as weights.

    `places` has for each vertex (V,) the first one at its place. Returns the faces as rows (F, 3) of the normals, and
    the normals (N, 3): corners with one row share vertex and normal.
    """
    corners = positions[faces].astype(np.float64)
    sides = np.roll(corners, -1, axis=1) - corners
    units = unit(sides)
    normal = unit(np.cross(sides[:, 0], -sides[:, 2]))
    angles = np.arccos(np.clip(-(units * np.roll(units, 1, axis=1)).sum(axis=2), -1, 1))
    group = _smooth_groups(places[faces], normal)
    weighted = (angles[:, :, None] * normal[:, None]).reshape(-1, 3)
    sums = np.column_stack([np.bincount(group, column, len(group)) for column in weighted.T])
    # Faces without area have no normal: zero.
    of_corner = unit(sums[group])
    key = np.column_stack([faces.ravel(), group.astype(np.uint32)])
    row = _core.first_alike(np.ascontiguousarray(key.astype(np.uint32)).view(np.uint8).reshape(len(key), -1))
    return row.reshape(-1, 3).astype(np.int64), of_corner.astype(np.float32)


def _smooth_groups(faces: NDArray[np.uint32], normal: NDArray[np.float64]) -> NDArray[np.uint32]:
    """Group number of each corner (3 F,); corners at one place are joined over smooth edges."""
    count = len(faces)
    corner = np.arange(3 * count, dtype=np.uint32).reshape(-1, 3)
    after = np.roll(corner, -1, axis=1)
    ends, is_reversed, order = sorted_edges(faces)
    # Corners at the edge's lower and at its upper place.
    low = np.where(is_reversed, after.ravel(), corner.ravel())
    high = np.where(is_reversed, corner.ravel(), after.ravel())
    first, second = order[:-1], order[1:]
    is_smooth = (ends[first] == ends[second]).all(axis=1)
    is_smooth &= (normal[first // 3] * normal[second // 3]).sum(axis=1) > CREASE_COSINE
    first, second = first[is_smooth], second[is_smooth]
    pairs = np.concatenate([np.column_stack([side[first], side[second]]) for side in (low, high)])
    triples = np.concatenate([np.column_stack([pairs, pairs[:, 1]]), np.repeat(corner.reshape(-1, 1), 3, axis=1)])
    return _core.pieces(np.ascontiguousarray(triples, np.uint32), 3 * count)[len(pairs) :]


def sorted_edges(faces: NDArray[Any]) -> tuple[NDArray[Any], NDArray[np.bool_], NDArray[np.intp]]:
    """Return the edges of faces (3 F, 2), lower number first; whether this reverses each; and the order by numbers."""
    ends = np.stack([faces, np.roll(faces, -1, axis=1)], axis=2).reshape(-1, 2)
    is_reversed = ends[:, 0] > ends[:, 1]
    ends.sort(axis=1)
    return ends, is_reversed, np.lexsort((ends[:, 1], ends[:, 0]))


def unit(vectors: NDArray[Any]) -> NDArray[np.float64]:
    """Normalise vectors (…, 3); zero vectors stay zero."""
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return np.asarray(np.divide(vectors, length, out=np.zeros(vectors.shape), where=length > 0), np.float64)
