"""Pictures of one view's splats from another direction: pieces of planes, and balls as squares facing the viewer."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.orthoview._leaves import Leaf, axes_of, metres_of
from nearfar import _core
from nearfar.orthoview import _codec
from nearfar.orthoview._layout import Layout

TURN = 20.0
"""Angle in degrees between a view's direction and the picture's; adjacent directions are 45° apart."""

MIN_COSINE = 0.2
"""Cosine between a normal and the view's direction below which splats are stretched no further."""

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Pixels:
    """Non-empty pixels of a view."""

    middle: Floats
    """World positions (N, 3), metres."""
    normal: Floats
    """Unit normals towards the view's viewer (N, 3)."""
    color: NDArray[np.uint8]
    """sRGB without light (N, 3)."""
    axes: Floats
    """Unit vectors to the right, upwards and towards the viewer (3, 3)."""
    sides: Floats
    """Width and height of a pixel (2,), metres."""
    mask: NDArray[np.bool_]
    """Mask of these pixels (H, W)."""

    def tangents(self, least: float) -> tuple[Floats, Floats]:
        """Sides of pixels on the tangent planes (N, 3); normals' cosines to the view are clamped to `least` or more."""
        n = self.normal @ self.axes.T
        zero, slope = np.zeros(len(n)), -n[:, :2] / np.maximum(n[:, 2:], least)
        u = np.stack([zero + 1, zero, slope[:, 0]], axis=1) @ self.axes * self.sides[0]
        v = np.stack([zero, zero + 1, slope[:, 1]], axis=1) @ self.axes * self.sides[1]
        return u, v


def pixels(leaf: Leaf, views: _core.OrthoViews, layout: Layout, number: int) -> Pixels:
    """Non-empty pixels of one view of a leaf."""
    axes, (width, height, deep) = axes_of(layout.directions[number], leaf.side)
    metres = metres_of(views, number, layout, leaf.side)
    is_shown = np.isfinite(metres)
    steps = (np.arange(layout.size) + 0.5) / layout.size - 0.5
    across, down = (values[is_shown] for values in np.meshgrid(steps, steps))
    local = np.stack([across * width, -down * height, deep / 2 - metres[is_shown]], axis=1)
    sides = np.array([width, height]) / layout.size
    normal = views.vectors()[number][is_shown].astype(np.float64)
    return Pixels(leaf.box.mean(axis=0) + local @ axes, normal, views.colors()[number][is_shown], axes, sides, is_shown)


def camera(leaf: Leaf, direction: tuple[int, int, int], size: int) -> nf.Camera:
    """Camera with parallel rays onto the whole leaf, from a view's direction turned upwards and to the side."""
    (right, up, toward), extents = _core.orthoview_axes(direction)
    turn = np.radians(TURN / np.sqrt(2))
    eye = np.array(toward) + np.tan(turn) * (np.array(right) + np.array(up))
    center, half_width = leaf.box.mean(axis=0), max(extents) * leaf.side / 2
    return nf.Camera.look_at(
        center + eye / np.linalg.norm(eye) * 2 * leaf.side,
        center,
        fov=nf.Orthographic(-half_width, half_width, -half_width, half_width),
        size=(size, size),
        up=up,
    )


def truth(leaf: Leaf, direction: tuple[int, int, int], size: int) -> NDArray[np.uint8]:
    """Render the leaf itself, ray by ray."""
    return nf.render(leaf.scene, camera(leaf, direction, size), clip=nf.Clip(box=leaf.box), samples=4).to_image()


def picture(leaf: Leaf, views: _core.OrthoViews, layout: Layout, number: int) -> NDArray[np.uint8]:
    """Render the splats of one view, shaded by their normals with the formula of all pictures."""
    picture_camera = camera(leaf, layout.directions[number], layout.size)
    return nf.render(splats(leaf, views, layout, number, picture_camera), picture_camera, samples=4).to_image()


def splats(leaf: Leaf, views: _core.OrthoViews, layout: Layout, number: int, picture_camera: nf.Camera) -> nf.Scene:
    view_pixels = pixels(leaf, views, layout, number)
    is_surfel = _core.orthoview_surfels(views.connected(_codec.CONNECTION_LIMITS))[number, ..., 0][view_pixels.mask]
    u, v = view_pixels.tangents(MIN_COSINE)
    _, rays = picture_camera.rays()
    side = np.cross(rays[0, 0], view_pixels.axes[1])
    side /= np.linalg.norm(side)
    longest = view_pixels.sides.max()
    u[~is_surfel], v[~is_surfel] = side * longest, np.cross(side, rays[0, 0]) * longest
    corners = view_pixels.middle[:, None] + np.stack([-u - v, u - v, u + v, v - u], axis=1) / 2
    first_corner = 4 * np.arange(len(corners))[:, None, None]
    mesh = trimesh.Trimesh(
        corners.reshape(-1, 3),
        (first_corner + np.array([[0, 1, 2], [0, 2, 3]])).reshape(-1, 3),
        vertex_normals=view_pixels.normal.repeat(4, axis=0),
        vertex_colors=np.column_stack([view_pixels.color, np.full(len(corners), 255, np.uint8)]).repeat(4, axis=0),
        process=False,
    )
    return nf.Scene.from_trimesh(mesh)
