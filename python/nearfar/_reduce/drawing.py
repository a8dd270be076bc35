"""Settings of a reduced scene's pictures, and where its morph shows spheres."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from nearfar._base import check
from nearfar._morph import morph
from nearfar._scene.levels import Leveled

MORPHS = ("blend", "cylinder", "none")

TOLERANCES = {"vertex": 0.5, "exact": 0.1}
"""Pixels, for each method of rendering."""


@dataclass(frozen=True)
class Drawing:
    """How a reduced scene is drawn; `ReducedScene.render` says what each means."""

    method: str = "vertex"
    env: bool = True
    tolerance_px: float | None = None

    @classmethod
    def checked(cls, method: str, env: bool, tolerance_px: float | None) -> Drawing:
        """Refuse other values."""
        check.choice("method", method, tuple(TOLERANCES))
        if not isinstance(env, bool):
            raise TypeError(f"env: expected True or False, got {type(env).__name__}")
        tolerance = None if tolerance_px is None else check.number("tolerance_px", tolerance_px, finite=False)
        return cls(method, env, tolerance)

    @property
    def tolerance(self) -> float:
        """`tolerance_px`, or the method's own."""
        return TOLERANCES[self.method] if self.tolerance_px is None else self.tolerance_px


def check_morph(morph: str, boundary: str) -> None:
    """ValueError for a morph that is none, and one that a map from r1 does not reach."""
    check.choice("morph", morph, MORPHS)
    if boundary == "r1" and morph != "none":
        raise ValueError(f"boundary: expected 'r2' with morph={morph!r}, got 'r1', which only morph='none' knows")


def morphed(
    leveled: Leveled, user: ArrayLike, *, center: tuple[float, float, float], r1: float, r2: float, kind: str
) -> Leveled:
    """Objects with levels where a near–far morph shows their spheres.

    A ball of radius r is shown within r (1 + |U−O| (2/(r2−r1) + 1/r1)) of where its middle is shown: the weight of the
    morph changes by at most 1/(r2−r1) a metre, and a whole change of weight moves a point by at most 2 |U−O|.
    """
    away = float(np.linalg.norm(np.subtract(user, center)))
    shown = morph(leveled.centers, user=user, center=center, r1=r1, r2=r2, kind=kind)
    stretch = 1.0 + away * (2.0 / (r2 - r1) + 1.0 / max(r1, away, 1e-300))
    return replace(leveled, centers=shown, radii=leveled.radii * stretch)
