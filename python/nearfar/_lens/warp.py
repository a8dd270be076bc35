"""Warps pictures by a lens's distortion, and makes warp meshes for runtimes."""

from __future__ import annotations

import abc
import math
from dataclasses import dataclass, field
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._camera.camera import Camera, Fov
from nearfar._render.frame import Frame

Filter = Literal["linear", "cubic"]
Symmetric = Literal["symmetric"]
"""Field of view of a picture whose middle is on the lens's axis."""

TYPES = (np.uint8, np.uint16, np.float32, np.float64)
"""Number types of pictures."""
MAX_CELLS = 1 << 18
"""Maximum number of cells of a mesh whose size follows from a tolerance."""


@dataclass(frozen=True, eq=False)
class WarpMesh:
    """A triangulated grid that warps pictures, with a position and texture coordinates at each vertex."""

    positions: NDArray[np.float32] = field(repr=False)
    """(N, 2) float32, clip coordinates: −1..1, x to the right, y up."""
    texcoords: NDArray[np.float32] = field(repr=False)
    """(L, N, 2) float32, texture coordinates in the source picture for each of L lenses: 0..1 from the top left corner,
    v down.

    They lie outside 0..1 where the lens shows a place outside the picture.
    """
    faces: NDArray[np.uint32] = field(repr=False)
    """(F, 3) uint32, vertex numbers, counter-clockwise."""
    error_px: float
    """Maximum displacement of any shown point of the source picture, in pixels of that picture.

    It is a bound from the map's second derivatives, not a measurement, over all cells that show a part of the picture.
    """


class Warping(abc.ABC):
    """Base class of lenses for one or three colours: warps pictures, and makes warp meshes."""

    @property
    @abc.abstractmethod
    def _cores(self) -> list[_core.RadialLens]:
        """The lens, or one for each of red, green and blue."""

    def warp(
        self,
        image: ArrayLike | Frame,
        inverse: bool = False,
        *,
        fov: Fov | Symmetric | None = None,
        output_fov: Fov | None = None,
        lens_radius: float | None = None,
        size: tuple[int, int] | None = None,
        filter: Filter = "linear",  # noqa: A002
        fill: float = 0.0,
    ) -> NDArray[Any]:
        """Distort a picture as the lens does, or warp it so that the lens's distortion cancels out.

        ValueError and TypeError for wrong shapes and types, unknown filters, a picture without a field of view, frames
        without colour, and frames of cameras without a `Fov`.

        Parameters
        ----------
        image
            (H, W) or (H, W, C), for a `ChromaticLens` (H, W, 3): uint8, uint16, float32 or float64, in the colour space
            in which pixels are to be mixed. A `Frame` of a camera with a `Fov`: its colour, linear.
        inverse
            False moves the pixel at r to f(r), like the lens. True moves the pixel at f(r) to r, so that the lens moves
            it back.
        fov
            Field of view of the picture, as tangents from the lens's axis, such as `hmd.left.fov`. Frames use that of
            their camera, and this must be None. Arrays need it: "symmetric" states that the axis is in the middle, that
            pixels are square, and that r = 1 at the left and right edges.
        output_fov, size
            Field of view and (width, height) in pixels of the result; by default those of `image`.
        lens_radius
            Tangent at which r = 1, such as `Hmd.tan_half_angle`. It is the same for both eyes, and for pictures that
            show more or less than the screen. By default the larger of left and right of `fov`.
        filter
            "linear" or "cubic" (Keys 1981, a = −1/2, equal to Catmull–Rom).
        fill
            Value of pixels that show no part of the picture.

        Returns
        -------
        NDArray
            The warped picture, in the type of `image`; for a frame its warped colour, (H, W, 3) float32, linear RGB,
            not a `Frame`, because no camera has the rays of its pixels. The position that a pixel is read from has an
            error of at most 5·10⁻¹⁰ of its distance from the axis.
        """
        check.choice("filter", filter, get_args(Filter))
        distort = not check.flag("inverse", inverse)
        if isinstance(image, Frame):
            fov = _fov_of("image", image.camera, fov)
            image = image.require("color")
        picture = _picture(image, len(self._cores))
        height, width = picture.shape[:2]
        view = _view(fov, output_fov, lens_radius, width / height) | {"distort": distort}
        values = picture if picture.ndim == 3 else picture[..., None]
        output_size = check.size("size", (width, height) if size is None else size)
        outside = _fill(fill, picture.dtype)
        result = _core.warp(self._cores, values, view, size=output_size, filter=filter, fill=outside)
        return result.reshape(result.shape[:2] + picture.shape[2:])

    def warp_mesh(
        self,
        size: tuple[int, int] | Camera | Frame,
        inverse: bool = True,
        *,
        fov: Fov | Symmetric | None = None,
        output_fov: Fov | None = None,
        lens_radius: float | None = None,
        cells: tuple[int, int] | None = None,
        tolerance_px: float = 0.25,
    ) -> WarpMesh:
        """Make a mesh with which a runtime warps pictures of one size, and bound its error between vertices.

        ValueError for a tolerance that 2¹⁸ cells do not satisfy, such as near the fold of an inverse; a field of view
        beyond the lens's domain; a size without a field of view; or a camera without a `Fov`.

        Parameters
        ----------
        size
            (width, height) of the source picture in pixels; or its camera, or a frame of that camera, which also define
            its `fov`.
        inverse, fov, output_fov, lens_radius
            As in `warp`. Runtimes need the inverse, which cancels the lens's distortion.
        cells
            Columns and rows of the grid, 1 to 4096 each. By default as many as `tolerance_px` needs.
        tolerance_px
            Maximum error in pixels of the source picture.

        Returns
        -------
        WarpMesh
            The mesh, without cells that reach beyond the lens's domain. For a `ChromaticLens` it has texture
            coordinates for red, green and blue.
        """
        distort = not check.flag("inverse", inverse)
        if isinstance(size, Camera | Frame):
            camera = size if isinstance(size, Camera) else size.camera
            size, fov = camera.size, _fov_of("size", camera, fov)
        width, height = check.size("size", size)
        view = _view(fov, output_fov, lens_radius, width / height) | {"distort": distort}
        tolerance = check.positive("tolerance_px", tolerance_px)

        def grid(columns: int, rows: int) -> WarpMesh:
            mesh = _core.warp_mesh(self._cores, view, cells=(columns, rows), size=(width, height))
            return _compact(*mesh, size=max(width, height))

        if cells is not None:
            return grid(*check.pair("cells", cells, 1, 4096))
        left, right, down, up = view["to_fov"]
        aspect = (up - down) / (right - left)

        def square_grid(finest: int) -> WarpMesh:
            """Make a mesh of nearly square cells, `finest` of them along the longer side."""
            return grid(max(1, round(finest / max(1.0, aspect))), max(1, round(finest * min(1.0, aspect))))

        greatest = math.isqrt(round(MAX_CELLS * max(aspect, 1 / aspect)))
        high = 4
        while (mesh := square_grid(high)).error_px > tolerance:
            if high == greatest:
                least = f"{mesh.error_px:.3g} px, the error of {MAX_CELLS:,} cells"
                raise ValueError(f"tolerance_px: expected at least {least}, got {tolerance}")
            high = min(2 * high, greatest)
        low = high // 2 if high > 4 else 0
        while high - low > 1:
            middle = (low + high) // 2
            candidate = square_grid(middle)
            if candidate.error_px <= tolerance:
                high, mesh = middle, candidate
            else:
                low = middle
        return mesh


def _compact(
    places: NDArray[np.float64], sources: NDArray[np.float64], faces: NDArray[np.uint32], error: float, *, size: int
) -> WarpMesh:
    """Drop vertices that no face uses, round to float32, and add the rounding to the error."""
    used, renumbered = np.unique(faces, return_inverse=True)
    positions = (places[used] * (2.0, -2.0) + (-1.0, 1.0)).astype(np.float32)
    texcoords = sources[:, used].astype(np.float32)
    # Half a float32 step of a texture coordinate in each direction, and of a position times the map's slope.
    rounding = size * 2.0**-23 * max(1.0, float(np.abs(texcoords).max()))
    return WarpMesh(positions, texcoords, renumbered.reshape(faces.shape).astype(np.uint32), error + rounding)


def radius_of(fov: Fov, lens_radius: float | None) -> float:
    """Return the tangent at which r = 1: `lens_radius`, or the larger of left and right of a field of view."""
    return max(abs(fov.left), abs(fov.right)) if lens_radius is None else check.positive("lens_radius", lens_radius)


def _fov_of(name: str, camera: Camera, fov: object) -> Fov:
    """Return the field of view of a frame's or a mesh's camera; ValueError if the caller gave another one."""
    if fov is not None:
        got = check.value_or_type(fov)
        raise ValueError(f"fov: expected None, because {name} has the field of view of its camera, got {got}")
    if not isinstance(camera.fov, Fov):
        raise ValueError(f"{name}: expected a camera with a Fov, got one with {type(camera.fov).__name__}")
    return camera.fov


def _view(
    fov: Fov | Symmetric | None, output_fov: Fov | None, lens_radius: float | None, aspect: float
) -> dict[str, Any]:
    """Return the fields of view of the source and the result, and the tangent at which r = 1, for kernels."""
    if fov is None or (isinstance(fov, str) and fov not in get_args(Symmetric)):
        expected = 'the Fov of the picture, such as hmd.left.fov, or "symmetric" for an axis in its middle'
        raise ValueError(f"fov: expected {expected}, got {check.value_or_type(fov)}")
    if isinstance(fov, str):
        fov = Fov(-1.0, 1.0, -1.0 / aspect, 1.0 / aspect)
    source = check.instance("fov", fov, Fov)
    result = source if output_fov is None else check.instance("output_fov", output_fov, Fov)
    return {"from_fov": source._sides, "to_fov": result._sides, "tan_omega": radius_of(source, lens_radius)}


def _fill(fill: float, dtype: np.dtype[Any]) -> float:
    """Check a fill value against the range of a pixel type; only floats allow NaN and infinities."""
    if dtype.kind == "f":
        return check.number("fill", fill, finite=False)
    value, greatest = check.number("fill", fill), np.iinfo(dtype).max
    if not 0 <= value <= greatest:
        raise ValueError(f"fill: expected a number from 0 to {greatest} for {dtype.name}, got {value}")
    return value


def _picture(image: ArrayLike, lenses: int) -> NDArray[Any]:
    picture = check.plain("image", image)
    if picture.dtype.type not in TYPES:
        names = ", ".join(np.dtype(kind).name for kind in TYPES)
        raise TypeError(f"image: expected one of {names}, got {picture.dtype}")
    if picture.ndim not in (2, 3) or 0 in picture.shape:
        raise ValueError(f"image: expected shape (H, W) or (H, W, C), got {picture.shape}")
    if lenses > 1 and picture.shape[2:] != (lenses,):
        raise ValueError(f"image: expected shape (H, W, {lenses}), a channel for each lens, got {picture.shape}")
    return np.require(picture, picture.dtype.newbyteorder("="), ["C_CONTIGUOUS", "ALIGNED"])
