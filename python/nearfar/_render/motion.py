"""Motion of each pixel's surface in the picture since another frame."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check
from nearfar._camera.camera import Camera
from nearfar._render.frame import Frame
from nearfar._render.renderable import Renderable


@dataclass(frozen=True)
class Sight:
    """Camera, posed source and user of a picture."""

    camera: Camera
    source: Renderable
    """The source in its pose."""
    user: tuple[float, float, float]
    """World position of the user, metres."""


_AWAY = 1e7
"""Distance for directions without a known point, metres: under a thousandth of a pixel from infinity."""
_ROWS = 64
"""Rows of pixels processed at once."""


def motion(frame: Frame, now: Sight, before: Sight, wanted: NDArray[np.bool_] | None = None) -> NDArray[np.float32]:
    """Compute the motion (H, W, 2) of a frame with positions, and with object numbers if objects can move.

    Pixels without a known point count as infinitely far: they move only with the camera's rotation. NaN where a point
    was behind the earlier camera, for pixels without a point along parallel rays, and for pixels not in `wanted`.
    """
    width, height = frame.camera.size
    starts, ways = frame.camera.rays()
    steps = _steps(now.source, before.source)
    moved = np.full((height, width, 2), np.nan, np.float32)
    for first in range(0, height, _ROWS):
        rows = slice(first, min(first + _ROWS, height))
        which = np.ones((rows.stop - rows.start, width), np.bool_) if wanted is None else wanted[rows]
        start, way = starts[rows][which], ways[rows][which]
        points = frame.require("position")[rows][which].astype(np.float64) + np.array(frame.origin)
        known = np.isfinite(points).all(axis=1)
        points[known] = _on_rays(points[known], start[known], way[known], now)
        for number, matrix in steps.items():
            mine = frame.require("object_id")[rows][which] == number
            points[mine] = points[mine] @ matrix[:3, :3].T + matrix[:3, 3]
        shown = np.array(before.camera.position) + _AWAY * way
        if frame.camera._core.is_parallel or before.camera._core.is_parallel:
            shown[:] = np.nan
        shown[known] = before.source.displayed(points[known], before.user)
        placed = np.full((len(points), 2), np.nan)
        finite = np.isfinite(shown).all(axis=1)
        placed[finite] = before.camera.project(shown[finite])[:, :2]
        y, x = np.nonzero(which)
        moved[rows][which] = np.stack([x, y + rows.start], axis=-1) + 0.5 - placed
    return moved


def _on_rays(
    points: NDArray[np.float64], starts: NDArray[np.float64], ways: NDArray[np.float64], now: Sight
) -> NDArray[np.float64]:
    """Move points (N, 3), which float32 has rounded, so that they are shown on their pixels' rays."""
    shown = now.source.displayed(points, now.user)
    along = ((shown - starts) * ways).sum(axis=1, keepdims=True)
    return np.asarray(points + (starts + along * ways - shown))


def _steps(source: Renderable, earlier: Renderable) -> dict[int, NDArray[np.float64]]:
    """Matrices (4, 4) from the present to the earlier place of objects that moved, by number."""
    now, then = (check.mapping("poses", one.poses, "matrices by name") for one in (source, earlier))
    names = check.texts("object_names", source.object_names)
    return {
        names.index(name): then[name] @ np.linalg.inv(pose)
        for name, pose in now.items()
        if name in then and not np.array_equal(pose, then[name])
    }
