"""Plain arrays read from a file or a trimesh object; repairs them and assembles a scene."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar._base.errors import SceneError
from nearfar._scene.arrays import transforms_of
from nearfar._scene.assembly import Assembly
from nearfar._scene.budget import Budget
from nearfar._scene.frames import Z_UP_TO_SCENE
from nearfar._scene.gltf.stored import Stored
from nearfar._scene.materials import BaseColor
from nearfar._scene.options import LoadOptions
from nearfar._scene.report import Surface, SurfaceUse, count, inventory, listing, notes as notes_on
from nearfar._scene.srgb import to_linear
from nearfar._scene.units import metres_in

_TURNS = {
    "x": np.array([[0.0, -1, 0, 0], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]),
    "y": np.eye(4),
    "z": Z_UP_TO_SCENE,
}
"""Rotations that turn the named axis to y."""

_BLEND_CUTOFF = 0.5
"""Alpha cutoff of blending materials drawn as "cutout"."""


@dataclass
class Shape:
    """A mesh of the source; its `faces` may have any integer type, and indices out of range."""

    vertices: NDArray[Any]
    faces: NDArray[Any]
    uvs: NDArray[Any] | None = None
    colors: NDArray[np.uint8] | None = None
    """Vertex colours (V, 3 or 4), sRGB with linear alpha."""
    normals: NDArray[Any] | None = None
    """Outward vertex normals (V, 3) of any length; rows that are zero or not finite count as no normal."""
    materials: list[BaseColor] = field(default_factory=list)
    """Materials; an empty list means the plain one."""
    face_material: NDArray[Any] | None = None
    """Index into `materials` for each face (F,); None with at most one material."""
    face_object: NDArray[np.int32] | None = None
    """Index into the content's `names` for each face (F,) of a shape with many objects; None for one object."""

    @property
    def surface(self) -> Surface:
        """Materials, and which vertex attributes exist."""
        return Surface(self.materials, *(rows is not None for rows in (self.normals, self.uvs, self.colors)))

    @property
    def use(self) -> SurfaceUse:
        """The shape's surface, for reports."""
        has_transparency = (
            self.colors is not None and self.colors.shape[1] == 4 and bool((self.colors[:, 3] != 255).any())
        )
        return SurfaceUse(self.surface, 1, int(has_transparency))

    def color_faces(self, colors: NDArray[np.uint8]) -> None:
        """Convert face colours (F, 4), sRGB, to materials, so that neighbouring faces can still share vertices."""
        # `np.unique` compares rows as structured types, during which Ctrl-C becomes a TypeError; integers avoid this.
        codes = np.ascontiguousarray(colors, np.uint8).view(">u4").ravel()
        distinct, self.face_material = np.unique(codes, return_inverse=True)
        distinct = distinct.astype(">u4").view(np.uint8).reshape(-1, 4)
        rows = np.column_stack([to_linear(distinct[:, :3] / 255), distinct[:, 3] / 255]).tolist()
        self.materials += [BaseColor((red, green, blue, alpha)) for red, green, blue, alpha in rows]


@dataclass(frozen=True)
class Nodes:
    """Placed shapes: for each of N nodes the object's name, the transform object→world (N, 4, 4) and the shape's name.

    For shapes with a `face_object` the node's object name is ignored.
    """

    objects: list[str]
    transforms: NDArray[np.float64]
    shapes: list[str]

    @classmethod
    def from_rows(cls, rows: Sequence[tuple[str, NDArray[np.float64], str]]) -> Nodes:
        """Make nodes of rows, each with an object's name, a transform (4, 4) and a shape's name."""
        transforms = np.array([transform for _, transform, _ in rows], np.float64).reshape(-1, 4, 4)
        return cls([name for name, _, _ in rows], transforms, [shape for _, _, shape in rows])


def translation(offset: ArrayLike) -> NDArray[np.float64]:
    """Transform (4, 4) that moves points by an offset (3,)."""
    matrix = np.eye(4)
    matrix[:3, 3] = offset
    return matrix


@dataclass
class Content:
    """Content of a source, from which a scene is assembled."""

    label: str
    """Name of the source in error messages, usually a path."""
    shapes: dict[str, Shape]
    nodes: Nodes
    notes: list[str] = field(default_factory=list)
    """Parts that are ignored or drawn differently, one sentence each."""
    used: list[str] = field(default_factory=list)
    """The format, and features that the scene uses besides meshes, one phrase each."""
    units: Sequence[str] = ()
    """Units that the meshes state, as trimesh names them, "" for none; without any, the unit is the metre."""
    names: Sequence[str] | int = ()
    """Object names for shapes with a `face_object`, or the number of nameless objects."""
    stored: Stored | None = None
    """Further shapes, whose meshes the core reads directly from the source's bytes."""

    @classmethod
    def of_shape(cls, label: str, shape: Shape, notes: list[str]) -> Content:
        """Make the content of a source with a single shape, named as in trimesh."""
        return cls(label, {"geometry": shape}, Nodes.from_rows([("geometry", np.eye(4), "geometry")]), notes)


def assemble(
    content: Content,
    options: LoadOptions,
    *,
    budget: Budget | None = None,
    moves: bool = False,
    origin: NDArray[np.float64] | None = None,
) -> dict[str, Any]:
    """Return the arguments of `Scene`, in one pass over the source's meshes; SceneError if they are unusable.

    A `budget` counts the copies of meshes placed several times. With `moves`, all objects are dynamic. `origin` (3,) is
    the point that float32 coordinates are relative to; None chooses it by the extent.
    """
    _to_metres(content, options.scale)
    nodes, flaws = _usable_nodes(content.nodes)
    used_names = set(nodes.shapes)
    shapes = {name: shape for name, shape in content.shapes.items() if name in used_names}
    dropped = 0
    for name, shape in shapes.items():
        flaw, dropped_faces = _repair(shape)
        dropped += dropped_faces
        if flaw:
            flaws.append(f"{flaw} in mesh {check.shortened(name)}")
    if flaws and not options.drops:
        raise SceneError(f"{content.label}: {listing(flaws)}; on_invalid='drop' leaves the faces out")
    stored = content.stored
    is_placed = np.zeros(0, bool) if stored is None else np.array([name in used_names for name in stored.names])
    has_faces = stored is not None and stored.core.face_counts()[is_placed].any()
    if not has_faces and not any(len(shape.faces) for shape in shapes.values()):
        raise SceneError(f"{content.label}: no triangles" + "".join(f"; {note}" for note in content.notes))
    if options.blend == "cutout":
        stored = _cut_out(shapes.values(), stored)
    builder = Assembly()
    # Moving objects need names.
    names = content.names
    names = [f"object_{number}" for number in range(names)] if moves and isinstance(names, int) else names
    builder.objects(names)
    handles = {} if stored is None else _store(builder, stored, is_placed)
    handles |= {name: _add(builder, shape) for name, shape in shapes.items() if len(shape.faces)}
    up = options.up
    # For a negative axis, another half turn about x.
    turn = np.diag([1.0, -1.0, -1.0, 1.0]) @ _TURNS[up[1:]] if up.startswith("-") else _TURNS[up]
    nodes = _select_nodes(nodes, np.array([shape in handles for shape in nodes.shapes], bool))
    transforms = nodes.transforms if up == "y" else turn @ nodes.transforms
    try:
        nodes = replace(nodes, transforms=transforms_of("transforms", transforms))
        has_many = np.array([name in shapes and shapes[name].face_object is not None for name in nodes.shapes], bool)
        for row in np.flatnonzero(has_many):
            builder.instance(handles[nodes.shapes[row]], nodes.transforms[row])
        single = _select_nodes(nodes, ~has_many)
        meshes = np.array([handles[shape] for shape in single.shapes], np.int64)
        builder._place(meshes, single.transforms, single.objects)
        dynamic = [*([] if isinstance(names, int) else names), *single.objects] if moves else ()
        arguments = builder._assemble(dynamic, budget, origin)
    except ValueError as error:
        raise SceneError(f"{content.label}: {error}") from error
    uses = [shape.use for shape in shapes.values()]
    vertices = sum(len(shape.vertices) for shape in shapes.values())
    if stored is not None:
        uses += stored.uses(is_placed)
        vertices += int(stored.core.vertex_counts()[is_placed].sum())
    notes, features = (*content.notes, *notes_on(uses)), (*content.used, *inventory(uses, vertices))
    return arguments | {"dropped": dropped, "notes": notes, "used": features}


def _to_metres(content: Content, scale: float | None) -> None:
    """Scale vertices and translations to metres; the linear parts of transforms stay, so poses have no scale."""
    metres = metres_in(content.label, content.units) if scale is None else scale
    if metres == 1.0:
        return
    if scale is None:
        content.notes.append(f"unit '{content.units[0]}' converted, {metres:g} m")
    for shape in content.shapes.values():
        shape.vertices = np.asarray(shape.vertices, np.float64) * metres
    if content.stored is not None:
        content.stored = replace(content.stored, core=content.stored.core.scaled(metres))
    factors = np.ones((4, 4))
    factors[:3, 3] = metres
    content.nodes = replace(content.nodes, transforms=content.nodes.transforms * factors)


def _usable_nodes(nodes: Nodes) -> tuple[Nodes, list[str]]:
    """Remove nodes whose transforms are not finite and affine; return the others and a description of each flaw."""
    matrices = nodes.transforms
    affine = np.isfinite(matrices).all(axis=(1, 2)) & (matrices[:, 3] == (0, 0, 0, 1)).all(axis=1)
    names = (check.shortened(nodes.objects[row]) for row in np.flatnonzero(~affine))
    return _select_nodes(nodes, affine), [f"a transform that is not finite and affine at node {n}" for n in names]


def _select_nodes(nodes: Nodes, keep: NDArray[np.bool_]) -> Nodes:
    if keep.all():
        return nodes
    rows = np.flatnonzero(keep)
    return Nodes([nodes.objects[row] for row in rows], nodes.transforms[rows], [nodes.shapes[row] for row in rows])


def _repair(shape: Shape) -> tuple[str, int]:
    """Drop faces with unusable vertices; return a description of the flaws and the number of dropped faces."""
    vertices, faces = shape.vertices, shape.faces
    flaws = []
    # NaN propagates through min and max and fails the comparison.
    limit = np.finfo(np.float32).max
    is_infinite = np.zeros(0, bool)
    if vertices.size and not (vertices.min() >= -limit and vertices.max() <= limit):
        is_infinite = np.asarray(~(np.abs(vertices) <= limit).all(axis=1))
        is_nan = np.asarray(~np.isfinite(vertices).all(axis=1))
        if is_nan.any():
            flaws.append(f"{count(int(is_nan.sum()), 'vertex', 'vertices')} with coordinates that are not finite")
        if (too_large := vertices[is_infinite & ~is_nan]).size:
            flaw = f"with coordinates too large for 32-bit floats, up to {np.abs(too_large).max():g},"
            flaws.append(f"{count(len(too_large), 'vertex', 'vertices')} {flaw}")
    if faces.size and (int(faces.min()) < 0 or int(faces.max()) >= len(vertices)):
        is_damaged = ((faces < 0) | (faces >= len(vertices))).any(axis=1)
        flaws.append(f"{count(int(is_damaged.sum()), 'face')} with vertices that do not exist")
    if not flaws:
        return "", 0
    keep = np.asarray(((faces >= 0) & (faces < len(vertices))).all(axis=1))
    if is_infinite.any():
        keep[keep] = ~is_infinite[faces[keep]].any(axis=1)
        shape.vertices = np.where(is_infinite[:, None], 0, vertices)
    shape.faces = faces[keep]
    if shape.face_material is not None:
        shape.face_material = shape.face_material[keep]
    if shape.face_object is not None:
        shape.face_object = shape.face_object[keep]
    return " and ".join(flaws), int((~keep).sum())


def _add(builder: Assembly, shape: Shape) -> int:
    numbers = [builder._materials.add(material) for material in shape.surface.drawn_materials]
    per_face = len(numbers) > 1 and shape.face_material is not None
    return builder.mesh(
        shape.vertices,
        shape.faces,
        material=np.array(numbers, np.int32)[shape.face_material] if per_face else numbers[0],
        uvs=shape.uvs if shape.surface.is_textured else None,
        colors=shape.colors,
        normals=None if shape.normals is None else _finite(shape.normals),
        face_object=shape.face_object,
    )


def _finite(normals: NDArray[Any]) -> NDArray[Any]:
    """Replace normals that are not finite by zeros, so that files with damaged normals stay usable."""
    is_finite = np.isfinite(normals).all(axis=1, keepdims=True)
    return normals if is_finite.all() else np.where(is_finite, normals, 0)


def _store(builder: Assembly, stored: Stored, placed: NDArray[np.bool_]) -> dict[str, int]:
    """Add stored meshes, and the materials of those in the mask `placed` (M,); return handles by name."""
    numbers = np.zeros(len(stored.surfaces), np.int32)
    for number in np.unique(stored.surface[placed[stored.mesh]]).tolist():
        (material,) = stored.surfaces[number].drawn_materials
        numbers[number] = builder._materials.add(material)
    builder._meshes.store(stored.core.with_materials(numbers))
    counts = stored.core.face_counts().tolist()
    return {name: number for number, (name, faces) in enumerate(zip(stored.names, counts, strict=True)) if faces}


def _cut_out(shapes: Iterable[Shape], stored: Stored | None) -> Stored | None:
    """Turn blending materials into cutouts: change shapes in place, return changed stored meshes; keep sharing."""
    cutouts: dict[int, BaseColor] = {}

    def cut_out(materials: Sequence[BaseColor]) -> list[BaseColor]:
        for material in materials:
            if material.blend and id(material) not in cutouts:
                cutouts[id(material)] = replace(material, cutoff=_BLEND_CUTOFF)
        return [cutouts.get(id(material), material) for material in materials]

    for shape in shapes:
        shape.materials = cut_out(shape.materials)
    if stored is None:
        return None
    return stored.with_materials([cut_out(surface.materials) for surface in stored.surfaces])
