"""Settings for baking a map; reduced scenes store them to bake maps for other centres alike."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, TypedDict

import numpy as np
from numpy.typing import DTypeLike

from nearfar._base import check
from nearfar._base.settings import set_fields
from nearfar._camera.shot import MAX_SAMPLES
from nearfar._cubemap import envmap
from nearfar._render import backend as backends
from nearfar._render.backend import Backend
from nearfar._render.bake import is_half
from nearfar._render.channels import channel_names
from nearfar._scene.scene import Scene


@dataclass(frozen=True, kw_only=True)
class MapSettings:
    """Settings of an environment map: its size, samples, channels, and the backend that bakes it.

    ValueError and TypeError for settings out of range.

    Parameters
    ----------
    face_size
        Number of texels across each of the map's six faces, 1 to 16,384.
    samples
        Number of colour samples of each texel, 1 to 1024; for maps of trees of orthoviews on a grid, 1, 4, 9 … 64.
    channels
        Channels of the map: "color" always, "range" and "object_id" if named. Scenes with moving objects always get
        range, because it decides which of them far buildings hide. Maps of trees of orthoviews have no "object_id".
    range_dtype
        Type of the map's range: float32, or float16, which halves memory and file and has an error of at most 2⁻¹¹ of
        the range.
    backend
        Backend that bakes the map: "cpu", "gpu", "auto" or None, as in `RenderSettings`. Maps of trees of orthoviews
        are drawn on the CPU.
    """

    face_size: int = 1024
    samples: int = 4
    channels: Iterable[str] = ("color",)
    range_dtype: DTypeLike = np.float32
    backend: Backend | None = None

    def __post_init__(self) -> None:
        names = channel_names(self.channels)
        if unknown := [name for name in names if name not in envmap.CHANNELS]:
            raise ValueError(f"channels: expected names of {', '.join(envmap.CHANNELS)}, got {', '.join(unknown)}")
        backends.check(self.backend)
        set_fields(
            self,
            face_size=check.integer("face_size", self.face_size, 1, 16384),
            samples=check.integer("samples", self.samples, 1, MAX_SAMPLES),
            channels=names,
            range_dtype=np.dtype(np.float16 if is_half("range_dtype", self.range_dtype) else np.float32),
        )

    @property
    def half(self) -> bool:
        """Whether range is stored as float16."""
        return self.range_dtype == np.float16


class MapKeywords(TypedDict, total=False):
    """Fields of `MapSettings` as keywords; a test compares both."""

    face_size: int
    samples: int
    channels: Iterable[str]
    range_dtype: DTypeLike
    backend: Backend | None


def require_cpu(settings: MapSettings, kind: str) -> None:
    """Raise ValueError unless the backend is the CPU, the only one that draws maps of this kind of world."""
    if settings.backend not in (None, "cpu"):
        raise ValueError(f"backend: expected cpu for {kind}, got {settings.backend}")


def bake_arguments(settings: MapSettings, scene: Scene) -> dict[str, Any]:
    """Return the keyword arguments of `bake` for a scene; DeviceError if "gpu" finds no usable adapter."""
    names = tuple(settings.channels)
    device = backends.device_for(settings.backend, scene, (names, settings.samples))
    return {
        "size": settings.face_size,
        "samples": settings.samples,
        "channels": names,
        "half": settings.half,
        "device": device,
    }
