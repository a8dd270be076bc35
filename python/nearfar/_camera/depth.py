"""Conversion between depth buffers and distances from the eye, and the error that rounding of depth causes."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._camera.camera import CubeFace, Orthographic, Projection

CLIP_SPACES = ("0..1", "-1..1")
"""Depth ranges of clip space: the first of Direct3D, Vulkan and WebGPU, the second of OpenGL."""
DEPTH_TYPES = ("float32", "float64", "uint16", "uint32")
"""NumPy types of depth that `range_from_depth` accepts."""
GPU_FORMATS = ("float32", "uint16", "uint24")
"""Depth formats of GPUs that `range_error` accepts."""


def range_from_depth(
    depth: ArrayLike,
    projection: Projection | ArrayLike,
    *,
    near: float | None = None,
    far: float = math.inf,
    reverse: bool | None = None,
    depth_range: str | None = None,
) -> NDArray[Any]:
    """Convert a depth buffer to distances from the eye.

    ValueError for values that are NaN or outside 0 to 1 (the message names the first one), wrong shapes, planes out of
    order, matrices that are not projections as described below, a matrix without `depth_range`, and options that do not
    apply to the projection; TypeError for depth of other types, because it is unknown which value stands for depth 1.

    Parameters
    ----------
    depth
        (H, W), or (N, H, W) for several images of one projection, such as the (6, S, S) faces of a cube map: values
        as buffers store them, row 0 on top. float32 and float64 from 0 to 1; uint16; uint32 with up to 24 bits.
    projection
        `Fov`, `Orthographic`, any `CubeFace` (square images; all faces give the same result), or a (4, 4) projection
        matrix for column vectors (x, y, z, 1). The matrix has the last row (0, 0, ∓1, 0), or (0, 0, 0, 1) for parallel
        rays. It may be off-axis and look along −z or z. Its y points up, as in OpenGL, Direct3D and WebGPU; for Vulkan
        negate row 1.
    near, far
        Distances of the planes in metres along the viewing axis, 0 < near < far. Parallel rays may have near = 0 and
        need a finite far plane. A matrix contains the planes, so both must stay unset with it.
    reverse
        True: the near plane has depth 1 and the far plane 0. False: the other way round. None means True, as in
        nearfar's GPU back end. A matrix determines this, so only None is allowed with it.
    depth_range
        Depth range of a matrix, required with a matrix and refused otherwise: "0..1" (Direct3D, Vulkan, WebGPU) or
        "-1..1" (OpenGL, whose buffers store it as 0 to 1).

    Returns
    -------
    NDArray
        Distance from the eye in metres, for parallel rays the distance along the pixel's ray, in the shape of `depth`;
        float64 for float64, else float32. +inf where the buffer has its clear value, the depth of the far plane:
        nothing was drawn there. Computed in float64: the error relative to the stored value is at most 16 roundings of
        2⁻⁵³, plus the rounding to the result's type. `range_error` bounds the error that storing depth has caused.
    """
    values = check.plain("depth", depth)
    # The name does not depend on the byte order.
    if values.dtype.name not in DEPTH_TYPES:
        raise TypeError(f"depth: expected {', '.join(DEPTH_TYPES[:-1])} or {DEPTH_TYPES[-1]}, got {values.dtype}")
    images, shape = _images("depth", values, values.dtype.newbyteorder("="))
    return _depth_buffer(images.shape, projection, near, far, reverse, depth_range).ranges(images).reshape(shape)


def depth_from_range(
    ranges: ArrayLike,
    projection: Projection | ArrayLike,
    *,
    near: float | None = None,
    far: float = math.inf,
    reverse: bool | None = None,
    depth_range: str | None = None,
) -> NDArray[Any]:
    """Convert distances from the eye to depth: the inverse of `range_from_depth`.

    So pictures with range, such as those of `render`, can be combined with a GPU's depth buffer. ValueError as in
    `range_from_depth`, and for NaN, negative distances, and points nearer than the near plane by more than the rounding
    of the range; TypeError for values that are not numbers.

    Parameters
    ----------
    ranges
        (H, W) or (N, H, W) distances from the eye in metres, +inf where nothing was drawn. float32 and float64 are
        kept, other numbers become float64.
    projection, near, far, reverse, depth_range
        As in `range_from_depth`.

    Returns
    -------
    NDArray
        Depth, 0 to 1, in the shape and type of `ranges`. +inf and distances from the far plane on give the clear value.
        If depth is not reversed, smaller distances whose depth rounds to the clear value give it, too.
    """
    images, shape = _images("ranges", ranges, None)
    return _depth_buffer(images.shape, projection, near, far, reverse, depth_range).depths(images).reshape(shape)


def range_error(
    distance: ArrayLike, *, near: float, far: float = math.inf, reverse: bool = True, depth_format: str = "float32"
) -> NDArray[np.float64]:
    """Bound the error of a range that was computed from a rounded depth value.

    ValueError and TypeError for distances outside near to far, planes out of order, and unknown formats.

    Parameters
    ----------
    distance
        Distances z along the viewing axis in metres, any shape, from near to far. A range r at the angle θ off the axis
        has z = r cos θ, and its error is the error of z divided by cos θ, so both have the same relative error.
    near, far, reverse
        As in `range_from_depth`, for a perspective view.
    depth_format
        Format of the depth buffer: "float32", or "uint16" and "uint24" for 16 and 24 bits.

    Returns
    -------
    NDArray
        Metres, float64, in the shape of `distance`: an upper bound of the error of `range_from_depth` for a depth that
        was computed exactly and rounded once to the nearest value, at most twice the greatest error near that distance.
        +inf where the depth may round to the far plane's value, which means that nothing was drawn. Errors of a GPU's
        interpolation of depth are not included.

    Notes
    -----
    1/z is linear in depth t with the slope s = ±(1/near − 1/far). Half a step h of the format at t changes 1/z by
    h |s|, hence z by z x/(1 − x), where x = h |s| z. Storing the range as float32 adds 2⁻²⁴ of it. If far is infinite:

    - float32, reversed: t = near/z and h ≤ 2⁻²⁴ t, so x ≤ 2⁻²⁴ everywhere: 6e-8 of z, the precision of float32 itself.
    - float32, standard: t → 1 and h = 2⁻²⁵, so x = 2⁻²⁵ z/near grows with z; the error is unbounded for z ≥ 2²⁵ near.
    - b bits: h = 2⁻ᵇ/2, so x = 2⁻⁽ᵇ⁺¹⁾ z/near, reversed or not.
    """
    distances = check.array("distance", distance, columns=None, dtype=np.float64, finite=True)
    nearest, farthest = _perspective_planes(near, far)
    check.choice("depth_format", depth_format, GPU_FORMATS)
    is_reversed = check.flag("reverse", reverse)
    if distances.size and (distances.min() < nearest or distances.max() > farthest):
        got = f"{distances.min():g} to {distances.max():g}"
        raise ValueError(f"distance: expected {nearest:g} to {farthest:g} metres, from near to far, got {got}")
    slope = 1.0 / nearest - 1.0 / farthest
    reversed_depth = (1.0 / distances - 1.0 / farthest) / slope
    depth = reversed_depth if is_reversed else 1.0 - reversed_depth
    half_step = _half_step(depth, depth_format)
    with np.errstate(divide="ignore", over="ignore", invalid="ignore"):
        relative_change = half_step * slope * distances
        error = np.where(relative_change < 1.0, distances * relative_change / (1.0 - relative_change), np.inf)
    # Depth within half a step of the far plane's value cannot be distinguished from it.
    error = np.where(reversed_depth <= half_step, np.inf, error)
    # 2⁻²⁴ for storing the range as float32, 2⁻⁴⁸ (32 roundings) for computing in float64.
    return np.asarray(error + (distances + error) * (2.0**-24 + 2.0**-48))


def _half_step(depth: NDArray[np.float64], depth_format: str) -> NDArray[np.float64]:
    """Return half the distance between neighbouring values of a format, plus a margin for the rounding of `depth`."""
    if depth_format != "float32":
        bits = int(depth_format.removeprefix("uint"))
        return np.full_like(depth, 0.5 / (2.0**bits - 1.0) + 2.0**-52)
    _, exponents = np.frexp(depth * (1.0 + 2.0**-50))
    # Float32 numbers in [2ᵉ⁻¹, 2ᵉ) have steps of 2ᵉ⁻²⁴; below 2⁻¹²⁶ the step is constant.
    return np.asarray(np.ldexp(1.0, np.maximum(exponents, -125) - 25) + 2.0**-52 * np.minimum(depth, 1.0))


def _images(name: str, values: ArrayLike, dtype: DTypeLike | None) -> tuple[NDArray[Any], tuple[int, ...]]:
    """Reshape values to (N, H, W) in a type that kernels accept; return them and their original shape."""
    images = check.array(name, values, columns=None, dtype=dtype)
    if images.ndim not in (2, 3) or not images.size:
        raise ValueError(f"{name}: expected shape (H, W) or (N, H, W), not empty, got {images.shape}")
    if max(images.shape[-2:]) > check.MAX_SIZE:
        raise ValueError(f"{name}: expected up to {check.MAX_SIZE} pixels each way, got {images.shape}")
    return images.reshape(-1, *images.shape[-2:]), images.shape


def _perspective_planes(near: float | None, far: float) -> tuple[float, float]:
    if near is None:
        raise ValueError("near: expected the near plane's distance in metres, got None")
    return check.positive("near", near), _number_above("far", far, near)


def _number_above(name: str, value: float, lower_bound: float) -> float:
    number = check.number(name, value, finite=False)
    if not number > lower_bound:
        raise ValueError(f"{name}: expected a number above near = {lower_bound:g}, got {number}")
    return number


def _depth_buffer(
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
        if rows.shape != (4, 4):
            raise ValueError(f"projection: expected a (4, 4) matrix, got shape {rows.shape}")
        if near is not None:
            raise ValueError("near: expected None beside a matrix, which has its own planes")
        if check.number("far", far, finite=False) != math.inf:
            raise ValueError("far: expected none beside a matrix, which has its own planes")
        if reverse is not None:
            raise ValueError("reverse: expected None beside a matrix, which determines it")
        if depth_range is None:
            raise ValueError(
                "depth_range: expected '0..1' or '-1..1' (OpenGL's), which a matrix does not determine, got None"
            )
        lowest_depth = -float(CLIP_SPACES.index(check.choice("depth_range", depth_range, CLIP_SPACES)))
        return _core.DepthBuffer.from_matrix((width, height), rows.tolist(), lowest_depth)
    if depth_range is not None:
        raise ValueError(
            f"depth_range: expected None beside {type(projection).__name__}, got {check.value_or_type(depth_range)}"
        )
    if isinstance(projection, CubeFace) and width != height:
        raise ValueError(f"depth: expected square images for cube faces, got {width} x {height}")
    is_parallel = isinstance(projection, Orthographic)
    kind = "cube" if isinstance(projection, CubeFace) else "orthographic" if is_parallel else "perspective"
    nearest, farthest = (_parallel_planes if is_parallel else _perspective_planes)(near, far)
    options: dict[str, Any] = {"kind": kind, "near": nearest, "far": farthest}
    if not isinstance(projection, CubeFace):
        options["bounds"] = projection._sides
    is_reversed = reverse is None or check.flag("reverse", reverse)
    return _core.DepthBuffer((width, height), reverse=is_reversed, **options)


def _parallel_planes(near: float | None, far: float) -> tuple[float, float]:
    farthest = check.number("far", far, finite=False)
    if near is None or not math.isfinite(farthest):
        got = f"{check.value_or_type(near)} and {farthest}"
        raise ValueError(f"far: expected finite near and far planes for parallel rays, got {got}")
    nearest = check.at_least_zero("near", near)
    return nearest, _number_above("far", far, nearest)
