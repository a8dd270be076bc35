"""Content of a file or a trimesh object as plain arrays, its repair, and the assembly of a scene from it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check
from nearfar._base.errors import SceneError
from nearfar._scene.arrays import transforms_of
from nearfar._scene.assembly import Assembled, Assembly
from nearfar._scene.budget import Budget
from nearfar._scene.materials import PLAIN, UNCOLORED, BaseColor
from nearfar._scene.report import count
from nearfar._scene.units import metres_in

_TURNS = {
    "x": np.array([[0.0, -1, 0, 0], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]),
    "y": np.eye(4),
    "z": np.array([[1.0, 0, 0, 0], [0, 0, 1, 0], [0, -1, 0, 0], [0, 0, 0, 1]]),
}
"""Rotations that turn the named axis to y."""

UP = ("x", "y", "z", "-x", "-y", "-z")
"""Names of the axes that may point up."""

BLEND = ("opaque", "cutout")
"""Ways to draw materials that blend."""

_HALF = 0.5
"""Least alpha of a material that blends where it is drawn as cut out."""

_MOST_NAMED = 3
"""Greatest number of flaws that an error message lists; it counts the rest."""


@dataclass
class Shape:
    """A mesh of the source; `faces` may have any integer type and numbers out of range."""

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
    """Index into the content's `names` for each face (F,), for shapes of many objects; None for those of one."""


@dataclass(frozen=True)
class Nodes:
    """Placed shapes: for each of N its object's name, its transform object→world (N, 4, 4), and its shape's name.

    Names of objects do not count for shapes with a `face_object`.
    """

    objects: list[str]
    transforms: NDArray[np.float64]
    shapes: list[str]


@dataclass
class Content:
    """Content of a source that becomes part of a scene."""

    label: str
    """Name of the source in error messages, usually a path."""
    shapes: dict[str, Shape]
    nodes: Nodes
    notes: list[str] = field(default_factory=list)
    """Parts that are ignored or drawn differently, one sentence each."""
    used: list[str] = field(default_factory=list)
    """The format, and parts that the scene uses besides its meshes, one phrase each."""
    units: Sequence[str] = ()
    """Units that the meshes state, in trimesh's names and "" for none; without any the unit is the metre."""
    names: Sequence[str] | int = ()
    """Objects of the shapes with a `face_object`, or the number of nameless ones."""


def assemble(
    content: Content,
    *,
    up: str,
    on_invalid: str,
    scale: float | None = None,
    budget: Budget | None = None,
    moves: bool = False,
    blend: str = "opaque",
    origin: NDArray[np.float64] | None = None,
) -> Assembled:
    """Assemble a scene's parts in one pass over the source's meshes; SceneError if they cannot be used.

    A `budget` counts the copies of what is placed many times. With `moves` all objects are dynamic. The extent
    chooses an `origin` (3,) unless it is given.
    """
    check.choice("up", up, UP)
    check.choice("on_invalid", on_invalid, ("raise", "drop"))
    check.choice("blend", blend, BLEND)
    _to_metres(content, scale)
    nodes, flaws = _usable_nodes(content.nodes)
    used = set(nodes.shapes)
    shapes = {name: shape for name, shape in content.shapes.items() if name in used}
    dropped = 0
    for name, shape in shapes.items():
        flaw, lost = _repair(shape)
        dropped += lost
        if flaw:
            flaws.append(f"{flaw} in mesh {check.shortened(name)}")
    if flaws and on_invalid == "raise":
        more = f" and {len(flaws) - _MOST_NAMED} more" if len(flaws) > _MOST_NAMED else ""
        raise SceneError(
            f"{content.label}: {', '.join(flaws[:_MOST_NAMED])}{more}; on_invalid='drop' leaves the faces out"
        )
    if not any(len(shape.faces) for shape in shapes.values()):
        raise SceneError(f"{content.label}: no triangles" + "".join(f"; {note}" for note in content.notes))
    if blend == "cutout":
        _cut_out(shapes.values())
    builder = Assembly()
    many = _many_objects(content, moves)
    builder.objects(many)
    handles = {name: _add(builder, shape) for name, shape in shapes.items() if len(shape.faces)}
    # The opposite axis is turned by another half turn about x.
    turn = np.diag([1.0, -1.0, -1.0, 1.0]) @ _TURNS[up[1:]] if up.startswith("-") else _TURNS[up]
    nodes = _chosen(nodes, np.array([shape in handles for shape in nodes.shapes], bool))
    transforms = nodes.transforms if up == "y" else turn @ nodes.transforms
    try:
        transforms = transforms_of("transforms", transforms)
        has_many = np.array([shapes[name].face_object is not None for name in nodes.shapes], bool)
        for row in np.flatnonzero(has_many):
            builder.instance(handles[nodes.shapes[row]], transforms[row])
        single = _chosen(replace(nodes, transforms=transforms), ~has_many)
        placed = np.array([handles[shape] for shape in single.shapes], np.int64)
        builder._place(placed, single.transforms, single.objects)
        dynamic = [*([] if isinstance(many, int) else many), *single.objects] if moves else ()
        parts = builder._assemble(dynamic, budget, origin)
    except ValueError as error:
        raise SceneError(f"{content.label}: {error}") from error
    notes = [*content.notes, *_material_notes(shapes.values()), *_alpha_notes(shapes.values())]
    notes += _emission_notes(shapes.values())
    held = (*content.used, *_inventory(shapes.values()))
    return replace(parts, dropped=dropped, notes=tuple(notes), used=held)


def _many_objects(content: Content, moves: bool) -> Sequence[str] | int:
    """Objects of shapes of many; those that move have names."""
    names = content.names
    return [f"object_{number}" for number in range(names)] if moves and isinstance(names, int) else names


def _to_metres(content: Content, scale: float | None) -> None:
    """Scale vertices and translations, so that rotations stay rotations and poses of objects have no scale."""
    metres = metres_in(content.label, content.units) if scale is None else check.positive("scale", scale)
    if metres == 1.0:
        return
    if scale is None:
        content.notes.append(f"unit '{content.units[0]}' converted, {metres:g} m")
    for shape in content.shapes.values():
        shape.vertices = np.asarray(shape.vertices, np.float64) * metres
    factors = np.ones((4, 4))
    factors[:3, 3] = metres
    content.nodes = replace(content.nodes, transforms=content.nodes.transforms * factors)


def _usable_nodes(nodes: Nodes) -> tuple[Nodes, list[str]]:
    """Split off nodes whose transforms are not finite and affine; returns the others and a description of each flaw."""
    matrices = nodes.transforms
    affine = np.isfinite(matrices).all(axis=(1, 2)) & (matrices[:, 3] == (0, 0, 0, 1)).all(axis=1)
    flaws = [
        f"a transform that is not finite and affine at node {check.shortened(nodes.objects[row])}"
        for row in np.flatnonzero(~affine)
    ]
    return _chosen(nodes, affine), flaws


def _chosen(nodes: Nodes, keep: NDArray[np.bool_]) -> Nodes:
    if keep.all():
        return nodes
    rows = np.flatnonzero(keep)
    return Nodes([nodes.objects[row] for row in rows], nodes.transforms[rows], [nodes.shapes[row] for row in rows])


def _repair(shape: Shape) -> tuple[str, int]:
    """Drop faces with unusable vertices; returns a description of the flaws and the number of dropped faces."""
    vertices, faces = shape.vertices, shape.faces
    flaws = []
    # A coordinate beyond float32's range counts as infinite. NaN passes through min and max and fails the comparison.
    limit = np.finfo(np.float32).max
    bad = np.zeros(0, bool)
    if vertices.size and not (vertices.min() >= -limit and vertices.max() <= limit):
        bad = np.asarray(~(np.abs(vertices) <= limit).all(axis=1))
        flaws.append(f"{count(int(bad.sum()), 'vertex', 'vertices')} with coordinates that are not finite")
    if faces.size and (int(faces.min()) < 0 or int(faces.max()) >= len(vertices)):
        outside = ((faces < 0) | (faces >= len(vertices))).any(axis=1)
        flaws.append(f"{count(int(outside.sum()), 'face')} with vertices that do not exist")
    if not flaws:
        return "", 0
    keep = np.asarray(((faces >= 0) & (faces < len(vertices))).all(axis=1))
    if bad.any():
        keep[keep] = ~bad[faces[keep]].any(axis=1)
        shape.vertices = np.where(bad[:, None], 0, vertices)
    shape.faces = faces[keep]
    if shape.face_material is not None:
        shape.face_material = shape.face_material[keep]
    if shape.face_object is not None:
        shape.face_object = shape.face_object[keep]
    return " and ".join(flaws), int((~keep).sum())


def _add(builder: Assembly, shape: Shape) -> int:
    materials = shape.materials or [PLAIN if shape.colors is None else UNCOLORED]
    textured = shape.uvs is not None and any(material.is_textured for material in materials)
    chosen = materials if textured else [material.without_textures() for material in materials]
    numbers = [builder._material(material) for material in chosen]
    per_face = len(numbers) > 1 and shape.face_material is not None
    return builder.mesh(
        shape.vertices,
        shape.faces,
        material=np.array(numbers, np.int32)[shape.face_material] if per_face else numbers[0],
        uvs=shape.uvs if textured else None,
        colors=shape.colors,
        normals=None if shape.normals is None else _finite(shape.normals),
        face_object=shape.face_object,
    )


def _finite(normals: NDArray[Any]) -> NDArray[Any]:
    """Replace normals that are not finite by zeros: a file with damaged normals is still usable."""
    good = np.isfinite(normals).all(axis=1, keepdims=True)
    return normals if good.all() else np.where(good, normals, 0)


def _inventory(shapes: Collection[Shape]) -> list[str]:
    """Count shapes, their vertices, and those that have an attribute, one phrase each."""
    vertices = sum(len(shape.vertices) for shape in shapes)
    attributes = {
        "vertex normals": sum(shape.normals is not None for shape in shapes),
        "texture coordinates": sum(shape.uvs is not None for shape in shapes),
        "vertex colours": sum(shape.colors is not None for shape in shapes),
    }
    whole = "all of them" if len(shapes) > 1 else "it"
    return [
        f"{count(len(shapes), 'mesh', 'meshes')} with {count(vertices, 'vertex', 'vertices')}",
        *(
            f"{name} of {whole if number == len(shapes) else f'{number:,} of them'}"
            for name, number in attributes.items()
            if number
        ),
    ]


def _cut_out(shapes: Iterable[Shape]) -> None:
    """Cut materials that blend out; those that shapes share stay shared."""
    cut: dict[int, BaseColor] = {}
    for shape in shapes:
        for material in shape.materials:
            if material.blend and id(material) not in cut:
                cut[id(material)] = replace(material, cutoff=_HALF)
        shape.materials = [cut.get(id(material), material) for material in shape.materials]


def _material_notes(shapes: Iterable[Shape]) -> list[str]:
    materials = {id(material): material for shape in shapes for material in shape.materials}
    counts = Counter(note for material in materials.values() for note in (*_blend_notes(material), *material.notes))
    return [f"{count(number, 'material')} {note}" for note, number in counts.items()]


def _blend_notes(material: BaseColor) -> list[str]:
    drawn = "opaque" if material.cutoff is None else "where alpha is at least 1/2"
    return [f"with {material.blend} drawn {drawn}"] if material.blend else []


def _alpha_notes(shapes: Iterable[Shape]) -> list[str]:
    transparent = sum(_ignores_alpha(shape) for shape in shapes)
    return [f"{count(transparent, 'mesh', 'meshes')} with vertex alpha below 1 drawn opaque"] if transparent else []


def _emission_notes(shapes: Iterable[Shape]) -> list[str]:
    lost = sum(
        shape.uvs is None and any(material.emission_texture is not None for material in shape.materials)
        for shape in shapes
    )
    ending = "with a map of emission but no texture coordinates drawn and saved without it"
    return [f"{count(lost, 'mesh', 'meshes')} {ending}"] if lost else []


def _ignores_alpha(shape: Shape) -> bool:
    if shape.colors is None or shape.colors.shape[1] < 4 or (shape.colors[:, 3] == 255).all():
        return False
    return not shape.materials or any(material.cutoff is None for material in shape.materials)
