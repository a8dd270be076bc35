"""Inputs of metrics: pictures of any number type and layout, converted only if kernels cannot read them directly."""

from __future__ import annotations

import sys
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from nearfar._base import check
from nearfar._render.frame import Frame

LUMA = (0.2126, 0.7152, 0.0722)
"""Rec. 709 weights of red, green and blue, applied to sRGB-encoded colour."""
MAX = 1e150
"""Greatest absolute value of a pixel, so that float64 holds its square."""
_KERNEL_TYPES = (np.uint8, np.uint16, np.float32)
"""Types that kernels read besides float64; all others are converted to float64."""
_MODES = ("1", "L", "RGB", "I", "F", "I;16", "I;16L", "I;16B", "I;16N")
"""Accepted modes of Pillow images: grey of any depth, and RGB."""


class Pair(NamedTuple):
    """Two pictures of one shape and one type: uint8, uint16, float32 or float64."""

    reference: NDArray[Any]
    test: NDArray[Any]
    data_range: float | None
    """Difference between the greatest and the least possible value; 1 for frames, None if unknown."""

    def non_finite_error(self, names: tuple[str, str] = ("reference", "test")) -> ValueError:
        """Return the error to raise for a result that is not finite; it states picture and position of the cause."""
        for name, values in zip(names, (self.reference, self.test), strict=True):
            if flaw := check.not_finite(name, values):
                return flaw
        return ValueError(f"{names[0]}: expected values up to {MAX:g}, whose squares float64 holds, got greater ones")

    @property
    def may_exceed(self) -> bool:
        """Whether the pictures' type allows values that differ by more than `data_range`."""
        kind = self.reference.dtype
        return kind.kind == "f" or np.iinfo(kind).max > self.extent()

    def is_beyond(self, least: float, greatest: float) -> bool:
        """Return whether values differ by more than `data_range`.

        Whole numbers are compared exactly. Real numbers may exceed it by their own rounding and by a millionth, because
        weights in float32 may not add up to 1: with Rec. 709's, the luma of white is 1.0000001. Filters that overshoot
        exceed it by per cents and are rejected.
        """
        extent, allowed = self.extent(), 0.0
        if self.reference.dtype.kind == "f":
            allowed = 1e-6 * extent + float(np.finfo(self.reference.dtype).eps) * (abs(least) + abs(greatest))
        return greatest - least > extent + allowed

    def check_values(self, least: float, greatest: float) -> None:
        """Raise ValueError for pictures whose least and greatest value differ by more than `data_range`."""
        if self.is_beyond(least, greatest):
            raise ValueError(
                f"data_range: expected at least {greatest - least:.9g}, because the pictures' values reach from "
                f"{least:.9g} to {greatest:.9g}, got {self.extent():.9g}"
            )

    def channels_first(self, axis: int | None) -> Pair:
        """Move the axis of the channels to the front, without a copy."""
        if axis is None:
            return self
        return Pair(np.moveaxis(self.reference, axis, 0), np.moveaxis(self.test, axis, 0), self.data_range)

    def extent(self) -> float:
        """Return `data_range`; ValueError if the caller did not state it."""
        if self.data_range is None:
            raise ValueError("data_range: expected the range of the pictures' values, such as 255 for 8 bits, got None")
        return check.positive("data_range", self.data_range)


def pair(reference: ArrayLike | Frame, test: ArrayLike | Frame, data_range: float | None = None) -> Pair:
    """Check two arrays of one shape, or compute the luma of two frames.

    Arrays that kernels can read are not copied: uint8, uint16, float32 and float64 with strides that are not negative.
    ValueError for different shapes, empty pictures, frames without colour or with a `data_range`, and Pillow images of
    a mode that is neither grey nor RGB; TypeError for values that are not numbers, and a frame together with an array.
    """
    if isinstance(reference, Frame) and isinstance(test, Frame):
        first, second = luma(reference), luma(test)
        data_range = frame_extent(data_range)
    elif isinstance(reference, Frame) or isinstance(test, Frame):
        raise TypeError("reference, test: expected two frames or two arrays, got one of each")
    else:
        first, second = stack(reference, test)
    if first.shape != second.shape:
        raise ValueError(f"test: expected shape {first.shape}, got {second.shape}")
    if not first.size:
        raise ValueError(f"reference: expected at least one value, got shape {first.shape}")
    return Pair(first, second, data_range)


def frame_extent(data_range: float | None) -> float:
    """Return the range of a frame's values, 1; ValueError if the caller states a range."""
    if data_range is not None:
        raise ValueError(
            f"data_range: expected none for frames, whose values are 0 to 1, got {check.value_or_type(data_range)}"
        )
    return 1.0


def channel_axis(pair: Pair, axis: int | None) -> int | None:
    """Find the axis of the channels; None for (H, W). ValueError for shapes that one picture cannot have."""
    shape = pair.reference.shape
    if axis is not None:
        number = check.integer("channel_axis", axis, -3, 2)
        if len(shape) != 3:
            raise ValueError(f"channel_axis: expected three axes, or None for (H, W), got {number} with shape {shape}")
        return number
    if len(shape) < 2:
        raise ValueError(f"reference: expected shape (H, W), (H, W, 1) or (H, W, 3), got {shape}")
    if len(shape) == 2:
        return None
    refuse_alpha(shape, "give channel_axis=-1 to compare all as channels")
    if len(shape) > 3 or shape[-1] not in (1, 3):
        raise ValueError(
            f"channel_axis: expected the axis of the channels of one picture, because shape {shape} is neither (H, W) "
            f"nor (H, W, 3), got None; nearfar.metrics.ssim_pairs compares stacks of pictures (..., H, W)"
        )
    return -1


def refuse_alpha(shape: tuple[int, ...], otherwise: str) -> None:
    """Raise ValueError if the last axis, of length 2 or 4, seems to include alpha, which would hide errors."""
    if len(shape) > 2 and shape[-1] in (2, 4):
        raise ValueError(
            f"reference: expected pictures without alpha, got shape {shape}; drop it by "
            f"image[..., :{shape[-1] - 1}], or {otherwise}"
        )


def stack(
    reference: ArrayLike, test: ArrayLike, names: tuple[str, str] = ("reference", "test")
) -> tuple[NDArray[Any], NDArray[Any]]:
    """Convert two arrays of any shapes to one type that kernels read."""
    first, second = numbers(names[0], reference), numbers(names[1], test)
    common = np.result_type(_kernel_type(first.dtype), _kernel_type(second.dtype))
    return _readable(first, common), _readable(second, common)


def _kernel_type(dtype: np.dtype[Any]) -> type[np.generic]:
    """Return the smallest type that kernels read and that represents all values of a type."""
    return next((kind for kind in _KERNEL_TYPES if np.can_cast(dtype, kind)), np.float64)


def luma(frame: Frame) -> NDArray[np.float64]:
    """Compute the Rec. 709 luma (H, W) of a frame's sRGB-encoded colour, 0..1."""
    return np.asarray(srgb_color(frame) @ np.array(LUMA))


def srgb_color(frame: Frame) -> NDArray[np.float64]:
    """Return a frame's sRGB-encoded colour (H, W, 3), 0..1."""
    linear = np.clip(frame.require("color").astype(np.float64), 0.0, 1.0)
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1.0 / 2.4) - 0.055)


def mask_of(mask: ArrayLike, name: str = "mask") -> NDArray[np.uint8]:
    """Convert a mask to bytes, 1 for the pixels that count; TypeError for anything but bools or whole numbers."""
    values = check.plain(name, mask)
    if values.dtype.kind not in "biu":
        raise TypeError(f"{name}: expected bools or whole numbers, got {values.dtype}")
    return _readable((values if values.dtype.kind == "b" else values != 0).view(np.uint8), np.uint8)


def numbers(name: str, value: ArrayLike) -> NDArray[Any]:
    """Return an array of real numbers or bools; ValueError or TypeError otherwise."""
    for part in value if isinstance(value, list | tuple) else (value,):
        _check_mode(name, part)
    values = check.plain(name, value)
    if values.dtype.kind not in "biuf":
        raise TypeError(f"{name}: expected real numbers, got {type(value).__name__} of type {values.dtype}")
    return values


def _check_mode(name: str, value: object) -> None:
    """Raise ValueError for Pillow images that are not grey or RGB: NumPy would compare palette indices and alpha."""
    # An image exists only if Pillow is loaded.
    pillow = sys.modules.get("PIL.Image")
    if pillow is not None and isinstance(value, pillow.Image) and value.mode not in _MODES:
        raise ValueError(
            f"{name}: expected an image of mode {', '.join(_MODES)}, got {value.mode!r}; convert it by "
            f"image.convert('RGB') or image.convert('L')"
        )


def _readable(array: NDArray[Any], dtype: DTypeLike) -> NDArray[Any]:
    """Convert arrays that kernels cannot read: other types or byte orders, negative or misaligned strides."""
    target = np.dtype(dtype)
    # Pillow's images of mode "1" are bools whose bytes are 255.
    typed = (array.view(np.uint8) != 0).view(np.uint8) if array.dtype.kind == "b" else array
    typed = typed.astype(target, copy=False)
    plain = typed.flags.aligned and all(step >= 0 and step % target.itemsize == 0 for step in typed.strides)
    # `copy=True` is needed, because NumPy calls an axis of length 1 contiguous whatever its stride.
    return typed if plain else np.array(typed, order="C", copy=True)
