"""Images in KTX 2 containers, written from its specification, and GLBs that draw them."""

from __future__ import annotations

import json
import struct
import zlib
from typing import Any

from numpy.typing import NDArray

from tests.support.gltf_cases import encode, gltf

EXTENSION = "KHR_texture_basisu"
SIGNATURE = b"\xabKTX 20\xbb\r\n\x1a\n"


def ktx2(pixels: NDArray[Any], kind: int, /, *, packed: bool = False, notes: bytes = b"", **changes: int) -> bytes:
    """A picture of one level with unmodified pixels (H, W, C); `changes` replace fields of the header."""
    level = pixels.tobytes()
    written = zlib.compress(level) if packed else level
    described = struct.pack("<2I2H4B", 44, 0, 2, 40, 1, 1, 2, 0) + bytes(28)
    header = {
        "kind": kind, "type_size": pixels.itemsize, "width": pixels.shape[1], "height": pixels.shape[0],
        "depth": 0, "layers": 0, "faces": 1, "levels": 1, "scheme": 3 if packed else 0,
    } | {key: value for key, value in changes.items() if key not in ("start", "length", "unpacked")}  # fmt: skip
    first = 80 + 24
    places = [first, len(described), first + len(described) if notes else 0, len(notes)]
    start = first + len(described) + len(notes)
    start += -start % 16
    index = {"start": start, "length": len(written), "unpacked": len(level)}
    index |= {key: value for key, value in changes.items() if key in index}
    head = struct.pack("<12s9I4I2Q3Q", SIGNATURE, *header.values(), *places, 0, 0, *index.values())
    body = head + described + notes
    return body + bytes(start - len(body)) + written


def glb(image: bytes, *others: bytes, materials: list[dict[str, Any]] | None = None, **changes: Any) -> bytes:
    """A GLB of squares whose textures are these images, the first one their base colour."""
    base = [{"pbrMetallicRoughness": {"metallicFactor": 0, "baseColorTexture": {"index": 0}}, "doubleSided": True}]
    file = gltf(base if materials is None else materials)
    length = int.from_bytes(file[12:16], "little")
    document = json.loads(file[20 : 20 + length])
    binary = file[28 + length :]
    document["images"], document["textures"] = [], []
    for number, data in enumerate((image, *others)):
        binary += bytes(-len(binary) % 4)
        view = {"buffer": 0, "byteOffset": len(binary), "byteLength": len(data)}
        document["bufferViews"].append(view)
        binary += data
        mime = "image/ktx2" if data.startswith(SIGNATURE[:4]) else "image/png"
        document["images"].append({"bufferView": len(document["bufferViews"]) - 1, "mimeType": mime})
        document["textures"].append({"extensions": {EXTENSION: {"source": number}}})
    document["buffers"][0]["byteLength"] = len(binary)
    return encode(document | {"extensionsRequired": [EXTENSION]} | changes, binary)
