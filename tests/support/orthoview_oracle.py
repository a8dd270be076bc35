"""Orthoviews by the definition: pixel by pixel and child by child, in float64 where the core uses float32."""

from __future__ import annotations

import functools
import itertools
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf

REACH_PIXELS = 4.0
"""Number of pixel widths of the larger picture by which surfaces of one block may lie behind the first."""

Triple = tuple[int, int, int]
Pixel = tuple[int, int]

OCTANTS: list[Triple] = [(x, y, z) for x, y, z in itertools.product((0, 1), repeat=3)]
DIRECTIONS: list[Triple] = [(x, y, z) for x, y, z in itertools.product((-1, 0, 1), repeat=3) if any((x, y, z))]


@dataclass(frozen=True)
class Axes:
    """Unit vectors of a direction's views, and the extents of a unit cube along them."""

    right: NDArray[np.float64]
    up: NDArray[np.float64]
    toward: NDArray[np.float64]

    @classmethod
    @functools.cache
    def from_direction(cls, direction: Triple) -> Axes:
        toward = np.array(direction, np.float64)
        right = np.cross([0, 1, 0], toward) if toward[0] or toward[2] else np.array([1.0, 0, 0])
        up = np.cross(toward, right)
        return cls(*(axis / np.linalg.norm(axis) for axis in (right, up, toward)))

    @functools.cached_property
    def extents(self) -> NDArray[np.float64]:
        extents: NDArray[np.float64] = np.abs(np.array([self.right, self.up, self.toward])).sum(axis=1)
        return extents


def steps_of(depth_bits: int) -> int:
    """Number of steps of a depth with some bits: sixths of a range are whole steps."""
    return ((1 << depth_bits) - 1) // 6 * 6


def decoded(codes: NDArray[np.uint16], bits: int) -> NDArray[np.float64]:
    """Unit normals (…, 3) of octahedral numbers (…, 2) of `bits` bits each."""
    x, y = np.moveaxis(codes / (2**bits - 2) * 2.0 - 1.0, -1, 0)
    z = 1 - np.abs(x) - np.abs(y)
    fold = np.maximum(-z, 0)
    normal = np.stack([x - np.copysign(fold, x), y - np.copysign(fold, y), z], axis=-1)
    unit: NDArray[np.float64] = normal / np.linalg.norm(normal, axis=-1, keepdims=True)
    return unit


def pixel_points(corner: Any, side: float, direction: Triple, size: int) -> NDArray[np.float64]:
    """World points (size, size, 3) at the front of a view's range, behind which its pixels' surfaces lie."""
    axes = Axes.from_direction(direction)
    width, height, depth = axes.extents * side
    center = np.asarray(corner) + side / 2 + axes.toward * depth / 2
    place = (np.arange(size) + 0.5) / size - 0.5
    points: NDArray[np.float64] = (
        center + place[None, :, None] * width * axes.right - place[:, None, None] * height * axes.up
    )
    return points


def cell_interval(
    points: NDArray[np.float64], direction: NDArray[np.float64], corner: Any, side: float
) -> NDArray[Any]:
    """Parameters (…, 2) at which rays enter and leave a cell; the first exceeds the second for misses."""
    low, high = np.asarray(corner), np.asarray(corner) + side
    with np.errstate(divide="ignore", invalid="ignore"):
        first, last = (low - points) / direction, (high - points) / direction
    is_along = direction == 0
    enter, leave = np.minimum(first, last), np.maximum(first, last)
    inside = (points >= low) & (points <= high)
    enter = np.where(is_along, np.where(inside, -np.inf, np.inf), enter)
    leave = np.where(is_along, np.where(inside, np.inf, -np.inf), leave)
    return np.stack([enter.max(axis=-1), leave.min(axis=-1)], axis=-1)


@dataclass
class Picture:
    """Depth in steps (infinite where empty), linear colour and normal of each pixel."""

    depth: NDArray[np.float64]
    color: NDArray[np.float64]
    normal: NDArray[np.float64]


def draw_view(
    scene: nf.Scene, colors: NDArray[np.float64], corner: Any, side: float, direction: Triple, size: int, steps: int
) -> Picture:
    """The surfaces of a cell, ray by ray; `colors` holds linear RGB of each triangle."""
    axes = Axes.from_direction(direction)
    points = pixel_points(corner, side, direction, size)
    enter, leave = np.moveaxis(cell_interval(points, -axes.toward, corner, side), -1, 0)
    depth = np.full((size, size), np.inf)
    color, normal = np.zeros((size, size, 3)), np.zeros((size, size, 3))
    rows = np.argwhere(enter <= leave)
    start = points[tuple(rows.T)] - enter[tuple(rows.T)][:, None] * axes.toward
    hits = nf.cast_rays(scene, start, np.broadcast_to(-axes.toward, start.shape))
    length = (leave - enter)[tuple(rows.T)]
    is_hit = hits.t_hit <= length
    rows, face = rows[is_hit], hits.triangle_index[is_hit]
    place = tuple(rows.T)
    depth[place] = (enter[place] + hits.t_hit[is_hit]) / (axes.extents[2] * side) * steps
    a, b, c = np.moveaxis(scene.triangles()[face].astype(np.float64), 1, 0)
    outward = np.cross(b - a, c - a)
    outward /= np.linalg.norm(outward, axis=1, keepdims=True)
    outward *= np.where(outward @ axes.toward < 0, -1, 1)[:, None]
    normal[place] = outward
    color[place] = colors[face]
    return Picture(depth, color, normal)


def reduced(picture: Picture, reach: float) -> Picture:
    """Combine four pixels into one: the least depth, and means over those at most `reach` behind it."""

    def blocks(values: NDArray[np.float64]) -> NDArray[np.float64]:
        size = len(values) // 2
        rest = values.shape[2:]
        split = values.reshape(size, 2, size, 2, *rest)
        joined: NDArray[np.float64] = np.moveaxis(split, 2, 1).reshape(size, size, 4, *rest)
        return joined

    depth, color, normal = blocks(picture.depth), blocks(picture.color), blocks(picture.normal)
    least = depth.min(axis=2)
    counts = (depth <= least[..., None] + reach) & np.isfinite(depth)
    weight = counts / np.maximum(counts.sum(axis=2, keepdims=True), 1)
    total = (normal * weight[..., None]).sum(axis=2)
    length = np.linalg.norm(total, axis=-1, keepdims=True)
    return Picture(least, (color * weight[..., None]).sum(axis=2), total / np.maximum(length, 1e-30))


def connected(
    depths: NDArray[np.uint16],
    normals: NDArray[np.float64],
    direction: Triple,
    steps: int,
    bounds: tuple[float, float, float],
) -> NDArray[np.uint8]:
    """Connections of a view's pixels, pair by pair: bits to the right, below, below right, below left."""
    size, axes = len(depths), Axes.from_direction(direction)
    pitch = axes.extents / (size, size, steps)
    found: dict[tuple[Pixel, Pixel], bool] = {}

    def connects(one: Pixel, other: Pixel) -> bool:
        if not depths[one] or not depths[other]:
            return False
        rows, columns, deeper = other[0] - one[0], other[1] - one[1], float(depths[other]) - float(depths[one])
        if abs(deeper * pitch[2]) >= bounds[0] * max(pitch[:2]):
            return False
        between = columns * pitch[0] * axes.right - rows * pitch[1] * axes.up - deeper * pitch[2] * axes.toward
        between /= np.linalg.norm(between)
        n, m = normals[one], normals[other]
        mirrored = n - 2 * (n @ between) * between
        return bool(abs(n @ between) < bounds[1] and abs(m @ between) < bounds[1] and mirrored @ m > bounds[2])

    for row, column in itertools.product(range(size - 1), repeat=2):
        block = [(row, column), (row, column + 1), (row + 1, column), (row + 1, column + 1)]
        groups = [{pixel} for pixel in block]
        for one, other in itertools.combinations(block, 2):
            if connects(one, other):
                both = next(g for g in groups if one in g) | next(g for g in groups if other in g)
                groups = [g for g in groups if not g & both] + [both]
        for one, other in itertools.combinations(block, 2):
            found[one, other] = found.get((one, other), False) or any({one, other} <= g for g in groups)
    bits = np.zeros((size, size), np.uint8)
    for (one, other), is_connected in found.items():
        first, second = sorted((one, other))
        step = (second[0] - first[0], second[1] - first[1])
        bits[first] |= is_connected << [(0, 1), (1, 0), (1, 1), (1, -1)].index(step)
    return bits
