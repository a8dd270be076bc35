"""Rendering of frames that stay on the graphics device."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from numpy.typing import ArrayLike

from nearfar import _core
from nearfar._base import check, progress
from nearfar._camera.camera import Camera
from nearfar._render import backend as backends
from nearfar._render.channels import CHANNELS, missing
from nearfar._render.frame import Frame
from nearfar._render.renderable import Renderable
from nearfar._render.renderer import Renderer


@dataclass(frozen=True, eq=False, repr=False)
class DeviceFrame:
    """The images of one view in the memory of the device that drew them.

    Made by `nearfar.gpu.render`. `nearfar.gpu.ssim` and `nearfar.gpu.discontinuity` process it on the device, so that
    only their results are read back. After it is deleted, its memory serves later frames.
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
        """Raise ValueError, which names the channels to render, if an image was not rendered."""
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
    channels: Iterable[str] | None = None,
    samples: int = 1,
) -> DeviceFrame:
    """Draw a picture on the graphics device and leave it there.

    Parameters
    ----------
    source
        A scene, or a reduced scene, which is drawn with the default settings of `ReducedScene.render`.
    camera, at, samples
        As in `nearfar.render`.
    channels
        Images to compute; by default the source's `default_channels`.

    Returns
    -------
    DeviceFrame
        The same picture as `nearfar.render` returns with `backend="gpu"`.

    Raises
    ------
    ValueError, TypeError
        Arguments out of range, and pictures that are too large to stay on the device.
    DeviceError
        If no adapter can be used.
    """
    renderer = Renderer(source, channels, samples)
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
