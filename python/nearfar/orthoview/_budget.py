"""Chooses the splats of a picture within a budget: those of a cut's views, blended where levels overlap."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from nearfar import _core
from nearfar._camera.camera import Camera
from nearfar.orthoview._cut import Cutter, OrthoCut, Settings
from nearfar.orthoview._layout import ViewKey
from nearfar.orthoview._views import Views

MAX_ERROR_FACTOR = 64.0
"""Greatest factor by which a budget may raise the error of the settings."""

BISECTIONS = 12
"""Bisection steps for the error's logarithm: the last step is 0.1 %."""

MAX_CUTS = 10
"""Maximum number of cuts that are tried: a view's number of splats is known only once it has been read."""

MIN_FILL = 0.98
"""Least share of the budget that a continuous cut must use to be accepted: before views are read, the number of splats
in bands where levels blend is an estimate."""

ERROR_RATIO = 1.002
"""Ratio of two errors below which the search between them ends."""


@dataclass(frozen=True)
class Fit:
    """A cut and its splats."""

    cut: OrthoCut
    error_px: float
    """Greatest width of a view's pixels in pixels of the picture, which the budget may have raised."""
    layers: list[Sequence[_core.OrthoSplats]]
    """Splats of each drawn view, layer by layer."""

    @property
    def splats(self) -> list[_core.OrthoSplats]:
        """Splats of all layers."""
        return [layer for layers in self.layers for layer in layers]

    @property
    def count(self) -> int:
        return sum(layer.count for layer in self.splats)


class Fitter:
    """Chooses the splats of pictures."""

    def __init__(self, cutter: Cutter, views: Views) -> None:
        self._cutter, self._views = cutter, views

    def fit(self, camera: Camera, settings: Settings) -> Fit:
        """Find the cut with the least error, at least that of the settings, whose splats are within the budget.

        If no error is large enough, views are left out: the third views of all cells first, then the second ones, and
        among equals those of the farthest cells first.
        """
        budget = settings.budget
        if budget is None:
            return self._fit_at(camera, settings)
        low, high, best = settings.error_px, settings.error_px * MAX_ERROR_FACTOR, None
        error = self._least_error(camera, settings, budget)
        for _ in range(MAX_CUTS):
            candidate = replace(settings, error_px=error)
            were_known = all(map(self._views.is_counted, self._cutter.complete_cut(camera, candidate).keys()))
            fitted = self._fit_at(camera, candidate)
            is_within = fitted.count <= budget
            best = fitted if is_within else best
            low, high = (low, error) if is_within else (error, high)
            if not settings.continuous:
                if were_known:
                    break
                error = self._least_error(camera, settings, budget)
                continue
            is_filled = fitted.count >= MIN_FILL * budget or error == settings.error_px
            if (is_within and is_filled) or high <= low * ERROR_RATIO:
                break
            # The number of splats is inversely proportional to the square of the error.
            error *= math.sqrt(max(fitted.count, 1) / budget) * ERROR_RATIO
            if not low < error < high:
                error = math.sqrt(low * high)
        return best or _drop_views(fitted, budget)

    def _fit_at(self, camera: Camera, settings: Settings) -> Fit:
        cut = self._cutter.complete_cut(camera, settings)
        layers: list[Sequence[_core.OrthoSplats]] = list(self._views.layers(cut.keys()))
        if settings.continuous:
            rule = self._cutter.rule(camera, settings)
            layers = list(_core.blend_orthoviews(_kernel_views(cut, cut.keys(), layers), rule))
        return Fit(cut, settings.error_px, layers)

    def _least_error(self, camera: Camera, settings: Settings, max_splats: int) -> float:
        """Find the least error at which at most `max_splats` splats are expected, by bisection."""
        low, high = math.log(settings.error_px), math.log(settings.error_px * MAX_ERROR_FACTOR)
        if self._expected(camera, settings) <= max_splats:
            return settings.error_px
        for _ in range(BISECTIONS):
            middle = (low + high) / 2
            is_enough = self._expected(camera, replace(settings, error_px=math.exp(middle))) <= max_splats
            low, high = (low, middle) if is_enough else (middle, high)
        return math.exp(high)

    def _expected(self, camera: Camera, settings: Settings) -> float:
        """Estimate the number of splats of a cut from the counts known so far."""
        cut = self._cutter.complete_cut(camera, settings)
        keys = cut.keys()
        if not settings.continuous:
            return sum(map(self._views.expected_count, keys))
        rule = self._cutter.rule(camera, settings)
        cached = [self._views.cached_layers(key) for key in keys]
        count = _core.expected_orthoviews(_kernel_views(cut, keys, cached), rule)
        return count + sum(
            self._views.expected_count(key) for key, layers in zip(keys, cached, strict=True) if not layers
        )


def _kernel_views(
    cut: OrthoCut, keys: Sequence[ViewKey], layers: Sequence[Sequence[_core.OrthoSplats]]
) -> list[tuple[Sequence[_core.OrthoSplats], int, tuple[int, int, int], int, bool]]:
    """Return the views that have layers, as arguments of the core."""
    rows = zip(keys, layers, cut.parts(), strict=True)
    return [(splats, level, place, n, is_partial) for (level, place, n), splats, is_partial in rows if splats]


def _drop_views(fitted: Fit, budget: int) -> Fit:
    """Keep the first views of all cells, then the second ones and so on, while the budget lasts."""
    ranks = np.argwhere(fitted.cut.directions >= 0)[:, 1]
    remaining, numbers = budget, []
    for number in np.argsort(ranks, kind="stable").tolist():
        remaining -= sum(layer.count for layer in fitted.layers[number])
        if remaining < 0:
            break
        numbers.append(number)
    return replace(fitted, layers=[fitted.layers[number] for number in sorted(numbers)])
