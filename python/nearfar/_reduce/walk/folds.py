"""Limits of a walk: distance at which the picture folds, height differences of a path, jumps between centres."""

from __future__ import annotations

import functools
import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import progress
from nearfar._bend import fold_margin
from nearfar._camera.camera import Camera, CubeFace, Fov
from nearfar._camera.rotation import rotation
from nearfar._impostor.bake import PIXELS_PER_DEGREE

Floats = NDArray[np.float64]

HEIGHT_STEP = 0.1
"""Step in metres between heights for which margins are computed."""

_NOISE = 1e-6
"""Tolerance in steps for rounding of the height."""

_MAX_HEIGHT = 1e6
"""Height in metres above which all pictures count as folded."""


def walkable_distance(kind: str, r1: float, r2: float, height: float) -> float:
    """Horizontal distance in metres from the centre at which the picture folds; infinite for the conventional method.

    `height` is the user's height above or below the centre, metres. It is rounded up to a multiple of `HEIGHT_STEP`,
    which only reduces the distance, so that results can be cached: `fold_margin` takes too long for a frame.
    """
    if kind == "none":
        return math.inf
    return -math.inf if height > _MAX_HEIGHT else _walkable(kind, r1, r2, math.ceil(height / HEIGHT_STEP - _NOISE))


@functools.lru_cache(maxsize=4096)
def _walkable(kind: str, r1: float, r2: float, steps: int) -> float:
    return fold_margin((0.0, steps * HEIGHT_STEP, 0.0), center=(0.0, 0.0, 0.0), r1=r1, r2=r2, kind=kind)


def height_differences(path: Floats, centers: Floats, reach: float) -> Floats:
    """Return the greatest height difference (K,) between each centre (K, 3) and the path (N, 3) within its reach."""
    starts, ends = (path[:-1], path[1:]) if len(path) > 1 else (path, path)
    steps, climb = ends - starts, np.zeros(len(centers))
    square = steps[:, 0] ** 2 + steps[:, 2] ** 2
    with progress.bar("checking heights") as report:
        for number, center in enumerate(centers):
            report(number, len(centers))
            x, z = starts[:, 0] - center[0], starts[:, 2] - center[2]
            # Parameters t of a piece at which |start + t step − O| = reach: square t² − 2 b t + c = 0.
            b, c = -(x * steps[:, 0] + z * steps[:, 2]), x * x + z * z - reach * reach
            root = np.sqrt(np.maximum(b * b - square * c, 0.0))
            unlimited = np.where(c <= 0.0, np.inf, np.nan)
            with np.errstate(divide="ignore", invalid="ignore"):
                begin = np.where(square > 0.0, (b - root) / square, -unlimited)
                end = np.where(square > 0.0, (b + root) / square, unlimited)
            begin, end = np.maximum(begin, 0.0), np.minimum(end, 1.0)
            is_within = (b * b >= square * c) & (begin <= end)
            heights = starts[is_within, 1] + np.stack([begin, end])[:, is_within] * steps[is_within, 1] - center[1]
            climb[number] = np.abs(heights).max(initial=0.0)
    return climb


def _focal_length(camera: Camera) -> float:
    """Focal length in pixels of a perspective picture; ValueError for parallel rays."""
    if isinstance(camera.fov, CubeFace):
        return camera.width / 2.0
    if isinstance(camera.fov, Fov):
        return camera.width / (camera.fov.right - camera.fov.left)
    raise ValueError("camera: expected a perspective view or a cube face, got parallel rays, which belong to no eye")


def _forward(camera: Camera) -> NDArray[np.float64]:
    """Unit vector of the viewing axis."""
    if isinstance(camera.fov, CubeFace):
        axis, is_negative = divmod(camera.fov.face, 2)
        return np.asarray(np.eye(3)[axis] * (-1.0 if is_negative else 1.0))
    return -rotation(camera.orientation)[:, 2]


def error_in_pixels(error_px: float, camera: Camera) -> float:
    """Convert an error of impostors to pixels in the middle of a camera's picture."""
    return _focal_length(camera) * math.tan(math.radians(error_px / PIXELS_PER_DEGREE))


def predict_jump(step: ArrayLike, camera: Camera, distance: float) -> float:
    """Predict the jump f·|ΔO⊥|/ρ in pixels of a point straight ahead, ρ metres from the old centre.

    The map shows a far point P in the direction P − O. A step ΔO of the centre rotates it by |ΔO⊥|/ρ, where ΔO⊥ is the
    component perpendicular to the line of sight.
    """
    perpendicular = np.cross(np.asarray(step, np.float64), _forward(camera))
    return _focal_length(camera) * math.hypot(*perpendicular) / distance
