"""Reads glTF and GLB with trimesh's reader, but not its scene graph, which takes a second for ten thousand nodes."""

from __future__ import annotations

import io
import json
from importlib.util import find_spec
from typing import Any

import numpy as np

from nearfar._base import glb
from nearfar._scene.materials import Materials, colors_of
from nearfar._scene.report import count
from nearfar._scene.source import Node, Shape, Source, UnusableError, world_transforms

_TRIANGLES, _STRIP = 4, 5
_FLOAT = 5126
_READ_MODES = (0, 1, _TRIANGLES, _STRIP)
"""Modes of primitives that trimesh reads (points, lines, triangles, strips); it skips the others."""

_UNBACKED = 64 << 20
"""Greatest size in bytes of accessors without data in a small file; the reader fills them with zeros."""

_EXPANSION = 200
"""Greatest size of accessors without data in a large file, in file sizes; Draco compresses less than that."""

_UNREAD = ("EXT_meshopt_compression", "KHR_meshopt_compression")
"""Extensions that compress whole meshes and that trimesh does not read."""

_COMPONENT_BYTES = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4}
_COMPONENTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}


def read(label: str, data: bytes, kind: str, resolver: Any) -> Source:
    """Read a GLB or the JSON of a glTF; the resolver loads its buffers and images."""
    from trimesh.exchange import gltf

    header, end = glb.header(data) if kind == "glb" else (glb.json_object(data), 0)
    notes = _notes(header)
    if _free_nodes(header):
        data = glb.with_document(data, end, header) if kind == "glb" else json.dumps(header).encode()
    _check_sizes(header, len(data))
    _check_extensions(header)
    reader = gltf.load_glb if kind == "glb" else gltf.load_gltf
    parts = reader(file_obj=io.BytesIO(data), resolver=resolver)
    primitives = [p for mesh in header.get("meshes", []) for p in mesh["primitives"] if _mode(p) in _READ_MODES]
    materials = Materials()
    shapes = {
        name: _shape(arrays, primitive, header, materials)
        for (name, arrays), primitive in zip(parts["geometry"].items(), primitives, strict=True)
        if "faces" in arrays
    }
    return Source(label, shapes, _nodes(parts, header, shapes), notes)


def _free_nodes(header: dict[str, Any]) -> bool:
    """Remove cameras and unread meshes from nodes; returns whether there were any.

    Trimesh drops a node with a camera, or with a mesh of which it skips all primitives, and loses the transforms of its
    children.
    """
    changed = False
    meshes = enumerate(header.get("meshes", []))
    skipped = {number for number, mesh in meshes if all(_mode(p) not in _READ_MODES for p in mesh["primitives"])}
    for node in header.get("nodes", []):
        if "camera" in node or ("mesh" in node and node["mesh"] in skipped):
            changed = True
            node.pop("camera", None)
            if node.get("mesh") in skipped:
                del node["mesh"]
    return changed


def _check_sizes(header: dict[str, Any], size: int) -> None:
    """Refuse files whose accessors without data claim implausibly many bytes."""
    claimed = 0
    for accessor in header.get("accessors", []):
        if "bufferView" not in accessor:
            item = _COMPONENT_BYTES[accessor["componentType"]] * _COMPONENTS[accessor["type"]]
            claimed += int(accessor["count"]) * item
    if claimed > max(_UNBACKED, _EXPANSION * size):
        raise UnusableError(f"its accessors claim {claimed:,} bytes without data")


def _check_extensions(header: dict[str, Any]) -> None:
    """Refuse compressed geometry that trimesh would read as zeros."""
    for name in header.get("extensionsRequired", []):
        if name in _UNREAD:
            raise UnusableError(f"it needs the extension {name}, which is not read: save it uncompressed")
        if name == "KHR_draco_mesh_compression" and not find_spec("DracoPy"):
            raise ModuleNotFoundError(name="DracoPy")


def _mode(primitive: dict[str, Any]) -> Any:
    return primitive.get("mode", _TRIANGLES)


def _shape(arrays: dict[str, Any], primitive: dict[str, Any], header: dict[str, Any], materials: Materials) -> Shape:
    vertices = arrays["vertices"]
    visual = arrays.get("visual")
    colors = arrays.get("vertex_colors")
    shape = Shape(vertices, arrays["faces"])
    if _accessor(primitive, "POSITION", header).get("normalized"):
        raise UnusableError("its positions are normalised integers, which are not read: save them as floats")
    normals = arrays.get("vertex_normals")
    if normals is not None and np.shape(normals) == np.shape(vertices):
        shape.normals = np.asarray(normals)
    if visual is not None:
        described = header["materials"][primitive["material"]]
        textured = "baseColorTexture" in described.get("pbrMetallicRoughness", {})
        shape.materials = materials.of(visual.material, factor=_factor(described), textured=textured)
        # Trimesh computes 1 − v before it scales whole numbers to 0..1, so only floats are right.
        shape.uvs = visual.uv if _component(primitive, "TEXCOORD_0", header) == _FLOAT else None
        colors = visual.vertex_attributes.get("color", None)
    if colors is not None:
        # COLOR_0 is linear (glTF 2.0, 3.7.2.1).
        shape.colors = colors_of(np.asarray(colors), len(vertices), linear=True)
    return shape


def _accessor(primitive: dict[str, Any], attribute: str, header: dict[str, Any]) -> dict[str, Any]:
    number = primitive.get("attributes", {}).get(attribute)
    return {} if number is None else header["accessors"][number]


def _component(primitive: dict[str, Any], attribute: str, header: dict[str, Any]) -> int:
    """Component type of an attribute; float for an absent one."""
    kind: int = _accessor(primitive, attribute, header).get("componentType", _FLOAT)
    return kind


def _factor(material: dict[str, Any]) -> tuple[float, float, float, float] | None:
    """Base colour factor in full precision; None means trimesh's value, which may come from an extension."""
    factor = material.get("pbrMetallicRoughness", {}).get("baseColorFactor")
    if factor is None or material.get("extensions"):
        return None
    red, green, blue, alpha = np.clip(np.nan_to_num(np.array(factor, np.float64)), 0, 1).tolist()
    return red, green, blue, alpha


def _nodes(parts: dict[str, Any], header: dict[str, Any], shapes: dict[str, Shape]) -> list[Node]:
    """Placed shapes in the file's order; trimesh's traversal reverses it."""
    named = {str(node.get("name", index)) for index, node in enumerate(header.get("nodes", []))}
    edges = [(edge["frame_from"], edge["frame_to"], edge.get("matrix")) for edge in parts["graph"]]
    world = world_transforms(edges, parts["base_frame"])
    nodes = []
    for edge in reversed(parts["graph"]):
        if edge.get("geometry") in shapes:
            frame, above = edge["frame_to"], edge["frame_from"]
            # Trimesh gives each primitive of a node its own frame, named after the node with a random suffix.
            is_primitive = frame not in named and frame.startswith(f"{above}_") and len(frame) == len(above) + 7
            nodes.append(Node(above if is_primitive else frame, world[frame], edge["geometry"]))
    return nodes


def _notes(header: dict[str, Any]) -> list[str]:
    """Notes on the features of a glTF file that are ignored."""
    primitives = [primitive for mesh in header.get("meshes", []) for primitive in mesh["primitives"]]
    ignored = {name: len(header.get(f"{name}s", [])) for name in ("animation", "skin", "camera")}
    ignored["non-triangle primitive"] = sum(_mode(p) not in (_TRIANGLES, _STRIP) for p in primitives)
    ignored["morphed primitive"] = sum("targets" in p for p in primitives)
    materials = json.dumps(header.get("materials", []))
    ignored["texture transform"] = materials.count('"KHR_texture_transform"')
    ignored["second texture coordinate"] = materials.count('"texCoord": 1')
    ignored["quantised set of texture coordinates"] = sum(
        _component(p, "TEXCOORD_0", header) != _FLOAT for p in primitives
    )
    return [f"{count(number, feature)} ignored" for feature, number in ignored.items() if number]
