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


def numbers(place: str, value: Any, count: int) -> NDArray[np.float64]:
    """Check a list of `count` coordinates; UnusableError otherwise."""
    if not isinstance(value, list) or len(value) != count or not all(type(n) in (int, float) for n in value):
        stated = f"a list of {len(value)}" if isinstance(value, list) else describe(value)
        raise UnusableError(f"{place}: expected {count} numbers, got {stated}")
    # Integers may have any number of digits.
    far = next((n for n in value if not -FARTHEST <= n <= FARTHEST), None)
    if far is not None:
        raise UnusableError(f"{place}: expected numbers within ±1e10, got {check.shortened(far)}")
    return np.array(value, np.float64)


def number(place: str, value: Any, least: float = 0.0) -> float:
    """Check a number of at least `least`, possibly infinite; UnusableError otherwise."""
    if type(value) not in (int, float) or not value >= least:
        raise UnusableError(f"{place}: expected a number of at least {least:g}, got {describe(value)}")
    return min(float(value), np.inf) if value <= np.finfo(np.float64).max else np.inf


def whole(place: str, value: Any, least: int, most: int) -> int:
    """Check an integer within bounds; UnusableError otherwise."""
    if isinstance(value, float) and value.is_integer():
        value = int(value)
    if type(value) is not int or not least <= value <= most:
        raise UnusableError(f"{place}: expected a whole number from {least} to {most}, got {describe(value)}")
    return value


def choice(place: str, value: Any, known: tuple[str, ...]) -> str:
    """Check one of several strings, in any case; UnusableError otherwise."""
    chosen = value.upper() if isinstance(value, str) else value
    if chosen not in known:
        raise UnusableError(f"{place}: expected {' or '.join(known)}, got {describe(value)}")
    return str(chosen)
