"""Objects with levels of detail: their meshes and placements, and the levels drawn in a picture."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import islice
from typing import Any, Protocol, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._scene.names import Names
from nearfar._scene.poses import square
from nearfar._scene.serialize import mesh_of


@runtime_checkable
class Selector(Protocol):
    """Interface of `nearfar.lod.Selector` that rendering uses."""

    @property
    def fade(self) -> float:
        """Width of the fade between levels; 0 switches without fading."""

    @property
    def select(self) -> Callable[..., Any]:
        """Function that chooses levels, like `nearfar.lod.select`."""


@runtime_checkable
class Model(Protocol):
    """Interface of `nearfar.lod.LodModel` that scenes use; the class itself belongs to a later stage."""

    @property
    def center(self) -> NDArray[np.float64]:
        """Centre of the bounding sphere (3,), metres in the object's frame."""

    @property
    def radius(self) -> float:
        """Radius of the bounding sphere, metres."""

    @property
    def levels(self) -> Sequence[Any] | None:
        """Levels from fine to coarse, each with its geometry as `scene`; None without geometry."""

    def selector(self, mode: str) -> Selector:
        """Make the selector of a mode with its default settings."""

    def __len__(self) -> int: ...


@dataclass(frozen=True, eq=False)
class Leveled:
    """The N objects of a scene that have levels, ordered by number.

    The fields from `models` on are arguments of `nearfar.lod.select`.
    """

    names: tuple[str, ...]
    """Names of the objects."""
    numbers: NDArray[np.int64]
    """Object numbers (N,) as in `Frame.object_id`, ascending."""
    models: tuple[Any, ...]
    """The distinct models, each a `nearfar.lod.LodModel`."""
    model_index: NDArray[np.int64]
    """Index into `models` for each object (N,)."""
    centers: NDArray[np.float64]
    """Centres of the objects' bounding spheres (N, 3), world, metres."""
    radii: NDArray[np.float64]
    """Radii of the bounding spheres (N,), metres: model radius times the greatest scale of the object's placement."""

    def __len__(self) -> int:
        """Return the number of objects."""
        return len(self.names)

    @property
    def level_counts(self) -> NDArray[np.int64]:
        """Number of levels of each object (N,)."""
        return np.array([len(model) for model in self.models], np.int64)[self.model_index]

    def __repr__(self) -> str:
        return f"Leveled({len(self.names):,} objects, {len(self.models):,} models)"


@dataclass(frozen=True, eq=False)
class Shown:
    """Levels and triangles of a scene with levels that a picture drew."""

    levels: NDArray[np.int64]
    """Level of each object (N,) in the order of `Scene.leveled`, 0 the finest; −1 for an object left out."""
    triangles: int
    """Number of drawn triangles, including those of objects without levels."""
    full_triangles: int
    """Number of triangles of the whole scene with all objects at level 0."""
    selection: Any = None
    """The selector's result, a `nearfar.lod.Selection`, with weights if levels fade; None if the caller set levels."""


@dataclass(frozen=True, eq=False)
class LevelTable:
    """Models and meshes of the levels of a scene's objects, shared by all scenes that derive from one another."""

    models: tuple[Any, ...]
    meshes: tuple[tuple[_core.Mesh, ...], ...]
    """Rows of meshes, one mesh for each level of a model. Mirrored objects have separate rows."""
    model_of: NDArray[np.int32]
    """Index into `models` for each object of the scene; −1 for none."""
    row_of: NDArray[np.int32]
    """Index into `meshes` for each object of the scene; −1 for none."""

    @cached_property
    def core(self) -> _core.Levels:
        """`meshes` in the form that kernels take."""
        return _core.Levels([list(row) for row in self.meshes])

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle meshes as arrays."""
        meshes = [[_core.mesh_parts(mesh) for mesh in row] for row in self.meshes]
        return _restore, (self.models, meshes, self.model_of, self.row_of)

    @cached_property
    def _row_boxes(self) -> NDArray[np.float64]:
        """Boxes (R, 2, 3) around all levels of each row of meshes, in the objects' frame."""
        boxes = np.zeros((len(self.meshes), 2, 3))
        for box, row in zip(boxes, self.meshes, strict=True):
            parts = [_core.mesh_parts(mesh) for mesh in row]
            used = [part["positions"][part["faces"]].reshape(-1, 3) for part in parts]
            box[0] = np.min([each.min(axis=0) for each in used], axis=0)
            box[1] = np.max([each.max(axis=0) for each in used], axis=0)
        return boxes

    def boxes(self, core: _core.Scene) -> NDArray[np.float64]:
        """World boxes (N, 2, 3) around all levels of each object, as placed now, in the order of `leveled`."""
        placements, numbers = self._placements(core)
        boxes = self._row_boxes[self.row_of[numbers]]
        centers = _world_points(core, placements, boxes.mean(axis=1))
        extents = np.einsum("nij,nj->ni", np.abs(placements[:, :, :3]), 0.5 * (boxes[:, 1] - boxes[:, 0]))
        return np.stack([centers - extents, centers + extents], axis=1)

    def _placements(self, core: _core.Scene) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
        """Placements (N, 3, 4) and numbers of the objects with levels, by ascending number."""
        placements, numbers = _core.placements_of(core, self.row_of >= 0)
        order = np.argsort(numbers)
        return placements[order], numbers[order]

    def leveled(self, core: _core.Scene, names: Names) -> Leveled:
        """Return the objects of a scene with levels, in their present placements."""
        placements, numbers = self._placements(core)
        index = self.model_of[numbers].astype(np.int64)
        middles = np.array([model.center for model in self.models], np.float64).reshape(-1, 3)[index]
        sizes = np.array([model.radius for model in self.models], np.float64)[index]
        axes = placements[:, :, :3]
        # The greatest scale of a matrix A is the square root of the greatest eigenvalue of AᵀA.
        scales = np.sqrt(np.linalg.eigvalsh(axes.transpose(0, 2, 1) @ axes)[:, -1])
        object_names = tuple(names.as_tuple[number] for number in numbers)
        centers = _world_points(core, placements, middles)
        return Leveled(object_names, numbers.astype(np.int64), self.models, index, centers, sizes * scales)


def _world_points(
    core: _core.Scene, placements: NDArray[np.float64], points: NDArray[np.float64]
) -> NDArray[np.float64]:
    """World positions (N, 3) of points (N, 3), each in the frame of a placement (N, 3, 4)."""
    local = np.einsum("nij,nj->ni", placements[:, :, :3], points)
    return np.asarray(local + placements[:, :, 3] + np.array(core.origin))


def _restore(
    models: tuple[Any, ...], parts: list[list[dict[str, Any]]], model_of: NDArray[np.int32], row_of: NDArray[np.int32]
) -> LevelTable:
    return LevelTable(models, tuple(tuple(map(mesh_of, row)) for row in parts), model_of, row_of)


@dataclass(frozen=True, eq=False)
class NewLevels:
    """Checked levels for K objects of a scene."""

    numbers: NDArray[np.int64]
    """Object numbers (K,)."""
    models: tuple[Any, ...]
    """Distinct models."""
    index: NDArray[np.int64]
    """Index into `models` for each object (K,)."""
    frames: NDArray[np.float64]
    """Matrices from the levels' frame to world (K, 4, 4) for the objects' load poses."""


def check_levels(
    names: Names, numbers: Sequence[int], models: Sequence[object], frames: NDArray[np.float64], *, in_place: bool
) -> NewLevels:
    """Check models and frames; errors name the object.

    With `in_place`, `frames` are the transforms of the objects that the levels replace; the result multiplies them by
    the inverse of the levels' own frame.
    """
    distinct: dict[int, Any] = {}
    for number, model in zip(numbers, models, strict=True):
        if id(model) not in distinct:
            _check_model(f"models['{names.as_tuple[number]}']", model)
            distinct[id(model)] = model
    rank = {key: position for position, key in enumerate(distinct)}
    index = np.array([rank[id(model)] for model in models], np.int64)
    flat = np.linalg.matrix_rank(frames[:, :3, :3]) < 3
    if flat.any():
        name = names.as_tuple[numbers[int(np.argmax(flat))]]
        raise ValueError(f"models: expected objects with invertible transforms, got a flat one for '{name}'")
    if in_place:
        level_frames = np.array([model.levels.frame for model in distinct.values()], np.float64).reshape(-1, 4, 4)
        frames = _divide_frames(frames, level_frames[index])
    return NewLevels(np.array(numbers, np.int64), tuple(distinct.values()), index, frames)


def _divide_frames(frames: NDArray[np.float64], level_frames: NDArray[np.float64]) -> NDArray[np.float64]:
    """Multiply objects' transforms (K, 4, 4) by inverse level frames; exactly the identity where both are equal."""
    solved = np.linalg.solve(level_frames.transpose(0, 2, 1), frames.transpose(0, 2, 1))
    placing = np.array(solved.transpose(0, 2, 1), np.float64)
    placing[:, 3] = (0, 0, 0, 1)
    placing[(frames == level_frames).all(axis=(1, 2))] = np.eye(4)
    return placing


def _check_model(argument: str, model: object) -> None:
    if not isinstance(model, Model):
        raise TypeError(f"{argument}: expected a LodModel, got {type(model).__name__}")
    if model.levels is None:
        raise ValueError(f"{argument}: expected a model with the geometry of its levels, got one without")
    if len(model.levels) != len(model):
        raise ValueError(f"{argument}: expected geometry of {len(model)} levels, got {len(model.levels)}")


def notes_of(models: Iterable[Any], scene: Any = None) -> dict[str, Any]:
    """Merge notes and undrawn materials of a scene and of models' levels, as arguments of `Scene`."""
    levels = (level.scene for model in models for level in model.levels)
    scenes = [*levels] if scene is None else [scene, *levels]
    notes = dict.fromkeys(note for each in scenes for note in each._notes)
    return {"notes": tuple(notes), "undrawn": {tag: part for each in scenes for tag, part in each._undrawn.items()}}


def levels_of(argument: str, levels: ArrayLike | Mapping[str, int], leveled: Leveled) -> NDArray[np.int64]:
    """Check levels and return one for each object (N,), −1 to leave it out; objects missing in a mapping get 0."""
    if isinstance(levels, Mapping):
        index = {name: number for number, name in enumerate(leveled.names)}
        if unknown := [name for name in levels if name not in index]:
            raise ValueError(f"{argument}: expected names of objects with levels, got {check.shortened(unknown[0])}")
        rows = np.zeros(len(leveled), np.int64)
        for name, level in levels.items():
            rows[index[name]] = check.integer(f"{argument}['{name}']", level, -1, 2**31 - 1)
    else:
        rows = check.array(argument, levels, columns=None, dtype=np.int64)
    if rows.shape != (len(leveled),):
        expected = f"one for each of {len(leveled)} objects with levels"
        raise ValueError(f"{argument}: expected {expected}, got shape {rows.shape}")
    counts = leveled.level_counts
    wrong_rows = np.flatnonzero((rows < -1) | (rows >= counts))
    if len(wrong_rows):
        row = wrong_rows[0]
        raise ValueError(f"{argument}: expected -1 to {counts[row] - 1} for '{leveled.names[row]}', got {rows[row]}")
    return rows


def with_levels(
    core: _core.Scene, load_placements: NDArray[np.float64], before: LevelTable | None, objects: int, new: NewLevels
) -> tuple[_core.Scene, NDArray[np.float64], LevelTable]:
    """Replace the meshes of objects by levels; return the new scene, in which these objects show level 0.

    A scene is passed and returned as its core, the load placements of its moving instances, and its level table. It
    has `objects` objects.
    """
    has_new_levels = np.zeros(objects, bool)
    has_new_levels[new.numbers] = True
    owner = core.moving_objects()
    placements, moves = _placements(core, load_placements, new)
    core, pieces = _core.with_surfaces(core, [level.scene._core for model in new.models for level in model.levels])
    piece = iter(pieces)
    rows = [tuple(islice(piece, len(model.levels))) for model in new.models]
    table, row = _table(before, objects, new, rows)
    order = np.argsort(moves, kind="stable")
    core = _core.with_instances(
        core.without_objects(has_new_levels),
        [table.meshes[number][0] for number in row[order]],
        placements[order],
        new.numbers[order].astype(np.int32),
        int(np.count_nonzero(~moves)),
    )
    loaded = new.frames[order[moves[order]], :3].copy()
    loaded[:, :, 3] -= np.array(core.origin)
    return core, np.concatenate([load_placements[~has_new_levels[owner]], loaded]), table


def _placements(
    core: _core.Scene, load_placements: NDArray[np.float64], new: NewLevels
) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """Present placements (K, 3, 4) of the objects, relative to the origin, and flags (K,) of those that move."""
    placements = new.frames[:, :3].copy()
    placements[:, :, 3] -= np.array(core.origin)
    owner, first = np.unique(core.moving_objects(), return_index=True)
    moves = np.isin(new.numbers, owner)
    instance = first[np.searchsorted(owner, new.numbers[moves])]
    present, loaded = (square(rows[instance]) for rows in (core.moving_placements(), load_placements))
    has_moved = (present != loaded).any(axis=(1, 2))
    moved_rows = np.flatnonzero(moves)[has_moved]
    # The levels move with the object's mesh: their placement is present · loaded⁻¹ · (load placement).
    relative = np.linalg.solve(loaded[has_moved], square(placements[moved_rows]))
    placements[moved_rows] = (present[has_moved] @ relative)[:, :3]
    return placements, moves


def _table(
    before: LevelTable | None, objects: int, new: NewLevels, rows: list[tuple[_core.Mesh, ...]]
) -> tuple[LevelTable, NDArray[np.int64]]:
    """Add new levels to a table; also return the row of meshes of each new object."""
    none = np.full(objects, -1, np.int32)
    before = before or LevelTable((), (), none, none)
    row = new.index + len(before.meshes)
    # Mirrored objects get meshes with reversed faces, so that outer sides stay outside.
    mirrored = np.linalg.det(new.frames[:, :3, :3]) < 0
    for model in np.unique(new.index[mirrored]).tolist():
        row[mirrored & (new.index == model)] = len(before.meshes) + len(rows)
        rows = [*rows, tuple(mesh.flip_faces() for mesh in rows[model])]
    model_of, row_of = before.model_of.copy(), before.row_of.copy()
    model_of[new.numbers], row_of[new.numbers] = new.index + len(before.models), row
    return LevelTable((*before.models, *new.models), (*before.meshes, *rows), model_of, row_of), row
