"""Valid arguments by the names of parameters, which mean the same in every stage, and instances of public classes."""

from __future__ import annotations

import functools
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

import nearfar as nf
from tests.support.valid_calls.objects import EYE, SIZE, ZONES, Valid
from tests.support.valid_calls.rooms import room

Make = Callable[[Valid], Any]

SMALL: dict[str, Any] = {
    "backend": "cpu", "blocks": 1, "copy": True, "count": 1, "distances": 4, "face_size": 4, "km": 1, "polygons": 48,
    "samples": 1, "threads": 1, "trees": 1, "views": 4,
}  # fmt: skip
"""Values that keep calls small; they are passed wherever a callable has the parameter."""

CONSTANTS: dict[str, Any] = {
    "aabb": [[0.0, 0.0, 0.0], [1.0, 1.0, 1.0]], "adapter": None, "cell": 8.0, "center": ZONES["center"],
    "centers": [[0.0, 1.0, 0.0]], "channel": "color", "data_range": 255, "detail": 9.0, "direction": [[1.0, 0.0]],
    "distance": 50.0, "down": -1.0, "eccentricity_deg": 10.0, "eye": EYE, "eye_to_head": np.eye(4)[:3], "face": 2,
    "focal": 300.0, "grid": 2.0, "horizontal_deg": 90.0, "i": 0, "index": 0, "ipd": 0.06, "j": 1, "k": [0.1],
    "left": -1.0, "level": 0, "levels": [0, 1], "link": nf.stream.Link(50.0, rtt_ms=20.0, loss=0.01), "mesh": 0,
    "model_index": [0], "mono_plane": 8.0, "morph": "cylinder", "names": ["near"], "near": 0.1,
    "numbers": np.array([0]), "percentile": 50.0, "place": (0, 0, 0), "poses": {"far": np.eye(4)}, "position": EYE,
    "r": [0.1, 0.2], "r1": ZONES["r1"], "r2": ZONES["r2"], "radii": [2.0, 4.0], "radius": 3.0, "region": 0,
    "relative": "nothing.glb", "right": 1.0, "ring": 1, "seconds": 0.1, "sigma": 0.1, "size": SIZE, "t": 0.5,
    "target": (0.0, 0.0, 0.0), "time": 1.0, "tolerance": 0.01, "tolerance_px": 100.0, "up": 1.0,
    "user": (0.5, 1.0, 0.0), "user_region": 0.1, "velocity": (0.0, 0.0, -1.0),
}  # fmt: skip
"""Arguments that callables require."""

OBJECTS: dict[str, str] = {
    "before": "camera", "bundle": "bundle", "camera": "camera", "color": "cube", "device": "device",
    "directions": "directions", "faces": "faces", "frame": "frame", "hmd": "hmd", "image": "picture", "lens": "lens",
    "model": "model", "points": "points", "positions": "vertices", "reference": "picture", "regions": "regions",
    "scene": "scene", "shot": "shot", "source": "scene", "transforms": "transforms", "tree": "orthotree",
    "values": "cube", "vertices": "vertices", "view": "camera",
}  # fmt: skip
"""Attributes of `Valid` that callables require."""

VALUES: dict[str, Make] = {
    "cameras": lambda v: [v.camera] * 2,
    "core": lambda v: v.scene._core,
    "fov": lambda v: v.camera.fov,
    "models": lambda v: [v.model],
    "projection": lambda v: v.camera.fov,
    "references": lambda v: v.picture[None],
    "rings": lambda v: v.ring_maps.rings,
    "test": lambda v: v.picture[::-1],
    "tests": lambda v: v.picture[None],
}
"""Other arguments that callables require."""

INSTANCES: Mapping[str, Make] = {
    "Camera": lambda v: v.camera,
    "ChromaticLens": lambda v: v.chromatic,
    "EnvMap": lambda v: v.env,
    "Frame": lambda v: v.frame,
    "Hmd": lambda v: v.hmd,
    "Impostors": lambda v: v.impostors,
    "LoadCurve": functools.cache(lambda v: nf.load_curve(v.scene, center=ZONES["center"])),
    "Partition": functools.cache(lambda v: nf.partition(v.scene, **ZONES)),
    "RadialLens": lambda v: v.lens,
    "Recentering": lambda v: v.reduced.recentered(ZONES["center"]),
    "ReducedScene": lambda v: v.reduced,
    "ReducedScene.at_levels": lambda v: v.reduced_leveled,
    "ReducedScene.render @levels": lambda v: v.reduced_leveled,
    "Regions": lambda v: v.regions,
    "Scene": lambda v: v.scene,
    "Scene.at_levels": lambda v: v.leveled,
    "SceneBuilder": lambda v: v.builder(),
    "SceneBuilder.objects": lambda v: nf.SceneBuilder(),
    "StereoFrame": lambda v: v.stereo,
    "Walk": lambda v: v.regions.walk(),
    "datasets.Asteroids": functools.cache(lambda v: nf.datasets.asteroids(3, 48)),
    "datasets.SphereTask": lambda v: v.sphere_task,
    "datasets.World": functools.cache(lambda v: nf.datasets.world(1)),
    "gpu.DeviceFrame": lambda v: v.device_frame,
    "lod.Curve4PL": lambda v: v.model.curves,
    "lod.Levels": lambda v: v.levels,
    "lod.LodModel": lambda v: v.model,
    "lod.LodModel.refit": lambda v: v.measured,
    "lod.LodThreshold": lambda v: nf.lod.LodThreshold(),
    "lod.Selection": lambda v: v.selection,
    "lod.Selector": lambda v: nf.lod.Selector(),
    "lod.Switches": functools.cache(lambda v: nf.lod.switches(v.model, view=v.camera)),
    "orthoview.Flight": lambda v: v.moving_orthotree.fly(threads=1),
    "orthoview.FlightLog": lambda v: v.flown,
    "orthoview.OrthoCut": functools.cache(lambda v: v.orthotree.cut(v.camera)),
    "orthoview.OrthoTree": lambda v: v.moving_orthotree,
    "orthoview.Steady": lambda v: nf.orthoview.Steady(),
    "stereo.AdaptivePlane": lambda v: nf.stereo.AdaptivePlane(v.hmd),
    "stereo.HybridRig": lambda v: v.rig,
    "stereo.TemporalAntialiasing": lambda v: nf.stereo.TemporalAntialiasing(),
    "stream.Bundle": lambda v: v.bundle,
    "stream.Growth": lambda v: nf.stream.Growth((2.0, 4.0)),
    "stream.RingMaps": lambda v: v.ring_maps,
    "stream.Rings": lambda v: v.ring_maps.rings,
    "stream.Timeline": lambda v: v.timeline,
    "stream.client.Room": lambda v: room(),
}
"""An instance of each class that has methods, or of the class for one call; a new one each time if calls change it."""


def required_argument(parameter: str, valid: Valid) -> Any:
    """Return an argument that callables require under this name."""
    if parameter in CONSTANTS:
        return CONSTANTS[parameter]
    return getattr(valid, OBJECTS[parameter]) if parameter in OBJECTS else VALUES[parameter](valid)
