"""Mean SSIM behind the lens under a budget of triangles, compared with rules of screen-space error.

All rules choose among the same levels, which are measured with the default settings. The budget of a view, for our rule
and for the greedy one, is the number of triangles that the rule `by_screen_error` draws in it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.report import start, table
from benchmarks.lod._objects import RIFT_S, Headset, measure_objects
from benchmarks.lod._views import TURNS, Case, Levels
from nearfar.lod._measure.settings import MeasureKeywords
from nearfar.lod._select.rules import Mode

PIXELS = (0.5, 1.0, 2.0, 4.0, 8.0, 16.0)
"""Allowed screen-space errors of viewers of 3D Tiles such as Cesium, pixels; 16 is the usual default."""
SCENES = [(10, 100), (15, 500), (20, 500), (30, 1000)]
"""Radius in metres of the sphere around the user in which objects are placed, and number of objects."""
NEAR = (3, 60)
"""Scene with objects larger than σ₁/₁₆: radius of the sphere in metres, and number of objects."""
STEPS = 7
"""Bisection steps of the search for a budget: to 1 % of the triangles that a rule draws."""
DEFAULTS: MeasureKeywords = {"spacing": "geometric", "standard_error": 0.02, "views": 144, "step": None}
"""The default settings of `measure`, but with all levels."""
MODE: Mode = "panel"
"""Mode that measures sizes in pixels of the panel, on which scores are measured."""


@dataclass(frozen=True)
class Outcome:
    """Triangles of all views, scores of all objects with enough visible pixels, and the predicted mean."""

    triangles: int
    scores: NDArray[np.float64]
    pictures: list[float]
    """SSIM of the picture of each view."""
    predicted: float = np.nan

    @property
    def mean(self) -> float:
        """Mean score over objects."""
        return float(self.scores.mean())

    @property
    def picture(self) -> float:
        """Mean SSIM over the pictures."""
        return float(np.mean(self.pictures))


@dataclass(frozen=True)
class View:
    """One view of a case."""

    case: Case
    number: int

    @property
    def camera(self) -> nf.Camera:
        """Camera with the rendered pixels."""
        return self.case.cameras[self.number]

    def outcome(self, levels: Levels, predicted: NDArray[np.float64] | None = None) -> Outcome:
        """Score the objects with enough visible pixels in the picture at given levels."""
        picture, object_scores = self.case.compare(self.number, levels)
        is_scored = (levels >= 0) & np.isfinite(object_scores)
        mean = np.nan if predicted is None else float(predicted[is_scored].mean())
        return Outcome(self.case.triangles(levels), object_scores[is_scored], [picture], mean)

    def by_screen_error(self, pixels: float) -> Levels:
        """Choose the coarsest levels whose error covers at most some pixels."""
        level_or_hidden = self.case.full_levels(self.camera)
        is_good = self.case.screen_errors(self.camera) <= pixels
        coarsest = len(is_good) - 1 - np.argmax(is_good[::-1], axis=0)
        return np.where(level_or_hidden < 0, level_or_hidden, coarsest).astype(np.int32)

    def by_greedy_error(self, budget: int) -> Levels:
        """Start at the coarsest levels and refine the object whose error covers most pixels while the budget allows."""
        errors, level_or_hidden = self.case.screen_errors(self.camera), self.case.full_levels(self.camera)
        levels = np.where(level_or_hidden < 0, level_or_hidden, np.isfinite(errors).sum(axis=0) - 1).astype(np.int32)
        models, index = self.case.models, self.case.crowd.model_index
        remaining = budget - self.case.triangles(levels)
        error = np.where(levels > 0, errors[np.maximum(levels, 0), np.arange(len(levels))], -np.inf)
        while np.isfinite(error).any():
            worst = int(np.argmax(error))
            model, level = models[index[worst]], levels[worst]
            added = int(model.triangles[level - 1] - model.triangles[level])
            if added > remaining:
                error[worst] = -np.inf
                continue
            remaining -= added
            levels[worst] -= 1
            error[worst] = errors[level - 1, worst] if level > 1 else -np.inf
        return levels

    def select(self, budget: int) -> nf.lod.Selection:
        """Choose levels under a budget."""
        case, camera = self.case, self.case.with_pixels_of(self.camera, MODE)
        settings: dict[str, Any] = {"lens": case.headset.lens, "mode": MODE, "budget": budget, "full": True}
        return nf.lod.select(case.models, *case.index_and_spheres, camera=camera, **settings)

    def under_budget(self, budget: int) -> Outcome:
        """Score our choice under a budget."""
        selection = self.select(budget)
        return self.outcome(selection.level, selection.score)


Rule = Callable[[View, int], Outcome]


def merge(parts: Sequence[Outcome]) -> Outcome:
    predicted = float(np.average([part.predicted for part in parts], weights=[len(part.scores) for part in parts]))
    scores, pictures = (
        np.concatenate([part.scores for part in parts]),
        [each for part in parts for each in part.pictures],
    )
    return Outcome(sum(part.triangles for part in parts), scores, pictures, predicted)


def ours(views: Sequence[View], budgets: Sequence[int]) -> Outcome:
    return merge([view.under_budget(budget) for view, budget in zip(views, budgets, strict=True)])


def at_equal_mean(views: Sequence[View], budgets: Sequence[int], mean: float) -> Outcome:
    """Scale the budgets by the least factor at which the mean of our choice reaches `mean`; score that choice."""
    low, high = 0.0, 1.0
    least = [view.case.triangles(coarsest(view)) for view in views]
    best = ours(views, budgets)
    for _ in range(STEPS):
        fraction = 0.5 * (low + high)
        reduced = np.maximum(fraction * np.array(budgets), least).astype(int)
        outcome = ours(views, reduced.tolist())
        if outcome.mean >= mean:
            high, best = fraction, outcome
        else:
            low = fraction
    return best


def coarsest(view: View) -> Levels:
    level_or_hidden = view.case.full_levels(view.camera)
    last = np.array([len(model) - 1 for model in view.case.models])
    return np.where(level_or_hidden < 0, level_or_hidden, last[view.case.crowd.model_index]).astype(np.int32)


def report(headset: Headset, *, quick: bool) -> str:
    """Table by rule: its mean score, our mean with as many triangles, and our triangles at an equal mean."""
    models = measure_objects(RIFT_S, **DEFAULTS)
    cases = [Case.in_sphere(models, headset, *scene) for scene in (SCENES[:1] if quick else SCENES)]
    views = [View(case, number) for case in cases for number in range(len(case.cameras))]
    rows = []
    for pixels in PIXELS:
        parts = [view.outcome(view.by_screen_error(pixels)) for view in views]
        rule, budgets = merge(parts), [part.triangles for part in parts]
        greedy = merge([view.outcome(view.by_greedy_error(n)) for view, n in zip(views, budgets, strict=True)])
        our_outcome, at_its_mean = ours(views, budgets), at_equal_mean(views, budgets, rule.mean)
        fewer = 100 * (1 - at_its_mean.triangles / rule.triangles)
        means = rule.mean, greedy.mean, our_outcome.mean, our_outcome.predicted, rule.picture, our_outcome.picture
        rows.append([pixels, rule.triangles, *means, at_its_mean.triangles, fewer])
    header = "pixels {:g} | triangles {:,} | SSIM, rule {:.3f} | greedy {:.3f} | budget {:.3f} | predicted {:.3f}"
    header += " | picture, rule {:.3f} | picture, budget {:.3f} | triangles at equal SSIM {:,} | fewer % {:.0f}"
    return table(f"Rift S: mean SSIM of {len(our_outcome.scores):,} objects, with as many triangles", header, rows)


def predictions(names: Sequence[str]) -> str:
    """Table of measured and predicted mean scores under budgets, of all objects and of those larger than σ₁/₁₆."""
    models, rows = measure_objects(RIFT_S, names, **DEFAULTS), []
    for scene, turns in ((SCENES[0], TURNS), (NEAR, 3)):
        case = Case.in_sphere(models, RIFT_S, *scene, turns=turns)
        views = [View(case, number) for number in range(len(case.cameras))]
        for pixels in PIXELS[2:]:
            chosen = [view.select(case.triangles(view.by_screen_error(pixels))) for view in views]
            measured = np.concatenate([case.scores(n, each.level) for n, each in enumerate(chosen)])
            predicted, sizes, levels = (
                np.concatenate([getattr(each, name) for each in chosen]) for name in ("score", "sigma_seen", "level")
            )
            is_scored = (levels >= 0) & np.isfinite(measured)
            is_large = is_scored & (sizes > nf.lod.reference_solid_angle(RIFT_S.fov))
            means = [values[mask].mean() for mask in (is_scored, is_large) for values in (measured, predicted)]
            rows.append([scene[0], pixels, is_scored.sum(), *means[:2], is_large.sum(), *means[2:]])
    header = "radius m | pixels {:g} | objects | measured {:.3f} | predicted {:.3f}"
    header += " | larger than σ₁/₁₆ | measured {:.3f} | predicted {:.3f}"
    return table("Rift S: mean SSIM under budgets, measured and predicted", header, rows)


def main() -> None:
    options = start(
        __doc__,
        "--quick",
        flat=(bool, "without the lens, whose warp resamples pictures"),
        predictions={
            "nargs": "+",
            "default": None,
            "metavar": "OBJECT",
            "help": "only compare measured and predicted scores in scenes of these objects",
        },
    )
    if options.predictions:
        print(predictions(options.predictions), flush=True)
        return
    headset = replace(RIFT_S, lens=nf.RadialLens((0.0,)), panel_size=RIFT_S.size) if options.flat else RIFT_S
    print(report(headset, quick=options.quick), flush=True)


if __name__ == "__main__":
    main()
