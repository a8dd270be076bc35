"""Finds what makes a reduction or its pictures say little, and why, as sentences for reports."""

from __future__ import annotations

from typing import Any

LARGEST, LOWEST_TOWER, STEEPEST, SMALLEST = 200e3, 1000.0, 0.2, 0.02
"""A scene wider than the first, higher than the second and the third's share of its width, or smaller than the fourth
(metres) has probably other units: no city is wider, no building higher, and no room smaller."""

LARGEST_OBJECT = 200.0
"""Size in metres above which a scene without open places is probably not a single object in metres."""


def of_reduction(stats: dict[str, Any], r2: float) -> list[str]:
    """Say what a reduction lacks.

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
    """Say why a picture does not show what distinguishes the methods.

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


def of_units(bounds: Any, *, is_object: bool) -> list[str]:
    """Say that a scene's extent suggests other units than metres.

    Parameters
    ----------
    bounds
        (2, 3) least and greatest corner, metres.
    is_object
        Whether the scene is a single object without open places.
    """
    width, height, depth = (float(high - low) for low, high in zip(bounds[0], bounds[1], strict=True))
    wide, extent = max(width, depth), f"{width:.3g} × {height:.3g} × {depth:.3g} m"
    largest = max(wide, height)
    if 0.0 < largest < SMALLEST:
        return [f"the units look wrong: the scene measures only {extent}; nearfar expects metres"]
    too_high = height > LOWEST_TOWER and height > STEEPEST * wide
    if wide > LARGEST or too_high or (is_object and largest > LARGEST_OBJECT):
        return [
            f"the units look wrong: the scene measures {extent}, which suggests centimetres or millimetres; nearfar "
            "expects metres"
        ]
    return []
