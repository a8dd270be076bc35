"""Checks of single numbers, and of pairs of them."""

from __future__ import annotations

import math
import operator
from collections.abc import Sequence
from typing import SupportsFloat, SupportsIndex

import numpy as np

from nearfar._base.check.describe import shortened, type_and_value, value_or_type

MAX_SIZE = 1 << 16
"""Greatest width or height of an image in pixels."""


def number(name: str, value: SupportsFloat, *, finite: bool = True) -> float:
    """Return one number, which must be finite if `finite`; ValueError or TypeError otherwise."""
    result = value if type(value) is float else _float(name, value)
    if finite and not math.isfinite(result):
        raise ValueError(f"{name}: expected a finite number, got {result}")
    return result


def in_range(name: str, value: SupportsFloat, low: float, high: float) -> float:
    """Return one number within [low, high]; ValueError or TypeError otherwise."""
    result = number(name, value)
    if not low <= result <= high:
        raise ValueError(f"{name}: expected a number from {low:g} to {high:g}, got {result}")
    return result


def at_least_zero(name: str, value: SupportsFloat) -> float:
    """Return one finite number of at least zero; ValueError or TypeError otherwise."""
    result = number(name, value)
    if result < 0.0:
        raise ValueError(f"{name}: expected a number of at least 0, got {result}")
    return result


def positive(name: str, value: SupportsFloat) -> float:
    """Return one finite number above zero; ValueError or TypeError otherwise."""
    result = number(name, value)
    if result <= 0.0:
        raise ValueError(f"{name}: expected a number above 0, got {result}")
    return result


def integer(name: str, value: SupportsIndex | float, low: int, high: int) -> int:
    """Return one whole number within [low, high], such as 1000000 or 1e6; ValueError or TypeError otherwise."""
    result = value if type(value) is int else _index(name, value)
    if not low <= result <= high:
        raise ValueError(f"{name}: expected a whole number from {low} to {high}, got {shortened(result)}")
    return result


def pair(name: str, value: tuple[int, int], low: int, high: int) -> tuple[int, int]:
    """Return two whole numbers within [low, high]; ValueError or TypeError otherwise."""
    return _pair(name, value, low, high, "two whole numbers")


def size(name: str, value: tuple[int, int]) -> tuple[int, int]:
    """Return width and height of an image in pixels; TypeError or ValueError otherwise."""
    return _pair(name, value, 1, MAX_SIZE, "(width, height) in pixels")


def radii(r1: SupportsFloat, r2: SupportsFloat) -> tuple[float, float]:
    """Check the radii in metres that bound the near and the intermediate zone, 0 ≤ r1 < r2; ValueError otherwise."""
    inner, outer = number("r1", r1), number("r2", r2)
    if inner < 0.0:
        raise ValueError(f"r1: expected a radius of at least 0, got {inner}")
    if inner >= outer:
        raise ValueError(f"r1: expected less than r2 = {outer}, got {inner}")
    return inner, outer


def flag(name: str, value: bool) -> bool:
    """Check a bool; TypeError for anything else, because texts and most arrays would count as true."""
    if not isinstance(value, bool | np.bool_):
        raise TypeError(f"{name}: expected True or False, got {type_and_value(value)}")
    return bool(value)


def _float(name: str, value: SupportsFloat) -> float:
    if not _is_number(value) or not hasattr(type(value), "__float__"):
        raise TypeError(f"{name}: expected a number, got {type_and_value(value)}")
    try:
        return float(value)
    except OverflowError:
        raise ValueError(f"{name}: expected a number up to 1.8e308, got {type_and_value(value)}") from None
    except (TypeError, ValueError):
        raise TypeError(f"{name}: expected a number, got {type_and_value(value)}") from None


def _index(name: str, value: SupportsIndex | float) -> int:
    if _is_number(value) and isinstance(value, float | np.floating | np.ndarray) and float(value).is_integer():
        return int(value)
    if not _is_number(value) or not hasattr(type(value), "__index__"):
        raise TypeError(f"{name}: expected a whole number, got {type_and_value(value)}")
    try:
        return operator.index(value)  # type: ignore[arg-type]
    except (TypeError, ValueError):
        raise TypeError(f"{name}: expected a whole number, got {type_and_value(value)}") from None


def _is_number(value: object) -> bool:
    """Return whether a value may be a real number: not a bool, text, date, complex number or array with axes."""
    if isinstance(value, np.ndarray | np.generic):
        return value.ndim == 0 and value.dtype.kind in "iuf" and not is_masked(value)
    return not isinstance(value, str | bytes | bool)


def is_masked(value: object) -> bool:
    """Return whether a value is an array with masked values, whose mask a conversion would lose."""
    # Only subclasses are tested: the first use of `np.ma` imports it.
    return isinstance(value, np.ndarray) and type(value) is not np.ndarray and bool(np.ma.is_masked(value))


def _pair(name: str, value: tuple[int, int], low: int, high: int, expected: str) -> tuple[int, int]:
    is_row = value.ndim == 1 if isinstance(value, np.ndarray) else isinstance(value, Sequence)
    if not is_row or isinstance(value, str | bytes) or len(value) != 2:
        raise TypeError(f"{name}: expected {expected}, got {value_or_type(value)}")
    return integer(f"{name}[0]", value[0], low, high), integer(f"{name}[1]", value[1], low, high)
