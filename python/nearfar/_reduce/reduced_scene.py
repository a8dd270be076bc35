"""Reduced scenes: what a thin client holds, its pictures, and its files."""

from __future__ import annotations

import copy
import math
import os
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import progress
from nearfar._camera.camera import Camera
from nearfar._camera.shot import Shot
from nearfar._cubemap import envmap
from nearfar._cubemap.envmap import EnvMap
from nearfar._partition.partition import Partition, partition
from nearfar._reduce import folder
from nearfar._reduce.drawing import Drawing, check_morph, morphed
from nearfar._render import backend as backends
from nearfar._render.frame import Frame
from nearfar._render.level_choice import Lod
from nearfar._render.renderable import Images, Report
from nearfar._render.renderer import Renderer
from nearfar._scene.levels import Leveled, levels_of
from nearfar._scene.scene import Scene


class ReducedScene:
    """A scene made light: near geometry that follows the user, before a map of what is far.

    Made by `reduce` or read by `load`. The scene's meshes are shared, not copied, except for the near triangles
    (`stats`).
    """

    def __init__(
        self,
        scene: Scene,
        zones: Partition,
        env: EnvMap | None,
        *,
        morph: str,
        boundary: str,
        counts: dict[str, int],
        is_whole: bool = True,
    ) -> None:
        self._scene, self._partition, self._env = scene, zones, env
        self._morph, self._boundary, self._counts, self._is_whole = morph, boundary, counts, is_whole
        self._unposed, self._poses = scene, dict[str, ArrayLike]()
        self._drawing = Drawing()
        self._at_levels: tuple[NDArray[np.int64], ReducedScene] | None = None
        radius = zones.r1 if boundary == "r1" else zones.r2
        channels = {} if env is None else {name: _rows(getattr(env, name)) for name in env.channels}
        size = 0 if env is None else env.face_size
        with progress.bar("gathering near geometry") as report:
            self._core = _core.Reduced(zones._core, morph=morph, boundary=radius, size=size, **channels, report=report)

    @property
    def scene(self) -> Scene:
        """The scene that was reduced; of a loaded one what was saved, its near part."""
        return self._scene

    @property
    def partition(self) -> Partition:
        """Which triangles are near and which are far."""
        return self._partition

    @property
    def env(self) -> EnvMap | None:
        """What surrounds the centre; None where nothing lies beyond the near part."""
        return self._env

    @property
    def center(self) -> tuple[float, float, float]:
        """World position of the centre O, metres."""
        return self._partition.center

    @property
    def r1(self) -> float:
        """Radius in metres inside which nothing is morphed."""
        return self._partition.r1

    @property
    def r2(self) -> float:
        """Radius in metres beyond which only the map is seen."""
        return self._partition.r2

    @property
    def morph(self) -> str:
        """How near and far part are joined: "blend", "cylinder" or "none"."""
        return self._morph

    @property
    def stats(self) -> dict[str, Any]:
        """Count what is left and what was needed.

        Returns
        -------
        dict
            `triangles` of the scene, `near`, `intermediate`, `nsf` and `sf` as in `Partition.summary`; `drawn`, the
            triangles that a client draws, and `reduction` = triangles / drawn; `map_bytes`, `near_bytes` (copies of
            near geometry); `rays` (0 where a graphics adapter baked) and `ranges_computed` while baking; of the last
            frame `frame_triangles` (after splitting; 0 where the scene's own trees were used), `dynamic_triangles`
            (moving ones that were looked for; 0 where there was no pass for them), `tolerance_held` (whether
            `tolerance_px` was a bound for "vertex": "blend", and a user at the camera, within 0.6 r1 of the centre) and
            `opposed_directions` (vertices that user and centre see in opposite directions, which happens only outside
            the near cylinder).
        """
        counts = self._counts
        triangles, moving, opposed, bounded = self._core.last_frame()
        return {
            **{name: counts[name] for name in ("triangles", "near", "intermediate", "nsf", "sf")},
            "drawn": self.triangle_count,
            "reduction": counts["triangles"] / max(self.triangle_count, 1),
            "map_bytes": 0 if self._env is None else self._env.nbytes,
            "near_bytes": self._core.near_bytes,
            "rays": counts["rays"],
            "ranges_computed": 0 if self._env is None or self._env.range is None else self._env.range.size,
            "frame_triangles": triangles,
            "dynamic_triangles": moving,
            "tolerance_held": bounded,
            "opposed_directions": opposed,
        }

    def render(
        self,
        camera: Camera,
        *,
        at: Mapping[str, ArrayLike] | None = None,
        user: ArrayLike | None = None,
        t_min: float = 0.0,
        t_max: float = math.inf,
        samples: int = 1,
        channels: Iterable[str] | None = None,
        lod: Lod | None = None,
        method: str = "vertex",
        env: bool = True,
        tolerance_px: float | None = None,
        backend: str = "auto",
    ) -> Frame:
        """Render what a thin client shows.

        Parameters
        ----------
        camera
            The view.
        at
            Poses of moving objects, as in `Scene.at`. They are seen wherever they are, never in the map; beyond the
            near part in the direction in which the centre sees them, where nothing in the map is nearer.
        user
            World position (3,) of the eye U that near geometry is bent for; by default the camera's. Another camera,
            such as one of two eyes, sees the bent geometry from where it is, before the map along its own directions.
        t_min, t_max
            Metres along each pixel's ray between which near geometry and moving objects are seen, by the displayed
            distance. The map is seen only where `t_max` is infinite and its range, if it has any, is at least `t_min`.
        samples
            Colour samples of each pixel; all other images are taken at the pixel's centre.
        channels
            Images to compute, as in `render`; by default colour, and range and object_id where far pixels have them.
            Far pixels have the channels that were baked, the point of the map's range as position, face_id −1 and
            no normal. `range` is the displayed distance, `position` and `normal` are unmorphed.
        lod
            Levels of detail of near objects, as `nearfar.render` takes it, for scenes whose objects have some. What is
            far is in the map, at the levels that were baked. When levels change, near geometry is gathered anew.
        method
            "vertex": the morph moves vertices, as a vertex shader would. "exact": every pixel shows what its bent ray
            (`bend_rays`) meets in the unmorphed scene.
        env
            False for the ideal picture of the method: what is far is traced from the centre instead of taken from the
            map, so that all channels are there.
        tolerance_px
            By how many of the image's finest pixels triangles may miss the morph of their points, by default 0.5:
            larger ones are split for this frame. A bound where `stats` says `tolerance_held`. Infinity morphs the
            vertices that there are, which bends long triangles wrongly and opens breaks at both radii. For "exact" by
            how many pixels, as large as they are where it passes, a bent ray may miss its curve, by default 0.1.
        backend
            "cpu", "gpu" or "auto", as in `render`. On a graphics adapter near triangles are split once for users about
            as far from the centre, not for each frame, and objects that move are split only where their edges are too
            long, so that a frame sends a transform for each. The map's colours are half floats there, at most 65,504.
            "exact" is for the CPU: "auto" leaves it there.

        Returns
        -------
        Frame
            The same bytes for any number of threads.

        Raises
        ------
        ValueError, TypeError
            For arguments out of their domains, for a range or object_id that was not baked, for `env` False where what
            is far was not saved, for parallel rays where there is a map or rays are bent, which show what one eye
            sees, for "exact" with "gpu" or a `user` apart from the camera, and for parts of rays with "exact" or `env`
            False.
        DeviceError
            As `render`.
        """
        drawn = self._drawn_by(Drawing.checked(method, env, tolerance_px))
        if backends.check(backend) == "gpu" and "gpu" not in drawn.backends:
            raise ValueError("method: expected 'vertex' with backend='gpu', got 'exact': rays are bent on the CPU")
        renderer = Renderer(drawn, channels, samples, lod)
        (frame,) = renderer.frames(renderer.shot([camera], user, t_min, t_max), at, renderer.device(backend, self))
        return frame

    @property
    def origin(self) -> NDArray[np.float64]:
        """World position (3,) that `Frame.position` is relative to: the scene's."""
        return self._scene.origin

    @property
    def default_channels(self) -> tuple[str, ...]:
        """Images that are computed where nobody says which: those that far pixels have."""
        if self._env is None or not self._drawing.env:
            return envmap.CHANNELS
        return self._env.channels

    @property
    def backends(self) -> tuple[str, ...]:
        """Where pictures can be made: rays are bent on the CPU alone."""
        bends = self._drawing.method == "exact" and self._morph != "none"
        return ("cpu",) if bends else ("cpu", "gpu")

    @property
    def triangle_count(self) -> int:
        """Triangles that a client draws."""
        return self._counts["nsf" if self._boundary == "r2" else "nsf_at_r1"]

    def at(self, poses: Mapping[str, ArrayLike]) -> ReducedScene:
        """Return the same reduced scene with dynamic objects in other places, as `Scene.at` does."""
        posed = copy.copy(self)
        posed._scene, posed._poses = self._scene.at(poses), {**self._poses, **poses}
        return posed

    def at_levels(self, levels: ArrayLike | Mapping[str, int]) -> ReducedScene:
        """Return the same reduced scene with near objects at these levels of detail, before the same map.

        Parameters
        ----------
        levels
            As `Scene.at_levels` takes them. Objects that are far are in the map, at the levels that were baked.

        Raises
        ------
        ValueError, TypeError
            As `Scene.at_levels`.
        """
        leveled = self._scene.leveled
        if leveled is None:
            raise ValueError("lod: expected a scene whose objects have levels, got one without; see Scene.with_levels")
        chosen = levels_of("levels", levels, leveled)
        if self._at_levels is None or not np.array_equal(self._at_levels[0], chosen):
            scene = self._unposed.at_levels(chosen)
            zones = partition(scene, center=self.center, r1=self.r1, r2=self.r2)
            self._at_levels = chosen, self._with(scene, zones, self._counts | zones.summary())
        left_out = {name for name, level in zip(leveled.names, chosen.tolist(), strict=True) if level < 0}
        poses = {name: pose for name, pose in self._poses.items() if name not in left_out}
        found = self._at_levels[1]
        return found.at(poses) if poses else found

    def shown_to(self, user: ArrayLike) -> Leveled | None:
        """Objects that have levels, where a user at a world position (3,) sees them: the morph moves their spheres."""
        leveled = self._scene.leveled
        if leveled is None or self._morph == "none":
            return leveled
        return morphed(leveled, user, center=self.center, r1=self.r1, r2=self.r2, kind=self._morph)

    def trace(self, shot: Shot, report: Report = None) -> list[Images]:
        """Trace the pictures of a shot, one for each camera."""
        settings = self._settings(shot)
        return [
            self._core.render(self._scene._core, camera._core, **settings, report=report) for camera in shot.cameras
        ]

    def begin(self, device: _core.GpuDevice, shot: Shot, report: Report = None) -> list[_core.GpuJob]:
        """Begin the pictures of a shot on a graphics device, one for each camera."""
        settings = self._settings(shot)
        return [
            device.reduced(self._core, self._scene._core, camera._core, **settings, report=report)
            for camera in shot.cameras
        ]

    def _settings(self, shot: Shot) -> dict[str, Any]:
        if not (self._drawing.env or self._is_whole or self._env is None):
            raise ValueError("env: expected True for a loaded scene, whose far geometry was not saved, got False")
        drawing = self._drawing
        drawn = {"method": drawing.method, "mapped": drawing.env, "tolerance_px": drawing.tolerance}
        return {**shot.settings, "user": shot.user, **drawn}

    def _drawn_by(self, drawing: Drawing) -> ReducedScene:
        drawn = copy.copy(self)
        drawn._drawing = drawing
        return drawn

    def _with(
        self, scene: Scene, zones: Partition, counts: dict[str, int], *, morph: str | None = None
    ) -> ReducedScene:
        """The same map around other near geometry, or joined to it in another way."""
        reduced = ReducedScene(
            scene,
            zones,
            self._env,
            morph=self._morph if morph is None else morph,
            boundary=self._boundary,
            counts=counts,
            is_whole=self._is_whole,
        )
        return reduced._drawn_by(self._drawing)

    def with_morph(self, morph: str) -> ReducedScene:
        """Join the same near part and the same map in another way, without baking anew.

        Parameters
        ----------
        morph
            "blend", "cylinder" or "none", as in `reduce`. A map baked from r1 serves "none" only.

        Raises
        ------
        ValueError
            For other names, and for a morph that this map does not reach.
        """
        check_morph(morph, self._boundary)
        return self._with(self._scene, self._partition, self._counts, morph=morph)

    def save(self, path: str | os.PathLike[str], *, half: bool = True) -> None:
        """Write a folder that other programs read, whole or not at all.

        Parameters
        ----------
        path
            The folder: `near.glb`, the geometry that is drawn, unmorphed, with objects as named nodes; `far.exr`, the
            map, where there is one (`EnvMap.save`); and `reduced.json`, which says the rest. A folder that exists is
            replaced if it is empty or one of these.
        half
            Store the map's colour as 16-bit floats, as `EnvMap.save` does. False keeps it bit for bit.

        Raises
        ------
        OSError
            Where the folder cannot be written, or holds other files.
        """
        zones = self._partition
        near = self._scene
        if self._is_whole:
            near = near.subset(triangles=zones.nsf if self._boundary == "r2" else self._drawn_at_r1())
        settings = (self.center, self.r1, self.r2, self._morph, self._boundary)
        folder.save(path, folder.Contents(near, self._env, *settings, self._counts), half=half)

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> ReducedScene:
        """Read what `save` wrote.

        It renders the same colours (with `half`, to a quarter of an 8-bit step), ranges and objects as what was saved;
        `face_id` counts the near part's triangles. What is far is in the map alone, so that `env=False` is refused.

        Raises
        ------
        FormatError
            For a file that is damaged or newer than this version reads; says which.
        OSError
            Where a file is missing.
        """
        saved = folder.load(path)
        return cls(
            saved.near,
            partition(saved.near, center=saved.center, r1=saved.r1, r2=saved.r2),
            saved.env,
            morph=saved.morph,
            boundary=saved.boundary,
            counts=saved.counts,
            is_whole=False,
        )

    def _drawn_at_r1(self) -> NDArray[np.int64]:
        """Triangles that are near or move."""
        moving = np.arange(self._scene._core.standing_triangle_count, self._scene.triangle_count)
        return np.union1d(self._partition.near, moving)

    def __repr__(self) -> str:
        stats = self.stats
        return (
            f"ReducedScene({self._morph!r}, r1={self.r1:g}, r2={self.r2:g}: {stats['drawn']:,} of "
            f"{stats['triangles']:,} triangles, map of {stats['map_bytes']:,} bytes)"
        )


def _rows(channel: Any) -> Any:
    """A map's channel as rows of texels, in the kernels' types."""
    channel = channel.astype(np.float32) if channel.dtype == np.float16 else channel
    return np.reshape(channel, (-1, 3) if channel.ndim == 4 else -1)
