"""Settings for baking a map, stored so that maps for other centres get the same settings."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import DTypeLike

from nearfar._base import check
from nearfar._camera.shot import MAX_SAMPLES
from nearfar._cubemap import envmap
from nearfar._render import backend as backends
from nearfar._render.bake import is_half
from nearfar._render.channels import CHANNELS, channel_names
from nearfar._scene.scene import Scene


@dataclass(frozen=True)
class Baking:
    """Settings of a map; `reduce` documents them."""

    face_size: int = 1024
    samples: int = 4
    channels: tuple[str, ...] = ("color",)
    """Channel names, in the order of `CHANNELS`."""
    half: bool = False
    """Whether range is stored as float16."""
    backend: str | None = None

    @classmethod
    def check_settings(
        cls,
        face_size: int,
        samples: int,
        channels: Iterable[str],
        backend: str | None,
        range_dtype: DTypeLike = np.float32,
    ) -> Baking:
        """Check arguments; TypeError or ValueError if they are out of range."""
        size = check.integer("face_size", face_size, 1, 16384)
        count = check.integer("samples", samples, 1, MAX_SAMPLES)
        names = set(channel_names(channels))
        if unknown := names - set(envmap.CHANNELS):
            listed = ", ".join(name for name in CHANNELS if name in unknown)
            raise ValueError(f"channels: expected names of {', '.join(envmap.CHANNELS)}, got {listed}")
        backends.check(backend)
        ordered = tuple(name for name in CHANNELS if name in names)
        return cls(size, count, ordered, is_half("range_dtype", range_dtype), backend)

    def arguments(self, scene: Scene) -> dict[str, Any]:
        """Keyword arguments of `stages.parts` for a scene; DeviceError if no adapter can be used for "gpu"."""
        device = backends.device_for(self.backend, scene, (self.channels, self.samples))
        return {
            "size": self.face_size,
            "samples": self.samples,
            "channels": self.channels,
            "half": self.half,
            "device": device,
        }
