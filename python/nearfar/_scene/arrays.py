"""Checks and conversions of arrays for meshes; arrays of the right type and layout are borrowed without a copy."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check

_UNIT = 1e-4
"""Tolerance of a unit normal's squared length: normals written with four digits count as unit normals."""

MAX_FLOAT32 = float(np.finfo(np.float32).max)
"""Greatest finite float32."""

MAX_CUTOFF = MAX_FLOAT32
"""Greatest alpha cutoff, which is stored as float32."""

ORIGIN_LIMIT = 32_768.0
"""Distance in metres beyond which float32 steps exceed 2 mm and coordinates are stored relative to an origin."""


def origin_for(bounds: NDArray[np.float64]) -> NDArray[np.float64]:
    """Origin (3,) of a scene with a world box (2, 3), in whole metres; 0 unless the box is finite and far from 0."""
    is_far = np.isfinite(bounds).all() and np.abs(bounds).max() >= ORIGIN_LIMIT
    return np.rint(bounds.mean(axis=0)) if is_far else np.zeros(3)


def touching(boxes: NDArray[np.float64], box: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Mask (N,) of the boxes (N, 2, 3) that touch a box (2, 3), borders included."""
    return np.asarray(((boxes[:, 0] <= box[1]) & (boxes[:, 1] >= box[0])).all(axis=1))


def positions_of(name: str, value: ArrayLike, *, copy: bool = False) -> tuple[NDArray[np.float32], NDArray[np.float64]]:
    """Convert vertices to C-contiguous float32 relative to a base in whole metres; return both.

    Float32 is kept bit for bit, with base 0; a C-contiguous array is borrowed unless `copy`. Float64 beyond 32,768 m is
    stored relative to the centre of its box, so that no digits are lost. ValueError for finite coordinates beyond
    `check.FARTHEST`; kernels refuse NaN and infinities.
    """
    array = check.array(name, value)
    base = np.zeros(3)
    if array.dtype == np.float32:
        return _copy_if_shared(array, value, copy), base
    if ORIGIN_LIMIT <= abs(_farthest(array)) < np.inf:
        low, high = array.min(axis=0), array.max(axis=0)
        if np.isfinite(low).all() and np.isfinite(high).all():
            base = np.rint(low / 2 + high / 2)
    local = np.empty(array.shape, np.float32)
    with np.errstate(over="ignore", invalid="ignore"):
        np.subtract(array, base, out=local, casting="same_kind", dtype=np.float64)
    return local, base


def _farthest(array: NDArray[Any]) -> float:
    """Return the coordinate that is farthest from 0, or NaN; ValueError if it is finite and beyond `check.FARTHEST`."""
    # Extremes of the whole array take a tenth of the time of column-wise ones.
    farthest = max(float(array.min()), float(array.max()), key=abs) if len(array) else 0.0
    if check.FARTHEST < abs(farthest) < np.inf:
        raise ValueError(f"vertices: expected coordinates within ±{check.FARTHEST:g} m, got {farthest:g} m")
    return farthest


def faces_of(name: str, value: ArrayLike, *, copy: bool = False) -> NDArray[np.uint32]:
    """Convert triangles to C-contiguous uint32; an array that is already one is borrowed unless `copy`."""
    return _copy_if_shared(check.array(name, value, dtype=np.uint32), value, copy)


def numbers_of(name: str, value: ArrayLike, count: int, limit: int, *, copy: bool = False) -> NDArray[np.int32]:
    """Check numbers of `count` faces, from -1 (none) to `limit` - 1, and convert them to C-contiguous int32."""
    array = check.array(name, value, columns=None, dtype=np.int32)
    if array.shape != (count,):
        raise ValueError(f"{name}: expected one number for each of {count} faces, got shape {array.shape}")
    if array.size:
        low, high = int(array.min()), int(array.max())
        if low < -1 or high >= limit:
            raise ValueError(f"{name}: expected numbers from -1 to {limit - 1}, got {low} to {high}")
    return _copy_if_shared(array, value, copy)


def normals_of(name: str, value: ArrayLike, vertex_count: int, *, copy: bool = False) -> NDArray[np.float32]:
    """Convert vertex normals to C-contiguous float32 of unit length; rows of zeros stand for no normal.

    Unit normals in C-contiguous float32 are borrowed unless `copy`; others are normalised in a copy.
    """
    array = check.array(name, value)
    if len(array) != vertex_count:
        raise ValueError(f"{name}: expected shape ({vertex_count}, 3), one row for each vertex, got {array.shape}")
    # The kernel rejects normals that are not finite.
    with np.errstate(over="ignore", invalid="ignore"):
        unit = np.abs(np.einsum("ij,ij->i", array, array) - 1.0) <= _UNIT
        if not unit.all() and not (unit | (array == 0).all(axis=1)).all():
            array = _unit(array.astype(np.float64))
    return _copy_if_shared(np.require(array, np.float32, ["C_CONTIGUOUS", "ALIGNED"]), value, copy)


def _unit(rows: NDArray[np.float64]) -> NDArray[np.float64]:
    """Normalise rows to unit length; rows of length 0 stay zero."""
    size = np.abs(rows).max(axis=1, keepdims=True)
    scaled = np.divide(rows, size, out=np.zeros_like(rows), where=size != 0)
    length = np.linalg.norm(scaled, axis=1, keepdims=True)
    return np.asarray(np.divide(scaled, length, out=scaled, where=length != 0))


def colors_of(name: str, value: ArrayLike, vertex_count: int) -> NDArray[np.uint8]:
    """Check sRGB colours with linear alpha and return C-contiguous uint8 (V, 4); three channels become opaque."""
    array = check.plain(name, value)
    if array.dtype != np.uint8:
        raise TypeError(f"{name}: expected uint8 sRGB colours, got {array.dtype}")
    if array.shape not in {(vertex_count, 3), (vertex_count, 4)}:
        raise ValueError(f"{name}: expected shape ({vertex_count}, 3) or ({vertex_count}, 4), got {array.shape}")
    if array.shape[1] == 3:
        array = np.concatenate([array, np.full((vertex_count, 1), 255, np.uint8)], axis=1)
    return np.require(array, np.uint8, ["C_CONTIGUOUS", "ALIGNED"])


def texture_of(name: str, value: ArrayLike) -> NDArray[np.uint8]:
    """Check an sRGB image with linear alpha (H, W, 4), row 0 on top, and return it as C-contiguous uint8."""
    array = check.plain(name, value)
    if array.dtype != np.uint8 or array.ndim != 3 or array.shape[2] != 4 or 0 in array.shape:
        raise ValueError(f"{name}: expected a uint8 image (H, W, 4), got {array.dtype} {array.shape}")
    return np.require(array, np.uint8, ["C_CONTIGUOUS", "ALIGNED"])


def transforms_of(name: str, value: ArrayLike) -> NDArray[np.float64]:
    """Check matrices object→world, (K, 4, 4) or (4, 4), finite with last row 0 0 0 1, and return them as float64."""
    array: NDArray[np.float64] = check.array(name, value, columns=None, dtype=np.float64, finite=True)
    if array.ndim not in (2, 3) or array.shape[-2:] != (4, 4):
        raise ValueError(f"{name}: expected a 4x4 matrix object→world, got shape {array.shape}")
    if array.size and np.abs(array).max() > check.FARTHEST:
        raise ValueError(f"{name}: expected a matrix of numbers up to {check.FARTHEST:g}, got {np.abs(array).max():g}")
    if not (array[..., 3, :] == (0, 0, 0, 1)).all():
        raise ValueError(f"{name}: expected an affine matrix with last row 0 0 0 1 (column vectors), got another row")
    return array


def _copy_if_shared(array: NDArray[Any], source: ArrayLike, copy: bool) -> NDArray[Any]:
    """Copy an array if `copy` is set and it shares memory with `source`."""
    return array.copy() if copy and isinstance(source, np.ndarray) and np.may_share_memory(array, source) else array


def triangle_mask(triangles: NDArray[Any], count: int) -> NDArray[np.bool_]:
    """Convert triangle numbers, or a mask, to a mask (count,) of bool."""
    if triangles.dtype == bool:
        if triangles.shape != (count,):
            raise ValueError(f"triangles: expected a mask of shape ({count},), got {triangles.shape}")
        return np.ascontiguousarray(triangles)
    if triangles.size and (triangles.dtype.kind not in "iu" or triangles.ndim != 1):
        raise TypeError(f"triangles: expected a list of numbers or a mask, got {triangles.dtype} {triangles.shape}")
    if triangles.size and (int(triangles.min()) < 0 or int(triangles.max()) >= count):
        raise ValueError(
            f"triangles: expected numbers from 0 to {count - 1}, got {triangles.min()} to {triangles.max()}"
        )
    mask = np.zeros(count, bool)
    mask[triangles.astype(np.int64)] = True
    return mask
