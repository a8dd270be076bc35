"""Arguments of calls that make, cut and reduce scenes, if parameter names do not determine them."""

from __future__ import annotations

from typing import Any

import numpy as np

import nearfar as nf
from nearfar._scene.names import Names
from tests.support.valid_calls.objects import EYE
from tests.support.valid_calls.values import Make

WALK: dict[str, Any] = {"reach": 0.5, "hysteresis": 0.1}

SCENES: dict[str, Make] = {
    "Scene": lambda v: {"names": Names(["near", "far"])},
    "Scene.from_arrays @objects": lambda v: {
        "face_object": np.repeat([0, 1], len(v.faces) // 2), "object_names": ["a", "b"],
    },
    "Scene.from_trimesh": lambda v: {"loaded": v.mesh},
    "Scene.load": lambda v: {"path": v.file("Scene")},
    "Scene.query": lambda v: {"detail": 0.5},
    "Scene.subset": lambda v: {"objects": ["near"]},
    "Scene.subset @triangles": lambda v: {"triangles": np.arange(len(v.faces) // 2)},
    "Scene.transform": lambda v: {"name": "near"},
    "Scene.with_levels": lambda v: {"models": {"near": v.model}},
    "SceneBuilder.instance": lambda v: {"name": "second"},
    "SceneBuilder.object": lambda v: {"name": "second"},
    "SceneBuilder.objects": lambda v: {"names": ["second"]},
    "SceneBuilder.place_many": lambda v: {"names": "many"},
    "open_source": lambda v: {"path": v.file("Scene")},
    "write_tiles": lambda v: {"folder": v.folder / "tiles", "cell": 4.0},
    "LoadCurve": lambda v: {"core": nf.load_curve(v.scene, center=EYE)._core},
    "LoadCurve.count": lambda v: {"r2": 3.0},
    "LoadCurve.radius": lambda v: {"budget": v.scene.triangle_count},
    "triangle_radii": lambda v: {"faces": v.faces},
    "cast_rays": lambda v: {"origins": [EYE] * len(v.directions)},
    "tessellate": lambda v: {"mesh": v.scene},
    "tessellate @cylinder": lambda v: {"mesh": v.scene, "kind": "cylinder", "radius": 2.0, "strength": 0.5},
    "tessellate @trimesh": lambda v: {"mesh": v.mesh},
    "choose_radii": lambda v: {"center": EYE, "r2": 60.0},
    "ReducedScene": lambda v: {
        "zones": v.reduced.partition, "env": v.reduced.env, "morph": "blend", "boundary": "r2",
        "counts": v.reduced._counts,
    },
    "ReducedScene.load": lambda v: {"path": v.file("ReducedScene")},
    "ReducedScene.render @levels": lambda v: {"lod": "depth"},
    "ReducedScene.save": lambda v: {"path": v.folder / "saved"},
    "ReducedScene.with_growth": lambda v: {"radius": 1.0, "strength": 0.5},
    "RadiusSettings": lambda v: {"r2": 60.0},
    "Recentering": lambda v: {"make": lambda: 3},
    "Regions": lambda v: {"centers": [EYE], "radii": v.regions.radii, "hysteresis": 0.1},
    "Regions.index": lambda v: {"current": 0},
    "regions": lambda v: {"path": [(0.0, 1.0, 1.0), (0.0, 1.0, 2.0)], "r2": 4.0, **WALK},
    "regions @area": lambda v: {
        "path": None, "area": [(-0.5, 0.0), (0.5, 1.0)], "budget": v.scene.triangle_count, **WALK,
    },
    "ImpostorSettings": lambda v: {"face_size": 64},
    "Impostors.load": lambda v: {"path": v.file("Impostors")},
    "Impostors.save": lambda v: {"path": v.folder / "saved"},
    "Impostors.save_glb": lambda v: {"path": v.folder / "saved.glb"},
    "datasets.World.query": lambda v: {"detail": 400.0},
    "datasets.city": lambda v: {"detail": 0},
    "datasets.factory": lambda v: {"detail": 0},
    "datasets.forest": lambda v: {"detail": 0},
    "datasets.landscape": lambda v: {"detail": 0},
    "datasets.room": lambda v: {"detail": 0},
    "datasets.spheres": lambda v: {"detail": 0},
}  # fmt: skip
