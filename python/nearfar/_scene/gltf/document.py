"""Reads glTF and GLB, and decides which extensions are required, used or ignored."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from nearfar._base import check, glb
from nearfar._base.errors import UnusableError
from nearfar._base.glb import entry
from nearfar._scene.budget import Budget
from nearfar._scene.content import Content, Shape
from nearfar._scene.coordinates import TRANSFORM
from nearfar._scene.gltf import draco, nodes, stored
from nearfar._scene.gltf.buffers import IMAGE_EXTENSIONS, MESHOPT, Buffers, name_files
from nearfar._scene.gltf.corners import MODES, UNSUPPORTED, drawn_primitives, is_drawn, mode
from nearfar._scene.gltf.ktx2 import BASISU
from nearfar._scene.gltf.material_reader import MaterialReader
from nearfar._scene.gltf.primitives import Primitives
from nearfar._scene.gltf.variants import PLAIN, Variant, assign, is_jointed
from nearfar._scene.materials import Materials
from nearfar._scene.names import distinct
from nearfar._scene.report import count
from nearfar._scene.undrawn import EXTENSIONS

_PLURALS = {"set of tangents": "sets of tangents", "primitive of an unknown mode": "primitives of unknown modes"}
_PLURALS |= {"primitive without POSITION": "primitives without POSITION"}

_READ = {draco.DRACO, "KHR_mesh_quantization", nodes.INSTANCING, nodes.VISIBILITY, *MESHOPT}
"""Supported extensions that affect shapes."""

_REMEDIES = {"MSFT_texture_dds": "which is not read: save its textures as PNG or JPEG"}

_DISPENSABLE = {
    *(TRANSFORM, "KHR_lights_punctual", "EXT_lights_image_based", "KHR_materials_variants", "KHR_animation_pointer"),
    *("KHR_xmp", "KHR_xmp_json_ld", "EXT_mesh_features", "EXT_instance_features", "EXT_structural_metadata"),
    *("MSFT_lod", "CESIUM_primitive_outline", "CESIUM_RTC"),
}
"""Extensions that may be ignored without changing a file's shapes and base colours."""

_SILENT = {*_READ, BASISU, TRANSFORM, *EXTENSIONS, *IMAGE_EXTENSIONS, *_REMEDIES}
"""Extensions without a note that they are ignored: supported, rejected, or noted elsewhere."""


def read(
    label: str, data: bytes, kind: str, resolver: Any, materials: Materials, budget: Budget, *, stores: bool = True
) -> Content:
    """Read a GLB or the JSON of a glTF; the resolver loads its buffers and images.

    With `stores`, meshes that the core can read directly stay in the file's bytes.
    """
    header, end = glb.header(data) if kind == "glb" else (glb.json_object(data), 0)
    _check_version(header)
    nodes.check_trees(header)
    notes, features = _notes(header), _features(header)
    _choose_images(header)
    _check_extensions(header)
    name_files(header, resolver)
    buffers = Buffers(header, glb.binary(data, end) if kind == "glb" else b"", resolver, budget)
    reader = MaterialReader(header, buffers, materials, budget)
    reader.decode(_materials(header))
    primitives = Primitives(header, buffers, reader, budget)
    instances = nodes.instance_transforms(header, buffers, budget)
    tints, tint_notes = nodes.instance_tints(header, buffers, instances)
    notes += tint_notes
    variants = assign(header, nodes.visible(header), tints)
    stored_meshes, numbers = None, list[int]()
    if stores:
        stored_meshes, numbers = stored.read_stored(header, reader, buffers, budget, variants.by_mesh)
    is_stored = set(numbers)
    names = _names(header, is_stored)
    other_names = {number: names[number] for number in names if number not in is_stored}
    shapes = _shapes(header, primitives, other_names, variants.by_mesh)
    notes += primitives.notes
    if stored_meshes is not None:
        stored_meshes = replace(stored_meshes, names=[names[number][0] for number in numbers])
    placed_nodes = nodes.place_nodes(header, names, instances, variants)
    return Content(label, shapes, placed_nodes, notes, used=features, stored=stored_meshes)


def _check_version(header: dict[str, Any]) -> None:
    """Reject documents of other major versions, and those that need a later minor version (glTF 2.0, 3.2)."""
    asset = header.get("asset", {})
    version, least_version = str(asset.get("version", "2.0")), str(asset.get("minVersion", "2.0"))
    if version.split(".")[0] != "2":
        raise UnusableError(f"it is glTF {check.shortened(version)}, and only glTF 2 is read")
    if least_version != "2.0":
        raise UnusableError(f"it needs glTF {check.shortened(least_version)} (asset.minVersion), and glTF 2.0 is read")


def _names(header: dict[str, Any], stored_numbers: set[int]) -> dict[int, list[str]]:
    """Shape names for each mesh: one if the mesh is stored, else one for each primitive."""
    rows = [
        (number, str(mesh.get("name") or "mesh"))
        for number, mesh in enumerate(header.get("meshes", []))
        for _ in ([mesh] if number in stored_numbers else drawn_primitives(mesh))
    ]
    names_by_mesh: dict[int, list[str]] = {}
    for (number, _), name in zip(rows, distinct([name for _, name in rows]), strict=True):
        names_by_mesh.setdefault(number, []).append(name)
    return names_by_mesh


def _shapes(
    header: dict[str, Any],
    primitives: Primitives,
    names: dict[int, list[str]],
    variants: Mapping[int, Variant],
) -> dict[str, Shape]:
    """Read the shapes of some meshes by name; `variants` are by mesh index."""
    uses = Counter(_positions(primitive) for mesh in header.get("meshes", []) for primitive in drawn_primitives(mesh))
    return {
        name: primitives.shape(name, primitive, variants.get(number, PLAIN), is_shared=uses[_positions(primitive)] > 1)
        for number, mesh_names in names.items()
        for name, primitive in zip(mesh_names, drawn_primitives(header["meshes"][number]), strict=True)
    }


def _materials(header: dict[str, Any]) -> list[int]:
    """Valid indices of the materials in use, without repetitions."""
    numbers = (primitive.get("material") for mesh in header.get("meshes", []) for primitive in drawn_primitives(mesh))
    valid = range(len(header.get("materials", [])))
    return sorted({number for number in numbers if type(number) is int and number in valid})


def _positions(primitive: dict[str, Any]) -> Any:
    return primitive.get("attributes", {}).get("POSITION")


def _notes(header: dict[str, Any]) -> list[str]:
    """Notes on ignored features of a glTF file."""
    primitives = [primitive for mesh in header.get("meshes", []) for primitive in mesh["primitives"]]
    ignored = Counter({name: len(header.get(f"{name}s", [])) for name in ("animation", "camera")})
    ignored.update(UNSUPPORTED.get(mode(p), "primitive of an unknown mode") for p in primitives if mode(p) not in MODES)
    ignored["other scene"] = max(0, len(header.get("scenes", [])) - 1)
    ignored["primitive without POSITION"] = sum(mode(p) in MODES and not is_drawn(p) for p in primitives)
    ignored["set of tangents"] = sum("TANGENT" in p.get("attributes", {}) for p in primitives)
    notes = [
        f"{count(number, feature, _PLURALS.get(feature, ''))} ignored" for feature, number in ignored.items() if number
    ]
    at_rest = {"skin": len(header.get("skins", [])), "morphed primitive": sum("targets" in p for p in primitives)}
    notes += [f"{count(number, feature)} shown at rest" for feature, number in at_rest.items() if number]
    extensions = [f"extension {name} ignored" for name in _extension_names(header) if name not in _SILENT]
    return notes + _node_notes(header) + extensions


def _node_notes(header: dict[str, Any]) -> list[str]:
    """Notes on nodes that are not drawn, or drawn differently."""
    hidden_count = sum(map(nodes.is_hidden, header.get("nodes", [])))
    skinned = [header["nodes"][number] for number in nodes.visible(header) if "skin" in header["nodes"][number]]
    primitives = [drawn_primitives(entry(header, "meshes", node["mesh"])) for node in skinned if "mesh" in node]
    loose_count = sum(not is_jointed(p) for group in primitives if any(map(is_jointed, group)) for p in group)
    hidden = f"{count(hidden_count, 'hidden node')} and all nodes below not drawn"
    loose = f"{count(loose_count, 'primitive')} without joints in skinned meshes drawn without the node's transform"
    return [*([hidden] if hidden_count else []), *([loose] if loose_count else [])]


def _features(header: dict[str, Any]) -> list[str]:
    """The format, counts of supported parts, and the extensions, one phrase each."""
    made_by = header.get("asset", {}).get("generator")
    placing = sum("mesh" in node for node in header.get("nodes", []))
    primitives = sum(len(drawn_primitives(mesh)) for mesh in header.get("meshes", []))
    supported = {*_READ, *IMAGE_EXTENSIONS, BASISU, TRANSFORM}
    return [
        "glTF 2.0" + (f", made by {check.shortened(str(made_by))}" if made_by else ""),
        f"{count(placing, 'node')} with meshes",
        f"{count(primitives, 'primitive')} of triangles",
        *(count(len(header[f"{part}s"]), part) for part in ("material", "texture", "image") if header.get(f"{part}s")),
        *(f"extension {name}" for name in _extension_names(header) if name in supported),
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
    """Make an extension's image the source of textures that have none."""
    for texture in header.get("textures", []):
        if "source" not in texture:
            for name in (*IMAGE_EXTENSIONS, BASISU):
                if name in texture.get("extensions", {}):
                    texture["source"] = texture["extensions"][name]["source"]


def _extension_names(header: dict[str, Any]) -> list[str]:
    return [*dict.fromkeys([*header.get("extensionsUsed", []), *header.get("extensionsRequired", [])])]
