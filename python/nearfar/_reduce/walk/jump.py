"""Jump of a far point in the picture at the change from one centre to another."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._camera.camera import Camera, CubeFace, Fov

_FACES = ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1))
"""Viewing directions of the faces of a cube map."""


def focal_length(camera: Camera) -> float:
    """Focal length in pixels of a perspective picture; ValueError for parallel rays."""
    if isinstance(camera.fov, CubeFace):
        return camera.width / 2.0
    if isinstance(camera.fov, Fov):
        return camera.width / (camera.fov.right - camera.fov.left)
    raise ValueError("camera: expected a perspective view or a cube face, got parallel rays, which belong to no eye")


def forward(camera: Camera) -> NDArray[np.float64]:
    """Unit vector of the viewing axis."""
    if isinstance(camera.fov, CubeFace):
        return np.array(_FACES[camera.fov.face], np.float64)
    x, y, z, w = camera.orientation
    return -np.array([2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y)])


def predicted(step: ArrayLike, camera: Camera, distance: float) -> float:
    """Predict the jump f·|ΔO⊥|/ρ in pixels of a point straight ahead, ρ metres from the old centre.

    The map shows a far point P in the direction P − O. A step ΔO of the centre rotates it by |ΔO⊥|/ρ, where ΔO⊥ is the
    component perpendicular to the line of sight.
    """
    across = np.cross(np.asarray(step, np.float64), forward(camera))
    return focal_length(camera) * math.hypot(*across) / distance
