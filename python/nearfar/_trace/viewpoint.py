"""Viewpoints that are chosen by casting rays: open ground near a scene's middle, facing its longest view."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nearfar._scene.scene import Scene
from nearfar._trace.rays import cast_rays

Point = tuple[float, float, float]

EYE_HEIGHT = 1.7
"""Metres above the ground: a standing person's eyes."""

SMALLEST_PLACE = 3.0
"""Metres across: smaller scenes are things, not places, and an eye's height is a share of the scene's."""

MOST_COMPARED = 40
"""Open places that are compared."""

BLOCK = 64
"""Candidates that are looked at together: calls cost more than their rays."""

GRID = 41
"""Candidates along each side of the middle of the scene."""

DIRECTIONS = 72
"""Directions looked in from a candidate: one every 5°."""

CLEARANCE = 3.0
"""Metres that must be free around an eye."""


@dataclass(frozen=True)
class Viewpoint:
    """An eye and the direction that it faces."""

    eye: Point
    """World position in metres."""
    forward: Point
    """Horizontal unit direction with the longest open view."""


def find(scene: Scene) -> Viewpoint:
    """Find an open place near the middle of a scene.

    A place is open if nothing stands within `CLEARANCE` of a person's eyes, half of the directions see at least ten
    metres far (less in small scenes) and a quarter of them see something. Of the first `MOST_COMPARED` such places,
    those under the sky before those under a roof, the one with the widest view is taken.
    """
    eyes = _candidates(scene)
    far = min(10.0, 0.25 * float(np.hypot(*(scene.bounds[1] - scene.bounds[0])[[0, 2]] / 2.0)))
    open_places: list[tuple[float, Point]] = []
    for block in np.split(eyes, range(BLOCK, len(eyes), BLOCK)):
        seen = np.minimum(_views(scene, block), 10.0 * far)
        is_free = seen.min(axis=1) >= min(CLEARANCE, far / 2.0)
        meets = (seen < 10.0 * far).mean(axis=1) >= 0.25
        is_open = is_free & meets & (np.median(seen, axis=1) >= far)
        open_places += [(float(seen[n].mean()), _point(block[n])) for n in np.flatnonzero(is_open)]
        if len(open_places) >= MOST_COMPARED:
            break
    best = max(open_places[:MOST_COMPARED])[1] if open_places else _point(eyes[0])
    return facing_open(scene, best)


def facing_open(scene: Scene, eye: Point) -> Viewpoint:
    """An eye that faces the longest open view."""
    return Viewpoint(eye, open_direction(scene, eye))


def facing(eye: Point, target: Point) -> Viewpoint:
    """An eye that faces a target, level."""
    ahead = np.array([target[0] - eye[0], 0.0, target[2] - eye[2]])
    return Viewpoint(eye, _point(ahead / np.linalg.norm(ahead)))


def beside(scene: Scene, viewpoint: Viewpoint, distance: float) -> Point:
    """Where the user stands: up to `distance` metres beside the centre, on the wider side and off its walls.

    Steps to the side show what the methods do to the picture; steps along the view hardly change it.
    """
    right = np.array([-viewpoint.forward[2], 0.0, viewpoint.forward[0]])
    free = cast_rays(scene, np.tile(viewpoint.eye, (2, 1)), np.stack([right, -right])).t_hit
    side = right if free[0] >= free[1] else -right
    return _point(np.array(viewpoint.eye) + min(distance, 0.6 * float(free.max())) * side)


def ahead(eye: Point, forward: Point, *, rise: float = 0.15) -> Point:
    """A point to look at: a metre ahead and `rise` metres above the eye, because a level view is half road."""
    return _point(np.array(eye) + np.array(forward) + np.array([0.0, rise, 0.0]))


def _candidates(scene: Scene) -> NDArray[np.float64]:
    """Eyes above the ground of a grid, nearest to the middle first: those seen from above, then those from below.

    Where rays meet nothing, the ground is the lowest height of the scene, because cities often come without any.
    Among places seen from above, roofs are left out.
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
    """Horizontal direction in which a field of view of a quarter turn sees farthest on the whole."""
    view = np.minimum(_view(scene, np.asarray(eye)), 500.0)
    quarter = DIRECTIONS // 4
    kernel = np.ones(quarter + 1)
    around = np.concatenate([view[-(quarter // 2) :], view, view[: quarter // 2]])
    seen = np.convolve(np.sqrt(around), kernel, mode="valid")
    # Among equals the first, −z, where cameras look by themselves.
    return _point(_ring()[int(np.argmax(seen))])


def _ring() -> NDArray[np.float64]:
    angle = np.arange(DIRECTIONS) * (2.0 * np.pi / DIRECTIONS)
    return np.column_stack([np.sin(angle), np.zeros(DIRECTIONS), -np.cos(angle)])


def _view(scene: Scene, eye: NDArray[np.float64]) -> NDArray[np.float64]:
    distances: NDArray[np.float64] = _views(scene, eye[None])[0]
    return distances


def _views(scene: Scene, eyes: NDArray[np.float64]) -> NDArray[np.float64]:
    """Distances (N, DIRECTIONS) to what each of N eyes sees around it."""
    origins, directions = np.repeat(eyes, DIRECTIONS, axis=0), np.tile(_ring(), (len(eyes), 1))
    return cast_rays(scene, origins, directions).t_hit.reshape(-1, DIRECTIONS).astype(np.float64)


def _point(values: NDArray[np.float64]) -> Point:
    x, y, z = (float(value) for value in values)
    return x, y, z
