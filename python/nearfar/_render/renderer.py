"""Renders shots of a renderable to frames, on the CPU or on a graphics adapter."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from numpy.typing import ArrayLike

from nearfar import _core
from nearfar._base import check, memory, progress
from nearfar._camera.camera import Camera
from nearfar._camera.shot import Shot
from nearfar._render import backend as backends
from nearfar._render.channels import BYTES, channel_names
from nearfar._render.frame import Frame
from nearfar._render.level_choice import Draws, LevelChoice
from nearfar._render.motion import Viewpoint, motion
from nearfar._render.renderable import Images, Job, Renderable, Report, check_renderable
from nearfar._render.settings import RenderSettings
from nearfar._scene.levels import Shown

NEEDED_BY_MOTION = ("position", "object_id")
"""Channels needed to compute motion; object numbers only if objects can move."""


@dataclass(frozen=True)
class View:
    """A shot, and the source in its pose and at its levels."""

    shot: Shot
    drawn: Renderable
    shown: Shown | None = None
    channels: tuple[str, ...] = ()
    """Channels of the frames; the shot may have more of them, for computing motion."""
    before: View | None = None
    """The view that motion is relative to; None for this view itself."""

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
        frames = [
            Frame(camera, origin, **images, lod=self.shown) for camera, images in zip(cameras, pictures, strict=True)
        ]
        if "motion" not in self.channels:
            return frames
        return [self._with_motion(number, frame) for number, frame in enumerate(frames)]

    def viewpoint(self, number: int) -> Viewpoint:
        """Return camera, source and user of one of the pictures."""
        camera = self.shot.cameras[number]
        return Viewpoint(camera, self.drawn, camera.position if self.shot.user is None else self.shot.user)

    def _with_motion(self, number: int, frame: Frame) -> Frame:
        now, before = (view.viewpoint(number) for view in (self, self if self.before is None else self.before))
        motions = motion(frame, now, before)
        position, object_id = (getattr(frame, name) if name in self.channels else None for name in NEEDED_BY_MOTION)
        return replace(frame, motion=motions, position=position, object_id=object_id)


def posed_at(source: Renderable, at: Mapping[str, ArrayLike], argument: str = "at") -> Renderable:
    """Pose a source; error messages begin with the name of the `argument` that contains the poses."""
    try:
        return source.at(check.mapping(argument, at, "matrices by name such as {'car': matrix}"))
    except (TypeError, ValueError) as error:
        if str(error).startswith(f"{argument}: "):
            raise
        kind = TypeError if isinstance(error, TypeError) else ValueError
        raise kind(f"{argument}: {error}") from error


class Renderer:
    """Renders frames of one source; remembers the levels of detail of the last shot."""

    def __init__(self, source: Renderable, settings: RenderSettings, *, argument: str = "source") -> None:
        check_renderable(argument, source)
        self.source, self.settings, self._argument = source, settings, argument
        self.channels = channel_names(source.default_channels if settings.channels is None else settings.channels)
        self._choice = None if settings.lod is None else LevelChoice(source, settings.lod)

    @property
    def drawn_channels(self) -> tuple[str, ...]:
        """Channels that the source draws: requested ones, and those needed for motion."""
        if "motion" not in self.channels:
            return self.channels
        needed = NEEDED_BY_MOTION if self.source.poses else NEEDED_BY_MOTION[:1]
        return channel_names([*(name for name in self.channels if name != "motion"), *needed])

    @property
    def work(self) -> backends.Work:
        """Kind of work: channels and samples."""
        return self.drawn_channels, self.settings.samples

    def shot(self, cameras: Sequence[Camera], user: ArrayLike | None = None) -> Shot:
        """Check the arguments and make a shot of them."""
        for camera in cameras:
            check.instance("camera", camera, Camera)
        pixels = sum(camera.size[0] * camera.size[1] for camera in cameras)
        sizes = " and ".join(dict.fromkeys(f"{camera.size[0]} × {camera.size[1]}" for camera in cameras))
        request = f"a picture of {sizes} pixels" if len(cameras) == 1 else f"{len(cameras)} pictures of {sizes} pixels"
        memory.check_room("camera", request, pixels * sum(BYTES[name] for name in self.channels))
        user_position = None if user is None else check.vector("user", user)
        return Shot(cameras=tuple(cameras), channels=self.drawn_channels, user=user_position, **self.settings.sampling)

    def device(self, measured_source: object | None = None) -> _core.GpuDevice | None:
        """Choose a device as `backend.device_for` does; "auto" chooses the CPU if no adapter can draw the source.

        `measured_source` is the object that measurements belong to; by default the source.
        """
        supported, backend = check.texts(f"{self._argument}.backends", self.source.backends), self.settings.backend
        if "gpu" not in supported and backends.check(backend) == "auto":
            return None
        return backends.device_for(backend, self.source if measured_source is None else measured_source, self.work)

    def view(
        self,
        shot: Shot,
        poses: Mapping[str, ArrayLike] | None,
        before: View | None = None,
        draws: Draws | None = None,
    ) -> View:
        """Pose the source and choose its levels for a shot; motion is relative to the view `before`.

        `draws` counts how often each object is drawn; by default once for each camera.
        """
        posed = self.source if poses is None else posed_at(self.source, poses)
        source, levels = (posed, None) if self._choice is None else self._choice(posed, shot, draws)
        # The earlier view loses its own link, so that views do not form a chain.
        return View(shot, source, levels, self.channels, None if before is None else replace(before, before=None))

    def frames(
        self,
        shot: Shot,
        poses: Mapping[str, ArrayLike] | None,
        device: _core.GpuDevice | None,
        before: View | None = None,
    ) -> list[Frame]:
        """Render the frames of a shot, one for each camera."""
        if before is None and "motion" in self.channels:
            raise ValueError(
                "channels: expected motion with the camera of an earlier frame, `before` of nearfar.render"
            )
        view = self.view(shot, poses, before)
        with progress.bar("rendering") as report:
            return view.trace(report) if device is None else view.finish(view.begin(device, report), report)
