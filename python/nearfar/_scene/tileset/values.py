"""Checked values of JSON documents: errors name the entry, the expected and the actual value."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check
from nearfar._base.errors import UnusableError

FARTHEST = 1e10
"""Greatest coordinate of a tile, metres: a thousand times the Earth, whose frame most tilesets use."""


def numbers(place: str, value: Any, count: int) -> NDArray[np.float64]:
    """Check a list of `count` coordinates; UnusableError otherwise."""
    if not isinstance(value, list) or len(value) != count or not all(type(n) in (int, float) for n in value):
        raise UnusableError(f"{place}: expected {count} numbers, got {_describe(value)}")
    # Integers may have any number of digits.
    far = next((n for n in value if not -FARTHEST <= n <= FARTHEST), None)
    if far is not None:
        raise UnusableError(f"{place}: expected numbers within ±1e10, got {check.shortened(far)}")
    return np.array(value, np.float64)


def number(place: str, value: Any, least: float = 0.0) -> float:
    """Check a number of at least `least`, possibly infinite; UnusableError otherwise."""
    if type(value) not in (int, float) or not value >= least:
        raise UnusableError(f"{place}: expected a number of at least {least:g}, got {_describe(value)}")
    return min(float(value), np.inf) if value <= np.finfo(np.float64).max else np.inf


def whole(place: str, value: Any, least: int, most: int) -> int:
    """Check an integer within bounds; UnusableError otherwise."""
    if isinstance(value, float) and value.is_integer():
        value = int(value)
    if type(value) is not int or not least <= value <= most:
        raise UnusableError(f"{place}: expected a whole number from {least} to {most}, got {_describe(value)}")
    return value


def entries(place: str, value: Any) -> dict[str, Any]:
    """Check an object; UnusableError otherwise."""
    if not isinstance(value, dict):
        raise UnusableError(f"{place}: expected an object, got {_describe(value)}")
    return value


def items(place: str, value: Any) -> list[Any]:
    """Check a list; UnusableError otherwise."""
    if not isinstance(value, list):
        raise UnusableError(f"{place}: expected a list, got {_describe(value)}")
    return value


def text(place: str, value: Any) -> str:
    """Check a string; UnusableError otherwise."""
    if not isinstance(value, str):
        raise UnusableError(f"{place}: expected a text, got {_describe(value)}")
    return value


def choice(place: str, value: Any, known: tuple[str, ...]) -> str:
    """Check one of several strings, in any case; UnusableError otherwise."""
    chosen = value.upper() if isinstance(value, str) else value
    if chosen not in known:
        raise UnusableError(f"{place}: expected {' or '.join(known)}, got {_describe(value)}")
    return str(chosen)


def _describe(value: Any) -> str:
    if value is None:
        return "none"
    if isinstance(value, list):
        return f"a list of {len(value)}"
    return "an object" if isinstance(value, dict) else check.type_and_value(value)
