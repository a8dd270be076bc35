"""Runs the near–far stages, partition and bake, in order, for `reduce` and the explorer."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import replace
from typing import Any, Unpack

from numpy.typing import ArrayLike

from nearfar._cubemap.envmap import EnvMap
from nearfar._partition.partition import Unit, partition
from nearfar._reduce import folder
from nearfar._reduce.baking import MapKeywords, MapSettings, bake_arguments, require_cpu
from nearfar._reduce.drawing import Boundary
from nearfar._render.bake import bake
from nearfar._scene.scene import Scene


class NearFarSource(ABC):
    """A world that provides its near part as a scene and draws the map of its far part, such as an `OrthoTree`."""

    @abstractmethod
    def near_scene(self, center: ArrayLike, radius: float) -> Scene | None:
        """Return the geometry within a radius of the vertical axis through a centre, and perhaps more."""

    @abstractmethod
    def far_map(
        self, center: ArrayLike, radius: float, *, settings: MapSettings | None = None, **keywords: Unpack[MapKeywords]
    ) -> EnvMap:
        """Draw the map of the geometry beyond the radius."""


def parts(
    source: Scene | NearFarSource,
    *,
    center: ArrayLike,
    r1: float,
    r2: float,
    boundary: Boundary,
    baking: MapSettings,
    unit: Unit = "triangle",
) -> dict[str, Any]:
    """Partition a scene or world and make the map of its far part; return arguments of `ReducedScene`.

    The parameters are checked arguments of `reduce`.
    """
    if isinstance(source, NearFarSource):
        require_cpu(baking, type(source).__name__)
        scene = source.near_scene(center, r2)
        if scene is None:
            raise ValueError(f"center: expected geometry within r2 = {r2:g} m, found none")
        if scene._core.triangle_count > scene._core.standing_triangle_count:
            baking = replace(baking, channels=(*baking.channels, "range"))
    else:
        scene = source
    zones = partition(scene, center=center, r1=r1, r2=r2, unit=unit)
    radius = zones.r1 if boundary == "r1" else zones.r2
    env, rays = None, 0
    if isinstance(source, NearFarSource):
        env = source.far_map(zones.center, radius, settings=baking)
    elif zones.summary()["sf"] > 0 or boundary == "r1":
        env, rays = bake(zones.scene, zones.center, radius, **bake_arguments(baking, scene))
    counts = {name: count for name, count in (zones.summary() | {"rays": rays}).items() if name in folder.COUNTS}
    return {"scene": zones.scene, "zones": zones, "env": env, "counts": counts}
