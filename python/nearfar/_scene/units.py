"""Units of sources: metres per stated unit, and a note if the extent suggests another unit."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check
from nearfar._base.errors import SceneError

TALLEST_BUILDING = 830.0
"""Height above that of any building, metres: the Burj Khalifa has 828 m."""

HIGHEST_GROUND = 9_000.0
"""Height above that of any ground, metres: Mount Everest has 8,849 m."""

STEEPEST_GROUND = 0.2
"""Ratio of height to width that rooms and houses exceed, but landscapes over 830 m high seldom do."""

EYES_APART = 0.06
"""Least plausible extent of a scene around a user, metres: about the distance between the eyes."""


def metres_in(label: str, units: Iterable[str]) -> float:
    """Return the metres per unit that the meshes of a source state; 1 if they state none.

    Units are trimesh's, such as "mm" or "0.0254 * meters", and "" for none, which means the metre. SceneError for
    unknown units, or for units of different lengths.
    """
    factors = {unit: _metres_in(label, unit) for unit in sorted(set(units))}
    if len(set(factors.values())) > 1:
        names = ", ".join(unit or "none" for unit in factors)
        raise SceneError(f"{label}: expected meshes of one unit, got {names}; scale= states the metres in a unit")
    return next(iter(factors.values()), 1.0)


def _metres_in(label: str, unit: str) -> float:
    from trimesh.units import unit_conversion

    if not unit:
        return 1.0
    try:
        # Trimesh's table is in inches, so the last digits of quotients are rounding errors.
        factor = float(f"{unit_conversion(unit, 'meters'):.12g}")
    except ValueError:
        factor = 0.0
    if not 0.0 < factor < np.inf:
        got = check.shortened(unit)
        raise SceneError(f"{label}: expected a unit that trimesh knows, got {got}; scale= states its metres")
    return factor


def extent_note(bounds: NDArray[np.float64]) -> str:
    """Describe an extent that suggests a unit other than the metre; "" for plausible extents and empty scenes.

    The note is given for heights above `HIGHEST_GROUND`, for heights above `TALLEST_BUILDING` unless the scene is as
    wide as a landscape, and for scenes smaller than `EYES_APART`. Rooms in centimetres have the extent of buildings in
    metres, so they are not detected.
    """
    sides = bounds[1] - bounds[0]
    if not np.isfinite(sides).all():
        return ""
    height, width = float(sides[1]), float(max(sides[0], sides[2]))
    extent = " × ".join(f"{side:,.6g}" for side in sides.tolist()) + " m"
    state = "if the unit of its source is not the metre, state it by scale (0.001 for millimetres)"
    if height > HIGHEST_GROUND or (height > TALLEST_BUILDING and height > STEEPEST_GROUND * width):
        return f"the scene has {extent}, higher than buildings and landscapes: {state}"
    if 0.0 < max(height, width) < EYES_APART:
        return f"the scene has {extent}, less than the distance between two eyes: {state}"
    return ""
