"""Chooses views for measuring the near–far methods: centres with surfaces at r₂, and users around them."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from nearfar._trace.rays import surface_heights

GOLDEN = 0.381966
"""Golden angle as a share of a turn; its multiples give directions that never repeat."""

Point = tuple[float, float, float]

_RING = 90
_NEAREST, _FARTHEST = 5.0, 8.0
"""Least and greatest distance of users from the centre, metres."""


def center_for(scene: nf.Scene, radius: float, *, grid: int = 38, reach: float = 600.0) -> Point:
    """Find the place on the ground, free for all users, where most directions hit a surface near `radius`.

    Without surfaces near the radius, a view does not show the boundary of the near part.
    """
    low, high = scene.bounds
    axis = np.linspace(-1.0, 1.0, grid)
    half_size = np.minimum(0.35 * (high - low), reach)[[0, 2]]
    x, z = (np.stack(np.meshgrid(axis, axis), axis=-1).reshape(-1, 2) * half_size + (0.5 * (low + high))[[0, 2]]).T
    ground = np.nan_to_num(surface_heights(scene, np.column_stack([x, z]), from_above=True), nan=low[1])
    eyes = np.column_stack([x, ground + 1.7, z])[ground <= np.percentile(ground, 10.0) + 2.0]
    distances = _distances_around(scene, eyes)
    ends = ((distances > 0.9 * radius) & (distances < 1.1 * radius)).sum(axis=1)
    best_eye = eyes[np.argmax(ends * (distances.min(axis=1) >= _FARTHEST + 1.0))]
    return float(best_eye[0]), float(best_eye[1]), float(best_eye[2])


def views(
    reduced: nf.ReducedScene, size: tuple[int, int], count: int, *, least_boundary: int = 100
) -> Iterator[nf.Camera]:
    """Choose users 5 to 8 m from the centre all around it, who look at right angles to the way from it.

    At most a hundred places are tried, so that there may be fewer than `count`.
    """
    center, count_so_far = np.array(reduced.center), 0
    for k in range(100):
        turn = 2.0 * np.pi * GOLDEN * k
        direction = np.array([np.cos(turn), 0.0, np.sin(turn)])
        sideways = np.array([-np.sin(turn), -0.02, np.cos(turn)]) * (1 if k % 2 else -1)
        user = center + direction * (_NEAREST + (_FARTHEST - _NEAREST) * count_so_far / (count - 1))
        camera = nf.Camera.look_at(user, user + sideways, fov=nf.Fov.symmetric(90, size[0] / size[1]), size=size)
        is_free = _is_free(reduced.scene, center, user, direction, sideways)
        if is_free and boundary_length(reduced, camera) >= least_boundary:
            count_so_far += 1
            yield camera
        if count_so_far == count:
            return


def boundary_length(reduced: nf.ReducedScene, camera: nf.Camera) -> int:
    """Number of pixels along the end of the near part in the continuous picture."""
    frame = reduced.render(camera, channels=("position",))
    return int(nf.metrics.boundary_mask(frame, center=reduced.center, radius=reduced.r2).sum())


def _is_free(
    scene: nf.Scene,
    center: NDArray[np.float64],
    user: NDArray[np.float64],
    direction: NDArray[np.float64],
    sideways: NDArray[np.float64],
) -> bool:
    """Whether nothing lies within 2 m of the user, nor between the centre and the user."""
    directions = np.stack([direction, -direction, sideways, -sideways])
    free_distance = float(nf.cast_rays(scene, np.tile(user, (4, 1)), directions).t_hit.min())
    distance = float(nf.cast_rays(scene, center[None], direction[None]).t_hit[0])
    return free_distance > 2.0 and distance > float(np.linalg.norm(user - center))


def _distances_around(scene: nf.Scene, eyes: NDArray[np.float64]) -> NDArray[np.float32]:
    """Distances in metres from each eye to surfaces in directions all around."""
    angle = np.arange(_RING) * (2.0 * np.pi / _RING)
    ring = np.column_stack([np.cos(angle), np.zeros(_RING), np.sin(angle)])
    hits = nf.cast_rays(scene, np.repeat(eyes, _RING, axis=0), np.tile(ring, (len(eyes), 1)))
    distances: NDArray[np.float32] = hits.t_hit.reshape(-1, _RING)
    return distances
