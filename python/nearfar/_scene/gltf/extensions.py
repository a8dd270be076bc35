"""Extensions of glTF: which ones a file cannot be used without, and which ones are ignored."""

from __future__ import annotations

from importlib.util import find_spec
from typing import Any

from nearfar._base.errors import UnusableError
from nearfar._scene.coordinates import TRANSFORM
from nearfar._scene.gltf.buffers import IMAGE_EXTENSIONS
from nearfar._scene.gltf.instances import INSTANCING
from nearfar._scene.gltf.meshopt import MESHOPT
from nearfar._scene.undrawn import EXTENSIONS

DRACO = "KHR_draco_mesh_compression"
_READ = {DRACO, "KHR_mesh_quantization", INSTANCING, *MESHOPT}
"""Extensions of shapes that are read."""

_REMEDIES = {
    "KHR_texture_basisu": "which is not read: save its textures as PNG or JPEG",
    "MSFT_texture_dds": "which is not read: save its textures as PNG or JPEG",
}

_DISPENSABLE = {
    *(TRANSFORM, "KHR_lights_punctual", "EXT_lights_image_based", "KHR_materials_variants", "KHR_animation_pointer"),
    *("KHR_xmp", "KHR_xmp_json_ld", "EXT_mesh_features", "EXT_instance_features", "EXT_structural_metadata"),
    *("MSFT_lod", "CESIUM_primitive_outline"),
}
"""Extensions whose absence leaves the shapes and base colours of a file right."""

_SILENT = {*_READ, TRANSFORM, *EXTENSIONS, *IMAGE_EXTENSIONS, *_REMEDIES}
"""Extensions that are read, refused, or noted where they are used."""


def check(header: dict[str, Any]) -> None:
    """Refuse a document that cannot be decoded."""
    for name in header.get("extensionsRequired", []):
        if name in _REMEDIES:
            raise UnusableError(f"it needs the extension {name}, {_REMEDIES[name]}")
        if name in IMAGE_EXTENSIONS:
            _check_image_support(name)
        elif name not in _DISPENSABLE | EXTENSIONS | _READ:
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


def _check_image_support(name: str) -> None:
    from PIL import features

    if not features.check(IMAGE_EXTENSIONS[name]):
        raise UnusableError(
            f"it needs the extension {name}, which the Python package Pillow decodes if it was built "
            f"with {IMAGE_EXTENSIONS[name]}: save its textures as PNG or JPEG"
        )


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
    return [f"extension {name} ignored" for name in _named(header) if name not in _SILENT]


def used(header: dict[str, Any]) -> list[str]:
    """The extensions that are read, for the list of what a scene uses."""
    return [f"extension {name}" for name in _named(header) if name in _READ or name in IMAGE_EXTENSIONS]


def _named(header: dict[str, Any]) -> list[str]:
    return [*dict.fromkeys([*header.get("extensionsUsed", []), *header.get("extensionsRequired", [])])]
