"""Poses of a user, checked and rounded to the precision of frames."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from nearfar._base import check
from nearfar.stream._room_events import Begin, Placed, Pointer
from nearfar.stream._room_frames import FARTHEST, MAX_LENGTH, MIN_LENGTH, ONE


def parse_pose(names: tuple[str, str], position: ArrayLike, rotation: ArrayLike) -> Placed:
    """Convert the pose of a head or a hand; errors name the arguments by `names`."""
    where, turned = check.vector(names[0], position), check.array(names[1], rotation, columns=None, dtype=np.float64)
    if max(map(abs, where)) > FARTHEST:
        raise ValueError(f"{names[0]}: expected coordinates within {FARTHEST:g} m of the origin, got {where}")
    if turned.shape != (4,):
        raise ValueError(f"{names[1]}: expected a quaternion (x, y, z, w), got shape {turned.shape}")
    length = float(np.linalg.norm(turned))
    # NaN fails the comparison.
    if not MIN_LENGTH <= length <= MAX_LENGTH:
        raise ValueError(f"{names[1]}: expected a quaternion of length 1, got one of length {length:g}")
    return Placed(np.array(where, np.float32), np.rint(turned / length * ONE) / ONE)


def hand(name: str, value: tuple[ArrayLike, ArrayLike] | None) -> Placed | None:
    """Convert the pose of a hand; None stays None."""
    if value is None:
        return None
    if not isinstance(value, tuple | list) or len(value) != 2:
        raise TypeError(f"{name}: expected a position and a quaternion, got {check.type_and_value(value)}")
    return parse_pose((name, name), *value)


def pointer(value: tuple[Begin, float] | None, left: Placed | None, right: Placed | None) -> Pointer | None:
    """Convert a pointer from its origin and length; None stays None. ValueError if its hand is missing."""
    if value is None:
        return None
    if not isinstance(value, tuple | list) or len(value) != 2:
        raise TypeError(
            f"pointer: expected where it begins and its length in metres, got {check.type_and_value(value)}"
        )
    begin, length = value
    check.choice("pointer", begin, ("head", "left", "right"))
    if (begin == "left" and left is None) or (begin == "right" and right is None):
        raise ValueError(f"pointer: expected a hand at which it begins, got {begin!r} without one")
    return Pointer(begin, float(np.float32(check.in_range("pointer", length, 0.0, FARTHEST))))
