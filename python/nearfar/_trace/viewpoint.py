"""Choice of viewpoints by ray casting: open ground near a scene's middle, facing the longest open view."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nearfar._scene.scene import Scene
from nearfar._trace.rays import cast_rays

Point = tuple[float, float, float]

EYE_HEIGHT = 1.7
"""Height of a standing person's eyes above the ground, metres."""

SMALLEST_PLACE = 3.0
"""Least size in metres of a scene that a person stands in; for a smaller one the eye's height scales with the scene."""

MOST_COMPARED = 40
"""Greatest number of open places that are compared."""

BLOCK = 64
"""Number of candidates whose rays are cast in one call, because a call takes longer than its rays."""

GRID = 41
"""Number of candidates along each side of a square grid over the middle of the scene."""

DIRECTIONS = 72
"""Number of horizontal rays from a candidate, one every 5°."""

CLEARANCE = 3.0
"""Least free distance around an eye, metres."""


@dataclass(frozen=True)
class Viewpoint:
    """An eye's position and viewing direction."""

    eye: Point
    """World position in metres."""
    forward: Point
    """Horizontal unit direction with the longest open view."""


def find(scene: Scene) -> Viewpoint:
    """Find an open place near the middle of a scene.

    A place is open if no ray from the eye hits anything within `CLEARANCE`, half of the rays reach at least ten metres
    (less in small scenes) and a quarter of them hit something. Places under the sky come before places under a roof.
    Of the first `MOST_COMPARED` open places, the one with the greatest mean distance is chosen.
    """
    eyes = _candidates(scene)
    far = min(10.0, 0.25 * float(np.hypot(*(scene.bounds[1] - scene.bounds[0])[[0, 2]] / 2.0)))
    open_places: list[tuple[float, Point]] = []
    for block in np.split(eyes, range(BLOCK, len(eyes), BLOCK)):
        distances = np.minimum(_views(scene, block), 10.0 * far)
        is_free = distances.min(axis=1) >= min(CLEARANCE, far / 2.0)
        meets = (distances < 10.0 * far).mean(axis=1) >= 0.25
        is_open = is_free & meets & (np.median(distances, axis=1) >= far)
        open_places += [(float(distances[n].mean()), _point(block[n])) for n in np.flatnonzero(is_open)]
        if len(open_places) >= MOST_COMPARED:
            break
    best = max(open_places[:MOST_COMPARED])[1] if open_places else _point(eyes[0])
    return facing_open(scene, best)


def facing_open(scene: Scene, eye: Point) -> Viewpoint:
    """Viewpoint at an eye's position that faces the longest open view."""
    return Viewpoint(eye, open_direction(scene, eye))


def facing(eye: Point, target: Point) -> Viewpoint:
    """Viewpoint at an eye's position that faces a target horizontally."""
    ahead = np.array([target[0] - eye[0], 0.0, target[2] - eye[2]])
    return Viewpoint(eye, _point(ahead / np.linalg.norm(ahead)))


def beside(scene: Scene, viewpoint: Viewpoint, distance: float) -> Point:
    """Position of a user up to `distance` metres beside the centre, on the side with more space, away from walls.

    A step to the side shows the effect of the near–far methods; a step along the view hardly changes the picture.
    """
    right = np.array([-viewpoint.forward[2], 0.0, viewpoint.forward[0]])
    free = cast_rays(scene, np.tile(viewpoint.eye, (2, 1)), np.stack([right, -right])).t_hit
    side = right if free[0] >= free[1] else -right
    return _point(np.array(viewpoint.eye) + min(distance, 0.6 * float(free.max())) * side)


def ahead(eye: Point, forward: Point, *, rise: float = 0.15) -> Point:
    """Target a metre ahead and `rise` metres above the eye: the road would fill half of a horizontal view."""
    return _point(np.array(eye) + np.array(forward) + np.array([0.0, rise, 0.0]))


def _candidates(scene: Scene) -> NDArray[np.float64]:
    """Eyes above a grid of ground points, nearest to the middle first.

    Vertical rays from above find the ground first, then rays from below. A ray that hits nothing takes the scene's
    lowest height, because models of cities often have no ground. Points more than two metres above the lowest tenth are
    left out, as they are roofs.
    """
    low, high = scene.bounds
    middle, half = (low + high) / 2.0, (high - low) / 2.0
    axis = np.linspace(-1.0, 1.0, GRID)
    grid = np.stack(np.meshgrid(axis, axis, indexing="ij"), axis=-1).reshape(-1, 2)
    grid = grid[np.argsort(np.hypot(*grid.T), kind="stable")]
    x, z = (grid * np.minimum(half * 0.6, 150.0)[[0, 2]] + middle[[0, 2]]).T
    eye_height = EYE_HEIGHT if 2.0 * half.max() >= SMALLEST_PLACE else 1.2 * half[1]
    eyes = []
    for start, sign in ((high[1] + 1.0, -1.0), (low[1] - 1.0, 1.0)):
        origins = np.column_stack([x, np.full(len(x), start), z])
        way = cast_rays(scene, origins, np.tile([0.0, sign, 0.0], (len(x), 1))).t_hit.astype(np.float64)
        ground = np.where(np.isfinite(way), start + sign * np.where(np.isfinite(way), way, 0.0), low[1])
        level = ground <= np.percentile(ground, 10.0) + 2.0
        eyes.append(np.column_stack([x, ground + eye_height, z])[level])
    return np.concatenate(eyes)


def open_direction(scene: Scene, eye: Point) -> Point:
    """Horizontal direction whose field of view of 90° has the greatest sum of the square roots of distances."""
    view = np.minimum(_view(scene, np.asarray(eye)), 500.0)
    quarter = DIRECTIONS // 4
    kernel = np.ones(quarter + 1)
    around = np.concatenate([view[-(quarter // 2) :], view, view[: quarter // 2]])
    visible = np.convolve(np.sqrt(around), kernel, mode="valid")
    # argmax takes the first of equal values: −z, the default direction of cameras.
    return _point(_ring()[int(np.argmax(visible))])


def _ring() -> NDArray[np.float64]:
    angle = np.arange(DIRECTIONS) * (2.0 * np.pi / DIRECTIONS)
    return np.column_stack([np.sin(angle), np.zeros(DIRECTIONS), -np.cos(angle)])


def _view(scene: Scene, eye: NDArray[np.float64]) -> NDArray[np.float64]:
    distances: NDArray[np.float64] = _views(scene, eye[None])[0]
    return distances


def _views(scene: Scene, eyes: NDArray[np.float64]) -> NDArray[np.float64]:
    """Distances (N, DIRECTIONS) in metres to the nearest hits around each of N eyes."""
    origins, directions = np.repeat(eyes, DIRECTIONS, axis=0), np.tile(_ring(), (len(eyes), 1))
    return cast_rays(scene, origins, directions).t_hit.reshape(-1, DIRECTIONS).astype(np.float64)


def _point(values: NDArray[np.float64]) -> Point:
    x, y, z = (float(value) for value in values)
    return x, y, z
