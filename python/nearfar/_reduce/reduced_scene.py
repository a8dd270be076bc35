"""Reduced scenes: near geometry and an environment map, as a thin client renders them."""

from __future__ import annotations

import copy
import os
from collections.abc import Mapping
from dataclasses import replace
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check, formats, progress
from nearfar._cubemap import envmap
from nearfar._cubemap.envmap import EnvMap
from nearfar._partition.partition import Partition, partition
from nearfar._reduce import folder, stages
from nearfar._reduce.baking import MapSettings
from nearfar._reduce.default_radii import join
from nearfar._reduce.drawing import (
    BOUNDARIES,
    Boundary,
    MorphKind,
    MorphSettings,
    check_morph,
    grow_radii,
    morphed,
    rows_of,
)
from nearfar._reduce.notebook import InNotebooks
from nearfar._reduce.pictures import InPictures
from nearfar._reduce.walk.recentering import Recenters
from nearfar._scene.levels import Leveled, levels_of
from nearfar._scene.scene import Scene


class ReducedScene(InPictures, InNotebooks, Recenters):
    """A reduced scene: near geometry, which is morphed for the user, in front of an environment map of the far part.

    Made by `reduce` or read by `load`. It shares the scene's meshes; only near triangles are copied (`near_bytes` of
    `stats`).
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
        self._baking = MapSettings() if baking is None else check.instance("baking", baking, MapSettings)
        self._at_levels: tuple[NDArray[np.int64], ReducedScene] | None = None
        radius = zones.r1 if boundary == "r1" else zones.r2
        channels = {} if env is None else {name: rows_of(getattr(env, name)) for name in env.channels}
        size = 0 if env is None else env.face_size
        with progress.bar("gathering near geometry") as report:
            self._core = _core.Reduced(zones._core, morph=morph, boundary=radius, size=size, **channels, report=report)

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

    def _with_reasons(self, reasons: Mapping[str, str]) -> Self:
        self._reasons = reasons
        return self

    @property
    def stats(self) -> dict[str, Any]:
        """Counts of triangles, bytes and rays of the reduction; `Frame.stats` has those of a frame.

        Returns
        -------
        dict
            Of the scene: `triangles`, and `near`, `intermediate`, `nsf` and `sf` as in `Partition.summary`; `drawn`,
            the number of triangles that a client draws, and `reduction` = triangles / drawn. Of the memory:
            `map_bytes`, and `near_bytes` for copies of near geometry. Of baking: `rays` (0 on a graphics adapter) and
            `ranges_computed`.
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
        """Images computed by default: those available for far pixels."""
        if self._env is None or not self._drawing.env:
            return envmap.CHANNELS
        return self._env.channels

    @property
    def triangle_count(self) -> int:
        """Number of triangles that a client draws."""
        return self._counts["nsf" if self._boundary == "r2" else "nsf_at_r1"]

    def at(self, poses: Mapping[str, ArrayLike]) -> ReducedScene:
        """Return the same reduced scene with dynamic objects in other poses, as `Scene.at` does."""
        posed = copy.copy(self)
        posed._scene, posed._poses = self._scene.at(poses), {**self._poses, **poses}
        return posed

    def at_levels(self, levels: ArrayLike | Mapping[str, int]) -> ReducedScene:
        """Return the same reduced scene with near objects at these levels of detail, before the same map.

        Parameters
        ----------
        levels
            As in `Scene.at_levels`. The map shows far objects at the levels that were baked.

        Raises
        ------
        ValueError, TypeError
            As in `Scene.at_levels`.
        """
        leveled = self._scene.leveled
        if leveled is None:
            raise ValueError("lod: expected a scene whose objects have levels, got one without; see Scene.with_levels")
        chosen_levels = levels_of("levels", levels, leveled)
        if self._at_levels is None or not np.array_equal(self._at_levels[0], chosen_levels):
            scene = self._unposed.at_levels(chosen_levels)
            zones = partition(scene, center=self.center, r1=self.r1, r2=self.r2)
            self._at_levels = chosen_levels, self._copy_with(scene, zones, self._counts | zones.summary())
        left_out = {name for name, level in zip(leveled.names, chosen_levels.tolist(), strict=True) if level < 0}
        poses = {name: pose for name, pose in self._poses.items() if name not in left_out}
        reduced = self._at_levels[1]._drawn_by(self._drawing)  # it may have been made for another drawing
        return reduced.at(poses) if poses else reduced

    def shown_to(self, user: ArrayLike) -> Leveled | None:
        """Return the objects with levels as a user at a world position (3,) sees them, with morphed spheres."""
        leveled = self._scene.leveled
        if leveled is None or self._morph == "none":
            return leveled
        grown = grow_radii(self._drawing, self.r1, self.r2)
        return morphed(leveled, user, center=self.center, kind=self._morph, growth=grown)

    def _copy_with(
        self, scene: Scene, zones: Partition, counts: dict[str, int], *, morph: MorphKind | None = None
    ) -> ReducedScene:
        """Copy with the same map and other near geometry or another morph."""
        reduced = ReducedScene(
            scene,
            zones,
            self._env,
            morph=self._morph if morph is None else morph,
            boundary=self._boundary,
            counts=counts,
            is_whole=self._is_whole,
            baking=self._baking,
        )
        return reduced._drawn_by(self._drawing)._with_reasons(self._reasons)

    def with_morph(self, morph: MorphKind) -> ReducedScene:
        """Return the same near part and the same map with another morph, without baking again.

        Parameters
        ----------
        morph
            "blend", "cylinder" or "none", as in `reduce`. A map that was baked from r1 allows only "none".

        Raises
        ------
        ValueError
            Unknown names, or a continuous morph with a map baked from r1.
        """
        check_morph(morph, self._boundary)
        return self._copy_with(self._scene, self._partition, self._counts, morph=morph)

    def with_r1(self, r1: float) -> ReducedScene:
        """Return the same near part and the same map with another r1, without baking again.

        Parameters
        ----------
        r1
            Radius in metres inside which nothing is morphed, 0 ≤ r1 < r2.

        Raises
        ------
        ValueError, TypeError
            Radii out of range, or a map baked from r1.
        """
        if self._boundary == "r1":
            raise ValueError(f"r1: expected {self.r1:g}, from which the map was baked, got {check.number('r1', r1):g}")
        zones = partition(self._undivided, center=self.center, r1=r1, r2=self.r2, unit=self._partition.unit)
        counts = zones.summary()
        # Triangles beyond r2 are those of the bake, even if only the near part was loaded.
        inner = {name: counts[name] for name in ("near", "intermediate", "nsf_at_r1")}
        reasons = {name: reason for name, reason in self._reasons.items() if name not in ("r1", "radii")}
        changed = self._copy_with(zones.scene, zones, self._counts | inner)._with_reasons(reasons)
        return changed.at(self._poses) if self._poses else changed

    def with_growth(self, radius: float | None = None, strength: float = 1.0) -> ReducedScene:
        """Return the same reduced scene drawn with another radius and strength of the morph, by `nearfar.render` too.

        These settings affect drawing only, so `save` does not keep them.

        Parameters
        ----------
        radius
            Metres, from 0 to r2, or None for r2; see `render`. r1 shrinks in proportion.
        strength
            Factor of the weight of the user's view, 0 to 1; see `render`.

        Raises
        ------
        ValueError, TypeError
            A radius below 0, or a strength outside 0 to 1.
        """
        return self._drawn_by(replace(self._drawing, radius=radius, strength=check.number("strength", strength)))

    def save(self, path: str | os.PathLike[str], *, half: bool = True) -> None:
        """Write a folder of files that other programs can read, atomically.

        Parameters
        ----------
        path
            The folder. It contains `near.glb`, the drawn geometry, unmorphed, with objects as named nodes and materials
            as in their glTF file, including undrawn properties; `far.exr`, the map, if there is one (`EnvMap.save`);
            and `reduced.json` with all other data. An existing folder is replaced if it is empty or contains a
            `reduced.json`.
        half
            True stores the map's colour as 16-bit floats, as `EnvMap.save` does; False stores it bit for bit.

        Raises
        ------
        OSError
            If the folder cannot be written or contains other files.
        """
        near = self._near_part
        settings = (self.center, self.r1, self.r2, self._morph, self._boundary)
        folder.save(
            path,
            folder.Contents(near, self._env, *settings, self._counts, self._reasons),
            half=check.flag("half", half),
        )

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> ReducedScene:
        """Read a folder that `save` wrote.

        The result renders the same colours (with `half`, to a quarter of an 8-bit step), ranges and objects as the
        saved scene; `face_id` counts the near part's triangles. Unless the map has object numbers, the objects of the
        loaded scene are those of the near part alone. Far geometry is not saved, so `env=False` is refused.

        Raises
        ------
        FormatError
            A file that is damaged or newer than supported; the message names it.
        OSError
            A missing file.
        """
        saved = folder.load(path)
        # Values of the files may be valid separately, but not together.
        with formats.guarded(path):
            zones = partition(saved.near, center=saved.center, r1=saved.r1, r2=saved.r2)
            fields: dict[str, Any] = {"morph": saved.morph, "boundary": saved.boundary, "counts": saved.counts}
            return cls(saved.near, zones, saved.env, **fields, is_whole=False)._with_reasons(saved.reasons)

    @property
    def _near_part(self) -> Scene:
        """The drawn geometry as a scene, unmorphed, with its dynamic objects."""
        near, zones = self._scene, self._partition
        if not self._is_whole:
            return near
        moving = np.arange(near._core.standing_triangle_count, near.triangle_count)
        return near.subset(triangles=zones.nsf if self._boundary == "r2" else np.union1d(zones.near, moving))

    @property
    def _undivided(self) -> Scene:
        """The scene before near objects became dynamic."""
        return self._partition.source if self._partition.unit == "object" else self._unposed

    def _again(self, baking: MapSettings, **changed: Any) -> ReducedScene:
        """Reduce the scene again in the same pose, about another `center` or with another `r1` and `r2`."""
        place: dict[str, Any] = {"center": self.center, "r1": self.r1, "r2": self.r2, **changed}
        source = self._undivided
        parts = stages.parts(source, **place, unit=self._partition.unit, boundary=self._boundary, baking=baking)
        again = ReducedScene(**parts, morph=self._morph, boundary=self._boundary, baking=baking)
        again = again._drawn_by(self._drawing)
        return again.at(self._poses) if self._poses else again

    def __repr__(self) -> str:
        stats = self.stats
        chosen = ", chosen by reduce" if self._reasons.keys() - {"center"} else ""
        return (
            f"ReducedScene({self._morph!r}, r1={self.r1:g}, r2={self.r2:g}{chosen}: {stats['drawn']:,} of "
            f"{stats['triangles']:,} triangles, map of {stats['map_bytes']:,} bytes)"
        )
