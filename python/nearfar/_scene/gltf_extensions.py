"""Extensions of glTF: which ones a file cannot be used without, and which ones are ignored."""

from __future__ import annotations

from importlib.util import find_spec
from typing import Any

from nearfar._base.errors import UnusableError
from nearfar._scene.gltf_buffers import IMAGE_EXTENSIONS
from nearfar._scene.undrawn import EXTENSIONS, TRANSFORM

DRACO = "KHR_draco_mesh_compression"
_QUANTIZATION = "KHR_mesh_quantization"
_MESHOPT = ("EXT_meshopt_compression", "KHR_meshopt_compression")

_REMEDIES = {
    **dict.fromkeys(_MESHOPT, "which is not read: save the model without compression"),
    "KHR_texture_basisu": "which is not read: save its textures as PNG or JPEG",
    "MSFT_texture_dds": "which is not read: save its textures as PNG or JPEG",
}

_DISPENSABLE = {
    *(TRANSFORM, "KHR_lights_punctual", "EXT_lights_image_based", "KHR_materials_variants", "KHR_animation_pointer"),
    *("KHR_xmp", "KHR_xmp_json_ld", "EXT_mesh_features", "EXT_instance_features", "EXT_structural_metadata"),
    *("MSFT_lod", "CESIUM_primitive_outline"),
}
"""Extensions whose absence leaves the shapes and base colours of a file right."""

_SILENT = {DRACO, _QUANTIZATION, TRANSFORM, *EXTENSIONS, *IMAGE_EXTENSIONS, *_REMEDIES}
"""Extensions that are read, refused, or noted where they are used."""


def check(header: dict[str, Any], *, has_binary: bool) -> None:
    """Refuse a document that cannot be decoded; `has_binary` says that it comes with a GLB's second chunk."""
    for name in header.get("extensionsRequired", []):
        if name in _REMEDIES:
            raise UnusableError(f"it needs the extension {name}, {_REMEDIES[name]}")
        if name in IMAGE_EXTENSIONS:
            _check_image_support(name)
        elif name not in _DISPENSABLE | EXTENSIONS | {DRACO, _QUANTIZATION}:
            raise UnusableError(f"it needs the extension {name}, which is not read: save the model without it")
    for mesh in header.get("meshes", []):
        for primitive in mesh["primitives"]:
            if (
                DRACO in primitive.get("extensions", {})
                and without_data(primitive, header)
                and not find_spec("DracoPy")
            ):
                raise UnusableError(
                    f"it needs the extension {DRACO}, which the Python package DracoPy decodes: pip install DracoPy"
                )
    for view in header.get("bufferViews", []):
        names = [name for name in _MESHOPT if name in view.get("extensions", {})]
        if names and _is_placeholder(header["buffers"][view["buffer"]], view["buffer"], has_binary=has_binary):
            raise UnusableError(f"it needs the extension {names[0]}, {_REMEDIES[names[0]]}")


def _check_image_support(name: str) -> None:
    from PIL import features

    if not features.check(IMAGE_EXTENSIONS[name]):
        raise UnusableError(
            f"it needs the extension {name}, which the Python package Pillow decodes if it was built "
            f"with {IMAGE_EXTENSIONS[name]}: save its textures as PNG or JPEG"
        )


def _is_placeholder(buffer: dict[str, Any], number: int, *, has_binary: bool) -> bool:
    """Whether a buffer stands for data that only a decoder makes."""
    is_fallback = any(buffer.get("extensions", {}).get(name, {}).get("fallback") for name in _MESHOPT)
    return "uri" not in buffer and (is_fallback or number > 0 or not has_binary)


def without_data(primitive: dict[str, Any], header: dict[str, Any]) -> bool:
    """Whether an attribute of a primitive, or its indices, have no bytes but those of an extension."""
    numbers = [*primitive.get("attributes", {}).values()]
    if "indices" in primitive:
        numbers.append(primitive["indices"])
    accessors = [header["accessors"][number] for number in numbers]
    return any("bufferView" not in accessor and "sparse" not in accessor for accessor in accessors)


def choose_images(header: dict[str, Any]) -> bool:
    """Let textures that have only an extension's image refer to it plainly; returns whether there were any."""
    changed = False
    for texture in header.get("textures", []):
        if "source" not in texture:
            for name in IMAGE_EXTENSIONS:
                if name in texture.get("extensions", {}):
                    texture["source"] = texture["extensions"][name]["source"]
                    changed = True
    return changed


def ignored(header: dict[str, Any]) -> list[str]:
    """Notes on the extensions that are ignored."""
    names = dict.fromkeys([*header.get("extensionsUsed", []), *header.get("extensionsRequired", [])])
    return [f"extension {name} ignored" for name in names if name not in _SILENT]
