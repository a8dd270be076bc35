"""Pictures of scenes and of reduced ones, on the CPU or on a graphics adapter: what differs, in one place."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from nearfar import _core
from nearfar._base import progress
from nearfar._camera.camera import Camera
from nearfar._render import backend as backends
from nearfar._render.frame import Frame
from nearfar._scene.scene import Scene

Report = Callable[[int, int], None] | None
"""Takes how much is done and how much there is."""


@dataclass(frozen=True)
class Painter:
    """How pictures of one kind are made. Scenes are those of the painter in any pose."""

    source: object
    """What measurements are kept for."""
    scene: Scene
    """What is seen, as it was given."""
    work: backends.Work
    """Images and samples."""
    trace: Callable[[Scene, Camera, Report], dict[str, Any]]
    """Make a picture's images on the CPU."""
    begin: Callable[[_core.GpuDevice, Scene, Camera, Report], _core.GpuJob]
    """Begin a picture on a device."""
    bends: bool = False
    """Rays are bent, which is done on the CPU alone."""

    def device(self, backend: str) -> _core.GpuDevice | None:
        """Choose where pictures are made: see `backends.device_for`. What only the CPU does, "auto" leaves to it."""
        if self.bends:
            if backends.check(backend) == "gpu":
                raise ValueError("method: expected 'vertex' with backend='gpu', got 'exact': rays are bent on the CPU")
            return None
        return backends.device_for(backend, self.source, self.work)

    def paint(self, scene: Scene, camera: Camera, backend: str) -> Frame:
        """Make one picture."""
        device = self.device(backend)
        with progress.bar("rendering") as report:
            if device is None:
                images = self.trace(scene, camera, report)
            else:
                images = self.begin(device, scene, camera, report).finish(report)
        return Frame(camera, scene._core.origin, **images)


def check_camera(camera: Camera) -> None:
    """Refuse what is no camera: TypeError."""
    if not isinstance(camera, Camera):
        raise TypeError(f"camera: expected a Camera, got {type(camera).__name__}")
