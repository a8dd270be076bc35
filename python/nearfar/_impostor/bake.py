"""Baking of impostors: checks the arguments, chooses the error for a budget, and puts near and far part together."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any, SupportsFloat, SupportsIndex

import numpy as np
from numpy.typing import ArrayLike

from nearfar import _core
from nearfar._base import check, progress
from nearfar._impostor.impostors import Impostors
from nearfar._impostor.quads import Point, Quads
from nearfar._partition.partition import partition
from nearfar._scene.joined import join_scenes
from nearfar._scene.scene import Scene, core_of

PIXELS_PER_DEGREE = 20.0
"""Density of the pixels in which errors are stated: a headset's, in the middle of its picture."""

MAX_ERROR_PX = 100.0
"""Greatest error, pixels."""
BUDGET_ERROR_PX = 8.0
"""Greatest error, pixels, that a budget of triangles chooses."""
MAX_FACE_SIZE = 8192
"""Greatest width of a face of a layer's cube map, texels."""
MAX_CENTERS = 64

_MAX_BAKES = 5
"""Greatest number of bakes for one budget."""
_FULL = 0.95
"""Share of a budget from which no finer error is looked for."""


def bake_impostors(
    scene: Scene,
    *,
    center: ArrayLike,
    reach: SupportsFloat = 8.0,
    r2: SupportsFloat = 50.0,
    error_px: SupportsFloat = 2.0,
    face_size: SupportsIndex = 1024,
    centers: SupportsIndex = 16,
    missing: SupportsFloat = 0.0005,
    triangles: SupportsIndex | None = None,
) -> Impostors:
    """Bake the far part of a scene as textured quads, which keep their parallax for users within a region.

    The quads are baked on the CPU from several centres: O, up to six on the circle of radius `reach` about O, and then
    wherever most is missing. The result has no quads if no static triangle lies beyond r2 as a whole. ValueError and
    TypeError for arguments out of range, or a `face_size` whose quads do not fit into one texture. Related: Seurat
    (Lall et al. 2018), layered meshes (Broxton et al. 2020), QUASAR (Lu et al. 2025).

    Parameters
    ----------
    scene
        The scene. Dynamic objects stay geometry, whatever their distance, and so do triangles that reach inside r2.
    center
        World position O in metres: the middle of the users' region, at the height of their eyes.
    reach
        Radius in metres of the sphere about O within which the error holds for users' eyes.
    r2
        Radius in metres about the vertical axis through O, above `reach`. Static triangles that lie beyond it as a
        whole are baked.
    error_px
        Greatest angle, in pixels of a headset with 20 pixels per degree, above 0 to 100, by which a user within `reach`
        sees the centre of a texel beside its place.
    face_size
        Number of texels across each face of a centre's cube map, 64 to 8192. 1024 is 11 texels per degree.
    centers
        Greatest number of centres, 1 to 64.
    missing
        Share of the pixels of the region's probes, 0 to 1, that may be missing when no centre is added.
    triangles
        Greatest number of triangles of the far part, at least 1; None for no limit. If they are more, `error_px` grows,
        up to 8 px, by at most four more bakes, and the result has the error that was chosen. If they are still more,
        the quads that show fewest texels are dropped, which leaves holes; the result's `stats` count them.
    """
    core_of(scene)
    middle, settings = _check(center, reach, r2, error_px, face_size, centers, missing)
    limit = None if triangles is None else check.integer("triangles", triangles, 1, np.iinfo(np.int64).max)
    zones = partition(scene, center=middle, r1=0.0, r2=settings.r2)
    counts = zones.summary()
    near_numbers = zones.nsf
    near = scene.subset(triangles=near_numbers)
    bakes = _Bakes(scene, settings)
    baked = bakes.choose(limit) if counts["sf"] > counts["straddling"] else None
    quads = None if baked is None else baked.quads if limit is None else baked.quads.keep_largest(limit)
    far = quads.scene(middle, scene.origin, scene.object_names) if quads is not None and len(quads) else None
    dropped = 0 if baked is None or quads is None else int(baked.quads.texels.sum() - quads.texels.sum())
    return Impostors(
        center=middle,
        reach=settings.reach,
        r2=settings.r2,
        error_px=settings.error_px if baked is None else baked.error_px,
        face_size=settings.face_size,
        far=far,
        near=near if len(near_numbers) else None,
        scene=near if far is None else join_scenes([near, far]),
        _quads=quads if far is not None else None,
        _counts={
            "scene_triangles": scene.triangle_count,
            "missing": 0.0 if baked is None else baked.missing,
            "bakes": bakes.count,
            "dropped_quads": 0 if baked is None or quads is None else len(baked.quads) - len(quads),
            "dropped_texels": dropped,
        },
    )


@dataclass(frozen=True)
class _Settings:
    """Checked settings of a bake, as `bake_impostors` takes them."""

    center: Point
    reach: float
    r2: float
    error_px: float
    face_size: int
    centers: int
    missing: float

    def for_kernel(self) -> dict[str, Any]:
        return {
            "center": self.center,
            "reach": self.reach,
            "height": min(0.5, 0.5 * self.reach),
            "r2": self.r2,
            "size": self.face_size,
            "angle": math.radians(self.error_px / PIXELS_PER_DEGREE),
            "centers": self.centers,
            "missing": self.missing,
        }


def _check(
    center: ArrayLike,
    reach: SupportsFloat,
    r2: SupportsFloat,
    error_px: SupportsFloat,
    face_size: SupportsIndex,
    centers: SupportsIndex,
    missing: SupportsFloat,
) -> tuple[Point, _Settings]:
    middle = check.vector("center", center)
    if max(map(abs, middle)) > check.FARTHEST:
        raise ValueError(f"center: expected coordinates within ±{check.FARTHEST:g} m, got {middle}")
    inner, outer = check.positive("reach", reach), check.positive("r2", r2)
    if not outer > inner:
        raise ValueError(f"r2: expected more than reach = {inner:g} m, got {outer:g}")
    error = check.positive("error_px", error_px)
    settings = _Settings(
        center=middle,
        reach=inner,
        r2=outer,
        error_px=check.in_range("error_px", error, 0.0, MAX_ERROR_PX),
        face_size=check.integer("face_size", face_size, 64, MAX_FACE_SIZE),
        centers=check.integer("centers", centers, 1, MAX_CENTERS),
        missing=check.in_range("missing", missing, 0.0, 1.0),
    )
    return middle, settings


@dataclass(frozen=True)
class _Baked:
    """Quads, the error that they were baked with, and the share of the probes' pixels that are missing."""

    quads: Quads
    error_px: float
    missing: float


class _Bakes:
    """Bakes of one scene with several errors."""

    def __init__(self, scene: Scene, settings: _Settings) -> None:
        self._scene, self._settings = scene, settings
        self.count = 0
        """Number of bakes so far."""

    def choose(self, triangles: int | None) -> _Baked:
        """Bake with the least error found that keeps a budget of triangles, or with the greatest if none does."""
        finest = self._bake(self._settings.error_px)
        if triangles is None or len(finest.quads.faces) <= triangles or finest.error_px >= BUDGET_ERROR_PX:
            return finest
        coarse = self._bake(BUDGET_ERROR_PX)
        while len(coarse.quads.faces) < _FULL * triangles and self.count < _MAX_BAKES:
            middle = self._bake(math.sqrt(finest.error_px * coarse.error_px))
            if len(middle.quads.faces) <= triangles:
                coarse = middle
            else:
                finest = middle
        return coarse

    def _bake(self, error_px: float) -> _Baked:
        self.count += 1
        settings = replace(self._settings, error_px=error_px).for_kernel()
        with progress.bar("baking impostors") as report:
            baked = _core.bake_impostors(self._scene._core, settings, report=report)
        return _Baked(Quads.from_kernel(baked), error_px, float(baked["missing"][-1]))
