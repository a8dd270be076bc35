"""Look-up in cube maps along directions and within cones, mip chains, and solid angles of texels."""

from __future__ import annotations

import math
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check

Filter = Literal["nearest", "linear", "cubic", "min", "max"]
"""Name of a filter that `cube_lookup` describes."""
FILTERS: tuple[Filter, ...] = get_args(Filter)

MipFilter = Literal["mean", "min", "max"]
"""Name of a filter of `cube_mips`."""

BITS = {1: np.uint8, 2: np.uint16, 4: np.uint32, 8: np.uint64}
"""Unsigned type by size in bytes, in which "nearest" copies numbers of any type."""

LIMIT = 16384
"""Maximum number of texels across a face."""


def cube_lookup(
    faces: ArrayLike,
    directions: ArrayLike,
    *,
    filter: Filter = "nearest",  # noqa: A002
    radius: float | None = None,
) -> NDArray[Any]:
    """Look up values of a cube map along directions.

    ValueError for wrong shapes, unknown filters, directions that are zero or not finite, a radius out of range, and a
    radius with a filter that has none; TypeError for values that are not numbers. Source: Keys (1981), "Cubic
    convolution interpolation for digital image processing", Eq. 4.

    Parameters
    ----------
    faces
        (6, S, S) or (6, S, S, C), faces +x −x +y −y +z −z in the Vulkan/WebGPU orientation, below. float32 and float64
        are kept, float16 and longdouble become float64. Integers and booleans can only be looked up with "nearest" and
        keep their type, in native byte order.

        ==== ========= ========
        face right (u) down (v)
        ==== ========= ========
        +x   −z        −y
        −x   +z        −y
        +y   +x        +z
        −y   +x        −z
        +z   +x        −y
        −z   −x        −y
        ==== ========= ========

        In a right-handed frame, such as glTF's, each face of this layout is mirrored when seen from inside.
    directions
        (..., 3), of any length; float32 and float64 are read without conversion.
    filter
        "nearest": the texel that the direction passes through. "linear": bilinear and seamless, as accurate across
        edges and corners as inside a face. "cubic": bicubic (Keys, a = −1/2, exact for polynomials of the second order
        in a face's coordinates) and seamless, with an error of the third order everywhere; it overshoots at steps and
        is meaningless near infinite values. "min", "max": the least and greatest of the texels that "linear" would mix
        with weights above 1e-10 (smaller weights may be rounding errors). They are for ranges, which must not be
        averaged across a silhouette. They skip NaN, which marks unknown values; the result is NaN if all are NaN.
    radius
        For "min" and "max": half-angle of a cone about the direction in radians, at least 0 and below π/2. Instead of
        four texels, all texels that the cone touches are searched. Texels outside the cone may be included, too, if
        they are within 4e-15 / sin(2 radius), at most 6.4e-8, radians of it.

    Returns
    -------
    NDArray
        (...) or (..., C), in the type of `faces`, computed in float64. If "linear" mixes an infinite value, the result
        is infinite.
    """
    check.choice("filter", filter, FILTERS)
    angle = None if radius is None else _angle(radius, filter)
    maps = numbers_of("faces", faces)
    texels = channel_rows(maps)
    rows, shape = directions_of(directions)
    if maps.dtype.kind in "iub" and filter != "nearest":
        raise ValueError(f"filter: expected 'nearest' for faces of type {maps.dtype}, got {filter!r}")
    values: NDArray[Any] = np.empty((len(rows), texels.shape[3]), maps.dtype)
    if filter == "nearest":
        bits = BITS[maps.itemsize]
        _core.cube_nearest((texels.view(bits), values.view(bits)), rows)
    else:
        _core.cube_lookup((texels, values), rows, filter, angle)
    return values.reshape(shape + maps.shape[3:])


def cube_mips(faces: ArrayLike, *, filter: MipFilter = "mean") -> list[NDArray[Any]]:  # noqa: A002
    """Compute the mip levels of a cube map, each half the size of the previous one, down to one texel per face.

    ValueError for wrong shapes and unknown filters; TypeError for values that are not numbers.

    Parameters
    ----------
    faces
        (6, S, S) or (6, S, S, C), as in `cube_lookup`. float32 and float64 are kept; other numbers and booleans (as 0
        and 1) become float64.
    filter
        "mean": texels weighted by the covered solid angle, so that the mean over the sphere does not change. "min",
        "max": the least and greatest of all covered texels, for ranges; they skip NaN as in `cube_lookup`.

    Returns
    -------
    list of NDArray
        `faces` first (not a copy, unless it was converted), then size max(1, S // 2) and so on. If a size is odd, a
        texel of the next level covers parts of 3 × 3 texels. `cube_lookup` looks up every level seamlessly.
    """
    check.choice("filter", filter, get_args(MipFilter))
    texels = check.plain("faces", faces)
    texels = texels.astype(np.float64) if texels.dtype.kind == "b" else texels
    levels = [check.array("faces", texels, columns=None)]
    channel_rows(levels[0])
    while (size := levels[-1].shape[1] // 2) > 0:
        finer, coarser = levels[-1], np.empty((6, size, size, *levels[-1].shape[3:]), levels[-1].dtype)
        _core.cube_next_level((channel_rows(finer), channel_rows(coarser)), filter)
        levels.append(coarser)
    return levels


def cube_solid_angles(size: int) -> NDArray[np.float64]:
    """Compute the solid angles of the texels of a face, which are the same for all six faces.

    Returns (S, S) float64 steradians with a relative error of at most 2e-15; they add up to 4π/6. ValueError and
    TypeError for sizes out of range. Source: van Oosterom and Strackee (1983), "The solid angle of a plane triangle",
    Eq. 8, for the two halves of a texel.

    Parameters
    ----------
    size
        Number S of texels across a face, 1 to 16,384.
    """
    size = check.integer("size", size, 1, LIMIT)
    angles = np.empty((size, size))
    _core.cube_solid_angles(angles)
    return angles


def directions_of(directions: ArrayLike) -> tuple[NDArray[Any], tuple[int, ...]]:
    """Check directions (..., 3); returns them as rows (N, 3), and the shape (...)."""
    vectors = check.array("directions", directions, columns=None)
    if vectors.ndim == 0 or vectors.shape[-1] != 3:
        raise ValueError(f"directions: expected shape (..., 3), got {vectors.shape}")
    return vectors.reshape(-1, 3), vectors.shape[:-1]


def numbers_of(name: str, values: ArrayLike) -> NDArray[Any]:
    """Convert floats to float32 or float64; keep integers and booleans, in native byte order."""
    array = check.plain(name, values)
    if array.dtype.kind not in "iub":
        return check.array(name, array, columns=None)
    return array.astype(array.dtype.newbyteorder("="), copy=False)


def channel_rows(faces: NDArray[Any]) -> NDArray[Any]:
    """Return faces as (6, S, S, C) for kernels, C = 1 if they have no axis of channels; ValueError for other shapes."""
    if faces.ndim not in (3, 4) or faces.shape[0] != 6 or faces.shape[1] != faces.shape[2] or faces.shape[1] == 0:
        raise ValueError(f"faces: expected shape (6, S, S) or (6, S, S, C), got {faces.shape}")
    return np.require(faces if faces.ndim == 4 else faces[..., None], None, ["C", "A"])


def _angle(radius: float, filter_name: str) -> float:
    if filter_name not in ("min", "max"):
        raise ValueError(f"radius: expected None with filter {filter_name!r}, got {check.value_or_type(radius)}")
    angle = check.number("radius", radius)
    if not 0.0 <= angle < math.pi / 2:
        raise ValueError(f"radius: expected radians of at least 0 and below π/2, got {angle}")
    return angle
