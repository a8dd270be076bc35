"""Cameras in the page's form: eye position, yaw to the left, pitch upwards, and vertical field of view."""

from __future__ import annotations

import math
from typing import NamedTuple

from nearfar._base import check
from nearfar._camera.camera import Camera, Fov
from nearfar.stream.collect._player import rotated, rotation_of

MAX_PITCH = 1.5
"""Greatest absolute pitch, radians."""

MIN_ANGLE, MAX_ANGLE = 10.0, 150.0
"""Range of the vertical field of view, degrees."""

TOLERANCE = 1e-6
"""Tolerance for the sine of a camera's roll, and for the relative asymmetry of a field of view's tangents."""


class Pose(NamedTuple):
    """Position and direction of the user's eye, and the vertical field of view."""

    position: tuple[float, float, float]
    yaw: float
    """Radians; 0 looks along −z, positive to the left."""
    pitch: float
    """Radians; positive looks up."""
    angle: float
    """Vertical field of view, degrees."""


def pose_of(camera: Camera) -> Pose:
    """Convert a camera to a pose; ValueError or TypeError if the page cannot represent it."""
    fov = check.instance("camera", camera, Camera).fov
    if not isinstance(fov, Fov):
        raise TypeError(f"camera: expected a perspective camera (nearfar.Fov), got {type(fov).__name__}")
    if abs(fov.left + fov.right) > TOLERANCE * fov.right or abs(fov.down + fov.up) > TOLERANCE * fov.up:
        raise ValueError("camera: expected the same field of view to both sides, up and down, got others")
    x, y, z, w = camera.orientation
    ahead = rotated(camera.orientation)
    right_y = 2 * (x * y + w * z)
    if abs(right_y) > TOLERANCE:
        raise ValueError(f"camera: expected one without roll, got {math.degrees(math.asin(right_y)):.3g} degrees")
    pitch = math.atan2(ahead[1], math.hypot(ahead[0], ahead[2]))
    if abs(pitch) > MAX_PITCH:
        raise ValueError(f"camera: expected a pitch of at most ±{MAX_PITCH} radians, got {pitch:.4g}")
    angle = math.degrees(2.0 * math.atan(fov.up))
    check.in_range("camera: vertical field of view", angle, MIN_ANGLE, MAX_ANGLE)
    return Pose(camera.position, math.atan2(-ahead[0], -ahead[2]), pitch, angle)


def camera_of(pose: Pose, size: tuple[int, int]) -> Camera:
    """Convert a pose to a camera with an image size in pixels."""
    up = math.tan(math.radians(0.5 * pose.angle))
    right = up * size[0] / size[1]
    return Camera(pose.position, rotation_of(pose.yaw, pose.pitch), fov=Fov(-right, right, -up, up), size=size)
