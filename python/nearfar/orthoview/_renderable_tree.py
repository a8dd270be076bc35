"""The `RenderableTree` class: a tree that `nearfar.render` draws."""

from __future__ import annotations

import copy
import os
from collections.abc import Mapping
from dataclasses import replace
from functools import cached_property
from typing import Any, Self, SupportsFloat, SupportsIndex, Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._base.settings import gather
from nearfar._camera.camera import Camera
from nearfar._camera.shot import Shot
from nearfar._render.frame import Frame
from nearfar._render.renderable import Images, Report
from nearfar._render.renderer import Renderer
from nearfar._render.settings import RenderKeywords, RenderSettings
from nearfar._scene.scene import Scene, core_of
from nearfar.orthoview._cut import MAX_VIEWS, OrthoCut, Settings
from nearfar.orthoview._files import Files
from nearfar.orthoview._stored import StoredTree
from nearfar.orthoview._viewer import OpenStore, OrthoRenderable, Viewer

MAX_SPLATS = (1 << 32) - 2
"""Maximum number of splats of a picture."""

CACHE_BYTES = 1 << 30
"""Default size of the view cache, bytes."""


class RenderableTree(StoredTree, OrthoRenderable):
    """A tree for `nearfar.render`; for errors see `OrthoTree`."""

    def __init__(self, path: str | os.PathLike[str], *, cache_bytes: SupportsIndex = CACHE_BYTES) -> None:
        super().__init__(path)
        self._cache_bytes = check.integer("cache_bytes", cache_bytes, 0, 1 << 62)
        self._settings = Settings()
        self._movers: Scene | None = None

    @property
    def origin(self) -> NDArray[np.float64]:
        """World position (3,) in metres that `Frame.position` is relative to."""
        return self._viewer.origin

    @cached_property
    def _viewer(self) -> Viewer:
        return self._open_store().viewer

    def _open_store(self, files: Files | None = None) -> OpenStore:
        """Open the store for drawing; `files` replaces the reader of its files."""
        self._require_records()
        return OpenStore.from_files(
            files or self._files, self._layout, self.generation, self._cache_bytes, failed=len(self._failed)
        )

    def __getstate__(self) -> dict[str, Any]:
        """Pickle without cached views, which another process reads again."""
        return {name: value for name, value in self.__dict__.items() if name != "_viewer"}

    def with_dynamic(self, scene: Scene) -> Self:
        """Return the same tree with a scene's moving objects, which are drawn as geometry with correct occlusion.

        The objects have their initial poses. `object_id` numbers them, and is −1 elsewhere. TypeError for a value that
        is not a scene.
        """
        core_of(scene)
        return self._copy(_movers=scene.with_dynamic(scene.object_names))

    def at(self, poses: Mapping[str, ArrayLike]) -> Self:
        """Return the same tree with moving objects in other poses; `poses` as in `Scene.at`."""
        if self._movers is None:
            return super().at(poses)
        return self._copy(_movers=self._movers.at(poses))

    def _copy(self, **changes: Any) -> Self:
        """Copy the tree with changed attributes; the copy shares the cache of views."""
        tree = copy.copy(self)
        tree.__dict__.update(changes, _viewer=self._viewer)
        return tree

    def cut(
        self,
        camera: Camera,
        *,
        views: SupportsIndex = 3,
        error_px: SupportsFloat = 1.0,
        geometry: bool = True,
        around: bool = False,
        continuous: bool = False,
        gaze: ArrayLike | None = None,
        lift_deg: SupportsFloat = 0.0,
    ) -> OrthoCut:
        """Return the cells that a viewer sees: near leaves as geometry, others from views, coarser with distance.

        Cells of level k are drawn from views at distances of at least 2ᵏ r. The reach r is p/(t `error_px`), where p is
        the width of a leaf's pixel and t the width of a picture's pixel at a distance of 1 m. ValueError for values out
        of range, TypeError for a value that is not a camera, or values of a wrong type; FormatError and OSError for a
        damaged or unreadable record of the store. Source: Chaudhuri et al. (2009), Image-Based Exploration of Massive
        Online Environments, section 4.2.

        Parameters
        ----------
        camera
            The view.
        views
            Number of views of a cell, 1 to 8: the non-empty views whose directions are nearest to the viewer's.
        error_px
            Greatest width of a view's pixels, in pixels of the picture. 2 suits thin clients: cells are drawn from half
            as far.
        geometry
            Whether leaves are drawn as geometry where their views are too coarse, if the tree has geometry. Otherwise
            views are drawn at any distance.
        around
            Whether to include cells outside the picture: viewers turn faster than views arrive.
        continuous
            Whether levels blend splat by splat: in a band of distances, some splats of each of two levels are drawn.
        gaze
            Pixel that the viewer looks at. `error_px` of a cell is divided by `nearfar.lod.acuity` of the least angle
            between the gaze and the cell's points. None for a picture of uniform resolution.
        lift_deg
            Degrees, 0 to 90, by which the viewer's direction is raised towards the zenith (+y), at most to it, before
            the nearest views are chosen; a view straight down stays. It suits viewers above a world with views from the
            upper half of the sphere.
        """
        settings = settings_of(views, error_px, geometry, continuous, gaze, lift_deg)
        checked_camera = check.instance("camera", camera, Camera)
        return self._viewer.cutter.complete_cut(checked_camera, settings, around=check.flag("around", around))

    def render(
        self,
        camera: Camera,
        *,
        views: SupportsIndex = 3,
        error_px: SupportsFloat = 1.0,
        geometry: bool = True,
        continuous: bool = False,
        gaze: ArrayLike | None = None,
        lift_deg: SupportsFloat = 0.0,
        budget: SupportsIndex | None = None,
        settings: RenderSettings | None = None,
        **keywords: Unpack[RenderKeywords],
    ) -> Frame:
        """Draw a picture from any viewpoint: the views of the cut as splats, and the nearest leaves as geometry.

        Errors as in `cut`, also for views and geometry; DeviceError as in `nearfar.render`, or for a picture whose
        views do not fit into the adapter's memory.

        Parameters
        ----------
        camera
            The view, with any projection.
        views, error_px, geometry, continuous, gaze, lift_deg
            As in `cut`.
        budget
            Greatest number of `splats` in `stats`, None for no limit. The error is increased from `error_px` as far as
            needed; if that does not suffice, views are left out.
        settings
            Samples (on a grid: 1, 4, 9 … 64), channels, limits and backend, as `nearfar.RenderSettings`. A splat is
            drawn if its centre is within the limits. Splats have the channels "color", "coverage", "range", "position",
            "normal", "albedo" and "shading_normal"; their `object_id` and `face_id` are −1. On geometry these numbers
            are valid within this picture only, except those of moving objects (`with_dynamic`). Graphics adapters keep
            views in their memory, losslessly packed.
        keywords
            Fields of `settings`, which they replace.

        Returns
        -------
        Frame
            The bytes do not depend on the number of threads. Both backends evaluate the same formulas; where a splat's
            edge passes through a sample, or two splats are equally near, they may show different splats. `stats` has
            the chosen `error_px`; counts of the cut's `cells`, their `views`, and its `leaves` drawn as geometry;
            counts of all `splats` of the views, of `splats_in_picture` in the parts that reach into the picture, of
            `splats_seen` that are not hidden, and of `splats_projected`, on the CPU once for each tile of the screen;
            the number of leaves that `failed` in the build; and `unbuilt`, the number of the largest cells in the
            picture that an unfinished build has not reached.
        """
        cut_settings = settings_of(views, error_px, geometry, continuous, gaze, lift_deg)
        limit = None if budget is None else check.integer("budget", budget, 1, MAX_SPLATS)
        tree = self._copy(_settings=replace(cut_settings, budget=limit))
        renderer = Renderer(tree, gather(RenderSettings, settings, keywords), argument="tree")
        (frame,) = renderer.frames(renderer.shot([camera]), None, renderer.device(self))
        return frame

    def _pictures(self, shot: Shot, device: _core.GpuDevice | None, report: Report) -> list[Images]:
        return self._viewer.draw(shot, self._settings, self._movers, report, device)


def settings_of(
    views: SupportsIndex,
    error_px: SupportsFloat,
    geometry: bool,
    continuous: bool = False,
    gaze: ArrayLike | None = None,
    lift_deg: SupportsFloat = 0.0,
) -> Settings:
    """Check the arguments of a cut and return them as settings."""
    return Settings(
        views=check.integer("views", views, 1, MAX_VIEWS),
        error_px=check.positive("error_px", error_px),
        geometry=check.flag("geometry", geometry),
        continuous=check.flag("continuous", continuous),
        gaze=None if gaze is None else _pixel(gaze),
        lift_deg=check.in_range("lift_deg", lift_deg, 0.0, 90.0),
    )


def _pixel(gaze: ArrayLike) -> tuple[float, float]:
    pixel = check.array("gaze", gaze, columns=None, dtype=np.float64)
    if pixel.shape != (2,):
        raise ValueError(f"gaze: expected two numbers or None, got an array of shape {pixel.shape}")
    return check.number("gaze", pixel[0]), check.number("gaze", pixel[1])
