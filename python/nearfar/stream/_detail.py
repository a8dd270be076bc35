"""Detail that a client can see: levels of objects and sizes of textures for given viewing distances."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import progress
from nearfar._camera.camera import Camera, Fov
from nearfar._render.level_choice import Lod, choose_levels, rule_of
from nearfar._scene.levels import Leveled
from nearfar.stream._assign import Rings
from nearfar.stream._manifest import NEAR_SHARE

MAX_HALVINGS = 32
"""Halvings that reduce any texture to one texel."""

EYE_PIXELS_PER_DEGREE = 60.0
"""Pixels per degree that the eye cannot resolve; used for unknown clients."""

VIEW_DEG = 90.0
"""Field of view for which levels are chosen, degrees; its width sets the object size from which level 0 is used."""


@dataclass(frozen=True)
class Detail:
    """Detail of a scene that a client can see."""

    rule: Any
    """Rule that chooses levels, as `rule_of` returns it; None for the scene's own meshes."""
    pixels_per_degree: float | None
    """Resolution of the client's display; None for unlimited resolution."""
    reach: float
    """Greatest horizontal distance between a user and a centre, metres."""

    @classmethod
    def from_options(
        cls, leveled: Leveled | None, lod: Lod | None, pixels_per_degree: float | None, reach: float
    ) -> Detail:
        """Check the rule for levels; ValueError if one is given and the scene has no levels."""
        if lod is None:
            return cls(None, pixels_per_degree, reach)
        if leveled is None:
            raise ValueError("lod: expected a scene whose objects have levels, got one without; see Scene.with_levels")
        return cls(rule_of(lod, leveled), pixels_per_degree, reach)

    def select_levels(self, rings: Rings) -> Rings:
        """Return the rings with each static object at the level for the nearest user position within `reach`.

        Selectors see all objects straight ahead, where they look largest through a lens and to the eye.
        """
        leveled = rings.scene.leveled
        if self.rule is None or leveled is None:
            return rings
        distances = np.linalg.norm(leveled.centers - rings.center, axis=1)
        ahead = np.zeros_like(leveled.centers)
        ahead[:, 2] = -np.maximum(distances - self.reach, 0.0)
        levels, _ = choose_levels(self.rule, replace(leveled, centers=ahead), [self._camera()])
        is_static = rings.ring[leveled.numbers] > 0
        return replace(rings, scene=rings.scene.at_levels(np.where(is_static, levels, 0)))

    def halvings(self, regions: Sequence[Rings]) -> NDArray[np.uint32]:
        """Return how often the sides of each texture can be halved while its texels suffice for all users.

        Along the direction in which they are finest, no face gets larger texels than the client's pixels, unless they
        were larger before. Textures that no ring shows become one texel.
        """
        count = regions[0].scene._core.texture_count
        if self.pixels_per_degree is None or not count:
            return np.zeros(count, np.uint32)
        texels, least = np.full(count, np.inf), [least_distances(rings, self.reach) for rings in regions]
        if self.rule is None:
            # All regions show the same levels.
            regions, least = regions[:1], [np.min(least, axis=0)]
        with progress.bar("textures") as report:
            for rings, distances in zip(regions, least, strict=True):
                core = self.select_levels(rings).scene._core
                np.minimum(texels, _core.texels_per_radian(core, distances, report=report), out=texels)
        with np.errstate(divide="ignore"):
            times = np.floor(np.log2(texels / math.degrees(self.pixels_per_degree)))
        return np.clip(times, 0, MAX_HALVINGS).astype(np.uint32)

    def _camera(self) -> Camera:
        """Return the client's view straight ahead."""
        focal_px = math.degrees(self.pixels_per_degree or EYE_PIXELS_PER_DEGREE)
        side = math.ceil(2.0 * math.tan(math.radians(VIEW_DEG / 2.0)) * focal_px)
        return Camera((0.0, 0.0, 0.0), fov=Fov.symmetric(VIEW_DEG), size=(side, side))


def least_distances(rings: Rings, reach: float) -> NDArray[np.float64]:
    """Return lower bounds (objects + 1,) of viewing distances in metres, including the morph's magnification.

    The last entry is for the faces without an object. It is infinite for objects in no ring, 0 for dynamic objects. A
    point at ρ is at least ρ − reach away. The morph's weight changes by at most 1/(0.3 R) per metre, R ≥ ρ and R ≥ R₁,
    and the two directions that it blends differ by at most reach/(ρ − reach), so it magnifies by at most
    1 + reach/(0.3 R).
    """
    rest = (0.0, *rings.radii, np.inf)[rings.rest - 1] if rings.rest <= rings.count else np.inf
    least = np.append(rings.least.astype(np.float64), rest)
    radii = np.maximum(least, rings.radii[0])
    distances: NDArray[np.float64] = np.maximum(least - reach, 0.0) / (1.0 + reach / ((1.0 - NEAR_SHARE) * radii))
    distances[:-1][rings.ring == 0] = 0.0
    return distances
