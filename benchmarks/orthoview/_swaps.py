"""Distances in the picture between splats and the splats of their parents that replace them."""

from __future__ import annotations

import itertools

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from nearfar.orthoview._view import OrthoView

REACH = 4.0
"""Maximum distance in pixels of a child's splat behind its parent's surface to belong to it."""

Tree = nf.orthoview.OrthoTree


def swap_distances(tree: Tree, camera: nf.Camera, error_px: float = 1.0) -> NDArray[np.float64]:
    """Distances in pixels between the middles of children's and their parents' splats, where the level changes.

    Parents are those in a cut, from the directions in which they are drawn. Children farther behind their parent's
    surface do not belong to it and are not replaced.
    """
    cut, distances = tree.cut(camera, error_px=error_px, geometry=False), []
    keys = cut.keys()
    for level, place, number in keys:
        parent = tree.view(level, place, number) if level else None
        for octant in itertools.product((0, 1), repeat=3) if parent is not None else ():
            x, y, z = (2 * base + step for base, step in zip(place, octant, strict=True))
            is_inside = all(n < count for n, count in zip((x, y, z), tree.cells(level - 1), strict=True))
            child = tree.view(level - 1, (x, y, z), number) if is_inside else None
            if child is not None and parent is not None:
                distances.append(between(camera, parent, child, 2**level * cut.reach))
    return np.concatenate(distances)


def between(camera: nf.Camera, parent: OrthoView, child: OrthoView, start: float) -> NDArray[np.float64]:
    """Distances in pixels between a child's splats in the picture and its parent's."""
    points = child.points()[np.isfinite(child.depth)]
    size, offset = len(parent.depth), points - parent.center
    column = np.floor((offset @ parent.right / parent.extents[0] + 0.5) * size).astype(int)
    row = np.floor((0.5 - offset @ parent.up / parent.extents[1]) * size).astype(int)
    is_inside = (column >= 0) & (column < size) & (row >= 0) & (row < size)
    points, parent_points = points[is_inside], parent.points()[row[is_inside], column[is_inside]]
    behind = (parent_points - points) @ parent.toward
    is_replaced = behind <= REACH * max(parent.extents[:2]) / (2 * size)
    points, parent_points = points[is_replaced], parent_points[is_replaced]
    child_pixels, parent_pixels = camera.project(points)[:, :2], camera.project(parent_points)[:, :2]
    distance = np.linalg.norm(points - np.array(camera.position), axis=1)
    pixels = np.linalg.norm(child_pixels - parent_pixels, axis=1) * distance / start
    width, height = camera.size
    is_visible = ((child_pixels >= 0) & (child_pixels < (width, height))).all(axis=1) & np.isfinite(pixels)
    return np.asarray(pixels[is_visible])
