"""Layouts of environment maps (cube, equirectangular, octahedral) and conversion between them."""

from __future__ import annotations

import math
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check, progress
from nearfar._cubemap.lookup import BITS, FILTERS, LIMIT, Filter, directions_of, numbers_of

Layout = Literal["cube", "equirectangular", "octahedral"]
"""Name of a layout that `convert_envmap` describes."""
LAYOUTS: tuple[Layout, ...] = get_args(Layout)


def convert_envmap(
    values: ArrayLike,
    *,
    source: Layout,
    target: Layout,
    size: int | tuple[int, int],
    filter: Filter = "linear",  # noqa: A002
    samples: int = 1,
) -> NDArray[Any]:
    """Convert an environment map to another layout.

    The result has the type of `values`; each look-up is rounded to it before the mean is taken in float64. ValueError
    for wrong shapes and sizes, and unknown layouts and filters; TypeError for values that are not numbers. Source:
    Cigolle et al. (2014), "A survey of efficient representations for independent unit vectors", for octahedra.

    Parameters
    ----------
    values
        Map in the layout `source`, with or without a last axis of channels; y is up. float32 and float64 are kept,
        float16 and longdouble become float64. Integers and booleans can only be converted with "nearest" and keep their
        type, in native byte order.

        - "cube": (6, S, S), faces +x −x +y −y +z −z as in the table of `cube_lookup`.
        - "equirectangular": (H, W), W even. Row 0 is next to +y. Columns follow longitude: the middle of the picture
          shows −z, and +x is to the right of it (seen from inside).
        - "octahedral": (S, S). The octahedron |x| + |y| + |z| = 1 seen from +y, x to the right and z down, the lower
          half folded outwards: −y lies at all four corners.
    source, target
        Names of the layouts.
    size
        Size of the result: S; for "equirectangular" (H, W), or H alone with W = 2 H.
    filter
        As in `cube_lookup`, applied in the source. It is continuous in every layout: equirectangular maps continue at
        the opposite edge, and beyond a pole at the opposite longitude; octahedral maps continue at the other half of
        each edge. In octahedral maps, doubling S halves the error at folds (the outer edges and the lines where a
        coordinate is 0) and quarters it elsewhere. For a smooth map with slopes of up to 5 per radian and S = 256, the
        error of "linear" is at most 0.011 within a texel of a fold, and 0.0006 beyond two texels. "min" and "max" skip
        NaN, in the source and among `samples`.
    samples
        For each texel n × n evenly spread directions are looked up and averaged (for "min" and "max" the least or
        greatest is taken), so that small results of large maps do not alias. n near the ratio of the two sizes
        suffices. Must be 1 with "nearest".
    """
    check.choice("source", source, LAYOUTS)
    check.choice("filter", filter, FILTERS)
    samples = check.integer("samples", samples, 1, 256)
    texels = numbers_of("values", values)
    from_shape, to_shape = _source_shape(texels, source), _shape("target", target, size)
    count = 3 if source == "cube" else 2
    if filter == "nearest" and samples > 1:
        raise ValueError(f"samples: expected 1 with filter 'nearest', got {samples}")
    if texels.dtype.kind in "iub" and filter != "nearest":
        raise ValueError(f"filter: expected 'nearest' for values of type {texels.dtype}, got {filter!r}")
    channels = math.prod(texels.shape[count:])
    rows = np.require(texels.reshape(math.prod(texels.shape[:count]), channels), None, ["C", "A"])
    out: NDArray[Any] = np.empty((*_array_shape(to_shape), *texels.shape[count:]), texels.dtype)
    out_rows = out.reshape(math.prod(_array_shape(to_shape)), channels)
    with progress.bar("converting") as report:
        if filter == "nearest":
            bits = BITS[texels.itemsize]
            _core.convert_envmap_nearest((rows.view(bits), out_rows.view(bits)), (from_shape, to_shape), report=report)
        else:
            _core.convert_envmap(
                (rows, out_rows), (from_shape, to_shape), filter=filter, samples=samples, report=report
            )
    return out


def envmap_directions(size: int | tuple[int, int], *, layout: Layout = "cube") -> NDArray[np.float64]:
    """Compute the directions of the texel centres of an environment map.

    ValueError and TypeError for unknown layouts, and sizes out of range.

    Parameters
    ----------
    size
        S of a cube or an octahedral map; for "equirectangular" (H, W), or H alone with W = 2 H.
    layout
        "cube", "equirectangular" or "octahedral", as in `convert_envmap`.

    Returns
    -------
    NDArray
        (6, S, S, 3), (H, W, 3) or (S, S, 3) float64. Not normalised: the greatest component is ±1 in cubes, and the
        absolute values of the three components add up to 1 in octahedral maps.
    """
    shape = _shape("layout", layout, size)
    directions = np.empty((*_array_shape(shape), 3))
    _core.envmap_directions(shape, directions.reshape(-1, 3))
    return directions


def envmap_texels(directions: ArrayLike, *, size: int | tuple[int, int], layout: Layout = "cube") -> NDArray[np.int64]:
    """Compute the numbers of the texels that directions pass through: the inverse of `envmap_directions`.

    Returns (...) int64, indices into the flattened map: face by face in a cube, row by row. ValueError and TypeError
    for unknown layouts, sizes out of range, directions that are zero or not finite.

    Parameters
    ----------
    directions
        (..., 3), of any length.
    size, layout
        As in `envmap_directions`.
    """
    shape = _shape("layout", layout, size)
    rows, outer = directions_of(directions)
    numbers = np.empty(len(rows), np.int64)
    _core.envmap_texels(shape, rows, numbers)
    return numbers.reshape(outer)


def _source_shape(values: NDArray[Any], layout: str) -> tuple[str, int, int]:
    """Return layout, rows and columns of an array; ValueError if it does not fit the layout."""
    shape = values.shape
    if layout == "cube":
        if len(shape) < 3 or shape[0] != 6 or shape[1] != shape[2] or not 1 <= shape[1] <= LIMIT:
            raise ValueError(f"values: expected shape (6, S, S, ...), S up to {LIMIT}, for a cube, got {shape}")
        return layout, shape[1], shape[2]
    is_square = layout == "octahedral"
    fits = len(shape) >= 2 and all(1 <= n <= 2 * LIMIT for n in shape[:2])
    if not fits or (is_square and shape[0] != shape[1]) or (not is_square and shape[1] % 2):
        expected = "(S, S, ...)" if is_square else "(H, W, ...) with an even W"
        raise ValueError(f"values: expected shape {expected}, up to {2 * LIMIT}, for {layout}, got {shape}")
    return layout, shape[0], shape[1]


def _shape(name: str, layout: str, size: int | tuple[int, int]) -> tuple[str, int, int]:
    """Check a layout and a size; returns layout, rows and columns."""
    check.choice(name, layout, LAYOUTS)
    limit = LIMIT if layout == "cube" else 2 * LIMIT
    # NumPy arrays are accepted like tuples; the first three numbers suffice to detect a wrong count.
    size = tuple(size[:3].tolist()) if isinstance(size, np.ndarray) and size.ndim == 1 else size
    if layout != "equirectangular":
        edge = check.integer("size", size, 1, limit)  # type: ignore[arg-type]
        return layout, edge, edge
    if isinstance(size, tuple | list):
        if len(size) != 2:
            raise ValueError(f"size: expected (H, W), got {len(size)} numbers")
        height, width = (check.integer("size", n, 1, limit) for n in size)
    else:
        height = check.integer("size", size, 1, LIMIT)
        width = 2 * height
    if width % 2:
        raise ValueError(f"size: expected an even W, got {width}")
    return layout, height, width


def _array_shape(shape: tuple[str, int, int]) -> tuple[int, ...]:
    layout, height, width = shape
    return (6, height, width) if layout == "cube" else (height, width)
