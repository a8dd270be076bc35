"""The `Impostors` class: near geometry, and the far part as textured quads, as a thin client renders them."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import card
from nearfar._camera.shot import Shot
from nearfar._impostor import file
from nearfar._impostor.file import Textures
from nearfar._impostor.quads import Point, Quads
from nearfar._render.renderable import Images, Job, Renderable, Report
from nearfar._scene.scene import Scene


@dataclass(frozen=True, eq=False, repr=False)
class Impostors(Renderable):
    """A scene whose far part is textured quads, baked from several centres; `bake_impostors` makes it.

    `nearfar.render` draws near geometry and quads together, without a morph. Users within `reach` of the centre see
    the centre of each texel at most `error_px` beside its place.
    """

    center: Point
    """World position of the centre O of the users' region, metres."""
    reach: float
    """Radius of the users' region, a sphere about O, metres."""
    r2: float
    """Radius in metres about the vertical axis through O beyond which static triangles became quads."""
    error_px: float
    """Greatest error in pixels, of which a degree has 20; a budget of triangles may have increased it."""
    face_size: int
    """Number of texels across each face of a centre's cube map."""
    far: Scene | None
    """The quads about O as a scene of one object; None if there are none."""
    near: Scene | None
    """All triangles that are not static and beyond r2 as a whole, as geometry; None if there are none."""
    scene: Scene
    """Near and far part: what `nearfar.render` draws."""
    _quads: Quads | None
    _counts: Mapping[str, Any]

    @property
    def triangle_count(self) -> int:
        """Number of triangles of the quads; `scene.triangle_count` is that of all that is drawn."""
        return 0 if self.far is None else self.far.triangle_count

    @property
    def layers(self) -> tuple[tuple[Point, int], ...]:
        """World position of each centre that quads were baked from, and the number of its quads."""
        if self._quads is None:
            return ()
        x, y, z = self.center
        return tuple(((x + dx, y + dy, z + dz), count) for (dx, dy, dz), count in self._quads.layers)

    @property
    def stats(self) -> dict[str, Any]:
        """Counts and measures.

        Far part: `triangles`, `quads`, the `texels` that they show, `layers`, and the `atlas` as width and height in
        texels. `near_triangles`, and `scene_triangles` of the original scene. `error_px` as chosen; `missing`, the
        share of the pixels of the region's probes that are missing, before quads were dropped for a budget;
        `dropped_quads` and `dropped_texels`, which they showed; `bakes`, the number of tried errors.
        """
        quads, counts = self._quads, self._counts
        return {
            "triangles": self.triangle_count,
            "quads": 0 if quads is None else len(quads),
            "texels": 0 if quads is None else int(quads.texels.sum()),
            "layers": len(self.layers),
            "atlas": (0, 0) if quads is None else quads.atlas.shape[1::-1],
            "near_triangles": 0 if self.near is None else self.near.triangle_count,
            "error_px": self.error_px,
            **counts,
        }

    def save(self, path: str | os.PathLike[str], *, textures: Textures = "webp") -> None:
        """Write the far part as one plain GLB that any program can show without a shader, atomically.

        Positions are relative to O, whose world position is `extras.nearfar.center` of the file's scene. Materials are
        unlit (`KHR_materials_unlit`); opaque quads and those with transparent texels (`MASK`) are separate primitives
        of one mesh with one texture, which is clamped, filtered and without mipmaps. The near part is not written.
        ValueError if there are no quads, or for a texture too large for WebP; OSError if the file cannot be written.

        Parameters
        ----------
        path
            Name ending in `.glb`.
        textures
            "webp": quality 80 with `EXT_texture_webp`, which readers need. "png": lossless.
        """
        file.save(path, self._quads, self, textures)

    @property
    def origin(self) -> NDArray[np.float64]:
        """World position (3,) in metres that `Frame.position` is relative to."""
        return self.scene.origin

    @property
    def default_channels(self) -> tuple[str, ...]:
        """Images that are rendered by default: those of a scene."""
        return self.scene.default_channels

    @property
    def object_names(self) -> tuple[str, ...]:
        """Names of all objects, by number: the scene's, with the same numbers, and that of the quads."""
        return self.scene.object_names

    @property
    def poses(self) -> dict[str, NDArray[np.float64]]:
        """Present object→world (4, 4) of each dynamic object, by name, as `at` takes them."""
        return self.scene.poses

    def at(self, poses: Mapping[str, ArrayLike]) -> Self:
        """Return the same impostors with dynamic objects in other poses; `poses` and errors as in `Scene.at`."""
        near = None if self.near is None else self.near.at(poses)
        return replace(self, near=near, scene=self.scene.at(poses))

    def displayed(self, points: ArrayLike, user: ArrayLike) -> NDArray[np.float64]:
        """Return the world positions (N, 3) where a picture shows points: unchanged, for any user."""
        return self.scene.displayed(points, user)

    def trace(self, shot: Shot, report: Report = None) -> list[Images]:
        """Trace the pictures of a shot, one for each camera."""
        return list(self.scene.trace(shot, report))

    def begin(self, device: _core.GpuDevice, shot: Shot, report: Report = None) -> list[Job]:
        """Start the pictures of a shot on a graphics device, one for each camera."""
        return list(self.scene.begin(device, shot, report))

    @card.repr_html
    def _repr_html_(self) -> str:
        stats = self.stats
        facts = [
            ("near", f"{stats['near_triangles']:,} of {stats['scene_triangles']:,} triangles"),
            ("far", f"{stats['triangles']:,} triangles of {stats['quads']:,} quads"),
            ("error", f"at most {self.error_px:.3g} px at 20 px a degree, within {self.reach:g} m of the centre"),
            ("r₂", f"{self.r2:g} m"),
            ("centre", card.point(self.center)),
        ]
        if self._quads is None:
            return card.page("Impostors", facts, notes=[_nothing_far(self)])
        height, width = self._quads.atlas.shape[:2]
        facts += [
            ("baked from", f"{len(self.layers)} centres, {self.face_size} texels a face"),
            ("texture", f"{width:,} × {height:,} texels, of which {stats['texels']:,} are shown"),
            ("missing in the region", f"{100.0 * stats['missing']:.2g} % of all pixels"),
        ]
        notes = []
        if stats["dropped_quads"]:
            notes.append(f"{stats['dropped_quads']:,} quads with {stats['dropped_texels']:,} texels were dropped.")
        picture = card.picture(card.subsample(self._quads.atlas), "texture", "the texture of all quads")
        return card.page("Impostors", facts, picture, notes=notes)

    def __repr__(self) -> str:
        stats = self.stats
        if self._quads is None:
            return f"<nearfar.Impostors: {stats['near_triangles']:,} near triangles, no quads: {_nothing_far(self)}>"
        return (
            f"<nearfar.Impostors: {stats['near_triangles']:,} near triangles, {stats['triangles']:,} far "
            f"ones of {stats['quads']:,} quads, {self.error_px:.3g} px within {self.reach:g} m>"
        )


def _nothing_far(impostors: Impostors) -> str:
    """Return why there are no quads."""
    if impostors.stats["dropped_quads"]:
        return "the budget of triangles leaves none"
    return f"no static triangle beyond {impostors.r2:g} m is seen"
