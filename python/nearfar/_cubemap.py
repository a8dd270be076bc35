"""Cube maps: values along directions."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _check, _core

FILTERS = ("nearest", "linear", "cubic", "min", "max")

BITS = {1: np.uint8, 2: np.uint16, 4: np.uint32, 8: np.uint64}
"""Numbers that are copied, not computed with, by their bytes."""


def cube_lookup(faces: ArrayLike, directions: ArrayLike, *, filter: str = "nearest") -> NDArray[Any]:  # noqa: A002
    """Values of a cube map along directions.

    Parameters
    ----------
    faces
        (6, S, S) or (6, S, S, C), faces +x −x +y −y +z −z in the Vulkan/WebGPU orientation. float32 and float64 are
        kept; integers can only be looked up with "nearest" and keep their type.
    directions
        (..., 3), of any length.
    filter
        "nearest": the texel that the direction passes through. "linear": bilinear, seamless across edges and corners,
        whose error is as small there as inside a face. "min", "max": the least and greatest of the texels that
        "linear" would mix, for ranges, which must not be averaged across a silhouette.

    Returns
    -------
    NDArray
        (...) or (..., C), in the type of `faces`. Where "linear" mixes an infinite value, the result is infinite.

    Raises
    ------
    ValueError
        For other shapes or filters, and for directions that are zero or not finite.
    TypeError
        For values that are not numbers.
    """
    _check.choice("filter", filter, FILTERS)
    maps = _faces(faces)
    along = _check.array("directions", directions, columns=None)
    if along.ndim == 0 or along.shape[-1] != 3:
        raise ValueError(f"directions: expected shape (..., 3), got {along.shape}")
    if maps.dtype.kind in "iub" and filter != "nearest":
        raise ValueError(f"filter: expected 'nearest' for faces of type {maps.dtype}, got {filter!r}")
    rows = along.reshape(-1, 3)
    deep = np.require(maps if maps.ndim == 4 else maps[..., None], None, ["C", "A"])
    values: NDArray[Any] = np.empty((len(rows), deep.shape[3]), maps.dtype)
    if filter == "nearest":
        bits = BITS[maps.itemsize]
        _core.cube_nearest((deep.view(bits), values.view(bits)), rows)
    else:
        _core.cube_lookup((deep, values), rows, filter)
    return values.reshape(along.shape[:-1] + maps.shape[3:])


def cube_directions(size: int) -> NDArray[np.float64]:
    """Directions (6, S, S, 3) of the texel centres of a cube map, not normalised: the longest component is ±1."""
    _check.integer("size", size, 1, 16384)
    return _core.cube_directions(size).reshape(6, size, size, 3)


def _faces(faces: ArrayLike) -> NDArray[Any]:
    given = np.asarray(faces)
    if given.dtype.kind not in "iub":
        given = _check.array("faces", given, columns=None)
    if given.ndim not in (3, 4) or given.shape[0] != 6 or given.shape[1] != given.shape[2] or given.shape[1] == 0:
        raise ValueError(f"faces: expected shape (6, S, S) or (6, S, S, C), got {given.shape}")
    return given
