"""Near–far reduction: the one file that knows the order partition → bake → render. It computes nothing itself."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike

from nearfar import _check, _core, _envmap, _progress, _render
from nearfar._camera import Camera
from nearfar._envmap import EnvMap
from nearfar._frame import CHANNELS, Frame
from nearfar._partition import Partition, partition
from nearfar._scene import Scene, core_of

MORPHS = ("blend", "cylinder", "none")

TOLERANCES = {"vertex": 0.5, "exact": 0.1}
"""Pixels, for each method of rendering."""


class ReducedScene:
    """A scene made light: near geometry that follows the user, before a map of what is far.

    Made by `reduce`. The scene's meshes are shared, not copied, except for the near triangles (`stats`).
    """

    def __init__(
        self, scene: Scene, zones: Partition, env: EnvMap | None, *, morph: str, boundary: str, rays: int = 0
    ) -> None:
        self._scene, self._partition, self._env = scene, zones, env
        self._morph, self._boundary, self._rays = morph, boundary, rays
        radius = zones.r1 if boundary == "r1" else zones.r2
        channels = {} if env is None else {name: _rows(getattr(env, name)) for name in env.channels}
        size = 0 if env is None else env.face_size
        with _progress.bar("gathering near geometry") as report:
            self._core = _core.Reduced(zones._core, morph=morph, boundary=radius, size=size, **channels, report=report)

    @property
    def scene(self) -> Scene:
        """The scene that was reduced."""
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
            near geometry); `rays` and `ranges_computed` while baking; of the last frame `frame_triangles` (after
            splitting; 0 where the scene's own trees were used), `dynamic_triangles` (moving ones that were looked for;
            0 where there was no pass for them), `tolerance_held` (whether `tolerance_px` was a bound for "vertex":
            "blend", and a user within 0.6 r1 of the centre) and `opposed_directions` (vertices that user and centre see
            in opposite directions, which happens only outside the near cylinder).
        """
        counts = self._partition.summary()
        triangles, moving, opposed, bounded = self._core.last_frame()
        drawn = counts["nsf" if self._boundary == "r2" else "nsf_at_r1"]
        return {
            **{name: counts[name] for name in ("triangles", "near", "intermediate", "nsf", "sf")},
            "drawn": drawn,
            "reduction": counts["triangles"] / max(drawn, 1),
            "map_bytes": 0 if self._env is None else self._env.nbytes,
            "near_bytes": self._core.near_bytes,
            "rays": self._rays,
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
            vertices that there are, which bends long triangles wrongly and opens breaks at both radii. For "exact" how
            far a bent ray may miss its curve, by default 0.1.

        Returns
        -------
        Frame
            The same bytes for any number of threads.

        Raises
        ------
        ValueError, TypeError
            For arguments out of their domains, for a range or object_id that was not baked, and for parallel rays where
            there is a map or rays are bent, which show what one eye sees.
        """
        if not isinstance(camera, Camera):
            raise TypeError(f"camera: expected a Camera, got {type(camera).__name__}")
        _check.choice("method", method, tuple(TOLERANCES))
        samples = _check.integer("samples", samples, 1, _render.MAX_SAMPLES)
        tolerance = (
            TOLERANCES[method] if tolerance_px is None else _check.number("tolerance_px", tolerance_px, finite=False)
        )
        wanted = _render.channel_names(self._default_channels(env) if channels is None else channels)
        scene = self._scene if at is None else self._scene.at(at)
        with _progress.bar("rendering") as report:
            images = self._core.render(
                scene._core,
                camera._core,
                channels=wanted,
                samples=samples,
                method=method,
                mapped=env,
                tolerance_px=tolerance,
                report=report,
            )
        return Frame(camera, scene._core.origin, **images)

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
        _check_morph(morph, self._boundary)
        zones, env = self._partition, self._env
        return ReducedScene(self._scene, zones, env, morph=morph, boundary=self._boundary, rays=self._rays)

    def _default_channels(self, env: bool) -> tuple[str, ...]:
        return self._env.channels if env and self._env is not None else _envmap.CHANNELS

    def __repr__(self) -> str:
        stats = self.stats
        return (
            f"ReducedScene({self._morph!r}, r1={self.r1:g}, r2={self.r2:g}: {stats['drawn']:,} of "
            f"{stats['triangles']:,} triangles, map of {stats['map_bytes']:,} bytes)"
        )


def reduce(
    scene: Scene,
    *,
    center: ArrayLike,
    r1: float,
    r2: float,
    face_size: int = 1024,
    morph: str = "blend",
    boundary: str = "r2",
    channels: Iterable[str] = ("color",),
    samples: int = 4,
    range_dtype: DTypeLike = np.float32,
    backend: str = "auto",
) -> ReducedScene:
    """Make a scene light: keep what is near as geometry, bake what is far, and join the two without a seam.

    Parameters
    ----------
    scene
        The scene.
    center
        World position O in metres that the map is baked from: an eye's height above the ground, in the middle of where
        users will be.
    r1, r2
        Radii in metres about the vertical axis through O, 0 ≤ r1 < r2. Inside r1 everything is where it is; beyond r2
        only the map is seen; in between the picture changes from one to the other.
    face_size
        Texels across each of the map's six faces.
    morph
        "blend" (Popescu et al. 2022) and "cylinder" (CloVR, 2024: points keep their distance from the axis) are
        continuous; "none" is the conventional method, whose near part ends with a break.
    boundary
        Where the near part of "none" ends and its map begins: "r2", or "r1" as in the paper's figure 1.
    channels
        What the map holds: "color" always, "range" and "object_id" if asked for. Scenes with moving objects get
        range anyway, because it tells what far buildings hide.
    samples
        Colour samples of each texel.
    range_dtype
        Type of the map's range: float32, or float16 in half the memory and file, off by at most 2⁻¹¹ of the range.
    backend
        "cpu", or "auto" for the fastest there is.

    Returns
    -------
    ReducedScene
        Without a map where nothing lies beyond the near part.

    Raises
    ------
    ValueError, TypeError
        For arguments out of their domains, and for float16 where the map reaches beyond 65,504 m.
    DeviceError
        For "gpu".

    References
    ----------
    Popescu, Lee, Choi, Fahmy (2022): Eq. 1–3 and figure 1. "cylinder" is Alg. 1 of CloVR (2024).
    """
    core_of(scene)
    _check_morph(morph, _check.choice("boundary", boundary, ("r1", "r2")))
    size = _check.integer("face_size", face_size, 1, 16384)
    samples = _check.integer("samples", samples, 1, _render.MAX_SAMPLES)
    wanted = set(_render.channel_names(channels))
    if unknown := wanted - set(_envmap.CHANNELS):
        listed = ", ".join(name for name in CHANNELS if name in unknown)
        raise ValueError(f"channels: expected names of {', '.join(_envmap.CHANNELS)}, got {listed}")
    _render.check_backend(backend)
    half = _half(range_dtype)
    zones = partition(scene, center=center, r1=r1, r2=r2)
    env, rays = _bake(scene, zones, boundary, size, samples, wanted, half)
    return ReducedScene(scene, zones, env, morph=morph, boundary=boundary, rays=rays)


def _check_morph(morph: str, boundary: str) -> None:
    _check.choice("morph", morph, MORPHS)
    if boundary == "r1" and morph != "none":
        raise ValueError(f"boundary: expected 'r2' with morph={morph!r}, got 'r1', which only morph='none' knows")


def _bake(
    scene: Scene, zones: Partition, boundary: str, size: int, samples: int, wanted: set[str], half: bool
) -> tuple[EnvMap | None, int]:
    """Bake the far part and count the rays; nothing where nothing is far."""
    counts = zones.summary()
    if counts["sf"] == 0 and boundary == "r2":
        return None, 0
    moving = scene._core.triangle_count > scene._core.standing_triangle_count
    with _progress.bar("baking") as report:
        faces, rays = _core.bake(
            scene._core,
            center=zones.center,
            radius=zones.r1 if boundary == "r1" else zones.r2,
            size=size,
            samples=samples,
            range="range" in wanted or moving,
            object_id="object_id" in wanted,
            report=report,
        )
    shaped = {name: image.reshape(6, size, size, *image.shape[2:]) for name, image in faces.items()}
    if half and "range" in shaped:
        shaped["range"] = _envmap.to_half(shaped["range"])
    names = scene.object_names if "object_id" in shaped else ()
    return EnvMap(zones.center, **shaped, object_names=names), rays


def _half(range_dtype: DTypeLike) -> bool:
    """Whether ranges are 16-bit."""
    wanted = np.dtype(range_dtype)
    if wanted not in (np.float16, np.float32):
        raise ValueError(f"range_dtype: expected float32 or float16, got {wanted}")
    return wanted == np.float16


def _rows(channel: Any) -> Any:
    """A map's channel as rows of texels, in the kernels' types."""
    channel = channel.astype(np.float32) if channel.dtype == np.float16 else channel
    return np.reshape(channel, (-1, 3) if channel.ndim == 4 else -1)
