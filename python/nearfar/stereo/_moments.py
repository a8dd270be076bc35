"""Moments of a rig (head pose and posed source), and motion of the shared picture's pixels for an eye."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar._camera.camera import Camera, Fov, quaternion
from nearfar._camera.rotation import rotation
from nearfar._render.renderable import Renderable
from nearfar._render.renderer import posed_at
from nearfar.stereo._geometry import RigGeometry


@dataclass(frozen=True)
class Moment:
    """Pose of the head, and the source in its pose."""

    position: tuple[float, float, float]
    """World position of the head, metres."""
    orientation: tuple[float, float, float, float]
    """Unit quaternion (x, y, z, w) from head axes to world axes."""
    source: Renderable
    """The source in its pose."""

    def head(self, rig: RigGeometry) -> tuple[float, float, float]:
        """World position of the middle between a rig's eyes, metres."""
        x, y, z = np.array(self.position) + rotation(self.orientation) @ np.array(rig._core.middle)
        return float(x), float(y), float(z)


def moment_before(source: Renderable, before: object, at: Mapping[str, ArrayLike] | None) -> Moment | None:
    """Convert the arguments `before` and `before_at` of a rendering function; None without `before`."""
    if before is None:
        if at is not None:
            raise ValueError("before_at: expected None without the pose `before`")
        return None
    if not isinstance(before, (tuple, list)) or len(before) != 2:
        raise TypeError(f"before: expected a pair (position, orientation), got {check.type_and_value(before)}")
    position, orientation = check.vector("before", before[0]), quaternion(before[1], "before")
    return Moment(position, orientation, source if at is None else posed_at(source, at, "before_at"))


def shift_pixels(camera: Camera, jitter: tuple[float, float]) -> Camera:
    """Shift a camera's pixels to the right and down by a fraction of a pixel."""
    fov, (width, height) = camera.fov, camera.size
    assert isinstance(fov, Fov)
    if jitter == (0.0, 0.0):
        return camera
    x, y = jitter[0] * (fov.right - fov.left) / width, jitter[1] * (fov.up - fov.down) / height
    return replace(camera, fov=Fov(fov.left + x, fov.right + x, fov.down - y, fov.up - y))


def map_motion(homography: Any, mask: NDArray[np.bool_], motions: NDArray[np.float32]) -> NDArray[np.float32]:
    """Map motions (N, 2) of the shared picture's pixels to an eye's picture, at its pixels in a mask (H, W).

    The homography depends on the rig only, so it is the same for both moments. To first order this is Eq. 9 of Fink et
    al.
    """
    to_eye = np.array(homography)
    rows, columns = np.nonzero(mask)
    pixels = np.stack([columns + 0.5, rows + 0.5], axis=-1)
    previous = _map_points(np.linalg.inv(to_eye), pixels) - motions
    return np.asarray(pixels - _map_points(to_eye, previous), np.float32)


def _map_points(matrix: NDArray[np.float64], points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Map places (N, 2) by a homography."""
    mapped = np.column_stack([points, np.ones(len(points))]) @ matrix.T
    return np.asarray(mapped[:, :2] / mapped[:, 2:])
