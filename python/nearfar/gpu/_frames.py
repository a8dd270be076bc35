"""Frames that stay on the graphics device, and the time of the same picture on the CPU and on an adapter."""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Unpack

from numpy.typing import ArrayLike

from nearfar import _core
from nearfar._base import check, progress
from nearfar._base.settings import gather
from nearfar._camera.camera import Camera
from nearfar._render import backend as backends
from nearfar._render.channels import CHANNELS, missing
from nearfar._render.frame import Frame
from nearfar._render.renderable import Renderable
from nearfar._render.renderer import Renderer
from nearfar._render.settings import RenderKeywords, RenderSettings, require_defaults

ROUNDS = 3
"""Number of timed pictures, after one that is not timed."""


@dataclass(frozen=True, eq=False, repr=False)
class DeviceFrame:
    """The images of one view in the memory of the device that drew them.

    `nearfar.gpu.render` returns it. `nearfar.gpu.ssim` and `nearfar.gpu.discontinuity` process it on the device, so
    that only their results are read back. After it is deleted, its memory is reused for later frames.
    """

    _core: _core.GpuFrame
    camera: Camera
    """The view."""
    _origin: tuple[float, float, float]
    channels: tuple[str, ...]
    """Names of the images that the frame has."""

    def read(self) -> Frame:
        """Read the images back, anew at each call; DeviceError if the device was lost."""
        with progress.bar("reading a frame") as report:
            images = self._core.read(report)
        return Frame(self.camera, self._origin, **images)

    def require(self, channel: str) -> None:
        """Raise ValueError if an image was not rendered; the message names the channels to render."""
        if check.choice("channel", channel, CHANNELS) not in self.channels:
            raise missing(channel, self.channels)

    def __repr__(self) -> str:
        width, height = self.camera.size
        return f"DeviceFrame({width} × {height}, {', '.join(self.channels)}, on {self._core.label})"


def render(
    source: Renderable,
    camera: Camera,
    *,
    at: Mapping[str, ArrayLike] | None = None,
    settings: RenderSettings | None = None,
    **keywords: Unpack[RenderKeywords],
) -> DeviceFrame:
    """Draw the picture of `nearfar.render` with `backend="gpu"`, and leave it on the graphics device.

    The arguments are those of `nearfar.render`. The source is a scene, or a reduced scene, which is drawn with the
    default settings of `ReducedScene.render`. ValueError and TypeError for arguments out of range, and pictures that
    are too large to stay on the device; DeviceError if no adapter can be used.
    """
    renderer = Renderer(source, gather(RenderSettings, settings, keywords))
    if renderer.settings.backend == "cpu":
        raise ValueError("backend: expected 'gpu' or None for a picture that stays on the device, got 'cpu'")
    shot, device = renderer.shot([camera]), backends.open_device()
    device.check_whole(camera._core, list(renderer.channels))
    view = renderer.view(shot, at)
    with progress.bar("drawing") as report:
        (job,) = view.begin(device, report)
        if not isinstance(job, _core.GpuJob):
            raise TypeError(
                f"source: expected a renderable whose pictures can stay on the device, got {type(source).__name__}"
            )
        core = _core.gpu_keep(job)
    return DeviceFrame(core, camera, check.vector("origin", view.drawn.origin), renderer.channels)


def measure(
    source: Renderable, camera: Camera, *, settings: RenderSettings | None = None, **keywords: Unpack[RenderKeywords]
) -> dict[str, float]:
    """Time a picture on the CPU and on the selected adapter; from then on "auto" uses the faster one.

    Arguments are as in `nearfar.render`, but without a backend; the camera is a typical view, with the size of later
    pictures. The result is used for this source, a scene or a reduced scene, as long as the object exists, and for
    pictures with the same channels and samples. Scenes derived from the source have to be measured separately.
    ValueError and TypeError for arguments out of range; DeviceError if no adapter can be used.

    Returns seconds per picture on the "cpu" and on the "gpu": the least of three each, taken alternately, after a first
    picture that uploads the scene to the adapter and builds the tracer's trees.
    """
    renderer = Renderer(source, gather(RenderSettings, settings, keywords))
    require_defaults(renderer.settings, "nearfar.gpu.measure", "backend")
    device = backends.open_device()
    shot = renderer.shot([camera])
    timings: dict[str, list[float]] = {"cpu": [], "gpu": []}
    for _ in range(ROUNDS + 1):
        for backend, seconds in timings.items():
            started = time.perf_counter()
            renderer.frames(shot, None, device if backend == "gpu" else None)
            seconds.append(time.perf_counter() - started)
    least_seconds = {backend: min(seconds[1:]) for backend, seconds in timings.items()}
    backends.remember(source, renderer.work, device.label, least_seconds["gpu"] < least_seconds["cpu"])
    return least_seconds
