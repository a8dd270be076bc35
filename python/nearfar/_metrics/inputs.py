"""Inputs of metrics: pictures of any number type and layout, converted only if kernels cannot read them."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from nearfar._base import check
from nearfar._render.frame import Frame

LUMA = (0.2126, 0.7152, 0.0722)
"""Rec. 709 weights of red, green and blue, applied to sRGB-encoded colour."""

GREATEST = 1e150
"""Greatest absolute value of a pixel, so that float64 holds its square."""

_KERNEL_TYPES = (np.uint8, np.uint16, np.float32)
"""Types that kernels read beside float64, which they take for all that do not fit into these."""


class Pair(NamedTuple):
    """Two pictures of one shape and one type: uint8, uint16, float32 or float64."""

    reference: NDArray[Any]
    test: NDArray[Any]
    data_range: float | None
    """Difference between the greatest and the least possible value; 1 for frames, None if unknown."""

    def refuse(self, names: tuple[str, str] = ("reference", "test")) -> ValueError:
        """Make the error for a result that is not finite; it names the picture and position that cause it."""
        for name, values in zip(names, (self.reference, self.test), strict=True):
            if flaw := check.not_finite(name, values):
                return flaw
        return ValueError(
            f"{names[0]}: expected values up to {GREATEST:g}, whose squares float64 holds, got greater ones"
        )

    def extent(self) -> float:
        """Return `data_range`; ValueError if it is unknown, because it is never guessed."""
        if self.data_range is None:
            raise ValueError("data_range: expected the range of the pictures' values, such as 255 for 8 bits, got None")
        return check.positive("data_range", self.data_range)


def pair(reference: ArrayLike | Frame, test: ArrayLike | Frame, data_range: float | None = None) -> Pair:
    """Check two arrays of one shape, or compute the luma of two frames.

    Arrays that kernels can read are not copied: uint8, uint16, float32 and float64 with strides that are not negative.

    Raises
    ------
    ValueError
        For different shapes, empty pictures and frames without colour.
    TypeError
        For values that are not numbers, and for a frame together with an array.
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
    """Convert two arrays of any shapes to one type that kernels read."""
    first, second = numbers(names[0], reference), numbers(names[1], test)
    common = np.result_type(_kernel_type(first.dtype), _kernel_type(second.dtype))
    return _readable(first, common), _readable(second, common)


def _kernel_type(dtype: np.dtype[Any]) -> type[np.generic]:
    """Smallest type that kernels read and that holds all values of a type."""
    return next((kind for kind in _KERNEL_TYPES if np.can_cast(dtype, kind)), np.float64)


def luma(frame: Frame) -> NDArray[np.float64]:
    """Compute the Rec. 709 luma (H, W) of a frame's sRGB-encoded colour, 0..1."""
    linear = np.clip(frame.require("color").astype(np.float64), 0.0, 1.0)
    encoded = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1.0 / 2.4) - 0.055)
    return np.asarray(encoded @ np.array(LUMA))


def mask_of(mask: ArrayLike, name: str = "mask") -> NDArray[np.uint8]:
    """Convert a mask to bytes, 1 for the pixels that count; TypeError for anything but bools or whole numbers."""
    values = check.plain(name, mask)
    if values.dtype.kind not in "biu":
        raise TypeError(f"{name}: expected true and false, got {values.dtype}")
    return _readable((values if values.dtype.kind == "b" else values != 0).view(np.uint8), np.uint8)


def numbers(name: str, value: ArrayLike) -> NDArray[Any]:
    """Return an array of real numbers or bools; ValueError or TypeError otherwise."""
    values = check.plain(name, value)
    if values.dtype.kind not in "biuf":
        raise TypeError(f"{name}: expected real numbers, got {type(value).__name__} of type {values.dtype}")
    return values


def _readable(array: NDArray[Any], dtype: DTypeLike) -> NDArray[Any]:
    """Convert arrays that kernels cannot read: other types or byte orders, negative or misaligned strides."""
    target = np.dtype(dtype)
    typed = array.view(np.uint8) if array.dtype.kind == "b" else array
    typed = typed.astype(target, copy=False)
    plain = typed.flags.aligned and all(step >= 0 and step % target.itemsize == 0 for step in typed.strides)
    # `copy=True` is needed: NumPy calls an axis of length 1 contiguous whatever its stride.
    return typed if plain else np.array(typed, order="C", copy=True)
