"""Reduced scenes: near geometry and an environment map, as a thin client renders them."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import replace
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike

from nearfar._base import check, formats
from nearfar._partition.partition import partition
from nearfar._reduce import folder
from nearfar._reduce.drawing import MorphKind, check_morph, grow_radii, morph_spheres
from nearfar._reduce.explore import NotebookMixin
from nearfar._reduce.pictures import RenderMixin
from nearfar._reduce.walk.recentering import RecenterMixin
from nearfar._scene.levels import Leveled, levels_of
from nearfar._scene.scene import Scene


class ReducedScene(RenderMixin, NotebookMixin, RecenterMixin):
    """A reduced scene: near geometry, which is morphed for the user, in front of an environment map of the far part.

    `reduce` makes it, or `load` reads it. It shares the scene's meshes; only near triangles are copied (`near_bytes` of
    `stats`).
    """

    def at_levels(self, levels: ArrayLike | Mapping[str, int]) -> Self:
        """Return the same reduced scene with near objects at these levels of detail, and the same map.

        Levels and errors are as in `Scene.at_levels`. The map still shows far objects at the levels that were baked.
        """
        leveled = self._scene.leveled
        if leveled is None:
            raise ValueError("lod: expected a scene whose objects have levels, got one without; see Scene.with_levels")
        chosen_levels = levels_of("levels", levels, leveled)
        if self._cached_by_levels is None or not np.array_equal(self._cached_by_levels[0], chosen_levels):
            scene = self._unposed.at_levels(chosen_levels)
            zones = partition(scene, center=self.center, r1=self.r1, r2=self.r2)
            self._cached_by_levels = chosen_levels, self._copy_with(scene, zones, self._counts | zones.summary())
        omitted = {name for name, level in zip(leveled.names, chosen_levels.tolist(), strict=True) if level < 0}
        poses = {name: pose for name, pose in self._poses.items() if name not in omitted}
        reduced = self._cached_by_levels[1]._replace(_drawing=self._drawing)  # it may be cached with other settings
        return reduced.at(poses) if poses else reduced

    def shown_to(self, user: ArrayLike) -> Leveled | None:
        """Return the objects with levels as a user at a world position (3,) sees them, with morphed spheres."""
        leveled = self._scene.leveled
        if leveled is None or self._morph == "none":
            return leveled
        grown = grow_radii(self._drawing, self.r1, self.r2)
        return morph_spheres(leveled, user, center=self.center, kind=self._morph, growth=grown)

    def with_morph(self, morph: MorphKind) -> Self:
        """Return the same near part and the same map with another morph, as in `reduce`, without baking again.

        ValueError for unknown names, or a morph other than "none" with a map baked from r1.
        """
        check_morph(morph, self._boundary)
        return self._copy_with(self._scene, self._partition, self._counts, morph=morph)

    def with_r1(self, r1: float) -> Self:
        """Return the same near part and the same map with another r1, in metres, without baking again.

        ValueError and TypeError unless 0 ≤ r1 < r2, or for a map baked from r1.
        """
        if self._boundary == "r1":
            raise ValueError(f"r1: expected {self.r1:g}, at which the map begins, got {check.number('r1', r1):g}")
        zones = partition(self._original_scene, center=self.center, r1=r1, r2=self.r2, unit=self._partition.unit)
        counts = zones.summary()
        # Counts beyond r2 stay those of the bake, because the far part of a loaded scene is unknown.
        inner = {name: counts[name] for name in ("near", "intermediate", "nsf_at_r1")}
        reasons = {name: reason for name, reason in self._reasons.items() if name not in ("r1", "radii")}
        changed = self._copy_with(zones.scene, zones, self._counts | inner)._replace(_reasons=reasons)
        return changed.at(self._poses) if self._poses else changed

    def with_growth(self, radius: float | None = None, strength: float = 1.0) -> Self:
        """Return the same reduced scene drawn with another radius and strength of the morph, by `nearfar.render` too.

        The radius is in metres, from 0 to r2, or None for r2, and r1 shrinks in proportion; the strength, 0 to 1, is a
        factor of the weight of the user's view: see `render`. Both affect drawing only, so `save` does not keep them.
        ValueError and TypeError for a radius below 0, or a strength outside 0 to 1.
        """
        return self._replace(
            _drawing=replace(self._drawing, radius=radius, strength=check.number("strength", strength))
        )

    def save(self, path: str | os.PathLike[str], *, half: bool = True) -> None:
        """Write a folder of files that other programs can read, atomically.

        OSError if the folder cannot be written or contains other files.

        Parameters
        ----------
        path
            The folder. It contains `near.glb`, the drawn geometry, unmorphed, with objects as named nodes and materials
            as in their glTF file, including undrawn properties; `far.exr`, the map, if there is one (`EnvMap.save`);
            and `reduced.json` with all other data. An existing folder is replaced if it is empty or contains a
            `reduced.json`.
        half
            True stores the map's colour as 16-bit floats, as `EnvMap.save` does; False stores it bit for bit.
        """
        near = self._near_part
        settings = (self.center, self.r1, self.r2, self._morph, self._boundary)
        folder.save(
            path,
            folder.Contents(near, self._env, *settings, self._counts, self._reasons),
            half=check.flag("half", half),
        )

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Self:
        """Read a folder that `save` wrote.

        The result renders the same colours (with `half`, to a quarter of an 8-bit step), ranges and objects as the
        saved scene; `face_id` counts the near part's triangles. Unless the map has object numbers, the objects of the
        loaded scene are those of the near part alone. Far geometry is not saved, so `env=False` is refused. FormatError
        for a file that is damaged or newer than supported, which the message names; OSError for a missing file.
        """
        saved = folder.load(path)
        # Values that are valid by themselves may contradict each other.
        with formats.guarded(path):
            zones = partition(saved.near, center=saved.center, r1=saved.r1, r2=saved.r2)
            fields: dict[str, Any] = {"morph": saved.morph, "boundary": saved.boundary, "counts": saved.counts}
            return cls(saved.near, zones, saved.env, **fields, is_whole=False)._replace(_reasons=saved.reasons)

    @property
    def _near_part(self) -> Scene:
        """The drawn geometry as a scene, unmorphed, with its dynamic objects."""
        near, zones = self._scene, self._partition
        if not self._is_whole:
            return near
        moving = np.arange(near._core.standing_triangle_count, near.triangle_count)
        return near.subset(triangles=zones.nsf if self._boundary == "r2" else np.union1d(zones.near, moving))

    def __repr__(self) -> str:
        stats = self.stats
        chosen = ", chosen by reduce" if self._reasons.keys() - {"center"} else ""
        return (
            f"ReducedScene({self._morph!r}, r1={self.r1:g}, r2={self.r2:g}{chosen}: {stats['drawn']:,} of "
            f"{stats['triangles']:,} triangles, map of {stats['map_bytes']:,} bytes)"
        )
