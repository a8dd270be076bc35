"""Which triangles belong to a leaf: each triangle of a world belongs to one leaf of those that it touches.

Queries return whole triangles that touch a box, so that neighbours get the same ones. A triangle belongs to the leaf
that holds its first corner inside of the tree's box; cells are half-open, and the last ones have their far sides as
well. Corners are compared with the same numbers by which a query compares them, so no rounding hides a triangle from
its leaf.

A tree of a part of a world has triangles without any corner inside. Such a triangle belongs to the leaf that holds the
mean corner of what is left of it inside of the tree's box. That point is off the triangle by some float64 roundings,
which is less than what queries allow for.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nearfar._scene.scene import Scene
from nearfar.orthoview._grid import Grid, Place

Floats = NDArray[np.float64]


def owned(part: Scene, grid: Grid, place: Place) -> NDArray[np.bool_]:
    """Whether each triangle (T,) of the query of a leaf's box belongs to the leaf."""
    anchors = _anchors(part.triangles(), *_sides(grid, (0, 0, 0), grid.counts, part))
    low, high = _sides(grid, place, (place[0] + 1, place[1] + 1, place[2] + 1), part)
    is_last = np.array(place) + 1 == grid.counts
    within = (anchors >= low) & ((anchors < high) | (is_last & (anchors <= high)))
    whole: NDArray[np.bool_] = within.all(axis=1)
    return whole


def owners(part: Scene, grid: Grid) -> NDArray[np.int64]:
    """The leaf (T, 3) to which each triangle of a query belongs; −1 for those of which nothing is in the tree's box."""
    anchors = _anchors(part.triangles(), *_sides(grid, (0, 0, 0), grid.counts, part))
    places = np.empty(anchors.shape, np.int64)
    for axis, count in enumerate(grid.counts):
        # The sides of all leaves, rounded as `owned` has them.
        sides = grid.origin[axis] + np.arange(count + 1) * grid.cell - part.origin[axis]
        number = np.searchsorted(sides, anchors[:, axis], side="right") - 1
        places[:, axis] = np.where(anchors[:, axis] == sides[-1], count - 1, number)
    places[np.isnan(anchors).any(axis=1)] = -1
    return places


def _sides(grid: Grid, first: Place, end: Place, part: Scene) -> tuple[Floats, Floats]:
    """Least and greatest corner of the leaves from `first` to before `end`, relative to the scene's origin."""
    return grid.corner(0, first) - part.origin, grid.corner(0, end) - part.origin


def _anchors(corners: NDArray[np.float32], low: Floats, high: Floats) -> Floats:
    """The point (T, 3) of each triangle that decides; NaN where nothing of a triangle is in the tree's box."""
    inside = np.asarray(((corners >= low) & (corners <= high)).all(axis=2))
    rows = np.arange(len(corners))
    anchors: Floats = corners[rows, inside.argmax(axis=1)].astype(np.float64)
    for row in np.flatnonzero(~inside.any(axis=1)).tolist():
        anchors[row] = _middle(corners[row].astype(np.float64), low, high)
    return anchors


def _middle(triangle: Floats, low: Floats, high: Floats) -> Floats:
    """The mean corner (3,) of a triangle (3, 3) cut to a box; NaN where nothing is left.

    Sutherland and Hodgman, Reentrant polygon clipping, 1974: one side of the box after the other.
    """
    polygon = list(triangle)
    for axis in range(3):
        for side, sign in ((low[axis], 1.0), (high[axis], -1.0)):
            cut: list[Floats] = []
            for before, here in zip([*polygon[-1:], *polygon[:-1]], polygon, strict=True):
                (p, q) = (sign * (point[axis] - side) for point in (before, here))
                if (p < 0) != (q < 0):
                    crossing = before + (here - before) * (p / (p - q))
                    crossing[axis] = side
                    cut.append(crossing)
                if q >= 0:
                    cut.append(here)
            polygon = cut
    if not polygon:
        return np.full(3, np.nan)
    # Rounding may take the mean beyond the triangle's own box, with which queries begin.
    least, greatest = np.maximum(low, triangle.min(axis=0)), np.minimum(high, triangle.max(axis=0))
    middle: Floats = np.clip(np.mean(polygon, axis=0), least, greatest)
    return middle
