"""Renders shots of a renderable to frames, on the CPU or on a graphics adapter."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence

from numpy.typing import ArrayLike

from nearfar import _core
from nearfar._base import check, progress
from nearfar._camera.camera import Camera
from nearfar._camera.shot import Shot
from nearfar._render import backend as backends
from nearfar._render.channels import MAX_SAMPLES, channel_names
from nearfar._render.frame import Frame
from nearfar._render.level_choice import LevelChoice, Lod
from nearfar._render.renderable import Images, Job, Renderable, Report, check_renderable
from nearfar._scene.levels import Shown


class Renderer:
    """Renders frames of one source; it remembers the levels of detail of the last shot."""

    def __init__(
        self,
        source: Renderable,
        channels: Iterable[str] | None,
        samples: int,
        lod: Lod | None = None,
        *,
        argument: str = "source",
    ) -> None:
        check_renderable(argument, source)
        self.source = source
        self.samples = check.integer("samples", samples, 1, MAX_SAMPLES)
        self.channels = channel_names(source.default_channels if channels is None else channels)
        self._choice = None if lod is None else LevelChoice(source, lod)

    @property
    def work(self) -> backends.Work:
        """The kind of work: channels and samples."""
        return self.channels, self.samples

    def shot(
        self, cameras: Sequence[Camera], user: ArrayLike | None = None, t_min: float = 0.0, t_max: float = math.inf
    ) -> Shot:
        """Check the arguments and make a shot of them."""
        for camera in cameras:
            check_camera(camera)
        near, far = check.number("t_min", t_min), check.number("t_max", t_max, finite=False)
        if not 0.0 <= near < far:
            raise ValueError(f"t_max: expected more than t_min and t_min at least 0, got {near:g} to {far:g}")
        return Shot(
            cameras=tuple(cameras),
            channels=self.channels,
            samples=self.samples,
            user=None if user is None else check.vector("user", user),
            t_min=near,
            t_max=far,
        )

    def device(self, backend: str, measured: object | None = None) -> _core.GpuDevice | None:
        """Choose a device as `backend.device_for` does; "auto" chooses the CPU if no adapter can draw the source.

        `measured` is the object that measurements belong to; by default the source.
        """
        if "gpu" not in self.source.backends and backends.check(backend) == "auto":
            return None
        return backends.device_for(backend, self.source if measured is None else measured, self.work)

    def drawn(self, shot: Shot, poses: Mapping[str, ArrayLike] | None) -> tuple[Renderable, Shown | None]:
        """Return the source in a pose and at the levels chosen for a shot, and these levels."""
        posed = self.source if poses is None else self.source.at(poses)
        return (posed, None) if self._choice is None else self._choice(posed, shot)

    def frames(self, shot: Shot, poses: Mapping[str, ArrayLike] | None, device: _core.GpuDevice | None) -> list[Frame]:
        """Render the frames of a shot, one for each camera."""
        drawn, shown = self.drawn(shot, poses)
        with progress.bar("rendering") as report:
            if device is None:
                return collected(drawn, shot, drawn.trace(shot, report), shown)
            return finished(drawn, shot, drawn.begin(device, shot, report), shown, report)


def finished(
    drawn: Renderable, shot: Shot, jobs: Sequence[Job], shown: Shown | None, report: Report = None
) -> list[Frame]:
    """Wait for a shot's pictures on a device and return its frames."""
    return collected(drawn, shot, [job.finish(report) for job in jobs], shown)


def collected(drawn: Renderable, shot: Shot, pictures: Sequence[Images], shown: Shown | None) -> list[Frame]:
    """Make the frames of a shot from its pictures."""
    origin = check.vector("origin", drawn.origin)
    return [Frame(camera, origin, **images, lod=shown) for camera, images in zip(shot.cameras, pictures, strict=True)]


def check_camera(camera: Camera) -> None:
    """Raise TypeError for anything that is not a `Camera`."""
    if not isinstance(camera, Camera):
        raise TypeError(f"camera: expected a Camera, got {type(camera).__name__}")
