"""Splitting of the large triangles of rings, so that a per-vertex morph matches ray bending within a tolerance."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from nearfar import _core
from nearfar._base import progress
from nearfar.stream._assign import Rings
from nearfar.stream._detail import EYE_PIXELS_PER_DEGREE, Detail
from nearfar.stream._manifest import NEAR_SHARE

MAX_REACH = 0.348
"""Greatest distance of users from a centre, as a share of the first radius, for which the error is bounded."""

MAX_ADDED_TRIANGLES = 10_000_000
"""Triangles that splitting may add to a region; several times as many as the rings of the largest scenes have."""

COARSEST = 8
"""Factor on the tolerance of the first trial split, which only counts triangles."""


@dataclass(frozen=True)
class Splitting:
    """Tolerated error of the vertex morph, and the users for whom it holds."""

    tolerance: float
    """Greatest error, radians."""
    reach: float
    """Greatest distance of a user from a centre, metres."""

    @classmethod
    def from_pixels(cls, split_px: float | None, detail: Detail) -> Splitting | None:
        """Convert an error in pixels of the client's display; None if nothing is to be split."""
        pixels_per_degree = detail.pixels_per_degree or EYE_PIXELS_PER_DEGREE
        return None if split_px is None else cls(split_px * math.radians(1.0 / pixels_per_degree), detail.reach)

    def check(self, center: tuple[float, float, float], radii: tuple[float, ...]) -> None:
        """Raise ValueError if the rings about a centre cannot be split within the tolerance."""
        if self.reach > MAX_REACH * radii[0]:
            raise ValueError(
                f"radii: expected a first radius of at least {self.reach / MAX_REACH:.3f} m with split_px, for users "
                f"up to {self.reach:g} m from a centre, got {radii[0]:g} m"
            )
        no_mesh: Any = {"vertices": np.zeros((0, 3)), "faces": np.zeros((0, 3), np.uint32)}
        try:
            for ring in range(1, len(radii) + 1):
                _core.tessellate_arrays(**no_mesh, **self._settings(center, radii, ring))
        except ValueError as error:
            raise ValueError(f"split_px: {error}") from None

    def split(self, rings: Rings) -> Rings:
        """Return the rings with the static triangles of each split for its own growth and for all later radii.

        ValueError for a ring that cannot be split finely enough, or that would add too many triangles.
        """
        addable = MAX_ADDED_TRIANGLES
        core, codes = rings.scene._core, rings.codes()
        with progress.bar("splitting") as report:
            for ring in sorted({*codes.tolist()} & {*range(1, rings.count + 1)}):
                settings = {**self._settings(rings.center, rings.radii, ring), "chosen": codes == ring}
                try:
                    core, added = _split_within(addable, core, {**settings, "report": report})
                except ValueError as error:
                    raise ValueError(f"split_px: too small for ring {ring} of this scene: {error}") from None
                addable -= added
        return replace(rings, scene=rings.scene._derived(core, rings.scene._rest))

    def _settings(self, center: tuple[float, float, float], radii: tuple[float, ...], ring: int) -> dict[str, Any]:
        return {"center": center, **stages(radii, ring), "reach": self.reach, "tolerance": self.tolerance}


def _split_within(addable: int, core: Any, settings: dict[str, Any]) -> tuple[Any, int]:
    """Split triangles if that adds at most `addable`; return the scene and the number of added triangles.

    The number grows at most with the square of the fineness. Where it could exceed the limit, coarser splits are
    counted first, so that a split that is too fine ends long before memory is exhausted.
    """
    times = COARSEST
    while True:
        tolerance = times * settings["tolerance"]
        split, counts = _core.tessellate_scene(core, **{**settings, "tolerance": tolerance})
        added = counts["after"] - counts["before"]
        if added > addable:
            raise ValueError(
                f"it would add more than {MAX_ADDED_TRIANGLES:,} triangles to the rings; choose more pixels, fewer "
                "pixels_per_degree or a greater first radius, or leave splitting to the client"
            )
        if times == 1:
            return split, added
        times = 1 if added * times**2 <= addable else times // 2


def stages(radii: tuple[float, ...], ring: int) -> dict[str, Any]:
    """Return the radii of the last morph, and the range of stages in which a ring's objects are shown.

    The range begins with the ring's arrival. Ring 1 grows by strength at its own radius, others from the one before.
    """
    last = radii[-1]
    return {"radii": (NEAR_SHARE * last, last), "stages": (radii[max(ring - 2, 0)], ring > 1)}
