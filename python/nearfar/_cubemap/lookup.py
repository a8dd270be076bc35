"""Cube maps: values along directions and within cones, mip chains, solid angles."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check

FILTERS = ("nearest", "linear", "cubic", "min", "max")

BITS = {1: np.uint8, 2: np.uint16, 4: np.uint32, 8: np.uint64}
"""Numbers that are copied, not computed with, by their bytes."""

LIMIT = 16384
"""Most texels across a face."""


def cube_lookup(
    faces: ArrayLike,
    directions: ArrayLike,
    *,
    filter: str = "nearest",  # noqa: A002
    radius: float | None = None,
) -> NDArray[Any]:
    """Values of a cube map along directions.

    Parameters
    ----------
    faces
        (6, S, S) or (6, S, S, C), faces +x −x +y −y +z −z in the Vulkan/WebGPU orientation, below. float32 and float64
        are kept, float16 and longdouble become float64; integers and booleans can only be looked up with "nearest" and
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

        In a right-handed frame, such as glTF's, each face so laid out is mirrored as one sees it from inside.
    directions
        (..., 3), of any length; float32 and float64 are read as they are.
    filter
        "nearest": the texel that the direction passes through. "linear": bilinear, seamless across edges and corners,
        whose error is as small there as inside a face. "cubic": bicubic (Keys' with a = −1/2, exact for polynomials
        of the second order in a face's coordinates), seamless too, with an error of the third order everywhere; it
        overshoots at steps, and near infinite values it means nothing. "min", "max": the least and greatest of the
        texels that "linear" would mix with weights above 1e-10 (those below may be rounding), for ranges, which must
        not be averaged across a silhouette; NaN are skipped, because they are unknown, and the result is NaN where
        all are NaN.
    radius
        With "min" and "max": radians, at least 0 and below π/2. Not the four texels, but all that the cone of
        this angle about the direction touches, exactly: none is left out, and none is taken that lies outside by more
        than 4e-15 / sin(2 radius), at most 6.4e-8 radians.

    Returns
    -------
    NDArray
        (...) or (..., C), in the type of `faces`, computed in float64. Where "linear" mixes an infinite value, the
        result is infinite.

    Raises
    ------
    ValueError
        For other shapes or filters, directions that are zero or not finite, a radius out of range or with a filter
        that has none.
    TypeError
        For values that are not numbers.

    References
    ----------
    Keys (1981), "Cubic convolution interpolation for digital image processing", Eq. 4.
    """
    check.choice("filter", filter, FILTERS)
    angle = None if radius is None else _radius(radius, filter)
    maps = _faces(faces)
    rows, shape = directions_of(directions)
    if maps.dtype.kind in "iub" and filter != "nearest":
        raise ValueError(f"filter: expected 'nearest' for faces of type {maps.dtype}, got {filter!r}")
    deep = _deep(maps)
    values: NDArray[Any] = np.empty((len(rows), deep.shape[3]), maps.dtype)
    if filter == "nearest":
        bits = BITS[maps.itemsize]
        _core.cube_nearest((deep.view(bits), values.view(bits)), rows)
    elif angle is not None:
        _core.cube_footprint((deep, values), rows, filter, angle)
    else:
        _core.cube_lookup((deep, values), rows, filter)
    return values.reshape(shape + maps.shape[3:])


def cube_mips(faces: ArrayLike, *, filter: str = "mean") -> list[NDArray[Any]]:  # noqa: A002
    """Levels of a cube map, each half the size of the one before, down to one texel a face.

    Parameters
    ----------
    faces
        (6, S, S) or (6, S, S, C), as in `cube_lookup`. float32 and float64 are kept, other numbers become float64, and
        so do booleans, 0 and 1.
    filter
        "mean": texels weighed by the solid angle that is covered, so that the mean over the sphere stays what it was.
        "min", "max": the least and greatest of all texels covered, for ranges; NaN are skipped as in `cube_lookup`.

    Returns
    -------
    list of NDArray
        `faces` first (the array itself, not a copy, where nothing had to be converted), then sizes max(1, S // 2) and
        so on. Where a size is odd, a texel covers parts of 3 × 3. All levels are looked up seamlessly by
        `cube_lookup`.

    Raises
    ------
    ValueError
        For other shapes or filters.
    TypeError
        For values that are not numbers.
    """
    check.choice("filter", filter, ("mean", "min", "max"))
    given = check.plain("faces", faces)
    given = given.astype(np.float64) if given.dtype.kind == "b" else given
    levels = [_faces(check.array("faces", given, columns=None))]
    while levels[-1].shape[1] > 1:
        above = levels[-1]
        size = above.shape[1] // 2
        levels.append(np.empty((6, size, size, *above.shape[3:]), above.dtype))
        _core.cube_next_level((_deep(above), _deep(levels[-1])), filter)
    return levels


def cube_solid_angles(size: int) -> NDArray[np.float64]:
    """Solid angles of the texels of a face; all six faces are alike.

    Parameters
    ----------
    size
        Texels across a face, 1 to 16,384.

    Returns
    -------
    NDArray
        (S, S) float64 steradians, each within 2e-15 of itself; they add up to 4π/6.

    Raises
    ------
    ValueError, TypeError
        For another size.

    References
    ----------
    van Oosterom and Strackee (1983), "The solid angle of a plane triangle", Eq. 8, for the two halves of a texel.
    """
    size = check.integer("size", size, 1, LIMIT)
    angles = np.empty((size, size))
    _core.cube_solid_angles(angles)
    return angles


def directions_of(directions: ArrayLike) -> tuple[NDArray[Any], tuple[int, ...]]:
    """Directions (..., 3) as rows, and the shape (...)."""
    along = check.array("directions", directions, columns=None)
    if along.ndim == 0 or along.shape[-1] != 3:
        raise ValueError(f"directions: expected shape (..., 3), got {along.shape}")
    return along.reshape(-1, 3), along.shape[:-1]


def numbers_of(name: str, values: ArrayLike) -> NDArray[Any]:
    """Floats as kernels take them, or integers and booleans as they are, in native byte order."""
    given = check.plain(name, values)
    if given.dtype.kind not in "iub":
        return check.array(name, given, columns=None)
    return given.astype(given.dtype.newbyteorder("="), copy=False)


def _radius(radius: float, chosen: str) -> float:
    if chosen not in ("min", "max"):
        raise ValueError(f"radius: expected None with filter {chosen!r}, got {radius}")
    if np.ndim(radius) > 0:
        raise TypeError(f"radius: expected a number, got {type(radius).__name__}")
    angle = check.number("radius", radius)
    if not 0.0 <= angle < math.pi / 2:
        raise ValueError(f"radius: expected radians of at least 0 and below π/2, got {angle}")
    return angle


def _deep(maps: NDArray[Any]) -> NDArray[Any]:
    """With channels, even if there is only one."""
    return np.require(maps if maps.ndim == 4 else maps[..., None], None, ["C", "A"])


def _faces(faces: ArrayLike) -> NDArray[Any]:
    given = numbers_of("faces", faces)
    if given.ndim not in (3, 4) or given.shape[0] != 6 or given.shape[1] != given.shape[2] or given.shape[1] == 0:
        raise ValueError(f"faces: expected shape (6, S, S) or (6, S, S, C), got {given.shape}")
    return given
