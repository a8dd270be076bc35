"""Cameras with enough pixels for a display's density."""

from __future__ import annotations

import math
from dataclasses import replace

from nearfar._camera.camera import Camera, Fov


def with_density(camera: Camera, pixels_per_degree: float) -> Camera:
    """Return the same view with at least this density in its middle; views without a field of view stay unchanged."""
    if not isinstance(camera.fov, Fov):
        return camera
    more = pixels_per_degree / math.radians(camera.width / (camera.fov.right - camera.fov.left))
    return replace(camera, size=(round(camera.width * more), round(camera.height * more))) if more > 1.0 else camera
