"""Checks of arguments. Each raises a sentence that names the argument, what was expected and what came."""

from __future__ import annotations

import math
import operator
import os
from collections.abc import Collection
from pathlib import Path
from typing import Any, SupportsFloat, SupportsIndex

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

MAX_SIZE = 1 << 16
"""Greatest width or height of an image in pixels."""


def array(
    name: str,
    value: ArrayLike,
    *,
    columns: int | None = 3,
    dtype: DTypeLike | None = None,
    finite: bool = False,
) -> NDArray[Any]:
    """Make an argument an aligned C-contiguous array in native byte order; copies only where it is not one already.

    Parameters
    ----------
    name
        The argument's public name.
    value
        What the caller passed.
    columns
        Expected shape (N, columns); None accepts any shape.
    dtype
        Wanted type. None keeps float32 and float64 and makes everything else float64. An integer type takes whole
        numbers only, within its range.
    finite
        Whether NaN and infinities are refused. It reads the whole array, so kernels that find out anyway skip it.

    Raises
    ------
    TypeError
        For values that are not real numbers, and for fractions where whole numbers are wanted.
    ValueError
        For a wrong shape, for whole numbers out of range, and for NaN and infinities if `finite`.
    """
    given = _numbers(name, value)
    wanted = _wanted(given.dtype, dtype)
    if columns is not None and (given.ndim != 2 or given.shape[1] != columns):
        raise ValueError(f"{name}: expected shape (N, {columns}), got {given.shape}")
    if wanted.kind in "iu":
        _whole(name, given, wanted)
    if finite and given.dtype.kind == "f" and not np.isfinite(given).all():
        bad = np.argwhere(~np.isfinite(given))
        where = tuple(int(i) for i in bad[0])
        raise ValueError(f"{name}: expected finite numbers, got {len(bad)} that are not, the first at {where}")
    return np.require(given, wanted, ["C_CONTIGUOUS", "ALIGNED"])


def plain(name: str, value: ArrayLike) -> NDArray[Any]:
    """Make an argument an array of any type; TypeError for masked values, which would lose their mask."""
    # Only subclasses are looked at, because `np.ma` is not loaded before its first use.
    if isinstance(value, np.ndarray) and type(value) is not np.ndarray and np.ma.is_masked(value):
        raise TypeError(f"{name}: expected an array without masked values, got one with a mask")
    try:
        return np.asarray(value)
    except ValueError:
        raise ValueError(f"{name}: expected rows of equal length") from None


def output(name: str, value: NDArray[Any], given: NDArray[Any]) -> NDArray[Any]:
    """Accept a caller's array for a result of the shape and type of what is given, apart from it in memory."""
    if not isinstance(value, np.ndarray):
        raise TypeError(f"{name}: expected an array, got {_what(value)}")
    if value.shape != given.shape or value.dtype != given.dtype:
        raise ValueError(f"{name}: expected {given.shape} of {given.dtype}, got {value.shape} of {value.dtype}")
    if not (value.flags.c_contiguous and value.flags.aligned and value.flags.writeable):
        raise ValueError(f"{name}: expected a C-contiguous array that can be written, got one that is not")
    if np.may_share_memory(value, given):
        raise ValueError(f"{name}: expected memory of its own, got that of the argument")
    return value


def vector(name: str, value: ArrayLike) -> tuple[float, float, float]:
    """Three finite numbers as float64, such as a position in metres; ValueError or TypeError otherwise."""
    given = _numbers(name, value)
    if given.shape != (3,):
        raise ValueError(f"{name}: expected 3 numbers, got shape {given.shape}")
    x, y, z = (float(v) for v in given)
    if not all(map(math.isfinite, (x, y, z))):
        raise ValueError(f"{name}: expected 3 finite numbers, got ({x}, {y}, {z})")
    return x, y, z


def number(name: str, value: SupportsFloat, *, finite: bool = True) -> float:
    """One number, finite if wanted; ValueError or TypeError otherwise."""
    if isinstance(value, str | bytes | bool) or not hasattr(type(value), "__float__"):
        raise TypeError(f"{name}: expected a number, got {_what(value)}")
    result = float(value)
    if finite and not math.isfinite(result):
        raise ValueError(f"{name}: expected a finite number, got {result}")
    return result


def positive(name: str, value: SupportsFloat) -> float:
    """One finite number above zero; ValueError or TypeError otherwise."""
    result = number(name, value)
    if result <= 0.0:
        raise ValueError(f"{name}: expected a number above 0, got {result}")
    return result


def integer(name: str, value: SupportsIndex, low: int, high: int) -> int:
    """One whole number within [low, high]; ValueError or TypeError otherwise."""
    if isinstance(value, bool) or not hasattr(type(value), "__index__"):
        raise TypeError(f"{name}: expected a whole number, got {_what(value)}")
    result = operator.index(value)
    if not low <= result <= high:
        raise ValueError(f"{name}: expected a whole number from {low} to {high}, got {result}")
    return result


def pair(name: str, value: tuple[int, int], low: int, high: int) -> tuple[int, int]:
    """Two whole numbers within [low, high]; ValueError or TypeError otherwise."""
    return _pair(name, value, low, high, "two whole numbers")


def size(name: str, value: tuple[int, int]) -> tuple[int, int]:
    """Width and height of an image in pixels; TypeError or ValueError otherwise."""
    return _pair(name, value, 1, MAX_SIZE, "(width, height) in pixels")


def spheres(centers: ArrayLike, radii: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Centres (N, 3) and as many radii, of which one may stand for all, as float64; ValueError otherwise."""
    places = array("centers", centers, dtype=np.float64)
    sizes = array("radii", radii, columns=None, dtype=np.float64)
    if sizes.shape not in ((), (len(places),)):
        raise ValueError(f"radii: expected one number or shape ({len(places)},), got {sizes.shape}")
    return places, np.ascontiguousarray(np.broadcast_to(sizes, len(places)))


def choice(name: str, value: str, options: Collection[str]) -> str:
    """One of the named options; ValueError or TypeError otherwise."""
    if not isinstance(value, str):
        raise TypeError(f"{name}: expected a string, got {_what(value)}")
    if value not in options:
        listed = ", ".join(repr(option) for option in options)
        raise ValueError(f"{name}: expected one of {listed}, got {value!r}")
    return value


def path(name: str, value: str | os.PathLike[str]) -> Path:
    """A place in the file system; TypeError for anything but a string or a path."""
    if not isinstance(value, str | os.PathLike) or isinstance(os.fspath(value), bytes):
        raise TypeError(f"{name}: expected a string or a path, got {_what(value)}")
    return Path(value)


def radii(r1: SupportsFloat, r2: SupportsFloat) -> tuple[float, float]:
    """Radii in metres of the near and the intermediate region: 0 ≤ r1 < r2, both finite; ValueError otherwise."""
    inner, outer = number("r1", r1), number("r2", r2)
    if inner < 0.0:
        raise ValueError(f"r1: expected a radius of at least 0, got {inner}")
    if inner >= outer:
        raise ValueError(f"r1: expected less than r2 = {outer}, got {inner}")
    return inner, outer


def _pair(name: str, value: tuple[int, int], low: int, high: int, expected: str) -> tuple[int, int]:
    try:
        one, other = value
    except (TypeError, ValueError):
        raise TypeError(f"{name}: expected {expected}, got {value!r}") from None
    return integer(f"{name}[0]", one, low, high), integer(f"{name}[1]", other, low, high)


def _numbers(name: str, value: ArrayLike) -> NDArray[Any]:
    given = plain(name, value)
    if given.dtype.kind not in "iuf":
        # An empty list has no type of its own: NumPy calls it float64, so it passes above.
        raise TypeError(f"{name}: expected real numbers, got {_what(value)} of type {given.dtype}")
    return given


def _wanted(given: np.dtype[Any], dtype: DTypeLike | None) -> np.dtype[Any]:
    if dtype is not None:
        return np.dtype(dtype)
    return np.dtype(np.float32 if given.kind == "f" and given.itemsize == 4 else np.float64)


def _whole(name: str, given: NDArray[Any], wanted: np.dtype[Any]) -> None:
    if given.size == 0 or given.dtype == wanted:
        return
    if given.dtype.kind not in "iu":
        raise TypeError(f"{name}: expected whole numbers, got {given.dtype}")
    low, high = int(given.min()), int(given.max())
    limits = np.iinfo(wanted)
    if low < limits.min or high > limits.max:
        raise ValueError(f"{name}: expected whole numbers from {limits.min} to {limits.max}, got {low} to {high}")


def _what(value: object) -> str:
    return f"{type(value).__name__} {value!r}" if isinstance(value, str | bool | int | float) else type(value).__name__
