"""Arguments of calls for levels of detail, orthoviews, bundles and rooms, if parameter names do not determine them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from nearfar.orthoview._cut import Settings
from nearfar.orthoview._pilot import PrefetchSettings
from nearfar.stream import collect
from tests.support.valid_calls.fields import fields
from tests.support.valid_calls.objects import EYE, ZONES, Valid
from tests.support.valid_calls.rooms import URL, FinishedRoom, room
from tests.support.valid_calls.values import Make

SIZES = np.geomspace(1e-4, 0.3, 8)
PLACE = (np.zeros(3), np.array([0.0, 0.0, 0.0, 1.0]))
JOINING: dict[str, Any] = {"url": URL, "room": "hall", "name": "Ada", "group": 1, "token": "1.2.3"}
MEASURED: dict[str, Any] = {
    "fov": nf.Fov.symmetric(90.0), "size": (32, 32), "views": 4, "distances": 4, "samples": 1,
}  # fmt: skip
ONE_CENTER: dict[str, Any] = {"centers": [[0.0, 0.0, 0.0]], "radii": [1.0]}


def _written(valid: Valid) -> Path:
    """The folder of the bundle."""
    assert valid.bundle.count
    return valid.folder / "bundle"


STREAMS: dict[str, Make] = {
    "lod.Curve4PL": lambda v: fields(v.model.curves),
    "lod.Curve4PL.__call__": lambda v: {"x": [0.1]},
    "lod.Levels": lambda v: {"levels": list(v.levels)},
    "lod.LodModel": lambda v: fields(v.model),
    "lod.LodModel.export": lambda v: {"path": v.folder / "model.glb"},
    "lod.LodModel.load": lambda v: {"path": v.file("LodModel")},
    "lod.LodModel.save": lambda v: {"path": v.folder / "model.json"},
    "lod.LodModel.selector": lambda v: {"mode": "depth"},
    "lod.LodThreshold.": lambda v: {"reference": 0.2},
    "lod.MeasureSettings": lambda v: MEASURED,
    "lod.MeasureSettings.full": lambda v: MEASURED,
    "lod.MeasureSettings.published": lambda v: MEASURED,
    "lod.Selection": lambda v: {"level": v.selection.level, "counts": v.selection.counts, "columns": {}},
    "lod.Selector.select": lambda v: {**ONE_CENTER, "draws": [3]},
    "lod.export": lambda v: {"scene": v.leveled, "path": v.folder / "scene.glb"},
    "lod.fit_4pl": lambda v: {"x": SIZES, "y": 1.0 - SIZES},
    "lod.measure": lambda v: {"levels": nf.lod.Levels([v.levels[1]]), **MEASURED},
    "lod.measure @many": lambda v: {"levels": {"a": nf.lod.Levels([v.levels[1]])}, **MEASURED},
    "lod.place": lambda v: {"model_index": [0, 0]},
    "lod.place @named": lambda v: {"models": {"ball": v.model}, "model_index": ["ball", "ball"]},
    "lod.select": lambda v: ONE_CENTER,
    "lod.select @fovea": lambda v: {
        **ONE_CENTER, "mode": "fovea", "lens": v.lens, "gaze": (0.0, 0.0, -1.0), "previous": [1],
        "full": True,
    },
    "lod.simplify": lambda v: {"mesh": v.mesh, "ratios": (1.0, 0.5)},
    "orthoview.Flight": lambda v: {
        "opened": v.orthotree._open_store(), "settings": Settings(), "ahead": PrefetchSettings(), "on_error": None,
    },
    "orthoview.Flight.wait": lambda v: {"seconds": 0.0},
    "orthoview.OrthoTree": lambda v: {"path": v.store},
    "orthoview.OrthoTree.compact": lambda v: {"path": v.folder / "compact.zarr"},
    "orthoview.OrthoTree.export_splats": lambda v: {"path": v.folder / "splats"},
    "orthoview.OrthoTree.far_map": lambda v: {"center": EYE, "radius": 5.0},
    "orthoview.OrthoTree.near_scene": lambda v: {"center": EYE, "radius": 5.0},
    "orthoview.OrthoTree.prefetch_queue": lambda v: {"camera": v.camera, "velocity": (0.0, 0.0, -1.0)},
    "orthoview.OrthoTree.view": lambda v: {"direction": 4},
    "orthoview.ViewSettings": lambda v: {"size": 8, "directions": 5},
    "orthoview.build": lambda v: {"path": v.folder / "new.zarr", "size": 8, "directions": 5},
    "orthoview.choose_cell": lambda v: {"size": 8, "directions": 5},
    "orthoview.open": lambda v: {"path": v.store},
    "orthoview.size_for": lambda v: {"pixels": 1000, "fov": 1.5},
    "stream.Bundle.at": lambda v: {"radius": 1.0},
    "stream.Bundle.nearest": lambda v: {"point": ZONES["center"]},
    "stream.Bundle.read": lambda v: {"name": next(iter(v.bundle.files))},
    "stream.ClientSettings": lambda v: {"head_path": ZONES["center"], "camera": v.camera},
    "stream.ExportSettings": lambda v: {"face_size": 64, "pixels_per_degree": 20.0, "split_px": 50.0},
    "stream.Link": lambda v: {"mbps": 50.0, "rtt_ms": 20.0, "loss": 0.01, "http": 1},
    "stream.Link @trace": lambda v: {"trace": ([0.0, 1.0], [50.0, 20.0])},
    "stream.Timeline.bytes_at": lambda v: {"time": [0.0, 1.0]},
    "stream.Timeline.plot": lambda v: {"value": "radius"},
    "stream.Timeline.to_json": lambda v: {"path": v.folder / "timeline.json"},
    "stream.export": lambda v: {
        "path": v.folder / "exported", "radii": [3.0], "face_size": 64, "pixels_per_degree": 20.0, "split_px": 50.0,
        "by_footprint": True,
    },
    "stream.export @regions": lambda v: {
        "path": v.folder / "exported", "center": v.regions, "grid": 0.5, "radii": [2.0], "face_size": 64,
    },
    "stream.export @levels": lambda v: {
        "scene": v.leveled, "path": v.folder / "exported", "radii": [20.0], "face_size": 64, "lod": "depth",
    },
    "stream.open": lambda v: {"path": _written(v)},
    "stream.radius_for": lambda v: {"link": nf.stream.Link(50.0)},
    "stream.ring_radii": lambda v: {"r_max": 20.0, "base_radius": 8.0},
    "stream.simulate": lambda v: {"head_path": ZONES["center"]},
    "stream.simulate @seen": lambda v: {
        "link": nf.stream.Link(50.0), "strategy": "clovrd", "scene": v.scene, "size": 16, "camera": v.camera,
    },
    "view.write_page": lambda v: {"path": _written(v)},
    "stream.client.Room": lambda v: JOINING,
    "stream.client.Room.pose": lambda v: {
        "position": PLACE[0], "rotation": PLACE[1], "left": PLACE, "right": PLACE, "pointer": ("left", 3.0),
        "acknowledged": True,
    },
    "stream.client.Room.say": lambda v: {"data": b"hit", "to": "room"},
    "stream.client.Room.signal": lambda v: {"user": 1, "data": b"offer"},
    "stream.client.join": lambda v: JOINING,
    "stream.collect.Person": lambda v: fields(collect.Person()),
    "stream.collect.Settings": lambda v: fields(collect.Settings()),
    "stream.collect.play": lambda v: {
        "room": room(FinishedRoom), "settings": collect.Settings(), "person": collect.Person(),
    },
    "stream.collect.simulate": lambda v: {
        "settings": collect.Settings(users=1, trials=1, duration=0.1), "person": collect.Person(), "groups": 1,
        "leg": (0.01, 0.001),
    },
}  # fmt: skip
