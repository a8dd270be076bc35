"""Draws pictures of a tree: views of the cut as splats, and the nearest leaves as geometry."""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._camera.camera import Camera
from nearfar._camera.shot import Shot
from nearfar._render.renderable import Images
from nearfar._scene.joined import join_scenes
from nearfar._scene.scene import Scene
from nearfar.orthoview._budget import Fitter
from nearfar.orthoview._cut import Cutter, Settings, grid_of
from nearfar.orthoview._near import Near
from nearfar.orthoview._views import Views

AVERAGED = ("color", "coverage")
"""Channels averaged over all samples of a pixel; the others are taken at its centre."""

Report = Callable[[int, int], None] | None


@dataclass(frozen=True)
class Parts:
    """Content of a picture."""

    splats: list[_core.OrthoSplats]
    near: Scene | None
    """Leaves drawn as geometry."""
    movers: Scene | None
    """Moving objects."""
    counts: dict[str, float]
    """Counts of the cut, for `stats`."""


class Viewer:
    """Draws a tree."""

    def __init__(self, cutter: Cutter, views: Views, near: Near) -> None:
        self.cutter, self.views, self.near = cutter, views, near
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
        sampled = tuple(name for name in shot.channels if name in AVERAGED)
        middle = tuple(name for name in shot.channels if name not in AVERAGED)
        if sampled and middle and grid > 1:
            passes = [(1, middle), (grid, sampled)]  # the splat at a pixel's centre must not depend on `samples`
        else:
            passes = [(grid if sampled else 1, shot.channels)]
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
            images |= {"stats": drawn["stats"] | parts.counts} | {name: drawn[name] for name in channels}
        return images

    def _gather(self, camera: Camera, settings: Settings, movers: Scene | None) -> Parts:
        """Read a picture's parts, one picture at a time: threads may share the viewer."""
        with self._lock:
            fitted = self._fitter.fit(camera, settings)
            near_leaves = self.near.scene(self.cutter.with_guests(fitted.cut.leaf_places()))
            counts = {"cells": len(fitted.cut), "views": len(fitted.layers), "leaves": len(fitted.cut.leaves)}
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
    """Map a scene's object numbers to those of the moving objects, −1 for others; the last entry is for misses."""
    numbers = {name: number for number, name in enumerate(movers.object_names)}
    return np.array([*(numbers.get(name, -1) for name in scene.object_names), -1], np.int32)
