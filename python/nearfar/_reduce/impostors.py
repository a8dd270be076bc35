"""The `Impostors` class: near geometry, and the far part as textured quads, as a thin client renders them."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any, Literal, Self, Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import card, check, files, formats
from nearfar._base.errors import FormatError
from nearfar._base.settings import gather
from nearfar._camera.camera import Camera
from nearfar._camera.shot import Shot
from nearfar._impostor import file
from nearfar._impostor.bake import Region
from nearfar._impostor.file import EncodedFile, Geometry, Textures
from nearfar._impostor.quads import Point, Quads
from nearfar._impostor.settings import ImpostorSettings
from nearfar._reduce import default_radii, folder, stages
from nearfar._reduce.baking import MapSettings
from nearfar._reduce.impostor_explorer import ImpostorExplorer
from nearfar._reduce.reduced_scene import ReducedScene
from nearfar._reduce.walk.recentering import Recentering
from nearfar._render.frame import Frame
from nearfar._render.renderable import Images, Job, Renderable, Report
from nearfar._render.settings import RenderKeywords, RenderSettings
from nearfar._render.truth import render
from nearfar._scene.joined import join_scenes
from nearfar._scene.scene import Scene

Part = Literal["all", "far"]
"""Part of the result that a GLB holds: near and far part, or the far part alone."""


@dataclass(frozen=True, eq=False, repr=False)
class Impostors(Renderable):
    """A scene whose far part is textured quads, baked from several centres; `reduce` with `far="impostors"` makes it.

    `nearfar.render` draws near geometry and quads together, without a morph. Users within `reach` of the centre see
    the centre of each texel at most `error_px` beside its place.
    """

    center: Point
    """World position of the centre O of the users' region, metres."""
    reach: float
    """Radius of the users' region, a sphere about O, metres."""
    r2: float
    """Radius in metres about the vertical axis through O beyond which static triangles became quads."""
    settings: ImpostorSettings
    """Settings of the bake; budgets may have increased `error_px` and decreased `face_size`."""
    near: Scene
    """All triangles that stay geometry; may be empty."""
    far: Scene | None
    """The quads as a scene, with the objects whose surfaces they show; None if there are none."""
    stats: Mapping[str, Any]
    """Counts and measures.

    Far part: `triangles`, `quads`, of which `shared_quads` are those of an earlier bake, the `texels` that they
    show, `layers`, and width and height of the `atlas` in texels. `near_triangles`, and `scene_triangles` of the
    original scene. `error_px` as chosen; `missing`, the share of the pixels of the region's probes that are missing,
    before quads were dropped for a budget; `dropped_quads` and `dropped_texels`, which they showed; `changed`, the
    share of the pixels of other users that show near triangles which were left out; `bakes`, the number of bakes.
    """
    layers: tuple[tuple[Point, int], ...]
    """World position of each centre that quads were baked from, and the number of its quads."""
    reason: str
    """Centre and radius that `reduce` chose and why, and why there are no quads; empty if there is nothing to say."""
    _quads: Quads | None = field(repr=False)
    _source: Scene | ReducedScene | None = field(repr=False)
    """The original scene, or the published reduction that a folder holds; None for a folder without a map."""
    _sheets: _core.ImpostorSheets | None = field(default=None, repr=False)
    """Quads that another region of the scene can use again; None for a folder, and for pickled impostors."""

    @cached_property
    def scene(self) -> Scene:
        """Near and far part: what `nearfar.render` draws."""
        return self.near if self.far is None else join_scenes([self.near, self.far])

    @property
    def triangle_count(self) -> int:
        """Number of triangles that a picture draws."""
        return self.near.triangle_count + (0 if self.far is None else self.far.triangle_count)

    @property
    def nbytes(self) -> int:
        """Bytes in memory of the quads, with their texture, and of near geometry; 0 for quads that `load` read."""
        sheets = 0 if self._sheets is None else self._sheets.bytes()
        return self.near._core.bytes() + sheets + (0 if self._quads is None else self._quads.nbytes)

    @cached_property
    def published(self) -> ReducedScene:
        """The published near-far reduction with the same centre and r2: near geometry, a map of the far part, a morph.

        Its map, with faces of `settings.face_size` texels, is baked at the first use. A client can show it outside the
        region, or before it has the quads; in a folder its near part lacks the triangles that no user there sees.
        """
        if isinstance(self._source, ReducedScene):
            return self._source
        if self._source is None:
            raise ValueError("published: expected baked impostors or those of a folder, got pickled ones of a folder")
        baking = MapSettings(face_size=self.settings.face_size)
        r1 = default_radii.complete_radii(None, self.r2)[0]
        parts = stages.parts(self._source, center=self.center, r1=r1, r2=self.r2, boundary="r2", baking=baking)
        return ReducedScene(**parts, morph="blend", boundary="r2", baking=baking)

    def render(
        self,
        camera: Camera,
        *,
        at: Mapping[str, ArrayLike] | None = None,
        user: ArrayLike | None = None,
        settings: RenderSettings | None = None,
        **keywords: Unpack[RenderKeywords],
    ) -> Frame:
        """Render the picture that a thin client shows; parameters and errors as in `nearfar.render`."""
        return render(self, camera, at=at, user=user, settings=gather(RenderSettings, settings, keywords))

    def explore(self, *, size: tuple[int, int] = (400, 250)) -> ImpostorExplorer:
        """Show the picture beside the truth in a notebook, with sliders for the user, who stays within `reach`.

        The explorer's sliders are attributes. A notebook shows the explorer if it is the last value of a cell.
        ImportError if ipywidgets is not installed; ValueError and TypeError for arguments out of range.

        Parameters
        ----------
        size
            Width and height of both pictures in pixels, 16 to 2048.
        """
        for name, value in zip(("size[0]", "size[1]"), check.size("size", size), strict=True):
            check.integer(name, value, 16, 2048)
        truth = self._source if isinstance(self._source, Scene) else None
        return ImpostorExplorer(self, center=self.center, reach=self.reach, truth=truth, size=size)

    def recentered(self, center: ArrayLike) -> Recentering[Impostors]:
        """Start baking the same scene about another centre, a world position (3,) in metres, in the background.

        Settings, r2 and poses stay. New quads of this bake that keep the error bound about the new centre are used
        again (not after pickling, nor with a budget), so the result may differ from that of `reduce` within the bound.
        In the result, `ready` says whether it is finished; `result()` waits for the new `Impostors`. ValueError and
        TypeError for an invalid centre, or for impostors that `load` read.
        """
        middle = check.vector("center", center)
        stages.check_place(middle)
        source = self._source
        if not isinstance(source, Scene):
            raise ValueError("center: expected impostors that were baked, got those of a folder without far geometry")
        settings = replace(self.settings, reach=self.reach)
        return Recentering(middle, lambda: reduce_to_impostors(source, middle, self.r2, settings, earlier=self))

    def save(
        self,
        path: str | os.PathLike[str],
        *,
        published: ReducedScene | None = None,
        textures: Textures = "webp",
        geometry: Geometry = "meshopt",
    ) -> tuple[str, ...]:
        """Write a folder that engines and nearfar can read, atomically.

        `light.glb` has near and far part, `near.glb` and `far.glb` one of them each. `far.exr` is the map of the
        published method, which `nearfar.ReducedScene.load` shows with `near.glb`. `reduced.json` has all other data. In
        `light.glb` and `far.glb` positions are relative to O, whose world position is `extras.nearfar.center` of the
        file's scene. The near part of `light.glb` has nearfar's light in its vertex colours. ValueError for impostors
        that `load` read, or another reduction's centre or r2; OSError if the folder cannot be written or contains other
        files.

        Parameters
        ----------
        path
            The folder. An existing folder is replaced if it is empty or contains a `reduced.json`.
        published
            Reduction with the same centre and r2, whose map is written; by default the property `published`, whose map
            is baked now if it was not used before.
        textures
            "webp": the texture of the quads in quality 80 with `EXT_texture_webp`, which readers need. "png": lossless.
        geometry
            "meshopt": compressed by `EXT_meshopt_compression`, which readers need. "plain": for any reader.

        Returns
        -------
        tuple of str
            What `light.glb` does not show of the near part, in words.
        """
        check.choice("textures", textures, file.TEXTURES)
        check.choice("geometry", geometry, file.GEOMETRIES)
        if self._source is None or isinstance(self._source, ReducedScene):
            raise ValueError("save: expected impostors that were baked, got those of a folder, which can be copied")
        published = self.published if published is None else check.instance("published", published, ReducedScene)
        if (published.center, published.r2) != (self.center, self.r2):
            raise ValueError(
                f"published: expected the centre {self.center} and r2 = {self.r2:g}, got {published.center} and "
                f"{published.r2:g}"
            )
        if published._boundary != "r2" or published.partition.unit != "triangle":
            raise ValueError("published: expected boundary 'r2' and unit 'triangle', got other ones")
        parts = (self.near, published.env, self.center, published.r1, published.r2, published.morph)
        contents = folder.Contents(*parts, "r2", published._counts, impostors=self._document())
        extra: dict[str, bytes] = {}
        lost: tuple[str, ...] = ()
        if self.triangle_count:
            light = self._encoded("all", textures, geometry)
            extra, lost = {folder.LIGHT: light.data} if light.data else {}, light.lost
        if self._quads is not None:
            extra[folder.QUADS] = self._encoded("far", textures, geometry).data
        folder.save(path, contents, half=True, extra=extra)
        return lost

    def save_glb(
        self,
        path: str | os.PathLike[str],
        *,
        part: Part = "all",
        textures: Textures = "webp",
        geometry: Geometry = "meshopt",
    ) -> tuple[str, ...]:
        """Write near and far part, or the far part alone, as one GLB, as in `save`, atomically.

        ValueError for a far part without quads, or a texture too large for WebP; OSError if the file cannot be written.

        Parameters
        ----------
        path
            Name ending in `.glb`.
        part
            "all" or "far".
        textures, geometry
            As in `save`.

        Returns
        -------
        tuple of str
            As in `save`.
        """
        target = check.path("path", path, ".glb")
        check.choice("part", part, ("all", "far"))
        check.choice("textures", textures, file.TEXTURES)
        check.choice("geometry", geometry, file.GEOMETRIES)
        encoded = self._encoded(part, textures, geometry)
        if not encoded.data:
            raise ValueError("part: expected geometry that is larger than its rounding, got none")
        with files.atomic_file(target) as aside:
            files.write(aside, encoded.data)
        return encoded.lost

    def _encoded(self, part: Part, textures: Textures, geometry: Geometry) -> EncodedFile:
        if self._quads is None and (part == "far" or self.far is not None):
            reason = "got none" if self.far is None else "got those of a folder, whose files can be copied"
            raise ValueError(f"part: expected impostors with quads, {reason}")
        near = self.near if part == "all" else None
        return file.encode(self._quads, self._region, near=near, textures=textures, geometry=geometry)

    @property
    def _region(self) -> Region:
        return Region(self.center, self.reach, self.r2, self.settings.error_px)

    def _document(self) -> dict[str, Any]:
        """The field `impostors` of the folder's document."""
        return {
            "reach": self.reach,
            "settings": {name: getattr(self.settings, name) for name in folder.IMPOSTOR_SETTINGS},
            "stats": dict(self.stats),
            "layers": [[list(at), count] for at, count in self.layers],
            "reason": self.reason,
        }

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Self:
        """Read a folder that `save` wrote.

        FormatError for a file that is damaged or newer than supported, or for a folder of a `ReducedScene`; OSError for
        a missing file. Far geometry is not saved, so the result can neither be saved nor recentered.
        """
        saved = folder.load(path)
        stated = saved.impostors
        target = Path(path)
        target = target.parent if target.name == folder.DOCUMENT else target
        if stated is None:
            raise FormatError(f"{target}: expected impostors, got a reduced scene with a map alone")
        with formats.guarded(target / folder.DOCUMENT):
            settings = ImpostorSettings(**stated["settings"])
            layers = tuple(
                (check.vector("layers", at), check.integer("layers", n, 0, 2**40)) for at, n in stated["layers"]
            )
            facts = (check.positive("reach", stated["reach"]), saved.r2, settings)
            reason, stats = check.text("reason", stated["reason"]), dict(stated["stats"])
        far = folder.load_quads(target, saved.center) if layers else None
        published = ReducedScene.load(target)
        return cls(saved.center, *facts, saved.near, far, stats, layers, reason, None, published)

    def __getstate__(self) -> dict[str, Any]:
        """Pickle without the published reduction, which is baked again when needed, or missing if it was read."""
        source = self._source if isinstance(self._source, Scene) else None
        state = {name: value for name, value in self.__dict__.items() if name != "published"}
        return state | {"_source": source, "_sheets": None}

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
        """Names of all objects, by number: the scene's, with the same numbers."""
        return self.scene.object_names

    @property
    def poses(self) -> dict[str, NDArray[np.float64]]:
        """Present object→world (4, 4) of each dynamic object, by name, as `at` takes them."""
        return self.scene.poses

    def at(self, poses: Mapping[str, ArrayLike]) -> Self:
        """Return the same impostors with dynamic objects in other poses; `poses` and errors as in `Scene.at`."""
        source = None if self._source is None else self._source.at(poses)
        posed = replace(self, near=self.near.at(poses), _source=source)
        posed.__dict__["scene"] = self.scene.at(poses)
        if "published" in self.__dict__:
            posed.__dict__["published"] = self.published.at(poses)
        return posed

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
            ("error", f"at most {self.settings.error_px:.3g} px at 20 px a degree, within {self.reach:g} m of O"),
            ("r₂", f"{self.r2:g} m"),
            ("centre", card.point(self.center)),
        ]
        notes = [self.reason] if self.reason else []
        if self.far is None:
            return card.page("Impostors", facts, notes=notes)
        width, height = stats["atlas"]
        facts += [
            ("baked from", f"{len(self.layers)} centres, {self.settings.face_size} texels a face"),
            ("texture", f"{width:,} × {height:,} texels, of which {stats['texels']:,} are shown"),
            ("missing in the region", f"{100.0 * stats['missing']:.2g} % of all pixels"),
        ]
        if stats["dropped_quads"]:
            notes.append(f"{stats['dropped_quads']:,} quads with {stats['dropped_texels']:,} texels were dropped.")
        if self._quads is None:
            return card.page("Impostors", facts, notes=notes)
        picture = card.picture(card.subsample(self._quads.atlas), "texture", "the texture of all quads")
        return card.page("Impostors", facts, picture, notes=notes)

    def __repr__(self) -> str:
        stats = self.stats
        near = f"{stats['near_triangles']:,} near triangles"
        if self.far is None:
            return f"<nearfar.Impostors: {near}, no quads: {self.reason}>"
        return (
            f"<nearfar.Impostors: {near}, {stats['triangles']:,} far ones of {stats['quads']:,} quads, "
            f"{self.settings.error_px:.3g} px within {self.reach:g} m>"
        )


def reduce_to_impostors(
    scene: Scene,
    center: Point,
    r2: float,
    settings: ImpostorSettings,
    reasons: Mapping[str, str] | None = None,
    *,
    may_keep: bool = True,
    earlier: Impostors | None = None,
) -> Impostors:
    """Bake impostors of a scene about a centre; `reasons` say how centre and r2 were chosen, in words by name.

    `may_keep` as in `stages.impostor_parts`. Quads of `earlier`, of another region of the scene, are used again where
    they keep the error bound.
    """
    sheets = None if earlier is None else earlier._sheets
    parts = stages.impostor_parts(scene, center, r2, settings, may_keep=may_keep, earlier=sheets)
    reason = default_radii.join({**(reasons or {}), **parts.pop("notes")})
    return Impostors(**parts, reason=reason, _source=scene)
