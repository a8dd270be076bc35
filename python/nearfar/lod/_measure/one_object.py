"""Measuring the levels of one object."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import progress
from nearfar._render.renderer import Renderer
from nearfar.lod._levels import Levels
from nearfar.lod._measure.fit import Curve4PL, fit_4pl
from nearfar.lod._measure.samples import Samples
from nearfar.lod._measure.score_cache import Kept, content
from nearfar.lod._measure.scores import Pictures, pictures, scores
from nearfar.lod._measure.views import AXES, Screen, Stand, turns
from nearfar.lod._model import LodModel

MOST_PIXELS = 1 << 20
"""Of a block of views: two pictures of each are in memory, and Ctrl-C loses one level's scores of it."""


STEPPED = 4
"""Sizes at which levels are kept by steps. SSIM of bumpy things dips where they are smaller, and a level that is enough
at 1/16 of the screen is not there: without a finer one that is, the base would be shown at all sizes."""


@dataclass(frozen=True)
class Settings:
    """How objects are measured; `measure` says what it means."""

    screen: Screen
    views: int
    distances: int
    percentile: float
    step: float | None
    saturated: float | None
    samples: int
    backend: str
    cache: bool


@dataclass
class Counts:
    """What was done, for one object."""

    renders: int = 0
    scores: int = 0


def measure_one(levels: Levels, report: progress.Report, *, settings: Settings) -> tuple[LodModel, list[int]]:
    """A model without geometry, and the numbers of the levels that it keeps; the base is one of them."""
    return _Job(levels, settings, report).done()


@dataclass
class _Job:
    levels: Levels
    settings: Settings
    report: progress.Report
    counts: Counts = field(default_factory=Counts)

    def __post_init__(self) -> None:
        levels, settings = self.levels, self.settings
        if not levels.radius > 0.0:
            raise ValueError(f"levels: expected a base that is more than a point, got radius {levels.radius}")
        center = (float(levels.center[0]), float(levels.center[1]), float(levels.center[2]))
        self.stand = Stand(settings.screen, center, levels.radius, _reach(levels))
        self.turns, self.shown = turns(settings.views)
        self.sizes = range(1, settings.distances + 1)
        self.scores = np.full((len(levels), settings.distances, len(self.turns)), np.nan)
        self.scores[0] = 1.0
        self.used = np.zeros(self.scores.shape[:2], bool)
        self.used[0] = True
        self.same = np.arange(len(levels)) == 0
        self.backend = self.device = "cpu"
        self.kept: Kept | None = None

    def done(self) -> tuple[LodModel, list[int]]:
        """Measure what has to be."""
        chosen = list(range(len(self.levels)))
        if len(self.levels) > 1:
            self._begin()
            try:
                chosen = self._measure()
            finally:
                # Ctrl-C keeps what is done.
                if self.kept is not None:
                    self.kept.save()
        return self._model(chosen), chosen

    def _begin(self) -> None:
        """Settle where pictures are made, once for all levels, and what is known already."""
        base = self.levels[0].scene
        device = Renderer(base, ("color", "range"), self.settings.samples).device(self.settings.backend)
        if device is not None:
            self.backend, self.device = "gpu", device.label
        contents = [content(level.scene) for level in self.levels]
        self.same[:] = [own == contents[0] for own in contents]
        self.scores[self.same] = 1.0
        if self.settings.cache:
            screen, stand = self.settings.screen, self.stand
            place = (stand.center, stand.radius, screen.tan_half_angle, screen.pixel, screen.size)
            how = (self.settings.views, self.settings.samples, self.device)
            self.kept = Kept(contents, (*place, *how), self.scores)

    def _measure(self) -> list[int]:
        """Go from near to far; returns the levels that are kept, which are chosen at the first sizes."""
        chosen, wanted = {0}, list(range(1, len(self.levels)))
        streaks = np.zeros(len(self.levels), int)
        for size in self.sizes:
            self._fill(size, wanted)
            self.used[wanted, size - 1] = True
            found = self._percentiles(size)
            if size <= STEPPED:
                # What is measured no further looks like the base.
                chosen.update(stepped(np.where(self.used[:, size - 1], found, 1.0), self.settings.step))
            if size == STEPPED:
                wanted = [number for number in wanted if number in chosen]
            if self.settings.saturated is not None:
                streaks = np.where(found >= self.settings.saturated, streaks + 1, 0)
                wanted = [number for number in wanted if streaks[number] < 2 or self.same[number]]
        return sorted(chosen)

    def _percentiles(self, size: int) -> NDArray[np.float64]:
        of_views = self.scores[:, size - 1][:, self.shown]
        found = np.full(len(of_views), np.nan)
        known = self.used[:, size - 1]
        found[known] = np.percentile(of_views[known], self.settings.percentile, axis=1, method="averaged_inverted_cdf")
        return found

    def _fill(self, size: int, wanted: list[int]) -> None:
        """Score levels at a size where no score is known, by blocks of views."""
        table = self.scores[:, size - 1]
        first, end, top, bottom = self.stand.box(size)
        block = max(1, MOST_PIXELS // ((end - first) * (bottom - top)))
        missing = np.flatnonzero(np.isnan(table[wanted]).any(axis=0)) if wanted else np.empty(0, int)
        for start in range(0, len(missing), block):
            views = missing[start : start + block]
            base: Pictures | None = None
            for order, number in enumerate(wanted):
                share = start + len(views) * order / len(wanted)
                self.report(*self._progress(size, share / len(missing), len(wanted)))
                new = np.isnan(table[number, views])
                if not new.any():
                    continue
                base = self._pictures(0, size, views) if base is None else base
                beside = base if new.all() else Pictures(base.luma[new], base.shown[new])
                table[number, views[new]] = scores(beside, self._pictures(number, size, views[new]))
                self.counts.scores += int(new.sum())
            if self.kept is not None:
                self.kept.save_at_times()

    def _pictures(self, level: int, size: int, views: NDArray[np.intp]) -> Pictures:
        self.counts.renders += len(views)
        cameras = [self.stand.camera(size, self.turns[view]) for view in views]
        return pictures(self.levels[level].scene, cameras, self.settings.samples, self.backend)

    def _progress(self, size: int, share: float, wanted: int) -> tuple[int, int]:
        """Pixels done and pixels in all, if no level that is measured now is left out later."""
        boxes = [self.stand.box(number) for number in self.sizes]
        pixels = [(end - first) * (bottom - top) * (wanted + 1) for first, end, top, bottom in boxes]
        return int(sum(pixels[: size - 1]) + share * pixels[size - 1]), sum(pixels)

    def _model(self, chosen: list[int]) -> LodModel:
        sigma = np.array([self.stand.sigma(size) for size in self.sizes])
        score = np.stack([self._percentiles(size) for size in self.sizes], axis=1)
        used = np.where(self.used[..., None], self.scores[..., self.shown], np.nan)
        samples = Samples(sigma, score[chosen], used[chosen].astype(np.float32))
        # Levels fall to their curve's plateau, and what is not measured looks no worse than what is.
        curves = _cautious(fit_4pl(sigma, samples.filled[1:]), samples.filled[1:])
        return LodModel(
            triangles=np.array([self.levels[number].triangle_count for number in chosen]),
            curves=curves,
            center=self.levels.center,
            radius=self.levels.radius,
            sigma=(float(sigma[-1]), float(sigma[0])),
            errors=np.array([self.levels[number].error for number in chosen]),
            name=self.levels.name,
            samples=samples,
            measured=self._measured(chosen, score[:, 0]),
        )

    def _measured(self, chosen: list[int], first: NDArray[np.float64]) -> dict[str, Any]:
        settings, counts = self.settings, self.counts
        most = (len(self.levels) - 1) * settings.distances * settings.views
        cached = int(self.used[~self.same].sum()) * len(self.turns) - counts.scores
        left = [number for number in range(len(self.levels)) if number not in chosen]
        return {
            "tan_half_angle": settings.screen.tan_half_angle,
            "pixel": settings.screen.pixel,
            "size": list(settings.screen.size),
            "axes": [list(axis) for axis in AXES],
            "views": settings.views,
            "distances": settings.distances,
            "percentile": settings.percentile,
            "step": settings.step,
            "saturated": settings.saturated,
            "samples": settings.samples,
            "device": self.device,
            "left_out": [{"triangles": self.levels[n].triangle_count, "score": float(first[n])} for n in left],
            "renders": counts.renders,
            "scores": counts.scores,
            "cached": cached,
            "skipped": most - counts.scores - cached,
        }


def stepped(found: NDArray[np.float64], step: float | None) -> list[int]:
    """Numbers of the levels that are kept by their scores (K,): for each step down from 1 the coarsest that is above.

    The base is always kept, and all are without a step.
    """
    if step is None:
        return list(range(len(found)))
    # Scores like 0.95, which binary numbers don't hold, are at their step.
    steps = np.maximum(1, np.ceil((1.0 - found) / step - 1e-9)).astype(int)
    best = {0}
    for allowed in np.unique(steps[1:]):
        best.add(int(np.flatnonzero(steps <= allowed)[-1]))
    return sorted(best)


def _reach(levels: Levels) -> float:
    """Metres from the base's middle to the farthest corner of any level."""
    farthest = 0.0
    for level in levels:
        scene = level.scene
        corners = scene.triangles().reshape(-1, 3) + (scene.origin - levels.center)
        farthest = max(farthest, math.sqrt(float(np.einsum("ij,ij->i", corners, corners).max())))
    return farthest


def _cautious(curves: Curve4PL, rows: NDArray[np.float64]) -> Curve4PL:
    """Flat curves at their row's least score: the mean that was fitted promises more than was seen at some sizes."""
    if not len(rows):
        return curves
    is_flat = curves.status == "flat"
    least = rows.min(axis=1)
    return replace(curves, a=np.where(is_flat, least, curves.a), d=np.where(is_flat, least, curves.d))
