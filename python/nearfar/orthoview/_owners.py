"""Assigns each triangle of a world to one of the leaves that it touches.

Queries return whole triangles that touch a box, so neighbouring leaves get the same triangles. A triangle belongs to
the leaf that holds its first corner inside the tree's box; cells are half-open, except that the last ones include their
far sides. Corners are compared with the same numbers as in a query, so that rounding never excludes a triangle from the
query of its own leaf.

If a tree covers part of a world, triangles may have no corner inside it. Such a triangle is clipped to the tree's box
and belongs to the leaf that holds the mean of the clipped polygon's corners. That point is off the triangle by some
float64 roundings, which is less than the tolerance of queries.

Guests of a leaf are other leaves that own triangles reaching into it. Each triangle is in the file of one leaf only, so
drawing a leaf as geometry needs the files of its guests, too.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from nearfar._base.errors import UnusableError
from nearfar._scene.scene import Scene
from nearfar.orthoview._grid import Grid, Place, places_of
from nearfar.orthoview._layout import Layout
from nearfar.orthoview._presence import pack, unpack

Floats = NDArray[np.float64]


def owned_mask(part: Scene, grid: Grid, place: Place) -> NDArray[np.bool_]:
    """Whether each triangle (T,) of the query of a leaf's box belongs to the leaf."""
    anchors = _anchors(part.triangles(), *_sides(grid, (0, 0, 0), grid.counts, part))
    low, high = _sides(grid, place, (place[0] + 1, place[1] + 1, place[2] + 1), part)
    is_last = np.array(place) + 1 == grid.counts
    is_within = (anchors >= low) & ((anchors < high) | (is_last & (anchors <= high)))
    return np.asarray(is_within.all(axis=1))


def owners(part: Scene, grid: Grid) -> NDArray[np.int64]:
    """Leaf (T, 3) that each triangle of a query belongs to; −1 for triangles outside the tree's box."""
    anchors = _anchors(part.triangles(), *_sides(grid, (0, 0, 0), grid.counts, part))
    places = np.empty(anchors.shape, np.int64)
    for axis, count in enumerate(grid.counts):
        # Sides of all leaves, rounded as in `owned_mask`.
        sides = grid.origin[axis] + np.arange(count + 1) * grid.cell - part.origin[axis]
        number = np.searchsorted(sides, anchors[:, axis], side="right") - 1
        places[:, axis] = np.where(anchors[:, axis] == sides[-1], count - 1, number)
    places[np.isnan(anchors).any(axis=1)] = -1
    return places


def _sides(grid: Grid, first: Place, end: Place, part: Scene) -> tuple[Floats, Floats]:
    """Least and greatest corner of the leaves [`first`, `end`), relative to the scene's origin."""
    return grid.corner(0, first) - part.origin, grid.corner(0, end) - part.origin


def _anchors(corners: NDArray[np.float32], low: Floats, high: Floats) -> Floats:
    """Points (T, 3) whose leaves own the triangles; NaN for triangles outside the tree's box."""
    is_inside = np.asarray(((corners >= low) & (corners <= high)).all(axis=2))
    rows = np.arange(len(corners))
    anchors: Floats = corners[rows, is_inside.argmax(axis=1)].astype(np.float64)
    for row in np.flatnonzero(~is_inside.any(axis=1)).tolist():
        anchors[row] = _middle(corners[row].astype(np.float64), low, high)
    return anchors


def _middle(triangle: Floats, low: Floats, high: Floats) -> Floats:
    """Mean corner (3,) of a triangle (3, 3) clipped to a box; NaN if nothing is left.

    Sutherland and Hodgman, Reentrant polygon clipping, 1974: one side of the box after the other.
    """
    polygon = list(triangle)
    for axis in range(3):
        for side, sign in ((low[axis], 1.0), (high[axis], -1.0)):
            cut: list[Floats] = []
            for start, end in zip([*polygon[-1:], *polygon[:-1]], polygon, strict=True):
                (p, q) = (sign * (point[axis] - side) for point in (start, end))
                if (p < 0) != (q < 0):
                    crossing = start + (end - start) * (p / (p - q))
                    crossing[axis] = side
                    cut.append(crossing)
                if q >= 0:
                    cut.append(end)
            polygon = cut
    if not polygon:
        return np.full(3, np.nan)
    # Rounding may put the mean beyond the triangle's own box, which queries test first.
    least, greatest = np.maximum(low, triangle.min(axis=0)), np.minimum(high, triangle.max(axis=0))
    return np.asarray(np.clip(np.mean(polygon, axis=0), least, greatest))


Guests = dict[Place, list[Place]]
"""Guests by leaf; leaves without guests may be missing."""

_MAX_UNPACKED_BYTES = 1 << 26
"""Maximum size of a decoded text, bytes."""


def guests(part: Scene, grid: Grid, place: Place) -> list[Place]:
    """Return the guests of a leaf from the query of its box."""
    if not part.triangle_count:
        return []
    owner_places = np.unique(owners(part, grid), axis=0)
    return [owner for owner in places_of(owner_places[(owner_places >= 0).all(axis=1)]) if owner != place]


def encode_guests(guests_by_leaf: Mapping[Place, Sequence[Place]]) -> str:
    """Encode guests as text: base64 of zlib of rows of six int32, a leaf and one of its guests."""
    rows = np.array([(*leaf, *guest) for leaf in sorted(guests_by_leaf) for guest in guests_by_leaf[leaf]], "<i4")
    return pack(rows.tobytes())


def guests_of(text: str, layout: Layout, tier: int, place: Place) -> Guests:
    """Decode the text that `encode_guests` returned for a subtree; UnusableError if it is invalid."""
    content = unpack("guests", text, _MAX_UNPACKED_BYTES)
    if len(content) % 24:
        raise UnusableError(f"guests: expected rows of 24 bytes, got {len(content)} bytes")
    rows = np.frombuffer(content, "<i4").reshape(-1, 6)
    leaves, guest_places = rows[:, :3], rows[:, 3:]
    counts, side = np.array(layout.grid.counts), layout.shard_side(0)
    is_wrong = (guest_places < 0).any() or (guest_places >= counts).any() or (leaves == guest_places).all(axis=1).any()
    if len(rows) and (tier or is_wrong or (leaves // side != place).any() or (leaves >= counts).any()):
        raise UnusableError("guests: expected leaves of the subtree, and others of the tree")
    guests_by_leaf: Guests = {}
    for a, b, c, x, y, z in rows.tolist():
        guests_by_leaf.setdefault((a, b, c), []).append((x, y, z))
    return guests_by_leaf
