"""Frames that stay on the graphics device."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from numpy.typing import ArrayLike

from nearfar import _core
from nearfar._base import check, progress
from nearfar._camera.camera import Camera
from nearfar._render import backend as backends
from nearfar._render.channels import CHANNELS
from nearfar._render.frame import Frame
from nearfar._render.renderable import Renderable
from nearfar._render.renderer import Renderer


class DeviceFrame:
    """The images of one view, held by the device that drew them.

    Made by `nearfar.gpu.render`. `nearfar.gpu.ssim` and `nearfar.gpu.discontinuity` take it where it is, so that
    nothing but their results is read back. Its memory is used for the next frames once it is dropped.
    """

    def __init__(
        self,
        core: _core.GpuFrame,
        camera: Camera,
        origin: tuple[float, float, float],
        channels: Iterable[str],
    ) -> None:
        self._core = core
        self._camera = camera
        self._origin = origin
        self._channels = tuple(channels)

    @property
    def camera(self) -> Camera:
        """The view."""
        return self._camera

    @property
    def channels(self) -> tuple[str, ...]:
        """Names of the images that the frame holds."""
        return self._channels

    def read(self) -> Frame:
        """Read the images back; each time anew. DeviceError where the device was lost."""
        with progress.bar("reading a frame") as report:
            images = self._core.read(report)
        return Frame(self._camera, self._origin, **images)

    def require(self, channel: str) -> None:
        """ValueError with the channels to ask for where an image was not rendered."""
        if channel not in self._channels:
            wanted = tuple(name for name in CHANNELS if name in {channel, *self._channels})
            raise ValueError(f"frame has no {channel}: render it with channels={wanted!r}")

    def __repr__(self) -> str:
        width, height = self._camera.size
        return f"DeviceFrame({width} × {height}, {', '.join(self._channels)}, on {self._core.label})"


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
        A scene, or a reduced one, which is drawn by its vertices before its map.
    camera, at, samples
        As `render` of the source takes them.
    channels
        Images to compute; by default those that `render` of the source computes by default.

    Returns
    -------
    DeviceFrame
        The picture that `render` gives with `backend="gpu"`.

    Raises
    ------
    ValueError, TypeError
        For arguments out of their domains.
    DeviceError
        Where no adapter can be used, and for pictures that are too large to be held in one piece.
    """
    renderer = Renderer(source, channels, samples)
    shot = renderer.shot([camera])
    drawn, _ = renderer.drawn(shot, at)
    with progress.bar("drawing") as report:
        (job,) = drawn.begin(backends.opened(), shot, report)
        if not isinstance(job, _core.GpuJob):
            raise TypeError(f"source: expected one whose pictures a device can keep, got {type(source).__name__}")
        core = _core.gpu_keep(job)
    return DeviceFrame(core, camera, check.vector("origin", drawn.origin), renderer.channels)
