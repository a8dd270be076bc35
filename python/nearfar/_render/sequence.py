"""Pictures along a path: the next one is begun before the last one is read."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import repeat

from numpy.typing import ArrayLike

from nearfar import _core
from nearfar._camera.camera import Camera
from nearfar._reduce.reduced_scene import ReducedScene
from nearfar._render.frame import Frame
from nearfar._render.level_choice import Choice, Lod, said
from nearfar._render.renderer import Painter
from nearfar._render.truth import painter
from nearfar._scene.levels import Shown
from nearfar._scene.scene import Scene

Pose = Mapping[str, ArrayLike]

AHEAD = 2
"""Frames that the device works on at a time: while one is read the next one is drawn."""


def render_path(
    source: Scene | ReducedScene,
    cameras: Iterable[Camera],
    *,
    at: Pose | Iterable[Pose] | None = None,
    channels: Iterable[str] | None = None,
    samples: int = 1,
    lod: Lod | None = None,
    backend: str = "auto",
) -> Iterator[Frame]:
    """Render a scene, or a reduced one, from one camera after the other.

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
        As `render` takes it, for a scene whose objects have levels. One selector chooses for all views in turn, so that
        it may keep objects at the levels that they have.

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
    how = painter_of(source, channels, samples)
    if isinstance(cameras, Camera) or not isinstance(cameras, Iterable):
        raise TypeError(f"cameras: expected an iterable of Cameras, got {type(cameras).__name__}")
    poses: Iterable[Pose | None] = repeat(None) if at is None or isinstance(at, Mapping) else at
    if isinstance(poses, str) or not isinstance(poses, Iterable):
        raise TypeError(f"at: expected matrices by name, or one such mapping for each camera, got {type(at).__name__}")
    _check_known(cameras, poses)
    scene = how.scene.at(at) if isinstance(at, Mapping) else how.scene
    choice = None
    if lod is not None:
        if isinstance(source, ReducedScene):
            raise ValueError("lod: expected None for a reduced scene, whose objects have no levels")
        choice = Choice(scene, lod)
    views = _views(_posed(scene, poses), cameras, choice)
    device = how.device(backend)
    return _traced(how, views) if device is None else _drawn(how, device, views)


def painter_of(source: Scene | ReducedScene, channels: Iterable[str] | None, samples: int) -> Painter:
    """How a source is seen; TypeError for what is neither a scene nor a reduced one."""
    if isinstance(source, ReducedScene):
        return source._painter(channels, samples)
    if not isinstance(source, Scene):
        raise TypeError(f"source: expected a Scene or a ReducedScene, got {type(source).__name__}")
    return painter(source, channels, samples)


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


def _posed(source: Scene, poses: Iterable[Pose | None]) -> Iterator[Scene]:
    """The scene in each pose. A mapping that is changed in place is another pose when its turn comes."""
    for pose in poses:
        yield source if pose is None else source.at(pose)


View = tuple[Scene, Camera, Shown | None]


def _views(scenes: Iterator[Scene], cameras: Iterable[Camera], choice: Choice | None) -> Iterator[View]:
    for number, camera in enumerate(cameras):
        _check_camera(number, camera)
        scene = next(scenes, None)
        if scene is None:
            raise ValueError(f"at: expected a pose for each camera, got {number}")
        drawn, shown = (scene, None) if choice is None else choice(scene, camera)
        yield drawn, camera, shown


def _traced(how: Painter, views: Iterator[View]) -> Iterator[Frame]:
    for scene, camera, shown in views:
        yield said(Frame(camera, scene._core.origin, **how.trace(scene, camera, None)), shown)


def _drawn(how: Painter, device: _core.GpuDevice, views: Iterator[View]) -> Iterator[Frame]:
    under_way: list[tuple[View, _core.GpuJob]] = []
    wrong: Exception | None = None
    while wrong is None:
        try:
            view = next(views)
            under_way.append((view, how.begin(device, *view[:2], None)))
        except StopIteration:
            break
        except Exception as error:
            # What was begun before it comes before it.
            wrong = error
        if len(under_way) == AHEAD:
            yield _finished(*under_way.pop(0))
    while under_way:
        yield _finished(*under_way.pop(0))
    if wrong is not None:
        raise wrong


def _finished(view: View, job: _core.GpuJob) -> Frame:
    scene, camera, shown = view
    return said(Frame(camera, scene._core.origin, **job.finish()), shown)
