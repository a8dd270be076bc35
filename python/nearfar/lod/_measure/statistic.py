"""Measured scores of an object's levels: the statistic over views that is a score, and the curves through scores."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check
from nearfar.lod._measure.fit import Curve4PL, fit_4pl

Mean = Literal["mean"]


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
        is_known = ~np.isnan(self.score)
        last = np.maximum.accumulate(np.where(is_known, np.arange(len(self.sigma)), 0), axis=1)
        return np.take_along_axis(self.score, last, axis=1)

    def __repr__(self) -> str:
        return f"Samples({self.score.shape[0]} levels, {self.score.shape[1]} sizes)"


def check_percentile(percentile: float | Mean) -> float | Mean:
    """Check a percentile, or "mean"; ValueError or TypeError that names the argument otherwise."""
    if not isinstance(percentile, str):
        return check.in_range("percentile", percentile, 0.0, 100.0)
    if percentile not in get_args(Mean):
        raise ValueError(
            f'percentile: expected a number from 0 to 100, or "mean", got {check.value_or_type(percentile)}'
        )
    return percentile


def of_views(scores: NDArray[Any], percentile: float | Mean) -> NDArray[np.float64]:
    """Reduce scores (…, V) to a percentile of the views, or their mean (…); NaN where a view is unknown."""
    statistics = np.full(scores.shape[:-1], np.nan)
    is_known = np.isfinite(scores).all(axis=-1)
    # Contiguous rows are always summed in the same order, whatever array they come from.
    rows = np.ascontiguousarray(scores[is_known], np.float64)
    if isinstance(percentile, str):
        statistics[is_known] = rows.mean(axis=1)
    else:
        statistics[is_known] = np.percentile(rows, percentile, axis=1, method="averaged_inverted_cdf")
    return statistics


def curves_through(samples: Samples) -> Curve4PL:
    """Fit a curve to the scores of each level but the base."""
    scores = samples.filled[1:]
    # Levels decay to their curve's plateau; unmeasured sizes look no worse than measured ones.
    return cautious(fit_4pl(samples.sigma, scores), scores)


def cautious(curves: Curve4PL, scores: NDArray[np.float64]) -> Curve4PL:
    """Lower flat curves to their least score: the fitted mean promises more than some sizes have shown."""
    is_flat = curves.status == "flat"
    least = scores.min(axis=1)
    return replace(curves, a=np.where(is_flat, least, curves.a), d=np.where(is_flat, least, curves.d))
