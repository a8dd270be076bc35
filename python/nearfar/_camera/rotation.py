"""Rotations as unit quaternions (x, y, z, w)."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

Quaternion = tuple[float, float, float, float]


def rotation(orientation: Quaternion) -> NDArray[np.float64]:
    """Compute the rotation matrix (3, 3) of a unit quaternion (x, y, z, w)."""
    x, y, z, w = orientation
    return np.array(
        [
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - z * w), 2.0 * (x * z + y * w)],
            [2.0 * (x * y + z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - x * w)],
            [2.0 * (x * z - y * w), 2.0 * (y * z + x * w), 1.0 - 2.0 * (x * x + y * y)],
        ]
    )


def compose_rotations(first: Quaternion, then: Quaternion) -> Quaternion:
    """Compute the unit quaternion of the rotation `first` followed by `then`."""
    (ax, ay, az, aw), (bx, by, bz, bw) = then, first
    product = (
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
        aw * bw - ax * bx - ay * by - az * bz,
    )
    length = math.sqrt(sum(part * part for part in product))
    return (product[0] / length, product[1] / length, product[2] / length, product[3] / length)
