"""Ground heights at places of a grid, from vertical rays from above and from below."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nearfar._scene.scene import Scene
from nearfar._trace.rays import cast_rays

Floats = NDArray[np.float64]

_RINGS = ((6, 0.5), (12, 0.95))
"""Number of rays around a place, and their distance from it as a share of the cell's radius."""


def ground_heights(scene: Scene, places: Floats, radius: float) -> Floats:
    """Find the ground height (K,) in metres at places (K, 2) as x, z, each the centre of a cell with a radius.

    The ground is the surface hit from above, unless it rises more steeply than 45° from surfaces hit by other rays in
    the cell: then the place is on a roof, a tree or a car, and the lowest of those surfaces is used. City models often
    have no ground. If a ray in the cell misses, the lowest surface hit from below is used, such as the bottom of a
    house; if all rays miss, the lowest height of the scene.
    """
    turns = [np.arange(count) * (2.0 * np.pi / count) for count, _ in _RINGS]
    offsets = np.concatenate(
        [np.zeros((1, 2))]
        + [
            share * radius * np.column_stack([np.cos(angles), np.sin(angles)])
            for angles, (_, share) in zip(turns, _RINGS, strict=True)
        ]
    )
    points = (places[:, None] + offsets).reshape(-1, 2)
    top, bottom = (_surface(scene, points, from_above=above).reshape(len(places), -1) for above in (True, False))
    least = np.min(bottom, axis=1, initial=np.inf, where=np.isfinite(bottom))
    least = np.where(np.isfinite(least), least, scene.bounds[0, 1])
    misses = ~np.isfinite(top)
    levels = np.where(misses, least[:, None], top)
    away = np.hypot(*offsets.T)
    is_ground = ~misses[:, 0] & (levels[:, :1] - levels <= away + 1e-3).all(axis=1)
    return np.where(is_ground, levels[:, 0], np.where(misses.any(axis=1), least, levels.min(axis=1)))


def _surface(scene: Scene, points: Floats, *, from_above: bool) -> Floats:
    """Heights (M,) of the first surface at points (M, 2) seen from above or from below; NaN without any."""
    low, high = scene.bounds[:, 1]
    start, sign = (high + 1.0, -1.0) if from_above else (low - 1.0, 1.0)
    origins = np.insert(points, 1, start, axis=1)
    way = cast_rays(scene, origins, np.tile([0.0, sign, 0.0], (len(points), 1))).t_hit.astype(np.float64)
    return np.where(np.isfinite(way), start + sign * np.where(np.isfinite(way), way, 0.0), np.nan)
