"""The meshes of a glTF document that the core can read as they lie in the file: most meshes of most files."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._scene.budget import Budget
from nearfar._scene.gltf.buffers import Buffers
from nearfar._scene.gltf.corners import MODES, TRIANGLES, mode
from nearfar._scene.gltf.material_reader import NONE, MaterialReader
from nearfar._scene.gltf.tables import Table, table
from nearfar._scene.stored import Stored, Surface

_FACE, _VERTEX = 12, 12 + 12 + 8 + 4
"""Bytes of a face, and of a vertex with all of its attributes."""

_PLAIN = {"attributes", "indices", "material", "mode", "targets", "extras"}
"""Entries of a primitive that change nothing about its arrays."""

_UNSIGNED = (5121, 5123, 5125)
_COLORS = (5121, 5123, 5126)
"""Types of numbers."""

Numbers = NDArray[np.int64]


def stored(
    header: dict[str, Any], materials: MaterialReader, buffers: Buffers, budget: Budget
) -> tuple[Stored | None, list[int]]:
    """The meshes that can be read so, without names, and their numbers in the document; None if there are none."""
    read = [primitive for mesh in header.get("meshes", []) for primitive in mesh["primitives"]]
    used = {number for primitive in read for number in primitive.get("attributes", {}).values()}
    used |= {primitive["indices"] for primitive in read if "indices" in primitive}
    rows = table(header, buffers, used)
    if rows is None:
        return None, []
    reader = _Faces(rows, materials)
    faces = np.array(
        [row for number, mesh in enumerate(header["meshes"]) for row in reader.of_mesh(number, mesh)], np.int64
    )
    if not len(faces):
        return None, []
    corners = np.where(faces[:, 5] == NONE, rows.counts[faces[:, 1]], rows.counts[faces[:, 5]])
    budget.hold(int(corners.sum()) // 3 * _FACE)
    core, faces = _fit(rows, faces)
    if core is None:
        return None, []
    budget.hold(int(core.vertex_counts().sum()) * _VERTEX)
    numbers, mesh = np.unique(faces[:, 0], return_inverse=True)
    return Stored(core, [], mesh, faces[:, 6], [*reader.surfaces]), numbers.tolist()


def _fit(rows: Table, faces: Numbers) -> tuple[_core.StoredMeshes | None, Numbers]:
    """Leave out the meshes that cannot be used as they are."""
    while len(faces):
        _, mesh = np.unique(faces[:, 0], return_inverse=True)
        core = _core.StoredMeshes(rows.blocks, rows.rows, np.column_stack([mesh, faces[:, 1:]]))
        is_fit = core.fit()
        if is_fit.all():
            return core, faces
        faces = faces[is_fit[mesh]]
    return None, faces


class _Faces:
    """Reads primitives as rows of numbers: mesh, positions, normals, UVs, colours, corners (−1 for none), surface."""

    def __init__(self, rows: Table, materials: MaterialReader) -> None:
        self._materials = materials
        self._counts = rows.counts.tolist()
        corners = rows.allows((1,), _UNSIGNED) & rows.is_tight & (rows.counts % 3 == 0)
        self._corners: list[bool] = corners.tolist()
        self._allowed: dict[str, list[bool]] = {
            "POSITION": rows.allows((3,)).tolist(),
            "NORMAL": rows.allows((3,)).tolist(),
            "COLOR_0": rows.allows((3, 4), _COLORS).tolist(),
        }
        self._uvs: list[bool] = rows.allows((2,)).tolist()
        self._surfaces: dict[tuple[int, bool, bool, bool], int] = {}
        self.surfaces: list[Surface] = []

    def of_mesh(self, number: int, mesh: dict[str, Any]) -> list[tuple[int, ...]]:
        """Rows of a mesh; none if one of its primitives is not plain."""
        found = []
        for primitive in mesh["primitives"]:
            if mode(primitive) in MODES:
                row = self._row(primitive)
                if row is None:
                    return []
                found.append((number, *row))
        return found

    def _row(self, primitive: dict[str, Any]) -> tuple[int, ...] | None:
        if mode(primitive) != TRIANGLES or not primitive.keys() <= _PLAIN:
            return None
        attributes, material = primitive.get("attributes", {}), primitive.get("material", NONE)
        numbers = [attributes.get(name, NONE) for name in self._allowed]
        if type(material) is not int or numbers[0] == NONE:
            return None
        count = -1
        for number, allowed in zip(numbers, self._allowed.values(), strict=True):
            if number == NONE:
                continue
            if not _is_one(number, allowed) or count not in (-1, self._counts[number]):
                return None
            count = self._counts[number]
        positions, normals, colors = numbers
        if "indices" not in primitive:
            corners = NONE
            if count % 3:
                return None
        elif not _is_one(corners := primitive["indices"], self._corners):
            return None
        shown = self._materials.coordinates(material)
        uvs = NONE if shown is None else attributes.get(f"TEXCOORD_{shown.number}", NONE)
        surface = self._surface(material, normals != NONE, uvs != NONE, colors != NONE)
        if not self.surfaces[surface].is_textured:
            uvs = NONE
        elif shown is None or not shown.is_plain or not _is_one(uvs, self._uvs) or self._counts[uvs] != count:
            return None
        return positions, normals, uvs, colors, corners, surface

    def _surface(self, material: int, has_normals: bool, has_uvs: bool, has_colors: bool) -> int:
        key = (material, has_normals, has_uvs, has_colors)
        if key not in self._surfaces:
            self._surfaces[key] = len(self.surfaces)
            materials = self._materials.material(material) if material != NONE else []
            self.surfaces.append(Surface(materials, has_normals, has_uvs, has_colors))
        return self._surfaces[key]


def _is_one(number: Any, allowed: list[bool]) -> bool:
    """Whether a number is that of an accessor that is allowed."""
    return type(number) is int and 0 <= number < len(allowed) and allowed[number]
