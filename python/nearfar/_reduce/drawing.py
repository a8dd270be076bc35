"""Render settings of reduced scenes, and the effect of their morph on bounding spheres."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from nearfar._base import check
from nearfar._morph import morph
from nearfar._scene.levels import Leveled

MORPHS = ("blend", "cylinder", "none")
"""Morphs by name; "none" is the conventional method."""

TOLERANCES = {"vertex": 0.5, "exact": 0.1}
"""Default tolerance in pixels of each rendering method."""

CONVENTIONAL_DYNAMIC = ("center", "user", "omit")
"""Names of the placements of moving objects beyond the near part with the conventional method."""

METHODS = ("auto", *TOLERANCES)
"""Names of rendering methods; "auto" bends rays if the picture of moved vertices would fold for the user."""


@dataclass(frozen=True)
class Drawing:
    """Settings for drawing a reduced scene; `ReducedScene.render` documents them."""

    method: str = "auto"
    env: bool = True
    tolerance_px: float | None = None
    radius: float | None = None
    strength: float = 1.0
    conventional_dynamic: str = "center"

    def __post_init__(self) -> None:
        check.choice("method", self.method, METHODS)
        check.choice("conventional_dynamic", self.conventional_dynamic, CONVENTIONAL_DYNAMIC)
        object.__setattr__(self, "env", check.flag("env", self.env))
        if self.tolerance_px is not None:
            object.__setattr__(self, "tolerance_px", check.number("tolerance_px", self.tolerance_px, finite=False))
        if self.radius is not None:
            object.__setattr__(self, "radius", check.at_least_zero("radius", self.radius))
        object.__setattr__(self, "strength", check.in_range("strength", self.strength, 0.0, 1.0))

    def grown(self, r1: float, r2: float) -> dict[str, Any]:
        """Effective radii in metres and strength, as arguments of `morph`, for the radii of the reduction."""
        radius = r2 if self.radius is None else min(float(self.radius), r2)
        near, far = (r1, r2) if radius == r2 else (r1 * (radius / r2), radius)
        return {"r1": near, "r2": far, "strength": self.strength}

    def settings(self, method: str) -> dict[str, Any]:
        """Kernel settings for "vertex" or "exact"."""
        tolerance = TOLERANCES[method] if self.tolerance_px is None else self.tolerance_px
        return {
            "method": method,
            "mapped": self.env,
            "tolerance_px": tolerance,
            "radius": self.radius,
            "strength": self.strength,
            "conventional_dynamic": self.conventional_dynamic,
        }


def check_morph(morph: str, boundary: str) -> None:
    """Raise ValueError for an unknown morph, or for a continuous one with a map baked from r1."""
    check.choice("morph", morph, MORPHS)
    if boundary == "r1" and morph != "none":
        raise ValueError(f"boundary: expected 'r2' with morph={morph!r}, got 'r1', which only morph='none' knows")


def morphed(
    leveled: Leveled, user: ArrayLike, *, center: tuple[float, float, float], kind: str, grown: dict[str, Any]
) -> Leveled:
    """Move the bounding spheres of objects with levels to where a near–far morph shows them.

    The morph shows a ball of radius r within r (1 + |U−O| (2/(r2−r1) + 1/r1)) of its displayed centre: the morph's
    weight changes by at most 1/(r2−r1) per metre, and a change of the weight from 0 to 1 moves a point by at most
    2 |U−O|. Without a near zone the user sees the ball as the centre does, with the cylinder up to |U−O| nearer or
    farther. Below full strength points near the user move, too, each by at most 2 |U−O|.
    """
    r2, strength = grown["r2"], grown["strength"]
    place = check.vector("user", user)
    away = math.dist(place, center)
    if r2 == 0.0 or strength == 0.0:
        moved = leveled.centers + np.subtract(place, center)
        return replace(leveled, centers=moved, radii=leveled.radii + (away if kind == "cylinder" else 0.0))
    shown = morph(leveled.centers, user=user, center=center, kind=kind, **grown)
    if strength < 1.0 or r2 < 1e-100:  # the inverse of a smaller radius overflows
        return replace(leveled, centers=shown, radii=leveled.radii + 4.0 * away)
    stretch = 1.0 + away * (2.0 / (r2 - grown["r1"]) + 1.0 / max(grown["r1"], away, 1e-300))
    return replace(leveled, centers=shown, radii=leveled.radii * stretch)


def rows_of(channel: Any) -> Any:
    """Reshape a map's channel to rows of texels, in a type that kernels read."""
    channel = channel.astype(np.float32) if channel.dtype == np.float16 else channel
    return np.reshape(channel, (-1, 3) if channel.ndim == 4 else -1)
