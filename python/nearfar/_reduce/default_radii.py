"""Default centre and radii: r2 from the surroundings of the centre, r1 from the shear of the ground."""

from __future__ import annotations

import logging
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from nearfar._base import check
from nearfar._reduce.choose_radii import distances_to_bounds, inner_radius, min_outer_radius, shear_of
from nearfar._scene.scene import Scene
from nearfar._trace import viewpoint
from nearfar._trace.viewpoint import Point, Viewpoint

MIN_CITY_EXTENT = 75.0
"""Least distance in metres from the centre to a city's farthest bounds."""

CITY_R2 = 50.0
"""Radius r2 in metres for cities."""

REACH = 8.0
"""Distance in metres that a user may walk from the centre; less if a small r2 would make the picture fold."""

SHEAR = 1.0
"""Greatest shear of the ground between the radii, pixels for each pixel."""

MIN_RATIO = 5.0 / 3.0
"""Least ratio of the default r2 to an r1 that the caller states."""

WALL_PERCENTILE = 75.0
"""Percentile of the distances around an eye that counts as the distance of the walls, because windows let rays pass."""

PUBLISHED = 0.6
"""Ratio of r1 to r2 in Popescu et al. (2022), 30 m and 50 m."""

USER_SHARES = (0.3, 0.9)
"""A user's default distance from O: the lesser of these shares of r2 − r1 and of r1, at which no picture folds."""


@dataclass(frozen=True)
class Choice:
    """Radii in metres, and the reasons for them."""

    r1: float
    r2: float
    reasons: Mapping[str, str] = field(default_factory=dict)
    """Reasons in words, for "r2", for "r1" (by the shear of the ground), or for "radii" if both were chosen at once."""

    @property
    def reason(self) -> str:
        """The reasons as one text; empty if the caller set both radii."""
        return join(self.reasons)

    @property
    def is_by_ground(self) -> bool:
        """Whether r1 was chosen by the shear of the ground."""
        return "r1" in self.reasons


def join(reasons: Mapping[str, str]) -> str:
    return "; ".join(reasons.values())


def choose(scene: Scene, start: Viewpoint, r1: float | None = None, r2: float | None = None) -> Choice:
    """Choose the radii that are None.

    r2 is `CITY_R2` for scenes that extend `MIN_CITY_EXTENT` metres or more. Else it lies at two thirds of the way from
    the nearest to the farthest of the scene's bounds; under a roof the visible walls count as the farthest. r1 follows
    from the shear of the ground (`choose_radii`). An object seen from outside has no ground; its r1 lies at one third.
    """
    if r1 is not None:
        reasons = {} if r2 is not None else {"r2": f"r2 is the greater of {CITY_R2:g} m and {MIN_RATIO:.3g} r1"}
        return Choice(*complete_radii(r1, r2), reasons)
    if r2 is not None:
        return _choose_by_ground(r2, {})
    nearest, farthest = _distances(scene, start)
    if (not start.is_outside and farthest >= MIN_CITY_EXTENT) or not nearest < farthest < np.inf:
        reason = f"r2 = {CITY_R2:g} m is the default where a scene reaches {MIN_CITY_EXTENT:g} m away"
        return _choose_by_ground(CITY_R2, {"r2": reason})
    near, far = (float(f"{nearest + fraction * (farthest - nearest):.2g}") for fraction in (1.0 / 3.0, 2.0 / 3.0))
    if near >= far:
        near, far = nearest, farthest
    if start.is_outside:
        reason = "the radii divide the way from the object's nearest to its farthest part in thirds"
        return Choice(near, far, {"radii": reason})
    return _choose_by_ground(far, {"r2": "r2 is two thirds of the way to the walls"})


def find_place(scene: Scene, center: ArrayLike | None = None) -> Viewpoint:
    """Find a viewpoint for a centre, by default an open place of the scene or a place in front of an object.

    ValueError for a centre deep below the scene, or farther from the scene than the scene's size.
    """
    if center is None:
        return viewpoint.find(scene)
    return viewpoint.facing_open(scene, viewpoint.check_center(scene, check.vector("center", center)))


def complete(
    scene: Scene, center: ArrayLike | None, r1: float | None, r2: float | None
) -> tuple[Point, float, float, Mapping[str, str]]:
    """Choose the centre and radii that are None; return all three, and the reasons for the choices."""
    r1 = None if r1 is None else check.at_least_zero("r1", r1)
    r2 = None if r2 is None else check.positive("r2", r2)
    start = find_place(scene, center)
    radii = choose(scene, start, r1, r2)
    where = "in front of the scene, where all of it is in view" if start.is_outside else "an open place near the middle"
    x, y, z = start.eye
    chosen_center = {"center": f"the centre ({x:.4g}, {y:.4g}, {z:.4g}) is {where}"} if center is None else {}
    reasons = chosen_center | dict(radii.reasons)
    logging.getLogger("nearfar").info("reduce: %s", join(reasons))
    return start.eye, radii.r1, radii.r2, reasons


def complete_radii(r1: float | None, r2: float | None) -> tuple[float, float]:
    """Replace radii of None: r2 by the greater of `CITY_R2` and `MIN_RATIO` r1, r1 by the shear of the ground."""
    if r2 is None:
        r2 = CITY_R2 if r1 is None else max(CITY_R2, r1 * MIN_RATIO)
    if r1 is None:
        r1 = float(f"{inner_radius(r2, _reach(r2), viewpoint.EYE_HEIGHT, SHEAR):.3g}")
    return r1, r2


def user_distance(r1: float, r2: float) -> float:
    """Return a distance in metres of a user from O at which the methods differ visibly and no picture folds."""
    share_between, share_within = USER_SHARES
    return min(share_between * (r2 - r1), share_within * r1) if r1 > 0.0 else share_between * (r2 - r1)


def _reach(r2: float) -> float:
    return min(REACH, REACH * r2 / min_outer_radius(REACH))


def _choose_by_ground(r2: float, reasons: Mapping[str, str]) -> Choice:
    r1, reach = complete_radii(None, r2)[0], _reach(r2)
    shear = shear_of(r1, r2, reach, viewpoint.EYE_HEIGHT)
    reason = (
        f"with r1 = {r1:g} m the greatest shear of the ground between the radii is {shear:.2g}, in pixels per pixel, "
        f"for a user {reach:.2g} m beside the centre"
    )
    return Choice(r1, r2, {**reasons, "r1": reason})


def _distances(scene: Scene, start: Viewpoint) -> tuple[float, float]:
    """Horizontal distances in metres from the eye to the nearest and farthest bounds of a scene, or to its walls."""
    nearest, farthest = distances_to_bounds(scene, start.eye)
    if not start.is_outside and viewpoint.is_roofed(scene, start.eye):
        distances = viewpoint.horizontal_distances(scene, start.eye)
        farthest = min(farthest, float(np.percentile(np.minimum(distances, farthest), WALL_PERCENTILE)))
    return nearest, farthest
