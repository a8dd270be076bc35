"""Default centre and radii: r2 from the surroundings of the centre, r1 from the shear of the ground."""

from __future__ import annotations

import logging
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from nearfar._base import check
from nearfar._reduce.choose_radii import by_ground, least_outer, shear_of
from nearfar._scene.scene import Scene
from nearfar._trace import viewpoint
from nearfar._trace.viewpoint import Point, Viewpoint

CITY = 75.0
"""Least distance in metres from the centre to a city's farthest bounds."""

CITY_OUTER = 50.0
"""Radius r2 in metres for cities."""

REACH = 8.0
"""Distance in metres that a user may walk from the centre; less if a small r2 would make the picture fold."""

SHEAR = 1.0
"""Greatest shear of the ground between the radii, pixels for each pixel."""

SPREAD = 5.0 / 3.0
"""Least ratio of r2 to a given r1."""

WALLS = 75.0
"""Percentile of the distances around an eye taken as the distance of a room's walls; windows let rays pass."""

PUBLISHED = 0.6
"""Ratio of r1 to r2 in Popescu et al. (2022), 30 m and 50 m."""

ASIDE = (0.3, 0.9)
"""Shares of r2 − r1 and of r1 whose lesser is a user's distance from O; the picture does not fold there."""


@dataclass(frozen=True)
class Choice:
    """Radii in metres, and the reason for them in words; empty if the caller set both."""

    r1: float
    r2: float
    reason: str = ""
    is_by_ground: bool = False
    """Whether r1 was chosen by the ground."""


def choose(scene: Scene, place: Viewpoint, r1: float | None = None, r2: float | None = None) -> Choice:
    """Choose the radii that are None.

    r2 is `CITY_OUTER` for scenes that extend `CITY` metres or more, else two thirds of the way from the nearest to the
    farthest of the scene's bounds; under a roof the visible walls count as the farthest. r1 follows from the ground
    (`choose_radii`). For an object seen from outside, r1 is a third of that way, since there is no ground.
    """
    if r1 is not None or r2 is not None:
        inner, outer = completed(r1, r2)
        if r1 is not None:
            why = f"r2 is the greater of {CITY_OUTER:g} m and {SPREAD:.3g} r1"
            return Choice(inner, outer, why if r2 is None else "")
        return Choice(inner, outer, _by_ground(inner, outer), is_by_ground=True)
    nearest, farthest = _extent(scene, place)
    if (not place.is_outside and farthest >= CITY) or not nearest < farthest < np.inf:
        inner = completed(None, CITY_OUTER)[0]
        why = f"r2 = {CITY_OUTER:g} m is the default where a scene reaches {CITY:g} m away"
        return Choice(inner, CITY_OUTER, f"{why}; {_by_ground(inner, CITY_OUTER)}", is_by_ground=True)
    thirds = [float(f"{nearest + share * (farthest - nearest):.2g}") for share in (1.0 / 3.0, 2.0 / 3.0)]
    inner, outer = thirds if thirds[0] < thirds[1] else (nearest, farthest)
    if place.is_outside:
        return Choice(inner, outer, "the radii divide the way from the object's nearest to its farthest part in thirds")
    inner = completed(None, outer)[0]
    why = f"r2 is two thirds of the way to the walls; {_by_ground(inner, outer)}"
    return Choice(inner, outer, why, is_by_ground=True)


def find_place(scene: Scene, center: ArrayLike | None = None) -> Viewpoint:
    """Find a viewpoint for a centre, by default an open place of the scene or a place in front of an object."""
    return viewpoint.find(scene) if center is None else viewpoint.facing_open(scene, check.vector("center", center))


def complete(
    scene: Scene, center: ArrayLike | None, r1: float | None, r2: float | None
) -> tuple[Point, float, float, str]:
    """Choose a centre and radii that are None; return all three, and the reasons in words. The log has them, too."""
    inner = None if r1 is None else check.at_least_zero("r1", r1)
    outer = None if r2 is None else check.positive("r2", r2)
    place = find_place(scene, center)
    radii = choose(scene, place, inner, outer)
    where = "in front of the scene, where all of it is in view" if place.is_outside else "an open place near the middle"
    x, y, z = place.eye
    reasons = [f"the centre ({x:.4g}, {y:.4g}, {z:.4g}) is {where}"] if center is None else []
    reason = "; ".join([*reasons, *([radii.reason] if radii.reason else [])])
    logging.getLogger("nearfar").info("reduce: %s", reason)
    return place.eye, radii.r1, radii.r2, reason


def completed(r1: float | None, r2: float | None) -> tuple[float, float]:
    """Return both radii; r1 follows from r2 by the ground, r2 is `CITY_OUTER` or `SPREAD` times r1."""
    if r2 is None:
        r2 = CITY_OUTER if r1 is None else max(CITY_OUTER, r1 * SPREAD)
    return _inner(r2) if r1 is None else r1, r2


def aside(r1: float, r2: float) -> float:
    """Distance in metres of a user from O at which the methods differ visibly, without folds."""
    between, within = ASIDE
    return min(between * (r2 - r1), within * r1) if r1 > 0.0 else between * (r2 - r1)


def _reach(r2: float) -> float:
    return min(REACH, REACH * r2 / least_outer(REACH))


def _inner(r2: float) -> float:
    return float(f"{by_ground(r2, _reach(r2), viewpoint.EYE_HEIGHT, SHEAR):.3g}")


def _by_ground(r1: float, r2: float) -> str:
    reach = _reach(r2)
    shear = shear_of(r1, r2, reach, viewpoint.EYE_HEIGHT)
    return (
        f"with r1 = {r1:g} m the ground between the radii is sheared by at most {shear:.2g} pixels a pixel for a user "
        f"{reach:.2g} m beside the centre"
    )


def _extent(scene: Scene, place: Viewpoint) -> tuple[float, float]:
    """Horizontal distances in metres from the eye to the nearest and the farthest of a scene's bounds, or to walls."""
    low, high = scene.bounds[:, [0, 2]]
    eye = np.array(place.eye)[[0, 2]]
    nearest = float(np.hypot(*np.maximum(np.maximum(low - eye, eye - high), 0.0)))
    farthest = float(np.hypot(*np.maximum(np.abs(low - eye), np.abs(high - eye))))
    if not place.is_outside and viewpoint.is_roofed(scene, place.eye):
        around = viewpoint.horizontal_distances(scene, place.eye)
        farthest = min(farthest, float(np.percentile(np.minimum(around, farthest), WALLS)))
    return nearest, farthest
