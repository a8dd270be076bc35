"""Measurement of the levels of one object: scores by size and view, the levels worth keeping, and their curves."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check, progress
from nearfar._render.renderer import Renderer
from nearfar.lod._levels import Levels
from nearfar.lod._measure.fit import Curve4PL, fit_4pl
from nearfar.lod._measure.samples import Samples
from nearfar.lod._measure.score_cache import ScoreCache, content
from nearfar.lod._measure.scores import Compared, scores
from nearfar.lod._measure.settings import MeasureSettings
from nearfar.lod._measure.views import AXES, Stand, turns
from nearfar.lod._model import LodModel

MAX_BLOCK_PIXELS = 1 << 20
"""Pixels of a block of views. Two pictures of each and every level's mask are in memory, and Ctrl-C loses one level's
scores of a block."""

STEPPED_SIZES = 4
"""Sizes at which levels are kept by steps. SSIM of bumpy things dips where they are smaller, and a level that is good
enough at 1/16 of the screen is not there: without a finer one that is, the base would be shown at all sizes."""

STEP_TOLERANCE = 1e-9
"""Share of a step by which a score may miss it: 0.95, which no binary number is, counts as one step of 0.05 below 1."""


def measure_one(levels: Levels, report: progress.Report, *, settings: MeasureSettings) -> tuple[LodModel, list[int]]:
    """Return a model without geometry, and the numbers of the levels that it keeps; the base is one of them."""
    return _Measurement(levels, settings, report).run()


def kept_scores(levels: Levels, settings: MeasureSettings) -> tuple[int, int]:
    """Count the scores that the cache has, and those that there would be if each level were measured at each size."""
    if len(levels) < 2 or not levels.radius > 0.0:
        return 0, 0
    measurement = _Measurement(levels, settings, lambda _done, _total: None)
    measurement.prepare()
    scores = measurement.scores[~measurement.is_base]
    return int(np.isfinite(scores).sum()), scores.size


class _Measurement:
    """Scores of K levels at D sizes from V different turns, and which of them are known."""

    def __init__(self, levels: Levels, settings: MeasureSettings, report: progress.Report) -> None:
        if not levels.radius > 0.0:
            raise ValueError(f"levels: expected a base that is more than a point, got radius {levels.radius}")
        self.levels, self.settings, self.report = levels, settings, report
        self.renders = self.comparisons = 0
        self.screen = settings.screen
        self.stand = Stand(self.screen, check.vector("center", levels.center), levels.radius, _reach(levels))
        self.turns, self.turn_of_view = turns(settings.views)
        self.sizes = range(1, settings.distances + 1)
        self.scores = np.full((len(levels), settings.distances, len(self.turns)), np.nan)
        self.scores[0] = 1.0
        self.is_measured = np.zeros(self.scores.shape[:2], bool)
        self.is_measured[0] = True
        self.is_base = np.arange(len(levels)) == 0
        self.backend = self.device = "cpu"
        self.cache: ScoreCache | None = None

    def run(self) -> tuple[LodModel, list[int]]:
        """Measure all that is not known; return the model and the levels that it keeps."""
        kept = list(range(len(self.levels)))
        if len(self.levels) > 1:
            self.prepare()
            try:
                kept = self._measure()
            finally:
                # Ctrl-C keeps the scores that are there.
                if self.cache is not None:
                    self.cache.save()
        return self._model(kept), kept

    def prepare(self) -> None:
        """Decide on which device pictures are made, once for all levels, and load the scores that are known."""
        base = self.levels[0].scene
        device = Renderer(base, ("color", "range"), self.settings.samples).device(self.settings.backend)
        if device is not None:
            self.backend, self.device = "gpu", device.label
        contents = [content(level.scene) for level in self.levels]
        self.is_base[:] = [one == contents[0] for one in contents]
        self.scores[self.is_base] = 1.0
        if self.settings.cache:
            screen, stand = self.screen, self.stand
            place = (stand.center, stand.radius, screen.tan_half_angle, screen.pixel, screen.size)
            pictured = (self.settings.views, self.settings.samples, self.device)
            self.cache = ScoreCache(contents, (*place, *pictured), self.scores)

    def _measure(self) -> list[int]:
        """Go from near to far; returns the levels that are kept, which the first sizes decide."""
        kept, measured = {0}, list(range(1, len(self.levels)))
        streaks = np.zeros(len(self.levels), int)
        for size in self.sizes:
            self._fill(size, measured)
            self.is_measured[measured, size - 1] = True
            percentiles = self._percentiles(size)
            if size <= STEPPED_SIZES:
                # Levels that are measured no further look like the base.
                known = self.is_measured[:, size - 1]
                kept.update(coarsest_of_steps(np.where(known, percentiles, 1.0), self.settings.step))
            if size == STEPPED_SIZES:
                measured = [number for number in measured if number in kept]
            if self.settings.saturated is not None:
                streaks = np.where(percentiles >= self.settings.saturated, streaks + 1, 0)
                measured = [number for number in measured if streaks[number] < 2 or self.is_base[number]]
        return sorted(kept)

    def _percentiles(self, size: int) -> NDArray[np.float64]:
        """The percentile over the views (K,); NaN for levels that were measured no further."""
        scores_of_views = self.scores[:, size - 1][:, self.turn_of_view]
        percentiles = np.full(len(scores_of_views), np.nan)
        known = self.is_measured[:, size - 1]
        percentiles[known] = np.percentile(
            scores_of_views[known], self.settings.percentile, axis=1, method="averaged_inverted_cdf"
        )
        return percentiles

    def _fill(self, size: int, measured: list[int]) -> None:
        """Score levels at a size where no score is known, by blocks of views."""
        table = self.scores[:, size - 1]
        first, end, top, bottom = self.stand.box(size)
        block = max(1, MAX_BLOCK_PIXELS // ((end - first) * (bottom - top)))
        missing = np.flatnonzero(np.isnan(table[measured]).any(axis=0)) if measured else np.empty(0, int)
        for start in range(0, len(missing), block):
            views = missing[start : start + block]
            new = {number: np.flatnonzero(np.isnan(table[number, views])) for number in measured}
            new = {number: places for number, places in new.items() if len(places)}
            cameras = [self.stand.camera(size, self.turns[view]) for view in views]
            compared = [Compared(self.levels[number].scene, places) for number, places in new.items()]
            found = scores(self.levels[0].scene, compared, cameras, self.settings.samples, self.backend)
            self.renders += len(views)
            for order, number in enumerate(new):
                share = start + len(views) * order / len(new)
                self.report(*self._progress(size, share / len(missing), len(measured)))
                table[number, views[new[number]]] = next(found)
                self.comparisons += len(new[number])
                self.renders += len(new[number])
            if self.cache is not None:
                self.cache.save_at_times()

    def _progress(self, size: int, share: float, measured: int) -> tuple[int, int]:
        """Pixels rendered and pixels in all, if no level that is measured now is left out later."""
        boxes = [self.stand.box(number) for number in self.sizes]
        pixels = [(end - first) * (bottom - top) * (measured + 1) for first, end, top, bottom in boxes]
        return int(sum(pixels[: size - 1]) + share * pixels[size - 1]), sum(pixels)

    def _model(self, kept: list[int]) -> LodModel:
        sigma = np.array([self.stand.sigma(size) for size in self.sizes])
        score = np.stack([self._percentiles(size) for size in self.sizes], axis=1)
        views = np.where(self.is_measured[..., None], self.scores[..., self.turn_of_view], np.nan)
        samples = Samples(sigma, score[kept], views[kept].astype(np.float32))
        # Levels fall to their curve's plateau, and sizes that are not measured look no worse than those that are.
        curves = _cautious(fit_4pl(sigma, samples.filled[1:]), samples.filled[1:])
        return LodModel(
            triangles=np.array([self.levels[number].triangle_count for number in kept]),
            curves=curves,
            center=self.levels.center,
            radius=self.levels.radius,
            sigma=(float(sigma[-1]), float(sigma[0])),
            errors=np.array([self.levels[number].error for number in kept]),
            name=self.levels.name,
            samples=samples,
            measured=self._record(kept, score[:, 0]),
        )

    def _record(self, kept: list[int], first: NDArray[np.float64]) -> dict[str, Any]:
        """Settings and work as JSON, and the levels that are left out with their scores at the first size."""
        settings = self.settings
        most = (len(self.levels) - 1) * settings.distances * settings.views
        cached = int(self.is_measured[~self.is_base].sum()) * len(self.turns) - self.comparisons
        left_out = [number for number in range(len(self.levels)) if number not in kept]
        return {
            "tan_half_angle": self.screen.tan_half_angle,
            "pixel": self.screen.pixel,
            "size": list(self.screen.size),
            "axes": [list(axis) for axis in AXES],
            "views": settings.views,
            "distances": settings.distances,
            "percentile": settings.percentile,
            "step": settings.step,
            "saturated": settings.saturated,
            "samples": settings.samples,
            "device": self.device,
            "left_out": [{"triangles": self.levels[n].triangle_count, "score": float(first[n])} for n in left_out],
            "renders": self.renders,
            "scores": self.comparisons,
            "cached": cached,
            "skipped": most - self.comparisons - cached,
        }


def coarsest_of_steps(score: NDArray[np.float64], step: float | None) -> list[int]:
    """Numbers of the levels to keep by their scores (K,): for each step down from 1 the coarsest that is above it.

    The base is always kept, and all are without a step.
    """
    if step is None:
        return list(range(len(score)))
    steps = np.maximum(1, np.ceil((1.0 - score) / step - STEP_TOLERANCE)).astype(int)
    kept = {0}
    for allowed in np.unique(steps[1:]):
        kept.add(int(np.flatnonzero(steps <= allowed)[-1]))
    return sorted(kept)


def _reach(levels: Levels) -> float:
    """Metres from the base's centre to the farthest corner of any level."""
    farthest = 0.0
    for level in levels:
        scene = level.scene
        corners = scene.triangles().reshape(-1, 3) + (scene.origin - levels.center)
        farthest = max(farthest, math.sqrt(float(np.einsum("ij,ij->i", corners, corners).max())))
    return farthest


def _cautious(curves: Curve4PL, scores: NDArray[np.float64]) -> Curve4PL:
    """Put flat curves at their least score: the mean that was fitted promises more than some sizes have shown."""
    if not len(scores):
        return curves
    is_flat = curves.status == "flat"
    least = scores.min(axis=1)
    return replace(curves, a=np.where(is_flat, least, curves.a), d=np.where(is_flat, least, curves.d))
