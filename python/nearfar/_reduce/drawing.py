"""Render settings of reduced scenes, and how their morph moves bounding spheres."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any, Literal, TypedDict, get_args

import numpy as np
from numpy.typing import ArrayLike

from nearfar._base import check
from nearfar._base.settings import set_fields
from nearfar._morph import morph
from nearfar._render.settings import RenderKeywords
from nearfar._scene.levels import Leveled

MorphKind = Literal["blend", "cylinder", "none"]
"""Name of a morph; "none" is the conventional method."""
MORPHS: tuple[MorphKind, ...] = get_args(MorphKind)

Boundary = Literal["r1", "r2"]
"""Name of the radius at which the near part ends."""
BOUNDARIES: tuple[Boundary, ...] = get_args(Boundary)

Method = Literal["auto", "vertex", "exact"]
"""Name of a rendering method; "auto" bends rays if the picture of moved vertices would fold for the user."""

TOLERANCES = {"vertex": 0.5, "exact": 0.1}
"""Default tolerance in pixels of each rendering method."""

ConventionalDynamic = Literal["center", "user", "omit"]
"""How the conventional method places moving objects beyond the near part."""


@dataclass(frozen=True, kw_only=True)
class MorphSettings:
    """Settings for drawing a reduced scene: the method of the morph, its extent, and what lies beyond.

    ValueError and TypeError for settings out of range.

    Parameters
    ----------
    method
        "vertex": the morph moves vertices, as a vertex shader would. "exact": every pixel shows the first hit of its
        bent ray (`bend_rays`) in the unmorphed scene. "auto": "exact" where moved vertices would fold the picture and
        rays can be bent (on the CPU, for one eye, whole rays), else "vertex".
    env
        True draws the far part from the map. False traces it from the centre, so that all channels exist; this is the
        method's picture with a map of unlimited resolution.
    tolerance_px
        For "vertex": greatest distance, in the image's finest pixels, between a drawn triangle's points and their
        morph, by default 0.5; larger triangles are split for the frame. It is a proven bound if the frame's `stats`
        have `tolerance_held`. On the CPU it is doubled until splitting makes at most 4 million triangles. Infinity
        morphs only the given vertices, which bends long triangles wrongly and opens breaks at both radii. For "exact":
        greatest distance between a bent ray and its curve, in pixels of the size at its place in the image, by default
        0.1.
    radius
        Radius of the morph in metres instead of r2, 0 to r2; r1 shrinks in proportion. Near geometry beyond it is
        drawn, too, as seen from the centre; with 0 that is everything. A client that increases it over several frames
        shows near geometry without a jump. None is r2, or the radius of `ReducedScene.with_growth`. Not for the
        conventional method.
    strength
        Factor of the weight of the user's view, 0 to 1. With 0 everything is shown as the centre sees it. Below 1 near
        geometry within r1 moves too, also for users for whom a smaller radius would fold the picture; rays are then
        bent one by one, which takes "exact" several times as long, and `tolerance_held` is False. None is 1, or the
        strength of `ReducedScene.with_growth`. Not for the conventional method.
    conventional_dynamic
        Where the conventional method shows moving objects beyond the near part. "center": in the direction in which the
        centre sees them, if nothing in the map is nearer. "user": in the direction in which the user sees them, over
        everything in the map, as in figure 1d of the paper. "omit": nowhere. A morph takes only "center".
    """

    method: Method = "auto"
    env: bool = True
    tolerance_px: float | None = None
    radius: float | None = None
    strength: float | None = None
    conventional_dynamic: ConventionalDynamic = "center"

    def __post_init__(self) -> None:
        check.choice("method", self.method, get_args(Method))
        check.choice("conventional_dynamic", self.conventional_dynamic, get_args(ConventionalDynamic))
        set_fields(self, env=check.flag("env", self.env))
        if self.tolerance_px is not None:
            tolerance = check.number("tolerance_px", self.tolerance_px, finite=False)
            if not tolerance > 0.0:
                raise ValueError(f"tolerance_px: expected a number above 0, got {self.tolerance_px}")
            set_fields(self, tolerance_px=tolerance)
        if self.radius is not None:
            set_fields(self, radius=check.at_least_zero("radius", self.radius))
        if self.strength is not None:
            set_fields(self, strength=check.in_range("strength", self.strength, 0.0, 1.0))

    @property
    def growth(self) -> tuple[float | None, float]:
        """Radius of the morph in metres, None for r2, and its strength."""
        return self.radius, 1.0 if self.strength is None else self.strength


class MorphKeywords(TypedDict, total=False):
    """Fields of `MorphSettings` as keywords; a test compares both."""

    method: Method
    env: bool
    tolerance_px: float | None
    radius: float | None
    strength: float | None
    conventional_dynamic: ConventionalDynamic


class MorphOptions(RenderKeywords, MorphKeywords, total=False):
    """Keywords of `ReducedScene.render`."""


def fill_growth(settings: MorphSettings, defaults: MorphSettings) -> MorphSettings:
    """Replace a radius or strength of None by that of `defaults`."""
    radius = defaults.radius if settings.radius is None else settings.radius
    strength = defaults.strength if settings.strength is None else settings.strength
    return replace(settings, radius=radius, strength=strength)


def grow_radii(settings: MorphSettings, r1: float, r2: float) -> dict[str, Any]:
    """Return the morph's radii in metres and strength as arguments of `morph`; `r1` and `r2` are the reduction's."""
    radius, strength = settings.growth
    if radius is None or radius >= r2:
        return {"r1": r1, "r2": r2, "strength": strength}
    return {"r1": r1 * (radius / r2), "r2": radius, "strength": strength}


def kernel_settings(settings: MorphSettings, method: str) -> dict[str, Any]:
    """Kernel settings for "vertex" or "exact"."""
    radius, strength = settings.growth
    return {
        "method": method,
        "mapped": settings.env,
        "tolerance_px": TOLERANCES[method] if settings.tolerance_px is None else settings.tolerance_px,
        "radius": radius,
        "strength": strength,
        "conventional_dynamic": settings.conventional_dynamic,
    }


def check_morph(morph: MorphKind, boundary: Boundary) -> None:
    """Raise ValueError for an unknown morph, or for a continuous one with a map baked from r1."""
    check.choice("morph", morph, MORPHS)
    if boundary == "r1" and morph != "none":
        raise ValueError(f"boundary: expected 'r2' with morph={morph!r}, got 'r1', which needs morph='none'")


def morph_spheres(
    leveled: Leveled, user: ArrayLike, *, center: tuple[float, float, float], kind: str, growth: dict[str, Any]
) -> Leveled:
    """Move the bounding spheres of objects with levels to where a near–far morph shows them.

    The morph shows a ball of radius r within r (1 + |U−O| (2/(r2−r1) + 1/r1)) of its displayed centre: the morph's
    weight changes by at most 1/(r2−r1) per metre, and a change of the weight from 0 to 1 moves a point by at most
    2 |U−O|. Without a near zone the user sees the ball as the centre does, with the cylinder up to |U−O| nearer or
    farther. Below full strength points near the user move, too, each by at most 2 |U−O|.
    """
    r1, r2, strength = growth["r1"], growth["r2"], growth["strength"]
    eye = check.vector("user", user)
    distance = math.dist(eye, center)
    if r2 == 0.0 or strength == 0.0:
        centers = leveled.centers + np.subtract(eye, center)
        return replace(leveled, centers=centers, radii=leveled.radii + (distance if kind == "cylinder" else 0.0))
    centers = morph(leveled.centers, user=user, center=center, kind=kind, **growth)
    if strength < 1.0 or r2 < 1e-100:  # the inverse of a smaller radius overflows
        return replace(leveled, centers=centers, radii=leveled.radii + 4.0 * distance)
    stretch = 1.0 + distance * (2.0 / (r2 - r1) + 1.0 / max(r1, distance, 1e-300))
    return replace(leveled, centers=centers, radii=leveled.radii * stretch)


def rows_of(channel: Any) -> Any:
    """Reshape a map's channel to rows of texels of a type that kernels accept."""
    channel = channel.astype(np.float32) if channel.dtype == np.float16 else channel
    return np.reshape(channel, (-1, 3) if channel.ndim == 4 else -1)
