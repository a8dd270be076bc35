"""Reads glTF and GLB; trimesh reads their materials and what Draco compresses."""

from __future__ import annotations

from collections import Counter
from typing import Any

from nearfar._base import glb
from nearfar._base.errors import UnusableError
from nearfar._scene.budget import Budget
from nearfar._scene.content import Content, Shape
from nearfar._scene.gltf import extensions, instances, inventory, nodes
from nearfar._scene.gltf.buffers import Buffers, name_files
from nearfar._scene.gltf.corners import MODES, OTHERS, mode
from nearfar._scene.gltf.primitives import Primitives
from nearfar._scene.materials import Materials
from nearfar._scene.names import distinct
from nearfar._scene.report import count

_PLURALS = {
    "set of tangents": "sets of tangents",
    "primitive of an unknown mode": "primitives of unknown modes",
}


def read(label: str, data: bytes, kind: str, resolver: Any, materials: Materials, budget: Budget) -> Content:
    """Read a GLB or the JSON of a glTF; the resolver loads its buffers and images."""
    header, end = glb.header(data) if kind == "glb" else (glb.json_object(data), 0)
    version = str(header.get("asset", {}).get("version", "2.0"))
    if version.split(".")[0] != "2":
        raise UnusableError(f"it is glTF {version}, and only glTF 2 is read")
    notes = _notes(header)
    nodes.check_trees(header)
    extensions.choose_images(header)
    extensions.check(header)
    name_files(header, resolver)
    buffers = Buffers(header, glb.binary(data, end) if kind == "glb" else b"", resolver, budget)
    shapes, names = _shapes(header, Primitives(header, buffers, resolver, materials, budget))
    placed = nodes.placed(header, names, instances.transforms(header, buffers, budget))
    return Content(label, shapes, placed, notes, used=inventory.used(header))


def _shapes(header: dict[str, Any], primitives: Primitives) -> tuple[dict[str, Shape], dict[int, list[str]]]:
    """The shapes of all meshes by names, and the names of each mesh's shapes."""
    read = [
        (number, mesh.get("name") or "mesh", primitive)
        for number, mesh in enumerate(header.get("meshes", []))
        for primitive in mesh["primitives"]
        if mode(primitive) in MODES
    ]
    names = distinct([str(name) for _, name, _ in read])
    of_mesh: dict[int, list[str]] = {}
    for (number, _, _), name in zip(read, names, strict=True):
        of_mesh.setdefault(number, []).append(name)
    uses = Counter(primitive.get("attributes", {}).get("POSITION") for _, _, primitive in read)
    shapes = {
        name: primitives.shape(primitive, is_shared=uses[primitive.get("attributes", {}).get("POSITION")] > 1)
        for (_, _, primitive), name in zip(read, names, strict=True)
    }
    return shapes, of_mesh


def _notes(header: dict[str, Any]) -> list[str]:
    """Notes on the features of a glTF file that are ignored."""
    primitives = [primitive for mesh in header.get("meshes", []) for primitive in mesh["primitives"]]
    ignored = {name: len(header.get(f"{name}s", [])) for name in ("animation", "skin", "camera")}
    kinds = Counter(mode(p) for p in primitives if mode(p) not in MODES)
    for kind, number in kinds.items():
        name = OTHERS.get(kind, "primitive of an unknown mode")
        ignored[name] = ignored.get(name, 0) + number
    ignored["morphed primitive"] = sum("targets" in p for p in primitives)
    ignored["set of tangents"] = sum("TANGENT" in p.get("attributes", {}) for p in primitives)
    notes = [
        f"{count(number, feature, _PLURALS.get(feature, ''))} ignored" for feature, number in ignored.items() if number
    ]
    return notes + extensions.ignored(header)
