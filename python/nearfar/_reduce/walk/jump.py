"""Jump of a far point in the picture at the change from one centre to another."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._camera.camera import Camera, CubeFace, Fov
from nearfar._camera.rotation import rotation


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
        axis, is_negative = divmod(camera.fov.face, 2)
        return np.asarray(np.eye(3)[axis] * (-1.0 if is_negative else 1.0))
    return -rotation(camera.orientation)[:, 2]


def predict_jump(step: ArrayLike, camera: Camera, distance: float) -> float:
    """Predict the jump f·|ΔO⊥|/ρ in pixels of a point straight ahead, ρ metres from the old centre.

    The map shows a far point P in the direction P − O. A step ΔO of the centre rotates it by |ΔO⊥|/ρ, where ΔO⊥ is the
    component perpendicular to the line of sight.
    """
    perpendicular = np.cross(np.asarray(step, np.float64), forward(camera))
    return focal_length(camera) * math.hypot(*perpendicular) / distance
