"""The order of the near–far stages, partition and bake, which `reduce` and the explorer run; it computes nothing."""

from __future__ import annotations

from collections.abc import Collection
from typing import TypedDict

from numpy.typing import ArrayLike

from nearfar import _core
from nearfar._cubemap.envmap import EnvMap
from nearfar._partition.partition import Partition, partition
from nearfar._reduce import folder
from nearfar._render.bake import bake
from nearfar._scene.scene import Scene


class Parts(TypedDict):
    """Parts of a reduced scene."""

    scene: Scene
    zones: Partition
    env: EnvMap | None
    counts: dict[str, int]


def parts(
    scene: Scene,
    *,
    center: ArrayLike,
    r1: float,
    r2: float,
    unit: str,
    boundary: str,
    size: int,
    samples: int,
    channels: Collection[str],
    half: bool = False,
    device: _core.GpuDevice | None = None,
) -> Parts:
    """Divide a scene at the radii and bake what lies beyond; `reduce` documents the arguments, which it has checked."""
    zones = partition(scene, center=center, r1=r1, r2=r2, unit=unit)
    env: EnvMap | None = None
    rays = 0
    if zones.summary()["sf"] > 0 or boundary == "r1":
        radius = zones.r1 if boundary == "r1" else zones.r2
        env, rays = bake(
            zones.scene, zones.center, radius, size=size, samples=samples, channels=channels, half=half, device=device
        )
    counts = {name: count for name, count in (zones.summary() | {"rays": rays}).items() if name in folder.COUNTS}
    return {"scene": zones.scene, "zones": zones, "env": env, "counts": counts}
