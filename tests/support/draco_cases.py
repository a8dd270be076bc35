"""GLBs of one mesh compressed by Draco."""

from __future__ import annotations

import base64
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.support.gltf_cases import COMPONENTS, encode, picture

EXTENSION = "KHR_draco_mesh_compression"
NUMBERS = {"NORMAL": 2, "TEXCOORD_0": 7, "TEXCOORD_1": 3, "COLOR_0": 5}
"""Numbers of the attributes in the streams, in a different order from the files."""


def compress(
    positions: NDArray[Any], faces: NDArray[Any] | None, attributes: dict[str, NDArray[Any]], level: int = 7
) -> tuple[bytes, dict[str, int]]:
    """A stream with these attributes in full precision, and their numbers; POSITION has 20 bits."""
    import DracoPy

    generic = {NUMBERS[name]: np.ascontiguousarray(rows) for name, rows in attributes.items()}
    data: bytes = DracoPy.encode(
        positions, faces, compression_level=level, quantization_bits=20, generic_attributes=generic, preserve_order=True
    )
    (place,) = (item["unique_id"] for item in DracoPy.decode(data).attributes if item["attribute_type"] == 0)
    return data, {name: NUMBERS[name] for name in attributes} | {"POSITION": place}


def accessor(rows: NDArray[Any], **changes: Any) -> dict[str, Any]:
    kind = "SCALAR" if rows.ndim == 1 else f"VEC{rows.shape[1]}"
    return {"componentType": COMPONENTS[rows.dtype.str[1:]], "count": len(rows), "type": kind} | changes


def document(
    stream: bytes, numbers: dict[str, int], arrays: dict[str, NDArray[Any]], faces: NDArray[Any], **normalized: bool
) -> tuple[dict[str, Any], bytes]:
    """Document and buffer of a file whose mesh is the stream; `normalized` names its normalised attributes."""
    accessors = [accessor(faces.astype(np.uint32).ravel())]
    attributes = {}
    for name, rows in arrays.items():
        attributes[name] = len(accessors)
        accessors.append(accessor(rows, normalized=normalized.get(name, False)))
    extension = {"bufferView": 0, "attributes": numbers}
    primitive = {"attributes": attributes, "indices": 0, "material": 0, "extensions": {EXTENSION: extension}}
    return {
        "asset": {"version": "2.0"},
        "extensionsRequired": [EXTENSION],
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [primitive]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
        "textures": [{"source": 0}],
        "images": [{"uri": f"data:image/png;base64,{base64.b64encode(picture(0, 'png')).decode()}"}],
        "accessors": accessors,
        "bufferViews": [{"buffer": 0, "byteLength": len(stream)}],
        "buffers": [{"byteLength": len(stream)}],
    }, stream


def glb(
    stream: bytes, numbers: dict[str, int], arrays: dict[str, NDArray[Any]], faces: NDArray[Any], **normalized: bool
) -> bytes:
    """A GLB of a `document`."""
    return encode(*document(stream, numbers, arrays, faces, **normalized))
