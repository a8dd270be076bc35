"""Pictures along a path: the next one is begun before the last one is read."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import repeat

from numpy.typing import ArrayLike

from nearfar import _core
from nearfar._camera.camera import Camera
from nearfar._camera.shot import Shot
from nearfar._render.frame import Frame
from nearfar._render.level_choice import Lod
from nearfar._render.renderable import Job, Renderable
from nearfar._render.renderer import Renderer, collected, finished
from nearfar._scene.levels import Shown

Pose = Mapping[str, ArrayLike]

AHEAD = 2
"""Frames that the device works on at a time: while one is read the next one is drawn."""


def render_path(
    source: Renderable,
    cameras: Iterable[Camera],
    *,
    at: Pose | Iterable[Pose] | None = None,
    channels: Iterable[str] | None = None,
    samples: int = 1,
    lod: Lod | None = None,
    backend: str = "auto",
) -> Iterator[Frame]:
    """Render a scene, a reduced scene or another renderable from one camera after the other.

    Parameters
    ----------
    source
        What is looked at. A reduced scene is drawn by its vertices before its map, as `ReducedScene.render` does by
        default.
    cameras
        Any number of views, of any sizes. On a graphics adapter one view is asked for before the frame of the one
        before it is given.
    at
        Poses of dynamic objects, as `Scene.at` takes them: one mapping for all views, or one for each view.
    channels
        Images to compute; by default those that the source's `render` computes by default.
    samples, backend
        As `render` takes them.
    lod
        As `render` takes it, for scenes and reduced scenes whose objects have levels. One selector chooses for all
        views in turn, so that it may keep objects at the levels that they have.

    Yields
    ------
    Frame
        The same as `render` returns for each camera. Closing the generator drops what is under way, and Ctrl-C ends it.

    Raises
    ------
    ValueError, TypeError
        At the call for arguments out of their domains. For what iterators bring when its turn comes: something else
        than a camera or a pose, and fewer poses than cameras.
    DeviceError
        As `render`.
    """
    if isinstance(cameras, Camera) or not isinstance(cameras, Iterable):
        raise TypeError(f"cameras: expected an iterable of Cameras, got {type(cameras).__name__}")
    poses: Iterable[Pose | None] = repeat(None) if at is None or isinstance(at, Mapping) else at
    if isinstance(poses, str) or not isinstance(poses, Iterable):
        raise TypeError(f"at: expected matrices by name, or one such mapping for each camera, got {type(at).__name__}")
    renderer = Renderer(source, channels, samples, lod)
    _check_known(cameras, poses)
    if isinstance(at, Mapping):
        renderer.source = source.at(at)
    views = _views(renderer, cameras, iter(poses))
    device = renderer.device(backend, source)
    return (view.trace() for view in views) if device is None else _drawn(device, views)


def _check_known(cameras: Iterable[Camera], poses: Iterable[Pose | None]) -> None:
    """Check what is there already: lists, not iterators."""
    if not isinstance(cameras, Sequence):
        return
    for number, camera in enumerate(cameras):
        _check_camera(number, camera)
    if isinstance(poses, Sequence) and len(poses) < len(cameras):
        raise ValueError(f"at: expected a pose for each of {len(cameras)} cameras, got {len(poses)}")


def _check_camera(number: int, camera: Camera) -> None:
    if not isinstance(camera, Camera):
        raise TypeError(f"cameras: expected Cameras, got {type(camera).__name__} as number {number}")


@dataclass(frozen=True)
class _View:
    """One camera of the sequence: the source as it is drawn for it."""

    drawn: Renderable
    shot: Shot
    shown: Shown | None

    def trace(self) -> Frame:
        (frame,) = collected(self.drawn, self.shot, self.drawn.trace(self.shot), self.shown)
        return frame

    def begin(self, device: _core.GpuDevice) -> Sequence[Job]:
        return self.drawn.begin(device, self.shot)

    def finish(self, jobs: Sequence[Job]) -> Frame:
        (frame,) = finished(self.drawn, self.shot, jobs, self.shown)
        return frame


def _views(renderer: Renderer, cameras: Iterable[Camera], poses: Iterator[Pose | None]) -> Iterator[_View]:
    for number, camera in enumerate(cameras):
        _check_camera(number, camera)
        try:
            pose = next(poses)
        except StopIteration:
            raise ValueError(f"at: expected a pose for each camera, got {number}") from None
        shot = renderer.shot([camera])
        drawn, shown = renderer.drawn(shot, pose)
        yield _View(drawn, shot, shown)


def _drawn(device: _core.GpuDevice, views: Iterator[_View]) -> Iterator[Frame]:
    under_way: list[tuple[_View, Sequence[Job]]] = []
    wrong: Exception | None = None
    while wrong is None:
        try:
            view = next(views)
            under_way.append((view, view.begin(device)))
        except StopIteration:
            break
        except Exception as error:
            # Pictures that were begun before the error come before it.
            wrong = error
        if len(under_way) == AHEAD:
            view, jobs = under_way.pop(0)
            yield view.finish(jobs)
    for view, jobs in under_way:
        yield view.finish(jobs)
    if wrong is not None:
        raise wrong
