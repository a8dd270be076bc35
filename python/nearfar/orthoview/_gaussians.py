"""Converts pixels of views to Gaussians for splat viewers.

A surfel's pixel spans u and v on its tangent plane (docs/orthoview_view.md). The Gaussian of the covariance
σ² (u uᵀ + v vᵀ), σ in pixels, has the same main axes as the ellipse that `tree.render` draws; it is thin along the
normal.
"""

from __future__ import annotations

from dataclasses import dataclass, fields, replace

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._scene.srgb import to_linear

Floats = NDArray[np.float32]

SIGMA = 0.6
"""Standard deviation of a surfel in pixels of its view (docs/orthoview_export.md). With smaller values the background
shows through between pixels; greater values blur edges."""

NORMAL_FACTOR = 0.1
"""Standard deviation along a surfel's normal, as a fraction of the smaller standard deviation in its plane."""

MIN_COSINE = 0.25
"""Least cosine between a surfel's normal and the direction of its view, as in `tree.render`."""

SUN = (0.526_315_8, 0.789_473_7, 0.315_789_5)
"""Unit vector towards the sun, as in all pictures."""

_SUN_COLOR = np.array([0.60, 0.56, 0.50], np.float32)
_SKY = np.array([-0.206_284_3, 0.928_279_1, 0.309_426_4], np.float32)
_SKY_COLORS = np.array([[0.130, 0.135, 0.150], [0.380, 0.420, 0.480]], np.float32)
_LINEAR = to_linear(np.arange(256) / 255.0).astype(np.float32)


@dataclass(frozen=True, eq=False)
class Gaussians:
    """Gaussians in one frame, all with opacity 1."""

    middle: Floats
    """Centres (N, 3), metres from the frame's origin."""
    rotation: Floats
    """Unit quaternions (N, 4), x, y, z, w; w is the greatest component. The columns of their rotation matrices are the
    main axes, the third one the normal."""
    scale: Floats
    """Standard deviations along the axes (N, 3), metres."""
    color: NDArray[np.uint8]
    """sRGB (N, 3)."""

    def __len__(self) -> int:
        return len(self.middle)

    def box(self) -> NDArray[np.float64]:
        """Bounding box (2, 3) of the 3σ ellipsoids, metres."""
        axes = matrices(self.rotation) * self.scale[:, None, :]
        reach = 3.0 * np.sqrt(np.einsum("nij,nij->ni", axes, axes))
        low, high = (self.middle - reach).min(axis=0), (self.middle + reach).max(axis=0)
        return np.array([low, high], np.float64)

    def translate(self, shift: NDArray[np.float64]) -> Gaussians:
        """Return the Gaussians translated by a vector (3,), metres."""
        return replace(self, middle=(self.middle + shift).astype(np.float32))


NO_GAUSSIANS = Gaussians(
    np.zeros((0, 3), np.float32), np.zeros((0, 4), np.float32), np.zeros((0, 3), np.float32), np.zeros((0, 3), np.uint8)
)


def concatenate(parts: list[Gaussians]) -> Gaussians:
    """Concatenate Gaussians of one frame."""
    return Gaussians(*(np.concatenate([getattr(part, field.name) for part in parts]) for field in fields(Gaussians)))


@dataclass(frozen=True, eq=False)
class Surfaces:
    """Pixels of a view that show something, in pixel order."""

    middle: Floats
    """Centres (N, 3), metres from the cell's centre."""
    normal: Floats
    """Unit normals (N, 3) towards the viewer."""
    color: NDArray[np.uint8]
    """Albedo, sRGB (N, 3)."""
    is_surfel: NDArray[np.bool_]
    """Whether each pixel is a surfel (N,); the others are balls."""

    def select(self, mask: NDArray[np.bool_]) -> Surfaces:
        return Surfaces(self.middle[mask], self.normal[mask], self.color[mask], self.is_surfel[mask])


def gaussians_of(
    surfaces: Surfaces, axes: Floats, pitch: tuple[float, float], sun: tuple[float, float, float] | None
) -> Gaussians:
    """Convert the pixels of a view to Gaussians.

    The rows of `axes` (3, 3) point to the right, up and towards the viewer. `pitch` is the width and height of a pixel,
    metres; `sun` a unit vector towards the sun, None for unshaded colours.
    """
    right, up, toward = axes
    facing = np.maximum(surfaces.normal @ toward, np.float32(MIN_COSINE))
    u = np.float32(pitch[0]) * (right - ((surfaces.normal @ right) / facing)[:, None] * toward)
    v = np.float32(pitch[1]) * (up - ((surfaces.normal @ up) / facing)[:, None] * toward)
    # Rotating the pixel's axes until their images u and v are perpendicular gives the main axes of u uᵀ + v vᵀ.
    uu, vv, uv = (np.einsum("ni,ni->n", a, b) for a, b in ((u, u), (v, v), (u, v)))
    angle = 0.5 * np.arctan2(2.0 * uv, uu - vv)
    cosine, sine = np.cos(angle)[:, None], np.sin(angle)[:, None]
    first, second = cosine * u + sine * v, cosine * v - sine * u
    lengths = np.stack([np.linalg.norm(first, axis=1), np.linalg.norm(second, axis=1)], axis=1)
    first, second = first / lengths[:, :1], second / lengths[:, 1:]
    main_axes = np.stack([first, second, np.cross(first, second)], axis=2)
    deviations = np.float32(SIGMA) * lengths
    scale = np.concatenate([deviations, NORMAL_FACTOR * deviations.min(axis=1, keepdims=True)], axis=1)

    is_ball = ~surfaces.is_surfel
    main_axes[is_ball] = np.eye(3, dtype=np.float32)
    # A ball's disc encloses the pixel, whose corners lie on the ellipse of a surfel with the radius √½ in pixels.
    scale[is_ball] = SIGMA * np.hypot(*pitch) / np.sqrt(2.0)
    rotation, order = _quaternions(main_axes)
    scale = np.take_along_axis(scale, order, axis=1).astype(np.float32)
    return Gaussians(surfaces.middle, rotation, scale, shade(surfaces.color, surfaces.normal, sun))


def shade(color: NDArray[np.uint8], normal: Floats, sun: tuple[float, float, float] | None) -> NDArray[np.uint8]:
    """Shade albedo (N, 3) by the light of all pictures with the sun in a given direction; sRGB in and out."""
    if sun is None:
        return color
    linear = (_LINEAR[color] * irradiance(normal, sun)).astype(np.float32)
    return _core.encode_srgb(linear.ravel()).reshape(linear.shape)


def irradiance(normal: Floats, sun: tuple[float, float, float]) -> Floats:
    """Linear RGB (N, 3) that white surfaces reflect in the light of all pictures with the sun in a given direction."""
    sky = (0.5 + 0.5 * (normal @ _SKY))[:, None]
    sunlight = _SUN_COLOR * np.maximum(normal @ np.array(sun, np.float32), 0.0)[:, None]
    return np.asarray(_SKY_COLORS[0] + (_SKY_COLORS[1] - _SKY_COLORS[0]) * sky + sunlight)


def _quaternions(matrix: Floats) -> tuple[Floats, NDArray[np.int64]]:
    """Convert rotation matrices (N, 3, 3), whose columns are axes, to quaternions (N, 4) and the axes' order (N, 3).

    The signs of axes do not matter, and the first two may be swapped. Of the rotations that give the same Gaussian, the
    one with the greatest w is chosen: formats that derive w from x, y and z are most accurate then.
    """
    swapped = np.stack([matrix[:, :, 1], -matrix[:, :, 0], matrix[:, :, 2]], axis=2)
    quaternions = np.stack([_quaternion_with_greatest_w(matrix), _quaternion_with_greatest_w(swapped)])
    is_swap_better = quaternions[1, :, 3] > quaternions[0, :, 3]
    order = np.where(is_swap_better[:, None], np.array([1, 0, 2]), np.array([0, 1, 2]))
    return np.where(is_swap_better[:, None], quaternions[1], quaternions[0]), order


def _quaternion_with_greatest_w(matrix: Floats) -> Floats:
    """Return each matrix's quaternion, after the half turn about one of its axes, or none, that makes w greatest."""
    x, y, z = (matrix[:, axis, axis] for axis in range(3))
    # 4 w², 4 x², 4 y², 4 z². Half turns about the axes permute w, x, y and z up to their signs.
    squares = np.stack([1 + x + y + z, 1 + x - y - z, 1 - x + y - z, 1 - x - y + z], axis=1)
    axis_code = squares.argmax(axis=1)
    # A half turn about axis k negates the two other columns.
    signs = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], np.float32)[axis_code]
    rotated = matrix * signs[:, None, :]
    w = 0.5 * np.sqrt(np.maximum(squares.max(axis=1), 1.0))
    factor = 0.25 / w
    return np.stack(
        [
            (rotated[:, 2, 1] - rotated[:, 1, 2]) * factor,
            (rotated[:, 0, 2] - rotated[:, 2, 0]) * factor,
            (rotated[:, 1, 0] - rotated[:, 0, 1]) * factor,
            w,
        ],
        axis=1,
    ).astype(np.float32)


def matrices(rotation: Floats) -> Floats:
    """Rotation matrices (N, 3, 3) of unit quaternions (N, 4)."""
    x, y, z, w = rotation.T
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.stack([np.stack(row, axis=1) for row in rows], axis=1).astype(np.float32)
