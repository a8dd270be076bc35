"""Measures of triangle soups and their bytes, for tests of procedural scenes."""

from __future__ import annotations

import hashlib
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from nearfar.datasets._shapes import Soup, weld


def volume(soup: Soup) -> float:
    """Signed volume, positive if faces point outwards."""
    a, b, c = soup.corners.transpose(1, 0, 2)
    return float((np.cross(a, b) * c).sum() / 6.0)


def lone_edges(soup: Soup) -> NDArray[np.float32]:
    """Ends (K, 2, 3) of directed edges without their opposite; a closed solid has none."""
    joined = weld(Soup(soup.corners, soup.materials))
    faces = joined.faces.astype(np.int64)
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    lone = ~np.isin(edges[:, 0] << 32 | edges[:, 1], edges[:, 1] << 32 | edges[:, 0])
    return np.asarray(joined.positions[edges[lone]])


def areas(corners: NDArray[Any]) -> NDArray[np.float64]:
    """Areas (T,) of triangles (T, 3, 3)."""
    sides = corners[:, 1:].astype(np.float64) - corners[:, :1]
    return np.asarray(np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1) / 2.0)


def count_covered(corners: NDArray[np.float64]) -> int:
    """Number of triangles whose centroid lies inside another coplanar one with the same facing, which would flicker."""
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    # Planes half a millimetre apart, or rotated by a thousandth, count as different.
    planes = np.round(np.column_stack([normals * 1e3, (normals * corners[:, 0]).sum(1) * 2e3])).astype(np.int64)
    _, plane = np.unique(planes, axis=0, return_inverse=True)
    order = np.argsort(plane.reshape(-1), kind="stable")
    count = 0
    for mine in np.split(order, np.flatnonzero(np.diff(plane.reshape(-1)[order])) + 1):
        flat = np.delete(corners[mine], np.argmax(np.abs(normals[mine[0]])), axis=2)
        middle = flat.mean(axis=1)[:, None]
        sides = []
        for a, b in ((0, 1), (1, 2), (2, 0)):
            edge, there = flat[None, :, b] - flat[None, :, a], middle - flat[None, :, a]
            sides.append(edge[..., 0] * there[..., 1] - edge[..., 1] * there[..., 0])
        inside = (np.stack(sides) > 1e-7).all(0) | (np.stack(sides) < -1e-7).all(0)
        count += int(inside.sum()) - len(mine)
    return count


def digest(*arrays: NDArray[Any]) -> str:
    """Hash of the shapes and bytes of arrays."""
    state = hashlib.sha256()
    for array in arrays:
        state.update(str(array.shape).encode() + np.ascontiguousarray(array).tobytes())
    return state.hexdigest()[:16]


def area_vectors(scene: nf.Scene) -> NDArray[np.float64]:
    """Area vectors (T, 3) of the triangles."""
    a, b, c = np.moveaxis(scene.triangles().astype(np.float64), 1, 0)
    return np.asarray(np.cross(b - a, c - a) / 2)
