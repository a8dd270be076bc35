"""Depth buffers: distances from the eye out of them and back, and what their rounding costs."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._camera.camera import CubeFace, Orthographic, Projection

CLIP_SPACES = ("0..1", "-1..1")
STORED = ("float32", "float64", "uint16", "uint32")
FORMATS = ("float32", "uint16", "uint24")


def range_from_depth(
    depth: ArrayLike,
    projection: Projection | ArrayLike,
    *,
    near: float | None = None,
    far: float = math.inf,
    reverse: bool | None = None,
    depth_range: str | None = None,
) -> NDArray[Any]:
    """Distance from the eye to what each pixel of a depth buffer shows.

    Parameters
    ----------
    depth
        (H, W), or (N, H, W) for several images of one projection, such as the (6, S, S) faces of a cube map: values
        as buffers store them, row 0 on top: float32 and float64 from 0 to 1; uint16; uint32 of up to 24 bits.
    projection
        `Fov`, `Orthographic`, any `CubeFace` (square images; they are all alike), or a (4, 4) projection matrix for
        columns (x, y, z, 1), with a last row of (0, 0, ∓1, 0), or (0, 0, 0, 1) for parallel rays. Off the axis or
        not, looking along −z or z; its y points up, as in OpenGL, Direct3D and WebGPU: negate row 1 of Vulkan's.
    near, far
        Planes in metres along the viewing axis, 0 < near < far; parallel rays may have near = 0 and need a finite far
        plane. A matrix says these itself: they are not given beside one.
    reverse
        Whether the near plane has depth 1 and the far one 0, as on our GPU, which is what None stands for, or the
        other way round. A matrix says this itself: None beside one.
    depth_range
        Beside a matrix, which does not say it, and only there: the depth that it maps to, "0..1" for Direct3D's,
        Vulkan's and WebGPU's, or "-1..1" for OpenGL's, which buffers store as 0 to 1.

    Returns
    -------
    NDArray
        Metres in the shape of `depth`, float32, or float64 for float64: along the pixel's ray for parallel rays. +inf
        where the buffer has its clear value, that of the far plane: nothing was drawn there. Computed in float64:
        within 16 roundings (2⁻⁵³) and that to the result's type of what the stored value stands for. What storing
        the value has cost is `range_error`.

    Raises
    ------
    ValueError
        For values that are NaN or beyond 0 to 1 (the first one is named), other shapes, planes out of order, and
        matrices that are no such projection; for options that the projection has no use for, and a matrix without
        `depth_range`.
    TypeError
        For depth of other types, which does not say what stands for 1.
    """
    given = check.plain("depth", depth)
    # By name, which is the same for any order of bytes.
    if given.dtype.name not in STORED:
        raise TypeError(f"depth: expected {', '.join(STORED[:-1])} or {STORED[-1]}, got {given.dtype}")
    images, shape = _images("depth", given, given.dtype.newbyteorder("="))
    buffer = _buffer(images.shape, projection, near, far, reverse, depth_range)
    found: NDArray[Any] = buffer.ranges(images)
    return found.reshape(shape)


def depth_from_range(
    ranges: ArrayLike,
    projection: Projection | ArrayLike,
    *,
    near: float | None = None,
    far: float = math.inf,
    reverse: bool | None = None,
    depth_range: str | None = None,
) -> NDArray[Any]:
    """What a depth buffer holds for distances from the eye: the inverse of `range_from_depth`.

    It puts pictures with range, such as those of `render`, beside what a GPU draws.

    Parameters
    ----------
    ranges
        (H, W) or (N, H, W) distances from the eye in metres, +inf for nothing. float32 and float64; other numbers
        become float64.
    projection, near, far, reverse, depth_range
        As in `range_from_depth`.

    Returns
    -------
    NDArray
        0 to 1 in the shape and type of `ranges`. The clear value for +inf and from the far plane on, and where a
        depth that is not reversed rounds to it.

    Raises
    ------
    ValueError
        As in `range_from_depth`; for NaN, negative distances, and places before the near plane (by more than the
        rounding of the range).
    TypeError
        For values that are not numbers.
    """
    images, shape = _images("ranges", ranges, None)
    buffer = _buffer(images.shape, projection, near, far, reverse, depth_range)
    found: NDArray[Any] = buffer.depths(images)
    return found.reshape(shape)


def range_error(
    distance: ArrayLike, *, near: float, far: float = math.inf, reverse: bool = True, depth_format: str = "float32"
) -> NDArray[np.float64]:
    """By how much a range from a depth buffer may be wrong because the buffer rounds.

    Parameters
    ----------
    distance
        Distances z along the viewing axis in metres, any shape, from near to far. Off the axis, by the angle θ, a
        range r has z = r cos θ, and its error is that of z over cos θ: the same share.
    near, far, reverse
        As in `range_from_depth`, for a perspective view.
    depth_format
        What stores depth: "float32", or "uint16" and "uint24" for 16 and 24 bits.

    Returns
    -------
    NDArray
        Metres, float64, in the shape of `distance`: no less than the error of `range_from_depth` for a depth that was
        computed exactly and rounded once to the nearest value, and within twice its greatest near that distance. +inf
        where the depth may be stored as the far plane's, which stands for nothing. A GPU interpolates depth with
        errors of its own.

    Raises
    ------
    ValueError, TypeError
        For distances that are not within near and far, planes out of order, and other formats.

    Notes
    -----
    1/z is linear in depth t with the slope s = ±(1/near − 1/far). Half a step h of the format at t moves 1/z by h |s|,
    so z by z x/(1 − x) with x = h |s| z, and storing the range as float32 costs 2⁻²⁴ of it. With far at infinity:

    - float32, reversed: t = near/z and h ≤ 2⁻²⁴ t, so x ≤ 2⁻²⁴ anywhere: 6e-8 of z, as good as float32 itself.
    - float32, standard: t → 1 and h = 2⁻²⁵: x = 2⁻²⁵ z/near grows with the distance; from z = 2²⁵ near on, all is lost.
    - b bits: h = 2⁻ᵇ/2: x = 2⁻⁽ᵇ⁺¹⁾ z/near, reversed or not.
    """
    given = check.array("distance", distance, columns=None, dtype=np.float64, finite=True)
    nearest, farthest = _planes(near, far)
    check.choice("depth_format", depth_format, FORMATS)
    if given.size and (given.min() < nearest or given.max() > farthest):
        got = f"{given.min():g} to {given.max():g}"
        raise ValueError(f"distance: expected {nearest:g} to {farthest:g} metres, from near to far, got {got}")
    slope = 1.0 / nearest - 1.0 / farthest
    share = (1.0 / given - 1.0 / farthest) / slope
    stored = share if reverse else 1.0 - share
    half = _half_step(stored, depth_format)
    moved = half * slope * given
    with np.errstate(divide="ignore", invalid="ignore"):
        error = np.where(moved < 1.0, given * moved / (1.0 - moved), np.inf)
    # Nothing is told from the far plane's value within half a step of it.
    error = np.where(share <= half, np.inf, error)
    # The range is stored, and computed in float64: 32 roundings of either, generously.
    return np.asarray(error + (given + error) * (2.0**-24 + 2.0**-48))


def _half_step(stored: NDArray[np.float64], depth_format: str) -> NDArray[np.float64]:
    """Half of the distance between values of a format about exact ones, and a little for their own rounding."""
    if depth_format != "float32":
        bits = int(depth_format.removeprefix("uint"))
        return np.full_like(stored, 0.5 / (2.0**bits - 1.0) + 2.0**-52)
    _, exponents = np.frexp(stored * (1.0 + 2.0**-50))
    # A number in [2ᵉ⁻¹, 2ᵉ) has steps of 2ᵉ⁻²⁴; below 2⁻¹²⁶ they stay as they are.
    return np.asarray(np.ldexp(1.0, np.maximum(exponents, -125) - 25) + 2.0**-52 * np.minimum(stored, 1.0))


def _images(name: str, values: ArrayLike, dtype: DTypeLike | None) -> tuple[NDArray[Any], tuple[int, ...]]:
    """Values as (N, H, W) of a type that kernels read, and their shape."""
    images = check.array(name, values, columns=None, dtype=dtype)
    if images.ndim not in (2, 3) or not images.size:
        raise ValueError(f"{name}: expected shape (H, W) or (N, H, W), not empty, got {images.shape}")
    if max(images.shape[-2:]) > check.MAX_SIZE:
        raise ValueError(f"{name}: expected up to {check.MAX_SIZE} pixels each way, got {images.shape}")
    return images.reshape(-1, *images.shape[-2:]), images.shape


def _planes(near: float | None, far: float) -> tuple[float, float]:
    if near is None:
        raise ValueError("near: expected the near plane's distance in metres, got None")
    return check.positive("near", near), _above("far", far, near)


def _above(name: str, value: float, least: float) -> float:
    number = check.number(name, value, finite=False)
    if not number > least:
        raise ValueError(f"{name}: expected a number above near = {least:g}, got {number}")
    return number


def _buffer(
    shape: tuple[int, ...],
    projection: Projection | ArrayLike,
    near: float | None,
    far: float,
    reverse: bool | None,
    depth_range: str | None,
) -> _core.DepthBuffer:
    height, width = shape[-2:]
    if not isinstance(projection, Projection):
        rows = check.array("projection", projection, columns=None, dtype=np.float64)
        return _matrix_buffer((width, height), rows, near, far, reverse, depth_range)
    if depth_range is not None:
        raise ValueError(f"depth_range: expected None beside {type(projection).__name__}, got {depth_range!r}")
    if isinstance(projection, CubeFace) and width != height:
        raise ValueError(f"depth: expected square images for cube faces, got {width} x {height}")
    parallel = isinstance(projection, Orthographic)
    kind = "cube" if isinstance(projection, CubeFace) else "orthographic" if parallel else "perspective"
    nearest, farthest = (_parallel_planes if parallel else _planes)(near, far)
    options: dict[str, Any] = {"kind": kind, "near": nearest, "far": farthest}
    if not isinstance(projection, CubeFace):
        options["bounds"] = (projection.left, projection.right, projection.down, projection.up)
    return _core.DepthBuffer((width, height), reverse=reverse is None or bool(reverse), **options)


def _matrix_buffer(
    size: tuple[int, int],
    rows: NDArray[np.float64],
    near: float | None,
    far: float,
    reverse: bool | None,
    depth_range: str | None,
) -> _core.DepthBuffer:
    if rows.shape != (4, 4):
        raise ValueError(f"projection: expected a (4, 4) matrix, got shape {rows.shape}")
    if near is not None or far != math.inf:
        raise ValueError("near: expected None beside a matrix, which has its own planes")
    if reverse is not None:
        raise ValueError(f"reverse: expected None beside a matrix, which says it itself, got {reverse!r}")
    if depth_range is None:
        raise ValueError(
            "depth_range: expected '0..1' or '-1..1' (OpenGL's) beside a matrix, which does not say it, got None"
        )
    low = -float(CLIP_SPACES.index(check.choice("depth_range", depth_range, CLIP_SPACES)))
    return _core.DepthBuffer.from_matrix(size, rows.tolist(), low)


def _parallel_planes(near: float | None, far: float) -> tuple[float, float]:
    if near is None or not math.isfinite(check.number("far", far, finite=False)):
        raise ValueError(f"far: expected finite near and far planes for parallel rays, got {near} and {far}")
    nearest = check.number("near", near)
    if nearest < 0.0:
        raise ValueError(f"near: expected a number of at least 0, got {nearest}")
    return nearest, _above("far", far, nearest)
