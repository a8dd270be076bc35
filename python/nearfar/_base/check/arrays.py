"""Checks and conversions of arrays of numbers, and of positions."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from nearfar._base import memory
from nearfar._base.check.describe import type_and_value
from nearfar._base.check.numbers import is_masked

FARTHEST = 1e30
"""Greatest coordinate of a position, metres, as in the core: beyond it, float32 rays overflow and miss the geometry."""

_UNCHECKED_BYTES = 1 << 30
"""Size in bytes up to which arrays are not checked, because every machine has as much memory."""


def array(
    name: str, value: ArrayLike, *, columns: int | None = 3, dtype: DTypeLike | None = None, finite: bool = False
) -> NDArray[Any]:
    """Convert an argument to an aligned C-contiguous array in native byte order; copies only if it is not one already.

    The shape must be (N, columns); None accepts any shape. `dtype` None keeps float32 and float64 and converts other
    types to float64. An integer type accepts only whole numbers within its range. `finite` rejects NaN and infinities.
    It reads the whole array, so leave it off if the kernel checks this. TypeError for values that are not real numbers,
    and for fractions if integers are required; ValueError for all else.
    """
    values = _numbers(name, value)
    is_float32 = values.dtype.kind == "f" and values.dtype.itemsize == 4
    target: np.dtype[Any] = np.dtype((np.float32 if is_float32 else np.float64) if dtype is None else dtype)
    if columns is not None and (values.ndim != 2 or values.shape[1] != columns):
        raise ValueError(f"{name}: expected shape (N, {columns}), got {values.shape}")
    if target.kind in "iu":
        _check_whole_numbers(name, values, target)
    result = _converted(name, values, target)
    if finite and (flaw := not_finite(name, result)):
        raise flaw
    return result


def counts(name: str, value: ArrayLike) -> NDArray[np.int64]:
    """Convert counts of any shape to int64; whole floats such as 1e6 count as whole numbers, as in `integer`.

    TypeError for values that are not whole numbers; ValueError for negative ones, and those beyond int64.
    """
    values = _numbers(name, value)
    if values.dtype.kind == "f":
        wide = values.astype(np.float64)
        is_whole = (wide == np.rint(wide)) & (np.abs(wide) < 2.0**63)
        values = wide.astype(np.int64) if is_whole.all() else values
    numbers = array(name, values, columns=None, dtype=np.int64)
    if numbers.size and numbers.min() < 0:
        raise ValueError(f"{name}: expected numbers of at least 0, got {numbers.min()}")
    return numbers


def plain(name: str, value: ArrayLike) -> NDArray[Any]:
    """Convert an argument to an array of any type.

    TypeError for masked values, which would lose their mask. ValueError for rows of unequal length. MemoryError for
    broadcast arrays (stride 0) whose copy would not fit into the machine's memory.
    """
    if is_masked(value):
        raise TypeError(f"{name}: expected an array without masked values, got one with a mask")
    try:
        values = np.asarray(value)
    except ValueError:
        raise ValueError(f"{name}: expected rows of equal length") from None
    # The memory of contiguous arrays exists: they own it, or map a file.
    if values.nbytes > _UNCHECKED_BYTES and not values.flags.forc and values.nbytes > memory.installed():
        raise _too_large(name, values, values.dtype)
    return values


def not_finite(name: str, values: NDArray[Any]) -> ValueError | None:
    """Return an error that names the first NaN or infinity of an array; None if all values are finite."""
    if values.dtype.kind != "f" or np.isfinite(values).all():
        return None
    indices = np.argwhere(~np.isfinite(values))
    where = tuple(int(i) for i in indices[0])
    return ValueError(f"{name}: expected finite numbers, got {len(indices)} that are not, the first at {where}")


def output(name: str, value: NDArray[Any], source: NDArray[Any]) -> NDArray[Any]:
    """Check a caller's output array: shape and type of `source`, and no memory shared with it."""
    if not isinstance(value, np.ndarray):
        raise TypeError(f"{name}: expected an array, got {type_and_value(value)}")
    if value.shape != source.shape or value.dtype != source.dtype:
        raise ValueError(f"{name}: expected {source.shape} of {source.dtype}, got {value.shape} of {value.dtype}")
    if not (value.flags.c_contiguous and value.flags.aligned and value.flags.writeable):
        raise ValueError(f"{name}: expected a C-contiguous array that can be written, got one that is not")
    if np.may_share_memory(value, source):
        raise ValueError(f"{name}: expected an array that shares no memory with the input, got one that does")
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


def box(name: str, value: ArrayLike) -> NDArray[np.float64]:
    """Return a box (2, 3), least and greatest corner, as float64; sides may be infinite.

    ValueError for NaN, a wrong shape, or a least corner above the greatest; TypeError for values that are not numbers.
    """
    corners = array(name, value, columns=None, dtype=np.float64)
    if corners.shape != (2, 3):
        raise ValueError(f"{name}: expected shape (2, 3), a least and a greatest corner, got {corners.shape}")
    if not (corners[0] <= corners[1]).all():
        raise ValueError(f"{name}: expected a least corner not above the greatest, got {corners.tolist()}")
    return corners


def spheres(centers: ArrayLike, radii: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return centres (N, 3) and radii (N,) as float64; one radius is repeated for all; ValueError otherwise."""
    positions = array("centers", centers, dtype=np.float64)
    sizes = array("radii", radii, columns=None, dtype=np.float64)
    if sizes.shape not in ((), (len(positions),)):
        raise ValueError(f"radii: expected one number or shape ({len(positions)},), got {sizes.shape}")
    return positions, np.ascontiguousarray(np.broadcast_to(sizes, len(positions)))


def _numbers(name: str, value: ArrayLike) -> NDArray[Any]:
    values = plain(name, value)
    if values.dtype.kind not in "iuf":
        # Empty lists pass: NumPy makes them float64.
        raise TypeError(f"{name}: expected real numbers, got {type_and_value(value)} of type {values.dtype}")
    return values


def _check_whole_numbers(name: str, values: NDArray[Any], target: np.dtype[Any]) -> None:
    if values.size == 0 or values.dtype == target:
        return
    if values.dtype.kind not in "iu":
        raise TypeError(f"{name}: expected whole numbers, got {values.dtype}")
    low, high = int(values.min()), int(values.max())
    limits = np.iinfo(target)
    if low < limits.min or high > limits.max:
        raise ValueError(f"{name}: expected whole numbers from {limits.min} to {limits.max}, got {low} to {high}")


def _converted(name: str, values: NDArray[Any], target: np.dtype[Any]) -> NDArray[Any]:
    """Convert type and layout; numbers beyond the range of a smaller float type become infinite."""
    if values.dtype == target and values.flags.c_contiguous and values.flags.aligned:
        return values
    try:
        with np.errstate(over="ignore", invalid="ignore"):
            return np.require(values, target, ["C_CONTIGUOUS", "ALIGNED"])
    except MemoryError:
        raise _too_large(name, values, target) from None


def _too_large(name: str, values: NDArray[Any], target: np.dtype[Any]) -> MemoryError:
    size = values.size * target.itemsize
    return MemoryError(f"{name}: a copy of {values.dtype} of shape {values.shape} as {target} needs {size} bytes")
