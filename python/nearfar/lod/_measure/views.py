"""Cameras around an object, and the part of a headset's picture that shows it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check
from nearfar._camera.camera import Camera, Fov
from nearfar.hmd._hmd import Hmd
from nearfar.lod._levels import Levels
from nearfar.lod._select.size import half_tangent, sphere_solid_angle

Directions = Literal["even", "published"]
"""Distributions of the views over directions; see `MeasureSettings`."""

Spacing = Literal["geometric", "published"]
"""Sequences of sizes; see `MeasureSettings`."""

AXES = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (1.0, 1.0, 0.0), (1.0, -1.0, 0.0))
"""Published axes about which objects turn, in the frame of a camera that looks along −z: horizontal, vertical and the
two diagonals between them. All are perpendicular to the line of sight, so that every turn shows another side."""

GOLDEN_ANGLE = math.pi * (3.0 - math.sqrt(5.0))
"""Angle between successive points of a Fibonacci sphere about its axis, radians."""

REFERENCE_WIDTH = 0.25
"""Width of the bounding sphere at σ₁/₁₆, as a share of the screen's: 1/16 of a square screen's area."""

LEAST_DIAMETER = 4.0
"""Diameter in pixels of the bounding sphere at the last geometric distance."""

FIRST_INTERVAL = 12
"""Every 12th turn is compared first, to predict scores and their standard errors. Multiples of 12 golden angles are not
close to whole circles, unlike multiples of a Fibonacci number of golden angles."""

MIN_SUBSET = 8
"""Least number of turns of a subset: the spread of fewer scores says too little."""

PADDING = 5
"""Padding in pixels around an object's box: SSIM windows of 11 pixels reach 5 pixels beyond their centre."""

Quaternion = tuple[float, float, float, float]


def turns(views: int, directions: Directions) -> tuple[list[Quaternion], NDArray[np.intp]]:
    """Distinct turns of the object as unit quaternions (x, y, z, w), and the index of each view's turn."""
    if directions == "published":
        return _published(views)
    return [_even(number, views) for number in range(views)], np.arange(views)


def nested_turns(count: int) -> list[NDArray[np.intp]]:
    """Indices of growing subsets of the turns, each from all sides and about twice as large as the one before.

    The first subset has every 12th turn, the next one also the turns midway between these, and so on; the last one has
    all.
    """
    bits = (FIRST_INTERVAL - 1).bit_length()
    offsets = [int(f"{number:0{bits}b}"[::-1], 2) for number in range(1 << bits)]
    offsets = [offset for offset in offsets if offset < FIRST_INTERVAL]
    ends = [*(1 << bit for bit in range(bits)), FIRST_INTERVAL]
    starts = [offsets[:end] for end in ends]
    subsets = [
        np.sort(np.concatenate([np.arange(offset, count, FIRST_INTERVAL) for offset in each])) for each in starts
    ]
    return [subset for subset in subsets[:-1] if len(subset) >= MIN_SUBSET] + subsets[-1:]


def _even(number: int, count: int) -> Quaternion:
    """Return the turn that shows the object from a point of a Fibonacci sphere about the line of sight.

    Point i of N is arccos(1 − (2i + 1)/N) away from +z, where the camera is, and i golden angles about it. The turn is
    the shortest one: its axis is perpendicular to the line of sight, like the published ones, and determines the roll.
    """
    fraction, angle = (number + 0.5) / count, number * GOLDEN_ANGLE
    # For cos θ = 1 − 2 fraction, sin(θ/2) = √fraction and cos(θ/2) = √(1 − fraction).
    sine = math.sqrt(fraction)
    return sine * math.sin(angle), -sine * math.cos(angle), 0.0, math.sqrt(1.0 - fraction)


def _published(views: int) -> tuple[list[Quaternion], NDArray[np.intp]]:
    """Turns about one axis of `AXES` after the other, in equal steps from 0.

    The turn by 0 is the same for all axes, so it is one picture. Half turns about all axes show the back, but with
    different roll, so they are four pictures. So 144 views are 141 pictures from 138 directions.
    """
    steps = views // len(AXES)
    distinct: list[Quaternion] = [(0.0, 0.0, 0.0, 1.0)]
    turn_of_view = []
    for axis in AXES:
        length = math.hypot(*axis)
        turn_of_view.append(0)
        for step in range(1, steps):
            half_angle = math.pi * step / steps
            x, y, z = (part / length * math.sin(half_angle) for part in axis)
            turn_of_view.append(len(distinct))
            distinct.append((x, y, z, math.cos(half_angle)))
    return distinct, np.array(turn_of_view)


@dataclass(frozen=True)
class Screen:
    """Screen for the pictures: an eye's view, symmetric about the axis, with square pixels."""

    tan_half_angle: float
    """Tangent of half the horizontal field of view, ω; the larger side of an asymmetric one."""
    pixel: float
    """Tangent spanned by a pixel at the axis."""
    size: tuple[int, int]
    """Width and height in pixels."""

    @classmethod
    def from_arguments(cls, hmd: Hmd | None, fov: Fov | None, size: tuple[int, int] | None) -> Screen:
        """Make the screen of a headset, or of a view and its pixels; ValueError for neither or both."""
        if hmd is not None:
            if fov is not None or size is not None:
                raise ValueError("hmd: expected None beside fov and size, got a headset")
            fov, size = check.instance("hmd", hmd, Hmd, "an Hmd such as nearfar.hmd.RIFT_S").left.fov, hmd.render_size
        elif fov is None or size is None:
            raise ValueError("hmd: expected a headset such as nearfar.hmd.RIFT_S, or else both fov and size")
        tangent = half_tangent(hmd or check.instance("fov", fov, Fov, "Fov"))
        width, height = check.size("size", size)
        window = 2 * PADDING + 1
        if min(width, height) < window:
            raise ValueError(f"size: expected at least {window} pixels, SSIM's window, got {width} × {height}")
        if not REFERENCE_WIDTH * tangent < 1.0:
            degrees = 2.0 * math.degrees(math.atan(1.0 / REFERENCE_WIDTH))
            raise ValueError(
                f"fov: expected less than {degrees:.4g} degrees across, so that an object can cover a sixteenth, "
                f"got {2.0 * math.degrees(math.atan(tangent)):.4g}"
            )
        return cls(tangent, (fov.right - fov.left) / width, (width, height))

    @property
    def reference_sine(self) -> float:
        """Sine of half the angle that a sphere of σ₁/₁₆ covers."""
        return REFERENCE_WIDTH * self.tan_half_angle

    def sines(self, spacing: Spacing, count: int) -> tuple[float, ...]:
        """Sines of half the angle that the bounding sphere covers at each distance, descending.

        "published": σ₁/₁₆, and the sphere's nearest point 2, 3, … times as far. "geometric": from twice the width of
        σ₁/₁₆, or half way to the whole sky, in equal factors down to `LEAST_DIAMETER`.
        """
        reference = self.reference_sine
        if spacing == "published":
            farther = (1.0 / (number * (1.0 / reference - 1.0) + 1.0) for number in range(2, count + 1))
            return reference, *farther
        greatest = min(2.0 * reference, 0.5 * (1.0 + reference))
        least = min(0.5 * LEAST_DIAMETER * self.pixel, 0.5 * reference)
        return tuple(np.geomspace(greatest, least, count).tolist())


@dataclass(frozen=True)
class Orbit:
    """Cameras around an object's bounding sphere; distances are numbered from 1."""

    screen: Screen
    center: tuple[float, float, float]
    radius: float
    reach: float
    """Distance from the centre to the farthest corner of any level, metres; coarse levels may exceed the sphere."""
    sines: tuple[float, ...]
    """Sine of half the angle that the sphere covers at each distance, descending."""

    @classmethod
    def of_levels(cls, levels: Levels, screen: Screen, sines: tuple[float, ...]) -> Orbit:
        """Make the cameras around the levels of an object."""
        reach = 0.0
        for level in levels:
            corners = level.scene.triangles().reshape(-1, 3) + (level.scene.origin - levels.center)
            reach = max(reach, math.sqrt(float(np.einsum("ij,ij->i", corners, corners).max())))
        return cls(screen, check.vector("center", levels.center), levels.radius, reach, sines)

    def distance(self, number: int) -> float:
        """Distance to the centre, metres."""
        return self.radius / self.sines[number - 1]

    def sigma(self, number: int) -> float:
        """Solid angle of the sphere in steradians."""
        return sphere_solid_angle(self.sines[number - 1])

    def box(self, number: int) -> tuple[int, int, int, int]:
        """First and end column, first and end row of the pixels that may show the object, padded for SSIM windows."""
        distance = self.distance(number)
        is_inside = self.reach >= distance
        radius = math.inf if is_inside else self.reach / math.sqrt(distance**2 - self.reach**2) / self.screen.pixel
        ends = []
        for length in self.screen.size:
            half_side = min(radius + PADDING, length)
            ends += [max(0, math.floor(length / 2 - half_side)), min(length, math.ceil(length / 2 + half_side))]
        return ends[0], ends[1], ends[2], ends[3]

    def pixel_count(self, number: int) -> int:
        """Number of pixels of the box."""
        first, end, top, bottom = self.box(number)
        return (end - first) * (bottom - top)

    def camera(self, number: int, turn: Quaternion) -> Camera:
        """Camera that sees the turned object: the camera turns inversely, so that the object stays fixed."""
        first, end, top, bottom = self.box(number)
        pixel, (width, height) = self.screen.pixel, self.screen.size
        x, y, z, w = -turn[0], -turn[1], -turn[2], turn[3]
        # The camera's z axis: (0, 0, 1) rotated by the quaternion.
        back = (2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y))
        distance = self.distance(number)
        eye = [middle + distance * part for middle, part in zip(self.center, back, strict=True)]
        fov = Fov(
            left=(first - width / 2) * pixel,
            right=(end - width / 2) * pixel,
            down=(height / 2 - bottom) * pixel,
            up=(height / 2 - top) * pixel,
        )
        return Camera((eye[0], eye[1], eye[2]), (x, y, z, w), fov=fov, size=(end - first, bottom - top))
