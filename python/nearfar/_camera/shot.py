"""Shots: what a renderer is asked for."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from nearfar._camera.camera import Camera


@dataclass(frozen=True, kw_only=True)
class Shot:
    """One moment seen by one or more cameras, such as a headset's eyes: from where, which part of it, which images."""

    cameras: tuple[Camera, ...]
    """The views, each of which gives a picture."""
    channels: tuple[str, ...]
    """Images of each picture, in the order of `Frame`'s."""
    samples: int = 1
    """Colour samples of each pixel."""
    user: tuple[float, float, float] | None = None
    """World position of the eye that a reduced scene is bent for; None for each camera's own."""
    t_min: float = 0.0
    """Metres along each ray from which on surfaces are seen."""
    t_max: float = math.inf
    """Metres along each ray up to which surfaces are seen."""

    @property
    def settings(self) -> dict[str, Any]:
        """Images, samples and part of the rays, as kernels take them beside the camera."""
        return {
            "channels": list(self.channels),
            "samples": self.samples,
            "t_min": self.t_min,
            "t_max": self.t_max,
        }

    @property
    def eye(self) -> tuple[float, float, float]:
        """World position of the user: `user`, or the middle of the cameras."""
        if self.user is not None:
            return self.user
        x, y, z = (sum(values) / len(self.cameras) for values in zip(*(c.position for c in self.cameras), strict=True))
        return x, y, z
