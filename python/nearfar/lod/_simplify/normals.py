"""Smooth normals for meshes without normals; hard edges stay hard."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core

CREASE_COSINE = np.cos(np.radians(60.0))
"""Cosine of the angle between two faces' normals below which their common edge is hard."""


def smooth_normals(
    positions: NDArray[np.float32], faces: NDArray[np.uint32], places: NDArray[np.uint32]
) -> tuple[NDArray[np.int64], NDArray[np.float32]]:
    """Compute a normal for each corner of the faces (F, 3): the mean over faces joined by smooth edges.

    Normals of faces are weighted by their angles at the corner. `places` (V,) has for each vertex the number of the
    first vertex at the same place. Returns `rows` (F, 3) and `normals`: corner c of face f has normal
    `normals[rows[f, c]]`. Corners with the same row have the same vertex and normal.
    """
    corners = positions[faces].astype(np.float64)
    sides = np.roll(corners, -1, axis=1) - corners
    units = unit(sides)
    normal = unit(np.cross(sides[:, 0], -sides[:, 2]))
    angles = np.arccos(np.clip(-(units * np.roll(units, 1, axis=1)).sum(axis=2), -1, 1))
    group = _smooth_groups(places[faces], normal)
    weighted = (angles[:, :, None] * normal[:, None]).reshape(-1, 3)
    sums = np.column_stack([np.bincount(group, column, len(group)) for column in weighted.T])
    # The normal of faces without area is zero.
    corner_normals = unit(sums[group])
    key = np.column_stack([faces.ravel(), group.astype(np.uint32)])
    row = _core.first_alike(np.ascontiguousarray(key.astype(np.uint32)).view(np.uint8).reshape(len(key), -1))
    return row.reshape(-1, 3).astype(np.int64), corner_normals.astype(np.float32)


def _smooth_groups(faces: NDArray[np.uint32], normal: NDArray[np.float64]) -> NDArray[np.uint32]:
    """Number the groups of corners (3 F,): corners at one place are in one group if smooth edges join their faces."""
    count = len(faces)
    corner = np.arange(3 * count, dtype=np.uint32).reshape(-1, 3)
    after = np.roll(corner, -1, axis=1)
    ends, is_reversed, order = sorted_edges(faces)
    # For each edge, the corners at the place with the lower and at the place with the higher number.
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
    """Return the edges of faces (3 F, 2), lower number first; whether each was reversed for this; and their order."""
    ends = np.stack([faces, np.roll(faces, -1, axis=1)], axis=2).reshape(-1, 2)
    is_reversed = ends[:, 0] > ends[:, 1]
    ends.sort(axis=1)
    return ends, is_reversed, np.lexsort((ends[:, 1], ends[:, 0]))


def unit(vectors: NDArray[Any]) -> NDArray[np.float64]:
    """Normalise vectors (…, 3); zero vectors stay zero."""
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return np.asarray(np.divide(vectors, length, out=np.zeros(vectors.shape), where=length > 0), np.float64)
