"""Slow definitions of horizontal radii, and random towns, for tests of partitions."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf


def exact_least_squared(triangle: Any, axis: tuple[Fraction, Fraction]) -> Fraction:
    """Squared least ρ in rational arithmetic: 0 if the axis pierces the triangle, else the nearest point of an edge."""
    points = [(Fraction(float(x)) - axis[0], Fraction(float(z)) - axis[1]) for x, _, z in triangle]
    pairs = [(points[i], points[(i + 1) % 3]) for i in range(3)]
    sides = [a[0] * b[1] - a[1] * b[0] for a, b in pairs]
    if all(s > 0 for s in sides) or all(s < 0 for s in sides):
        return Fraction(0)
    nearest = []
    for a, b in pairs:
        edge = (b[0] - a[0], b[1] - a[1])
        length = edge[0] ** 2 + edge[1] ** 2
        t = min(max(-(a[0] * edge[0] + a[1] * edge[1]) / length, Fraction(0)), Fraction(1)) if length else Fraction(0)
        nearest.append((a[0] + t * edge[0]) ** 2 + (a[1] + t * edge[1]) ** 2)
    return min(nearest)


def exact_radii(triangle: Any, center: Any) -> tuple[float, float]:
    """Least and greatest ρ from exact squares."""
    axis = (Fraction(float(center[0])), Fraction(float(center[2])))
    greatest = max((Fraction(float(x)) - axis[0]) ** 2 + (Fraction(float(z)) - axis[1]) ** 2 for x, _, z in triangle)
    return math.sqrt(exact_least_squared(triangle, axis)), math.sqrt(greatest)


def numpy_radii(corners: NDArray[Any], center: Any) -> NDArray[np.float64]:
    """Least and greatest ρ in float64 arrays, for many triangles."""
    plan = corners[..., [0, 2]].astype(np.float64) - [center[0], center[2]]
    following = np.roll(plan, -1, axis=1)
    edge = following - plan
    length = (edge**2).sum(-1)
    t = np.clip(-(plan * edge).sum(-1) / np.where(length > 0, length, 1), 0, 1)
    distance = np.linalg.norm(plan + t[..., None] * edge, axis=-1).min(1)
    side = plan[..., 0] * following[..., 1] - plan[..., 1] * following[..., 0]
    inside = (side > 0).all(1) | (side < 0).all(1)
    return np.stack([np.where(inside, 0, distance), np.linalg.norm(plan, axis=-1).max(1)], axis=1)


def town(seed: int = 0, count: int = 400, size: float = 120.0) -> NDArray[np.float32]:
    """Walls, roofs, slivers, points and two large ground triangles around the middle."""
    random = np.random.default_rng(seed)
    corners = random.uniform(-size, size, (count, 1, 3)) + random.normal(0, 8, (count, 3, 3))
    corners[: count // 2, 2, [0, 2]] = corners[: count // 2, 1, [0, 2]]
    corners[:10] = corners[:10, :1]
    ground = [[[-500, 0, -500], [500, 0, -500], [500, 0, 500]], [[-500, 0, -500], [500, 0, 500], [-500, 0, 500]]]
    return np.concatenate([corners, ground]).astype(np.float32)


def soup(corners: NDArray[Any]) -> nf.Scene:
    """A scene of triangles that share no vertices."""
    return nf.Scene.from_arrays(corners.reshape(-1, 3), np.arange(3 * len(corners)).reshape(-1, 3))
