"""Draws pictures of a tree: views of the cut as splats, and the nearest leaves and moving objects as geometry.

`OpenStore` is a store at one of its generations; a newer generation takes over its unchanged views and leaves.
"""

from __future__ import annotations

import threading
from abc import abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import check, formats
from nearfar._base.errors import FormatError
from nearfar._camera.camera import Camera
from nearfar._camera.shot import Shot, check_request
from nearfar._render.renderable import Images, Renderable, Report
from nearfar._scene.joined import join_scenes
from nearfar._scene.scene import Scene
from nearfar.orthoview import _store
from nearfar.orthoview._budget import Fitter
from nearfar.orthoview._chunks import Chunks
from nearfar.orthoview._cut import Cutter, Settings, grid_of
from nearfar.orthoview._files import Files, Local
from nearfar.orthoview._geometry_store import names
from nearfar.orthoview._grid import Grid, Place, place_of
from nearfar.orthoview._layout import Layout, ViewKey
from nearfar.orthoview._near import Near
from nearfar.orthoview._unfinished import UnfinishedFiles, open_store
from nearfar.orthoview._views import Views

AVERAGED = ("color", "coverage")
"""Channels averaged over all samples of a pixel; the others are taken at its centre."""


class OrthoRenderable(Renderable):
    """Base class of renderables that draw orthoviews."""

    _movers: Scene | None
    """Moving objects."""

    @property
    def default_channels(self) -> tuple[str, ...]:
        """Images that are computed by default."""
        return ("color", "range")

    @property
    def backends(self) -> tuple[str, ...]:
        """Backends that can render this source."""
        return ("cpu", "gpu")

    @property
    def object_names(self) -> tuple[str, ...]:
        """Names of all moving objects, by number."""
        return () if self._movers is None else self._movers.object_names

    @property
    def poses(self) -> dict[str, NDArray[np.float64]]:
        """Present poses (4, 4), object→world, of the moving objects, as `at` takes them."""
        return {} if self._movers is None else self._movers.poses

    def trace(self, shot: Shot, report: Report = None) -> Sequence[Images]:
        """Draw the pictures of a shot on the CPU, one for each camera; `nearfar.render` makes frames of them."""
        check_request(shot, report)
        return self._pictures(shot, None, report)

    def begin(self, device: _core.GpuDevice, shot: Shot, report: Report = None) -> Sequence[FinishedPicture]:
        """Draw the pictures of a shot on a device, one for each camera."""
        check_request(shot, report)
        checked_device = check.instance("device", device, _core.GpuDevice)
        return [FinishedPicture(images) for images in self._pictures(shot, checked_device, report)]

    @abstractmethod
    def _pictures(self, shot: Shot, device: _core.GpuDevice | None, report: Report) -> list[Images]:
        """Draw the pictures of a shot on a device, or without one on the CPU."""


@dataclass(frozen=True)
class FinishedPicture:
    images: dict[str, Any]

    def finish(self, report: Report = None) -> Images:
        return self.images


@dataclass(frozen=True)
class Parts:
    """Splats and geometry of a picture."""

    splats: list[_core.OrthoSplats]
    near: Scene | None
    """Leaves drawn as geometry."""
    movers: Scene | None
    """Moving objects."""
    counts: dict[str, float]
    """Counts of the cut, for `stats`."""


class Viewer:
    """Draws a tree."""

    def __init__(self, cutter: Cutter, views: Views, near: Near, failed: int = 0) -> None:
        self.cutter, self.views, self.near, self.failed = cutter, views, near, failed
        self._fitter = Fitter(cutter, views)
        self._lock = threading.Lock()

    @property
    def origin(self) -> NDArray[np.float64]:
        """World position (3,) that positions in pictures are relative to, metres."""
        return self.near.origin

    def draw(
        self,
        shot: Shot,
        settings: Settings,
        movers: Scene | None = None,
        report: Report = None,
        device: _core.GpuDevice | None = None,
    ) -> list[Images]:
        """Draw the pictures of a shot with moving objects, one for each camera."""
        parts_by_camera = ((camera, self._gather(camera, settings, movers)) for camera in shot.cameras)
        return [self.picture(camera, shot, parts, report, device) for camera, parts in parts_by_camera]

    def picture(
        self, camera: Camera, shot: Shot, parts: Parts, report: Report = None, device: _core.GpuDevice | None = None
    ) -> Images:
        """Draw the picture of one of a shot's cameras from given parts, on a device or on the CPU."""
        grid = grid_of(shot.samples)
        averaged = tuple(name for name in shot.channels if name in AVERAGED)
        central = tuple(name for name in shot.channels if name not in AVERAGED)
        if averaged and central and grid > 1:
            passes = [(1, central), (grid, averaged)]  # the splat at a pixel's centre must not depend on `samples`
        else:
            passes = [(grid if averaged else 1, shot.channels)]
        images: Images = {}
        x, y, z = self.origin.tolist()
        for samples, channels in passes:
            request = replace(shot, cameras=(camera,), channels=channels)
            drawn = _core.splat_orthoviews(
                parts.splats,
                camera._core,
                request.settings,
                origin=(x, y, z),
                grid=samples,
                before=_geometry(parts, self.origin, camera, request, samples, device),
                report=report,
                device=device,
            )
            stats = drawn["stats"] | parts.counts | {"failed": self.failed}
            images |= {"stats": stats} | {name: drawn[name] for name in channels}
        return images

    def _gather(self, camera: Camera, settings: Settings, movers: Scene | None) -> Parts:
        """Read a picture's parts, one picture at a time: threads may share the viewer."""
        with self._lock:
            fitted = self._fitter.fit(camera, settings)
            near_leaves = self.near.scene(self.cutter.with_guests(fitted.cut.leaf_places()))
            counts = {"cells": len(fitted.cut), "views": len(fitted.layers), "leaves": len(fitted.cut.leaves)}
            counts |= {"unbuilt": fitted.cut.unbuilt}
            return Parts(fitted.splats, near_leaves, movers, {**counts, "error_px": fitted.error_px})


def _geometry(
    parts: Parts, origin: NDArray[np.float64], camera: Camera, shot: Shot, grid: int, device: _core.GpuDevice | None
) -> dict[str, Any] | None:
    """Render geometry and moving objects, with a pixel for each sample."""
    scenes = [scene for scene in (parts.near, parts.movers) if scene is not None]
    if not scenes:
        return None
    scene = join_scenes(scenes) if len(scenes) > 1 else scenes[0]
    width, height = camera.size
    finer = replace(camera, size=(width * grid, height * grid))
    mask = None if shot.mask is None else np.repeat(np.repeat(shot.mask, grid, axis=0), grid, axis=1)
    channels = tuple(dict.fromkeys((*shot.channels, "range")))
    request = replace(shot, cameras=(finer,), channels=channels, samples=1, mask=mask)
    (images,) = scene.trace(request) if device is None else [job.finish() for job in scene.begin(device, request)]
    result = dict(images)
    if "position" in result:
        result["position"] += (scene.origin - origin).astype(np.float32)
    if "object_id" in result and parts.movers is not None:
        result["object_id"] = _object_numbers(scene, parts.movers)[result["object_id"]]
    return result


def _object_numbers(scene: Scene, movers: Scene) -> NDArray[np.int32]:
    """Map a scene's object numbers to numbers of moving objects, −1 for other objects; the last entry is for misses."""
    numbers = {name: number for number, name in enumerate(movers.object_names)}
    return np.array([*(numbers.get(name, -1) for name in scene.object_names), -1], np.int32)


@dataclass(frozen=True)
class OpenStore:
    """A store that is open for viewing, at one of its generations."""

    files: Files
    layout: Layout
    generation: int
    cache_bytes: int
    chunks: Chunks
    read_cells: Callable[[int, Place], _store.Cells]
    """Reads the cells of a subtree by its tier and place."""
    viewer: Viewer

    @classmethod
    def from_files(
        cls, files: Files, layout: Layout, generation: int, cache_bytes: int, *, failed: int = 0
    ) -> OpenStore:
        """Open a generation of a store; `failed` is its number of failed leaves."""
        chunks, read_cells = _store.open_generation(files, layout, generation)
        views = Views(files.address, chunks, layout, cache_bytes)
        near = Near(files.address, chunks, layout.grid, cache_bytes)
        viewer = Viewer(Cutter(layout, read_cells), views, near, failed)
        return cls(files, layout, generation, cache_bytes, chunks, read_cells, viewer)

    @property
    def grid(self) -> Grid:
        return self.layout.grid

    @property
    def units(self) -> NDArray[np.float64]:
        """Unit vectors (D, 3) of the tree's directions."""
        return np.array([_core.orthoview_axes(direction)[0][2] for direction in self.layout.directions])

    def newer(self) -> OpenStore | None:
        """Open the newest generation, with the unchanged views and leaves of this one; None if this is the newest.

        Before the build has ended, open the cells written by now; None if nothing was written since.
        """
        older = self.files
        files, attributes, layout = open_store(Local(older.folder) if isinstance(older, UnfinishedFiles) else older)
        with formats.guarded(f"{files.address}/{_store.DOCUMENT}"):
            newest, failed = int(attributes["generation"]), [place_of(name) for name in attributes["failed"]]
        if isinstance(older, UnfinishedFiles):
            is_same = isinstance(files, UnfinishedFiles) and files.snapshot == older.snapshot
        else:
            is_same = newest <= self.generation
        if is_same:
            return None
        if layout != self.layout:
            raise FormatError(f"{files.address}: the folder now holds another tree; open it again")
        opened = OpenStore.from_files(files, layout, newest, self.cache_bytes, failed=len(failed))
        overlays = _store.overlays(files, newest)[: newest - self.generation]
        repeated = {place_of(name) for name in older.snapshot.failed} if isinstance(older, UnfinishedFiles) else set()

        def may_view_differ(view: ViewKey) -> bool:
            """Whether a newer generation has the view's shard, or a failed leaf in the cell was built again."""
            level, place, _ = view
            if any(tuple(number >> level for number in leaf) == place for leaf in repeated):
                return True
            path = self.layout.shard_path(self.layout.key(view))
            return any(path in overlay.shards for overlay in overlays)

        def is_leaf_changed(place: Place) -> bool:
            # A leaf without geometry may have been unbuilt.
            was_unbuilt = isinstance(older, UnfinishedFiles) and self.viewer.near.cache.values.get(place) is None
            return (
                was_unbuilt
                or place in repeated
                or any(name in overlay.geometry for overlay in overlays for name in names(self.grid, place))
            )

        opened.viewer.views.take_over(self.viewer.views, may_view_differ)
        opened.viewer.near.cache.take_over(self.viewer.near.cache, is_leaf_changed)
        return opened
