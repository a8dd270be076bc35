"""Splats by the definition: one after another, in float64 where the core uses float32.

A sample's right answer may depend on float32: whether the edge of an ellipse includes it, and which of two splats at
equal depth is nearer. So the oracle returns all answers that rounding allows: a sample is right if it shows one
of these, and most samples have only one.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from nearfar import _core
from nearfar._scene.srgb import to_linear
from nearfar.orthoview._codec import CONNECTION_LIMITS
from tests.support import orthoview_oracle
from tests.support.orthoview_oracle import Axes, Triple
from tests.support.render_oracle import CUBE_TABLE

Array = NDArray[np.float64]

NEIGHBOURS = [(0, 1), (1, 0), (1, 1), (1, -1)]
"""Row and column offsets to the pixels of a connection's bits."""

BORDER, MIN_COSINE, SQUARED_RADIUS = 1.27, 0.25, 0.5

OFF = 2e-4
"""Pixels by which float32 may misplace a splat in pictures of about 100 pixels: 100 × 2⁻²⁴ × some 30 roundings."""


@dataclass(frozen=True)
class Lens:
    """A camera as linear functions: pixels to the right and down (times the distance, for perspective) and distance."""

    eye: Array
    rows: Array
    shift: Array
    is_parallel: bool

    @classmethod
    def from_camera(cls, camera: nf.Camera) -> Lens:
        width, height = camera.size
        if isinstance(camera.fov, nf.CubeFace):
            right, down, forward = (sign * np.eye(3)[axis] for axis, sign in CUBE_TABLE[camera.fov.face])
            left, rightmost, bottom, top = -1.0, 1.0, -1.0, 1.0
        else:
            x, y, z, w = camera.orientation
            turn = np.array(
                [
                    [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                    [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                    [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
                ]
            )
            right, down, forward = turn[:, 0], -turn[:, 1], -turn[:, 2]
            fov = camera.fov
            left, rightmost, bottom, top = fov.left, fov.right, fov.down, fov.up
        across, along = width / (rightmost - left), height / (top - bottom)
        is_parallel = isinstance(camera.fov, nf.Orthographic)
        rows, shift = np.array([right * across, down * along, forward]), np.array([-left * across, top * along, 0.0])
        if not is_parallel:
            # A point at distance w is shown at (row · d + shift w) / w.
            rows, shift = rows + shift[:, None] * forward, np.zeros(3)
        return cls(np.array(camera.position), rows, shift, is_parallel)

    def project(self, point: Array) -> Array:
        """Position in the picture, and the distance along the axis."""
        x, y, w = self.rows @ (point - self.eye) + self.shift
        return np.array([x, y, w] if self.is_parallel else [x / w, y / w, w])

    def change(self, point: Array, vector: Array) -> Array:
        """The derivative of the position and of the nearness (1/w or −w) along a vector."""
        (x, y, w), (dx, dy, dw) = self.project(point), self.rows @ vector
        if self.is_parallel:
            return np.array([dx, dy, -dw])
        return np.array([(dx - x * dw) / w, (dy - y * dw) / w, -dw / w**2])

    def gradient(self, point: Array) -> Array:
        """Lengths of the gradients of both coordinates of the position."""
        lengths: Array = np.linalg.norm([self.change(point, axis)[:2] for axis in np.eye(3)], axis=0)
        return lengths

    def nearness(self, distance: Any) -> Any:
        return -distance if self.is_parallel else 1 / distance


@dataclass(frozen=True)
class Splat:
    """A pixel of a view."""

    point: Array
    normal: Array
    albedo: Array
    u: Array
    v: Array
    """Axes of a surfel's ellipse in space."""
    factor: float
    """Length of a surfel's axes; 0 for a ball."""
    ball: float
    """Radius of a ball, metres."""
    least: float
    """Least distance at which a perspective camera shows it."""


@dataclass(frozen=True)
class Seen:
    """A splat that a sample may show."""

    splat: Splat
    low: float
    high: float
    """Its nearness there."""
    is_sure: bool


def neighbours(bits: NDArray[np.uint8]) -> NDArray[np.int64]:
    """Number of pixels that are connected with each."""
    counts = np.zeros(bits.shape, np.int64)
    for bit, (rows, columns) in enumerate(NEIGHBOURS):
        for row, column in np.argwhere(bits >> bit & 1):
            counts[row, column] += 1
            counts[row + rows, column + columns] += 1
    return counts


def splats_of(
    views: _core.OrthoViews, number: int, direction: Triple, corner: Any, side: float, depth_bits: int
) -> list[Splat]:
    """The splats of one of a cell's views."""
    codes, axes = views.depths()[number, ..., 0], Axes.from_direction(direction)
    counts = neighbours(views.connected(CONNECTION_LIMITS)[number, ..., 0])
    albedo, normals = to_linear(views.colors()[number] / 255), views.vectors()[number].astype(np.float64)
    extents, size = axes.extents * side, len(codes)
    x, y = extents[:2] / size
    step = extents[2] / orthoview_oracle.steps_of(depth_bits)
    front = orthoview_oracle.pixel_points(corner, side, direction, size)
    splats = []
    for row, column in np.argwhere(codes):
        normal, count = normals[row, column], counts[row, column]
        facing = max(normal @ axes.toward, MIN_COSINE)
        splats.append(
            Splat(
                point=front[row, column] - (codes[row, column] - 0.5) * step * axes.toward,
                normal=normal,
                albedo=albedo[row, column],
                u=x * (axes.right - normal @ axes.right / facing * axes.toward),
                v=y * (-axes.up + normal @ axes.up / facing * axes.toward),
                factor=(1.0 if count == 8 else BORDER) if count > 4 else 0.0,
                ball=float(np.hypot(x, y)) / 2,
                least=max(x, y),
            )
        )
    return splats


def samples_of(splat: Splat, lens: Lens, size: tuple[int, int]) -> Iterator[tuple[tuple[int, int], list[Seen]]]:
    """Rows and columns of the samples that may show a splat, and how it may be seen there."""
    distance = lens.rows[2] @ (splat.point - lens.eye) + lens.shift[2]
    reach = np.sqrt(SQUARED_RADIUS) * splat.factor * np.hypot(lens.rows[2] @ splat.u, lens.rows[2] @ splat.v)
    if distance < 0 or (not lens.is_parallel and distance - reach < splat.least):
        return
    place, near = lens.project(splat.point)[:2], lens.nearness(distance)
    slopes = np.zeros(2)
    if splat.factor:
        changes = splat.factor * np.array([lens.change(splat.point, axis) for axis in (splat.u, splat.v)])
        ellipse, slopes = changes[:, :2].T, changes[:, 2]
    else:
        ellipse = np.diag(lens.gradient(splat.point) * splat.ball / np.sqrt(SQUARED_RADIUS))
    determinant = np.linalg.det(ellipse)
    # Seen edge-on it is a line; rounding decides which lines are empty.
    is_line = abs(determinant) < 1e-5 * np.abs(ellipse[0]).sum() * np.abs(ellipse[1]).sum()
    inverse = np.zeros((2, 2)) if is_line else np.linalg.inv(ellipse)
    half = np.sqrt(SQUARED_RADIUS * (ellipse**2).sum(axis=1)) + 1
    first = np.maximum(np.floor(place - half), 0).astype(int)
    last = np.minimum(np.ceil(place + half), np.array(size) - 1).astype(int)
    off = float(np.linalg.norm(inverse, 2)) * OFF + 1e-5
    # Plain numbers, because arrays of two take many times as long.
    (a, b), (c, d) = inverse.tolist()
    (middle_x, middle_y), (half_x, half_y), (slope_u, slope_v) = place.tolist(), half.tolist(), slopes.tolist()
    radius, change = math.sqrt(SQUARED_RADIUS), abs(slope_u) + abs(slope_v)
    for row, column in itertools.product(range(first[1], last[1] + 1), range(first[0], last[0] + 1)):
        x, y = column + 0.5 - middle_x, row + 0.5 - middle_y
        from_middle = max(abs(x), abs(y)) - 0.5
        seen = []
        if is_line:
            if abs(x) <= half_x - 1 + OFF and abs(y) <= half_y - 1 + OFF:
                seen.append((near, 0.71 * change, False))
            inside, outside = False, True
        else:
            u, v = a * x + b * y, c * x + d * y
            length = math.hypot(u, v)
            inside, outside = length + off < radius, length - off > radius
            if not outside:
                seen.append((near + slope_u * u + slope_v * v, change * off, inside))
        if not inside and from_middle <= OFF:
            seen.append((near, 0.0, outside and from_middle < -OFF and not is_line))
        # Then one of the two answers is certain, but not which.
        found = [
            Seen(splat, value - 3e-6 * abs(near) - spread, value + 3e-6 * abs(near) + spread, is_sure)
            for value, spread, is_sure in seen
        ]
        if found:
            yield (row, column), found


def possible(splats: Sequence[Splat], camera: nf.Camera) -> dict[tuple[int, int], list[Seen]]:
    """Splats that each sample may show, by row and column."""
    lens, at = Lens.from_camera(camera), dict[tuple[int, int], list[Seen]]()
    for splat in splats:
        for sample, found in samples_of(splat, lens, camera.size):
            at.setdefault(sample, []).extend(found)
    best = {sample: max((one.low for one in found if one.is_sure), default=-np.inf) for sample, found in at.items()}
    return {sample: [one for one in found if one.high >= best[sample]] for sample, found in at.items()}


def facing(normal: Array, ray: Array, found: Array) -> Array:
    """The normal on the viewer's side; up to rounding of grazing rays either side is accepted."""
    cosine = float(normal @ ray)
    if abs(cosine) < 1e-5:
        cosine = -float(normal @ found)
    return -normal if cosine > 0 else normal


def check(images: dict[str, Any], splats: Sequence[Splat], camera: nf.Camera, *, most_doubt: float = 0.06) -> float:
    """Compare range, albedo and normal at each sample; returns the share of samples that show a splat.

    `most_doubt` bounds the share of these for which rounding allows several answers.
    """
    lens, right, rays = Lens.from_camera(camera), possible(splats, camera), camera.rays()[1]
    width, height = camera.size
    lengths = np.ones((height, width))
    if not lens.is_parallel:
        # |d| for rays along which w grows by 1.
        lengths = 1 / (rays @ lens.rows[2])
    shown = doubtful = 0
    for row, column in itertools.product(range(height), range(width)):
        found, distance = right.get((row, column), []), float(images["range"][row, column]) / lengths[row, column]
        is_sure = any(one.is_sure for one in found)
        if not np.isfinite(distance):
            assert not is_sure, f"nothing at {row, column}"
            doubtful += bool(found)
            continue
        near = lens.nearness(distance)
        albedo, normal = images["albedo"][row, column], images["normal"][row, column]
        fitting = [
            one
            for one in found
            if one.low <= near <= one.high
            and np.abs(one.splat.albedo - albedo).max() < 1e-6
            and np.abs(facing(one.splat.normal, rays[row, column], normal) - normal).max() < 1e-6
        ]
        assert fitting, f"another splat at {row, column}: {near}, expected one of {found}"
        shown += 1
        doubtful += len({id(one.splat) for one in found}) > 1 or not is_sure
    assert doubtful <= most_doubt * max(shown, 1), (doubtful, shown)
    return shown / (width * height)
