"""Frames of a renderable: on the CPU or on a graphics adapter, one shot after the other."""

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
    """How frames of one source are made. It remembers the levels that the last shot showed."""

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
        """Images and samples."""
        return self.channels, self.samples

    def shot(
        self, cameras: Sequence[Camera], user: ArrayLike | None = None, t_min: float = 0.0, t_max: float = math.inf
    ) -> Shot:
        """Check and collect what is asked for."""
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
        """Choose where pictures are made: see `backend.device_for`. "auto" leaves to the CPU what no adapter draws.

        `measured` is the object that measurements were kept for; by default the source.
        """
        if "gpu" not in self.source.backends and backends.check(backend) == "auto":
            return None
        return backends.device_for(backend, self.source if measured is None else measured, self.work)

    def drawn(self, shot: Shot, poses: Mapping[str, ArrayLike] | None) -> tuple[Renderable, Shown | None]:
        """Return the source in a pose and at the levels that a shot shows."""
        posed = self.source if poses is None else self.source.at(poses)
        return (posed, None) if self._choice is None else self._choice(posed, shot)

    def frames(self, shot: Shot, poses: Mapping[str, ArrayLike] | None, device: _core.GpuDevice | None) -> list[Frame]:
        """Make the frames of a shot, one for each camera."""
        drawn, shown = self.drawn(shot, poses)
        with progress.bar("rendering") as report:
            if device is None:
                return collected(drawn, shot, drawn.trace(shot, report), shown)
            return finished(drawn, shot, drawn.begin(device, shot, report), shown, report)


def finished(
    drawn: Renderable, shot: Shot, jobs: Sequence[Job], shown: Shown | None, report: Report = None
) -> list[Frame]:
    """Wait for the pictures of a shot that a device draws."""
    return collected(drawn, shot, [job.finish(report) for job in jobs], shown)


def collected(drawn: Renderable, shot: Shot, pictures: Sequence[Images], shown: Shown | None) -> list[Frame]:
    """Frames of a shot's pictures."""
    origin = check.vector("origin", drawn.origin)
    return [Frame(camera, origin, **images, lod=shown) for camera, images in zip(shot.cameras, pictures, strict=True)]


def check_camera(camera: Camera) -> None:
    """Refuse what is no camera: TypeError."""
    if not isinstance(camera, Camera):
        raise TypeError(f"camera: expected a Camera, got {type(camera).__name__}")
