"""A slow cut through a tree of orthoviews: recursion over all cells, and the half-spaces of a picture by corners."""

from __future__ import annotations

import itertools
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
import trimesh
from numpy.typing import ArrayLike, NDArray

import nearfar as nf
from nearfar.orthoview._grid import Grid, Place

Cell = tuple[int, Place]
"""Level and place."""

FACES = {
    0: ((0, 0, -1), (0, 1, 0), (1, 0, 0)),
    1: ((0, 0, 1), (0, 1, 0), (-1, 0, 0)),
    2: ((1, 0, 0), (0, 0, -1), (0, 1, 0)),
    3: ((1, 0, 0), (0, 0, 1), (0, -1, 0)),
    4: ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    5: ((-1, 0, 0), (0, 1, 0), (0, 0, -1)),
}
"""Right, up and forward of the faces of a cube map."""

DOUBT = 1e-7
"""Metres within which rounding decides."""


class DoubtfulError(Exception):
    """Rounding decides the result."""


@dataclass
class Expected:
    """A cut that includes cells outside of the picture."""

    reach: float
    cells: set[Cell] = field(default_factory=set)
    leaves: set[Place] = field(default_factory=set)
    partial: set[Cell] = field(default_factory=set)
    """Cells that are drawn in part, which are among `cells`."""
    is_doubtful: bool = False
    """Whether rounding decides a level."""


def pixel(camera: nf.Camera) -> float:
    """Side of a square of a pixel's area: metres at a distance of 1 m, or anywhere for parallel rays."""
    fov = camera.fov
    sides = (-1, 1, -1, 1) if isinstance(fov, nf.CubeFace) else (fov.left, fov.right, fov.down, fov.up)
    left, right, down, up = sides
    return math.sqrt((right - left) / camera.width * (up - down) / camera.height)


@dataclass(frozen=True)
class World:
    """The non-empty cells of a tree."""

    grid: Grid
    shown: Mapping[Cell, int]
    """Bits of the non-empty directions of each cell."""
    low: NDArray[np.float64]
    high: NDArray[np.float64]
    """Corners of the cells, in their order."""

    @classmethod
    def from_cells(cls, grid: Grid, shown: Mapping[Cell, int]) -> World:
        boxes = np.array([grid.box(*cell) for cell in shown])
        return cls(grid, shown, boxes[:, 0], boxes[:, 1])


def lattice(low: NDArray[np.float64], high: NDArray[np.float64], count: int = 2) -> NDArray[np.float64]:
    """Points of boxes (N, 3) on lattices that have their corners (N, count³, 3); by default the corners alone."""
    steps = np.array(list(itertools.product(np.linspace(0, 1, count), repeat=3)))
    return np.asarray(low[:, None] + steps * (high - low)[:, None])


def nearest(eye: NDArray[np.float64], low: NDArray[np.float64], high: NDArray[np.float64]) -> NDArray[np.float64]:
    """Distances of the nearest points of boxes (…, 3), metres; 0 within them."""
    return np.asarray(np.linalg.norm(np.maximum(0, np.maximum(low - eye, eye - high)), axis=-1))


def seen_from(
    camera: nf.Camera, low: NDArray[np.float64], high: NDArray[np.float64], sight: NDArray[np.float64] | None
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Bounds of the apparent distances of boxes' points: those from the eye over the acuity away from the gaze."""
    eye = np.array(camera.position)
    least, most = nearest(eye, low, high), np.linalg.norm(lattice(low, high) - eye, axis=2).max(axis=1)
    if sight is None:
        return least, most
    middle, radius = (low + high) / 2 - eye, np.linalg.norm(high - low, axis=1) / 2
    distance = np.linalg.norm(middle, axis=1)
    away = np.degrees(np.arccos(np.clip(middle @ sight / distance / np.linalg.norm(sight), -1, 1)))
    half = np.where(radius < distance, np.degrees(np.arcsin(np.minimum(radius / distance, 1))), 180.0)
    pixel_deg = math.degrees(math.atan(pixel(camera)))
    sharp, dull = (
        nf.lod.acuity(angles, pixel_deg=pixel_deg)
        for angles in (np.maximum(away - half, 0), np.minimum(away + half, 180))
    )
    return least / sharp, most / dull


def sight_through(camera: nf.Camera, gaze: tuple[float, float]) -> NDArray[np.float64]:
    """The direction through an integer position in a picture: the mean of the four pixels about it at a depth of 1."""
    (x, y), (_, ahead) = map(int, gaze), camera.rays()
    through = ahead[y - 1 : y + 1, x - 1 : x + 1]
    sight: NDArray[np.float64] = (through / (through @ camera_axis(camera))[..., None]).mean(axis=(0, 1))
    return sight


def camera_axis(camera: nf.Camera) -> NDArray[np.float64]:
    """Viewing direction of a camera."""
    if isinstance(camera.fov, nf.CubeFace):
        return np.array(FACES[camera.fov.face][2], np.float64)
    x, y, z, w = camera.orientation
    forward: NDArray[np.float64] = -trimesh.transformations.quaternion_matrix([w, x, y, z])[:3, 2]
    return forward


def expected(
    world: World,
    camera: nf.Camera,
    pitch: float,
    error_px: float,
    *,
    geometry: bool,
    band: float | None = None,
    gaze: tuple[float, float] | None = None,
) -> Expected:
    """The cut of a tree; `pitch` is the width of a leaf's pixel."""
    found = Expected(pitch / (pixel(camera) * error_px))
    sight = None if gaze is None else sight_through(camera, gaze)
    # For parallel rays a pixel of the picture is as wide anywhere as it is at 1 m for perspective.
    near, far = np.ones((2, len(world.low)))
    if not isinstance(camera.fov, nf.Orthographic):
        near, far = seen_from(camera, world.low, world.high, sight)
    bounds_of = dict(zip(world.shown, zip(near.tolist(), far.tolist(), strict=True), strict=True))

    def visit(level: int, place: Place) -> None:
        if (level, place) not in world.shown:
            return
        near, far = bounds_of[level, place]
        needed = 2**level * found.reach
        bounds = [needed] if band is None or level == 0 else [needed, needed * (1 + band)]
        found.is_doubtful |= any(abs(at - bound) < DOUBT for at in (near, far) for bound in bounds)
        if near >= bounds[-1] or (level == 0 and not geometry):
            found.cells.add((level, place))
        elif level == 0:
            found.leaves.add(place)
        else:
            if len(bounds) == 2 and far >= needed:
                found.cells.add((level, place))
                found.partial.add((level, place))
            for _, child in world.grid.children(level, place):
                visit(level - 1, child)

    visit(world.grid.levels - 1, (0, 0, 0))
    return found


def margins(camera: nf.Camera, corners: NDArray[np.float64]) -> NDArray[np.float64]:
    """Signed extent of boxes into the half-space of the picture into which they extend least; negative outside.

    Corners are (N, 8, 3).
    """
    offsets = corners - np.array(camera.position)
    if isinstance(camera.fov, nf.CubeFace):
        x, y, depth = np.moveaxis(offsets @ np.array(FACES[camera.fov.face], np.float64).T, -1, 0)
        left, right, down, up = -1.0, 1.0, -1.0, 1.0
    else:
        qx, qy, qz, qw = camera.orientation
        x, y, back = np.moveaxis(offsets @ trimesh.transformations.quaternion_matrix([qw, qx, qy, qz])[:3, :3], -1, 0)
        depth = -back
        left, right, down, up = camera.fov.left, camera.fov.right, camera.fov.down, camera.fov.up
    along = np.ones_like(depth) if isinstance(camera.fov, nf.Orthographic) else depth
    sides = [x - left * along, right * along - x, y - down * along, up * along - y, depth]
    return np.asarray(np.min([side.max(axis=1) for side in sides], axis=0))


def are_sampled(camera: nf.Camera, points: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Whether one of some points (N, P, 3) is in the picture."""
    x, y, _ = camera.project(points.reshape(-1, 3)).T  # NaN behind the camera.
    is_in = (x >= 0) & (x <= camera.width) & (y >= 0) & (y <= camera.height)
    return np.asarray(is_in.reshape(points.shape[:2]).any(axis=1))


def raised(unit: NDArray[np.float64], lift_deg: float) -> tuple[NDArray[np.float64], bool]:
    """A direction rotated about a horizontal axis towards +y, at most to +y, and whether it is there.

    A direction straight up or down has no such axis, and stays.
    """
    axis = np.cross(unit, (0, 1, 0))
    if lift_deg == 0 or not axis.any():
        return unit, False
    below = math.atan2(float(np.linalg.norm(axis)), unit[1])
    if np.linalg.norm(axis) < DOUBT or abs(below - math.radians(lift_deg)) < DOUBT:
        raise DoubtfulError
    angle = min(math.radians(lift_deg), below)
    turned: NDArray[np.float64] = trimesh.transformations.rotation_matrix(angle, axis)[:3, :3] @ unit
    return turned, angle == below


def nearest_directions(
    toward: ArrayLike, directions: Sequence[Place], views: int, mask: int, lift_deg: float = 0.0
) -> list[int]:
    """Numbers of the directions in a mask nearest to one, raised by an angle, padded with −1.

    Directions at equal angles from +y are equally near to a viewer that is raised to there: then those nearest to the
    unraised viewer come first.
    """
    unit = np.asarray(toward) / np.linalg.norm(toward)
    lifted, is_highest = raised(unit, lift_deg)
    own, others = ([angle_between(way, one) for one in directions] for way in (unit, lifted))
    keys = sorted(zip((np.round(others, 6) if is_highest else others), own, range(len(directions)), strict=True))
    for (angle, beside, _), (next_angle, next_beside, _) in itertools.pairwise(keys):
        if next_angle - angle < DOUBT and (not is_highest or next_beside - beside < DOUBT):
            raise DoubtfulError
    numbers = [number for *_, number in keys if mask >> number & 1][:views]
    return numbers + [-1] * (views - len(numbers))


def angle_between(unit: NDArray[np.float64], way: ArrayLike) -> float:
    """Angle between a unit vector and a vector, radians."""
    return math.acos(np.clip(np.dot(unit, way) / np.linalg.norm(way), -1, 1))
