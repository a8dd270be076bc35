"""Geometry of a hybrid rig: two eyes, the mono plane, the camera behind the eyes, and the error of its pictures."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check, memory
from nearfar._base.pickling import WithTwin
from nearfar._base.settings import set_fields
from nearfar._camera.camera import Camera, Fov, quaternion
from nearfar._camera.clip import Clip
from nearfar._camera.rotation import rotation
from nearfar.hmd._eye import Eye
from nearfar.hmd._hmd import EYES, Hmd
from nearfar.stereo._kink import kink_angles
from nearfar.stereo._layer import QuadLayer
from nearfar.stereo._settings import check_depths
from nearfar.stereo._view_vectors import view_vectors

AXES = ("horizontal", "vertical", "both")
"""Names of the components of an error."""
UNITS = ("pixels", "arcmin")
"""Names of the units of an error field."""


@dataclass(frozen=True, kw_only=True)
class RigGeometry(WithTwin):
    """Positions of a rig's cameras, the mapping between their pictures, and their errors."""

    left: Eye
    right: Eye
    mono_plane: float | tuple[float, float]
    size: tuple[int, int]
    hmd: Hmd | None = None

    def __post_init__(self) -> None:
        for side in EYES:
            check.instance(side, getattr(self, side), Eye, "Eye")
        set_fields(self, mono_plane=_plane(self.mono_plane), size=check.size("size", self.size))
        if self.hmd is not None:
            check.instance("hmd", self.hmd, Hmd, "an Hmd")
        # The core checks the other values.
        _ = self._core

    def with_plane(self, mono_plane: float | tuple[float, float]) -> Self:
        """Return the same eyes with another mono plane or zone, metres."""
        return replace(self, mono_plane=mono_plane)

    @property
    def planes(self) -> tuple[float, float]:
        """Distances m₁ and m₂ of the zone in metres; equal for a single plane.

        The pictures meet on the plane m with 1/m = (1/m₁ + 1/m₂)/2.
        """
        plane = self.mono_plane
        return plane if isinstance(plane, tuple) else (plane, plane)

    @property
    def has_zone(self) -> bool:
        """Whether rays bend in a zone between two planes, instead of at a single plane."""
        return self.planes[1] > self.planes[0]

    @property
    def ipd(self) -> float:
        """Distance between the eyes, metres."""
        return math.dist(self.left.position, self.right.position)

    @property
    def center_offset(self) -> float:
        """Distance s in metres of the third camera behind the middle between the eyes."""
        return self._core.setback

    @property
    def center_fov(self) -> Fov:
        """Field of view of the third camera, tangents: the hull of both eyes' views on the plane m."""
        return Fov(*self._core.center_fov)

    @property
    def center_size(self) -> tuple[int, int]:
        """Width and height in pixels of the third camera's picture, whose pixels are as fine as the eyes' (Eq. 8)."""
        return self._core.center_size

    @property
    def overlap(self) -> float:
        """Distance ε in metres before the plane m₂ from which the third camera draws.

        2 s m₂ as published. If pixels are coarse or the plane is far away, it is 1.5 pixels of depth, at most m₂/2, so
        that floors and walls a metre or more beside the line of sight have no gap.
        """
        return self._core.overlap

    def cameras(
        self, position: ArrayLike, orientation: ArrayLike = (0.0, 0.0, 0.0, 1.0)
    ) -> tuple[Camera, Camera, Camera]:
        """Return the cameras of the left eye, the right eye and the third one.

        The pose of the head is a world position in metres and a unit quaternion (x, y, z, w) that rotates head axes to
        world axes, as for `Hmd.camera`.
        """
        left, right = (eye._camera(position, orientation, self.size) for eye in (self.left, self.right))
        head, behind = quaternion(orientation), np.add(self._core.middle, (0.0, 0.0, self.center_offset))
        center = np.array(check.vector("position", position)) + rotation(head) @ behind
        return left, right, Camera(check.vector("position", center), head, fov=self.center_fov, size=self.center_size)

    def clip(
        self,
        position: ArrayLike,
        orientation: ArrayLike = (0.0, 0.0, 0.0, 1.0),
        *,
        near: float = 0.0,
        far: float = math.inf,
    ) -> Clip:
        """Return the space between two depths in front of the plane of the eyes, for `nearfar.render` and others.

        The pose is that of the head, as for `cameras`; depths are in metres, and `far` may be infinite. ValueError and
        TypeError for depths below 0 or out of order, and invalid poses.
        """
        begin, end = check_depths(near, far)
        turn = rotation(quaternion(orientation))
        forward = turn @ np.array((0.0, 0.0, -1.0))
        middle = np.array(check.vector("position", position)) + turn @ np.array(self._core.middle)
        offset = float(forward @ middle)
        planes = [(*forward.tolist(), -offset - begin)]
        if math.isfinite(end):
            planes.append((*(-forward).tolist(), offset + end))
        return Clip(planes=planes)

    @property
    def quad_layer(self) -> QuadLayer:
        """The rectangle on the plane m that the third camera sees, for compositors (OpenXR, WebXR)."""
        fov, m = self.center_fov, self._core.mono
        distance = m + self.center_offset
        x, y, z = self._core.middle
        middle = (x + 0.5 * distance * (fov.left + fov.right), y + 0.5 * distance * (fov.down + fov.up), z - m)
        return QuadLayer(middle, (distance * (fov.right - fov.left), distance * (fov.up - fov.down)))

    def view_vectors(
        self,
        eye: str,
        points: ArrayLike,
        position: ArrayLike,
        orientation: ArrayLike = (0.0, 0.0, 0.0, 1.0),
        *,
        blend: float = 0.3,
    ) -> NDArray[np.float64]:
        """Return unit vectors (N, 3) from surface points (N, 3) to the viewer, for view-dependent shading.

        The viewer is the third camera beyond the plane, and the eye, "left" or "right", before it. Over the last
        `blend` metres before the plane, m₂ for a zone, both vectors are interpolated linearly, so that highlights do
        not jump there. Points are world positions in metres, and the pose is that of the head, as for `cameras`. NaN
        for a point at the viewer. ValueError and TypeError for arguments out of range. Source: Fink et al. (2019).
        """
        positions = check.array("points", points, columns=3, dtype=np.float64, finite=True)
        length = check.positive("blend", blend)
        side = EYES.index(check.choice("eye", eye, EYES))
        cameras = self.cameras(position, orientation)
        forward = rotation(quaternion(orientation)) @ np.array((0.0, 0.0, -1.0))
        return view_vectors(
            positions,
            np.array(cameras[side].position),
            np.array(cameras[2].position),
            forward,
            plane=self.planes[1],
            setback=self.center_offset,
            blend=length,
        )

    def homography(self, eye: str) -> NDArray[np.float64]:
        """Return the matrix (3, 3) that maps pixels of the third camera to pixels of an eye, "left" or "right" (Eq. 5).

        It maps (x, y, 1) to (x w, y w, w), where w is the distance in metres of the plane's point along the eye's axis.
        Pixel centres are at +0.5.
        """
        return np.array(self._core.homography(check.choice("eye", eye, EYES)))

    def shown(self, eye: str, at: ArrayLike, *, depth: float = math.inf) -> tuple[float, float]:
        """Return the tangents at which an eye's picture shows a point; its true tangents are `at` (2,).

        `depth` is the point's distance in metres ahead of the plane of the eyes.
        """
        tangents = check.array("at", at, columns=None, dtype=np.float64, finite=True)
        if tangents.shape != (2,):
            raise ValueError(f"at: expected two tangents, got {check.value_or_type(at)}")
        side, (x, y) = check.choice("eye", eye, EYES), tangents.tolist()
        x, y = self._core.displayed_tangents(side, (x, y), _depth(depth))
        return x, y

    def max_error(self, depth: float = math.inf, axis: str = "horizontal") -> float:
        """Return the maximum error over both eyes in pixels: a component, or the length of the error for "both".

        `depth` is that of the points in metres ahead of the plane of the eyes; by default infinite, the depth with the
        greatest error. ValueError and TypeError for depths that are not above 0, and unknown axes.
        """
        return self._core.max_error(_depth(depth), check.choice("axis", axis, AXES))

    def error_field(self, eye: str, depth: float = math.inf, *, unit: str = "pixels") -> NDArray[np.float64]:
        """Return the error of each pixel of an eye, "left" or "right", (H, W, 2) float64: to the right and upwards.

        `depth` is that of the points in metres ahead of the plane of the eyes; `unit` is "pixels", or "arcmin": minutes
        of arc for the eye at that pixel. ValueError and TypeError for depths that are not above 0, and unknown eyes or
        units.
        """
        side = check.choice("eye", eye, EYES)
        check.choice("unit", unit, UNITS)
        width, height = self.size
        memory.check_room("size", f"errors of {width} × {height} pixels", 16 * width * height)
        field = self._core.error_field(side, _depth(depth))
        return field if unit == "pixels" else self._in_arc_minutes(side, field)

    def kink_angle(self, eye: str, at: ArrayLike, direction: ArrayLike) -> NDArray[np.float64]:
        """Return the angles (N,) in degrees, 0 to 180, by which straight lines appear bent at the plane.

        `at` has the tangents (N, 2) at which the eye, "left" or "right", sees the intersections of the lines with the
        plane m₁; `direction` (N, 2) the lines' metres to the right and upwards per metre ahead, in head axes. NaN for
        lines through the eye, which it sees as points. ValueError and TypeError for arrays of other shapes, and rigs
        with a zone, which have no kink.
        """
        m, end = self.planes
        if end > m:
            raise ValueError(f"mono_plane: expected one plane for a kink, got the zone from {m:g} to {end:g} m")
        eye_on_head: Eye = getattr(self, check.choice("eye", eye, EYES))
        relative = replace(eye_on_head, position=tuple(np.subtract(eye_on_head.position, self._core.middle).tolist()))
        tangents = check.array("at", at, columns=2, dtype=np.float64, finite=True)
        directions = check.array("direction", direction, columns=2, dtype=np.float64, finite=True)
        if len(tangents) != len(directions):
            raise ValueError(f"direction: expected one for each of {len(tangents)} places, got {len(directions)}")
        return kink_angles(relative, m, self.center_offset, tangents, directions)

    def _in_arc_minutes(self, eye: str, field: NDArray[np.float64]) -> NDArray[np.float64]:
        """Convert errors in pixels to angles: pixels far from the eye's axis subtend smaller angles."""
        fov, (width, height) = getattr(self, eye).fov, self.size
        pitch = np.array([(fov.right - fov.left) / width, (fov.up - fov.down) / height])
        x = fov.left + pitch[0] * (np.arange(width) + 0.5)
        y = fov.up - pitch[1] * (np.arange(height) + 0.5)
        errors = field * pitch
        # atan changes by 1/(1 + x²) per unit of tangent; the exact value is the difference of two angles.
        horizontal = np.arctan2(errors[..., 0], 1.0 + x * (x + errors[..., 0]))
        vertical = np.arctan2(errors[..., 1], 1.0 + y[:, None] * (y[:, None] + errors[..., 1]))
        return np.asarray(np.degrees(np.stack([horizontal, vertical], axis=-1)) * 60.0)

    @cached_property
    def _core(self) -> _core.HybridRig:
        left, right = ((eye.fov._sides, eye.position, eye.orientation) for eye in (self.left, self.right))
        return _core.HybridRig(left, right, self.planes, self.size)


def _plane(value: float | tuple[float, float]) -> float | tuple[float, float]:
    if isinstance(value, (tuple, list)):
        if len(value) != 2:
            raise ValueError(f"mono_plane: expected a distance or a pair of distances, got {len(value)} numbers")
        return check.number("mono_plane", value[0]), check.number("mono_plane", value[1])
    return check.number("mono_plane", value)


def _depth(value: float) -> float:
    return check.number("depth", value, finite=False)
