"""Compares a picture with the ground truth by all metrics at once, for command line, benchmarks and notebooks."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar._render.frame import Frame
from nearfar.metrics._discontinuity import boundary_mask, discontinuity
from nearfar.metrics._perceptual import flip
from nearfar.metrics._pixel_errors import psnr, rmse
from nearfar.metrics._similarity import ssim

VISIBLE = 8
"""Least difference in 8-bit codes (of 255) at which a pixel counts as visibly different."""


@dataclass(frozen=True, eq=False, kw_only=True)
class Comparison:
    """Errors of a picture against the ground truth, and its discontinuity; the result of `compare`.

    A mean over no pixels is None.
    """

    psnr: float
    """Peak signal-to-noise ratio of the sRGB-encoded Rec. 709 luma, decibels; infinite for equal pictures."""
    ssim: float
    """Structural similarity of the same luma, with Gaussian windows."""
    rmse: float
    """Root mean square error of the same luma, 0 to 1."""
    flip: float | None
    """Mean FLIP error with default settings, 0 to 1; None without the package flip-evaluator."""
    discontinuity: float | None
    """Mean of `torn`."""
    discontinuity_p99: float | None
    """99th percentile of `torn`."""
    boundary_discontinuity: float | None
    """Mean of |`torn`| over the pixels along the boundary of the near part."""
    boundary_pixels: int
    """Number of pixels along that boundary at which the discontinuity is defined."""
    torn: NDArray[np.float32]
    """Discontinuity of each pixel (H, W); NaN where it is undefined."""


def compare(reference: Frame, test: Frame, *, center: ArrayLike, radius: float) -> Comparison:
    """Compare a picture of a reduced scene with the ground truth.

    The result has the values of `ssim`, `psnr`, `rmse` and `discontinuity` with default settings, and the discontinuity
    within the `boundary_mask`. ValueError and TypeError for frames without these channels or of different sizes, and
    arguments out of range. Sources: Wang, Bovik, Sheikh, Simoncelli (2004); Popescu, Lee, Choi, Fahmy (2022), Eq. 5–6.

    Parameters
    ----------
    reference
        The ground truth, with `color`.
    test
        The picture, with `color` and `position`, from the same camera.
    center
        World position O of the reduction, metres.
    radius
        Distance from the vertical axis through O at which near geometry ends, metres: r2 of the reduction.
    """
    check.instance("reference", reference, Frame)
    check.instance("test", test, Frame)
    torn = discontinuity(test)
    defined = torn[~np.isnan(torn)]
    edge = boundary_mask(test, center=center, radius=radius) & ~np.isnan(torn)
    return Comparison(
        psnr=psnr(reference, test),
        ssim=ssim(reference, test),
        rmse=rmse(reference, test),
        flip=_flip_or_none(reference, test),
        discontinuity=float(defined.mean()) if defined.size else None,
        discontinuity_p99=float(np.percentile(defined, 99)) if defined.size else None,
        boundary_discontinuity=float(np.abs(torn[edge]).mean()) if edge.any() else None,
        boundary_pixels=int(edge.sum()),
        torn=torn,
    )


def _flip_or_none(reference: Frame, test: Frame) -> float | None:
    """Return the mean of FLIP; None if its package is missing or cannot be imported."""
    try:
        return flip(reference, test)
    except ImportError:
        return None


def visible_difference(reference: NDArray[np.uint8], test: NDArray[np.uint8]) -> tuple[int, float, float]:
    """Count the pixels of two 8-bit sRGB pictures (H, W, 3) that differ by at least `VISIBLE` codes in a channel.

    Returns their number, its share of all pixels, and the root mean square error of all values, 0 to 1.
    """
    error = np.abs(reference.astype(np.int16) - test)
    pixels = int((error.max(axis=-1) >= VISIBLE).sum())
    return pixels, pixels / error[..., 0].size, float(np.sqrt(np.mean(error.astype(np.float64) ** 2)) / 255.0)
