"""Runs the near–far stages, partition and bake of a map or of impostors, in order."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import replace
from typing import Any, Unpack

import numpy as np
from numpy.typing import ArrayLike

from nearfar import _core
from nearfar._base import check
from nearfar._cubemap.envmap import EnvMap
from nearfar._impostor import bake as impostor_bake, file
from nearfar._impostor.bake import Region
from nearfar._impostor.budget import Budget
from nearfar._impostor.quads import Point
from nearfar._impostor.settings import ImpostorSettings
from nearfar._partition.partition import Unit, partition
from nearfar._reduce import default_radii, folder
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


def check_place(center: Point) -> None:
    """Raise ValueError for a centre too far away for distances to it."""
    if max(map(abs, center)) > check.FARTHEST:
        raise ValueError(f"center: expected coordinates within ±{check.FARTHEST:g} m, got {center}")


def impostor_parts(
    scene: Scene,
    center: Point,
    r2: float,
    settings: ImpostorSettings,
    *,
    may_keep: bool = True,
    earlier: _core.ImpostorSheets | None = None,
) -> dict[str, Any]:
    """Partition a scene and bake impostors of its far part; return arguments of `Impostors`, and `notes` by name.

    `r2` is checked. A scene stays as it is if impostors would have as many triangles, unless bytes are limited, and far
    triangles that users see stay if quads would have as many and take as many bytes; without `may_keep` it gets
    impostors all the same. Quads of an `earlier` bake of the scene are used again where they keep the
    bound, unless there is a budget. ValueError for a centre out of range, and a reach that is not less than r2.
    """
    reach = min(default_radii.REACH, 0.5 * r2) if settings.reach is None else settings.reach
    check_place(center)
    if not r2 > reach:
        raise ValueError(f"reach: expected less than r2 = {r2:g} m, got {reach:g}")
    region = Region(center, reach, r2, settings.error_px)
    facts: dict[str, Any] = {"center": center, "reach": reach, "r2": r2, "settings": settings}
    counts = {"scene_triangles": scene.triangle_count, "missing": 0.0, "changed": 0.0, "bakes": 0}
    if fitting := _explain_fit(scene, region, settings):
        return facts | _whole(scene, counts, fitting)
    zones = partition(scene, center=center, r1=0.0, r2=r2)
    # Quads of an earlier bake get no coarser for a budget, and those that a budget dropped would come back.
    has_budget = settings.triangles is not None or settings.bytes is not None
    budget = Budget(zones, region, settings, None if has_budget else earlier)
    baked = budget.bake()
    quads, used = baked.quads, baked.settings
    is_small = may_keep and settings.bytes is None
    if is_small and quads is not None and len(baked.near) + baked.far_count >= scene.triangle_count:
        note = f"impostors would have {baked.far_count:,} triangles, so the {scene.triangle_count:,} of the scene stay"
        return facts | _whole(scene, counts | {"bakes": budget.bakes}, note)
    notes = {}
    geometry = budget.as_geometry(baked) if may_keep and quads is not None else None
    if geometry is not None:
        facts_of_far = f"the {len(baked.far):,} far triangles that users see stay geometry"
        notes = {"far": f"{facts_of_far}; textured quads would have {baked.far_count:,}"}
        baked, quads = geometry, None
    elif quads is None:
        is_cut = budget.dropped[0] > 0
        notes = {"far": "the budget leaves none" if is_cut else f"no static triangle beyond {r2:g} m is seen"}
    near = scene.subset(triangles=baked.near)
    far = None if quads is None else quads.scene(center, scene.origin, scene.object_names)
    counts |= {
        "missing": baked.missing,
        "changed": impostor_bake.changed_share(zones, region, baked),
        "bakes": budget.bakes,
    }
    dropped = {"dropped_quads": budget.dropped[0], "dropped_texels": budget.dropped[1]}
    layers = () if quads is None else quads.layers
    return facts | {
        "settings": used,
        "near": near,
        "far": far,
        "stats": {
            "triangles": baked.far_count,
            "quads": 0 if quads is None else len(quads),
            "shared_quads": 0 if quads is None else quads.shared,
            "texels": 0 if quads is None else int(quads.texels.sum()),
            "layers": len(layers),
            "atlas": (0, 0) if quads is None else quads.atlas.shape[1::-1],
            "near_triangles": near.triangle_count,
            "error_px": used.error_px,
            **counts,
            **dropped,
        },
        "layers": tuple((tuple(np.add(center, offset).tolist()), count) for offset, count in layers),
        "notes": notes,
        "_quads": quads,
        "_sheets": None if has_budget else baked.sheets,
    }


def _explain_fit(scene: Scene, region: Region, settings: ImpostorSettings) -> str:
    """Return why a scene needs no reduction: it keeps the budgets as it is. Empty if it doesn't, or without budgets."""
    triangles, size = settings.triangles, settings.bytes
    if (triangles is None and size is None) or scene.triangle_count > (triangles or scene.triangle_count):
        return ""
    # A triangle takes at least a byte.
    if size is not None and (scene.triangle_count > size or len(file.encode(None, region, near=scene).data) > size):
        return ""
    kept = " and ".join(f"{limit:,} {name}" for limit, name in ((triangles, "triangles"), (size, "bytes")) if limit)
    return f"the scene fits into {kept} as it is, so nothing was baked"


def _whole(scene: Scene, counts: dict[str, Any], note: str) -> dict[str, Any]:
    """Return the arguments of `Impostors` for a scene that stays as it is."""
    nothing = {
        "triangles": 0,
        "quads": 0,
        "shared_quads": 0,
        "texels": 0,
        "layers": 0,
        "atlas": (0, 0),
        "error_px": 0.0,
    }
    stats = {**nothing, "near_triangles": scene.triangle_count, **counts, "dropped_quads": 0, "dropped_texels": 0}
    return {
        "near": scene,
        "far": None,
        "stats": stats,
        "layers": (),
        "notes": {"far": note},
        "_quads": None,
        "_sheets": None,
    }
