"""Reads the primitives of glTF meshes: faces and attributes, changed by morph targets, skins and tints."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check
from nearfar._base.errors import UnusableError
from nearfar._base.glb import entry
from nearfar._scene.budget import Budget
from nearfar._scene.content import Shape
from nearfar._scene.gltf import draco, skins
from nearfar._scene.gltf.buffers import Buffers
from nearfar._scene.gltf.corners import faces, mode
from nearfar._scene.gltf.material_reader import MaterialReader
from nearfar._scene.gltf.variants import WHITE, Variant, is_jointed
from nearfar._scene.materials import colors_of
from nearfar._scene.report import count, listing

_UV_WIDTH = 2

_Rows = Callable[[str, int, int], NDArray[Any]]
"""Function that returns the rows of an attribute by name, accessor index and width."""


class Primitives:
    """Reads the primitives of one document, the `header`; `budget` counts the bytes of new arrays."""

    def __init__(self, header: dict[str, Any], buffers: Buffers, materials: MaterialReader, budget: Budget) -> None:
        self._header, self._buffers, self._materials, self._budget = header, buffers, materials, budget
        self._draco_meshes: dict[Any, draco.DracoMesh] = {}
        self._skins = skins.Skins(header, buffers, budget)
        self._incomplete: list[str] = []

    @property
    def notes(self) -> list[str]:
        """Note on attributes that lack rows; glTF requires one for each vertex."""
        if not self._incomplete:
            return []
        attributes = count(len(self._incomplete), "attribute")
        return [f"{attributes} without a row for each vertex ignored: {listing(self._incomplete)}"]

    def shape(self, name: str, primitive: dict[str, Any], variant: Variant, *, is_shared: bool) -> Shape:
        """Read a primitive as drawn by a variant of its mesh; `is_shared` limits it to the vertices in use.

        Notes use the mesh's `name`.
        """
        draco_faces = self._decoded_faces(primitive)
        numbers = primitive.get("attributes", {})
        positions = self._buffers.raw(numbers["POSITION"])
        self._check_decoded(primitive, positions)
        vertex_count = len(positions)
        vertex_rows: NDArray[np.int64] | slice = slice(None)
        triangles = self._faces(primitive, vertex_count) if draco_faces is None else draco_faces
        if is_shared and "indices" in primitive and draco_faces is None:
            vertex_rows, triangles = _used_vertices(triangles, vertex_count)

        def is_complete(attribute: str) -> bool:
            """Whether the primitive has an attribute with a row for each vertex."""
            if attribute not in numbers:
                return False
            rows = len(self._buffers.raw(numbers[attribute]))
            if rows != vertex_count:
                self._incomplete.append(f"{attribute} of mesh {check.shortened(name)} ({rows:,} for {vertex_count:,})")
            return rows == vertex_count

        def used_rows(number: int) -> NDArray[Any]:
            rows = self._buffers.raw(number)
            return rows[vertex_rows] if len(rows) == vertex_count else rows

        def stored_rows(name: str, number: int, width: int) -> NDArray[Any]:
            """Rows of an attribute, which may be integers, normalised or not (KHR_mesh_quantization)."""
            rows = used_rows(number)
            if rows.shape[1] != width:
                raise UnusableError(f"expected {width} numbers in each row of {name}, got {rows.shape[1]}")
            return self._buffers.fractions(number, rows)

        targets = [target for target in zip(variant.weights, primitive.get("targets", []), strict=False) if target[0]]

        def attribute(name: str, width: int) -> NDArray[Any]:
            """Rows of an attribute with the weighted changes of the morph targets."""
            rows = stored_rows(name, numbers[name], width)
            for weight, target in targets:
                if name in target:
                    change = stored_rows(f"{name} of a morph target", target[name], width)
                    if len(change) != len(rows):
                        raise UnusableError(f"expected {len(rows)} rows of {name} of a morph target, got {len(change)}")
                    self._budget.count_arrays(8 * rows.size)
                    rows = rows.astype(np.float64) + weight * change
            return rows

        vertices = attribute("POSITION", 3)
        shape = Shape(vertices, triangles)
        if is_complete("NORMAL"):
            shape.normals = attribute("NORMAL", 3)
        if variant.skin is not None and is_jointed(primitive):
            self._pose(shape, variant.skin, numbers, stored_rows)
        if "material" in primitive:
            shape.materials = self._materials.material(primitive["material"])
            uv_set = self._materials.coordinates(primitive["material"])
            if uv_set is not None and is_complete(uv_name := f"TEXCOORD_{uv_set.number}"):
                shape.uvs = uv_set.to_scene(attribute(uv_name, _UV_WIDTH).astype(np.float32))
        has_colors = is_complete("COLOR_0")
        if has_colors or variant.tint != WHITE:
            # COLOR_0 is linear (glTF 2.0, 3.7.2.1).
            colors = used_rows(numbers["COLOR_0"]) if has_colors else np.ones((len(vertices), 4), np.float32)
            if colors.shape[1] not in (3, 4):
                raise UnusableError(f"expected 3 or 4 numbers in each row of COLOR_0, got {colors.shape[1]}")
            if has_colors and any("COLOR_0" in target for _, target in targets):
                colors = np.clip(attribute("COLOR_0", colors.shape[1]), 0, 1)
            colors = colors if variant.tint == WHITE else _apply_tint(colors, variant.tint)
            shape.colors = colors_of(colors, len(vertices), linear=True)
        arrays = (shape.vertices, shape.faces, shape.normals, shape.uvs, shape.colors)
        self._budget.count_arrays(sum(rows.nbytes for rows in arrays if rows is not None))
        return shape

    def _pose(self, shape: Shape, skin: int, numbers: dict[str, int], stored_rows: _Rows) -> None:
        """Place a shape's vertices and normals by the joints at rest."""
        matrices = self._skins.vertex_matrices(skin, numbers, stored_rows)
        if len(matrices) != len(shape.vertices):
            raise UnusableError(f"expected joints of {len(shape.vertices)} vertices, got {len(matrices)}")
        shape.vertices = skins.transform_vertices(matrices, shape.vertices)
        if shape.normals is not None:
            shape.normals = skins.transform_normals(matrices, shape.normals)

    def _faces(self, primitive: dict[str, Any], vertex_count: int) -> NDArray[Any]:
        is_indexed = "indices" in primitive
        corners = self._buffers.raw(primitive["indices"]).reshape(-1) if is_indexed else np.arange(vertex_count)
        return faces(mode(primitive), corners, is_indexed=is_indexed)

    def _decoded_faces(self, primitive: dict[str, Any]) -> NDArray[Any] | None:
        """Faces decoded by Draco, together with their vertices; None for uncompressed primitives."""
        if not draco.needs_draco(primitive, self._header):
            return None
        view = primitive["extensions"][draco.DRACO]["bufferView"]
        key = (view, *sorted(primitive["attributes"].items()))
        if key not in self._draco_meshes:
            self._draco_meshes[key] = draco.decode(self._header, primitive, self._buffers.blob(view), self._budget)
        for number, rows in self._draco_meshes[key].rows.items():
            self._buffers.replace(number, rows)
        return self._draco_meshes[key].faces

    def _check_decoded(self, primitive: dict[str, Any], vertices: NDArray[Any]) -> None:
        """Reject vertices that are all zero because nearfar does not decode an extension."""
        accessor = entry(self._header, "accessors", primitive["attributes"]["POSITION"])
        names = list(primitive.get("extensions", {}))
        if names and "bufferView" not in accessor and "sparse" not in accessor and not np.any(vertices):
            raise UnusableError(f"its extension {names[0]} was not decoded: save the model without it")


def _apply_tint(colors: NDArray[Any], tint: Sequence[float]) -> NDArray[np.float64]:
    """Multiply linear vertex colours (V, 3 or 4), floats or integers, by linear RGBA; the result is in 0..1."""
    full = 1.0 if colors.dtype.kind == "f" else float(np.iinfo(colors.dtype).max)
    rgba = np.ones((len(colors), 4))
    rgba[:, : colors.shape[1]] = colors / full
    rgba *= tint
    return rgba


def _used_vertices(triangles: NDArray[Any], vertex_count: int) -> tuple[NDArray[np.int64] | slice, NDArray[Any]]:
    """Indices of the vertices in use, and the triangles renumbered to them; all vertices if indices are damaged."""
    if not triangles.size or int(triangles.min()) < 0 or int(triangles.max()) >= vertex_count:
        return slice(None), triangles
    used, indices = np.unique(triangles, return_inverse=True)
    return (slice(None), triangles) if len(used) == vertex_count else (used.astype(np.int64), indices.reshape(-1, 3))
