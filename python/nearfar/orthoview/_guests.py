"""Guests of a leaf: other leaves that own triangles reaching into it.

Each triangle is in the file of one leaf. A leaf drawn as geometry therefore needs its guests' files, too.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from nearfar._base.errors import UnusableError
from nearfar._scene.scene import Scene
from nearfar.orthoview._grid import Grid, Place
from nearfar.orthoview._layout import Layout
from nearfar.orthoview._owned import owners
from nearfar.orthoview._presence import pack, unpack

Guests = dict[Place, list[Place]]
"""Guests by leaf; leaves without guests may be missing."""

_MAX = 1 << 26
"""Maximum number of bytes that a text may unpack to."""


def guests(part: Scene, grid: Grid, place: Place) -> list[Place]:
    """Return the guests of a leaf from the query of its box."""
    if not part.triangle_count:
        return []
    found = np.unique(owners(part, grid), axis=0)
    rows = (tuple(row) for row in found[(found >= 0).all(axis=1)].tolist())
    return [(x, y, z) for x, y, z in rows if (x, y, z) != place]


def encode_guests(known: Mapping[Place, Sequence[Place]]) -> str:
    """Encode guests as text: base64 of zlib of rows of six int32, a leaf and one of its guests."""
    rows = np.array([(*leaf, *guest) for leaf in sorted(known) for guest in known[leaf]], "<i4")
    return pack(rows.tobytes())


def guests_of(text: str, layout: Layout, tier: int, place: Place) -> Guests:
    """Decode the text that `encode_guests` returned for a subtree; UnusableError if it is invalid."""
    content = unpack("guests", text, _MAX)
    if len(content) % 24:
        raise UnusableError(f"guests: expected rows of 24 bytes, got {len(content)} bytes")
    rows = np.frombuffer(content, "<i4").reshape(-1, 6)
    leaves, others = rows[:, :3], rows[:, 3:]
    counts, side = np.array(layout.grid.counts), layout.shard_side(0)
    is_wrong = (others < 0).any() or (others >= counts).any() or (leaves == others).all(axis=1).any()
    if len(rows) and (tier or is_wrong or (leaves // side != place).any() or (leaves >= counts).any()):
        raise UnusableError("guests: expected leaves of the subtree, and others of the tree")
    found: Guests = {}
    for a, b, c, x, y, z in rows.tolist():
        found.setdefault((a, b, c), []).append((x, y, z))
    return found
