"""Parts of a tree that are read separately: views of cells, geometry of leaves, records of subtrees."""

from __future__ import annotations

from collections.abc import Sequence

from nearfar.orthoview._cut import Cutter, OrthoCut
from nearfar.orthoview._grid import Place
from nearfar.orthoview._views import ViewKey

Part = ViewKey
"""Level, place and direction of a view. The direction `GEOMETRY` stands for the geometry of a leaf, `RECORD` for the
record of a subtree, whose tier and place come first."""

GEOMETRY, RECORD = -1, -2


def kind(part: Part) -> int:
    """Kind of a part: `GEOMETRY`, `RECORD`, or 0 for a view."""
    return min(part[2], 0)


def records_of(cut: OrthoCut) -> list[Part]:
    """Records of subtrees that a cut lacks."""
    return [(tier, place, RECORD) for tier, place in cut.unknown]


def leaf_parts(leaves: Sequence[Place], cutter: Cutter) -> list[Part]:
    """Geometry of leaves and of their guests, as parts."""
    return [(0, place, GEOMETRY) for place in cutter.with_guests(leaves)]
