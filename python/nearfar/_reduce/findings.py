"""Sentences for reports that explain why a reduction or its pictures are not informative."""

from __future__ import annotations

from typing import Any


def of_reduction(stats: dict[str, Any], r2: float) -> list[str]:
    """Explain why a reduction is trivial, from `ReducedScene.stats` and its outer radius in metres."""
    triangles, drawn = stats["triangles"], stats["drawn"]
    sentences = []
    if drawn == 0:
        sentences.append(f"nothing is near: no triangle lies within r2 = {r2:g} m of the centre; r2 can be larger")
    if stats["sf"] == 0:
        sentences.append(f"nothing is far: everything lies within r2 = {r2:g} m, so there is no map; r2 can be less")
    if drawn == triangles > 0:
        reason = "everything lies" if stats["sf"] == 0 else "every triangle lies at least partly"
        geometry = f"all {triangles:,} triangles stay geometry"
        sentences.append(f"no reduction: {geometry}, because {reason} within r2 = {r2:g} m")
    return sentences


def of_view(*, crosses: bool, is_measurable: bool = True, fold_margin: float, r2: float) -> list[str]:
    """Explain why a picture does not show the difference between the methods.

    `crosses` states whether the boundary of the near part, at `r2` metres, is in view, and `is_measurable` whether both
    of its sides are visible along enough of it in the pictures of both methods. `fold_margin` is in metres.
    """
    sentences = []
    if not crosses:
        sentences.append(
            f"the boundary is not in view: the picture shows no surface that crosses r2 = {r2:g} m, so the "
            "methods cannot break there; look elsewhere or choose another r2"
        )
    elif not is_measurable:
        sentences.append(
            f"the boundary cannot be measured: in the picture of a method, one side of r2 = {r2:g} m hides the other "
            "almost everywhere; look elsewhere or choose another r2"
        )
    if fold_margin < 0.0:
        sentences.append(f"the continuous picture folds: {explain_fold(fold_margin)}")
    return sentences


def explain_fold(fold_margin: float) -> str:
    """Explain why a picture folds, by a negative `fold_margin` in metres."""
    position = f"{-fold_margin:.3g} m beyond" if fold_margin > float("-inf") else "at a height outside of"
    return f"the user is {position} the fold margin; go closer to the centre"
