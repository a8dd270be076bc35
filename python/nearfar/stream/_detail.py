"""Detail that a client can see: levels of objects and sizes of textures for the distances from which it sees them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import progress
from nearfar._camera.camera import Camera, Fov
from nearfar._render.level_choice import Lod, choose_levels, rule_of
from nearfar._scene.scene import Scene
from nearfar.stream._assign import Rings
from nearfar.stream._manifest import NEAR_SHARE

MOST_HALVINGS = 32
"""Halvings that leave one texel of any texture."""

SHARPEST = 60.0
"""Pixels per degree of a display whose pixels the eye does not see, for clients that are not known."""

VIEW_DEG = 90.0
"""Field of view for which levels are chosen: of its width depends from which size on objects have level 0."""


@dataclass(frozen=True)
class Detail:
    """The detail of a scene that a client can see."""

    scene: Scene
    """The scene, whose objects may have levels."""
    rule: Any
    """How levels are chosen, as `rule_of` returns it; None for the meshes of the scene."""
    pixels_per_degree: float | None
    """Of the client's display; None for one that shows everything."""
    reach: float
    """Greatest horizontal distance of a user from a centre, metres."""

    @classmethod
    def of(cls, scene: Scene, lod: Lod | None, pixels_per_degree: float | None, reach: float) -> Detail:
        """Check how levels are to be chosen; ValueError for scenes without levels that are to be."""
        if lod is None:
            return cls(scene, None, pixels_per_degree, reach)
        leveled = scene.leveled
        if leveled is None:
            raise ValueError("lod: expected a scene whose objects have levels, got one without; see Scene.with_levels")
        return cls(scene, rule_of(lod, leveled), pixels_per_degree, reach)

    def shown(self, rings: Rings) -> Rings:
        """The rings with each static object at the level for a user within `reach` who is nearest to it.

        Selectors see all objects straight ahead, where they look largest through a lens and to the eye.
        """
        leveled = self.scene.leveled
        if self.rule is None or leveled is None:
            return rings
        away = np.linalg.norm(leveled.centers - rings.center, axis=1)
        ahead = np.zeros_like(leveled.centers)
        ahead[:, 2] = -np.maximum(away - self.reach, 0.0)
        levels, _ = choose_levels(self.rule, replace(leveled, centers=ahead), [self._camera()])
        is_static = rings.ring[leveled.numbers] > 0
        return replace(rings, scene=self.scene.at_levels(np.where(is_static, levels, 0)))

    def halvings(self, divided: Sequence[Rings]) -> NDArray[np.uint32]:
        """How often the sides of each texture are halved, so that its texels suffice wherever a user sees them.

        Along the direction in which they are finest, no face has larger texels than the client's pixels, unless they
        were larger. Textures that no ring shows become one texel.
        """
        count = self.scene._core.texture_count
        if self.pixels_per_degree is None or not count:
            return np.zeros(count, np.uint32)
        texels = np.full(count, np.inf)
        with progress.bar("textures") as report:
            for scene, distances in self._views(divided):
                np.minimum(texels, _core.texels_per_radian(scene._core, distances, report=report), out=texels)
        with np.errstate(divide="ignore"):
            times = np.floor(np.log2(texels / math.degrees(self.pixels_per_degree)))
        return np.clip(times, 0, MOST_HALVINGS).astype(np.uint32)

    def _views(self, divided: Sequence[Rings]) -> Iterator[tuple[Scene, NDArray[np.float64]]]:
        """Scenes with the least distances of their objects: one if no region shows other levels."""
        if self.rule is None:
            yield self.scene, np.min([least_distances(rings, self.reach) for rings in divided], axis=0)
        else:
            yield from ((self.shown(rings).scene, least_distances(rings, self.reach)) for rings in divided)

    def _camera(self) -> Camera:
        """The client's view of what lies straight ahead."""
        sharp = SHARPEST if self.pixels_per_degree is None else self.pixels_per_degree
        side = math.ceil(2.0 * math.tan(math.radians(VIEW_DEG / 2.0)) * math.degrees(sharp))
        return Camera((0.0, 0.0, 0.0), fov=Fov.symmetric(VIEW_DEG), size=(side, side))


def least_distances(rings: Rings, reach: float) -> NDArray[np.float64]:
    """Metres from which objects look as large as a user within `reach` can see them, (objects + 1,).

    The last is that of faces without an object. Infinite for what no ring shows, 0 for dynamic objects. A point at ρ is
    at least ρ − reach away. The morph's weight changes by at most 1/(0.3 R) a metre, R ≥ ρ and R ≥ R₁, and the two
    directions that it blends differ by at most reach/(ρ − reach): so it enlarges by at most 1 + reach/(0.3 R).
    """
    rest = (0.0, *rings.radii, np.inf)[rings.rest - 1] if rings.rest <= rings.count else np.inf
    least = np.append(rings.least.astype(np.float64), rest)
    radii = np.maximum(least, rings.radii[0])
    distances: NDArray[np.float64] = np.maximum(least - reach, 0.0) / (1.0 + reach / ((1.0 - NEAR_SHARE) * radii))
    distances[:-1][rings.ring == 0] = 0.0
    return distances
