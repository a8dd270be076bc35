"""Chooses the radii of a reduction so that the ground between them shears little for a walking user."""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import dataclass
from typing import ClassVar, TypedDict, Unpack

import numpy as np
from numpy.typing import ArrayLike

from nearfar._base import check
from nearfar._base.settings import Alternatives, gather, set_fields
from nearfar._bend import fold_margin
from nearfar._partition.load_curve import load_curve
from nearfar._scene.scene import Scene

Point = tuple[float, float, float]

STEPS = 24
"""Bisection steps for a radius: they shrink an interval to a millionth, below the error of margins, 1e-4."""


@dataclass(frozen=True, kw_only=True)
class RadiusSettings(Alternatives):
    """Requirements on the radii of a reduction for a walking user; functions that take them need `r2` or `budget`.

    ValueError and TypeError for both `r2` and `budget`, and settings out of range.

    Parameters
    ----------
    r2
        Radius in metres beyond which the map shows everything.
    budget
        Instead of `r2`: maximum number of triangles that stay geometry. r2 becomes the greatest radius within which
        there are no more.
    reach
        Distance R in metres that the user walks away from the centre, above 0.
    eye_height
        Height h in metres of the eyes above the ground, above 0.
    shear
        Greatest shear s of the ground between the radii, above 0: pixels sideways for each pixel upwards.
    """

    _alternatives: ClassVar = (("r2",), ("budget",))

    r2: float | None = None
    budget: int | None = None
    reach: float = 8.0
    eye_height: float = 1.7
    shear: float = 1.0

    def __post_init__(self) -> None:
        if self.r2 is not None and self.budget is not None:
            raise ValueError("r2: expected either r2 or budget, got both")
        if self.budget is not None:
            set_fields(self, budget=check.integer("budget", self.budget, 0, 2**63 - 1))
        names = ("r2", "reach", "eye_height", "shear")[self.r2 is None :]
        set_fields(self, **{name: check.positive(name, getattr(self, name)) for name in names})


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
    scene: Scene, center: ArrayLike, *, settings: RadiusSettings | None = None, **keywords: Unpack[RadiusKeywords]
) -> Radii:
    """Choose r1 so that the ground is sheared little for a walking user, for a given r2 or a budget of triangles.

    For a user at a distance R (`reach`) from the centre and a height h (`eye_height`) the ground between the radii is
    sheared by R r1 / ((r2 − r1) h) pixels per pixel. A shear of at most s thus needs r1 ≤ s h r2 / (R + s h). The user
    stays within r1, so r1 is at least R. The ground beyond r2 is sheared by R / h with every method that has one map.
    Returns r1 = max(R, s h r2 / (R + s h)), r2, and the resulting shear. If the picture would fold within R, r1 is
    smaller. If r2 is less than R (R + s h) / (s h), r1 is R, and the shear exceeds s; `remarks` say so. ValueError for
    neither or both of `r2` and `budget`, values that are not positive, or an r2 so small that the picture would fold
    within `reach`; TypeError for values of other types. Source: derived for the blend of Popescu, Lee, Choi, Fahmy
    (2022), Eq. 1–3.

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
    """
    check.instance("scene", scene, Scene)
    settings = complete_settings(gather(RadiusSettings, settings, keywords))
    r2 = _outer_radius(scene, check.vector("center", center), settings)
    reach, height, max_shear = settings.reach, settings.eye_height, settings.shear
    r1 = inner_radius(r2, reach, height, max_shear)
    margin = _margin(r1, r2)
    if margin < reach:
        name, verb = ("r2", "got") if settings.r2 is not None else ("budget", "which gives")
        raise ValueError(
            f"{name}: expected an r2 of at least {min_outer_radius(reach):.4g} m for a reach of {reach:g} m, because "
            f"the picture would fold within it, {verb} {r2:.4g}"
        )
    shear = shear_of(r1, r2, reach, height)
    remarks: tuple[str, ...] = ()
    if shear > 1.005 * max_shear:
        min_r2 = reach * (reach + max_shear * height) / (max_shear * height)
        remarks = (
            f"the ground between the radii is sheared by up to {shear:.2g} instead of {max_shear:g}: that needs r2 of "
            f"at least {min_r2:.3g} m",
        )
    return Radii(r1=r1, r2=r2, reach=reach, eye_height=height, shear=shear, fold_margin=margin, remarks=remarks)


def complete_settings(settings: RadiusSettings) -> RadiusSettings:
    """Return settings that have an r2 or a budget; ValueError otherwise."""
    if settings.r2 is None and settings.budget is None:
        raise ValueError("r2: expected either r2 or budget, got neither")
    return settings


@functools.cache
def inner_radius(r2: float, reach: float, height: float, shear: float) -> float:
    """Return r1 in metres for a reach, an eye's height and a shear; see `choose_radii`."""
    r1 = max(reach, shear * height * r2 / (reach + shear * height))
    if _margin(r1, r2) >= reach:
        return r1
    return _bisect(reach, r1, lambda inner: _margin(inner, r2) >= reach)[0]


def shear_of(r1: float, r2: float, reach: float, height: float) -> float:
    """Shear of the ground between the radii, pixels for each pixel, for a user `reach` metres beside the centre."""
    return reach * r1 / ((r2 - r1) * height)


def _outer_radius(scene: Scene, center: Point, settings: RadiusSettings) -> float:
    """Return the r2 of the settings, or the greatest r2 within the budget, but not beyond the whole scene."""
    if settings.budget is None:
        assert settings.r2 is not None
        return settings.r2
    radius = float(load_curve(scene, center=center).radius(settings.budget))
    return radius if np.isfinite(radius) else distances_to_bounds(scene, center)[1]


def distances_to_bounds(scene: Scene, point: Point) -> tuple[float, float]:
    """Horizontal distances in metres from a point to the nearest and to the farthest point of a scene's bounds."""
    low, high = scene.bounds[:, [0, 2]]
    x_z = np.array(point)[[0, 2]]
    nearest = np.hypot(*np.maximum(np.maximum(low - x_z, x_z - high), 0.0))
    return float(nearest), float(np.hypot(*np.maximum(np.abs(low - x_z), np.abs(high - x_z))))


def _margin(r1: float, r2: float) -> float:
    """Return the distance that a user may walk from the centre; −∞ unless r1 < r2."""
    return fold_margin((0, 0, 0), center=(0, 0, 0), r1=r1, r2=r2) if r1 < r2 else -np.inf


@functools.cache
def min_outer_radius(reach: float) -> float:
    """Return the least r2 in metres for which the fold margin of r1 = `reach` is `reach`; it is proportional to it."""
    return reach * _bisect(1.0, 4.0, lambda outer: _margin(1.0, outer) < 1.0)[1]


def _bisect(low: float, high: float, holds: Callable[[float], bool]) -> tuple[float, float]:
    """Bisect for the point where a condition, true at `low`, ends; return the last interval."""
    for _ in range(STEPS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if holds(middle) else (low, middle)
    return low, high
