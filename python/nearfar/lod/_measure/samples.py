"""Measured scores of an object's levels, the input of the curve fit."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, eq=False, repr=False)
class Samples:
    """Scores of K levels, including the base, at D sizes."""

    sigma: NDArray[np.float64]
    """Solid angles (D,) of the bounding sphere in steradians, descending: 1/16 of the screen first."""
    score: NDArray[np.float64]
    """Percentile or mean of SSIM over all views (K, D); NaN at sizes skipped because the level looked like the base."""
    views: NDArray[np.float32] | None = None
    """SSIM of each view (K, D, V): ordered from the object's front to its back, or by published axis."""

    @property
    def filled(self) -> NDArray[np.float64]:
        """`score` (K, D) for the curve fit: skipped sizes repeat the last score before them."""
        known = ~np.isnan(self.score)
        last = np.maximum.accumulate(np.where(known, np.arange(len(self.sigma)), 0), axis=1)
        return np.take_along_axis(self.score, last, axis=1)

    def __repr__(self) -> str:
        return f"Samples({self.score.shape[0]} levels, {self.score.shape[1]} sizes)"
