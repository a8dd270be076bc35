"""Bend of straight lines at the mono plane, in closed form."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nearfar._camera.rotation import rotation
from nearfar.hmd._eye import Eye

Array = NDArray[np.float64]


def kink_angles(eye: Eye, m: float, s: float, tangents: Array, direction: Array) -> Array:
    """Compute the angles (N,) in degrees between lines' images just in front of the plane m and just behind it.

    The eye's position is relative to the midpoint between the eyes; s is the third camera's distance behind that. Let X
    be the point on the plane and v the line's direction per metre ahead. The vector from the eye to the displayed point
    changes by (v, −1) in front of the plane. Behind it the displayed point is where the third camera's ray intersects
    the plane, so the vector changes by (v − X/(m + s), 0).
    """
    turn, position = rotation(eye.orientation), np.array(eye.position)
    directions = np.column_stack([tangents, -np.ones(len(tangents))]) @ turn.T
    from_eye = directions * ((m + position[2]) / -directions[:, 2:])
    on_plane = from_eye[:, :2] + position[:2]
    before = np.column_stack([direction, -np.ones(len(direction))])
    behind = np.column_stack([direction - on_plane / (m + s), np.zeros(len(direction))])
    image_before, image_behind = (_image_of(from_eye @ turn, change @ turn) for change in (before, behind))
    cross = image_before[:, 0] * image_behind[:, 1] - image_before[:, 1] * image_behind[:, 0]
    dot = (image_before * image_behind).sum(axis=1)
    angles = np.degrees(np.arctan2(np.abs(cross), dot))
    is_point = (np.abs(image_before).max(axis=1) < 1e-12) | (np.abs(image_behind).max(axis=1) < 1e-12)
    return np.where(is_point, np.nan, angles)


def _image_of(point: Array, change: Array) -> Array:
    """Changes (N, 2) of the tangents of a moving point (N, 3) in an eye's axes."""
    depth = -point[:, 2:]
    return np.asarray(change[:, :2] / depth + point[:, :2] * change[:, 2:] / depth**2)
