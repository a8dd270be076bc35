"""The `Scene` class, which files, trimesh objects, arrays or a builder create and every other stage reads."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any, Self, Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import card, check
from nearfar._base.settings import gather
from nearfar._scene import preview
from nearfar._scene.assembly import one_mesh
from nearfar._scene.levels import Leveled, LevelTable, check_levels, levels_of, notes_of, with_levels
from nearfar._scene.names import Names, names_of
from nearfar._scene.options import Blend, LoadKeywords, LoadOptions, OnInvalid, Up
from nearfar._scene.parts import PartsMixin, RenderMixin
from nearfar._scene.poses import checked_pose, frame_of, placements_in, pose_of
from nearfar._scene.report import Report
from nearfar._scene.serialize import core_of_parts, parts_of
from nearfar._scene.undrawn import GltfMaterial

if TYPE_CHECKING:
    import trimesh


class Scene(PartsMixin, RenderMixin):
    """An immutable scene of objects, some of which may move; objects can share meshes.

    An object is a set of faces or instances with one name. Static meshes placed once are merged; meshes that move or
    are placed several times stay instances. Scenes derived from a scene (`at`, `with_dynamic`, `with_levels`,
    `subset`) share its meshes, textures and search trees. Metres, right-handed, y up. Make one with `load`,
    `from_trimesh`, `from_arrays` or `nearfar.datasets`.
    """

    def __init__(
        self,
        core: _core.Scene,
        names: Names,
        *,
        frames: NDArray[np.float64] | None = None,
        load_placements: NDArray[np.float64] | None = None,
        dropped: int = 0,
        notes: tuple[str, ...] = (),
        used: tuple[str, ...] = (),
        table: LevelTable | None = None,
        undrawn: Mapping[int, GltfMaterial] | None = None,
    ) -> None:
        self._core = check.instance("core", core, _core.Scene, "what Scene.load, from_arrays and others pass")
        self._names, self._frames = check.instance("names", names, Names, "what Scene.load and others pass"), frames
        self._load_placements = core.moving_placements() if load_placements is None else load_placements
        self._dropped, self._notes, self._used, self._table = dropped, notes, used, table
        self._undrawn: Mapping[int, GltfMaterial] = {} if undrawn is None else undrawn

    @classmethod
    def load(
        cls, path: str | os.PathLike[str], options: LoadOptions | None = None, **keywords: Unpack[LoadKeywords]
    ) -> Scene:
        """Load a file: GLB, glTF with its buffers and images, OBJ with MTL, PLY, STL, OFF or another format of trimesh.

        It also loads tilesets of 3D Tiles 1.0 and 1.1 (their .json, at a path or a URL), tiles (.b3dm, .i3dm, .cmpt),
        CityJSON (.city.json, .city.jsonl), extruded footprints of GeoJSON and GeoParquet, and gzip files (``.ply.gz``).
        Nodes become objects. `report` lists what is not drawn; files written from the scene nevertheless include it.
        SceneError, with the file's name and the reason, for a file that is unusable or unpacks to too much; ValueError
        and TypeError for options out of range, or an option for files of another kind; MemoryError for a file that
        does not fit into memory; OSError for a file that cannot be opened.

        Parameters
        ----------
        path
            The file.
        options
            Axis, unit, limits and detail, as `LoadOptions`.
        keywords
            Fields of `options`, which they replace: `up`, `scale`, `on_invalid`, `max_bytes`, `blend`; for tilesets
            `error`, `triangles`, `origin`; for cities `lod`, `height`, `origin`.
        """
        from nearfar._scene import load

        return cls(**load.load(path, gather(LoadOptions, options, keywords, "options")))

    @classmethod
    def from_trimesh(
        cls,
        loaded: trimesh.Trimesh | trimesh.Scene,
        *,
        up: Up = "y",
        on_invalid: OnInvalid = "raise",
        scale: float | None = None,
        blend: Blend = "opaque",
    ) -> Scene:
        """Convert one of trimesh's meshes or scenes.

        SceneError if there are no triangles, for unusable vertices or transforms, unknown units, or meshes of several
        units; TypeError for a value that is neither a mesh nor a scene.

        Parameters
        ----------
        loaded
            Mesh or scene. Its nodes become objects; a single mesh is called ``object``. Vertex normals from its source
            are used, but not those that trimesh computes from the faces, so that a box keeps sharp edges.
        up, on_invalid, blend
            As in `LoadOptions`.
        scale
            Metres per unit. None for the unit in `loaded.units`, which all meshes must share, or the metre without one.
        """
        from nearfar._scene import content as contents, load_trimesh

        options = LoadOptions(up=up, on_invalid=on_invalid, scale=scale, blend=blend)
        return cls(**contents.assemble(load_trimesh.read("trimesh object", loaded), options))

    @classmethod
    def from_arrays(
        cls,
        vertices: ArrayLike,
        faces: ArrayLike,
        face_object: ArrayLike | None = None,
        *,
        object_names: Sequence[str] | None = None,
        copy: bool = False,
    ) -> Scene:
        """Make a scene of one mesh.

        C-contiguous float32 vertices, uint32 faces and int32 objects are not copied: the scene reads the caller's
        memory, and the arrays become read-only. Do not write through other views of it. Other types are converted.
        ValueError for vertices that are not finite, numbers out of range, shapes that do not match, or repeated names;
        TypeError for values that are not numbers, or names that are not strings.

        Parameters
        ----------
        vertices
            (V, 3) metres, world. Float64 beyond 32,768 m keeps its digits (see `origin`).
        faces
            (F, 3) vertex numbers, counter-clockwise from outside.
        face_object
            (F,) object number of each face, -1 for none; by default all belong to object 0.
        object_names
            Name of each object number; by default ``object_0``, ``object_1``, …
        copy
            Copy all arrays, and leave the caller's arrays writable.
        """
        names = None if object_names is None else names_of("object_names", object_names)
        return cls(**one_mesh(vertices, faces, face_object, names, copy=copy))

    @property
    def object_names(self) -> tuple[str, ...]:
        """Names of the objects, in the order of the numbers in `Frame.object_id`; subsets keep all of them."""
        return self._names.as_tuple

    @cached_property
    def bounds(self) -> NDArray[np.float64]:
        """World box (2, 3) of all triangles, least and greatest corner; infinite and inverted for an empty scene."""
        return self._core.bounds()

    @property
    def origin(self) -> NDArray[np.float64]:
        """World position (3,) that kernels' float32 coordinates are relative to.

        It is 0 if all coordinates are within 32,768 m, else the centre of the bounds in whole metres.
        """
        return np.array(self._core.origin)

    @cached_property
    def report(self) -> Report:
        """Counts of the scene's contents, and parts of its source that are used, dropped or not drawn."""
        moving = len(self._load_placements)
        return Report.count(self._core, len(self._names), moving, self._dropped, self._notes, self._used)

    def triangles(self) -> NDArray[np.float32]:
        """Corners of all triangles (T, 3, 3), relative to `origin`; for exchange with other tools."""
        return self._core.triangles()

    def with_dynamic(self, names: Iterable[str]) -> Scene:
        """Return a copy of the scene in which `at` can also pose the named objects.

        Faces of a merged mesh that belong to a named object become a separate mesh. ValueError for a name that the
        scene does not have.
        """
        core = self._core.with_moving(self._names.flags("names", names))
        added = core.moving_placements()[len(self._load_placements) :]
        return self._derived(core, np.concatenate([self._load_placements, added]), self._table)

    def with_levels(self, models: Mapping[str, Any]) -> Scene:
        """Return the same scene with levels of detail for some objects; it shows their level 0.

        `models` has a `nearfar.lod.LodModel` with its geometry for each object, by name. The levels replace the
        objects' meshes. They are placed by the object's `transform`, and dynamic objects stay dynamic. Objects with the
        same model share its meshes. `nearfar.render` renders chosen levels. ValueError for unknown names, models
        without geometry, or objects with singular transforms; TypeError for a value that is not a mapping from names to
        models.
        """
        check.mapping("models", models, "models by name such as {'tree': model}")
        numbers = [self._names.number("models", name) for name in models]
        frames = np.array([self._frame(number) for number in numbers], np.float64).reshape(-1, 4, 4)
        new = check_levels(self._names, numbers, list(models.values()), frames, in_place=True)
        changed = with_levels(self._core, self._load_placements, self._table, len(self._names), new)
        return self._derived(*changed, **notes_of(new.models, self))

    @cached_property
    def leveled(self) -> Leveled | None:
        """The objects with levels and their present bounding spheres; None if no object has levels."""
        return None if self._table is None else self._table.leveled(self._core, self._names)

    @cached_property
    def level_boxes(self) -> NDArray[np.float64]:
        """Boxes (N, 2, 3) in world metres around all levels of each object of `leveled`, least corner first."""
        return np.zeros((0, 2, 3)) if self._table is None else self._table.boxes(self._core)

    def shown_to(self, user: ArrayLike) -> Leveled | None:
        """Return `leveled`. Other renderables depend on the user's world position (3,); a scene ignores it."""
        return self.leveled

    def at_levels(self, levels: ArrayLike | Mapping[str, int]) -> Scene:
        """Return a scene whose objects have the given levels as their only meshes; it shares meshes and trees.

        `levels` is an array (N,) in the order of `leveled`, or a mapping by name in which missing objects get 0. Level
        0 is the finest; −1 leaves an object out. ValueError for levels that do not exist, a wrong number of levels, or
        a scene without levels; TypeError for levels that are not whole numbers.
        """
        leveled, table = self.leveled, self._table
        if leveled is None or table is None:
            raise ValueError("levels: expected a scene whose objects have levels, got one without; see with_levels")
        level_rows = levels_of("levels", levels, leveled)
        by_object = np.zeros(len(self._names), np.int32)
        by_object[leveled.numbers] = level_rows
        remains = (by_object >= 0)[self._core.moving_objects()]
        return self._derived(table.core.choose(self._core, table.row_of, by_object), self._load_placements[remains])

    def transform(self, name: str) -> NDArray[np.float64]:
        """Transform object→world (4, 4) that an object had when it was loaded; `at` replaces it."""
        return self._frame(self._names.number("name", name)).copy()

    @property
    def poses(self) -> dict[str, NDArray[np.float64]]:
        """Present object→world (4, 4) of each dynamic object, by name, in the form that `at` takes."""
        return {self.object_names[n]: self._pose(n) for n in np.unique(self._core.moving_objects()).tolist()}

    def at(self, poses: Mapping[str, ArrayLike]) -> Scene:
        """Return the same scene with dynamic objects in other poses.

        A pose is object→world (4, 4) for column vectors, by name. It replaces the object's load transform (see
        `transform`); objects that are not named keep their poses. ValueError for unknown objects, objects that are not
        dynamic, or matrices that are not finite, affine and invertible; TypeError for a value that is not a mapping
        from names to poses.
        """
        check.mapping("poses", poses, "matrices by name such as {'car': matrix}")
        placements, owner = self._core.moving_placements(), self._core.moving_objects()
        for name, pose in poses.items():
            number = self._names.number("poses", name)
            rows = np.flatnonzero(owner == number)
            if not len(rows):
                raise ValueError(f"poses: expected dynamic objects, got the static '{name}'; see with_dynamic")
            matrix = checked_pose(f"poses[{name!r}]", pose)
            placements[rows] = placements_in(matrix, self._frame(number), self._load_placements[rows], self.origin)
        return self._derived(self._core.posed(placements), self._load_placements, self._table)

    def _pose(self, number: int) -> NDArray[np.float64]:
        """Present object→world (4, 4) of an object."""
        return pose_of(self._core, number, self._frame(number), self._load_placements)

    def _frame(self, number: int) -> NDArray[np.float64]:
        return frame_of(self._frames, number)

    def _derived(
        self, core: _core.Scene, load_placements: NDArray[np.float64], table: LevelTable | None = None, **changes: Any
    ) -> Self:
        arguments = self._arguments | {"load_placements": load_placements, "table": table}
        return type(self)(core, self._names, **(arguments | changes))

    @property
    def _arguments(self) -> dict[str, Any]:
        """Keyword arguments that recreate this scene from its core and names."""
        names = ("frames", "load_placements", "dropped", "notes", "used", "table", "undrawn")
        return {name: getattr(self, f"_{name}") for name in names}

    def __getstate__(self) -> dict[str, Any]:
        """Pickle a scene as arrays; its search trees are rebuilt after unpickling."""
        source = self._names.source
        names = source if isinstance(source, int) else list(source)
        return {"parts": parts_of(self._core), "names": names, "own": self._arguments}

    def __setstate__(self, state: dict[str, Any]) -> None:
        Scene.__init__(self, core_of_parts(state["parts"]), Names(state["names"]), **state["own"])

    @card.repr_html
    def _repr_html_(self) -> str:
        return preview.html(self._core, self.report, self.bounds)

    def __repr__(self) -> str:
        return f"<nearfar.Scene: {self.triangle_count:,} triangles, {len(self._names):,} objects>"


def core_of(scene: Scene) -> _core.Scene:
    """Return the compiled scene that kernels take; TypeError for other arguments."""
    return check.instance("scene", scene, Scene)._core
