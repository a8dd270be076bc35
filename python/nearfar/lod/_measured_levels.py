"""Levels of one object with their measured curves: the data for selection and files."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar._base.settings import set_fields
from nearfar.lod._levels import Levels, level_numbers, pick_levels
from nearfar.lod._measure import statistic
from nearfar.lod._measure.fit import Curve4PL
from nearfar.lod._measure.statistic import Samples

MAX_SCORE = 1e100
"""Greatest score of a curve, so that budgets' sums of weighted scores stay finite. SSIM is at most 1."""


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class MeasuredLevels:
    """The data of a `LodModel`, which documents the fields.

    It is a separate class so that selectors and files, which `LodModel` uses, can use it without an import cycle.
    """

    triangles: NDArray[np.int64]
    curves: Curve4PL
    center: NDArray[np.float64] = field(default_factory=lambda: np.zeros(3))
    radius: float = 1.0
    sigma: tuple[float, float] = (0.0, 4 * math.pi)
    errors: NDArray[np.float64] = field(default_factory=lambda: np.empty(0))
    pixel: float | None = None
    name: str = "object"
    levels: Levels | None = None
    measured: dict[str, Any] = field(default_factory=dict)
    samples: Samples | None = None

    def __post_init__(self) -> None:
        triangles = check.counts("triangles", self.triangles)
        if triangles.ndim != 1 or not triangles.size or triangles.min() < 1:
            got = f"shape {triangles.shape}" if triangles.ndim != 1 else check.value_or_type(triangles.tolist())
            raise ValueError(f"triangles: expected at least one for each level (K,), got {got}")
        errors = check.array("errors", self.errors, columns=None, dtype=np.float64, finite=True)
        if not errors.size:
            errors = np.zeros(len(triangles))
        if errors.shape != triangles.shape:
            raise ValueError(f"errors: expected shape {triangles.shape}, one for each level, got {errors.shape}")
        sigma = check.array("sigma", self.sigma, columns=None, dtype=np.float64)
        if sigma.shape != (2,) or not 0.0 <= sigma[0] <= sigma[1]:
            raise ValueError(
                f"sigma: expected the least and the greatest solid angle, got {check.value_or_type(sigma.tolist())}"
            )
        check.instance("curves", self.curves, Curve4PL)
        curves = self.curves if self.curves.is_many else _as_many(self.curves)
        if len(curves) != len(triangles) - 1:
            raise ValueError(
                f"curves: expected {len(triangles) - 1}, one for each level but level 0, got {len(curves)}"
            )
        greatest = np.abs([curves.a, curves.d]).max(initial=0.0, where=np.isfinite([curves.a, curves.d]))
        if greatest > MAX_SCORE:
            raise ValueError(f"curves: expected scores a and d of at most {MAX_SCORE:g}, got {greatest:g}")
        check.instance("measured", self.measured, dict)
        if self.levels is not None:
            check.instance("levels", self.levels, Levels, "Levels")
        if self.samples is not None:
            shape = check.instance("samples", self.samples, Samples, "Samples").score.shape
            if shape != (len(triangles), len(self.samples.sigma)):
                expected = f"scores of {len(triangles)} levels at {len(self.samples.sigma)} sizes"
                raise ValueError(f"samples: expected {expected}, got shape {shape}")
        set_fields(
            self,
            triangles=triangles,
            curves=curves,
            errors=errors,
            sigma=(float(sigma[0]), float(sigma[1])),
            center=np.array(check.vector("center", self.center)),
            radius=check.positive("radius", self.radius),
            pixel=None if self.pixel is None else check.positive("pixel", self.pixel),
            name=check.text("name", self.name),
        )

    @cached_property
    def mean_curves(self) -> tuple[Curve4PL, NDArray[np.float64]]:
        """Curves of the mean score over the views, for budgets, and parameters (K − 1, 4) of curves to add to them.

        Without scores of single views, these are `curves` and curves that are 0 everywhere.
        """
        nothing = np.tile((0.0, 1.0, 1.0, 0.0), (len(self.curves), 1))
        if self.samples is None or self.samples.views is None or not len(self.curves):
            return self.curves, nothing
        curves, rises = statistic.mean_curves_through(self.samples)
        return curves, np.where(np.isnan(rises.rows), nothing, rises.rows)

    @cached_property
    def falling_curves(self) -> Curve4PL:
        """Curves for thresholds, one for each level except level 0: the least score at a size and all smaller ones.

        A curve that rises with size becomes constant, at its value at the least measured size.
        """
        curves = self.curves
        least = curves(np.array([self.sigma[0]]))[:, 0]
        rises = np.asarray(curves.a) < np.asarray(curves.d)
        return replace(curves, a=np.where(rises, least, curves.a), d=np.where(rises, least, curves.d))

    def of_levels(self, numbers: ArrayLike) -> Self:
        """Return the model with some of its levels, by ascending numbers (N,) that start with 0."""
        numbers = level_numbers("numbers", numbers, len(self))
        samples = self.samples
        if samples is not None:
            views = None if samples.views is None else samples.views[numbers]
            samples = replace(samples, score=samples.score[numbers], views=views)
        return replace(
            self,
            triangles=self.triangles[numbers],
            curves=self.curves[numbers[1:] - 1],
            errors=self.errors[numbers],
            levels=None if self.levels is None else pick_levels(self.levels, numbers.tolist()),
            samples=samples,
        )

    def __len__(self) -> int:
        """Return the number of levels, level 0 included."""
        return len(self.triangles)


def _as_many(curve: Curve4PL) -> Curve4PL:
    """Convert a single curve to an array of one."""
    parts = (*curve, curve.rms, curve.status, curve.reason)
    return Curve4PL(*(np.atleast_1d(np.asarray(part)) for part in parts))
