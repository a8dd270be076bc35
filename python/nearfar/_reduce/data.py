"""Content of a reduced scene, and how copies with changes share it."""

from __future__ import annotations

import copy
from collections.abc import Mapping
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check, progress
from nearfar._cubemap import envmap
from nearfar._cubemap.envmap import EnvMap
from nearfar._partition.partition import Partition
from nearfar._reduce import stages
from nearfar._reduce.baking import MapSettings
from nearfar._reduce.default_radii import join
from nearfar._reduce.drawing import BOUNDARIES, Boundary, MorphKind, MorphSettings, check_morph, rows_of
from nearfar._scene.scene import Scene


class ReducedData:
    """Near geometry, map and settings of a reduced scene; the base of `ReducedScene` and its mixins.

    `is_whole` states whether `scene` is the whole original scene, which can be baked again.
    """

    def __init__(
        self,
        scene: Scene,
        zones: Partition,
        env: EnvMap | None,
        *,
        morph: MorphKind,
        boundary: Boundary,
        counts: dict[str, int],
        is_whole: bool = True,
        baking: MapSettings | None = None,
    ) -> None:
        self._scene = check.instance("scene", scene, Scene)
        self._partition, self._env = check.instance("zones", zones, Partition), env
        if env is not None:
            check.instance("env", env, EnvMap, "an EnvMap")
        check_morph(morph, check.choice("boundary", boundary, BOUNDARIES))
        check.instance("counts", counts, dict)
        is_whole = check.flag("is_whole", is_whole)
        self._morph, self._boundary, self._counts, self._is_whole = morph, boundary, counts, is_whole
        self._unposed, self._poses = scene, dict[str, ArrayLike]()
        self._drawing = MorphSettings()
        self._reasons: Mapping[str, str] = {}
        self._has_warned = [False]
        """Whether a folded picture was reported, in a list of one that copies share."""
        self._baking = MapSettings() if baking is None else check.instance("baking", baking, MapSettings)
        self._cached_by_levels: tuple[NDArray[np.int64], Self] | None = None
        """The last levels of detail, and this reduced scene at these levels."""
        rows = None
        if env is not None:
            rows = {"size": env.face_size} | {name: rows_of(getattr(env, name)) for name in env.channels}
        with progress.bar("gathering near geometry") as report:
            self._core = _core.Reduced(
                zones._core, morph=morph, boundary=self._boundary_radius, map=rows, report=report
            )

    @property
    def scene(self) -> Scene:
        """The scene that was reduced; after `load` only its saved near part."""
        return self._scene

    @property
    def partition(self) -> Partition:
        """Zones of the scene's triangles."""
        return self._partition

    @property
    def env(self) -> EnvMap | None:
        """Environment map of the far part; None if nothing lies beyond the near part."""
        return self._env

    @property
    def center(self) -> tuple[float, float, float]:
        """World position of the centre O, metres."""
        return self._partition.center

    @property
    def r1(self) -> float:
        """Radius in metres inside which nothing is morphed."""
        return self._partition.r1

    @property
    def r2(self) -> float:
        """Radius in metres beyond which only the map is visible."""
        return self._partition.r2

    @property
    def morph(self) -> MorphKind:
        """Name of the morph that joins near and far part: "blend", "cylinder" or "none"."""
        return self._morph

    @property
    def reason(self) -> str:
        """Centre and radii that `reduce` chose, and why, in words; empty if the caller set them."""
        return join(self._reasons)

    @property
    def stats(self) -> dict[str, Any]:
        """Counts of triangles, bytes and rays of the reduction; `Frame.stats` has those of a frame.

        Scene: `triangles`, and `near`, `intermediate`, `nsf` and `sf` as in `Partition.summary`; `drawn`, the number of
        triangles that a client draws, and `reduction` = triangles / drawn. Memory: `map_bytes`, and `near_bytes` for
        copies of near geometry. Baking: `rays` (0 on a graphics adapter) and `ranges_computed`.
        """
        counts = self._counts
        return {
            **{name: counts[name] for name in ("triangles", "near", "intermediate", "nsf", "sf")},
            "drawn": self.triangle_count,
            "reduction": counts["triangles"] / max(self.triangle_count, 1),
            "map_bytes": 0 if self._env is None else self._env.nbytes,
            "near_bytes": self._core.near_bytes,
            "rays": counts["rays"],
            "ranges_computed": 0 if self._env is None or self._env.range is None else self._env.range.size,
        }

    @property
    def origin(self) -> NDArray[np.float64]:
        """World position (3,) in metres that `Frame.position` is relative to, the scene's origin."""
        return self._scene.origin

    @property
    def default_channels(self) -> tuple[str, ...]:
        """Names of the images that are rendered by default: all that exist for far pixels."""
        if self._env is None or not self._drawing.env:
            return envmap.CHANNELS
        return self._env.channels

    @property
    def triangle_count(self) -> int:
        """Number of triangles that a client draws."""
        return self._counts["nsf" if self._boundary == "r2" else "nsf_at_r1"]

    @property
    def nbytes(self) -> int:
        """Bytes in memory of the map and of copies of near geometry."""
        return int(self.stats["map_bytes"] + self.stats["near_bytes"])

    @property
    def _boundary_radius(self) -> float:
        """Radius in metres at which the near part ends."""
        return self.r1 if self._boundary == "r1" else self.r2

    def at(self, poses: Mapping[str, ArrayLike]) -> Self:
        """Return the same reduced scene with dynamic objects in other poses, as `Scene.at` does."""
        return self._replace(_scene=self._scene.at(poses), _poses={**self._poses, **poses})

    def _replace(self, **attributes: Any) -> Self:
        """Copy, with new values of some attributes."""
        duplicate = copy.copy(self)
        duplicate.__dict__.update(attributes)
        return duplicate

    def _copy_with(
        self, scene: Scene, zones: Partition, counts: dict[str, int], *, morph: MorphKind | None = None
    ) -> Self:
        """Copy with the same map, but other near geometry or another morph."""
        reduced = type(self)(
            scene,
            zones,
            self._env,
            morph=self._morph if morph is None else morph,
            boundary=self._boundary,
            counts=counts,
            is_whole=self._is_whole,
            baking=self._baking,
        )
        return reduced._replace(_drawing=self._drawing, _reasons=self._reasons)

    @property
    def _original_scene(self) -> Scene:
        """The scene before the partition, which with unit "object" makes near objects dynamic."""
        return self._partition.source if self._partition.unit == "object" else self._unposed

    def _reduce_again(self, baking: MapSettings, **changes: Any) -> Self:
        """Reduce the scene again in the same pose, about another `center` or with another `r1` and `r2`."""
        place: dict[str, Any] = {"center": self.center, "r1": self.r1, "r2": self.r2, **changes}
        source = self._original_scene
        parts = stages.parts(source, **place, unit=self._partition.unit, boundary=self._boundary, baking=baking)
        again = type(self)(**parts, morph=self._morph, boundary=self._boundary, baking=baking)
        again = again._replace(_drawing=self._drawing)
        return again.at(self._poses) if self._poses else again
