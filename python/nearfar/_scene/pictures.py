"""Rendering of a scene: the mixin of `Scene` that draws pictures."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._camera.shot import Shot, check_begin, check_request

if TYPE_CHECKING:
    from nearfar._core import GpuDevice, GpuJob, Scene as CoreScene


class InPictures:
    """Mixin that renders a scene exactly."""

    _core: CoreScene

    @property
    def default_channels(self) -> tuple[str, ...]:
        """Images that `nearfar.render` computes by default."""
        return ("color", "range", "object_id")

    @property
    def backends(self) -> tuple[str, ...]:
        """Backends that can render the scene."""
        return ("cpu", "gpu")

    def displayed(self, points: ArrayLike, user: ArrayLike) -> NDArray[np.float64]:
        """Return the world positions (N, 3) where a picture shows points: unchanged, for any user."""
        check.vector("user", user)
        return check.array("points", points, columns=3, dtype=np.float64)

    def trace(self, shot: Shot, report: Callable[[int, int], None] | None = None) -> list[dict[str, NDArray[Any]]]:
        """Trace the pictures of a shot, one for each camera; `nearfar.render` makes frames of them."""
        check_request(shot, report)
        return [_core.render_truth(self._core, camera._core, shot.settings, report=report) for camera in shot.cameras]

    def begin(self, device: GpuDevice, shot: Shot, report: Callable[[int, int], None] | None = None) -> list[GpuJob]:
        """Begin the pictures of a shot on a graphics device, one for each camera.

        Pictures of two cameras are drawn in one pass if the adapter supports it.
        """
        check_begin(device, shot, report)
        cameras = [camera._core for camera in shot.cameras]
        return device.truth(self._core, cameras, shot.settings, report=report)
