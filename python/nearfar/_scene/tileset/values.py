"""Checked values of JSON documents: errors name the entry, the expected and the actual value."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check
from nearfar._base.errors import UnusableError
from nearfar._scene.entries import describe

FARTHEST = 1e10
"""Greatest coordinate of a tile, metres: a thousand times the Earth, whose frame most tilesets use."""


def numbers(json_path: str, value: Any, count: int) -> NDArray[np.float64]:
    """Check a list of `count` coordinates; UnusableError otherwise."""
    if not isinstance(value, list) or len(value) != count or not all(type(n) in (int, float) for n in value):
        got = f"a list of {len(value)}" if isinstance(value, list) else describe(value)
        raise UnusableError(f"{json_path}: expected {count} numbers, got {got}")
    # Integers may have any number of digits.
    too_large = next((n for n in value if not -FARTHEST <= n <= FARTHEST), None)
    if too_large is not None:
        raise UnusableError(f"{json_path}: expected numbers within ±1e10, got {check.shortened(too_large)}")
    return np.array(value, np.float64)


def number(json_path: str, value: Any, minimum: float = 0.0) -> float:
    """Check a number of at least `least`, possibly infinite; UnusableError otherwise."""
    if type(value) not in (int, float) or not value >= minimum:
        raise UnusableError(f"{json_path}: expected a number of at least {minimum:g}, got {describe(value)}")
    return min(float(value), np.inf) if value <= np.finfo(np.float64).max else np.inf


def whole(json_path: str, value: Any, minimum: int, maximum: int) -> int:
    """Check an integer within bounds; UnusableError otherwise."""
    if isinstance(value, float) and value.is_integer():
        value = int(value)
    if type(value) is not int or not minimum <= value <= maximum:
        raise UnusableError(f"{json_path}: expected a whole number from {minimum} to {maximum}, got {describe(value)}")
    return value


def choice(json_path: str, value: Any, options: tuple[str, ...]) -> str:
    """Check one of several strings, in any case; UnusableError otherwise."""
    upper = value.upper() if isinstance(value, str) else value
    if upper not in options:
        raise UnusableError(f"{json_path}: expected {' or '.join(options)}, got {describe(value)}")
    return str(upper)
