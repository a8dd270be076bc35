"""Cameras: position, orientation, projection and image size."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._base.pickling import WithTwin
from nearfar._base.settings import set_fields

Quaternion = tuple[float, float, float, float]
"""A unit quaternion (x, y, z, w)."""


@dataclass(frozen=True)
class _Bounded:
    """A projection with four sides."""

    left: float
    right: float
    down: float
    up: float

    def __post_init__(self) -> None:
        sides = ("left", "right", "down", "up")
        set_fields(self, **{side: check.number(f"fov.{side}", getattr(self, side)) for side in sides})
        if self.left >= self.right:
            raise ValueError(f"fov: expected left < right, got {self.left} and {self.right}")
        if self.down >= self.up:
            raise ValueError(f"fov: expected down < up, got {self.down} and {self.up}")

    @property
    def _sides(self) -> tuple[float, float, float, float]:
        """Left, right, down and up, as kernels take them."""
        return self.left, self.right, self.down, self.up


@dataclass(frozen=True)
class Fov(_Bounded):
    """Field of view of a perspective camera: tangents of the angles to the four sides.

    Left and down are negative in a symmetric view. Asymmetric views, as headsets have them, are allowed.
    """

    @classmethod
    def symmetric(cls, horizontal_deg: float, aspect: float = 1.0) -> Fov:
        """Make a symmetric view from its horizontal angle in degrees, below 180; `aspect` is width over height."""
        angle, aspect = check.positive("horizontal_deg", horizontal_deg), check.positive("aspect", aspect)
        if angle >= 180.0:
            raise ValueError(f"horizontal_deg: expected less than 180 degrees, got {angle}")
        x = math.tan(math.radians(angle) / 2)
        if not 0.0 < x / aspect < math.inf:
            raise ValueError(f"aspect: expected a ratio for which the height is a finite number, got {aspect:g}")
        return cls(-x, x, -x / aspect, x / aspect)

    @classmethod
    def from_angles(cls, left: float, right: float, up: float, down: float) -> Fov:
        """Make a view from four signed angles in radians, in the order of OpenXR's XrFovf; left and down negative."""
        angles = {"left": left, "right": right, "up": up, "down": down}
        for name, angle in angles.items():
            if abs(check.number(name, angle)) >= math.pi / 2:
                raise ValueError(f"{name}: expected an angle between -pi/2 and pi/2 radians, got {angle}")
        return cls(math.tan(left), math.tan(right), math.tan(down), math.tan(up))


@dataclass(frozen=True)
class Orthographic(_Bounded):
    """Projection by parallel rays along the viewing direction; the image's bounds in metres about the position."""


@dataclass(frozen=True)
class CubeFace:
    """Face of a cube map, 0 to 5 for +x −x +y −y +z −z in world axes; the camera's orientation does not rotate it."""

    face: int

    def __post_init__(self) -> None:
        set_fields(self, face=check.integer("face", self.face, 0, 5))


Projection = Fov | Orthographic | CubeFace


@dataclass(frozen=True)
class Camera(WithTwin):
    """A view of a scene.

    ValueError and TypeError for values that are not finite, a quaternion that is not unit, and an empty image.

    Parameters
    ----------
    position
        World position in metres.
    orientation
        Unit quaternion (x, y, z, w) that turns camera axes into world axes; the camera looks along −z with y up.
    fov
        `Fov` (perspective), `Orthographic` or `CubeFace`.
    size
        Width and height of the image in pixels.
    """

    position: tuple[float, float, float]
    orientation: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 1.0)
    fov: Projection = field(kw_only=True)
    size: tuple[int, int] = field(kw_only=True)

    def __post_init__(self) -> None:
        position, orientation = check.vector("position", self.position), quaternion(self.orientation)
        set_fields(self, position=position, orientation=orientation, size=check.size("size", self.size))
        if not isinstance(self.fov, Projection):
            raise TypeError(f"fov: expected Fov, Orthographic or CubeFace, got {type(self.fov).__name__}")
        if isinstance(self.fov, CubeFace) and self.size[0] != self.size[1]:
            raise ValueError(f"size: expected a square image for a cube face, got {self.size}")

    @classmethod
    def look_at(
        cls,
        eye: ArrayLike,
        target: ArrayLike,
        *,
        fov: Projection,
        size: tuple[int, int],
        up: ArrayLike = (0.0, 1.0, 0.0),
    ) -> Camera:
        """Make a view from `eye` to `target` (world, metres) with `up` pointing up in the image.

        ValueError if eye and target coincide or the line between them is parallel to `up`.
        """
        start, end = np.array(check.vector("eye", eye)), np.array(check.vector("target", target))
        upward = np.array(check.vector("up", up))
        distance, height = np.linalg.norm(end - start), np.linalg.norm(upward)
        if distance == 0.0:
            raise ValueError(f"target: expected another point than eye, got {tuple(end.tolist())}")
        if height == 0.0:
            raise ValueError("up: expected a direction, got (0, 0, 0)")
        back = (start - end) / distance
        right = np.cross(upward / height, back)
        length = np.linalg.norm(right)
        # For shorter vectors the image's up direction would depend on the rounding of positions.
        if length < 1e-9:
            raise ValueError(f"up: expected a direction away from the line of sight, got {tuple(upward.tolist())}")
        right /= length
        axes = np.column_stack([right, np.cross(back, right), back])
        position = (float(start[0]), float(start[1]), float(start[2]))
        return cls(position, quaternion_from_axes(axes), fov=fov, size=size)

    @property
    def width(self) -> int:
        """Width of the image in pixels."""
        return self.size[0]

    @property
    def height(self) -> int:
        """Height of the image in pixels."""
        return self.size[1]

    def project(self, points: ArrayLike) -> NDArray[np.float64]:
        """Project world points (N, 3), metres, to image positions.

        Returns (N, 3) float64: x to the right and y down in pixels, where (0.5, 0.5) is the centre of the top left
        pixel, and the depth along the viewing axis in metres. Rows of points behind the camera are NaN; points outside
        the image have positions outside it.
        """
        return self._core.project(check.array("points", points, dtype=np.float64))

    def rays(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return the rays through all pixel centres: world origins in metres and unit directions, (H, W, 3) float64."""
        return self._core.rays()

    @cached_property
    def _core(self) -> _core.Camera:
        fov = self.fov
        if isinstance(fov, CubeFace):
            return _core.Camera(self.position, self.orientation, self.size, kind="cube", face=fov.face)
        kind = "perspective" if isinstance(fov, Fov) else "orthographic"
        return _core.Camera(self.position, self.orientation, self.size, kind=kind, bounds=fov._sides)


def quaternion(value: ArrayLike, argument: str = "orientation") -> Quaternion:
    components = check.array(argument, value, columns=None, dtype=np.float64, finite=True)
    if components.shape != (4,):
        raise ValueError(f"{argument}: expected a quaternion (x, y, z, w), got shape {components.shape}")
    x, y, z, w = (float(v) for v in components)
    length = math.sqrt(x * x + y * y + z * z + w * w)
    # The rounding of a quaternion to float32 stays below this tolerance.
    if abs(length - 1.0) > 1e-6:
        raise ValueError(f"{argument}: expected a unit quaternion (x, y, z, w), got length {length:g}")
    return x, y, z, w


def quaternion_from_axes(axes: NDArray[np.float64]) -> Quaternion:
    """Convert a rotation matrix to a unit quaternion through its largest component (Shepperd, 1978)."""
    trace = float(np.trace(axes))
    squares = np.array([*(1.0 + 2.0 * np.diag(axes) - trace), 1.0 + trace])
    largest = int(np.argmax(squares))
    if largest == 3:
        q = [axes[2, 1] - axes[1, 2], axes[0, 2] - axes[2, 0], axes[1, 0] - axes[0, 1], squares[3]]
    else:
        i, j, k = largest, (largest + 1) % 3, (largest + 2) % 3
        q = [0.0, 0.0, 0.0, axes[k, j] - axes[j, k]]
        q[i], q[j], q[k] = squares[i], axes[j, i] + axes[i, j], axes[k, i] + axes[i, k]
    unit = np.array(q) / np.linalg.norm(q)
    return float(unit[0]), float(unit[1]), float(unit[2]), float(unit[3])


def orientation_of(yaw: float, pitch: float) -> Quaternion:
    """Return the orientation that turns −z by a yaw, positive to the left, and a pitch, positive up, in radians."""
    sy, cy = math.sin(yaw / 2), math.cos(yaw / 2)
    sp, cp = math.sin(pitch / 2), math.cos(pitch / 2)
    return cy * sp, sy * cp, -sy * sp, cy * cp


def viewing_direction(orientation: Quaternion) -> tuple[float, float, float]:
    """Return the direction to which an orientation turns −z."""
    x, y, z, w = orientation
    return -2.0 * (x * z + w * y), 2.0 * (w * x - y * z), 2.0 * (x * x + y * y) - 1.0
