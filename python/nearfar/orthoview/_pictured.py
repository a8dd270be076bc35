"""Renderable base of trees and flights, with moving objects, for the CPU and for graphics adapters."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._camera.shot import Shot, check_request
from nearfar._render.renderable import Images, Renderable, Report
from nearfar._scene.scene import Scene


class Pictured(Renderable):
    """Base class of renderables that draw orthoviews."""

    _movers: Scene | None
    """Moving objects."""

    @property
    def default_channels(self) -> tuple[str, ...]:
        """Images that are computed by default."""
        return ("color", "range")

    @property
    def backends(self) -> tuple[str, ...]:
        """Backends that can render this source."""
        return ("cpu", "gpu")

    @property
    def object_names(self) -> tuple[str, ...]:
        """Names of all moving objects, by number."""
        return () if self._movers is None else self._movers.object_names

    @property
    def poses(self) -> dict[str, NDArray[np.float64]]:
        """Present poses (4, 4), object→world, of the moving objects, as `at` takes them."""
        return {} if self._movers is None else self._movers.poses

    def trace(self, shot: Shot, report: Report = None) -> Sequence[Images]:
        """Draw the pictures of a shot on the CPU, one for each camera; `nearfar.render` makes frames of them."""
        check_request(shot, report)
        return self._pictures(shot, None, report)

    def begin(self, device: _core.GpuDevice, shot: Shot, report: Report = None) -> Sequence[Drawn]:
        """Draw the pictures of a shot on a device, one for each camera."""
        check_request(shot, report)
        checked_device = check.instance("device", device, _core.GpuDevice)
        return [Drawn(images) for images in self._pictures(shot, checked_device, report)]

    @abstractmethod
    def _pictures(self, shot: Shot, device: _core.GpuDevice | None, report: Report) -> list[Images]:
        """Draw the pictures of a shot on a device, or without one on the CPU."""


@dataclass(frozen=True)
class Drawn:
    """A finished picture."""

    images: dict[str, Any]

    def finish(self, report: Report = None) -> Images:
        """Return the picture."""
        return self.images
