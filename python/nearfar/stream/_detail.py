"""Detail that a client can see: levels of objects, sizes of textures, and splits of large triangles of rings.

Triangles are split so that a morph of vertices matches ray bending within a tolerance.
"""

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

MAX_REACH = 0.348
"""Greatest distance of users from a centre, as a share of the first radius, for which the error is bounded."""

MAX_ADDED_TRIANGLES = 10_000_000
"""Triangles that splitting may add to a region; several times as many as the rings of the largest scenes have."""

COARSEST = 8
"""Factor on the tolerance of the first trial split, which only counts triangles."""


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

        Levels are selected as if each object were straight ahead, where the lens and the eye show it largest.
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

        On every face texels stay at most as large as the client's pixels, measured along the texels' finest direction.
        Texels that were larger before are not halved. Textures that no ring shows become one texel.
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

    The last entry is for the faces without an object. Objects in no ring have infinity, dynamic objects 0. A point at ρ
    is at least ρ − reach away. The morph's weight changes by at most 1/(0.3 R) per metre, R ≥ ρ and R ≥ R₁, and the two
    directions that it blends differ by at most reach/(ρ − reach), so it magnifies by at most 1 + reach/(0.3 R).
    """
    least_of_rest = (0.0, *rings.radii, np.inf)[rings.rest - 1] if rings.rest <= rings.count else np.inf
    least = np.append(rings.least.astype(np.float64), least_of_rest)
    radii = np.maximum(least, rings.radii[0])
    distances: NDArray[np.float64] = np.maximum(least - reach, 0.0) / (1.0 + reach / ((1.0 - NEAR_SHARE) * radii))
    distances[:-1][rings.ring == 0] = 0.0
    return distances


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
        no_mesh = np.zeros((0, 3)), np.zeros((0, 3), np.uint32)
        try:
            for ring in range(1, len(radii) + 1):
                _core.tessellate_arrays(*no_mesh, self._settings(center, radii, ring))
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
                    core, added = _split_within(addable, core, settings, report)
                except ValueError as error:
                    raise ValueError(f"split_px: too small for ring {ring} of this scene: {error}") from None
                addable -= added
        return replace(rings, scene=rings.scene._derived(core, rings.scene._load_placements))

    def _settings(self, center: tuple[float, float, float], radii: tuple[float, ...], ring: int) -> dict[str, Any]:
        return {"center": center, **stages(radii, ring), "reach": self.reach, "tolerance": self.tolerance}


def _split_within(addable: int, core: Any, settings: dict[str, Any], report: progress.Report) -> tuple[Any, int]:
    """Split triangles if that adds at most `addable`; return the scene and the number of added triangles.

    The number of triangles grows at most with the square of the fineness. Coarser splits are counted first if it could
    exceed the limit, so that too fine a split is refused long before memory is exhausted.
    """
    times = COARSEST
    while True:
        coarser = {**settings, "tolerance": times * settings["tolerance"]}
        split, counts = _core.tessellate_scene(core, coarser, report=report)
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

    The range begins with the ring's arrival. Ring 1 grows in strength at its own radius; the other rings grow from the
    previous ring's radius.
    """
    last = radii[-1]
    return {"radii": (NEAR_SHARE * last, last), "grown": (radii[max(ring - 2, 0)], ring > 1)}
