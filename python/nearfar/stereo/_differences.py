"""Differences between an eye's picture and plain stereo."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nearfar._render.frame import Frame
from nearfar.metrics._pixel_errors import psnr
from nearfar.metrics._similarity import ssim

_CONTRAST = 10.0
"""Factor by which dissimilarity is brightened in pictures."""


@dataclass(frozen=True, eq=False, kw_only=True)
class EyeDifference:
    """Differences between plain stereo and the hybrid picture of one eye, computed from sRGB codes."""

    ssim: float
    """Structural similarity, in windows of 4 × 4 pixels as in Fink et al. 2019."""
    psnr: float
    """Peak signal-to-noise ratio, decibels; infinite for equal pictures."""
    codes: NDArray[np.float32]
    """Greatest difference of a channel (H, W), sRGB codes."""
    dissimilarity: NDArray[np.float64]
    """Mean of 1 − SSIM over the channels (H, W)."""

    @property
    def picture(self) -> NDArray[np.uint8]:
        """Grey picture (2H, W): `codes` above `dissimilarity` × 10."""
        dissimilar = 255.0 * np.clip(_CONTRAST * self.dissimilarity, 0.0, 1.0)
        return np.concatenate([self.codes, dissimilar]).astype(np.uint8)


def compare_eye(plain: Frame, hybrid: Frame) -> EyeDifference:
    """Compare one eye's hybrid picture with plain stereo."""
    codes = plain.to_image(), hybrid.to_image()
    similarity = ssim(*codes, data_range=255.0, window="uniform", size=4, convention="full", full=True)
    return EyeDifference(
        ssim=float(similarity),
        psnr=psnr(*codes, data_range=255.0),
        codes=np.abs(np.subtract(*codes, dtype=np.float32)).max(axis=-1),
        dissimilarity=1.0 - similarity.map.mean(axis=-1),
    )
