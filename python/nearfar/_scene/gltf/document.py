"""Reads glTF and GLB, and decides which extensions are required, used or ignored."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check, glb
from nearfar._base.errors import UnusableError
from nearfar._base.glb import entry
from nearfar._scene.budget import Budget
from nearfar._scene.content import Content, Shape
from nearfar._scene.coordinates import TRANSFORM
from nearfar._scene.gltf import draco, nodes, stored
from nearfar._scene.gltf.buffers import IMAGE_EXTENSIONS, MESHOPT, Buffers, name_files
from nearfar._scene.gltf.corners import MODES, OTHERS, faces, mode
from nearfar._scene.gltf.ktx2 import BASISU
from nearfar._scene.gltf.material_reader import MaterialReader
from nearfar._scene.materials import Materials, colors_of
from nearfar._scene.names import distinct
from nearfar._scene.report import count
from nearfar._scene.undrawn import EXTENSIONS

_PLURALS = {"set of tangents": "sets of tangents", "primitive of an unknown mode": "primitives of unknown modes"}

_UV_WIDTH = 2

_READ = {draco.DRACO, "KHR_mesh_quantization", nodes.INSTANCING, *MESHOPT}
"""Supported extensions of shapes."""

_REMEDIES = {"MSFT_texture_dds": "which is not read: save its textures as PNG or JPEG"}

_DISPENSABLE = {
    *(TRANSFORM, "KHR_lights_punctual", "EXT_lights_image_based", "KHR_materials_variants", "KHR_animation_pointer"),
    *("KHR_xmp", "KHR_xmp_json_ld", "EXT_mesh_features", "EXT_instance_features", "EXT_structural_metadata"),
    *("MSFT_lod", "CESIUM_primitive_outline", "CESIUM_RTC"),
}
"""Extensions that may be ignored without changing a file's shapes and base colours."""

_SILENT = {*_READ, BASISU, TRANSFORM, *EXTENSIONS, *IMAGE_EXTENSIONS, *_REMEDIES}
"""Extensions not listed as ignored: they are supported, rejected, or noted where they are used."""


def read(
    label: str, data: bytes, kind: str, resolver: Any, materials: Materials, budget: Budget, *, stores: bool = True
) -> Content:
    """Read a GLB or the JSON of a glTF; the resolver loads its buffers and images.

    With `stores`, meshes that the core can read directly stay in the file's bytes.
    """
    header, end = glb.header(data) if kind == "glb" else (glb.json_object(data), 0)
    version = str(header.get("asset", {}).get("version", "2.0"))
    if version.split(".")[0] != "2":
        raise UnusableError(f"it is glTF {version}, and only glTF 2 is read")
    notes = _notes(header)
    nodes.check_trees(header)
    _choose_images(header)
    _check_extensions(header)
    name_files(header, resolver)
    buffers = Buffers(header, glb.binary(data, end) if kind == "glb" else b"", resolver, budget)
    reader = MaterialReader(header, buffers, materials, budget)
    reader.decode(_materials(header))
    primitives = _Primitives(header, buffers, reader, budget)
    stored_meshes, numbers = stored.stored(header, reader, buffers, budget) if stores else (None, [])
    is_stored = set(numbers)
    names = _names(header, is_stored)
    shapes = _shapes(header, primitives, {number: names[number] for number in names if number not in is_stored})
    if stored_meshes is not None:
        stored_meshes = replace(stored_meshes, names=[names[number][0] for number in numbers])
    placed = nodes.place_nodes(header, names, nodes.instance_transforms(header, buffers, budget))
    return Content(label, shapes, placed, notes, used=_features(header), stored=stored_meshes)


def _names(header: dict[str, Any], stored_numbers: set[int]) -> dict[int, list[str]]:
    """Shape names for each mesh: one if the mesh is stored, else one for each primitive."""
    rows = [
        (number, str(mesh.get("name") or "mesh"))
        for number, mesh in enumerate(header.get("meshes", []))
        for _ in ([mesh] if number in stored_numbers else _primitives(mesh))
    ]
    names_by_mesh: dict[int, list[str]] = {}
    for (number, _), name in zip(rows, distinct([name for _, name in rows]), strict=True):
        names_by_mesh.setdefault(number, []).append(name)
    return names_by_mesh


def _shapes(header: dict[str, Any], primitives: _Primitives, names: dict[int, list[str]]) -> dict[str, Shape]:
    """Shapes of some meshes by name."""
    uses = Counter(_positions(primitive) for mesh in header.get("meshes", []) for primitive in _primitives(mesh))
    return {
        name: primitives.shape(primitive, is_shared=uses[_positions(primitive)] > 1)
        for number, mesh_names in names.items()
        for name, primitive in zip(mesh_names, _primitives(header["meshes"][number]), strict=True)
    }


def _primitives(mesh: dict[str, Any]) -> list[dict[str, Any]]:
    """Primitives of a mesh whose mode is supported."""
    return [primitive for primitive in mesh["primitives"] if mode(primitive) in MODES]


def _materials(header: dict[str, Any]) -> list[int]:
    """Unique indices of the materials in use; invalid indices are left out."""
    numbers = (primitive.get("material") for mesh in header.get("meshes", []) for primitive in _primitives(mesh))
    valid = range(len(header.get("materials", [])))
    return sorted({number for number in numbers if type(number) is int and number in valid})


def _positions(primitive: dict[str, Any]) -> Any:
    return primitive.get("attributes", {}).get("POSITION")


def _notes(header: dict[str, Any]) -> list[str]:
    """Notes on ignored features of a glTF file."""
    primitives = [primitive for mesh in header.get("meshes", []) for primitive in mesh["primitives"]]
    ignored = Counter({name: len(header.get(f"{name}s", [])) for name in ("animation", "skin", "camera")})
    ignored.update(OTHERS.get(mode(p), "primitive of an unknown mode") for p in primitives if mode(p) not in MODES)
    ignored["morphed primitive"] = sum("targets" in p for p in primitives)
    ignored["set of tangents"] = sum("TANGENT" in p.get("attributes", {}) for p in primitives)
    notes = [
        f"{count(number, feature, _PLURALS.get(feature, ''))} ignored" for feature, number in ignored.items() if number
    ]
    return notes + _ignored_extensions(header)


def _features(header: dict[str, Any]) -> list[str]:
    """The format, counts of supported parts, and the extensions, one phrase each."""
    made_by = header.get("asset", {}).get("generator")
    placing = sum("mesh" in node for node in header.get("nodes", []))
    primitives = sum(mode(primitive) in MODES for mesh in header.get("meshes", []) for primitive in mesh["primitives"])
    return [
        "glTF 2.0" + (f", made by {check.shortened(str(made_by))}" if made_by else ""),
        f"{count(placing, 'node')} with meshes",
        f"{count(primitives, 'primitive')} of triangles",
        *(count(len(header[f"{part}s"]), part) for part in ("material", "texture", "image") if header.get(f"{part}s")),
        *_used_extensions(header),
    ]


def _check_extensions(header: dict[str, Any]) -> None:
    """Reject a document with required extensions that are not supported."""
    for name in header.get("extensionsRequired", []):
        if name in _REMEDIES:
            raise UnusableError(f"it needs the extension {name}, {_REMEDIES[name]}")
        if name in IMAGE_EXTENSIONS:
            _check_image_support(name)
        elif name not in _DISPENSABLE | EXTENSIONS | _READ | {BASISU}:
            raise UnusableError(f"it needs the extension {name}, which is not read: save the model without it")
    primitives = (primitive for mesh in header.get("meshes", []) for primitive in mesh["primitives"])
    if any(draco.needs_draco(primitive, header) for primitive in primitives):
        draco.prepare()


def _check_image_support(name: str) -> None:
    from PIL import features

    if not features.check(IMAGE_EXTENSIONS[name]):
        condition = f"which the Python package Pillow decodes if it was built with {IMAGE_EXTENSIONS[name]}"
        raise UnusableError(f"it needs the extension {name}, {condition}: save its textures as PNG or JPEG")


def _choose_images(header: dict[str, Any]) -> None:
    """Make an extension's image the plain source of textures without one."""
    for texture in header.get("textures", []):
        if "source" not in texture:
            for name in (*IMAGE_EXTENSIONS, BASISU):
                if name in texture.get("extensions", {}):
                    texture["source"] = texture["extensions"][name]["source"]


def _ignored_extensions(header: dict[str, Any]) -> list[str]:
    """Notes on ignored extensions."""
    return [f"extension {name} ignored" for name in _extension_names(header) if name not in _SILENT]


def _used_extensions(header: dict[str, Any]) -> list[str]:
    """Supported extensions, for the list of features that a scene uses."""
    supported = {*_READ, *IMAGE_EXTENSIONS, BASISU, TRANSFORM}
    return [f"extension {name}" for name in _extension_names(header) if name in supported]


def _extension_names(header: dict[str, Any]) -> list[str]:
    return [*dict.fromkeys([*header.get("extensionsUsed", []), *header.get("extensionsRequired", [])])]


class _Primitives:
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
        vertex_count = len(positions)
        used: NDArray[np.int64] | slice = slice(None)
        triangles = self._faces(primitive, vertex_count) if decoded is None else decoded
        if is_shared and "indices" in primitive and decoded is None:
            used, triangles = _used_vertices(triangles, vertex_count)

        def used_rows(number: int) -> NDArray[Any]:
            rows = self._buffers.raw(number)
            return rows[used] if len(rows) == vertex_count else rows

        def attribute(name: str, width: int) -> NDArray[Any]:
            """Rows of an attribute, which may be integers, normalised or not (KHR_mesh_quantization)."""
            rows = used_rows(numbers[name])
            if rows.shape[1] != width:
                raise UnusableError(f"expected {width} numbers in each row of {name}, got {rows.shape[1]}")
            rows = self._buffers.fractions(numbers[name], rows)
            return rows.astype(np.float32) if width == _UV_WIDTH and rows.dtype.kind != "f" else rows

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


def _used_vertices(triangles: NDArray[Any], vertex_count: int) -> tuple[NDArray[np.int64] | slice, NDArray[Any]]:
    """Indices of the vertices in use, and the triangles renumbered to them; all vertices if indices are damaged."""
    if not triangles.size or int(triangles.min()) < 0 or int(triangles.max()) >= vertex_count:
        return slice(None), triangles
    used, indices = np.unique(triangles, return_inverse=True)
    return (slice(None), triangles) if len(used) == vertex_count else (used.astype(np.int64), indices.reshape(-1, 3))
