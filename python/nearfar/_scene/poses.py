"""Poses of dynamic objects: object→world matrices, and the placements of their meshes that follow from them."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._scene.arrays import transforms_of

Floats = NDArray[np.float64]


def checked_pose(argument: str, pose: ArrayLike) -> Floats:
    """A pose as one finite, affine and invertible matrix (4, 4)."""
    matrix = transforms_of(argument, pose)
    if matrix.shape != (4, 4):
        raise ValueError(f"{argument}: expected one 4x4 matrix object→world, got shape {matrix.shape}")
    if np.linalg.matrix_rank(matrix[:3, :3]) < 3:
        raise ValueError(f"{argument}: expected an invertible matrix, got determinant {np.linalg.det(matrix):g}")
    return matrix


def placements_in(pose: Floats, frame: Floats, rest: Floats, origin: Floats) -> Floats:
    """Placements (K, 3, 4) of an object's meshes in a pose.

    Parameters
    ----------
    pose, frame
        Object→world now, and when the object was loaded.
    rest
        Placements of its meshes when it was loaded (K, 3, 4), relative to `origin`.
    """
    if np.array_equal(pose, frame):
        return rest
    world = rest.copy()
    world[:, :, 3] += origin
    # mesh→world becomes pose · frame⁻¹ · (mesh→world when loaded); solved first, so that equal factors cancel.
    local = np.linalg.solve(frame, np.concatenate([world, np.tile([[[0.0, 0, 0, 1]]], (len(world), 1, 1))], axis=1))
    placements: Floats = (pose @ local)[:, :3]
    placements[:, :, 3] -= origin
    return placements


def current_pose(frame: Floats, placement: Floats, rest: Floats, origin: Floats) -> Floats:
    """Object→world (4, 4) of an object whose mesh stood at `rest` (3, 4) when loaded and is now at `placement`."""
    now, loaded = (np.vstack([rows, [0, 0, 0, 1]]) for rows in (placement, rest))
    if np.array_equal(now, loaded):
        return frame.copy()
    for matrix in (now, loaded):
        matrix[:3, 3] += origin
    moved: Floats = now @ np.linalg.solve(loaded, frame)
    return moved
