"""Windows, constants and conventions of structural similarity, checked."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._metrics.inputs import Pair

WINDOWS = ("gaussian", "uniform", "global")
"""Names of the windows that `ssim` describes."""

CONVENTIONS = ("wang", "wang-downsampled", "skimage", "full")
"""Names of the conventions that `ssim` describes."""

MASKINGS = ("mean", "windows")
"""Names of the maskings that `ssim` describes."""

_CONSTANTS = (1e-140, 1e140)
"""Least and greatest constants c1 and c2 whose product float64 holds with all digits."""


@dataclass(frozen=True)
class Window:
    """Settings of the windows and constants of the similarity, checked."""

    name: str
    size: int
    sigma: float
    k1: float
    k2: float
    convention: str = "wang"
    masking: str = "mean"
    masked: bool = False

    def __post_init__(self) -> None:
        check.choice("window", self.name, WINDOWS)
        convention = check.choice("convention", self.convention, CONVENTIONS)
        check.choice("masking", self.masking, MASKINGS)
        if self.masking == "windows" and not self.masked:
            raise ValueError("masking: expected a mask with 'windows', got none")
        if self.masking == "windows" and convention in ("skimage", "wang-downsampled"):
            reason = "knows no masked windows" if convention == "skimage" else "makes pictures smaller without the mask"
            raise ValueError(f"masking: expected 'mean' with convention={convention!r}, which {reason}, got 'windows'")
        least = 2 if convention == "skimage" and self.name != "global" else 1
        object.__setattr__(self, "size", check.integer("size", self.size, least, 10_001))
        for name in ("sigma", "k1", "k2"):
            object.__setattr__(self, name, check.positive(name, getattr(self, name)))

    def shrink(self, height: int, width: int) -> int:
        """Factor of the downsampling before the comparison: to about 256 pixels for "wang-downsampled", else 1."""
        if self.convention != "wang-downsampled":
            return 1
        return max(1, math.floor(min(height, width) / 256 + 0.5))

    def settings(self, pair: Pair) -> _core._Settings:
        """Return the kernel's settings, which are the same for every pair of a comparison."""
        height, width = pair.reference.shape[-2:]
        extent = pair.extent()
        # Products overflow to infinity; powers would raise.
        c1, c2 = (k * extent * k * extent for k in (self.k1, self.k2))
        if not _CONSTANTS[0] <= min(c1, c2) <= max(c1, c2) <= _CONSTANTS[1]:
            raise ValueError(
                f"data_range, k1, k2: expected squares of k1 data_range and k2 data_range from {_CONSTANTS[0]:g} to "
                f"{_CONSTANTS[1]:g}, got {c1:g} and {c2:g}"
            )
        if self.convention == "skimage":
            # Sample covariances are N/(N − 1) times the population's; dividing c2 by that factor has the same effect.
            count = height * width if self.name == "global" else self.size**2
            c2 *= (count - 1) / count if count > 1 else 1.0
        factor = self.shrink(height, width)
        return (
            self.name,
            self.size,
            self.sigma,
            (c1, c2),
            factor,
            self.convention == "full",
            self.masking == "windows",
            pair.may_exceed,
        )

    def covered_pixels(self, mask: NDArray[Any], height: int, width: int) -> NDArray[np.bool_]:
        """Pixels of a picture (H, W) within the windows that a mask selects, which is downsampled like the picture."""
        named: NDArray[np.bool_] = mask != 0
        if self.masking == "windows":
            return named
        if self.name == "global":
            return np.full((height, width), named.any())
        before, after = self.size // 2, self.size - 1 - self.size // 2
        counted = named
        if self.convention != "full" and min(named.shape) >= self.size:
            counted = np.zeros_like(named)
            inside = tuple(slice(before, length - after) for length in named.shape)
            counted[inside] = named[inside]
        for axis in (0, 1):
            counted = _reached(counted, before, after, axis)
        factor = self.shrink(height, width)
        if factor == 1:
            return counted
        # Boxes of the downsampling begin before the pixel that has their mean.
        rows, columns = (
            np.minimum((np.arange(length) + (factor - 1) // 2) // factor, small - 1)
            for length, small in zip((height, width), counted.shape, strict=True)
        )
        return np.asarray(counted[rows[:, None], columns])


def _reached(counted: NDArray[np.bool_], before: int, after: int, axis: int) -> NDArray[np.bool_]:
    """Pixels along an axis that lie in the window around any counted pixel."""
    length = counted.shape[axis]
    total = np.insert(np.cumsum(counted, axis=axis), 0, 0, axis=axis)
    place = np.arange(length)
    last, first = np.minimum(place + before + 1, length), np.maximum(place - after, 0)
    return np.asarray(np.take(total, last, axis=axis) > np.take(total, first, axis=axis))
