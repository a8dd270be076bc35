"""Measured scores of an object's levels: statistics over the views, and curves fitted to them."""

from __future__ import annotations

import math
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
    """Solid angles (D,) of the bounding sphere in steradians, descending."""
    score: NDArray[np.float64]
    """Percentile or mean of SSIM over all views (K, D); NaN at sizes skipped because the level looked like the base."""
    views: NDArray[np.float32] | None = None
    """SSIM of each view (K, D, V), ordered from the object's front to its back, or by published axis; NaN for views
    that were not needed."""

    @property
    def filled(self) -> NDArray[np.float64]:
        """`score` (K, D) for the curve fit: skipped sizes repeat the last score before them."""
        is_known = ~np.isnan(self.score)
        last = np.maximum.accumulate(np.where(is_known, np.arange(len(self.sigma)), 0), axis=1)
        return np.take_along_axis(self.score, last, axis=1)

    def __repr__(self) -> str:
        return f"Samples({self.score.shape[0]} levels, {self.score.shape[1]} sizes)"


def check_percentile(percentile: float | Mean) -> float | Mean:
    """Check a percentile, or "mean"; ValueError or TypeError for other values."""
    if not isinstance(percentile, str):
        return check.in_range("percentile", percentile, 0.0, 100.0)
    if percentile not in get_args(Mean):
        raise ValueError(
            f'percentile: expected a number from 0 to 100, or "mean", got {check.value_or_type(percentile)}'
        )
    return percentile


def of_views(scores: NDArray[Any], percentile: float | Mean) -> NDArray[np.float64]:
    """Reduce scores (…, V) to a percentile of the measured views, or their mean (…); NaN where none is measured."""
    statistics = np.full(scores.shape[:-1], np.nan)
    for place in np.ndindex(statistics.shape):
        views = scores[place]
        measured = views[np.isfinite(views)].astype(np.float64)
        if measured.size:
            statistics[place] = (
                measured.mean()
                if isinstance(percentile, str)
                else np.percentile(measured, percentile, method="averaged_inverted_cdf")
            )
    return statistics


def standard_errors(scores: NDArray[Any], percentile: float | Mean, count: int) -> NDArray[np.float64]:
    """Standard errors (…) of the statistic from scores (…, V) of a random subset of `count` views; 0 for all views.

    The error of a percentile is half the difference between the quantiles that lie one standard deviation of the
    binomial distribution above and below it (Woodruff 1952, Confidence intervals for medians and other position
    measures).
    """
    known = scores.shape[-1]
    if known >= count:
        return np.zeros(scores.shape[:-1])
    share = math.sqrt((1 - known / count) / known)
    views = scores.astype(np.float64)
    if isinstance(percentile, str):
        return np.asarray(share * views.std(axis=-1, ddof=1))
    p = percentile / 100
    deviation = share * math.sqrt(max(p * (1 - p), 1 / known))
    low, high = np.quantile(views, (max(0.0, p - deviation), min(1.0, p + deviation)), axis=-1)
    return np.asarray((high - low) / 2)


def curves_through(samples: Samples) -> Curve4PL:
    """Fit a falling curve for each level but the base, to the least score at each size and all smaller ones.

    SSIM of many levels falls and rises again as they get smaller. By the least score, a level that is good enough at a
    size is also good enough at all smaller sizes, so no object gets a finer level as it shrinks.
    """
    scores = _least_of_smaller(samples.filled[1:])
    return cautious(fit_4pl(samples.sigma, scores), scores)


def mean_curves_through(samples: Samples) -> tuple[Curve4PL, Curve4PL]:
    """Fit the sum of two curves to the mean scores over the views, for each level but the base.

    The first curve is fitted to the least score at each size and all smaller ones, the second one to the remainder,
    which rises with size.
    """
    scores = replace(samples, score=of_views(np.asarray(samples.views), "mean")).filled[1:]
    falling = fit_4pl(samples.sigma, _least_of_smaller(scores))
    return falling, fit_4pl(samples.sigma, scores - falling(samples.sigma))


def _least_of_smaller(scores: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the least score (K, D) at each size and all smaller ones, for descending sizes."""
    return np.minimum.accumulate(scores[:, ::-1], axis=1)[:, ::-1]


def cautious(curves: Curve4PL, scores: NDArray[np.float64]) -> Curve4PL:
    """Lower flat curves to their least score: the fitted mean exceeds the scores at some sizes."""
    is_flat = curves.status == "flat"
    least = scores.min(axis=1)
    return replace(curves, a=np.where(is_flat, least, curves.a), d=np.where(is_flat, least, curves.d))
