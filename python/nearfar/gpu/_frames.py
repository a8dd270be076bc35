"""Frames that stay on the graphics device."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from nearfar import _check, _core, _progress
from nearfar._camera import Camera
from nearfar._frame import CHANNELS, Frame
from nearfar._render import MAX_SAMPLES, channel_names
from nearfar._scene import Scene, core_of


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
        with _progress.bar("reading a frame") as report:
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
    scene: Scene,
    camera: Camera,
    *,
    channels: Iterable[str] = ("color", "range", "object_id"),
    samples: int = 1,
) -> DeviceFrame:
    """Draw a picture on the graphics device and leave it there.

    Parameters
    ----------
    scene
        What is looked at.
    camera, channels, samples
        As in `nearfar.render`.

    Returns
    -------
    DeviceFrame
        The picture that `nearfar.render` gives with `backend="gpu"`.

    Raises
    ------
    ValueError, TypeError
        For arguments out of their domains.
    DeviceError
        Where no adapter can be used, and for pictures that are too large to be held in one piece.
    """
    if not isinstance(camera, Camera):
        raise TypeError(f"camera: expected a Camera, got {type(camera).__name__}")
    wanted = channel_names(channels)
    begin, origin = _source(scene)
    count = _check.integer("samples", samples, 1, MAX_SAMPLES)
    with _progress.bar("drawing") as report:
        core = _core.gpu_keep(begin(camera._core, channels=wanted, samples=count, report=report))
    return DeviceFrame(core, camera, origin, wanted)


def _source(scene: Scene) -> tuple[Callable[..., _core.GpuJob], tuple[float, float, float]]:
    """What begins a frame of a scene, and where its positions are relative to."""
    core = core_of(scene)
    device = _device()
    return lambda camera, **settings: device.truth(core, camera, **settings), core.origin


def _device() -> _core.GpuDevice:
    """The device that is used."""
    return _core.GpuDevice(None)
