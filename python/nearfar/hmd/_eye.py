"""Eyes of headsets: field of view and pose on the head, and the total field of view of two eyes."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar._base.settings import set_fields
from nearfar._camera.camera import Camera, Fov, quaternion, quaternion_from_axes
from nearfar._camera.rotation import compose_rotations, rotation

ROTATION_TOLERANCE = 1e-4
"""Greatest difference between the entries of a matrix and of the nearest rotation; runtimes print six digits."""


@dataclass(frozen=True)
class Eye:
    """One eye of a headset.

    Parameters
    ----------
    fov
        Field of view in the eye's axes, tangents.
    position
        Metres in head axes: x to the right, y up, looking along −z.
    orientation
        Unit quaternion (x, y, z, w) that turns the eye's axes into the head's; canted views are turned outwards.
    """

    fov: Fov
    position: tuple[float, float, float]
    orientation: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 1.0)

    def __post_init__(self) -> None:
        check.instance("fov", self.fov, Fov, "Fov")
        set_fields(self, position=check.vector("position", self.position), orientation=quaternion(self.orientation))

    @classmethod
    def from_matrix(cls, fov: Fov, eye_to_head: ArrayLike) -> Eye:
        """Make an eye from OpenVR's eye-to-head matrix (3, 4), metres; rounded entries become the nearest rotation.

        ValueError if the first three columns are not a rotation.
        """
        rows = check.array("eye_to_head", eye_to_head, columns=4, dtype=np.float64, finite=True)
        if len(rows) != 3:
            raise ValueError(f"eye_to_head: expected shape (3, 4), got {rows.shape}")
        axes = rows[:, :3]
        orientation = (0.0, 0.0, 0.0, 1.0)
        if not np.array_equal(axes, np.eye(3)):
            # The rotation of the polar decomposition is the nearest by least squares (Higham, 1986).
            left, _, right = np.linalg.svd(axes)
            nearest = left @ right
            if np.linalg.det(nearest) < 0.0 or np.abs(nearest - axes).max() > ROTATION_TOLERANCE:
                raise ValueError(f"eye_to_head: expected a rotation in the first three columns, got {axes.tolist()}")
            orientation = quaternion_from_axes(nearest)
        return cls(fov, (float(rows[0, 3]), float(rows[1, 3]), float(rows[2, 3])), orientation)

    def _camera(self, position: ArrayLike, orientation: ArrayLike, size: tuple[int, int]) -> Camera:
        """Make the camera of the eye from the pose of the head; see `Hmd.camera`."""
        head = quaternion(orientation)
        x, y, z = np.array(check.vector("position", position)) + rotation(head) @ np.array(self.position)
        turned = compose_rotations(self.orientation, head)
        return Camera((float(x), float(y), float(z)), turned, fov=self.fov, size=size)

    @property
    def matrix(self) -> NDArray[np.float64]:
        """Eye-to-head matrix (3, 4): a rotation, and the position in metres."""
        return np.column_stack([rotation(self.orientation), self.position])

    @property
    def corners(self) -> NDArray[np.float64]:
        """Directions of the view's corners in head axes, (4, 3): left bottom, right bottom, right top, left top."""
        f = self.fov
        directions = [(f.left, f.down, -1), (f.right, f.down, -1), (f.right, f.up, -1), (f.left, f.up, -1)]
        return np.asarray(np.array(directions, np.float64) @ rotation(self.orientation).T)

    @property
    def angles_deg(self) -> tuple[float, float, float, float]:
        """Angles in degrees to the left, right, lower and upper edge of the view; left and down negative.

        They are measured from straight ahead in the planes of the head's axes, so they differ between the sides of a
        canted eye.
        """
        left, right = self._plane_angles("horizontal", 0, 1)
        down, up = self._plane_angles("vertical", 1, 0)
        return left, right, down, up

    @property
    def rotation_deg(self) -> float:
        """Angle in degrees between the eye's and the head's viewing axis, positive for a turn to the right."""
        axis = rotation(self.orientation)[:, 2]
        # atan2 is accurate for small angles, for which acos is not.
        angle = math.degrees(math.atan2(math.hypot(axis[0], axis[1]), axis[2]))
        return -angle if axis[0] > 0.0 else angle

    def _plane_angles(self, plane: str, axis: int, normal_axis: int) -> tuple[float, float]:
        """Least and greatest angle, degrees, at which the view's edge crosses a plane through the head's viewing axis.

        Angles are measured from the viewing axis towards `axis`; the plane is perpendicular to `normal_axis`.
        """
        corners = self.corners
        angles = []
        for start, end in zip(corners, np.roll(corners, -1, axis=0), strict=True):
            if (start[normal_axis] < 0.0) != (end[normal_axis] < 0.0):
                fraction = start[normal_axis] / (start[normal_axis] - end[normal_axis])
                point = start + fraction * (end - start)
                angles.append(math.degrees(math.atan2(point[axis], -point[2])))
        if not angles:
            raise ValueError(f"fov: expected a view that crosses the head's {plane} plane, got {self}")
        return min(angles), max(angles)


class TotalFov(NamedTuple):
    """Total field of view of both eyes, degrees, as hmdq computes it without hidden areas."""

    horizontal_deg: float
    """Angle from the left eye's left edge to the right eye's right edge."""
    vertical_deg: float
    """Mean of both eyes' vertical angles."""
    diagonal_deg: float
    """Mean of both diagonals, from a corner of one eye to the opposite corner of the other."""
    overlap_deg: float
    """Horizontal angle that both eyes see."""


def total_fov(left: Eye, right: Eye) -> TotalFov:
    """Compute the total field of view of two eyes for distant objects, for which the eyes' positions do not matter."""
    left_angles, right_angles = left.angles_deg, right.angles_deg
    diagonals = [_angle_between(left.corners[k], right.corners[(k + 2) % 4]) for k in (0, 3)]
    return TotalFov(
        horizontal_deg=right_angles[1] - left_angles[0],
        vertical_deg=((left_angles[3] - left_angles[2]) + (right_angles[3] - right_angles[2])) / 2.0,
        diagonal_deg=sum(diagonals) / 2.0,
        overlap_deg=left_angles[1] - right_angles[0],
    )


def _angle_between(a: NDArray[np.float64], b: NDArray[np.float64]) -> float:
    # Tangents may be so large that their products overflow; scaling by powers of two is exact.
    a, b = (np.ldexp(vector, -math.frexp(float(np.abs(vector).max()))[1]) for vector in (a, b))
    return math.degrees(math.atan2(float(np.linalg.norm(np.cross(a, b))), float(a @ b)))
