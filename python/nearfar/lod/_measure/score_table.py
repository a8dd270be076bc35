"""Table of the scores of one object's levels by size and view; measures scores that are unknown."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nearfar._base import progress
from nearfar._render.backend import Backend
from nearfar._render.renderer import Renderer
from nearfar._render.settings import RenderSettings
from nearfar.lod._levels import Levels
from nearfar.lod._measure import statistic
from nearfar.lod._measure.score_cache import ScoreCache, content
from nearfar.lod._measure.scores import Compared, scores
from nearfar.lod._measure.settings import MeasureSettings
from nearfar.lod._measure.views import Orbit, nested_turns, turns

MAX_BLOCK_PIXELS = 1 << 20
"""Pixels of a block of views. Memory holds two pictures of each view of a block, and each level's mask; Ctrl-C loses
the scores of one level of a block."""


class ScoreTable:
    """Scores of K levels, base first, at D sizes from T distinct turns, NaN where unknown.

    Scores are float32, as in a model's samples, so that a model can recompute its curves. `report` is called with the
    pixels rendered so far and in total.
    """

    def __init__(self, levels: Levels, settings: MeasureSettings, report: progress.Report) -> None:
        if not levels.radius > 0.0:
            raise ValueError(f"levels: expected a base that is more than a point, got radius {levels.radius}")
        self.levels, self.settings, self.report = levels, settings, report
        self.renders = 0
        self.screen = settings.screen
        self.orbit = Orbit.of_levels(levels, self.screen, self.screen.sines(settings.spacing, settings.distances))
        self.turns, self.turn_of_view = turns(settings.views, settings.directions)
        self.subsets = nested_turns(len(self.turns))
        self.sizes = range(1, settings.distances + 1)
        self.scores = np.full((len(levels), settings.distances, len(self.turns)), np.nan, np.float32)
        self.scores[0] = 1.0
        self.is_base = np.arange(len(levels)) == 0
        self.is_used = np.zeros(self.scores.shape, bool)
        self.was_known = np.isfinite(self.scores)
        self.backend: Backend = "cpu"
        self.device = "cpu"
        self.cache: ScoreCache | None = None
        self._done = 0

    def prepare(self) -> None:
        """Choose the device for pictures, once for all levels, and load the known scores."""
        base = self.levels[0].scene
        settings = RenderSettings(
            samples=self.settings.samples, channels=("color", "range"), backend=self.settings.backend
        )
        device = Renderer(base, settings).device()
        if device is not None:
            self.backend, self.device = "gpu", device.label
        contents = [content(level.scene) for level in self.levels]
        self.is_base[:] = [hashed == contents[0] for hashed in contents]
        self.scores[self.is_base] = 1.0
        if self.settings.cache:
            screen, orbit = self.screen, self.orbit
            cameras = (orbit.center, orbit.radius, screen.tan_half_angle, screen.pixel, screen.size)
            # Published distances do not depend on their number, so more distances extend the cached scores.
            sizes = orbit.sines if self.settings.spacing == "geometric" else ()
            pictures = (sizes, self.settings.views, self.settings.directions, self.settings.samples, self.device)
            self.cache = ScoreCache(contents, (*cameras, *pictures), self.scores)
        self.was_known = np.isfinite(self.scores)

    def fill(self, size: int, numbers: list[int], among: NDArray[np.intp] | None = None) -> None:
        """Measure the unknown scores of levels at a size, for all turns or those `among`, in blocks of views."""
        table = self.scores[:, size - 1]
        is_requested = np.zeros(len(self.turns), bool)
        is_requested[slice(None) if among is None else among] = True
        self.is_used[numbers, size - 1] |= is_requested
        missing = np.flatnonzero(is_requested & np.isnan(table[numbers]).any(axis=0)) if numbers else np.empty(0, int)
        block = max(1, MAX_BLOCK_PIXELS // self.orbit.pixel_count(size))
        for start in range(0, len(missing), block):
            views = missing[start : start + block]
            unknown = {number: np.flatnonzero(np.isnan(table[number, views])) for number in numbers}
            unknown = {number: indices for number, indices in unknown.items() if len(indices)}
            cameras = [self.orbit.camera(size, self.turns[view]) for view in views]
            compared = [Compared(self.levels[number].scene, indices) for number, indices in unknown.items()]
            new_scores = scores(self.levels[0].scene, compared, cameras, self.settings.samples, self.backend)
            self.renders += len(views)
            for number, indices in unknown.items():
                self._report(size, float(np.isfinite(table[numbers]).mean()))
                table[number, views[indices]] = next(new_scores)
                self.renders += len(indices)
            if self.cache is not None:
                self.cache.save_at_times()

    def percentiles(self, size: int, among: NDArray[np.intp] | None = None) -> NDArray[np.float64]:
        """Percentile (K,) over all views, or those with the turns `among`; NaN if one of them is unknown."""
        views = self._views(size, among)
        return np.where(np.isfinite(views).all(axis=1), statistic.of_views(views, self.settings.percentile), np.nan)

    def standard_errors(self, size: int, among: NDArray[np.intp]) -> NDArray[np.float64]:
        """Standard error (K,) of the percentile over the views with the turns `among`."""
        return statistic.standard_errors(self._views(size, among), self.settings.percentile, self.settings.views)

    def _views(self, size: int, among: NDArray[np.intp] | None) -> NDArray[np.float32]:
        """Scores (K, V) of all views at a size, or of those with the turns `among`."""
        turns = self.turn_of_view if among is None else self.turn_of_view[np.isin(self.turn_of_view, among)]
        return self.scores[:, size - 1][:, turns]

    @property
    def counts(self) -> tuple[int, int]:
        """Number of used scores that were measured, and number of used scores that were known before."""
        used = self.is_used & ~self.is_base[:, None, None]
        return int((used & ~self.was_known).sum()), int((used & self.was_known).sum())

    def _report(self, size: int, share: float) -> None:
        """Report progress: the pixels of earlier sizes, and a share of this size's pixels."""
        pixels = [self.orbit.pixel_count(number) for number in self.sizes]
        self._done = max(self._done, int(sum(pixels[: size - 1]) + share * pixels[size - 1]))
        self.report(self._done, sum(pixels))
