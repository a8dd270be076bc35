"""Checks names of rooms and users by the server's rules, and poses, rounded as in frames."""

from __future__ import annotations

import unicodedata

import numpy as np
from numpy.typing import ArrayLike

from nearfar._base import check
from nearfar.stream._room_events import Placed, Pointer, PointerOrigin as Origin
from nearfar.stream._room_frames import MAX_METRES, MAX_NORM, MIN_NORM, ONE

MAX_NAME_BYTES = 64
"""Greatest size of a name, bytes."""


def room_name(argument: str, value: str) -> str:
    """Check a room's name; ValueError for one that cannot be part of a room's address."""
    name = _text(argument, value)
    # Clients and proxies resolve dots as folders.
    if not name or "/" in name or name in (".", ".."):
        got = check.shortened(value)
        raise ValueError(
            f"{argument}: expected 1 to {MAX_NAME_BYTES} bytes without a slash, but not . or .., got {got}"
        )
    return name


def user_name(argument: str, value: str) -> str:
    """Check a user's name, which may be empty; ValueError for invisible characters, which make names look alike."""
    name = _text(argument, value)
    if any(unicodedata.category(letter) == "Cf" for letter in name):
        raise ValueError(f"{argument}: expected no characters that only format, got {check.shortened(value)}")
    return name


def _text(argument: str, value: str) -> str:
    name = check.text(argument, value)
    if len(name.encode()) > MAX_NAME_BYTES:
        raise ValueError(f"{argument}: expected at most {MAX_NAME_BYTES} bytes of UTF-8, got {check.shortened(value)}")
    if any(unicodedata.category(letter) == "Cc" for letter in name):
        raise ValueError(f"{argument}: expected no control characters, got {check.shortened(value)}")
    return name


def parse_pose(names: tuple[str, str], position: ArrayLike, rotation: ArrayLike) -> Placed:
    """Convert the pose of a head or a hand; errors name the arguments by `names`."""
    point = check.vector(names[0], position)
    quaternion = check.array(names[1], rotation, columns=None, dtype=np.float64)
    if max(map(abs, point)) > MAX_METRES:
        raise ValueError(f"{names[0]}: expected coordinates within {MAX_METRES:g} m of the origin, got {point}")
    if quaternion.shape != (4,):
        raise ValueError(f"{names[1]}: expected a quaternion (x, y, z, w), got shape {quaternion.shape}")
    norm = float(np.linalg.norm(quaternion))
    # NaN fails the comparison.
    if not MIN_NORM <= norm <= MAX_NORM:
        raise ValueError(f"{names[1]}: expected a quaternion of length 1, got one of length {norm:g}")
    return Placed(np.array(point, np.float32), np.rint(quaternion / norm * ONE) / ONE)


def parse_hand(name: str, value: tuple[ArrayLike, ArrayLike] | None) -> Placed | None:
    """Convert the pose of a hand; None stays None."""
    if value is None:
        return None
    if not isinstance(value, tuple | list) or len(value) != 2:
        raise TypeError(f"{name}: expected a position and a quaternion, got {check.type_and_value(value)}")
    return parse_pose((name, name), *value)


def parse_pointer(value: tuple[Origin, float] | None, left: Placed | None, right: Placed | None) -> Pointer | None:
    """Convert a pointer from its origin and length; None stays None. ValueError if its hand is missing."""
    if value is None:
        return None
    if not isinstance(value, tuple | list) or len(value) != 2:
        raise TypeError(f"pointer: expected its origin and its length in metres, got {check.type_and_value(value)}")
    begin, length = value
    check.choice("pointer", begin, ("head", "left", "right"))
    if (begin == "left" and left is None) or (begin == "right" and right is None):
        raise ValueError(f"pointer: expected a hand as its origin, got {begin!r} without that hand's pose")
    return Pointer(begin, float(np.float32(check.in_range("pointer", length, 0.0, MAX_METRES))))
