"""Mean SSIM behind the lens under a budget of triangles, compared with rules of screen-space error.

All rules choose among the same levels; our curves begin at a quarter of the screen. The budget of a view is the number
of triangles that the rule draws there.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.report import start, table
from benchmarks.lod._objects import RIFT_S, Headset, measured
from benchmarks.lod._views import Case, Levels
from nearfar.lod._select.rules import Mode

PIXELS = (0.5, 1.0, 2.0, 4.0, 8.0, 16.0)
"""Allowed screen-space errors of tile viewers, pixels; 16 is the usual default."""
SCENES = [(10, 100), (15, 500), (20, 500), (30, 1000)]
"""Radius of the ball in metres, and number of objects."""
STEPS = 7
"""Bisection steps of the search for a budget: to 1 % of the triangles that a rule draws."""
MODE: Mode = "panel"
"""Mode that measures sizes in pixels of the panel, on which scores are measured."""


@dataclass(frozen=True)
class Outcome:
    """Triangles of all views, scores of all objects with enough visible pixels, and the predicted mean."""

    triangles: int
    scores: NDArray[np.float64]
    foreseen: float = np.nan

    @property
    def mean(self) -> float:
        """Mean score over objects."""
        return float(self.scores.mean())


@dataclass(frozen=True)
class View:
    """One view of a case."""

    case: Case
    number: int

    @property
    def camera(self) -> nf.Camera:
        """Camera with the rendered pixels."""
        return self.case.cameras[self.number]

    def outcome(self, levels: Levels, foreseen: NDArray[np.float64] | None = None) -> Outcome:
        """Score the objects with enough visible pixels in the picture at given levels."""
        object_scores = self.case.scores(self.number, levels)
        is_scored = (levels >= 0) & np.isfinite(object_scores)
        mean = np.nan if foreseen is None else float(foreseen[is_scored].mean())
        return Outcome(self.case.triangles(levels), object_scores[is_scored], mean)

    def by_screen_error(self, pixels: float) -> Levels:
        """Choose the coarsest levels whose error covers at most some pixels."""
        full = self.case.in_full(self.camera)
        is_good = self.case.screen_errors(self.camera) <= pixels
        coarsest = len(is_good) - 1 - np.argmax(is_good[::-1], axis=0)
        return np.where(full < 0, full, coarsest).astype(np.int32)

    def by_greedy_error(self, budget: int) -> Levels:
        """Refine the object whose error covers most pixels, from the coarsest levels on, while the budget allows."""
        errors, full = self.case.screen_errors(self.camera), self.case.in_full(self.camera)
        levels = np.where(full < 0, full, np.isfinite(errors).sum(axis=0) - 1).astype(np.int32)
        models, index = self.case.models, self.case.crowd.model_index
        remaining = budget - self.case.triangles(levels)
        now = np.where(levels > 0, errors[np.maximum(levels, 0), np.arange(len(levels))], -np.inf)
        while np.isfinite(now).any():
            worst = int(np.argmax(now))
            model, level = models[index[worst]], levels[worst]
            added = int(model.triangles[level - 1] - model.triangles[level])
            if added > remaining:
                now[worst] = -np.inf
                continue
            remaining -= added
            levels[worst] -= 1
            now[worst] = errors[level - 1, worst] if level > 1 else -np.inf
        return levels

    def under_budget(self, budget: int) -> Outcome:
        """Score our choice under a budget."""
        case, camera = self.case, self.case.counting(self.camera, MODE)
        selection = nf.lod.select(
            *case.spheres, camera=camera, lens=case.headset.lens, mode=MODE, budget=budget, full=True
        )
        return self.outcome(selection.level, selection.score)


Rule = Callable[[View, int], Outcome]


def merge(parts: Sequence[Outcome]) -> Outcome:
    counts = [len(part.scores) for part in parts]
    foreseen = float(np.average([part.foreseen for part in parts], weights=counts))
    return Outcome(sum(part.triangles for part in parts), np.concatenate([part.scores for part in parts]), foreseen)


def ours(views: Sequence[View], budgets: Sequence[int]) -> Outcome:
    return merge([view.under_budget(budget) for view, budget in zip(views, budgets, strict=True)])


def at_equal_mean(views: Sequence[View], budgets: Sequence[int], mean: float) -> Outcome:
    """Score our choice at the least share of the budgets whose mean is no worse."""
    low, high = 0.0, 1.0
    least = [view.case.triangles(coarsest(view)) for view in views]
    best = ours(views, budgets)
    for _ in range(STEPS):
        fraction = 0.5 * (low + high)
        outcome = ours(views, [max(int(fraction * each), few) for each, few in zip(budgets, least, strict=True)])
        if outcome.mean >= mean:
            high, best = fraction, outcome
        else:
            low = fraction
    return best


def coarsest(view: View) -> Levels:
    full, last = view.case.in_full(view.camera), np.array([len(model) - 1 for model in view.case.models])
    return np.where(full < 0, full, last[view.case.crowd.model_index]).astype(np.int32)


def report(headset: Headset, *, quick: bool) -> str:
    """Table of each rule: its mean, ours with as many triangles, and our triangles for its mean."""
    models = measured(RIFT_S, step=None, wider=2)
    cases = [Case.in_ball(models, headset, *scene) for scene in (SCENES[:1] if quick else SCENES)]
    views = [View(case, number) for case in cases for number in range(len(case.cameras))]
    rows = []
    for pixels in PIXELS:
        parts = [view.outcome(view.by_screen_error(pixels)) for view in views]
        rule, budgets = merge(parts), [part.triangles for part in parts]
        greedy = merge(
            [view.outcome(view.by_greedy_error(budget)) for view, budget in zip(views, budgets, strict=True)]
        )
        own_outcome, equal = ours(views, budgets), at_equal_mean(views, budgets, rule.mean)
        fewer = 100 * (1 - equal.triangles / rule.triangles)
        means = rule.mean, greedy.mean, own_outcome.mean, own_outcome.foreseen
        rows.append([pixels, rule.triangles, *means, equal.triangles, fewer])
    header = "pixels {:g} | triangles {:,} | SSIM, rule {:.3f} | greedy {:.3f} | budget {:.3f} | foreseen {:.3f}"
    header += " | triangles at equal SSIM {:,} | fewer % {:.0f}"
    return table(f"Rift S: mean SSIM of {len(own_outcome.scores):,} objects, with as many triangles", header, rows)


def main() -> None:
    options = start(__doc__, "--quick", flat=(bool, "without the lens, whose warp resamples pictures"))
    headset = replace(RIFT_S, lens=nf.RadialLens((0.0,)), panel_size=RIFT_S.size) if options.flat else RIFT_S
    print(report(headset, quick=options.quick), flush=True)


if __name__ == "__main__":
    main()
