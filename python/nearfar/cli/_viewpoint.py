"""Viewpoints that commands take where none is given."""

from __future__ import annotations

import nearfar as nf
from nearfar._trace import viewpoint
from nearfar._trace.viewpoint import Viewpoint
from nearfar.cli._options import Point

KNOWN = {"city": nf.datasets.street_view, "room": nf.datasets.room_view}
"""Procedural scenes that say where to stand and what to look at."""


def choose(scene: nf.Scene, source: str, eye: Point | None = None) -> Viewpoint:
    """A given eye, facing the longest open view; else the view that a procedural scene suggests, else an open place."""
    if eye is not None:
        return viewpoint.facing_open(scene, eye)
    name = source.partition(":")[0]
    return viewpoint.facing(*KNOWN[name]()) if name in KNOWN else viewpoint.find(scene)
