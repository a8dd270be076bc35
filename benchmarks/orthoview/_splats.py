"""Pictures of one view's splats from beside its direction: pieces of planes, and balls as squares that face it."""

from __future__ import annotations

import numpy as np
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.orthoview._leaves import Leaf
from nearfar import _core
from nearfar.orthoview import _codec
from nearfar.orthoview._layout import Layout

TURN = 20.0
"""Degrees between a view's direction and the picture's; directions that neighbour one another are 45° apart."""

STEEPEST = 0.2
"""Least cosine between a normal and the view's direction by which a splat is stretched."""


def camera(leaf: Leaf, direction: tuple[int, int, int], size: int) -> nf.Camera:
    """Parallel rays onto the whole leaf, from a view's direction turned upwards and to the side."""
    (right, up, toward), extents = _core.orthoview_axes(direction)
    turn = np.radians(TURN / np.sqrt(2))
    eye = np.array(toward) + np.tan(turn) * (np.array(right) + np.array(up))
    center, half = leaf.box.mean(axis=0), max(extents) * leaf.side / 2
    return nf.Camera.look_at(
        center + eye / np.linalg.norm(eye) * 2 * leaf.side,
        center,
        fov=nf.Orthographic(-half, half, -half, half),
        size=(size, size),
        up=up,
    )


def truth(leaf: Leaf, direction: tuple[int, int, int], size: int) -> NDArray[np.uint8]:
    """The leaf itself, ray by ray."""
    box = nf.Clip(box=leaf.box)
    return nf.render(leaf.scene, camera(leaf, direction, size), clip=box, samples=4).to_image()


def picture(leaf: Leaf, views: _core.OrthoViews, layout: Layout, number: int) -> NDArray[np.uint8]:
    """The splats of one view, shaded by their normals with the formula of all pictures."""
    direction = layout.directions[number]
    onto = camera(leaf, direction, layout.size)
    return nf.render(splats(leaf, views, layout, number, onto), onto, samples=4).to_image()


def splats(leaf: Leaf, views: _core.OrthoViews, layout: Layout, number: int, onto: nf.Camera) -> nf.Scene:
    (right, up, toward), extents = _core.orthoview_axes(layout.directions[number])
    axes = np.array([right, up, toward])
    width, height, deep = np.array(extents) * leaf.side
    codes = views.depths()[number, ..., 0]
    seen = codes > 0
    place = (np.arange(layout.size) + 0.5) / layout.size - 0.5
    across, down = (values[seen] for values in np.meshgrid(place, place))
    behind = (codes[seen] - 0.5) * deep / layout.steps
    local = np.stack([across * width, -down * height, deep / 2 - behind], axis=1)
    is_surfel = _core.orthoview_surfels(views.connected(_codec.CONNECTED))[number, ..., 0][seen]
    normals = views.vectors()[number][seen].astype(np.float64)
    n = normals @ axes.T
    pixel = np.array([width, height]) / layout.size
    zero, slope = np.zeros(len(n)), -n[:, :2] / np.maximum(n[:, 2:], STEEPEST)
    u = np.stack([zero + 1, zero, slope[:, 0]], axis=1) @ axes * pixel[0]
    v = np.stack([zero, zero + 1, slope[:, 1]], axis=1) @ axes * pixel[1]
    _, along = onto.rays()
    side = np.cross(along[0, 0], up)
    side /= np.linalg.norm(side)
    u[~is_surfel], v[~is_surfel] = side * pixel.max(), np.cross(side, along[0, 0]) * pixel.max()
    center = leaf.box.mean(axis=0) + local @ axes
    corners = center[:, None] + np.stack([-u - v, u - v, u + v, v - u], axis=1) / 2
    first = 4 * np.arange(len(center))[:, None, None]
    rgba = np.column_stack([views.colors()[number][seen], np.full(len(center), 255, np.uint8)])
    mesh = trimesh.Trimesh(
        corners.reshape(-1, 3),
        (first + np.array([[0, 1, 2], [0, 2, 3]])).reshape(-1, 3),
        vertex_normals=normals.repeat(4, axis=0),
        vertex_colors=rgba.repeat(4, axis=0),
        process=False,
    )
    return nf.Scene.from_trimesh(mesh)
