"""Renders the pictures of a camera path; a graphics adapter starts a picture before the last one is read back."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import repeat
from typing import Unpack

from numpy.typing import ArrayLike

from nearfar import _core
from nearfar._base import check
from nearfar._base.settings import gather
from nearfar._camera.camera import Camera
from nearfar._render.frame import Frame
from nearfar._render.renderable import Job, Renderable
from nearfar._render.renderer import Renderer, View, posed_at
from nearfar._render.settings import RenderKeywords, RenderSettings

Pose = Mapping[str, ArrayLike]

AHEAD = 2
"""Number of frames in progress on a device: one is drawn while the previous one is read back."""


def render_path(
    source: Renderable,
    cameras: Iterable[Camera],
    *,
    at: Pose | Iterable[Pose] | None = None,
    settings: RenderSettings | None = None,
    **keywords: Unpack[RenderKeywords],
) -> Iterator[Frame]:
    """Render a scene, a reduced scene or another renderable from successive cameras.

    Yields the frame that `render` returns for each camera. Closing the generator, or Ctrl-C, discards unfinished
    pictures. ValueError and TypeError at the call for arguments out of range, during iteration for an item that is not
    a camera or a pose, and for fewer poses than cameras; DeviceError as in `render`.

    Parameters
    ----------
    source
        Scene, reduced scene or other renderable. A reduced scene is drawn with the default
        `MorphSettings`.
    cameras
        Any number of views, of any sizes. With a graphics adapter, the next camera is taken from the iterable before
        the present frame is yielded.
    at
        Poses of dynamic objects, as `Scene.at` takes them: one mapping for all views, or one for each view.
    settings
        Samples, channels, limits, backend and levels, as `RenderSettings`. The channel "motion" is relative to the
        previous frame, 0 in the first one. A selector of levels knows the levels of the previous view, so that
        hysteresis works.
    keywords
        Fields of `settings`, which they replace.
    """
    check.iterable("cameras", cameras, "an iterable of Cameras")
    poses: Iterable[Pose | None] = repeat(None)
    if at is not None and not isinstance(at, Mapping):
        poses = check.iterable("at", at, "matrices by name, or one such mapping for each camera")
    renderer = Renderer(source, gather(RenderSettings, settings, keywords))
    _check_sequences(cameras, poses)
    if isinstance(at, Mapping):
        renderer.source = posed_at(source, at)
    views = _views(renderer, cameras, iter(poses))
    device = renderer.device(source)
    return (frame for view in views for frame in view.trace()) if device is None else _pipelined_frames(device, views)


def _check_sequences(cameras: Iterable[Camera], poses: Iterable[Pose | None]) -> None:
    """Check cameras and poses at the call if they are sequences; iterators are checked item by item."""
    if not isinstance(cameras, Sequence):
        return
    for number, camera in enumerate(cameras):
        _check_camera(number, camera)
    if isinstance(poses, Sequence) and len(poses) < len(cameras):
        raise ValueError(f"at: expected a pose for each of {len(cameras)} cameras, got {len(poses)}")


def _check_camera(number: int, camera: Camera) -> None:
    if not isinstance(camera, Camera):
        raise TypeError(f"cameras: expected Cameras, got {type(camera).__name__} as number {number}")


def _views(renderer: Renderer, cameras: Iterable[Camera], poses: Iterator[Pose | None]) -> Iterator[View]:
    before: View | None = None
    for number, camera in enumerate(cameras):
        _check_camera(number, camera)
        try:
            pose = next(poses)
        except StopIteration:
            raise ValueError(f"at: expected a pose for each camera, got {number}") from None
        if "motion" in renderer.channels and before is not None and before.shot.cameras[0].size != camera.size:
            raise ValueError(f"cameras: expected all of one size for motion, got {camera.size} as number {number}")
        before = renderer.view(renderer.shot([camera]), pose, before)
        yield before


def _pipelined_frames(device: _core.GpuDevice, views: Iterator[View]) -> Iterator[Frame]:
    started: list[tuple[View, Sequence[Job]]] = []
    failure: Exception | None = None
    while failure is None:
        try:
            view = next(views)
            started.append((view, view.begin(device)))
        except StopIteration:
            break
        except Exception as error:
            # Pictures that were started before the error come first.
            failure = error
        if len(started) == AHEAD:
            view, jobs = started.pop(0)
            yield from view.finish(jobs)
    for view, jobs in started:
        yield from view.finish(jobs)
    if failure is not None:
        raise failure
