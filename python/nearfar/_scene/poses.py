"""Poses of dynamic objects (matrices object→world) and the resulting placements of their meshes."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._scene.arrays import transforms_of

Floats = NDArray[np.float64]


def checked_pose(argument: str, pose: ArrayLike) -> Floats:
    """Check a pose and return it as one finite, affine and invertible matrix (4, 4); ValueError otherwise."""
    matrix = transforms_of(argument, pose)
    if matrix.shape != (4, 4):
        raise ValueError(f"{argument}: expected one 4x4 matrix object→world, got shape {matrix.shape}")
    if np.linalg.matrix_rank(matrix[:3, :3]) < 3:
        raise ValueError(f"{argument}: expected an invertible matrix, got determinant {np.linalg.det(matrix):g}")
    return matrix


def placements_in(pose: Floats, frame: Floats, load_placements: Floats, origin: Floats) -> Floats:
    """Compute an object's mesh placements (K, 3, 4) in a pose, relative to the world position `origin`, metres.

    `pose` and `frame` are matrices object→world (4, 4): the new pose, and the load transform. `load_placements` are
    those of the meshes (K, 3, 4), relative to `origin`.
    """
    if np.array_equal(pose, frame):
        return load_placements
    world = square(load_placements)
    world[:, :3, 3] += origin
    # mesh→world = pose · frame⁻¹ · placement; frame⁻¹ · placement comes first, so that equal factors cancel exactly.
    placements: Floats = (pose @ np.linalg.solve(frame, world))[:, :3]
    placements[:, :, 3] -= origin
    return placements


def square(placements: Floats) -> Floats:
    """Append the row (0, 0, 0, 1) to placements (K, 3, 4)."""
    return np.concatenate([placements, np.tile([[[0.0, 0, 0, 1]]], (len(placements), 1, 1))], axis=1)


def frame_of(frames: Floats | None, number: int) -> Floats:
    """Load transform (4, 4) of an object; the identity beyond the rows of `frames` (N, 4, 4)."""
    return np.eye(4) if frames is None or number >= len(frames) else np.asarray(frames[number])


def pose_of(core: _core.Scene, number: int, frame: Floats, load_placements: Floats) -> Floats:
    """Present object→world (4, 4) of an object, from its load transform and moving instances' load placements."""
    rows = np.flatnonzero(core.moving_objects() == number)[:1]
    present, loaded = square(core.moving_placements()[rows]), square(load_placements[rows])
    if np.array_equal(present, loaded):
        return frame.copy()
    present[:, :3, 3] += core.origin
    loaded[:, :3, 3] += core.origin
    return np.asarray(present[0] @ np.linalg.solve(loaded[0], frame))
