"""What metrics compare: pictures of any number type and layout, taken as they are where kernels can read them."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from nearfar._base import check
from nearfar._render.frame import Frame

LUMA = (0.2126, 0.7152, 0.0722)
"""Rec. 709, of sRGB-encoded colour."""

GREATEST = 1e150
"""Values whose squares float64 holds."""

# What kernels read, and for other types the smallest of these that holds their values; float64 for the rest.
_READ: dict[np.dtype[Any], DTypeLike] = {
    np.dtype(given): np.dtype(read)
    for given, read in {
        np.bool_: np.uint8,
        np.uint8: np.uint8,
        np.uint16: np.uint16,
        np.int8: np.float32,
        np.int16: np.float32,
        np.float16: np.float32,
        np.float32: np.float32,
    }.items()
}


class Pair(NamedTuple):
    """Two pictures of one shape and of one of uint8, uint16, float32 and float64."""

    reference: NDArray[Any]
    test: NDArray[Any]
    data_range: float | None
    """1 for frames."""

    def refuse(self, names: tuple[str, str] = ("reference", "test")) -> ValueError:
        """Why a result is no number: the picture that is to blame, and where."""
        for name, values in zip(names, (self.reference, self.test), strict=True):
            if values.dtype.kind == "f" and not np.isfinite(values).all():
                bad = np.argwhere(~np.isfinite(values))
                where = tuple(int(i) for i in bad[0])
                return ValueError(f"{name}: expected finite numbers, got {len(bad)} that are not, the first at {where}")
        return ValueError(
            f"{names[0]}: expected values up to {GREATEST:g}, whose squares float64 holds, got greater ones"
        )

    def extent(self) -> float:
        """`data_range`, which is never guessed."""
        if self.data_range is None:
            raise ValueError("data_range: expected the range of the pictures' values, such as 255 for 8 bits, got None")
        return check.positive("data_range", self.data_range)


def pair(reference: ArrayLike | Frame, test: ArrayLike | Frame, data_range: float | None = None) -> Pair:
    """Two arrays of one shape, or the luma of two frames.

    Nothing is copied that kernels can read: uint8, uint16, float32 and float64 with any steps between values that are
    not negative.

    Raises
    ------
    ValueError
        For other shapes, empty pictures and frames without colour.
    TypeError
        For values that are not numbers, and for a frame beside an array.
    """
    if isinstance(reference, Frame) and isinstance(test, Frame):
        first, second = luma(reference), luma(test)
        data_range = 1.0 if data_range is None else data_range
    elif isinstance(reference, Frame) or isinstance(test, Frame):
        raise TypeError("test: expected two frames or two arrays, got one of each")
    else:
        first, second = stack(reference, test)
    if first.shape != second.shape:
        raise ValueError(f"test: expected shape {first.shape}, got {second.shape}")
    if not first.size:
        raise ValueError(f"reference: expected at least one value, got shape {first.shape}")
    return Pair(first, second, data_range)


def stack(
    reference: ArrayLike, test: ArrayLike, names: tuple[str, str] = ("reference", "test")
) -> tuple[NDArray[Any], NDArray[Any]]:
    """Both as arrays of one type that kernels read, of any shapes."""
    first, second = numbers(names[0], reference), numbers(names[1], test)
    common = np.result_type(*(_READ.get(array.dtype.newbyteorder("="), np.float64) for array in (first, second)))
    return _readable(first, common), _readable(second, common)


def luma(frame: Frame) -> NDArray[np.float64]:
    """Rec. 709 luma of the sRGB-encoded colour."""
    linear = np.clip(frame.require("color").astype(np.float64), 0.0, 1.0)
    encoded = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1.0 / 2.4) - 0.055)
    return np.asarray(encoded @ np.array(LUMA))


def mask_of(mask: ArrayLike, name: str = "mask") -> NDArray[np.uint8]:
    """Which pixels a mask names, as bytes; TypeError for anything but true and false or whole numbers."""
    given = check.plain(name, mask)
    if given.dtype.kind not in "biu":
        raise TypeError(f"{name}: expected true and false, got {given.dtype}")
    named: NDArray[np.uint8] = _readable((given if given.dtype.kind == "b" else given != 0).view(np.uint8), np.uint8)
    return named


def numbers(name: str, value: ArrayLike) -> NDArray[Any]:
    """An array of real numbers or of true and false; ValueError or TypeError otherwise."""
    given = check.plain(name, value)
    if given.dtype.kind not in "biuf":
        raise TypeError(f"{name}: expected real numbers, got {type(value).__name__} of type {given.dtype}")
    return given


def _readable(array: NDArray[Any], dtype: DTypeLike) -> NDArray[Any]:
    """Convert only what kernels cannot read: other types and byte orders, steps back, values across their alignment."""
    wanted = np.dtype(dtype)
    typed = array.view(np.uint8) if array.dtype.kind == "b" else array
    typed = typed.astype(wanted, copy=False)
    plain = typed.flags.aligned and all(step >= 0 and step % wanted.itemsize == 0 for step in typed.strides)
    # A copy by all means: to NumPy axes of one value are contiguous whatever their step.
    return typed if plain else np.array(typed, order="C", copy=True)
