"""Objects with levels of detail: the meshes that they may show, where they stand, and what of them a picture drew."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._scene.names import Names


@runtime_checkable
class Selector(Protocol):
    """What pictures need of a `nearfar.lod.Selector`."""

    @property
    def fade(self) -> float:
        """Above 0 where levels fade over."""

    @property
    def select(self) -> Callable[..., Any]:
        """Chooses levels, as `nearfar.lod.select` does."""


@runtime_checkable
class Model(Protocol):
    """What scenes need of a `nearfar.lod.LodModel`, which comes later in the data flow."""

    @property
    def center(self) -> NDArray[np.float64]:
        """Centre of the bounding sphere (3,), metres in the object's frame."""

    @property
    def radius(self) -> float:
        """Its radius, metres."""

    @property
    def levels(self) -> Sequence[Any] | None:
        """The geometry of each level, in its `scene`."""

    def selector(self, mode: str) -> Selector:
        """What chooses levels in a mode, with its defaults."""

    def __len__(self) -> int: ...


@dataclass(frozen=True, eq=False)
class Leveled:
    """The N objects of a scene that have levels, in the order of their numbers.

    From `models` on they are what `nearfar.lod.select` takes.
    """

    names: tuple[str, ...]
    """Of the objects."""
    numbers: NDArray[np.int64]
    """The same as in `Frame.object_id` (N,), ascending."""
    models: tuple[Any, ...]
    """The different models, each a `nearfar.lod.LodModel`."""
    model_index: NDArray[np.int64]
    """Which of them each object has (N,)."""
    centers: NDArray[np.float64]
    """Middles of the objects' bounding spheres (N, 3), world, metres."""
    radii: NDArray[np.float64]
    """Their radii (N,), metres: the model's, times the greatest scale of where the object stands."""

    def __len__(self) -> int:
        """How many objects there are."""
        return len(self.names)

    @property
    def level_counts(self) -> NDArray[np.int64]:
        """How many levels each object has (N,)."""
        return np.array([len(model) for model in self.models], np.int64)[self.model_index]

    def __repr__(self) -> str:
        return f"Leveled({len(self.names):,} objects, {len(self.models):,} models)"


@dataclass(frozen=True, eq=False)
class Shown:
    """What a picture drew of a scene whose objects have levels."""

    levels: NDArray[np.int64]
    """Level of each object (N,) in the order of `Scene.leveled`, 0 the finest; −1 for one that was left out."""
    triangles: int
    """Triangles that were drawn, those of objects without levels among them."""
    full_triangles: int
    """Triangles of the whole scene with everything at level 0."""
    selection: Any = None
    """The selector's answer: a `nearfar.lod.Selection`, with weights where it fades. None where levels were given."""


@dataclass(frozen=True, eq=False)
class LevelTable:
    """The levels of a scene's objects. Scenes made from one another share it."""

    models: tuple[Any, ...]
    meshes: tuple[tuple[_core.Mesh, ...], ...]
    """Rows of meshes, one for each level of a model. Objects that stand mirrored have rows of their own."""
    core: _core.Levels
    """The same for kernels."""
    model_of: NDArray[np.int32]
    """Of each object the model, −1 where it has none."""
    row_of: NDArray[np.int32]
    """Of each object the row of meshes, −1 where it has none."""

    def __reduce__(self) -> tuple[Any, ...]:
        """Meshes travel to other processes as arrays."""
        meshes = [[_core.mesh_parts(mesh) for mesh in row] for row in self.meshes]
        return _restored, (self.models, meshes, self.model_of, self.row_of)

    def leveled(self, core: _core.Scene, names: Names) -> Leveled:
        """Return the objects with levels that a scene holds, where they are in it."""
        placements, numbers = _core.placements_of(core, self.row_of >= 0)
        order = np.argsort(numbers)
        placements, numbers = placements[order], numbers[order]
        index = self.model_of[numbers].astype(np.int64)
        middles = np.array([model.center for model in self.models], np.float64).reshape(-1, 3)[index]
        sizes = np.array([model.radius for model in self.models], np.float64)[index]
        axes = placements[:, :, :3]
        centers = np.einsum("nij,nj->ni", axes, middles) + placements[:, :, 3] + np.array(core.origin)
        # The greatest scale is the root of the greatest eigenvalue of AᵀA.
        scales = np.sqrt(np.linalg.eigvalsh(axes.transpose(0, 2, 1) @ axes)[:, -1]) if len(axes) else np.zeros(0)
        named = tuple(names.all[number] for number in numbers)
        return Leveled(named, numbers.astype(np.int64), self.models, index, centers, sizes * scales)


def _restored(
    models: tuple[Any, ...],
    parts: list[list[dict[str, Any]]],
    model_of: NDArray[np.int32],
    row_of: NDArray[np.int32],
) -> LevelTable:
    meshes = tuple(
        tuple(_core.Mesh(mesh.pop("positions"), mesh.pop("faces"), **mesh) for mesh in map(dict, row)) for row in parts
    )
    return LevelTable(models, meshes, _core.Levels([list(row) for row in meshes]), model_of, row_of)


@dataclass(frozen=True, eq=False)
class Given:
    """Objects that are given levels."""

    numbers: NDArray[np.int64]
    """Of the objects (K,)."""
    models: tuple[Any, ...]
    """Different models."""
    index: NDArray[np.int64]
    """Which of them each object is given (K,)."""
    frames: NDArray[np.float64]
    """Where the levels stand (K, 4, 4), their frame→world, when the objects were loaded."""


def given(
    names: Names, numbers: Sequence[int], models: Sequence[object], frames: NDArray[np.float64], *, in_place: bool
) -> Given:
    """Check models and where they are to stand; errors name the object.

    `in_place` says that frames are those of objects whose place the levels take: the levels' own is taken off.
    """
    distinct: dict[int, Any] = {}
    for number, model in zip(numbers, models, strict=True):
        if id(model) not in distinct:
            _check_model(f"models['{names.all[number]}']", model)
            distinct[id(model)] = model
    rank = {key: place for place, key in enumerate(distinct)}
    index = np.array([rank[id(model)] for model in models], np.int64)
    flat = np.linalg.matrix_rank(frames[:, :3, :3]) < 3 if len(frames) else np.zeros(0, bool)
    if flat.any():
        name = names.all[numbers[int(np.argmax(flat))]]
        raise ValueError(f"models: expected objects with invertible transforms, got a flat one for '{name}'")
    if in_place:
        own = np.array([model.levels.frame for model in distinct.values()], np.float64).reshape(-1, 4, 4)
        frames = _placing(frames, own[index])
    return Given(np.array(numbers, np.int64), tuple(distinct.values()), index, frames)


def _placing(frames: NDArray[np.float64], own: NDArray[np.float64]) -> NDArray[np.float64]:
    """Levels' frames→world: an object's transform after the levels' frame is taken off; nothing is lost where equal."""
    solved = np.linalg.solve(own.transpose(0, 2, 1), frames.transpose(0, 2, 1))
    placing = np.array(solved.transpose(0, 2, 1), np.float64)
    placing[:, 3] = (0, 0, 0, 1)
    same = (frames == own).all(axis=(1, 2))
    placing[same] = np.eye(4)
    return placing


def _check_model(argument: str, model: object) -> None:
    if not isinstance(model, Model):
        raise TypeError(f"{argument}: expected a LodModel, got {type(model).__name__}")
    if model.levels is None:
        raise ValueError(f"{argument}: expected a model with the geometry of its levels, got one without")
    if len(model.levels) != len(model):
        raise ValueError(f"{argument}: expected geometry of {len(model)} levels, got {len(model.levels)}")


def levels_of(argument: str, levels: ArrayLike | Mapping[str, int], leveled: Leveled) -> NDArray[np.int64]:
    """One level for each object (N,), −1 for those left out; by name, objects that are not named are at level 0."""
    if isinstance(levels, Mapping):
        place = {name: at for at, name in enumerate(leveled.names)}
        if unknown := [name for name in levels if name not in place]:
            raise ValueError(f"{argument}: expected names of objects with levels, got {unknown[0]!r}")
        chosen = np.zeros(len(leveled), np.int64)
        for name, level in levels.items():
            chosen[place[name]] = check.integer(f"{argument}['{name}']", level, -1, 2**31 - 1)
    else:
        chosen = check.array(argument, levels, columns=None, dtype=np.int64)
    if chosen.shape != (len(leveled),):
        raise ValueError(
            f"{argument}: expected one for each of {len(leveled)} objects with levels, got shape {chosen.shape}"
        )
    counts = leveled.level_counts
    wrong = (chosen < -1) | (chosen >= counts)
    if wrong.any():
        at = int(np.argmax(wrong))
        most = counts[at] - 1
        raise ValueError(f"{argument}: expected -1 to {most} for '{leveled.names[at]}', got {chosen[at]}")
    return chosen


def with_levels(
    core: _core.Scene, rest: NDArray[np.float64], before: LevelTable | None, objects: int, new: Given
) -> tuple[_core.Scene, NDArray[np.float64], LevelTable]:
    """Put levels in the place of what objects were.

    Parameters
    ----------
    core, rest, before
        The scene, where its moving instances were loaded, and the levels that its objects have already.
    objects
        How many objects the scene knows.
    new
        What is given to which of them.

    Returns
    -------
    core, rest, table
        Of the new scene, in which the objects show level 0.
    """
    chosen = np.zeros(objects, bool)
    chosen[new.numbers] = True
    owner = core.moving_objects()
    placed, moves = _placements(core, rest, new)
    core, pieces = _core.with_surfaces(core, [level.scene._core for model in new.models for level in model.levels])
    rows = _rows(pieces, [len(model.levels) for model in new.models])
    table, row = _table(before, objects, new, rows)
    order = np.argsort(moves, kind="stable")
    core = _core.with_instances(
        core.without_objects(chosen),
        [table.meshes[number][0] for number in row[order]],
        placed[order],
        new.numbers[order].astype(np.int32),
        int(np.count_nonzero(~moves)),
    )
    loaded = new.frames[order[moves[order]], :3].copy()
    loaded[:, :, 3] -= np.array(core.origin)
    return core, np.concatenate([rest[~chosen[owner]], loaded]), table


def _placements(
    core: _core.Scene, rest: NDArray[np.float64], new: Given
) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """Where the objects are (K, 3, 4), relative to the origin, and which of them move."""
    placed = new.frames[:, :3].copy()
    placed[:, :, 3] -= np.array(core.origin)
    owner, first = np.unique(core.moving_objects(), return_index=True)
    moves = np.isin(new.numbers, owner)
    instance = first[np.searchsorted(owner, new.numbers[moves])]
    now, then = (_square(rows[instance]) for rows in (core.moving_placements(), rest))
    moved = (now != then).any(axis=(1, 2))
    at = np.flatnonzero(moves)[moved]
    # mesh→scene is pose · load⁻¹ · (mesh→scene when loaded), of which the pose is wanted.
    placed[at] = (now[moved] @ np.linalg.solve(then[moved], _square(placed[at])))[:, :3]
    return placed, moves


def _square(rows: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.concatenate([rows, np.tile([[[0.0, 0, 0, 1]]], (len(rows), 1, 1))], axis=1)


def _rows(pieces: list[_core.Mesh], lengths: list[int]) -> list[tuple[_core.Mesh, ...]]:
    ends = np.cumsum(lengths, dtype=int).tolist()
    return [tuple(pieces[end - length : end]) for end, length in zip(ends, lengths, strict=True)]


def _table(
    before: LevelTable | None, objects: int, new: Given, rows: list[tuple[_core.Mesh, ...]]
) -> tuple[LevelTable, NDArray[np.int64]]:
    """The levels of all objects, and the row of each that is given some."""
    models = () if before is None else before.models
    meshes = () if before is None else before.meshes
    row = new.index + len(meshes)
    # Objects that stand mirrored take twins whose faces keep their outside outside.
    mirrored = np.linalg.det(new.frames[:, :3, :3]) < 0 if len(new.frames) else np.zeros(0, bool)
    for model in np.unique(new.index[mirrored]).tolist():
        row[mirrored & (new.index == model)] = len(meshes) + len(rows)
        rows = [*rows, tuple(mesh.turned() for mesh in rows[model])]
    none = np.full(objects, -1, np.int32)
    model_of, row_of = (none, none.copy()) if before is None else (before.model_of.copy(), before.row_of.copy())
    model_of[new.numbers], row_of[new.numbers] = new.index + len(models), row
    meshes = (*meshes, *rows)
    core = _core.Levels([list(levels) for levels in meshes])
    return LevelTable((*models, *new.models), meshes, core, model_of, row_of), row
