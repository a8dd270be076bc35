"""Order of the near–far stages, partition and bake, for `reduce` and the explorer; it computes nothing itself."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Collection
from dataclasses import replace
from typing import TypedDict

import numpy as np
from numpy.typing import ArrayLike

from nearfar import _core
from nearfar._cubemap.envmap import EnvMap, to_half
from nearfar._partition.partition import Partition, Unit, partition
from nearfar._reduce import folder
from nearfar._render.bake import bake
from nearfar._scene.scene import Scene


class Divided(ABC):
    """A world that provides its near part as a scene and draws the map of its far part, such as an `OrthoTree`."""

    @abstractmethod
    def near_scene(self, center: ArrayLike, radius: float) -> Scene | None:
        """Return the geometry within a radius of the vertical axis through a centre, and perhaps more."""

    @abstractmethod
    def far_map(
        self, center: ArrayLike, radius: float, *, face_size: int, samples: int, channels: Collection[str]
    ) -> EnvMap:
        """Draw the map of the geometry beyond the radius."""


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
    unit: Unit,
    boundary: str,
    size: int,
    samples: int,
    channels: Collection[str],
    half: bool = False,
    device: _core.GpuDevice | None = None,
) -> Parts:
    """Partition a scene and bake the part beyond; arguments as in `reduce`, already checked."""
    zones = partition(scene, center=center, r1=r1, r2=r2, unit=unit)
    env: EnvMap | None = None
    rays = 0
    if zones.summary()["sf"] > 0 or boundary == "r1":
        radius = zones.r1 if boundary == "r1" else zones.r2
        env, rays = bake(
            zones.scene, zones.center, radius, size=size, samples=samples, channels=channels, half=half, device=device
        )
    return _parts(zones, env, rays)


def divided(
    world: Divided,
    *,
    center: ArrayLike,
    r1: float,
    r2: float,
    boundary: str,
    size: int,
    samples: int,
    channels: Collection[str],
    half: bool = False,
) -> Parts:
    """Like `parts`, for a world that provides its parts itself."""
    scene = world.near_scene(center, r2)
    if scene is None:
        raise ValueError(f"center: expected geometry within r2 = {r2:g} m, found none")
    zones = partition(scene, center=center, r1=r1, r2=r2, unit="triangle")
    moves = scene._core.triangle_count > scene._core.standing_triangle_count
    named = {*channels, "range"} if moves else {*channels}
    radius = zones.r1 if boundary == "r1" else zones.r2
    env = world.far_map(zones.center, radius, face_size=size, samples=samples, channels=named)
    if half and env.range is not None:
        env = replace(env, range=to_half(np.asarray(env.range)))
    return _parts(zones, env, 0)


def _parts(zones: Partition, env: EnvMap | None, rays: int) -> Parts:
    counts = {name: count for name, count in (zones.summary() | {"rays": rays}).items() if name in folder.COUNTS}
    return {"scene": zones.scene, "zones": zones, "env": env, "counts": counts}
