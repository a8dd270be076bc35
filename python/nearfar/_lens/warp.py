"""Pictures and meshes warped by lenses."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._camera.camera import Fov

FILTERS = ("linear", "cubic")

TYPES = (np.uint8, np.uint16, np.float32, np.float64)

MOST_CELLS = 1 << 18
"""Cells that a tolerance may ask for."""

View = tuple[Fov | None, Fov | None, float | None]
"""What is read and what is made show, and the tangent at which r = 1, as callers give them."""


@dataclass(frozen=True, eq=False)
class WarpMesh:
    """A grid that warps pictures: at each vertex where it is drawn, and what of the picture is shown there."""

    positions: NDArray[np.float32] = field(repr=False)
    """(N, 2) float32, clip coordinates: −1..1, x to the right, y up."""
    texcoords: NDArray[np.float32] = field(repr=False)
    """(L, N, 2) float32 for each lens, shares of the picture that is read from its top left corner, v down.

    They may lie outside 0..1 where the lens shows what is beside the picture.
    """
    faces: NDArray[np.uint32] = field(repr=False)
    """(F, 3) uint32, counter-clockwise."""
    error_px: float
    """Nothing of the picture that is read is shown further beside its place, in pixels of that picture.

    A bound from the map's second derivatives, not a measurement. Cells that show nothing of the picture don't count.
    """


def warp(
    lenses: list[_core.RadialLens],
    image: ArrayLike,
    inverse: bool,
    view: View,
    size: tuple[int, int] | None,
    filter: str,  # noqa: A002
    fill: float,
) -> NDArray[Any]:
    """Warp a picture by one lens, or by one for each of its channels."""
    picture = _picture(image, len(lenses))
    height, width = picture.shape[:2]
    check.choice("filter", filter, FILTERS)
    shown = _view(*view, width / height)
    values = picture if picture.ndim == 3 else picture[..., None]
    made = _core.warp(
        lenses,
        values,
        **shown,
        size=check.size("size", (width, height) if size is None else size),
        distort=not inverse,
        filter=filter,
        fill=_fill(fill, picture.dtype),
    )
    return made.reshape(made.shape[:2] + picture.shape[2:])


def warp_mesh(
    lenses: list[_core.RadialLens],
    size: tuple[int, int],
    inverse: bool,
    view: View,
    cells: tuple[int, int] | None,
    tolerance_px: float,
) -> WarpMesh:
    """Make a mesh of given cells, or of as many as a tolerance needs."""
    width, height = check.size("size", size)
    shown = _view(*view, width / height)
    tolerance = check.positive("tolerance_px", tolerance_px)

    def made(columns: int, rows: int) -> WarpMesh:
        mesh = _core.warp_mesh(lenses, **shown, cells=(columns, rows), size=(width, height), distort=not inverse)
        return _compact(*mesh, size=max(width, height))

    if cells is not None:
        return made(*check.pair("cells", cells, 1, 4096))
    left, right, down, up = shown["to_fov"]
    aspect = (up - down) / (right - left)

    def of(finest: int) -> WarpMesh:
        """Cells that are as wide as high, so many along the longer side."""
        return made(max(1, round(finest / max(1.0, aspect))), max(1, round(finest * min(1.0, aspect))))

    most = math.isqrt(round(MOST_CELLS * max(aspect, 1 / aspect)))
    high = 4
    mesh = of(high)
    while mesh.error_px > tolerance:
        if high == most:
            raise ValueError(
                f"tolerance_px: expected one that {MOST_CELLS:,} cells hold, got {tolerance}; "
                f"they may be off by up to {mesh.error_px:.3g} px"
            )
        high = min(2 * high, most)
        mesh = of(high)
    low = high // 2 if high > 4 else 0
    while high - low > 1:
        middle = (low + high) // 2
        between = of(middle)
        if between.error_px <= tolerance:
            high, mesh = middle, between
        else:
            low = middle
    return mesh


def _compact(
    places: NDArray[np.float64],
    sources: NDArray[np.float64],
    faces: NDArray[np.uint32],
    error: float,
    *,
    size: int,
) -> WarpMesh:
    """Drop vertices that no face uses; round to float32, which the error allows for."""
    used, renumbered = np.unique(faces, return_inverse=True)
    positions = places[used] * (2.0, -2.0) + (-1.0, 1.0)
    texcoords = sources[:, used].astype(np.float32)
    # Half a step of a texture coordinate each way, and of a position, times the map's slope.
    rounding = size * 2.0**-23 * max(1.0, float(np.abs(texcoords).max()))
    return WarpMesh(
        positions.astype(np.float32), texcoords, renumbered.reshape(faces.shape).astype(np.uint32), error + rounding
    )


def radius_of(fov: Fov, lens_radius: float | None) -> float:
    """Tangent at which r = 1: as given, or the larger side of a field of view."""
    return max(abs(fov.left), abs(fov.right)) if lens_radius is None else check.positive("lens_radius", lens_radius)


def _view(fov: Fov | None, output_fov: Fov | None, lens_radius: float | None, aspect: float) -> dict[str, Any]:
    """Fields of view of what is read and what is made, and the tangent at which r = 1."""
    for name, given in (("fov", fov), ("output_fov", output_fov)):
        if given is not None and not isinstance(given, Fov):
            raise TypeError(f"{name}: expected a Fov, got {type(given).__name__}")
    read = fov or Fov(-1.0, 1.0, -1.0 / aspect, 1.0 / aspect)
    made = output_fov or read
    bounds = [(each.left, each.right, each.down, each.up) for each in (read, made)]
    return {"from_fov": bounds[0], "to_fov": bounds[1], "tan_omega": radius_of(read, lens_radius)}


def _fill(fill: float, dtype: np.dtype[Any]) -> float:
    """What pixels of a type can be: NaN and infinities only for floats."""
    if dtype.kind == "f":
        return check.number("fill", fill, finite=False)
    value, most = check.number("fill", fill), np.iinfo(dtype).max
    if not 0 <= value <= most:
        raise ValueError(f"fill: expected a number from 0 to {most} for {dtype.name}, got {value}")
    return value


def _picture(image: ArrayLike, lenses: int) -> NDArray[Any]:
    picture = check.plain("image", image)
    if picture.dtype.type not in TYPES:
        names = ", ".join(np.dtype(each).name for each in TYPES)
        raise TypeError(f"image: expected one of {names}, got {picture.dtype}")
    if picture.ndim not in (2, 3) or 0 in picture.shape:
        raise ValueError(f"image: expected shape (H, W) or (H, W, C), got {picture.shape}")
    if lenses > 1 and picture.shape[2:] != (lenses,):
        raise ValueError(f"image: expected shape (H, W, {lenses}), a channel for each lens, got {picture.shape}")
    return np.require(picture, picture.dtype.newbyteorder("="), ["C_CONTIGUOUS", "ALIGNED"])
