"""Windows, constants and conventions of structural similarity; its result, a number with an optional map."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Literal, TypedDict, get_args

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._base.settings import set_fields
from nearfar.metrics._inputs import Pair

Window = Literal["gaussian", "uniform", "global"]
Masking = Literal["mean", "windows"]
Convention = Literal["wang", "wang-downsampled", "skimage", "full"]

_CONSTANTS = (1e-140, 1e140)
"""Range of the constants c1 and c2 in which float64 represents their product with all digits."""


@dataclass(frozen=True, kw_only=True)
class SsimSettings:
    """Windows, constants and conventions of the structural similarity.

    ValueError and TypeError for settings out of range, and masked windows with "skimage" or "wang-downsampled".

    Parameters
    ----------
    window
        "gaussian", "uniform", or "global", which is one window over the whole picture.
    size
        Width and height of the window in pixels, 1 to 10,001. An even window extends one pixel further up and left.
        Except with "full" and masked windows, smaller pictures raise ValueError.
    sigma
        Standard deviation of the Gaussian, pixels, above 0.
    k1, k2
        Constants K₁ and K₂, above 0, which keep the similarity defined where means or variances vanish.
    masking
        "mean": the mask limits the mean. "windows": it also limits the windows: pixels outside the mask, and outside
        the picture, are ignored, and each window's remaining weights are scaled to the sum 1.
    convention
        "wang": windows that lie within the picture, as in Wang's ssim_index.m. "skimage": the same with sample
        covariances (N/(N − 1)), scikit-image's default. "full": all windows, with the picture mirrored at its borders.
        "wang-downsampled": "wang" after downsampling to about 256 pixels, as in Wang's ssim.m.
    """

    window: Window = "gaussian"
    size: int = 11
    sigma: float = 1.5
    k1: float = 0.01
    k2: float = 0.03
    masking: Masking = "mean"
    convention: Convention = "wang"

    def __post_init__(self) -> None:
        check.choice("window", self.window, get_args(Window))
        check.choice("masking", self.masking, get_args(Masking))
        convention = check.choice("convention", self.convention, get_args(Convention))
        if self.masking == "windows" and convention in ("skimage", "wang-downsampled"):
            reason = "has no masked windows" if convention == "skimage" else "downsamples pictures without the mask"
            raise ValueError(f"masking: expected 'mean' with convention={convention!r}, which {reason}, got 'windows'")
        least = 2 if convention == "skimage" and self.window != "global" else 1
        numbers = {name: check.positive(name, getattr(self, name)) for name in ("sigma", "k1", "k2")}
        set_fields(self, size=check.integer("size", self.size, least, 10_001), **numbers)

    def _require_mask(self, mask: object) -> None:
        """Raise ValueError for masked windows without a mask."""
        if mask is None and self.masking == "windows":
            raise ValueError("masking: expected a mask with 'windows', got none")

    def _shrink(self, height: int, width: int) -> int:
        """Return the factor by which to downsample pictures: to about 256 pixels for "wang-downsampled", else 1."""
        if self.convention != "wang-downsampled":
            return 1
        return max(1, math.floor(min(height, width) / 256 + 0.5))

    def _for_kernel(self, pair: Pair) -> _core._Settings:
        """Return the kernel's settings for all pairs of a comparison."""
        height, width = pair.reference.shape[-2:]
        factor, is_full, is_masked = self._shrink(height, width), self.convention == "full", self.masking == "windows"
        shorter = -(-min(height, width) // factor)
        if self.window != "global" and not is_full and not is_masked and self.size > shorter:
            raise ValueError(
                f"size: expected a window of at most {shorter} pixels, the pictures' shorter side, got {self.size}; "
                "windows of convention='full' reach beyond the pictures"
            )
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
            count = height * width if self.window == "global" else self.size**2
            c2 *= (count - 1) / count if count > 1 else 1.0
        return self.window, self.size, self.sigma, (c1, c2), factor, is_full, is_masked, pair.may_exceed

    def _covered_pixels(self, mask: NDArray[Any], height: int, width: int) -> NDArray[np.bool_]:
        """Find the pixels (H, W) in windows around the pixels of a mask, which is downsampled like the picture."""
        covered: NDArray[np.bool_] = mask != 0
        if self.masking == "windows":
            return covered
        if self.window == "global":
            return np.full((height, width), covered.any())
        before, after = self.size // 2, self.size - 1 - self.size // 2
        if self.convention != "full":
            inside = np.zeros_like(covered)
            inside[tuple(slice(before, length - after) for length in covered.shape)] = True
            covered &= inside
        for axis in (0, 1):
            covered = _dilate(covered, before, after, axis)
        factor = self._shrink(height, width)
        if factor == 1:
            return covered
        # A box that is averaged begins before the pixel that gets the mean.
        rows, columns = (
            np.minimum((np.arange(length) + (factor - 1) // 2) // factor, small - 1)
            for length, small in zip((height, width), covered.shape, strict=True)
        )
        return np.asarray(covered[rows[:, None], columns])


class SsimKeywords(TypedDict, total=False):
    """Fields of `SsimSettings` as keywords of `ssim`, `ssim_pairs` and `ms_ssim`; a test compares both."""

    window: Window
    size: int
    sigma: float
    k1: float
    k2: float
    masking: Masking
    convention: Convention


def _dilate(is_counted: NDArray[np.bool_], before: int, after: int, axis: int) -> NDArray[np.bool_]:
    """Find the pixels that lie, along an axis, in the window around any counted pixel."""
    length = is_counted.shape[axis]
    total = np.insert(np.cumsum(is_counted, axis=axis), 0, 0, axis=axis)
    pixel = np.arange(length)
    end, start = np.minimum(pixel + before + 1, length), np.maximum(pixel - after, 0)
    return np.asarray(np.take(total, end, axis=axis) > np.take(total, start, axis=axis))


class Similarity(float):
    """Mean structural similarity of two pictures: a float, with the similarity around each pixel on request.

    It unpacks to the mean and the map, as scikit-image's result does: ``mean, map = nf.ssim(a, b, full=True)``.
    """

    _map: NDArray[Any] | None

    def __new__(cls, mean: float, similarities: NDArray[Any] | None = None) -> Similarity:
        """Join a mean with its map."""
        similarity = super().__new__(cls, check.number("mean", mean, finite=False))
        similarity._map = similarities
        return similarity

    @property
    def map(self) -> NDArray[Any]:
        """Similarity around each pixel, in the picture's shape; ValueError unless it was asked for by `full=True`."""
        if self._map is None:
            raise ValueError("map: expected a similarity that was computed with full=True")
        return self._map

    def __iter__(self) -> Iterator[Any]:
        yield float(self)
        yield self.map

    def __reduce__(self) -> tuple[Any, ...]:
        return Similarity, (float(self), self._map)
