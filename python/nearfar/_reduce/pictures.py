"""The mixin of `ReducedScene` that renders frames."""

from __future__ import annotations

import math
import warnings
from collections.abc import Mapping
from typing import Any, Unpack, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._base.settings import gather, split
from nearfar._camera.camera import Camera
from nearfar._camera.shot import Shot, check_begin, check_request
from nearfar._morph import morph
from nearfar._reduce.data import ReducedData
from nearfar._reduce.drawing import MorphOptions, MorphSettings, fill_growth, grow_radii, kernel_settings
from nearfar._reduce.findings import explain_fold
from nearfar._render.frame import Frame
from nearfar._render.renderable import Images, Renderable, Report
from nearfar._render.renderer import Renderer
from nearfar._render.settings import RenderSettings


class RenderMixin(ReducedData):
    """Mixin that renders a reduced scene."""

    def render(
        self,
        camera: Camera,
        *,
        at: Mapping[str, ArrayLike] | None = None,
        user: ArrayLike | None = None,
        settings: RenderSettings | None = None,
        morphing: MorphSettings | None = None,
        **keywords: Unpack[MorphOptions],
    ) -> Frame:
        """Render the picture that a thin client shows.

        UserWarning once per reduced scene if a picture folds; DeviceError as in `render`. ValueError and TypeError for
        arguments out of range and for: `range`, `position` or `object_id` if the map lacks range or object numbers;
        `env` False after `load`, because far geometry is not saved; parallel rays with a map or with bent rays, which
        belong to one eye; "exact" with "gpu", or with a `user` apart from the camera; limits of rays or `clip` with
        "exact" or with `env` False; a `radius` beyond r2; a `radius`, or a strength below 1, with the conventional
        method; a `conventional_dynamic` other than "center" with a morph.

        Parameters
        ----------
        camera
            The view.
        at
            Poses of moving objects, as in `Scene.at`. Moving objects are never in the map. Beyond the near part they
            are drawn in the direction in which the centre sees them, if nothing in the map is nearer.
        user
            World position (3,), metres, of the eye U that near geometry is morphed for; by default the camera's
            position. Another camera, such as one of two eyes, sees the morphed geometry from its own position, in front
            of the map along its own directions.
        settings
            Samples, channels, limits, backend and levels of detail, as `RenderSettings`. `range`, `position` and
            `object_id` need a map that was baked with them; the position of a far pixel is the point at the map's
            range. Far pixels of a map have `face_id` −1 and no normal. `range` is the displayed distance; `position`
            and `normal` are unmorphed. A change of levels gathers the near geometry again. A graphics adapter does not
            split near triangles for each frame, but once for all users at about the same distance from the centre. It
            splits moving objects only if their edges are too long, so that a frame sends one transform for each. It
            stores the map's colours as half floats, at most 65,504.
        morphing
            Method, map, tolerance and growth of the morph, as `MorphSettings`. "exact" runs on the CPU only, also with
            the backend "auto".
        keywords
            Fields of `settings` and `morphing`, which they replace.

        Returns
        -------
        Frame
            The bytes do not depend on the number of threads. `stats["fold_margin"]` is the distance in metres that the
            user may still walk before the picture folds: `fold_margin` with the user's height rounded to a thousandth
            of r2; infinite for the conventional method.
        """
        render_keywords, morph_keywords = split(MorphSettings, keywords)
        settings = gather(RenderSettings, settings, render_keywords)
        morphing = fill_growth(gather(MorphSettings, morphing, morph_keywords, argument="morphing"), self._drawing)
        reduced = self._replace(_drawing=morphing)
        if settings.backend == "gpu" and "gpu" not in reduced.backends:
            raise ValueError("method: expected 'vertex' with backend='gpu', got 'exact': rays are bent on the CPU")
        renderer = Renderer(cast(Renderable, reduced), settings)
        (frame,) = renderer.frames(renderer.shot([camera], user), at, renderer.device(self))
        return frame

    @property
    def backends(self) -> tuple[str, ...]:
        """Backends that can render this scene; only the CPU bends rays."""
        bends = self._drawing.method == "exact" and self._morph != "none"
        return ("cpu",) if bends else ("cpu", "gpu")

    @property
    def object_names(self) -> tuple[str, ...]:
        """Names of all objects, by number."""
        return self._scene.object_names

    @property
    def poses(self) -> dict[str, NDArray[np.float64]]:
        """Present object→world (4, 4) of each dynamic object, by name, as `at` takes them."""
        return self._scene.poses

    def displayed(self, points: ArrayLike, user: ArrayLike) -> NDArray[np.float64]:
        """Return where a picture shows world positions (N, 3) to a user at a world position (3,), metres."""
        positions = check.array("points", points, columns=3, dtype=np.float64)
        center, eye = self._partition.center, check.vector("user", user)
        if self._morph != "none":
            grown = grow_radii(self._drawing, self._partition.r1, self._partition.r2)
            return np.asarray(morph(positions, user=eye, center=center, kind=self._morph, **grown))
        from_center = positions - np.array(center)
        is_far = np.hypot(from_center[:, 0], from_center[:, 2]) > self._boundary_radius
        return np.where(is_far[:, None], np.array(eye) + from_center, positions)

    def trace(self, shot: Shot, report: Report = None) -> list[Images]:
        """Trace the pictures of a shot, one for each camera."""
        check_request(shot, report)
        pictures = []
        for camera in shot.cameras:
            method: str = self._drawing.method
            if method == "auto":
                method = "exact" if self._margin(shot, camera) < 0.0 and self._can_bend(shot, camera) else "vertex"
            morphing = self._kernel_settings(shot, camera, method)
            scene = self._scene._core
            pictures.append(self._core.render(scene, camera._core, shot.settings, morphing, report=report))
        return pictures

    def begin(self, device: _core.GpuDevice, shot: Shot, report: Report = None) -> list[_core.GpuJob]:
        """Start the pictures of a shot on a graphics device, one for each camera."""
        check_begin(device, shot, report)
        method = "exact" if self._drawing.method == "exact" else "vertex"
        jobs = []
        for camera in shot.cameras:
            morphing, scene = self._kernel_settings(shot, camera, method), self._scene._core
            jobs.append(device.reduced(self._core, scene, camera._core, shot.settings, morphing, report=report))
        return jobs

    def _kernel_settings(self, shot: Shot, camera: Camera, method: str) -> dict[str, Any]:
        """Return the kernel's settings for a picture, except those of the shot."""
        if not (self._drawing.env or self._is_whole or self._env is None):
            raise ValueError("env: expected True for a loaded scene, whose far geometry was not saved, got False")
        margin = self._margin(shot, camera)
        if margin < 0.0 and not self._has_warned[0]:
            self._has_warned[0] = True
            warnings.warn(f"the picture folds: {explain_fold(margin)}", UserWarning, stacklevel=2)
        return {"user": shot.user, **kernel_settings(self._drawing, method)}

    def _margin(self, shot: Shot, camera: Camera) -> float:
        """Distance in metres that the user of a picture may still move before it folds."""
        user = camera.position if shot.user is None else shot.user
        return self._core.fold_margin(user, *self._drawing.growth)

    def _can_bend(self, shot: Shot, camera: Camera) -> bool:
        is_eye = shot.user is None or shot.user == camera.position
        is_unlimited = shot.t_min == 0.0 and shot.t_max == math.inf and shot.clip is None
        is_finite = self._drawing.tolerance_px is None or math.isfinite(self._drawing.tolerance_px)
        return is_eye and is_unlimited and is_finite and not camera._core.is_parallel
