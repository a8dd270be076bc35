"""Default viewpoints of commands."""

from __future__ import annotations

import nearfar as nf
from nearfar._trace import viewpoint
from nearfar._trace.viewpoint import Viewpoint
from nearfar.cli._options import Point

KNOWN = {"city": nf.datasets.street_view, "room": nf.datasets.room_view}
"""Functions that return eye and target, by the name of their procedural scene."""


def choose(scene: nf.Scene, source: str, eye: Point | None = None) -> Viewpoint:
    """Choose a viewpoint: at `eye` if set, else the view of a procedural scene, else an open place of the scene."""
    if eye is not None:
        return viewpoint.facing_open(scene, eye)
    name = source.partition(":")[0]
    return viewpoint.facing(*KNOWN[name]()) if name in KNOWN else viewpoint.find(scene)
