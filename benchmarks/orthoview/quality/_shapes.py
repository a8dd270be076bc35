"""Splats of several shapes, drawn by a simple, slow splatter."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.orthoview._splats import Pixels
from nearfar._camera.rotation import rotation
from nearfar.orthoview._gaussians import MIN_COSINE, SUN, shade

BORDER_SCALE = 1.27
"""Factor by which surfels at the border of a surface are enlarged, as in `tree.render`."""
INNER_NEIGHBOURS = 8
"""Number of neighbours connected with a pixel that is not at a border."""
STEP = 0.01
"""Step of the projection's derivative, as a share of a splat's sides."""

Floats = NDArray[np.float64]
Sides = tuple[Floats, Floats]


def circle(pixels: Pixels, camera: nf.Camera) -> Sides:
    """Discs that face the viewer and enclose a pixel."""
    width = np.hypot(*pixels.sides) / np.sqrt(2)
    ahead = np.broadcast_to(ahead_of(camera), pixels.middle.shape)
    right = _unit(np.cross(ahead, [0.0, 1.0, 0.0]))
    return width * right, width * np.cross(right, ahead)


def warped_circle(pixels: Pixels, camera: nf.Camera) -> Sides:
    """Discs of the same radius on the tangent planes."""
    width = np.hypot(*pixels.sides) / np.sqrt(2)
    tangent = _unit(np.cross(pixels.normal, _least_parallel_axis(pixels.normal)))
    return width * tangent, width * np.cross(pixels.normal, tangent)


def ellipse(pixels: Pixels, camera: nf.Camera) -> Sides:
    """Ellipses on the tangent planes, through the pixels' corners projected onto them."""
    return pixels.tangents(MIN_COSINE)


def mixed(is_surfel: NDArray[np.bool_], is_inner: NDArray[np.bool_]) -> Callable[[Pixels, nf.Camera], Sides]:
    """Ellipses for connected pixels, larger ones at borders, and balls elsewhere."""

    def shape(pixels: Pixels, camera: nf.Camera) -> Sides:
        surfel, inner = (flags[pixels.mask][:, None] for flags in (is_surfel, is_inner))
        factor = np.where(inner, 1.0, BORDER_SCALE)
        pairs = zip(ellipse(pixels, camera), circle(pixels, camera), strict=True)
        u, v = (np.where(surfel, factor * flat, ball) for flat, ball in pairs)
        return u, v

    return shape


def inner(bits: NDArray[np.uint8]) -> NDArray[np.bool_]:
    """Whether all eight neighbours of the pixels (H, W) are connected with them."""
    right, below, below_right, below_left = (bits >> n & 1 for n in range(4))
    count = np.zeros(bits.shape, int)
    for link, (y, x) in ((right, (0, 1)), (below, (1, 0)), (below_right, (1, 1)), (below_left, (1, -1))):
        count += link
        count += np.roll(link, (y, x), axis=(0, 1))
    return np.asarray(count == INNER_NEIGHBOURS)


def rasterize(pixels: Pixels, sides: Sides, camera: nf.Camera) -> tuple[NDArray[np.uint8], Floats]:
    """Draw the nearest splats: colours (H, W, 3) and depths (H, W), infinite for empty pixels."""
    width, height = camera.size
    middle = camera.project(pixels.middle)
    u, v = (_projection(camera, pixels.middle, side) for side in sides)
    normal = np.cross(*sides)
    plane = (normal * (pixels.middle - np.array(camera.position))).sum(axis=1)
    half_extent = np.sqrt((u * u + v * v) / 2)
    determinant = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
    _, rays = camera.rays()
    rays = rays / (rays @ ahead_of(camera))[..., None]
    low, high = (np.floor(middle[:, :2] + sign * half_extent).astype(int) for sign in (-1, 1))
    nearest = np.full(width * height, np.iinfo(np.uint64).max, np.uint64)
    span = (high - low).max(axis=1)
    for reach in np.unique(span):
        splats_of_reach = np.flatnonzero(span == reach)
        for down in range(reach + 1):
            for across in range(reach + 1):
                x, y = low[splats_of_reach, 0] + across, low[splats_of_reach, 1] + down
                px, py = x + 0.5 - middle[splats_of_reach, 0], y + 0.5 - middle[splats_of_reach, 1]
                a = (v[splats_of_reach, 1] * px - v[splats_of_reach, 0] * py) / determinant[splats_of_reach]
                b = (u[splats_of_reach, 0] * py - u[splats_of_reach, 1] * px) / determinant[splats_of_reach]
                # The sample that contains the middle counts, so that thin splats do not vanish.
                is_inside = (a * a + b * b <= 0.5) | ((np.abs(px) <= 0.5) & (np.abs(py) <= 0.5))
                is_inside &= (x >= 0) & (x < width) & (y >= 0) & (y < height)
                splat, x, y = splats_of_reach[is_inside], x[is_inside], y[is_inside]
                with np.errstate(divide="ignore"):
                    depth = plane[splat] / (normal[splat] * rays[y, x]).sum(axis=1)
                # An edge-on splat has no plane that intersects the ray nearby.
                longest = sum(np.linalg.norm(side[splat], axis=1) for side in sides)
                depth = np.where(np.abs(depth - middle[splat, 2]) < longest, depth, middle[splat, 2])
                key = depth.astype(np.float32).view(np.uint32).astype(np.uint64) << np.uint64(32)
                np.minimum.at(nearest, y * width + x, key | splat.astype(np.uint64))
    is_shown = nearest < np.iinfo(np.uint64).max
    depths = np.full(width * height, np.inf)
    depths[is_shown] = (nearest[is_shown] >> np.uint64(32)).astype(np.uint32).view(np.float32)
    colors = np.zeros((width * height, 3), np.uint8)
    colors[is_shown] = _lit(pixels, camera)[(nearest[is_shown] & np.uint64(0xFFFFFFFF)).astype(np.int64)]
    return colors.reshape(height, width, 3), depths.reshape(height, width)


def _lit(pixels: Pixels, camera: nf.Camera) -> NDArray[np.uint8]:
    """Colours in the light of `nf.render`, with normals turned towards the viewer."""
    toward = np.array(camera.position) - pixels.middle
    side = np.where((pixels.normal * toward).sum(axis=1, keepdims=True) < 0, -1.0, 1.0)
    return shade(pixels.color, (side * pixels.normal).astype(np.float32), SUN)


def _projection(camera: nf.Camera, middle: Floats, side: Floats) -> Floats:
    """Vectors (N, 2) in pixels that show a side in the picture, by the derivative of the projection."""
    ahead, behind = (camera.project(middle + sign * STEP * side)[:, :2] for sign in (1, -1))
    return np.asarray((ahead - behind) / (2 * STEP))


def ahead_of(camera: nf.Camera) -> Floats:
    """Unit vector in the direction of the camera's view."""
    return -rotation(camera.orientation)[:, 2]


def _least_parallel_axis(normals: Floats) -> Floats:
    """For each vector the coordinate axis that is least parallel to it."""
    return np.asarray(np.eye(3)[np.abs(normals).argmin(axis=1)])


def _unit(vectors: Floats) -> Floats:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=-1, keepdims=True))
