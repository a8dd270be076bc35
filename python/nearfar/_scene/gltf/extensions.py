"""glTF extensions: which ones a file requires, and which ones are ignored."""

from __future__ import annotations

from typing import Any

from nearfar._base.errors import UnusableError
from nearfar._base.glb import entry
from nearfar._scene.coordinates import TRANSFORM
from nearfar._scene.gltf import draco
from nearfar._scene.gltf.buffers import IMAGE_EXTENSIONS, MESHOPT
from nearfar._scene.gltf.ktx2 import BASISU
from nearfar._scene.gltf.nodes import INSTANCING
from nearfar._scene.undrawn import EXTENSIONS

_READ = {draco.DRACO, "KHR_mesh_quantization", INSTANCING, *MESHOPT}
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


def check(header: dict[str, Any]) -> None:
    """Reject a document with required extensions that are not supported."""
    for name in header.get("extensionsRequired", []):
        if name in _REMEDIES:
            raise UnusableError(f"it needs the extension {name}, {_REMEDIES[name]}")
        if name in IMAGE_EXTENSIONS:
            _check_image_support(name)
        elif name not in _DISPENSABLE | EXTENSIONS | _READ | {BASISU}:
            raise UnusableError(f"it needs the extension {name}, which is not read: save the model without it")
    primitives = (primitive for mesh in header.get("meshes", []) for primitive in mesh["primitives"])
    if any(needs_draco(primitive, header) for primitive in primitives):
        draco.prepare()


def _check_image_support(name: str) -> None:
    from PIL import features

    if not features.check(IMAGE_EXTENSIONS[name]):
        condition = f"which the Python package Pillow decodes if it was built with {IMAGE_EXTENSIONS[name]}"
        raise UnusableError(f"it needs the extension {name}, {condition}: save its textures as PNG or JPEG")


def needs_draco(primitive: dict[str, Any], header: dict[str, Any]) -> bool:
    """Whether an attribute of a primitive, or its indices, exist only in Draco's compressed form."""
    if draco.DRACO not in primitive.get("extensions", {}):
        return False
    numbers = [*primitive.get("attributes", {}).values(), *([primitive["indices"]] if "indices" in primitive else [])]
    return any("bufferView" not in entry(header, "accessors", number) for number in numbers)


def choose_images(header: dict[str, Any]) -> None:
    """Make an extension's image the plain source of textures without one."""
    for texture in header.get("textures", []):
        if "source" not in texture:
            for name in (*IMAGE_EXTENSIONS, BASISU):
                if name in texture.get("extensions", {}):
                    texture["source"] = texture["extensions"][name]["source"]


def ignored(header: dict[str, Any]) -> list[str]:
    """Notes on ignored extensions."""
    return [f"extension {name} ignored" for name in _extension_names(header) if name not in _SILENT]


def used(header: dict[str, Any]) -> list[str]:
    """Supported extensions, for the list of features that a scene uses."""
    supported = {*_READ, *IMAGE_EXTENSIONS, BASISU, TRANSFORM}
    return [f"extension {name}" for name in _extension_names(header) if name in supported]


def _extension_names(header: dict[str, Any]) -> list[str]:
    return [*dict.fromkeys([*header.get("extensionsUsed", []), *header.get("extensionsRequired", [])])]
