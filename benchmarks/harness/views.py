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

MIN_BOUNDARY = 100
"""Least number of pixels along the boundary of the near part in the continuous picture of a view."""

_GRID, _REACH = 38, 600.0
"""Number of places along each axis that `center_for` tries, and their greatest distance from the middle in metres."""
_RING = 90
"""Number of horizontal directions in which `center_for` looks for surfaces."""
_NEAREST, _FARTHEST = 5.0, 8.0
"""Least and greatest distance of users from the centre, metres."""


def center_for(scene: nf.Scene, radius: float) -> Point:
    """Find the place on the ground, free for all users, where most directions hit a surface near `radius`."""
    low, high = scene.bounds
    axis = np.linspace(-1.0, 1.0, _GRID)
    half_size = np.minimum(0.35 * (high - low), _REACH)[[0, 2]]
    x, z = (np.stack(np.meshgrid(axis, axis), axis=-1).reshape(-1, 2) * half_size + (0.5 * (low + high))[[0, 2]]).T
    ground = np.nan_to_num(surface_heights(scene, np.column_stack([x, z]), from_above=True), nan=low[1])
    eyes = np.column_stack([x, ground + 1.7, z])[ground <= np.percentile(ground, 10.0) + 2.0]
    _, distances = distances_around(scene, eyes, _RING)
    ends = ((distances > 0.9 * radius) & (distances < 1.1 * radius)).sum(axis=1)
    best_eye = eyes[np.argmax(ends * (distances.min(axis=1) >= _FARTHEST + 1.0))]
    return float(best_eye[0]), float(best_eye[1]), float(best_eye[2])


def views(reduced: nf.ReducedScene, size: tuple[int, int], count: int) -> Iterator[nf.Camera]:
    """Choose users 5 to 8 m from the centre, all around it, who look at right angles to the line from the centre.

    At most a hundred places are tried, so there may be fewer views than `count`.
    """
    center, count_so_far = np.array(reduced.center), 0
    for k in range(100):
        turn = 2.0 * np.pi * GOLDEN * k
        direction = np.array([np.cos(turn), 0.0, np.sin(turn)])
        sideways = np.array([-np.sin(turn), -0.02, np.cos(turn)]) * (1 if k % 2 else -1)
        user = center + direction * (_NEAREST + (_FARTHEST - _NEAREST) * count_so_far / (count - 1))
        camera = nf.Camera.look_at(user, user + sideways, fov=nf.Fov.symmetric(90, size[0] / size[1]), size=size)
        if _is_free(reduced.scene, center, user, direction, sideways):
            frame = reduced.render(camera, channels=("position",))
            if nf.metrics.boundary_mask(frame, center=reduced.center, radius=reduced.r2).sum() >= MIN_BOUNDARY:
                count_so_far += 1
                yield camera
        if count_so_far == count:
            return


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


def distances_around(
    scene: nf.Scene, eyes: NDArray[np.float64], count: int
) -> tuple[NDArray[np.float64], NDArray[np.float32]]:
    """Horizontal directions (C, 3) all around, and distances (N, C) in metres from each eye to surfaces there."""
    angle = np.arange(count) * (2.0 * np.pi / count)
    ring = np.column_stack([np.cos(angle), np.zeros(count), np.sin(angle)])
    hits = nf.cast_rays(scene, np.repeat(eyes, count, axis=0), np.tile(ring, (len(eyes), 1)))
    return ring, hits.t_hit.reshape(-1, count)
