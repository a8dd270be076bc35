"""Measures the levels of one object: chooses the levels to keep, and fits their curves."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import progress
from nearfar.lod._levels import Levels
from nearfar.lod._measure import statistic
from nearfar.lod._measure.score_table import ScoreTable
from nearfar.lod._measure.settings import MeasureSettings
from nearfar.lod._measure.statistic import Samples
from nearfar.lod._measure.views import AXES
from nearfar.lod._model import LodModel

STEPPED_SIZES = 4
"""Number of sizes at which levels are chosen by steps of their scores. SSIM of bumpy objects may fall as they get
smaller: a level that is good enough at 1/16 of the screen may be too coarse at the next sizes, where the base would be
shown if no finer level were kept."""

RECORDED = ("spacing", "distances", "standard_error", "percentile", "step", "saturated", "samples")
"""Settings in the record of a measurement, besides the screen and the views."""

LARGE_ERROR = 2.0
"""Factor of the allowed standard error above σ₁/₁₆, where pictures take the most time and only budgets use curves."""

SIZE_TOLERANCE = 1e-9
"""Relative tolerance for comparing sizes with σ₁/₁₆."""

STEP_TOLERANCE = 1e-9
"""Tolerance in steps: 0.95, which float64 rounds, is one step of 0.05 below 1."""


def measure_one(levels: Levels, report: progress.Report, *, settings: MeasureSettings) -> tuple[LodModel, list[int]]:
    """Return a model without geometry, and the numbers of its levels, which always include the base."""
    return _Measurement(ScoreTable(levels, settings, report)).run()


def count_scores(levels: Levels, settings: MeasureSettings) -> tuple[int, int]:
    """Count the cached scores, and the scores of a complete measurement."""
    if len(levels) < 2 or not levels.radius > 0.0:
        return 0, 0
    table = ScoreTable(levels, settings, lambda _done, _total: None)
    table.prepare()
    scores = table.scores[~table.is_base]
    return int(np.isfinite(scores).sum()), scores.size


class _Measurement:
    """Decides which levels are measured at which sizes from which views, and makes the model from their scores."""

    def __init__(self, table: ScoreTable) -> None:
        self.table, self.levels, self.settings = table, table.levels, table.settings
        self.is_measured = np.zeros(table.scores.shape, bool)
        self.is_measured[0] = True
        self.first_scores = np.full(len(self.levels), np.nan)
        """Scores (K,) at the first size at which levels are chosen; NaN where unknown."""

    def run(self) -> tuple[LodModel, list[int]]:
        """Measure the scores that are unknown; return the model and the numbers of its levels."""
        kept = list(range(len(self.levels)))
        if len(self.levels) > 1:
            self.table.prepare()
            try:
                if self.settings.step is not None:
                    kept = self._keep(self.settings.step)
                self._measure(kept)
            finally:
                # Also on Ctrl-C, to keep the scores found so far.
                if self.table.cache is not None:
                    self.table.cache.save()
        return self._model(kept), kept

    def _keep(self, step: float) -> list[int]:
        """Choose the levels by their scores at the first sizes up to σ₁/₁₆."""
        table, saturated = self.table, self.settings.saturated
        kept = {0}
        streaks = np.zeros(len(self.levels), int)
        limit = table.screen.reference_sine * (1 + SIZE_TOLERANCE)
        sizes = [size for size, sine in zip(table.sizes, table.orbit.sines, strict=True) if sine <= limit]
        # If all sizes are larger, the smallest one decides.
        sizes = sizes[:STEPPED_SIZES] or list(table.sizes[-1:])
        for size in sizes:
            scores = self._from_coarsest(size, step, streaks >= 2)
            if size == sizes[0]:
                self.first_scores = scores
            # Levels without a score look like the base, or are finer than one that is within a step of the base.
            kept.update(coarsest_of_steps(np.where(np.isnan(scores), 1.0, scores), step))
            if saturated is not None:
                streaks = np.where(scores >= saturated, streaks + 1, np.where(streaks < 2, 0, streaks))
        return sorted(kept)

    def _from_coarsest(self, size: int, step: float, is_like_base: NDArray[np.bool_]) -> NDArray[np.float64]:
        """Scores (K,) at a size, from the coarsest level up to the first within a step of the base; else NaN.

        Finer levels are never chosen, so they are not scored. A few turns predict the finest level that must be scored:
        then the base's pictures usually are made only once.
        """
        table, count = self.table, len(self.levels)
        # Levels that look like the base are within a step, so finer ones need no score.
        finest = max(1, int(np.flatnonzero(is_like_base)[-1]) + 1) if is_like_base.any() else 1
        pilot = table.subsets[0]
        table.fill(size, list(range(finest, count)), pilot)
        is_good = steps_below(table.percentiles(size, pilot), step) <= 1
        start = max(finest, int(np.flatnonzero(is_good)[-1]))
        scores = np.full(count, np.nan)
        while start < count:
            measured = list(range(start, count))
            scores[measured] = table.percentiles(size, self._fill(size, measured))[measured]
            if start == finest or (steps_below(scores[measured], step) <= 1).any():
                break
            start -= 1
        return scores

    def _fill(self, size: int, numbers: list[int]) -> NDArray[np.intp]:
        """Score levels at a size from more and more turns until the standard errors are small; return these turns."""
        table, limit = self.table, self.settings.standard_error
        if table.orbit.sines[size - 1] > table.screen.reference_sine * (1 + SIZE_TOLERANCE):
            limit *= LARGE_ERROR
        turns = table.subsets[-1]
        if numbers:
            for turns in table.subsets if limit > 0 else table.subsets[-1:]:
                table.fill(size, numbers, turns)
                if (table.standard_errors(size, turns)[numbers] <= limit).all():
                    break
        return turns

    def _measure(self, kept: list[int]) -> None:
        """Measure the kept levels at all sizes, from near to far."""
        table, streaks = self.table, np.zeros(len(self.levels), int)
        measured = kept[1:]
        for size in table.sizes:
            turns = self._fill(size, measured)
            for number in measured:
                self.is_measured[number, size - 1, turns] = True
            if self.settings.saturated is not None:
                streaks = np.where(table.percentiles(size, turns) >= self.settings.saturated, streaks + 1, 0)
                measured = [number for number in measured if streaks[number] < 2 or table.is_base[number]]

    def _model(self, kept: list[int]) -> LodModel:
        table = self.table
        sigma = np.array([table.orbit.sigma(size) for size in table.sizes])
        views = np.where(self.is_measured, table.scores, np.nan)[kept][..., table.turn_of_view]
        samples = Samples(sigma, statistic.of_views(views, self.settings.percentile), views)
        return LodModel(
            triangles=np.array([self.levels[number].triangle_count for number in kept]),
            curves=statistic.curves_through(samples),
            center=self.levels.center,
            radius=self.levels.radius,
            sigma=(float(sigma[-1]), float(sigma[0])),
            pixel=table.screen.pixel,
            errors=np.array([self.levels[number].error for number in kept]),
            name=self.levels.name,
            samples=samples,
            measured=self._record(kept),
        )

    def _record(self, kept: list[int]) -> dict[str, Any]:
        """Record of the settings, the work, and the levels left out with their scores at the first size, as JSON."""
        settings, screen = vars(self.settings), self.table.screen
        needed = (len(self.levels) - 1) * settings["distances"] * settings["views"]
        scored, cached = self.table.counts
        left_out = [number for number in range(len(self.levels)) if number not in kept]
        known_scores = [float(score) if np.isfinite(score) else None for score in self.first_scores]
        return {
            "tan_half_angle": screen.tan_half_angle,
            "pixel": screen.pixel,
            "size": list(screen.size),
            **{name: settings[name] for name in ("views", "directions")},
            "axes": [list(axis) for axis in AXES] if settings["directions"] == "published" else None,
            **{name: settings[name] for name in RECORDED},
            "device": self.table.device,
            "left_out": [{"triangles": self.levels[n].triangle_count, "score": known_scores[n]} for n in left_out],
            "renders": self.table.renders,
            "scores": scored,
            "cached": cached,
            "skipped": needed - scored - cached,
        }


def steps_below(score: NDArray[np.float64], step: float) -> NDArray[np.float64]:
    """Number of steps by which scores (K,) are below 1, at least 1; NaN for NaN."""
    return np.maximum(1.0, np.ceil((1.0 - score) / step - STEP_TOLERANCE))


def coarsest_of_steps(score: NDArray[np.float64], step: float) -> list[int]:
    """Numbers of the levels to keep: the base, and the coarsest level within 1, 2, … steps below 1, by scores (K,)."""
    steps = steps_below(score, step)
    return sorted({0, *(int(np.flatnonzero(steps <= allowed)[-1]) for allowed in np.unique(steps[1:]))})
