"""Frames of a reduced scene: the mixin of `ReducedScene` that renders."""

from __future__ import annotations

import copy
import math
import warnings
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, Self, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar._camera.camera import Camera
from nearfar._camera.clip import Clip
from nearfar._camera.shot import Shot, check_begin, check_request
from nearfar._cubemap.envmap import EnvMap
from nearfar._morph import morph
from nearfar._partition.partition import Partition
from nearfar._reduce.drawing import Drawing
from nearfar._render import backend as backends
from nearfar._render.frame import Frame
from nearfar._render.level_choice import Lod
from nearfar._render.renderable import Images, Renderable, Report
from nearfar._render.renderer import Renderer
from nearfar._scene.scene import Scene

if TYPE_CHECKING:
    from nearfar._core import GpuDevice, GpuJob, Reduced


class InPictures:
    """Mixin that renders a reduced scene."""

    _scene: Scene
    _partition: Partition
    _boundary: str
    _env: EnvMap | None
    _morph: str
    _core: Reduced
    _drawing: Drawing
    _is_whole: bool
    _has_warned: list[bool]
    """Whether a folded picture was reported: one entry, shared by copies."""

    def render(
        self,
        camera: Camera,
        *,
        at: Mapping[str, ArrayLike] | None = None,
        user: ArrayLike | None = None,
        t_min: float = 0.0,
        t_max: float = math.inf,
        clip: Clip | None = None,
        samples: int = 1,
        channels: Iterable[str] | None = None,
        lod: Lod | None = None,
        radius: float | None = None,
        strength: float | None = None,
        method: str = "auto",
        env: bool = True,
        tolerance_px: float | None = None,
        conventional_dynamic: str = "center",
        backend: str | None = None,
    ) -> Frame:
        """Render the picture that a thin client shows.

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
        t_min, t_max
            Limits in metres of the displayed distance along each pixel's ray, for near geometry and moving objects. The
            map is drawn only if `t_max` is infinite and its range, where it has one, is at least `t_min`.
        clip
            Planes and a box that limit what is visible, by displayed position. The map is drawn only where no plane
            ends the ray.
        samples
            Number of colour samples of each pixel; all other images are sampled once, at the pixel's centre.
        channels
            Images to compute, as in `render`; by default the channels of the map (`default_channels`). `range`,
            `position` and `object_id` need a map that was baked with them; the position of a far pixel is the point at
            the map's range. Far pixels of a map have `face_id` −1 and no normal. `range` is the displayed distance;
            `position` and `normal` are unmorphed.
        lod
            Levels of detail of near objects, as in `nearfar.render`, for scenes whose objects have some. The map shows
            far objects at the levels that were baked. A change of levels gathers the near geometry again.
        radius
            Radius of the morph in metres in this frame instead of r2, 0 to r2; r1 shrinks in proportion. Near geometry
            beyond it is drawn, too, as seen from the centre; with 0 that is everything. A client that increases it over
            several frames shows near geometry without a jump. Not for the conventional method.
        strength
            Factor of the weight of the user's view in this frame, 0 to 1, instead of 1 or that of `with_growth`. With 0
            everything is shown as the centre sees it. Below 1 near geometry within r1 moves too, also for users for
            whom a smaller radius would fold the picture; rays are then bent one by one, which takes "exact" several
            times as long, and `tolerance_held` is False. Not for the conventional method.
        method
            "vertex": the morph moves vertices, as a vertex shader would. "exact": every pixel shows the first hit of
            its bent ray (`bend_rays`) in the unmorphed scene. "auto": "exact" where moved vertices would fold the
            picture and rays can be bent (on the CPU, for one eye, whole rays), else "vertex".
        env
            True draws the far part from the map. False traces it from the centre, so that all channels exist; this is
            the method's picture with a map of unlimited resolution.
        tolerance_px
            For "vertex": greatest distance, in the image's finest pixels, between a drawn triangle's points and their
            morph, by default 0.5; larger triangles are split for the frame. It is a proven bound if the frame's
            `stats` have `tolerance_held`. On the CPU it is doubled until splitting makes at most 4 million triangles.
            Infinity morphs only the given vertices, which bends long triangles wrongly and opens breaks at both radii.
            For "exact": greatest distance between a bent ray and its curve, in pixels of the size at its place in the
            image, by default 0.1.
        conventional_dynamic
            Where the conventional method shows moving objects beyond the near part. "center": in the direction in which
            the centre sees them, if nothing in the map is nearer. "user": in the direction in which the user sees them,
            over everything in the map, as in figure 1d of the paper. "omit": nowhere. A morph takes only "center".
        backend
            "cpu", "gpu", "auto" or None, as in `render`. On a graphics adapter near triangles are split once for all
            users at about the same distance from the centre, not for each frame, and moving objects are split only if
            their edges are too long, so that a frame sends one transform for each. The map's colours are half floats
            there, at most 65,504. "exact" runs on the CPU only, also with "auto".

        Returns
        -------
        Frame
            The bytes do not depend on the number of threads. `stats["fold_margin"]` is the distance in metres that the
            user may still walk before the picture folds (`fold_margin`, for the user's height to a thousandth of r2);
            infinite for the conventional method.

        Warns
        -----
        UserWarning
            Once for a reduced scene, when a picture folds.

        Raises
        ------
        ValueError, TypeError
            Arguments out of range; range, position or object_id of a map without range or object_id; `env` False after
            `load`, because far geometry is not saved; parallel rays with a map or bent rays, which both belong to one
            eye; "exact" with "gpu" or a `user` apart from the camera; limits of rays and `clip` with "exact" or `env`
            False; a `radius` beyond r2, or with the conventional method, as for a strength below 1; and a
            `conventional_dynamic` other than "center" with a morph.
        DeviceError
            As in `render`.
        """
        shown = self._drawing.radius if radius is None else radius
        share = self._drawing.strength if strength is None else strength
        drawn = self._drawn_by(Drawing(method, env, tolerance_px, shown, share, conventional_dynamic))
        if backends.check(backend) == "gpu" and "gpu" not in drawn.backends:
            raise ValueError("method: expected 'vertex' with backend='gpu', got 'exact': rays are bent on the CPU")
        renderer = Renderer(cast(Renderable, drawn), channels, samples, lod)
        (frame,) = renderer.frames(
            renderer.shot([camera], user, t_min, t_max, clip), at, renderer.device(backend, self)
        )
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
        places = check.array("points", points, columns=3, dtype=np.float64)
        center, eye = self._partition.center, check.vector("user", user)
        if self._morph != "none":
            grown = self._drawing.grown(self._partition.r1, self._partition.r2)
            return np.asarray(morph(places, user=eye, center=center, kind=self._morph, **grown))
        away = places - np.array(center)
        boundary = self._partition.r1 if self._boundary == "r1" else self._partition.r2
        far = np.hypot(away[:, 0], away[:, 2]) > boundary
        return np.where(far[:, None], np.array(eye) + away, places)

    def trace(self, shot: Shot, report: Report = None) -> list[Images]:
        """Trace the pictures of a shot, one for each camera."""
        check_request(shot, report)
        pictures = []
        for camera in shot.cameras:
            method = self._drawing.method
            if method == "auto":
                method = "exact" if self._margin(shot, camera) < 0.0 and self._bends(shot, camera) else "vertex"
            how = self._how(shot, camera, method)
            pictures.append(self._core.render(self._scene._core, camera._core, shot.settings, **how, report=report))
        return pictures

    def begin(self, device: GpuDevice, shot: Shot, report: Report = None) -> list[GpuJob]:
        """Start the pictures of a shot on a graphics device, one for each camera."""
        check_begin(device, shot, report)
        method = "exact" if self._drawing.method == "exact" else "vertex"
        jobs = []
        for camera in shot.cameras:
            how, scene = self._how(shot, camera, method), self._scene._core
            jobs.append(device.reduced(self._core, scene, camera._core, shot.settings, **how, report=report))
        return jobs

    def _drawn_by(self, drawing: Drawing) -> Self:
        drawn = copy.copy(self)
        drawn._drawing = drawing
        return drawn

    def _how(self, shot: Shot, camera: Camera, method: str) -> dict[str, Any]:
        """Settings of this scene's pictures for kernels, in addition to those of the shot."""
        if not (self._drawing.env or self._is_whole or self._env is None):
            raise ValueError("env: expected True for a loaded scene, whose far geometry was not saved, got False")
        margin = self._margin(shot, camera)
        if margin < 0.0 and not self._has_warned[0]:
            self._has_warned[0] = True
            beyond = f"{-margin:.3g} m beyond" if margin > -math.inf else "at a height outside of"
            message = f"the picture folds: the user is {beyond} the fold margin; go closer to the centre"
            warnings.warn(message, UserWarning, stacklevel=2)
        return {"user": shot.user, **self._drawing.settings(method)}

    def _margin(self, shot: Shot, camera: Camera) -> float:
        """Distance in metres that the user of a picture may still move before it folds."""
        user = camera.position if shot.user is None else shot.user
        return self._core.fold_margin(user, self._drawing.radius, self._drawing.strength)

    def _bends(self, shot: Shot, camera: Camera) -> bool:
        """Whether rays can be bent for a picture."""
        is_eye = shot.user is None or shot.user == camera.position
        tolerance = self._drawing.tolerance_px
        is_whole = shot.t_min == 0.0 and shot.t_max == math.inf and shot.clip is None
        is_finite = tolerance is None or math.isfinite(tolerance)
        return is_eye and is_whole and is_finite and not camera._core.is_parallel
