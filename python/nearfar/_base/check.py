"""Checks of arguments: each error message names the argument, the expected value and the value passed."""

from __future__ import annotations

import math
import operator
import os
from collections.abc import Collection
from pathlib import Path
from typing import Any, SupportsFloat, SupportsIndex, TypeVar

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

Kind = TypeVar("Kind")

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
    """Convert an argument to an aligned C-contiguous array in native byte order; copies only if it is not one already.

    Parameters
    ----------
    name
        The argument's public name.
    value
        The caller's value.
    columns
        Expected shape (N, columns); None accepts any shape.
    dtype
        Type of the result. None keeps float32 and float64 and converts other types to float64. An integer type accepts
        only whole numbers within its range.
    finite
        Whether to refuse NaN and infinities. This reads the whole array; callers whose kernels check it leave it off.

    Raises
    ------
    TypeError
        For values that are not real numbers, and for fractions where whole numbers are wanted.
    ValueError
        For a wrong shape, for whole numbers out of range, and for NaN and infinities if `finite`.
    """
    values = _numbers(name, value)
    target = _target_type(values.dtype, dtype)
    if columns is not None and (values.ndim != 2 or values.shape[1] != columns):
        raise ValueError(f"{name}: expected shape (N, {columns}), got {values.shape}")
    if target.kind in "iu":
        _whole(name, values, target)
    if finite and (flaw := not_finite(name, values)):
        raise flaw
    return np.require(values, target, ["C_CONTIGUOUS", "ALIGNED"])


def plain(name: str, value: ArrayLike) -> NDArray[Any]:
    """Convert an argument to an array of any type; TypeError for masked values, which would lose their mask."""
    # Only subclasses are tested, because the first use of `np.ma` loads it.
    if isinstance(value, np.ndarray) and type(value) is not np.ndarray and np.ma.is_masked(value):
        raise TypeError(f"{name}: expected an array without masked values, got one with a mask")
    try:
        return np.asarray(value)
    except ValueError:
        raise ValueError(f"{name}: expected rows of equal length") from None


def not_finite(name: str, values: NDArray[Any]) -> ValueError | None:
    """Make the error for an array with NaN or infinities, which names the first; None for an array without any."""
    if values.dtype.kind != "f" or np.isfinite(values).all():
        return None
    bad = np.argwhere(~np.isfinite(values))
    where = tuple(int(i) for i in bad[0])
    return ValueError(f"{name}: expected finite numbers, got {len(bad)} that are not, the first at {where}")


def output(name: str, value: NDArray[Any], source: NDArray[Any]) -> NDArray[Any]:
    """Check a caller's output array: shape and type of `source`, and no memory shared with it."""
    if not isinstance(value, np.ndarray):
        raise TypeError(f"{name}: expected an array, got {_describe(value)}")
    if value.shape != source.shape or value.dtype != source.dtype:
        raise ValueError(f"{name}: expected {source.shape} of {source.dtype}, got {value.shape} of {value.dtype}")
    if not (value.flags.c_contiguous and value.flags.aligned and value.flags.writeable):
        raise ValueError(f"{name}: expected a C-contiguous array that can be written, got one that is not")
    if np.may_share_memory(value, source):
        raise ValueError(f"{name}: expected memory of its own, got that of the argument")
    return value


def vector(name: str, value: ArrayLike) -> tuple[float, float, float]:
    """Return three finite numbers as float64, such as a position in metres; ValueError or TypeError otherwise."""
    values = _numbers(name, value)
    if values.shape != (3,):
        raise ValueError(f"{name}: expected 3 numbers, got shape {values.shape}")
    x, y, z = (float(v) for v in values)
    if not all(map(math.isfinite, (x, y, z))):
        raise ValueError(f"{name}: expected 3 finite numbers, got ({x}, {y}, {z})")
    return x, y, z


def number(name: str, value: SupportsFloat, *, finite: bool = True) -> float:
    """Return one number, which must be finite if `finite`; ValueError or TypeError otherwise."""
    if isinstance(value, str | bytes | bool) or not hasattr(type(value), "__float__"):
        raise TypeError(f"{name}: expected a number, got {_describe(value)}")
    result = float(value)
    if finite and not math.isfinite(result):
        raise ValueError(f"{name}: expected a finite number, got {result}")
    return result


def instance(name: str, value: object, kind: type[Kind], expected: str = "") -> Kind:
    """Return a value of a type, which `expected` describes if "a" and the type's name do not; TypeError otherwise."""
    if not isinstance(value, kind):
        raise TypeError(f"{name}: expected {expected or f'a {kind.__name__}'}, got {type(value).__name__}")
    return value


def within(name: str, value: SupportsFloat, low: float, high: float) -> float:
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


def integer(name: str, value: SupportsIndex, low: int, high: int) -> int:
    """Return one whole number within [low, high]; ValueError or TypeError otherwise."""
    if isinstance(value, bool) or not hasattr(type(value), "__index__"):
        raise TypeError(f"{name}: expected a whole number, got {_describe(value)}")
    result = operator.index(value)
    if not low <= result <= high:
        raise ValueError(f"{name}: expected a whole number from {low} to {high}, got {result}")
    return result


def pair(name: str, value: tuple[int, int], low: int, high: int) -> tuple[int, int]:
    """Return two whole numbers within [low, high]; ValueError or TypeError otherwise."""
    return _pair(name, value, low, high, "two whole numbers")


def size(name: str, value: tuple[int, int]) -> tuple[int, int]:
    """Return width and height of an image in pixels; TypeError or ValueError otherwise."""
    return _pair(name, value, 1, MAX_SIZE, "(width, height) in pixels")


def spheres(centers: ArrayLike, radii: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return centres (N, 3) and radii (N,) as float64; one radius is repeated for all; ValueError otherwise."""
    places = array("centers", centers, dtype=np.float64)
    sizes = array("radii", radii, columns=None, dtype=np.float64)
    if sizes.shape not in ((), (len(places),)):
        raise ValueError(f"radii: expected one number or shape ({len(places)},), got {sizes.shape}")
    return places, np.ascontiguousarray(np.broadcast_to(sizes, len(places)))


def choice(name: str, value: str, options: Collection[str]) -> str:
    """Return one of the named options; ValueError or TypeError otherwise."""
    if not isinstance(value, str):
        raise TypeError(f"{name}: expected a string, got {_describe(value)}")
    if value not in options:
        listed = ", ".join(repr(option) for option in options)
        raise ValueError(f"{name}: expected one of {listed}, got {value!r}")
    return value


def path(name: str, value: str | os.PathLike[str]) -> Path:
    """Return a path in the file system; TypeError for anything but a string or a path."""
    if not isinstance(value, str | os.PathLike) or isinstance(os.fspath(value), bytes):
        raise TypeError(f"{name}: expected a string or a path, got {_describe(value)}")
    return Path(value)


def radii(r1: SupportsFloat, r2: SupportsFloat) -> tuple[float, float]:
    """Return the radii in metres that bound the near and the intermediate zone, 0 ≤ r1 < r2; ValueError otherwise."""
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
    values = plain(name, value)
    if values.dtype.kind not in "iuf":
        # An empty list passes the test above, because NumPy makes it float64.
        raise TypeError(f"{name}: expected real numbers, got {_describe(value)} of type {values.dtype}")
    return values


def _target_type(source: np.dtype[Any], dtype: DTypeLike | None) -> np.dtype[Any]:
    if dtype is not None:
        return np.dtype(dtype)
    return np.dtype(np.float32 if source.kind == "f" and source.itemsize == 4 else np.float64)


def _whole(name: str, values: NDArray[Any], target: np.dtype[Any]) -> None:
    if values.size == 0 or values.dtype == target:
        return
    if values.dtype.kind not in "iu":
        raise TypeError(f"{name}: expected whole numbers, got {values.dtype}")
    low, high = int(values.min()), int(values.max())
    limits = np.iinfo(target)
    if low < limits.min or high > limits.max:
        raise ValueError(f"{name}: expected whole numbers from {limits.min} to {limits.max}, got {low} to {high}")


def _describe(value: object) -> str:
    return f"{type(value).__name__} {value!r}" if isinstance(value, str | bool | int | float) else type(value).__name__
