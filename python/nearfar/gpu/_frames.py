"""Frames that stay on the graphics device."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from numpy.typing import ArrayLike

from nearfar import _core
from nearfar._base import progress
from nearfar._camera.camera import Camera
from nearfar._reduce.reduced_scene import ReducedScene
from nearfar._render import backend as backends
from nearfar._render.frame import CHANNELS, Frame
from nearfar._render.renderer import check_camera
from nearfar._render.sequence import painter_of
from nearfar._scene.scene import Scene


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
    source: Scene | ReducedScene,
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
    check_camera(camera)
    painter = painter_of(source, channels, samples)
    scene = painter.scene if at is None else painter.scene.at(at)
    device = backends.opened()
    with progress.bar("drawing") as report:
        core = _core.gpu_keep(painter.begin(device, scene, camera, report))
    return DeviceFrame(core, camera, scene._core.origin, painter.work[0])
