"""A picture beside the truth by all measures at once: what the command line, benchmarks and notebooks report."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._metrics.discontinuity import boundary, discontinuity
from nearfar._metrics.pixel_errors import psnr, rmse
from nearfar._metrics.similarity import ssim
from nearfar._render.frame import Frame

VISIBLE = 8
"""Levels of 255 from which a pixel counts as different from the truth."""


@dataclass(frozen=True, eq=False, kw_only=True)
class Comparison:
    """How far a picture is from the truth, and how far it is torn; `compare` makes it.

    Means are None where the picture has no pixel that they are taken over.
    """

    psnr: float
    """Decibels, of the sRGB-encoded Rec. 709 luma; infinite for equal pictures."""
    ssim: float
    """Gaussian windows, of the same luma."""
    rmse: float
    """Root mean square of the same luma's error, 0 to 1."""
    discontinuity: float | None
    """Mean of `torn`."""
    discontinuity_p99: float | None
    """99th percentile of `torn`."""
    boundary: float | None
    """Mean of |`torn`| over the pixels along the boundary."""
    boundary_pixels: int
    """Pixels along the boundary that have a discontinuity."""
    torn: NDArray[np.float32]
    """Discontinuity of each pixel (H, W); NaN where it has none."""


def compare(reference: Frame, test: Frame, *, center: ArrayLike, radius: float) -> Comparison:
    """Measure a picture of a reduced scene beside the truth.

    Parameters
    ----------
    reference
        The truth, with `color`.
    test
        The picture, with `color` and `position`, from the same camera.
    center
        World position O, metres, of the reduction.
    radius
        Metres from O's axis at which near geometry ends: r2 of the reduction.

    Returns
    -------
    Comparison
        Similarity, pixel errors and discontinuity in their default conventions (`ssim`, `psnr`, `rmse`,
        `discontinuity`), and discontinuity along the `boundary`.

    Raises
    ------
    ValueError, TypeError
        For frames without these channels or of two sizes, and arguments out of their domains.

    References
    ----------
    Wang, Bovik, Sheikh, Simoncelli (2004); Popescu, Lee, Choi, Fahmy (2022), Eq. 5–6.
    """
    torn = discontinuity(test)
    known = torn[~np.isnan(torn)]
    edge = boundary(test, center=center, radius=radius) & ~np.isnan(torn)
    return Comparison(
        psnr=psnr(reference, test),
        ssim=ssim(reference, test),
        rmse=rmse(reference, test),
        discontinuity=float(known.mean()) if known.size else None,
        discontinuity_p99=float(np.percentile(known, 99)) if known.size else None,
        boundary=float(np.abs(torn[edge]).mean()) if edge.any() else None,
        boundary_pixels=int(edge.sum()),
        torn=torn,
    )


def visible_difference(reference: NDArray[np.uint8], test: NDArray[np.uint8]) -> tuple[int, float, float]:
    """Count the pixels of two sRGB pictures (H, W, 3) of 8 bits that differ by `VISIBLE` levels or more.

    Returns
    -------
    pixels, share, rmse
        The count, its share of all pixels, and the root mean square error of all values, 0 to 1.
    """
    error = np.abs(reference.astype(np.int16) - test)
    pixels = int((error.max(axis=-1) >= VISIBLE).sum())
    return pixels, pixels / error[..., 0].size, float(np.sqrt(np.mean(error.astype(np.float64) ** 2)) / 255.0)
