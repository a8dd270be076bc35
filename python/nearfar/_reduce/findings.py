"""Explains in sentences why a reduction or its pictures are not informative, for reports."""

from __future__ import annotations

from typing import Any


def of_reduction(stats: dict[str, Any], r2: float) -> list[str]:
    """Describe what a reduction lacks.

    Parameters
    ----------
    stats
        `ReducedScene.stats`.
    r2
        Its outer radius, metres.
    """
    triangles, drawn = stats["triangles"], stats["drawn"]
    found = []
    if drawn == 0:
        found.append(f"nothing is near: no triangle lies within r2 = {r2:g} m of the centre; r2 can be larger")
    if stats["sf"] == 0:
        found.append(f"nothing is far: everything lies within r2 = {r2:g} m, so that there is no map; r2 can be less")
    if drawn == triangles > 0:
        reason = "everything lies" if stats["sf"] == 0 else "every triangle lies at least partly"
        found.append(f"no reduction: all {triangles:,} triangles stay geometry, because {reason} within r2 = {r2:g} m")
    return found


def of_view(*, crosses: bool, fold_margin: float, r2: float) -> list[str]:
    """Explain why a picture does not show the difference between the methods.

    Parameters
    ----------
    crosses
        Whether the boundary of the near part is in view.
    fold_margin
        Result of `fold_margin` for the user, metres.
    r2
        Radius of the boundary, metres.
    """
    found = []
    if not crosses:
        found.append(
            f"the boundary is not in view: the picture shows no surface that crosses r2 = {r2:g} m, so that the "
            "methods hardly differ; look elsewhere or choose another r2"
        )
    if fold_margin < 0.0:
        beyond = f"{-fold_margin:.3g} m beyond" if fold_margin > float("-inf") else "at a height outside of"
        found.append(f"the continuous picture folds: the user is {beyond} the fold margin; go closer to the centre")
    return found
