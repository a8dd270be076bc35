"""Slow ray casting in float64, the oracle: every ray against every triangle, with an independent shading formula."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf

Array = NDArray[Any]

# OpenGL's and Vulkan's table of cube faces: sc, tc and ma as (axis, sign).
CUBE_TABLE = [
    ((2, -1), (1, -1), (0, 1)),
    ((2, 1), (1, -1), (0, -1)),
    ((0, 1), (2, 1), (1, 1)),
    ((0, 1), (2, -1), (1, -1)),
    ((0, 1), (1, -1), (2, 1)),
    ((0, -1), (1, -1), (2, -1)),
]

SUN_DIRECTION = np.array([0.5, 0.75, 0.3]) / 0.95
SUN = np.array([0.60, 0.56, 0.50])
SKY_DIRECTION = np.array([-0.2, 0.9, 0.3]) / np.sqrt(0.94)
SKY_LOW, SKY_HIGH = np.array([0.130, 0.135, 0.150]), np.array([0.380, 0.420, 0.480])
NADIR, HORIZON, ZENITH = np.array([0.24, 0.25, 0.26]), np.array([0.66, 0.74, 0.82]), np.array([0.16, 0.34, 0.66])


@dataclass
class Surface:
    """A mesh with one material."""

    vertices: Array
    faces: NDArray[np.int64]
    base_color: tuple[float, float, float, float] = (0.8, 0.8, 0.8, 1.0)
    cutoff: float | None = None
    uvs: Array | None = None
    texture: NDArray[np.uint8] | None = None
    colors: NDArray[np.uint8] | None = None
    normals: Array | None = None
    emission: tuple[float, float, float] = (0.0, 0.0, 0.0)
    emission_texture: NDArray[np.uint8] | None = None
    unlit: bool = False
    levels: list[Array] = field(default_factory=list)
    emission_levels: list[Array] = field(default_factory=list)


@dataclass
class Pixels:
    """Hits of N rays; arrays of length N."""

    color: Array
    range: Array
    object_id: NDArray[np.int64]
    face_id: NDArray[np.int64]
    position: Array
    normal: Array


@dataclass
class View:
    """Rays with unit directions; a ray is `widths + spreads * distance` metres wide."""

    origins: Array
    directions: Array
    widths: Array
    spreads: Array


def rotate(quaternion: tuple[float, ...], vectors: Array) -> Array:
    """Rows rotated by a unit quaternion (x, y, z, w); textbook matrix."""
    x, y, z, w = quaternion
    matrix = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    return np.asarray(vectors @ matrix.T)


def view(camera: nf.Camera, offset: tuple[float, float] = (0.5, 0.5), samples: int = 1) -> View:
    """Rays through one position in every pixel, in row-major order; each covers a share of its pixel."""
    (width, height), fov = camera.size, camera.fov
    axes = rotate(camera.orientation, np.eye(3))
    bounds = (-1.0, 1.0, -1.0, 1.0)
    if isinstance(fov, nf.CubeFace):
        axes = np.zeros((3, 3))
        for row, (axis, sign), turn in zip(axes, CUBE_TABLE[fov.face], (1, -1, -1), strict=True):
            row[axis] = sign * turn
    else:
        bounds = (fov.left, fov.right, fov.down, fov.up)
    left, right, down, up = bounds
    s, t = np.meshgrid((np.arange(width) + offset[0]) / width, (np.arange(height) + offset[1]) / height)
    plane = np.stack([left + (right - left) * s, up + (down - up) * t], -1).reshape(-1, 2)
    size = np.sqrt((right - left) / width * (up - down) / height / samples)
    eye = np.array(camera.position)
    if isinstance(fov, nf.Orthographic):
        directions = np.tile(-axes[2], (len(plane), 1))
        return View(eye + plane @ axes[:2], directions, np.full(len(plane), size), np.zeros(len(plane)))
    directions = plane @ axes[:2] - axes[2]
    secant = np.linalg.norm(directions, axis=1)
    return View(np.tile(eye, (len(plane), 1)), directions / secant[:, None], np.zeros(len(plane)), size * secant**-1.5)


def irradiance(normals: Array) -> Array:
    """Linear RGB (N, 3) of white surfaces by their normals."""
    sky = 0.5 + 0.5 * normals @ SKY_DIRECTION
    sun = np.maximum(normals @ SUN_DIRECTION, 0.0)
    return np.asarray(SKY_LOW + (SKY_HIGH - SKY_LOW) * sky[:, None] + SUN * sun[:, None])


def background(directions: Array) -> Array:
    """Linear RGB of the sky by unit directions (N, 3)."""
    y = directions[:, 1:2]
    end = np.where(y < 0.0, NADIR, ZENITH)
    return np.asarray(HORIZON + (end - HORIZON) * np.sqrt(np.abs(y)))


def linear_from_srgb(codes: NDArray[np.uint8]) -> Array:
    s = codes / 255.0
    return np.where(s <= 0.04045, s / 12.92, ((s + 0.055) / 1.055) ** 2.4)


def levels_of(texture: NDArray[np.uint8], cutout: bool) -> list[Array]:
    """Linear RGB of all levels; those of cut-out materials are weighted by alpha."""
    color = linear_from_srgb(texture[..., :3])
    weight = texture[..., 3:] / 255.0 + 1 / 1024 if cutout else np.ones_like(color[..., :1])
    levels, image = [color], np.concatenate([color * weight, weight], axis=2)
    while max(image.shape[:2]) > 1:
        image = halved(halved(image, 0), 1)
        levels.append(image[..., :3] / image[..., 3:])
    return levels


def halved(image: Array, axis: int) -> Array:
    """Half the texels along an axis: each is the integral over its share of the old ones."""
    count = image.shape[axis]
    integral = np.concatenate([np.zeros_like(image.take([0], axis)), np.cumsum(image, axis)], axis)
    edges = np.linspace(0.0, count, max(count // 2, 1) + 1)
    below = np.minimum(edges.astype(int), count - 1)
    part = (edges - below)[:, None] if axis else (edges - below)[:, None, None]
    at = integral.take(below, axis) * (1 - part) + integral.take(below + 1, axis) * part
    return np.asarray(np.diff(at, axis=axis) * ((len(edges) - 1) / count))


def bilinear(image: Array, uv: Array) -> Array:
    """Values (N, C) of a repeating image at (N, 2) coordinates, v upwards."""
    height, width = image.shape[:2]
    x, y = uv[:, 0] * width - 0.5, (1.0 - uv[:, 1]) * height - 0.5
    column, row = np.floor(x).astype(int), np.floor(y).astype(int)
    fx, fy = (x - column)[:, None], (y - row)[:, None]
    left, right, upper, lower = column % width, (column + 1) % width, row % height, (row + 1) % height
    above = image[upper, left] * (1 - fx) + image[upper, right] * fx
    below = image[lower, left] * (1 - fx) + image[lower, right] * fx
    return np.asarray(above * (1 - fy) + below * fy)


def trilinear(levels: list[Array], uv: Array, level: Array) -> Array:
    level = np.clip(level, 0.0, len(levels) - 1.0)
    fine = np.minimum(np.floor(level).astype(int), len(levels) - 1)
    values = np.stack([bilinear(image, uv) for image in levels])
    coarse = np.minimum(fine + 1, len(levels) - 1)
    ray = np.arange(len(uv))
    part = (level - fine)[:, None]
    return np.asarray(values[fine, ray] * (1 - part) + values[coarse, ray] * part)


def cast(surfaces: list[Surface], rays: View, segment: tuple[float, float] = (0.0, np.inf)) -> Pixels:
    """Find the nearest hit of each ray among all triangles, between two distances."""
    origins, directions, count = rays.origins, rays.directions, len(rays.directions)
    best = np.full(count, np.inf)
    color, normal = background(directions), np.full((count, 3), np.nan)
    object_id, face_id = np.full(count, -1), np.full(count, -1)
    first = 0
    for number, surface in enumerate(surfaces):
        for index, face in enumerate(surface.faces):
            t, u, v = _meet(surface.vertices[face], origins, directions)
            hit = (t < best) & (t >= segment[0]) & (t <= segment[1])
            hit[hit] &= _solid(surface, face, u[hit], v[hit])
            if hit.any():
                best[hit] = t[hit]
                object_id[hit], face_id[hit] = number, first + index
                wide = rays.widths[hit] + rays.spreads[hit] * t[hit]
                color[hit], normal[hit] = _shade(surface, face, u[hit], v[hit], directions[hit], wide)
        first += len(surface.faces)
    finite = np.isfinite(best)[:, None]
    position = np.where(finite, origins + np.where(finite, best[:, None], 0.0) * directions, np.nan)
    return Pixels(color, best, object_id, face_id, position, normal)


def _meet(corners: Array, origins: Array, directions: Array) -> tuple[Array, Array, Array]:
    """Distance, infinite for a miss, and the weights of the second and third corner (Möller, Trumbore 1997)."""
    a, ab, ac = corners[0], corners[1] - corners[0], corners[2] - corners[0]
    p = np.cross(directions, ac)
    with np.errstate(divide="ignore", invalid="ignore"):
        inverse = 1.0 / (p @ ab)
        s = origins - a
        u = np.einsum("ij,ij->i", s, p) * inverse
        q = np.cross(s, ab)
        v = np.einsum("ij,ij->i", directions, q) * inverse
        t = (q @ ac) * inverse
        inside = (u >= 0) & (v >= 0) & (u + v <= 1) & (t >= 0)
    return np.where(inside, t, np.inf), u, v


def _blend(corners: Array, u: Array, v: Array) -> Array:
    return np.asarray(corners[0] * (1 - u - v)[:, None] + corners[1] * u[:, None] + corners[2] * v[:, None])


def _solid(surface: Surface, face: NDArray[np.int64], u: Array, v: Array) -> NDArray[np.bool_]:
    if surface.cutoff is None:
        return np.ones(len(u), bool)
    alpha = np.full(len(u), float(surface.base_color[3]))
    if surface.colors is not None:
        alpha *= _blend(surface.colors[face, 3:] / 255.0, u, v)[:, 0]
    if surface.texture is not None and surface.uvs is not None:
        alpha *= bilinear(surface.texture[..., 3:] / 255.0, _blend(surface.uvs[face], u, v))[:, 0]
    return np.asarray(alpha >= surface.cutoff)


def _shade(
    surface: Surface, face: NDArray[np.int64], u: Array, v: Array, directions: Array, widths: Array
) -> tuple[Array, Array]:
    a, b, c = surface.vertices[face]
    cross = np.cross(b - a, c - a)
    outside = cross / np.linalg.norm(cross)
    cosine = directions @ outside
    normals = np.where(cosine[:, None] > 0, -outside, outside)
    albedo = np.tile(np.array(surface.base_color[:3]), (len(u), 1))
    if surface.colors is not None:
        albedo = albedo * _blend(linear_from_srgb(surface.colors[face, :3]), u, v)
    footprints = widths / np.sqrt(np.abs(cosine) * np.linalg.norm(cross))
    if surface.texture is not None and surface.uvs is not None:
        surface.levels = surface.levels or levels_of(surface.texture, surface.cutoff is not None)
        albedo = albedo * _filtered(surface.levels, surface.uvs[face], u, v, footprints)
    emission = np.array(surface.emission)
    if surface.emission_texture is not None and surface.uvs is not None:
        surface.emission_levels = surface.emission_levels or levels_of(surface.emission_texture, False)
        emission = emission * _filtered(surface.emission_levels, surface.uvs[face], u, v, footprints)
    light = 1.0 if surface.unlit else irradiance(_smooth(surface, face, u, v, outside, cosine, normals))
    return albedo * light + emission, normals


def _filtered(levels: list[Array], uvs: Array, u: Array, v: Array, footprints: Array) -> Array:
    """Colours of a texture; a footprint is divided by the root of twice the face's area."""
    height, width = levels[0].shape[:2]
    ua, ub, uc = uvs * (width, height)
    (bx, by), (cx, cy) = ub - ua, uc - ua
    return trilinear(levels, _blend(uvs, u, v), np.log2(footprints * np.sqrt(abs(bx * cy - by * cx))))


def _smooth(
    surface: Surface, face: NDArray[np.int64], u: Array, v: Array, outside: Array, cosine: Array, flat: Array
) -> Array:
    """Shading normals: interpolated between the corners', where zeros mean the face's; the same for both sides."""
    if surface.normals is None or not surface.normals[face].any():
        return flat
    corners = surface.normals[face]
    corners = np.where(corners.any(axis=1, keepdims=True), corners, outside)
    between = _blend(corners, u, v)
    between /= np.linalg.norm(between, axis=1, keepdims=True)
    return np.where(cosine[:, None] > 0, -between, between)
