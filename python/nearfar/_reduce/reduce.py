"""Near–far reduction: the one file that knows the order partition → bake → render. It computes nothing itself."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike

from nearfar import _core
from nearfar._base import check, progress
from nearfar._cubemap import envmap
from nearfar._cubemap.envmap import EnvMap
from nearfar._partition.partition import Partition, partition
from nearfar._reduce import folder
from nearfar._reduce.reduced_scene import ReducedScene, check_morph
from nearfar._render import backend as backends
from nearfar._render import truth
from nearfar._render.frame import CHANNELS
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
    samples = check.integer("samples", samples, 1, truth.MAX_SAMPLES)
    wanted = set(truth.channel_names(channels))
    if unknown := wanted - set(envmap.CHANNELS):
        listed = ", ".join(name for name in CHANNELS if name in unknown)
        raise ValueError(f"channels: expected names of {', '.join(envmap.CHANNELS)}, got {listed}")
    device = backends.device_for(backend, scene, (tuple(n for n in CHANNELS if n in wanted), samples))
    half = _half(range_dtype)
    zones = partition(scene, center=center, r1=r1, r2=r2)
    env, rays = _bake(device, scene, zones, boundary, size, samples, wanted, half)
    counts = {name: count for name, count in (zones.summary() | {"rays": rays}).items() if name in folder.COUNTS}
    return ReducedScene(scene, zones, env, morph=morph, boundary=boundary, counts=counts)


def _bake(
    device: _core.GpuDevice | None,
    scene: Scene,
    zones: Partition,
    boundary: str,
    size: int,
    samples: int,
    wanted: set[str],
    half: bool,
) -> tuple[EnvMap | None, int]:
    """Bake the far part and count the rays, which a device casts none; nothing where nothing is far."""
    counts = zones.summary()
    if counts["sf"] == 0 and boundary == "r2":
        return None, 0
    moving = scene._core.triangle_count > scene._core.standing_triangle_count
    with progress.bar("baking") as report:
        settings: Any = {
            "center": zones.center,
            "radius": zones.r1 if boundary == "r1" else zones.r2,
            "size": size,
            "samples": samples,
            "range": "range" in wanted or moving,
            "object_id": "object_id" in wanted,
            "report": report,
        }
        if device is None:
            faces, rays = _core.bake(scene._core, **settings)
        else:
            faces, rays = device.bake(scene._core, **settings), 0
    shaped = {name: image.reshape(6, size, size, *image.shape[2:]) for name, image in faces.items()}
    if half and "range" in shaped:
        shaped["range"] = envmap.to_half(shaped["range"])
    names = scene.object_names if "object_id" in shaped else ()
    return EnvMap(zones.center, **shaped, object_names=names), rays


def _half(range_dtype: DTypeLike) -> bool:
    """Whether ranges are 16-bit."""
    try:
        wanted = np.dtype(range_dtype)
    except TypeError:
        raise TypeError(f"range_dtype: expected float32 or float16, got {range_dtype!r}") from None
    if wanted not in (np.float16, np.float32):
        raise ValueError(f"range_dtype: expected float32 or float16, got {wanted}")
    return wanted == np.float16
