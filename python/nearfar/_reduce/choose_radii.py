"""Chooses the radii of a reduction by the shear of the ground between them for a walking user."""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import dataclass
from typing import TypedDict, Unpack

import numpy as np
from numpy.typing import ArrayLike

from nearfar._base import check
from nearfar._base.settings import gather
from nearfar._bend import fold_margin
from nearfar._partition.load_curve import load_curve
from nearfar._scene.scene import Scene

STEPS = 24
"""Bisection steps for a radius: they leave less than a millionth of an interval; margins are exact to 1e-4 only."""


@dataclass(frozen=True, kw_only=True)
class RadiusSettings:
    """Requirements on the radii of a reduction for a walking user; either `r2` or `budget` must be set.

    Parameters
    ----------
    r2
        Radius in metres beyond which the map shows everything.
    budget
        Maximum number of triangles that stay geometry, instead of `r2`: r2 is the greatest radius within it.
    reach
        Distance R in metres that the user walks away from the centre, above 0.
    eye_height
        Height h in metres of the eyes above the ground, above 0.
    shear
        Greatest shear s of the ground between the radii, above 0: pixels sideways for each pixel upwards.

    Raises
    ------
    ValueError, TypeError
        Neither or both of `r2` and `budget`, and settings out of range.
    """

    r2: float | None = None
    budget: int | None = None
    reach: float = 8.0
    eye_height: float = 1.7
    shear: float = 1.0

    def __post_init__(self) -> None:
        if (self.r2 is None) == (self.budget is None):
            got = "neither" if self.r2 is None else "both"
            raise ValueError(f"r2: expected either r2 or budget, got {got}")
        if self.budget is not None:
            object.__setattr__(self, "budget", check.integer("budget", self.budget, 0, 2**63 - 1))
        for name in ("r2", "reach", "eye_height", "shear"):
            value = getattr(self, name)
            if name != "r2" or value is not None:
                object.__setattr__(self, name, check.positive(name, value))


class RadiusKeywords(TypedDict, total=False):
    """Fields of `RadiusSettings` as keywords; a test compares both."""

    r2: float | None
    budget: int | None
    reach: float
    eye_height: float
    shear: float


@dataclass(frozen=True, kw_only=True)
class Radii:
    """Radii of a reduction and their effect for a walking user; the result of `choose_radii`."""

    r1: float
    """Radius in metres inside which nothing is morphed."""
    r2: float
    """Radius in metres beyond which only the map is visible."""
    reach: float
    """Distance R in metres that the user may walk away from the centre."""
    eye_height: float
    """Height h in metres of the user's eyes above the ground."""
    shear: float
    """Greatest shear of the ground between the radii, seen from `reach`: pixels sideways for each pixel upwards."""
    fold_margin: float
    """Distance in metres from the centre at which the picture would fold; at least `reach`."""
    remarks: tuple[str, ...] = ()
    """Sentences on requirements that could not be met."""


def choose_radii(
    scene: Scene,
    center: ArrayLike,
    *,
    settings: RadiusSettings | None = None,
    **keywords: Unpack[RadiusKeywords],
) -> Radii:
    """Choose r1 so that the ground is sheared little for a walking user, for a given r2 or a budget of triangles.

    For a user at a distance R (`reach`) from the centre and a height h (`eye_height`) the ground between the radii is
    sheared by R r1 / ((r2 − r1) h) pixels per pixel. A shear of at most s thus needs r1 ≤ s h r2 / (R + s h). The user
    stays within r1, so r1 is at least R. The ground beyond r2 is sheared by R / h with every method that has one map.

    Parameters
    ----------
    scene
        The scene; its triangles count for a `budget`.
    center
        World position O, metres.
    settings
        Either r2 or a budget, and the user's reach R, eye height h and shear s, as `RadiusSettings`.
    keywords
        Fields of `settings`, which they replace: `r2`, `budget`, `reach`, `eye_height`, `shear`.

    Returns
    -------
    Radii
        r1 = max(R, s h r2 / (R + s h)), r2, and the resulting shear. r1 is smaller if the picture would fold within R.
        If r2 is less than R (R + s h) / (s h), r1 is R, and the shear exceeds s; `remarks` say so.

    Raises
    ------
    ValueError
        Neither or both of `r2` and `budget`; values that are not positive; or an r2 too small for `reach`, so that the
        picture would fold within it.
    TypeError
        Values of other types.

    Notes
    -----
    r1 = max(R, s h r2 / (R + s h)) for the blend of Popescu, Lee, Choi, Fahmy (2022), Eq. 1–3.
    """
    check.instance("scene", scene, Scene)
    chosen = gather(RadiusSettings, settings, keywords)
    outer = _outer(scene, check.vector("center", center), chosen)
    walked, height, wanted = chosen.reach, chosen.eye_height, chosen.shear
    inner = by_ground(outer, walked, height, wanted)
    margin = _margin(inner, outer)
    if margin < walked:
        name, given = ("r2", "got") if chosen.r2 is not None else ("budget", "which gives")
        raise ValueError(
            f"{name}: expected an r2 of at least {least_outer(walked):.4g} m for a reach of {walked:g} m, because the "
            f"picture would fold within it, {given} {outer:.4g}"
        )
    left = shear_of(inner, outer, walked, height)
    remarks: tuple[str, ...] = ()
    if left > 1.005 * wanted:
        least = walked * (walked + wanted * height) / (wanted * height)
        remarks = (
            f"the ground between the radii is sheared by up to {left:.2g} instead of {wanted:g}: that needs r2 of at "
            f"least {least:.3g} m",
        )
    return Radii(
        r1=inner,
        r2=outer,
        reach=walked,
        eye_height=height,
        shear=left,
        fold_margin=margin,
        remarks=remarks,
    )


def by_ground(r2: float, reach: float, height: float, shear: float) -> float:
    """Return r1 in metres for a reach, an eye's height and a shear; see `choose_radii`."""
    r1 = max(reach, shear * height * r2 / (reach + shear * height))
    if _margin(r1, r2) >= reach:
        return r1
    return _bisected(reach, r1, lambda inner: _margin(inner, r2) >= reach)[0]


def shear_of(r1: float, r2: float, reach: float, height: float) -> float:
    """Shear of the ground between the radii, pixels for each pixel, for a user `reach` metres beside the centre."""
    return reach * r1 / ((r2 - r1) * height)


def _outer(scene: Scene, center: tuple[float, float, float], settings: RadiusSettings) -> float:
    """Given r2, or the greatest within a budget; if the whole scene fits, the distance of its farthest corner."""
    if settings.budget is None:
        assert settings.r2 is not None
        return settings.r2
    radius = float(load_curve(scene, center=center).radius(settings.budget))
    if np.isfinite(radius):
        return radius
    low, high = scene.bounds[:, [0, 2]]
    here = np.array(center)[[0, 2]]
    return float(np.hypot(*np.maximum(np.abs(low - here), np.abs(high - here))))


def _margin(r1: float, r2: float) -> float:
    """Distance that a user may walk from the centre; negative if the radii leave no zone."""
    return fold_margin((0, 0, 0), center=(0, 0, 0), r1=r1, r2=r2) if r1 < r2 else -np.inf


def least_outer(reach: float) -> float:
    """Least r2 in metres at which r1 = `reach` leaves a margin of `reach`; all lengths scale alike."""
    return reach * _least_share()


@functools.cache
def _least_share() -> float:
    return _bisected(1.0, 4.0, lambda outer: _margin(1.0, outer) < 1.0)[1]


def _bisected(low: float, high: float, holds: Callable[[float], bool]) -> tuple[float, float]:
    """Bisect for the end of a condition that holds at `low`; return the last bracket."""
    for _ in range(STEPS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if holds(middle) else (low, middle)
    return low, high
