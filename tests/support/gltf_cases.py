"""A glTF file for tests that uses all material properties, and readers of written files."""

from __future__ import annotations

import io
import json
import struct
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

import nearfar as nf

COMPONENTS = {"i1": 5120, "u1": 5121, "i2": 5122, "u2": 5123, "u4": 5125, "f4": 5126}
"""Codes of glTF by the types of arrays."""

CORNERS = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0]], np.float32)

MATERIALS: list[dict[str, Any]] = [
    {
        "name": "lamp",
        "pbrMetallicRoughness": {
            "baseColorFactor": [0.8, 0.3, 0.1, 0.7],
            "baseColorTexture": {"index": 0},
            "metallicFactor": 0.9,
            "roughnessFactor": 0.35,
            "metallicRoughnessTexture": {"index": 2},
        },
        "normalTexture": {"index": 1, "scale": 0.6},
        "occlusionTexture": {"index": 2, "strength": 0.5},
        "emissiveTexture": {"index": 3},
        "emissiveFactor": [1.0, 0.5, 0.25],
        "alphaMode": "BLEND",
        "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 4.0}},
    },
    {
        "name": "leaf",
        "pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.3, 0.1, 0.7], "baseColorTexture": {"index": 0}},
        "alphaMode": "MASK",
        "alphaCutoff": 0.3,
        "doubleSided": True,
    },
    {
        "name": "plaster",
        "pbrMetallicRoughness": {"metallicFactor": 0.0},
        "normalTexture": {"index": 1, "extensions": {"KHR_texture_transform": {"scale": [2.0, 2.0]}}},
        "doubleSided": True,
    },
]
"""Names of materials in the file that `gltf` writes."""

IMAGES = 4


def picture(number: int, kind: str) -> bytes:
    """One of the file's images, as PNG or JPEG."""
    texels = np.random.default_rng(number).integers(0, 256, (8, 6, 3), np.uint8)
    file = io.BytesIO()
    Image.fromarray(texels).save(file, kind)
    return file.getvalue()


def gltf(materials: list[dict[str, Any]] | None = None, **changes: Any) -> bytes:
    """A GLB with a square for each material; `changes` replace entries of its document."""
    chosen = MATERIALS if materials is None else materials
    corners = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], np.float32)
    uvs = np.array([[0, 1], [1, 1], [1, 0], [0.1, 0.3]], np.float32)
    faces = np.array([[0, 1, 2], [0, 2, 3]], np.uint16)
    images = [picture(n, "jpeg" if n == 1 else "png") for n in range(IMAGES)]
    pieces = [corners.tobytes(), uvs.tobytes(), faces.tobytes(), *images]
    views, binary = [], b""
    for piece in pieces:
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(piece)})
        binary += piece + bytes(-len(piece) % 4)
    attributes = {"POSITION": 0, "TEXCOORD_0": 1}
    meshes = [
        {"primitives": [{"attributes": attributes, "indices": 2, "material": number}]} for number in range(len(chosen))
    ]
    document: dict[str, Any] = {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": list(range(len(chosen)))}],
        "nodes": [{"mesh": n, "name": f"square{n}", "translation": [2.0 * n, 0, 0]} for n in range(len(chosen))],
        "meshes": meshes,
        "materials": chosen,
        "samplers": [{"wrapS": 33071, "magFilter": 9728}],
        "textures": [{"source": n} | ({"sampler": 0} if n == 0 else {}) for n in range(IMAGES)],
        "images": [{"bufferView": 3 + n, "mimeType": "image/jpeg" if n == 1 else "image/png"} for n in range(IMAGES)],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
            {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
            {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"},
        ],
        "bufferViews": views,
        "buffers": [{"byteLength": len(binary)}],
    }
    return encode(document | changes, binary)


def triangle(binary: bytes = CORNERS.tobytes(), **changes: Any) -> bytes:
    """A GLB of one triangle, whose corners fill the buffer; `changes` replace entries of its document."""
    document = {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": "thing"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
        "bufferViews": [{"buffer": 0, "byteLength": CORNERS.nbytes}],
        "buffers": [{"byteLength": CORNERS.nbytes}],
    }
    return encode(document | changes, binary)


def load(folder: Path, content: bytes, **options: Any) -> nf.Scene:
    """Write a GLB into a folder, and load it."""
    (folder / "a.glb").write_bytes(content)
    return nf.Scene.load(folder / "a.glb", **options)


def encode(document: Any, binary: bytes) -> bytes:
    return join(json.dumps(document).encode(), binary)


def join(text: bytes, binary: bytes) -> bytes:
    """A GLB of two chunks."""
    text += b" " * (-len(text) % 4)
    binary += bytes(-len(binary) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(binary), b"BIN\0") + binary
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def decode(file: Path | bytes) -> tuple[dict[str, Any], bytes]:
    """Document and buffer of a GLB."""
    data = file if isinstance(file, bytes) else file.read_bytes()
    (length,) = struct.unpack_from("<I", data, 12)
    document: dict[str, Any] = json.loads(data[20 : 20 + length])
    return document, data[20 + length + 8 :]


def materials(path: Path) -> dict[str, dict[str, Any]]:
    """Materials of a GLB by name; images' bytes and samplers replace the textures that refer to them."""
    document, binary = decode(path)

    def resolved(key: str, value: Any) -> Any:
        if not isinstance(value, dict):
            return value
        value = {name: resolved(name, item) for name, item in value.items()}
        if key.endswith("Texture"):
            texture = document["textures"][value.pop("index")]
            view = document["bufferViews"][document["images"][texture["source"]]["bufferView"]]
            start = view.get("byteOffset", 0)
            value["image"] = binary[start : start + view["byteLength"]]
            value["sampler"] = document["samplers"][texture["sampler"]] if "sampler" in texture else None
        return value

    return {material.get("name", ""): resolved("", material) for material in document.get("materials", [])}


def texels(data: bytes) -> np.ndarray:
    with Image.open(io.BytesIO(data)) as image:
        return np.asarray(image.convert("RGBA"))


def assert_same_materials(written: Path, source: Path) -> None:
    """Assert equal materials in both files: images of base colours by texels, everything else by bytes."""
    one, other = materials(written), materials(source)
    assert one.keys() == other.keys()
    for name, material in one.items():
        surfaces = [m.setdefault("pbrMetallicRoughness", {}) for m in (material, other[name])]
        images = [surface.get("baseColorTexture", {}).pop("image", None) for surface in surfaces]
        assert (images[0] is None) == (images[1] is None), name
        if images[0] is not None:
            np.testing.assert_array_equal(texels(images[0]), texels(images[1]))
        for surface in surfaces:
            surface.setdefault("baseColorFactor", [1.0, 1.0, 1.0, 1.0])
        assert material == other[name]
