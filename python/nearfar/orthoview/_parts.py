"""Parts of a tree that are read one by one: views of cells, and the geometry of leaves."""

from __future__ import annotations

from collections.abc import Sequence

from nearfar.orthoview._cut import Cutter, OrthoCut
from nearfar.orthoview._grid import Place
from nearfar.orthoview._views import ViewKey

Part = ViewKey
"""Level, place and direction of a view. With the direction `GEOMETRY` the geometry of a leaf; with `RECORD` tier and
place of a subtree, and the record of its cells."""

GEOMETRY, RECORD = -1, -2


def kind(part: Part) -> int:
    """`GEOMETRY`, `RECORD`, or 0 for a view."""
    return min(part[2], 0)


def records_of(cut: OrthoCut) -> list[Part]:
    """The records of subtrees that a cut lacks."""
    return [(tier, place, RECORD) for tier, place in cut.unknown]


def leaf_parts(leaves: Sequence[Place], cutter: Cutter) -> list[Part]:
    """The files that leaves are drawn from as geometry."""
    return [(0, place, GEOMETRY) for place in cutter.with_guests(leaves)]
