"""Valid calls of every public callable of `nf.orthoview`."""

from __future__ import annotations

from typing import Any

import numpy as np

import nearfar as nf
from nearfar.orthoview._cut import Settings
from nearfar.orthoview._pilot import Ahead
from tests.support.valid_fields import fields
from tests.support.valid_objects import EYE, Valid


def cut(valid: Valid) -> nf.orthoview.OrthoCut:
    """The cut of a view."""
    return nf.orthoview.open(valid.store).cut(valid.camera)


def tree(valid: Valid) -> nf.orthoview.OrthoTree:
    """A tree with objects that move."""
    return nf.orthoview.open(valid.store).with_dynamic(valid.scene)


def flight(valid: Valid) -> nf.orthoview.Flight:
    """A flight that has read nothing, and whose threads have not begun."""
    return tree(valid).fly(threads=1)


def orthoviews(valid: Valid) -> dict[str, dict[str, Any]]:
    """Return valid keywords by the callable's name."""
    own, poses = nf.orthoview.open(valid.store), {"far": np.eye(4)}
    return {
        "nearfar.orthoview.Flight.at": {"poses": poses},
        "nearfar.orthoview.OrthoCut.parts": {},
        "nearfar.orthoview.OrthoTree.at": {"poses": poses},
        "nearfar.orthoview.Flight": {
            "opened": own._opened(), "settings": Settings(), "ahead": Ahead(), "threads": 1, "on_error": None,
        },
        "nearfar.orthoview.Flight.begin": {"device": None, "shot": valid.shot},
        "nearfar.orthoview.Flight.close": {},
        "nearfar.orthoview.Flight.look": {"camera": valid.camera, "time": 0.0},
        "nearfar.orthoview.Flight.refresh": {},
        "nearfar.orthoview.Flight.render": {"camera": valid.camera, "time": 0.0},
        "nearfar.orthoview.Flight.trace": {"shot": valid.shot},
        "nearfar.orthoview.Flight.wait": {"seconds": 0.0},
        "nearfar.orthoview.FlightLog": fields(valid.flown),
        "nearfar.orthoview.FlightLog.plot": {},
        "nearfar.orthoview.OrthoCut": fields(cut(valid)),
        "nearfar.orthoview.OrthoCut.keys": {},
        "nearfar.orthoview.OrthoCut.leaf_places": {},
        "nearfar.orthoview.OrthoTree": {"path": valid.store},
        "nearfar.orthoview.OrthoTree.begin": {"device": None, "shot": valid.shot},
        "nearfar.orthoview.OrthoTree.box": {"level": 0, "place": (0, 0, 0)},
        "nearfar.orthoview.OrthoTree.cells": {"level": 0},
        "nearfar.orthoview.OrthoTree.compact": {"path": valid.folder / "compact.zarr"},
        "nearfar.orthoview.OrthoTree.export_splats": {"path": valid.folder / "splats"},
        "nearfar.orthoview.OrthoTree.cut": {"camera": valid.camera},
        "nearfar.orthoview.OrthoTree.fly": {"threads": 1},
        "nearfar.orthoview.OrthoTree.leaf_glb": {"place": (0, 0, 0)},
        "nearfar.orthoview.OrthoTree.prefetch_queue": {
            "position": EYE, "camera": valid.camera, "velocity": (0.0, 0.0, -1.0),
        },
        "nearfar.orthoview.OrthoTree.far_map": {"center": EYE, "radius": 5.0, "face_size": 4, "samples": 1},
        "nearfar.orthoview.OrthoTree.near_scene": {"center": EYE, "radius": 5.0},
        "nearfar.orthoview.OrthoTree.with_dynamic": {"scene": valid.scene},
        "nearfar.orthoview.OrthoTree.preview": {},
        "nearfar.orthoview.OrthoTree.render": {"camera": valid.camera},
        "nearfar.orthoview.OrthoTree.trace": {"shot": valid.shot},
        "nearfar.orthoview.OrthoTree.update": {"aabb": [[0, 0, 0], [1, 1, 1]], "source": valid.scene},
        "nearfar.orthoview.OrthoTree.verify": {},
        "nearfar.orthoview.OrthoTree.view": {"level": 0, "place": (0, 0, 0), "direction": 4},
        "nearfar.orthoview.PrefetchQueue": fields(own.prefetch_queue(EYE)),
        "nearfar.orthoview.build": {
            "source": valid.scene, "path": valid.folder / "new.zarr", "cell": 8.0, "size": 8, "directions": 5,
        },
        "nearfar.orthoview.open": {"path": valid.store},
        "nearfar.orthoview.simulate": {
            "tree": own, "cameras": [valid.camera] * 2, "link": nf.stream.Link(50.0, rtt_ms=20.0, loss=0.01),
        },
        "nearfar.orthoview.size_for": {"pixels": 1000, "cell": 40.0, "distance": 50.0, "fov": 1.5},
    }  # fmt: skip
