"""Distance between two surfaces, greatest and mean, in both directions."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import random
from nearfar._scene.scene import Scene
from nearfar.lod._simplify.surface import Surface

SAMPLES = 20_000
"""Number of sample points on each surface, uniform by area; the mean distance is accurate to a few thousandths."""

_SEED, _PLACE, _FIRST, _SECOND = 7, 0, 1, 2
"""Seed, and streams of random numbers: position within a share of the area, and two barycentric weights in a face."""


def deviation(base: tuple[Scene, Surface], level: tuple[Scene, Surface]) -> tuple[float, float]:
    """Compute the greatest and the mean distance between a base and a level, metres.

    The greatest distance is over all vertices and sample points of both surfaces, each to the nearest point of the
    other surface. It is a lower bound of the Hausdorff distance, up to rounding, because samples may miss places. The
    mean is over the sample points only.
    """
    greatest, means = 0.0, []
    for (_, surface), (scene, _) in ((base, level), (level, base)):
        vertices = _distances(scene, surface.positions[np.unique(surface.faces)])
        between = _distances(scene, spread_points(surface, SAMPLES))
        greatest = max(greatest, float(vertices.max(initial=0.0)), float(between.max(initial=0.0)))
        means.append(float(between.mean()) if len(between) else float(vertices.mean()))
    return greatest, (means[0] + means[1]) / 2


def _distances(scene: Scene, points: NDArray[np.float32] | NDArray[np.float64]) -> NDArray[np.float64]:
    return _core.nearest_points(scene._core, np.ascontiguousarray(points + scene.origin))[0]


def spread_points(surface: Surface, count: int) -> NDArray[np.float64]:
    """Sample points (count, 3) uniformly by area, relative to the surface's origin; empty without area.

    Each of `count` equal shares of the area, in the order of the faces, gets one point; the points are the same on
    every machine.
    """
    corners = surface.positions[surface.faces].astype(np.float64)
    first_side, second_side = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    ends = np.cumsum(np.linalg.norm(np.cross(first_side, second_side), axis=1))
    if not ends[-1] > 0:
        return np.zeros((0, 3))
    index = np.arange(count, dtype=np.uint64)
    area_below = (index + random.uniform(_SEED, _PLACE, index)) * (ends[-1] / count)
    face = np.minimum(np.searchsorted(ends, area_below, side="right"), len(ends) - 1)
    u, v = random.uniform(_SEED, _FIRST, index), random.uniform(_SEED, _SECOND, index)
    is_mirrored = u + v > 1
    u, v = np.where(is_mirrored, 1 - u, u)[:, None], np.where(is_mirrored, 1 - v, v)[:, None]
    return np.asarray(corners[face, 0] + u * first_side[face] + v * second_side[face])
