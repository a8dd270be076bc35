"""Reduced scenes: what a thin client holds, its pictures, and its files."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check, progress
from nearfar._camera.camera import Camera
from nearfar._cubemap import envmap
from nearfar._cubemap.envmap import EnvMap
from nearfar._partition.partition import Partition, partition
from nearfar._reduce import folder
from nearfar._render import truth
from nearfar._render.frame import Frame
from nearfar._render.renderer import Painter, Report, check_camera
from nearfar._scene.scene import Scene

MORPHS = ("blend", "cylinder", "none")

TOLERANCES = {"vertex": 0.5, "exact": 0.1}
"""Pixels, for each method of rendering."""


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
            `tolerance_px` was a bound for "vertex": "blend", and a user within 0.6 r1 of the centre) and
            `opposed_directions` (vertices that user and centre see in opposite directions, which happens only outside
            the near cylinder).
        """
        counts = self._counts
        triangles, moving, opposed, bounded = self._core.last_frame()
        drawn = counts["nsf" if self._boundary == "r2" else "nsf_at_r1"]
        return {
            **{name: counts[name] for name in ("triangles", "near", "intermediate", "nsf", "sf")},
            "drawn": drawn,
            "reduction": counts["triangles"] / max(drawn, 1),
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
        samples: int = 1,
        channels: Iterable[str] | None = None,
        method: str = "vertex",
        env: bool = True,
        tolerance_px: float | None = None,
        backend: str = "auto",
    ) -> Frame:
        """Render what a thin client shows to a user at the camera's position.

        Parameters
        ----------
        camera
            The user's view.
        at
            Poses of moving objects, as in `Scene.at`. They are seen wherever they are, never in the map; beyond the
            near part in the direction in which the centre sees them, where nothing in the map is nearer.
        samples
            Colour samples of each pixel; all other images are taken at the pixel's centre.
        channels
            Images to compute, as in `render`; by default colour, and range and object_id where far pixels have them.
            Far pixels have the channels that were baked, the point of the map's range as position, face_id −1 and
            no normal. `range` is the displayed distance, `position` and `normal` are unmorphed.
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
            sees, and for "exact" with "gpu".
        DeviceError
            As `render`.
        """
        check_camera(camera)
        painter = self._painter(channels, samples, method=method, env=env, tolerance_px=tolerance_px)
        return painter.paint(self._scene if at is None else self._scene.at(at), camera, backend)

    def _painter(
        self,
        channels: Iterable[str] | None,
        samples: int,
        *,
        method: str = "vertex",
        env: bool = True,
        tolerance_px: float | None = None,
    ) -> Painter:
        """How it is seen; None stands for the default images."""
        check.choice("method", method, tuple(TOLERANCES))
        if not isinstance(env, bool):
            raise TypeError(f"env: expected True or False, got {type(env).__name__}")
        if not (env or self._is_whole or self._env is None):
            raise ValueError("env: expected True for a loaded scene, whose far geometry was not saved, got False")
        samples = check.integer("samples", samples, 1, truth.MAX_SAMPLES)
        tolerance = (
            TOLERANCES[method] if tolerance_px is None else check.number("tolerance_px", tolerance_px, finite=False)
        )
        wanted = truth.channel_names(self._default_channels(env) if channels is None else channels)
        settings: Any = {
            "channels": wanted,
            "samples": samples,
            "method": method,
            "mapped": env,
            "tolerance_px": tolerance,
        }

        def trace(scene: Scene, camera: Camera, report: Report) -> dict[str, Any]:
            return self._core.render(scene._core, camera._core, **settings, report=report)

        def begin(device: _core.GpuDevice, scene: Scene, camera: Camera, report: Report) -> _core.GpuJob:
            return device.reduced(self._core, scene._core, camera._core, **settings, report=report)

        bends = method == "exact" and self._morph != "none"
        return Painter(self, self._scene, (tuple(wanted), samples), trace, begin, bends=bends)

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
        return ReducedScene(
            self._scene,
            self._partition,
            self._env,
            morph=morph,
            boundary=self._boundary,
            counts=self._counts,
            is_whole=self._is_whole,
        )

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

    def _default_channels(self, env: bool) -> tuple[str, ...]:
        return self._env.channels if env and self._env is not None else envmap.CHANNELS

    def __repr__(self) -> str:
        stats = self.stats
        return (
            f"ReducedScene({self._morph!r}, r1={self.r1:g}, r2={self.r2:g}: {stats['drawn']:,} of "
            f"{stats['triangles']:,} triangles, map of {stats['map_bytes']:,} bytes)"
        )


def check_morph(morph: str, boundary: str) -> None:
    """ValueError for a morph that is none, and one that a map from r1 does not reach."""
    check.choice("morph", morph, MORPHS)
    if boundary == "r1" and morph != "none":
        raise ValueError(f"boundary: expected 'r2' with morph={morph!r}, got 'r1', which only morph='none' knows")


def _rows(channel: Any) -> Any:
    """A map's channel as rows of texels, in the kernels' types."""
    channel = channel.astype(np.float32) if channel.dtype == np.float16 else channel
    return np.reshape(channel, (-1, 3) if channel.ndim == 4 else -1)
