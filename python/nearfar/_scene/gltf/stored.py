"""Meshes of a glTF document that the core reads directly from the file's bytes, as it can for most meshes."""

from __future__ import annotations

from collections.abc import Container, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._scene.budget import Budget
from nearfar._scene.gltf.buffers import Buffers
from nearfar._scene.gltf.corners import TRIANGLES, drawn_primitives, mode
from nearfar._scene.gltf.material_reader import NONE, MaterialReader
from nearfar._scene.gltf.tables import Table, table
from nearfar._scene.materials import BaseColor
from nearfar._scene.report import Surface, SurfaceUse

_NONE = -1
"""Index that means no accessor."""

_NAMES = ("POSITION", "NORMAL", "COLOR_0")

_ATTRIBUTES = np.array([12, 8, 4])
"""Bytes per vertex of normals, texture coordinates and colours."""

_PLAIN = {"attributes", "indices", "material", "mode", "targets", "extras"}
"""Entries of a primitive that do not affect its arrays."""

_COORDINATES = (5120, 5121, 5122, 5123, 5126)
_UNSIGNED = (5121, 5123, 5125)
_COLORS = (5121, 5123, 5126)
"""Component types supported for positions and normals, for indices, and for colours."""

Numbers = NDArray[np.int64]


@dataclass(frozen=True)
class Stored:
    """Meshes in the bytes of a source, with faces grouped by surface."""

    core: _core.StoredMeshes
    """The meshes; their material numbers are indices into `surfaces`."""
    names: Sequence[str]
    """Names of the meshes' shapes."""
    mesh: NDArray[np.int64]
    """Mesh of each group of faces (G,), ascending."""
    surface: NDArray[np.int64]
    """Surface of each group of faces (G,)."""
    surfaces: Sequence[Surface]

    def with_materials(self, materials: Sequence[Sequence[BaseColor]]) -> Stored:
        """Copy with other materials for the surfaces."""
        surfaces = [replace(old, materials=new) for old, new in zip(self.surfaces, materials, strict=True)]
        return replace(self, surfaces=surfaces)

    def uses(self, placed: NDArray[np.bool_]) -> list[SurfaceUse]:
        """Surfaces of the meshes in the mask `placed` (M,), for reports."""
        is_placed = placed[self.mesh]
        shape_counts = np.bincount(self.surface[is_placed], minlength=len(self.surfaces)).tolist()
        transparent_counts = [0] * len(self.surfaces)
        if any(surface.has_colors for surface in self.surfaces):
            rows = self.surface[is_placed & self.core.see_through()]
            transparent_counts = np.bincount(rows, minlength=len(self.surfaces)).tolist()
        return [SurfaceUse(*row) for row in zip(self.surfaces, shape_counts, transparent_counts, strict=True) if row[1]]


def read_stored(
    header: dict[str, Any],
    materials: MaterialReader,
    buffers: Buffers,
    budget: Budget,
    excluded: Container[int] = (),
) -> tuple[Stored | None, list[int]]:
    """Return the meshes that can be read directly, still without names, and their indices in the document.

    Meshes with the `excluded` indices are left out. None if no mesh remains.
    """
    meshes = {number: mesh for number, mesh in enumerate(header.get("meshes", [])) if number not in excluded}
    rows = table(header, buffers, _used_accessors([*meshes.values()], materials))
    if rows is None:
        return None, []
    reader = _Faces(rows, materials)
    faces = np.array([row for number, mesh in meshes.items() for row in reader.of_mesh(number, mesh)], np.int64)
    if not len(faces):
        return None, []
    budget.count_arrays(_bytes(rows, faces))
    numbers, mesh = np.unique(faces[:, 0], return_inverse=True)
    core = _core.StoredMeshes(rows.blocks, rows.rows, np.column_stack([mesh, faces[:, 1:]]))
    is_usable = core.usable()
    if not is_usable.all():
        core, numbers, faces = core.only(np.flatnonzero(is_usable)), numbers[is_usable], faces[is_usable[mesh]]
        mesh = np.unique(faces[:, 0], return_inverse=True)[1]
    return (Stored(core, [], mesh, faces[:, 6], [*reader.surfaces]), numbers.tolist()) if len(faces) else (None, [])


def _used_accessors(meshes: list[dict[str, Any]], materials: MaterialReader) -> set[int]:
    """Valid indices of the accessors that triangle primitives need."""
    numbers = []
    for primitive in (primitive for mesh in meshes for primitive in drawn_primitives(mesh)):
        attributes, material = primitive.get("attributes", {}), primitive.get("material")
        numbers += [primitive.get("indices"), *(attributes.get(name) for name in _NAMES)]
        uv_set = materials.coordinates(material) if type(material) is int and material >= 0 else None
        if uv_set is not None:
            numbers.append(attributes.get(f"TEXCOORD_{uv_set.number}"))
    return {number for number in numbers if type(number) is int}


def _bytes(rows: Table, faces: Numbers) -> int:
    """Upper bound of the bytes of the arrays that the meshes need; indices count as in the file."""
    has_corners = faces[:, 5] != _NONE
    counts = np.where(has_corners, rows.counts[faces[:, 5]], rows.counts[faces[:, 1]])
    corners = int((counts * np.where(has_corners, rows.rows[faces[:, 5], 2], 4)).sum())
    sets, of_set = np.unique(faces[:, :5], axis=0, return_inverse=True)
    uses = np.bincount(sets[:, 1])[sets[:, 1]]
    needed_counts = np.bincount(of_set.ravel(), counts, minlength=len(sets)).astype(np.int64)
    # Meshes that share positions copy a range each, at most twice as long as their faces need.
    taken_counts = np.where(uses > 1, np.minimum(rows.counts[sets[:, 1]], 2 * needed_counts), rows.counts[sets[:, 1]])
    return corners + int((taken_counts * (12 + (sets[:, 2:5] != _NONE) @ _ATTRIBUTES)).sum())


class _Faces:
    """Reads primitives as integer rows: mesh, positions, normals, UVs, colours, indices (−1 for none), surface."""

    def __init__(self, rows: Table, materials: MaterialReader) -> None:
        self._materials = materials
        self._counts = rows.counts.tolist()
        self._corners: list[bool] = (rows.allows((1,), _UNSIGNED) & rows.is_tight & (rows.counts % 3 == 0)).tolist()
        coordinates: list[bool] = rows.allows((3,), _COORDINATES).tolist()
        self._allowed: list[list[bool]] = [coordinates, coordinates, rows.allows((3, 4), _COLORS).tolist()]
        self._uvs: list[bool] = rows.allows((2,)).tolist()
        self._surfaces: dict[tuple[int, bool, bool, bool], int] = {}
        self.surfaces: list[Surface] = []

    def of_mesh(self, number: int, mesh: dict[str, Any]) -> list[tuple[int, ...]]:
        """Rows of a mesh; empty if one of its primitives cannot be read directly."""
        rows = [self._row(primitive) for primitive in drawn_primitives(mesh)]
        return [] if None in rows else [(number, *row) for row in rows if row is not None]

    def _row(self, primitive: dict[str, Any]) -> tuple[int, ...] | None:
        """Row of a primitive without the mesh; None if it cannot be read directly."""
        if mode(primitive) != TRIANGLES or not primitive.keys() <= _PLAIN:
            return None
        attributes, material = primitive.get("attributes", {}), primitive.get("material", NONE)
        if type(material) is not int or ("material" in primitive and material < 0):
            return None
        count, numbers = self._count_of(attributes["POSITION"]), []
        for name, allowed in zip(_NAMES, self._allowed, strict=True):
            number = attributes.get(name, _NONE)
            if name in attributes and not (_is_allowed(number, allowed) and self._counts[number] == count):
                return None
            numbers.append(number)
        corners = primitive.get("indices", _NONE)
        if count % 3 if "indices" not in primitive else not _is_allowed(corners, self._corners):
            return None
        positions, normals, colors = numbers
        uv_set = self._materials.coordinates(material)
        name = "" if uv_set is None else f"TEXCOORD_{uv_set.number}"
        surface = self._surface(material, normals != _NONE, name in attributes, colors != _NONE)
        uvs = _NONE
        if self.surfaces[surface].is_textured:
            uvs = attributes[name]
            if uv_set is None or not uv_set.is_plain or not _is_allowed(uvs, self._uvs) or self._counts[uvs] != count:
                return None
        return positions, normals, uvs, colors, corners, surface

    def _count_of(self, number: Any) -> int:
        """Number of an accessor's rows; −1 for an invalid index."""
        return self._counts[number] if type(number) is int and 0 <= number < len(self._counts) else -1

    def _surface(self, material: int, has_normals: bool, has_uvs: bool, has_colors: bool) -> int:
        key = (material, has_normals, has_uvs, has_colors)
        if key not in self._surfaces:
            self._surfaces[key] = len(self.surfaces)
            materials = self._materials.material(material) if material != NONE else []
            self.surfaces.append(Surface(materials, has_normals, has_uvs, has_colors))
        return self._surfaces[key]


def _is_allowed(number: Any, allowed: list[bool]) -> bool:
    """Whether an index is valid and its accessor allowed."""
    return type(number) is int and 0 <= number < len(allowed) and allowed[number]
