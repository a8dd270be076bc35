"""Renders shots of a renderable to frames, on the CPU or on a graphics adapter."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from numpy.typing import ArrayLike

from nearfar import _core
from nearfar._base import check, memory, progress
from nearfar._camera.camera import Camera
from nearfar._camera.clip import Clip
from nearfar._camera.shot import MAX_SAMPLES, Shot
from nearfar._render import backend as backends
from nearfar._render.channels import BYTES, channel_names
from nearfar._render.frame import Frame
from nearfar._render.level_choice import LevelChoice, Lod
from nearfar._render.renderable import Images, Job, Renderable, Report, check_renderable
from nearfar._scene.levels import Shown


@dataclass(frozen=True)
class View:
    """A shot, and the source in the pose and at the levels in which it is drawn."""

    shot: Shot
    drawn: Renderable
    shown: Shown | None = None

    def trace(self, report: Report = None) -> list[Frame]:
        """Render the frames on the CPU, one for each camera."""
        return self._frames(self.drawn.trace(self.shot, report))

    def begin(self, device: _core.GpuDevice, report: Report = None) -> Sequence[Job]:
        """Start the pictures on a device."""
        return self.drawn.begin(device, self.shot, report)

    def finish(self, jobs: Sequence[Job], report: Report = None) -> list[Frame]:
        """Wait for the pictures that `begin` started, and return the frames."""
        return self._frames([job.finish(report) for job in jobs])

    def _frames(self, pictures: Sequence[Images]) -> list[Frame]:
        origin, cameras = check.vector("origin", self.drawn.origin), self.shot.cameras
        return [
            Frame(camera, origin, **images, lod=self.shown) for camera, images in zip(cameras, pictures, strict=True)
        ]


def posed_at(source: Renderable, at: Mapping[str, ArrayLike]) -> Renderable:
    """Pose a source by the argument `at`, which its messages name."""
    try:
        return source.at(check.mapping("at", at, "matrices by name such as {'car': matrix}"))
    except (TypeError, ValueError) as error:
        if str(error).startswith("at: "):
            raise
        kind = TypeError if isinstance(error, TypeError) else ValueError
        raise kind(f"at: {error}") from error


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
        self,
        cameras: Sequence[Camera],
        user: ArrayLike | None = None,
        t_min: float = 0.0,
        t_max: float = math.inf,
        clip: Clip | None = None,
    ) -> Shot:
        """Check the arguments and make a shot of them."""
        for camera in cameras:
            check.instance("camera", camera, Camera)
        pixels = sum(camera.size[0] * camera.size[1] for camera in cameras)
        sizes = " and ".join(dict.fromkeys(f"{camera.size[0]} × {camera.size[1]}" for camera in cameras))
        what = f"a picture of {sizes} pixels" if len(cameras) == 1 else f"{len(cameras)} pictures of {sizes} pixels"
        memory.check_room("camera", what, pixels * sum(BYTES[name] for name in self.channels))
        place = None if user is None else check.vector("user", user)
        return Shot(
            cameras=tuple(cameras),
            channels=self.channels,
            samples=self.samples,
            user=place,
            t_min=t_min,
            t_max=t_max,
            clip=clip,
        )

    def device(self, backend: str | None, measured: object | None = None) -> _core.GpuDevice | None:
        """Choose a device as `backend.device_for` does; "auto" chooses the CPU if no adapter can draw the source.

        `measured` is the object that measurements belong to; by default the source.
        """
        if "gpu" not in self.source.backends and backends.check(backend) == "auto":
            return None
        return backends.device_for(backend, self.source if measured is None else measured, self.work)

    def view(self, shot: Shot, poses: Mapping[str, ArrayLike] | None) -> View:
        """Pose the source and choose its levels for a shot."""
        posed = self.source if poses is None else posed_at(self.source, poses)
        return View(shot, posed) if self._choice is None else View(shot, *self._choice(posed, shot))

    def frames(self, shot: Shot, poses: Mapping[str, ArrayLike] | None, device: _core.GpuDevice | None) -> list[Frame]:
        """Render the frames of a shot, one for each camera."""
        view = self.view(shot, poses)
        with progress.bar("rendering") as report:
            return view.trace(report) if device is None else view.finish(view.begin(device, report), report)
