"""Choice of viewpoints by ray casting: open ground near a scene's middle, or a place in front of a single object."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from nearfar._scene.scene import Scene
from nearfar._trace.rays import Hits, cast_rays, is_hit_from_behind, surface_heights

Point = tuple[float, float, float]

EYE_HEIGHT = 1.7
"""Height of a standing person's eyes above the ground, metres."""

MIN_SCENE_SIZE = 3.0
"""Least size in metres of a scene that a person stands in; a smaller one is an object."""

GROUND_SHAPE = (20.0, 0.2)
"""Least size in metres, and greatest ratio of height to size, of scenes without open places that count as ground."""

OBJECT_DISTANCE = 2.25
"""Distance of the eye from the middle of an object, in radii of its bounding sphere, at which it fits into the view."""

NEAR_DISTANCE = 30.0
"""Distance in metres within which open places have surfaces if possible, so that a user's steps show parallax."""

MAX_COMPARED = 40
"""Maximum number of open places that are compared."""

BLOCK = 64
"""Number of candidates whose rays are cast in one call; a call for a single candidate takes longer than its rays."""

GRID = 41
"""Number of candidates along each side of a square grid over the middle of the scene."""

OUTSIDE_SHARE = 0.25
"""Distance of an eye from a scene's bounds, as a share of their horizontal diagonal, beyond which it is outside."""

MIN_HIT_SHARE = 0.25
"""Least share of the rays of a view that hit something."""

DIRECTIONS = 72
"""Number of horizontal rays from a candidate, one every 5°."""

CLEARANCE = 3.0
"""Least free distance around an eye, metres."""


MAX_DEPTH = 50.0
"""Depth in metres below a scene's bounds beyond which a centre counts as a mistake."""


@dataclass(frozen=True)
class Viewpoint:
    """An eye's position and viewing direction."""

    eye: Point
    """World position in metres."""
    forward: Point
    """Horizontal unit direction: with the longest open view, or towards the scene's middle."""
    middle: Point | None = None
    """Middle of a scene that the eye sees from outside; None within a scene."""

    @property
    def is_outside(self) -> bool:
        """Whether the eye sees the scene from outside, as it sees a single object."""
        return self.middle is not None

    @property
    def target(self) -> Point:
        """Point to look at: from outside the scene's middle, else above the horizon, so that the road fills less."""
        return self.middle or ahead(self.eye, self.forward)


def find(scene: Scene) -> Viewpoint:
    """Find an open place near the middle of a scene, or a place in front of a scene that is a single object.

    A place is open if no ray from the eye hits anything within `CLEARANCE`, half of the rays reach at least ten metres
    (less in small scenes), a quarter of them hit something, and no half of the horizon is empty, as it would be beside
    a convex object. Places under the sky are tried before places under a roof. The latter are open only if the rays hit
    the front of surfaces, because an eye that sees backs is inside a solid. Of the first `MAX_COMPARED` open places,
    the one with the greatest mean distance is chosen, if possible among places with near surfaces. A scene without an
    open place is an object, unless it is flat and wide.
    """
    size = scene.bounds[1] - scene.bounds[0]
    if size.max() < MIN_SCENE_SIZE:
        return in_front(scene)
    sky_eyes, roofed_eyes = _candidates(scene)
    eyes = np.concatenate([sky_eyes, roofed_eyes])
    far_distance = min(10.0, 0.25 * float(np.hypot(*size[[0, 2]] / 2.0)))
    open_places: list[tuple[bool, float, Point]] = []
    for start in range(0, len(eyes), BLOCK):
        block = eyes[start : start + BLOCK]
        hits = _hits(scene, block)
        is_around = _has_hits_all_around(np.isfinite(_distances(hits)))
        distances = np.minimum(_distances(hits), 10.0 * far_distance)
        is_free = distances.min(axis=1) >= min(CLEARANCE, far_distance / 2.0)
        meets = (distances < 10.0 * far_distance).mean(axis=1) >= 0.25
        is_open = is_free & meets & is_around & (np.median(distances, axis=1) >= far_distance)
        roofed = is_open & (start + np.arange(len(block)) >= len(sky_eyes))
        if roofed.any():
            is_open[roofed] = ~_inside_solid(scene, hits, roofed)
        # Without near surfaces the methods show no effect.
        has_near = distances.min(axis=1) <= NEAR_DISTANCE
        numbers = np.flatnonzero(is_open)
        open_places += [(bool(has_near[n]), float(distances[n].mean()), _point(block[n])) for n in numbers]
        if len(open_places) >= MAX_COMPARED:
            break
    if open_places:
        return facing_open(scene, max(open_places[:MAX_COMPARED])[2])
    min_size, max_flatness = GROUND_SHAPE
    is_ground = size.max() >= min_size and size[1] <= max_flatness * size.max()
    return facing_open(scene, _point(eyes[0])) if is_ground else in_front(scene)


def check_center(scene: Scene, center: Point) -> Point:
    """Return a centre; ValueError if it is deep below the scene, or farther away than the scene's size."""
    low, high = scene.bounds
    offsets = np.maximum(np.maximum(low - center, np.subtract(center, high)), 0.0)
    distance, size = float(np.linalg.norm(offsets)), float(np.linalg.norm(high - low))
    depth = float(low[1] - center[1])
    if scene.triangle_count and (distance > max(size, MAX_DEPTH) or depth > MAX_DEPTH):
        where = f"{depth:.4g} m below" if depth > MAX_DEPTH else f"{distance:.4g} m away from"
        extent = " to ".join(",".join(f"{value:.6g}" for value in corner) for corner in (low, high))
        raise ValueError(
            f"center: expected a place in or near the scene, which reaches from {extent} m, got one {where} it"
        )
    return center


def in_front(scene: Scene) -> Viewpoint:
    """Return a viewpoint outside a scene, at the height of its middle, from which all of it is in view."""
    low, high = scene.bounds
    distance = OBJECT_DISTANCE * max(float(np.linalg.norm(high - low)) / 2.0, 1e-6)
    forward, middle = np.array([-0.5, 0.0, -np.sqrt(0.75)]), (low + high) / 2.0
    return Viewpoint(_point(middle - distance * forward), _point(forward), _point(middle))


def facing_open(scene: Scene, eye: Point) -> Viewpoint:
    """Return a viewpoint that faces the longest open view, or from far away the middle of the scene."""
    low, high = scene.bounds[:, [0, 2]]
    x_z = np.array(eye)[[0, 2]]
    distance = np.linalg.norm(np.maximum(np.maximum(low - x_z, x_z - high), 0.0))
    if distance > OUTSIDE_SHARE * np.linalg.norm(high - low):
        middle = _point(scene.bounds.mean(axis=0))
        return replace(facing(eye, middle), middle=middle)
    return Viewpoint(eye, open_direction(scene, eye))


def facing(eye: Point, target: Point) -> Viewpoint:
    """Return a viewpoint that faces a target horizontally."""
    direction = np.array([target[0] - eye[0], 0.0, target[2] - eye[2]])
    return Viewpoint(eye, _point(direction / np.linalg.norm(direction)))


def beside(scene: Scene, viewpoint: Viewpoint, distance: float) -> list[Point]:
    """Return positions of a user up to `distance` metres to both sides of the centre, the side with more space first.

    They keep away from walls. A step to the side shows the effect of the near–far methods; a step along the view hardly
    changes the picture.
    """
    right = np.array([-viewpoint.forward[2], 0.0, viewpoint.forward[0]])
    sides = np.stack([right, -right])
    free = cast_rays(scene, np.tile(viewpoint.eye, (2, 1)), sides).t_hit
    order = (0, 1) if free[0] >= free[1] else (1, 0)
    return [_point(np.array(viewpoint.eye) + min(distance, 0.6 * float(free[n])) * sides[n]) for n in order]


def ahead(eye: Point, forward: Point, *, rise: float = 0.15) -> Point:
    """Return a target a metre ahead and `rise` metres above the eye; in a horizontal view the road would fill half."""
    return _point(np.array(eye) + np.array(forward) + np.array([0.0, rise, 0.0]))


def _candidates(scene: Scene) -> list[NDArray[np.float64]]:
    """Return eyes above a grid of ground points, nearest to the middle first: under the sky, and under a roof.

    Vertical rays from above find the ground under the sky, rays from below the ground under a roof. Where a ray hits
    nothing, the scene's lowest height is taken, because models of cities often have no ground. Points more than two
    metres above the lowest tenth are left out, because they are roofs.
    """
    low, high = scene.bounds
    middle, half_size = (low + high) / 2.0, (high - low) / 2.0
    axis = np.linspace(-1.0, 1.0, GRID)
    grid = np.stack(np.meshgrid(axis, axis, indexing="ij"), axis=-1).reshape(-1, 2)
    grid = grid[np.argsort(np.hypot(*grid.T), kind="stable")]
    x, z = (grid * np.minimum(half_size * 0.6, 150.0)[[0, 2]] + middle[[0, 2]]).T
    eyes = []
    for from_above in (True, False):
        ground = np.nan_to_num(surface_heights(scene, np.column_stack([x, z]), from_above=from_above), nan=low[1])
        is_low = ground <= np.percentile(ground, 10.0) + 2.0
        eyes.append(np.column_stack([x, ground + EYE_HEIGHT, z])[is_low])
    return eyes


def horizontal_distances(scene: Scene, eye: Point) -> NDArray[np.float64]:
    """Return the distances (DIRECTIONS,) in metres that an eye sees horizontally, clockwise from −z; +∞ for a miss."""
    distances: NDArray[np.float64] = _distances(_hits(scene, np.asarray(eye)[None]))[0]
    return distances


def is_roofed(scene: Scene, eye: Point) -> bool:
    """Return whether most of nine rays upwards, one vertical and eight at 30° to it, hit something."""
    turns = np.radians(np.arange(8) * 45.0)
    tilted = np.stack([0.5 * np.sin(turns), np.full(8, np.sqrt(0.75)), -0.5 * np.cos(turns)], axis=-1)
    rays = np.concatenate([[[0.0, 1.0, 0.0]], tilted])
    return bool(cast_rays(scene, np.asarray(eye), rays).hit.mean() > 0.5)


def open_direction(scene: Scene, eye: Point) -> Point:
    """Return the horizontal direction whose view of 90° has the greatest sum of the square roots of distances.

    Views in which less than `MIN_HIT_SHARE` of the rays hit something are used only if there are no others.
    """
    distances = horizontal_distances(scene, eye)
    quarter = DIRECTIONS // 4
    kernel = np.ones(quarter + 1)

    def sum_of_quarter(values: NDArray[np.float64]) -> NDArray[np.float64]:
        ring = np.concatenate([values[-(quarter // 2) :], values, values[: quarter // 2]])
        return np.convolve(ring, kernel, mode="valid")

    shows = sum_of_quarter(np.isfinite(distances).astype(np.float64)) >= MIN_HIT_SHARE * len(kernel)
    visible = sum_of_quarter(np.sqrt(np.minimum(distances, 500.0)))
    if shows.any():
        visible = np.where(shows, visible, -1.0)
    # argmax takes the first of equal values: −z, the default direction of cameras.
    return _point(_horizontal_rays()[int(np.argmax(visible))])


def _horizontal_rays() -> NDArray[np.float64]:
    angle = np.arange(DIRECTIONS) * (2.0 * np.pi / DIRECTIONS)
    return np.column_stack([np.sin(angle), np.zeros(DIRECTIONS), -np.cos(angle)])


def _has_hits_all_around(is_hit: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return whether every half of the horizon has a hit, for rows of `DIRECTIONS` rays."""
    half_count = DIRECTIONS // 2
    padded = np.concatenate([np.zeros((len(is_hit), 1), bool), is_hit, is_hit[:, :half_count]], axis=1)
    counts = np.cumsum(padded, axis=1)
    return np.asarray((counts[:, half_count:] > counts[:, :-half_count]).all(axis=1))


def _hits(scene: Scene, eyes: NDArray[np.float64]) -> Hits:
    """Return the nearest hits of `DIRECTIONS` horizontal rays around each of N eyes."""
    origins, directions = np.repeat(eyes, DIRECTIONS, axis=0), np.tile(_horizontal_rays(), (len(eyes), 1))
    return cast_rays(scene, origins, directions)


def _distances(hits: Hits) -> NDArray[np.float64]:
    """Return the distances (N, DIRECTIONS) in metres to the hits around each of N eyes."""
    return hits.t_hit.reshape(-1, DIRECTIONS).astype(np.float64)


def _inside_solid(scene: Scene, hits: Hits, selected: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return whether most of the rays that hit something around each selected eye hit it from behind."""
    numbers = hits.triangle_index.reshape(-1, DIRECTIONS)[selected]
    hits_back = is_hit_from_behind(scene, numbers, _horizontal_rays())
    return np.asarray(hits_back.sum(axis=1) > 0.5 * (numbers >= 0).sum(axis=1))


def _point(values: NDArray[np.float64]) -> Point:
    x, y, z = (float(value) for value in values)
    return x, y, z
