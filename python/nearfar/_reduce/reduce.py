"""Near–far reduction: the one file that knows the order partition → bake → render. It computes nothing itself."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import ArrayLike, DTypeLike

from nearfar._base import check
from nearfar._cubemap import envmap
from nearfar._cubemap.envmap import EnvMap
from nearfar._partition.partition import partition
from nearfar._reduce import folder
from nearfar._reduce.drawing import check_morph
from nearfar._reduce.reduced_scene import ReducedScene
from nearfar._render import backend as backends
from nearfar._render.bake import bake, is_half
from nearfar._render.channels import CHANNELS, MAX_SAMPLES, channel_names
from nearfar._scene.scene import Scene, core_of


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
        Where the map is baked: "cpu", "gpu" or "auto", as in `render`.

    Returns
    -------
    ReducedScene
        Without a map where nothing lies beyond the near part.

    Raises
    ------
    ValueError, TypeError
        For arguments out of their domains, and for float16 where the map reaches beyond 65,504 m.
    DeviceError
        As `render`.

    References
    ----------
    Popescu, Lee, Choi, Fahmy (2022): Eq. 1–3 and figure 1. "cylinder" is Alg. 1 of CloVR (2024).
    """
    core_of(scene)
    check_morph(morph, check.choice("boundary", boundary, ("r1", "r2")))
    size = check.integer("face_size", face_size, 1, 16384)
    samples = check.integer("samples", samples, 1, MAX_SAMPLES)
    wanted = set(channel_names(channels))
    if unknown := wanted - set(envmap.CHANNELS):
        listed = ", ".join(name for name in CHANNELS if name in unknown)
        raise ValueError(f"channels: expected names of {', '.join(envmap.CHANNELS)}, got {listed}")
    device = backends.device_for(backend, scene, (tuple(n for n in CHANNELS if n in wanted), samples))
    half = is_half("range_dtype", range_dtype)
    zones = partition(scene, center=center, r1=r1, r2=r2)
    env: EnvMap | None = None
    rays = 0
    if zones.summary()["sf"] > 0 or boundary == "r1":
        radius = zones.r1 if boundary == "r1" else zones.r2
        env, rays = bake(
            scene, zones.center, radius, size=size, samples=samples, channels=wanted, half=half, device=device
        )
    counts = {name: count for name, count in (zones.summary() | {"rays": rays}).items() if name in folder.COUNTS}
    return ReducedScene(scene, zones, env, morph=morph, boundary=boundary, counts=counts)
