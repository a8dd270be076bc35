"""Reads primitives of glTF meshes, with their materials, as shapes."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base.errors import UnusableError
from nearfar._base.glb import entry
from nearfar._scene.budget import Budget
from nearfar._scene.content import Shape
from nearfar._scene.gltf import draco
from nearfar._scene.gltf.buffers import Buffers
from nearfar._scene.gltf.corners import faces, mode
from nearfar._scene.gltf.draco import DRACO, needs_draco
from nearfar._scene.gltf.material_reader import MaterialReader
from nearfar._scene.materials import colors_of

_UV_WIDTH = 2


class Primitives:
    """Reads the primitives of one document, the `header`; `budget` counts the bytes of new arrays."""

    def __init__(self, header: dict[str, Any], buffers: Buffers, materials: MaterialReader, budget: Budget) -> None:
        self._header, self._buffers, self._materials, self._budget = header, buffers, materials, budget
        self._decoded: dict[Any, draco.Decoded] = {}

    def shape(self, primitive: dict[str, Any], *, is_shared: bool) -> Shape:
        """Read a primitive; with `is_shared` only the vertices that it uses."""
        decoded = self._decoded_faces(primitive)
        numbers = primitive.get("attributes", {})
        if "POSITION" not in numbers:
            raise UnusableError("a primitive of its meshes has no POSITION")
        positions = self._buffers.raw(numbers["POSITION"])
        self._check_decoded(primitive, positions)
        count = len(positions)
        used: NDArray[np.int64] | slice = slice(None)
        triangles = self._faces(primitive, count) if decoded is None else decoded
        if is_shared and "indices" in primitive and decoded is None:
            used, triangles = _used(triangles, count)

        def used_rows(number: int) -> NDArray[Any]:
            rows = self._buffers.raw(number)
            return rows[used] if len(rows) == count else rows

        def attribute(name: str, width: int) -> NDArray[Any]:
            return self._attribute(name, width, numbers[name], used_rows(numbers[name]))

        vertices = attribute("POSITION", 3)
        shape = Shape(vertices, triangles)
        if "NORMAL" in numbers and (normals := attribute("NORMAL", 3)).shape == vertices.shape:
            shape.normals = normals
        if "material" in primitive:
            shape.materials = self._materials.material(primitive["material"])
            uv_set = self._materials.coordinates(primitive["material"])
            if uv_set is not None and (name := f"TEXCOORD_{uv_set.number}") in numbers:
                uvs = attribute(name, _UV_WIDTH)
                # v points down in files.
                shape.uvs = np.column_stack([uvs[:, 0], 1 - uvs[:, 1]]) if uv_set.is_plain else uv_set.upwards(uvs)
        if "COLOR_0" in numbers:
            # COLOR_0 is linear (glTF 2.0, 3.7.2.1).
            shape.colors = colors_of(used_rows(numbers["COLOR_0"]), len(vertices), linear=True)
        arrays = (shape.vertices, shape.faces, shape.normals, shape.uvs, shape.colors)
        self._budget.hold(sum(rows.nbytes for rows in arrays if rows is not None))
        return shape

    def _attribute(self, name: str, width: int, number: int, rows: NDArray[Any]) -> NDArray[Any]:
        """Rows of an attribute, which may be integers, normalised or not (KHR_mesh_quantization)."""
        if rows.shape[1] != width:
            raise UnusableError(f"expected {width} numbers in each row of {name}, got {rows.shape[1]}")
        rows = self._buffers.fractions(number, rows)
        return rows.astype(np.float32) if width == _UV_WIDTH and rows.dtype.kind != "f" else rows

    def _faces(self, primitive: dict[str, Any], vertex_count: int) -> NDArray[Any]:
        is_indexed = "indices" in primitive
        corners = self._buffers.raw(primitive["indices"]).reshape(-1) if is_indexed else np.arange(vertex_count)
        return faces(mode(primitive), corners, is_indexed=is_indexed)

    def _decoded_faces(self, primitive: dict[str, Any]) -> NDArray[Any] | None:
        """Faces decoded by Draco, together with their vertices; None for uncompressed primitives."""
        if not needs_draco(primitive, self._header):
            return None
        view = primitive["extensions"][DRACO]["bufferView"]
        key = (view, *sorted(primitive["attributes"].items()))
        if key not in self._decoded:
            self._decoded[key] = draco.decoded(self._header, primitive, self._buffers.blob(view), self._budget)
        for number, rows in self._decoded[key].rows.items():
            self._buffers.replace(number, rows)
        return self._decoded[key].faces

    def _check_decoded(self, primitive: dict[str, Any], vertices: NDArray[Any]) -> None:
        """Reject vertices that are all zero because an extension was not decoded."""
        accessor = entry(self._header, "accessors", primitive["attributes"]["POSITION"])
        names = list(primitive.get("extensions", {}))
        if names and "bufferView" not in accessor and "sparse" not in accessor and not np.any(vertices):
            raise UnusableError(f"its extension {names[0]} was not decoded: save the model without it")


def _used(faces: NDArray[Any], count: int) -> tuple[NDArray[np.int64] | slice, NDArray[Any]]:
    """Indices of the vertices in use, and the faces renumbered to them; all vertices if faces are damaged."""
    if not faces.size or int(faces.min()) < 0 or int(faces.max()) >= count:
        return slice(None), faces
    used, indices = np.unique(faces, return_inverse=True)
    return (slice(None), faces) if len(used) == count else (used.astype(np.int64), indices.reshape(-1, 3))
