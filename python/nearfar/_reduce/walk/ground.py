"""Ground heights at the centres of a grid, from vertical rays from above and from below."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nearfar._scene.scene import Scene
from nearfar._trace.rays import surface_heights

Floats = NDArray[np.float64]

_RINGS = ((6, 0.5), (12, 0.95))
"""Number of rays around a centre, and their distance from it as a share of the cell's radius."""


def ground_heights(scene: Scene, centers: Floats, radius: float) -> Floats:
    """Find the ground height (K,) in metres at the centres (K, 2) as x, z of cells with a radius.

    The ground is the surface hit from above, unless it rises more steeply than 45° from surfaces hit by other rays in
    the cell: then the centre is on a roof, a tree or a car, and the lowest of those surfaces is used. City models often
    have no ground. If a ray in the cell misses, the lowest surface hit from below is used, such as the bottom of a
    house; if all rays miss, the lowest height of the scene.
    """
    offsets = [np.zeros((1, 2))]
    for count, share in _RINGS:
        angles = np.arange(count) * (2.0 * np.pi / count)
        offsets.append(share * radius * np.column_stack([np.cos(angles), np.sin(angles)]))
    points = (centers[:, None] + np.concatenate(offsets)).reshape(-1, 2)
    shape = (len(centers), -1)
    top, bottom = (surface_heights(scene, points, from_above=above).reshape(shape) for above in (True, False))
    lowest = np.min(bottom, axis=1, initial=np.inf, where=np.isfinite(bottom))
    lowest = np.where(np.isfinite(lowest), lowest, scene.bounds[0, 1])
    misses = ~np.isfinite(top)
    heights = np.where(misses, lowest[:, None], top)
    distances = np.hypot(*np.concatenate(offsets).T)
    is_ground = ~misses[:, 0] & (heights[:, :1] - heights <= distances + 1e-3).all(axis=1)
    return np.where(is_ground, heights[:, 0], np.where(misses.any(axis=1), lowest, heights.min(axis=1)))
