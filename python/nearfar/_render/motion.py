"""Motion of each pixel's surface in the picture since an earlier frame."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check
from nearfar._camera.camera import Camera
from nearfar._render.frame import Frame
from nearfar._render.renderable import Renderable


@dataclass(frozen=True)
class Viewpoint:
    """Camera, posed scene and user of a picture."""

    camera: Camera
    renderable: Renderable
    """Drawn scene in its pose."""
    user: tuple[float, float, float]
    """World position of the user, metres."""


_FAR_DISTANCE = 1e7
"""Distance in metres assumed without a known point; its motion differs from infinity's by less than 0.001 pixels."""
_ROWS = 64
"""Rows of pixels processed at once."""


def motion(
    frame: Frame, now: Viewpoint, before: Viewpoint, mask: NDArray[np.bool_] | None = None
) -> NDArray[np.float32]:
    """Compute the motion (H, W, 2) of a frame, which has positions, and object numbers if objects can move.

    Pixels without a known point count as infinitely far: they move only with the camera's rotation. NaN where a point
    was behind the earlier camera, for pixels without a point along parallel rays, and for pixels not in `mask`.
    """
    width, height = frame.camera.size
    starts, directions = frame.camera.rays()
    steps = _steps_since(now.renderable, before.renderable)
    motions = np.full((height, width, 2), np.nan, np.float32)
    for top in range(0, height, _ROWS):
        rows = slice(top, min(top + _ROWS, height))
        selected = np.ones((rows.stop - rows.start, width), np.bool_) if mask is None else mask[rows]
        start, direction = starts[rows][selected], directions[rows][selected]
        points = frame.require("position")[rows][selected].astype(np.float64) + np.array(frame.origin)
        is_known = np.isfinite(points).all(axis=1)
        points[is_known] = _move_to_rays(points[is_known], start[is_known], direction[is_known], now)
        for number, matrix in steps.items():
            is_of_object = frame.require("object_id")[rows][selected] == number
            points[is_of_object] = points[is_of_object] @ matrix[:3, :3].T + matrix[:3, 3]
        displayed = np.array(before.camera.position) + _FAR_DISTANCE * direction
        if frame.camera._core.is_parallel or before.camera._core.is_parallel:
            displayed[:] = np.nan
        displayed[is_known] = before.renderable.displayed(points[is_known], before.user)
        pixels = np.full((len(points), 2), np.nan)
        finite = np.isfinite(displayed).all(axis=1)
        pixels[finite] = before.camera.project(displayed[finite])[:, :2]
        y, x = np.nonzero(selected)
        motions[rows][selected] = np.stack([x, y + rows.start], axis=-1) + 0.5 - pixels
    return motions


def _move_to_rays(
    points: NDArray[np.float64], starts: NDArray[np.float64], directions: NDArray[np.float64], now: Viewpoint
) -> NDArray[np.float64]:
    """Move points (N, 3) back onto the rays of their pixels, which float32 rounding made them leave."""
    displayed = now.renderable.displayed(points, now.user)
    distances = ((displayed - starts) * directions).sum(axis=1, keepdims=True)
    return np.asarray(points + (starts + distances * directions - displayed))


def _steps_since(now: Renderable, earlier: Renderable) -> dict[int, NDArray[np.float64]]:
    """Return matrices (4, 4) from the present to the earlier pose of each object that moved, by number."""
    poses, earlier_poses = (check.mapping("poses", posed.poses, "matrices by name") for posed in (now, earlier))
    names = check.texts("object_names", now.object_names)
    return {
        names.index(name): earlier_poses[name] @ np.linalg.inv(pose)
        for name, pose in poses.items()
        if name in earlier_poses and not np.array_equal(pose, earlier_poses[name])
    }
