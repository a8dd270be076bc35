"""The `Shot` class: cameras, channels, samples and ray limits of one rendering request."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._base.settings import set_fields
from nearfar._camera.camera import Camera
from nearfar._camera.clip import Clip

MAX_SAMPLES = 1024
"""Maximum number of colour samples of a pixel."""


@dataclass(frozen=True, kw_only=True)
class Sampling:
    """Number of samples of each pixel, and limits of their rays; the base of `Shot` and of render settings."""

    samples: int = 1
    """Number of colour samples of each pixel."""
    t_min: float = 0.0
    """Least distance along each ray at which surfaces are visible, metres."""
    t_max: float = math.inf
    """Greatest distance along each ray at which surfaces are visible, metres."""
    clip: Clip | None = None
    """Planes and a box; nothing outside them is visible."""

    def __post_init__(self) -> None:
        near, far = check.at_least_zero("t_min", self.t_min), check.number("t_max", self.t_max, finite=False)
        if not near < far:
            raise ValueError(f"t_max: expected more than t_min, {near:g} m, got {far:g}")
        if self.clip is not None:
            check.instance("clip", self.clip, Clip, "a Clip")
        set_fields(self, samples=check.integer("samples", self.samples, 1, MAX_SAMPLES), t_min=near, t_max=far)

    @property
    def sampling(self) -> dict[str, Any]:
        """Samples and limits by name, as arguments of a `Shot`."""
        return {name: getattr(self, name) for name in ("samples", "t_min", "t_max", "clip")}


@dataclass(frozen=True, kw_only=True)
class Shot(Sampling):
    """A request to render one moment from one or more cameras, such as the eyes of a headset."""

    cameras: tuple[Camera, ...]
    """The views, one picture each."""
    channels: tuple[str, ...]
    """Images of each picture, in the order of the channels of `Frame`."""
    user: tuple[float, float, float] | None = None
    """World position in metres of the eye for which a reduced scene is morphed; None for each camera's position."""
    mask: NDArray[np.bool_] | None = field(default=None, compare=False)
    """(H, W), true for needed pixels; others may be black and misses. None for all pixels."""
    bare: bool = False
    """Whether samples that hit no triangle are black instead of showing the sky or a map."""
    occlusion: bool = True
    """Whether graphics adapters also cull geometry that projects only to pixels that `mask` excludes."""
    instances: NDArray[np.bool_] | None = field(default=None, compare=False)
    """(N,), whether the pictures may show each instance of a scene, static instances first. If known, graphics adapters
    need not cull them; None if unknown."""

    def __post_init__(self) -> None:
        cameras = check.items("cameras", self.cameras, Camera, "a sequence of Cameras")
        if not cameras:
            raise ValueError("cameras: expected at least one, got none")
        super().__post_init__()
        set_fields(
            self,
            cameras=tuple(cameras),
            mask=self._check_mask(cameras),
            bare=check.flag("bare", self.bare),
            occlusion=check.flag("occlusion", self.occlusion),
            instances=self._check_instances(),
            channels=tuple(check.texts("channels", self.channels)),
            user=None if self.user is None else check.vector("user", self.user),
        )

    def _check_mask(self, cameras: list[Camera]) -> NDArray[np.bool_] | None:
        if self.mask is None:
            return None
        mask = check.instance("mask", self.mask, np.ndarray, "an array")
        for width, height in (camera.size for camera in cameras):
            if mask.dtype != np.bool_ or mask.shape != (height, width):
                got = f"{mask.shape} of {mask.dtype}"
                raise ValueError(f"mask: expected ({height}, {width}) of bool for the camera's size, got {got}")
        return np.ascontiguousarray(mask)

    def _check_instances(self) -> NDArray[np.bool_] | None:
        if self.instances is None:
            return None
        instances = check.instance("instances", self.instances, np.ndarray, "an array")
        if instances.dtype != np.bool_ or instances.ndim != 1 or not instances.flags.c_contiguous:
            got = f"{instances.shape} of {instances.dtype} with strides {instances.strides}"
            raise ValueError(f"instances: expected (N,) of bool without gaps, got {got}")
        return instances

    @property
    def settings(self) -> dict[str, Any]:
        """All kernel arguments except the camera: images, samples, pixels and ray limits."""
        return self.sampling | {
            "channels": list(self.channels),
            "clip": [] if self.clip is None else self.clip.half_spaces.tolist(),
            "mask": self.mask,
            "bare": self.bare,
            "occlusion": self.occlusion,
            "instances": self.instances,
        }

    @property
    def eye(self) -> tuple[float, float, float]:
        """World position of the user, metres: `user`, or the mean of the cameras' positions."""
        if self.user is not None:
            return self.user
        x, y, z = (sum(values) / len(self.cameras) for values in zip(*(c.position for c in self.cameras), strict=True))
        return x, y, z


def check_request(shot: object, report: object) -> None:
    """Check the arguments that rendering passes to a renderable's `trace`; TypeError for other types."""
    check.instance("shot", shot, Shot)
    if report is not None and not callable(report):
        raise TypeError(f"report: expected a function of two numbers or None, got {check.type_and_value(report)}")


def check_begin(device: object, shot: object, report: object) -> None:
    """Check the arguments that rendering passes to a renderable's `begin`; TypeError for other types."""
    check_request(shot, report)
    check.instance("device", device, _core.GpuDevice, "what nearfar.render passes")
