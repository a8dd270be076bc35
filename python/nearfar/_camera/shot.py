"""The `Shot` class: cameras, channels and ray limits of one rendering request."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from nearfar._camera.camera import Camera


@dataclass(frozen=True, kw_only=True)
class Shot:
    """A request to render one moment from one or more cameras, such as the eyes of a headset."""

    cameras: tuple[Camera, ...]
    """The views, one picture each."""
    channels: tuple[str, ...]
    """Images of each picture, in the order of the channels of `Frame`."""
    samples: int = 1
    """Number of colour samples of each pixel."""
    user: tuple[float, float, float] | None = None
    """World position, metres, of the eye that a reduced scene is morphed for; None takes each camera's position."""
    t_min: float = 0.0
    """Least distance along each ray at which surfaces are visible, metres."""
    t_max: float = math.inf
    """Greatest distance along each ray at which surfaces are visible, metres."""

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
        """World position of the user, metres: `user`, or the mean of the cameras' positions."""
        if self.user is not None:
            return self.user
        x, y, z = (sum(values) / len(self.cameras) for values in zip(*(c.position for c in self.cameras), strict=True))
        return x, y, z
