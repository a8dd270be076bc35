"""Measured scores of an object's levels, to which curves are fitted."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, eq=False, repr=False)
class Samples:
    """Scores of K levels, the base among them, at D sizes."""

    sigma: NDArray[np.float64]
    """Solid angles (D,) of the bounding sphere in steradians, falling: 1/16 of the screen first."""
    score: NDArray[np.float64]
    """The percentile or mean of SSIM over all views (K, D); NaN where a level looked like the base before."""
    views: NDArray[np.float32] | None = None
    """SSIM of each view (K, D, V): from the front of the object to its back, or about one published axis after the
    other."""

    @property
    def filled(self) -> NDArray[np.float64]:
        """`score` (K, D) to which curves are fitted: sizes that were skipped have the last score before them."""
        known = ~np.isnan(self.score)
        last = np.maximum.accumulate(np.where(known, np.arange(len(self.sigma)), 0), axis=1)
        return np.take_along_axis(self.score, last, axis=1)

    def __repr__(self) -> str:
        return f"Samples({self.score.shape[0]} levels, {self.score.shape[1]} sizes)"
