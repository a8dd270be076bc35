"""Reads glTF and GLB with trimesh's reader, but not its scene graph, which takes a second for ten thousand nodes."""

from __future__ import annotations

import io
import json
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import glb
from nearfar._base.errors import UnusableError
from nearfar._scene import gltf_extensions, gltf_nodes
from nearfar._scene.gltf_buffers import COMPONENTS, WIDTHS, Buffers, name_files
from nearfar._scene.materials import Described, Materials, colors_of
from nearfar._scene.report import count
from nearfar._scene.source import Shape, Source

_TRIANGLES, _STRIP = 4, 5
_READ_ATTRIBUTES = ("POSITION", "NORMAL", "TEXCOORD_0", "COLOR_0")
_PLURALS = {"set of tangents": "sets of tangents"}
_READ_MODES = (0, 1, _TRIANGLES, _STRIP)
"""Modes of primitives that trimesh reads (points, lines, triangles, strips); it skips the others."""

_UNBACKED = 64 << 20
"""Greatest size in bytes of accessors without data in a small file; the reader fills them with zeros."""

_EXPANSION = 200
"""Greatest size of accessors without data in a large file, in file sizes; Draco compresses less than that."""


def read(label: str, data: bytes, kind: str, resolver: Any, materials: Materials) -> Source:
    """Read a GLB or the JSON of a glTF; the resolver loads its buffers and images."""
    from trimesh.exchange import gltf

    header, end = glb.header(data) if kind == "glb" else (glb.json_object(data), 0)
    notes = _notes(header)
    buffers = Buffers(header, glb.binary(data, end) if kind == "glb" else b"", resolver)
    gltf_nodes.check_trees(header)
    skipped = {n for n, mesh in enumerate(header.get("meshes", [])) if not any(map(_is_read, mesh["primitives"]))}
    changes = [
        gltf_nodes.free_nodes(header, skipped),
        gltf_extensions.choose_images(header),
        name_files(header, resolver),
    ]
    if any(changes):
        data = glb.with_document(data, end, header) if kind == "glb" else json.dumps(header).encode()
    _check_sizes(header, len(data))
    gltf_extensions.check(header, has_binary=kind == "glb" and len(data) > end)
    reader = gltf.load_glb if kind == "glb" else gltf.load_gltf
    parts = reader(file_obj=io.BytesIO(data), resolver=resolver)
    primitives = [p for mesh in header.get("meshes", []) for p in mesh["primitives"] if _is_read(p)]
    shapes = {
        name: _shape(arrays, primitive, header, buffers, materials)
        for (name, arrays), primitive in zip(parts["geometry"].items(), primitives, strict=True)
        if "faces" in arrays
    }
    return Source(label, shapes, gltf_nodes.placed(parts, header, shapes), notes)


def _check_sizes(header: dict[str, Any], size: int) -> None:
    """Refuse files whose accessors without data claim implausibly many bytes."""
    claimed = 0
    for accessor in header.get("accessors", []):
        if "bufferView" not in accessor:
            item = np.dtype(COMPONENTS[accessor["componentType"]]).itemsize * WIDTHS[accessor["type"]]
            claimed += int(accessor["count"]) * item
    if claimed > max(_UNBACKED, _EXPANSION * size):
        raise UnusableError(f"its accessors claim {claimed:,} bytes without data")


def _is_read(primitive: dict[str, Any]) -> bool:
    """Whether trimesh reads the primitive."""
    return _mode(primitive) in _READ_MODES


def _mode(primitive: dict[str, Any]) -> Any:
    return primitive.get("mode", _TRIANGLES)


def _shape(
    arrays: dict[str, Any], primitive: dict[str, Any], header: dict[str, Any], buffers: Buffers, materials: Materials
) -> Shape:
    special = {
        name: buffers.array(number)
        for name, number in primitive["attributes"].items()
        if name in _READ_ATTRIBUTES and buffers.misread(name, number)
    }
    vertices = special.get("POSITION", arrays["vertices"])
    _check_decoded(primitive, header, vertices)
    visual = arrays.get("visual")
    colors = arrays.get("vertex_colors")
    shape = Shape(vertices, arrays["faces"])
    normals = special.get("NORMAL", arrays.get("vertex_normals"))
    if normals is not None and np.shape(normals) == np.shape(vertices):
        shape.normals = np.asarray(normals)
    if visual is not None:
        described = header["materials"][primitive["material"]]
        shape.materials = materials.of(visual.material, described=Described(described, buffers.texture))
        shape.uvs = _upwards(special["TEXCOORD_0"]) if "TEXCOORD_0" in special else visual.uv
        colors = visual.vertex_attributes.get("color", None)
    colors = special.get("COLOR_0", colors)
    if colors is not None:
        # COLOR_0 is linear (glTF 2.0, 3.7.2.1).
        shape.colors = colors_of(np.asarray(colors), len(vertices), linear=True)
    return shape


def _upwards(uvs: NDArray[Any]) -> NDArray[Any]:
    """Texture coordinates whose v points up; those of files point down."""
    return np.column_stack([uvs[:, 0], 1 - uvs[:, 1]])


def _check_decoded(primitive: dict[str, Any], header: dict[str, Any], vertices: NDArray[Any]) -> None:
    """Refuse the zeros that trimesh leaves where an extension was not decoded."""
    accessors = [_accessor(primitive, "POSITION", header)]
    if "indices" in primitive:
        accessors.append(header["accessors"][primitive["indices"]])
    if any("sparse" in accessor for accessor in accessors[1:]):
        raise UnusableError("its faces are stored as sparse accessors, which is not read: save them in full")
    names = list(primitive.get("extensions", {}))
    is_missing = "bufferView" not in accessors[0] and "sparse" not in accessors[0]
    if names and is_missing and not np.any(vertices):
        raise UnusableError(f"its extension {names[0]} was not decoded: save the model without it")


def _accessor(primitive: dict[str, Any], attribute: str, header: dict[str, Any]) -> dict[str, Any]:
    number = primitive.get("attributes", {}).get(attribute)
    return {} if number is None else header["accessors"][number]


def _notes(header: dict[str, Any]) -> list[str]:
    """Notes on the features of a glTF file that are ignored."""
    primitives = [primitive for mesh in header.get("meshes", []) for primitive in mesh["primitives"]]
    ignored = {name: len(header.get(f"{name}s", [])) for name in ("animation", "skin", "camera")}
    ignored["non-triangle primitive"] = sum(_mode(p) not in (_TRIANGLES, _STRIP) for p in primitives)
    ignored["morphed primitive"] = sum("targets" in p for p in primitives)
    materials = json.dumps(header.get("materials", []))
    ignored["texture transform"] = materials.count('"KHR_texture_transform"')
    ignored["second texture coordinate"] = materials.count('"texCoord": 1')
    ignored["set of tangents"] = sum("TANGENT" in p.get("attributes", {}) for p in primitives)
    notes = [
        f"{count(number, feature, _PLURALS.get(feature, ''))} ignored" for feature, number in ignored.items() if number
    ]
    return notes + gltf_extensions.ignored(header)
