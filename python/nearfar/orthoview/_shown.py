"""A tree as something that is rendered."""

from __future__ import annotations

import copy
import math
import os
from collections.abc import Iterable, Mapping
from dataclasses import replace
from functools import cached_property
from typing import Any, Self, SupportsFloat, SupportsIndex

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._camera.camera import Camera
from nearfar._camera.clip import Clip
from nearfar._camera.shot import Shot
from nearfar._render.frame import Frame
from nearfar._render.renderable import Images, Report
from nearfar._render.renderer import Renderer
from nearfar._scene.scene import Scene, core_of
from nearfar.orthoview._cut import MOST_VIEWS, OrthoCut, Settings
from nearfar.orthoview._open import Opened
from nearfar.orthoview._pictured import Pictured
from nearfar.orthoview._stored import StoredTree
from nearfar.orthoview._viewer import Viewer

MOST_SPLATS = (1 << 32) - 2
"""Greatest number of splats of a picture."""

CACHE_BYTES = 1 << 30
"""Bytes of memory for views by default."""


class ShownTree(StoredTree, Pictured):
    """A tree as `nearfar.render` takes it; `OrthoTree` tells what it raises."""

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
        return self._opened().viewer

    def _opened(self) -> Opened:
        """The store, open for a viewer of its own."""
        if not self.is_complete:
            raise ValueError(f"path: {self.path} is not complete, build it again")
        return Opened.of(self._files, self._layout, self.generation, self._cache_bytes)

    def __getstate__(self) -> dict[str, Any]:
        """Leave out the views that are kept: another process reads them itself."""
        return {name: value for name, value in self.__dict__.items() if name != "_viewer"}

    def with_dynamic(self, scene: Scene) -> Self:
        """Return the same tree with objects that move, which pictures show before and behind it by their distance.

        Parameters
        ----------
        scene
            The objects, at their first poses. They are drawn as geometry, and `object_id` numbers them; it is −1 on all
            else.

        Raises
        ------
        TypeError
            Something that is no scene.
        """
        core_of(scene)
        return self._with(scene.with_dynamic(scene.object_names))

    def at(self, poses: Mapping[str, ArrayLike]) -> Self:
        """Return the same tree with objects that move in other poses; `poses` as in `Scene.at`."""
        if self._movers is None:
            return super().at(poses)
        return self._with(self._movers.at(poses))

    def _with(self, movers: Scene) -> Self:
        shown = copy.copy(self)
        shown.__dict__["_viewer"] = self._viewer  # views that it reads are kept for the next picture
        shown._movers = movers
        return shown

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
        """Return the cells that a viewer sees: leaves near it as geometry, others from views, the coarser the farther.

        Parameters
        ----------
        camera
            The view.
        views
            Number of views of a cell, 1 to 8: of those that show something the ones whose directions are nearest to the
            viewer's.
        error_px
            Greatest width of a view's pixels, in pixels of the picture. 2 suits thin clients: cells
            are drawn from half as far.
        geometry
            Whether leaves so near that their views are too coarse are drawn as geometry, where the tree has it; else
            views are drawn at any distance.
        around
            Whether cells outside of the picture count, too: viewers turn faster than views arrive.
        continuous
            Whether levels change splat by splat: then cells of two levels are drawn in a band of distances, some splats
            of each.
        gaze
            Place in the picture that the viewer looks at, pixels: `error_px` is over `nearfar.lod.acuity` beside it, at
            the least angle of a cell's points. None for a picture that is equally fine everywhere.
        lift_deg
            Degrees, 0 to 90, by which the viewer's direction is raised towards the zenith (+y), at most to it, before
            the nearest views are chosen; straight down stays. For viewers above and directions of the upper half.

        Returns
        -------
        OrthoCut
            With a reach r of p/(t `error_px`), where p is the width of a leaf's pixel and t that of the picture's at a
            distance of 1 m, cells of level k are drawn from views if they are no nearer than 2ᵏ r.

        Raises
        ------
        ValueError
            Values out of range; a tree that is not complete.
        TypeError
            Something that is no camera, values of a wrong kind.
        FormatError, OSError
            A record of the store that is damaged, or that cannot be read.

        References
        ----------
        Chaudhuri et al., A System for View-Dependent Rendering of Very Large Scenes Using Orthoviews, section 4.2.
        """
        settings = settings_of(views, error_px, geometry, continuous, gaze, lift_deg)
        own = check.instance("camera", camera, Camera)
        return self._viewer.cutter.whole(own, settings, around=check.flag("around", around))

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
        t_min: float = 0.0,
        t_max: float = math.inf,
        clip: Clip | None = None,
        samples: int = 1,
        channels: Iterable[str] | None = None,
        backend: str | None = None,
    ) -> Frame:
        """Draw a picture from any viewpoint: the views of the cut as splats, and the nearest leaves as geometry.

        Parameters
        ----------
        camera
            The view, with any projection.
        views, error_px, geometry, continuous, gaze, lift_deg
            As in `cut`.
        budget
            Greatest number of splats in `stats`, None for any: the error is the least one from `error_px` on for which
            they are no more. Where no error is great enough, views are left out.
        t_min, t_max, clip
            As in `nearfar.render`; a splat is drawn if its middle is within them.
        samples
            Number of colour samples of each pixel, on a grid: 1, 4, 9 … 64.
        channels
            Images to compute, as in `nearfar.render`: splats have "color", "coverage", "range", "position", "normal",
            "albedo" and "shading_normal"; where they are seen, `object_id` and `face_id` are −1. On geometry these are
            numbers within this picture alone, see `with_dynamic`. The default is colour and range.
        backend
            As in `nearfar.render`. On an adapter views stay in its memory, without loss and in fewer bytes.

        Returns
        -------
        Frame
            The bytes are the same for any number of threads. Both backends evaluate the same formulas; where a splat's
            edge passes through a sample's place, or two splats are equally near, either may be shown. `stats` has the
            `error_px` that was chosen and counts the `cells` and `views` of the cut, its `leaves` of geometry, all
            `splats` of the views, `splats_in_picture` of parts that reach into it, `splats_seen` of those that are not
            hidden, and `splats_projected`, on the CPU once for each tile of the screen.

        Raises
        ------
        ValueError
            Values out of range; a tree that is not complete.
        TypeError
            Something that is no camera, values of a wrong kind.
        DeviceError
            As in `nearfar.render`; a picture whose views do not fit into the adapter's memory.
        FormatError, OSError
            A part of the store that is damaged, or that cannot be read.

        References
        ----------
        Chaudhuri et al., A System for View-Dependent Rendering of Very Large Scenes Using Orthoviews, section 4.
        """
        shown = copy.copy(self)
        shown.__dict__["_viewer"] = self._viewer  # views that it reads are kept for the next picture
        settings = settings_of(views, error_px, geometry, continuous, gaze, lift_deg)
        shown._settings = replace(
            settings, budget=None if budget is None else check.integer("budget", budget, 1, MOST_SPLATS)
        )
        renderer = Renderer(shown, channels, samples, argument="tree")
        shot = renderer.shot([camera], None, t_min, t_max, clip)
        (frame,) = renderer.frames(shot, None, renderer.device(backend, self))
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
    """The settings that a caller asks for."""
    return Settings(
        views=check.integer("views", views, 1, MOST_VIEWS),
        error_px=check.positive("error_px", error_px),
        geometry=check.flag("geometry", geometry),
        continuous=check.flag("continuous", continuous),
        gaze=None if gaze is None else _pixel(gaze),
        lift_deg=check.within("lift_deg", lift_deg, 0.0, 90.0),
    )


def _pixel(gaze: ArrayLike) -> tuple[float, float]:
    place = check.array("gaze", gaze, columns=None, dtype=np.float64)
    if place.shape != (2,):
        raise ValueError(f"gaze: expected two numbers or None, got an array of shape {place.shape}")
    return check.number("gaze", place[0]), check.number("gaze", place[1])
