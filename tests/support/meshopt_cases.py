"""Streams of meshoptimizer's codecs, written from the specification of EXT_meshopt_compression, and GLBs of them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.support.gltf_cases import COMPONENTS, encode

EXTENSION = "EXT_meshopt_compression"


@dataclass(frozen=True)
class Stream:
    """A compressed buffer view, and the accessor of all of its rows."""

    data: bytes
    extension: dict[str, Any]
    accessor: dict[str, Any]


def attributes(values: NDArray[Any], *, filter: str = "NONE", **accessor: Any) -> Stream:  # noqa: A002
    """Rows (N, K), padded to multiples of four bytes; `accessor` contains differences from an accessor of the array."""
    width = values.itemsize * values.shape[1]
    rows = np.zeros((len(values), -(-width // 4) * 4), np.uint8)
    rows[:, :width] = np.ascontiguousarray(values).view(np.uint8)
    described = {"count": len(rows), "byteStride": rows.shape[1], "mode": "ATTRIBUTES", "filter": filter}
    return Stream(vertex_codec(rows), described, _accessor(values) | accessor)


def triangles(faces: NDArray[Any]) -> Stream:
    """Corners (N, 3) of triangles."""
    corners = faces.reshape(-1, 1)
    described = {"count": len(corners), "byteStride": corners.itemsize, "mode": "TRIANGLES"}
    return Stream(triangle_codec(corners[:, 0].tolist()), described, _accessor(corners))


def indices(corners: NDArray[Any]) -> Stream:
    """Indices (N,) of any kind."""
    column = corners.reshape(-1, 1)
    described = {"count": len(column), "byteStride": column.itemsize, "mode": "INDICES"}
    return Stream(sequence_codec(corners.tolist()), described, _accessor(column))


def _accessor(values: NDArray[Any]) -> dict[str, Any]:
    kind = "SCALAR" if values.shape[1] == 1 else f"VEC{values.shape[1]}"
    return {"componentType": COMPONENTS[values.dtype.str[1:]], "count": len(values), "type": kind}


def glb(streams: Iterable[Stream], *, name: str = EXTENSION, **document: Any) -> bytes:
    """A GLB whose buffer views and accessors are those of the streams, in order; `document` contains the rest."""
    views: list[dict[str, Any]] = []
    accessors: list[dict[str, Any]] = []
    binary, decoded = b"", 0
    for number, stream in enumerate(streams):
        described = stream.extension
        size = described["count"] * described["byteStride"]
        extension = {"buffer": 0, "byteOffset": len(binary), "byteLength": len(stream.data)} | described
        view = {"buffer": 1, "byteOffset": decoded, "byteLength": size, "extensions": {name: extension}}
        views.append(view | ({"byteStride": described["byteStride"]} if described["mode"] == "ATTRIBUTES" else {}))
        accessors.append({"bufferView": number} | stream.accessor)
        binary += stream.data + bytes(-len(stream.data) % 4)
        decoded += size
    buffers = [{"byteLength": len(binary)}, {"byteLength": decoded, "extensions": {name: {"fallback": True}}}]
    written = {
        "asset": {"version": "2.0"},
        "extensionsRequired": [name],
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "bufferViews": views,
        "accessors": accessors,
        "buffers": buffers,
    }
    return encode(written | document, binary)


def vertex_codec(rows: NDArray[np.uint8]) -> bytes:
    """Version 0 with all differences in 8 bits, which are the longest."""
    count, stride = rows.shape
    step = min(8192 // stride // 16 * 16, 256)
    before = np.concatenate([rows[:1], rows[:-1]])
    change = (rows - before).view(np.int8)
    zigzag = ((change << 1) ^ (change >> 7)).view(np.uint8)
    written = b"\xa0"
    for start in range(0, count, step):
        block = zigzag[start : start + step]
        groups = -(-len(block) // 16)
        for column in block.T:
            written += b"\xff" * -(-groups // 4) + column.tobytes() + bytes(16 * groups - len(block))
    first: bytes = rows[0].tobytes()
    return written + bytes(max(0, 32 - stride)) + first


def triangle_codec(corners: list[int]) -> bytes:
    """Version 1 with all corners stated."""
    codes = b"\xff" * (len(corners) // 3)
    data, last = b"", 0
    for place, corner in enumerate(corners):
        data += (b"\xff" if place % 3 == 0 else b"") + varint(_zigzag(corner - last))
        last = corner
    return b"\xe1" + codes + data + bytes(16)


def sequence_codec(corners: list[int]) -> bytes:
    """Version 1 with differences from the index before."""
    changes = [corner - last for corner, last in zip(corners, [0, *corners[:-1]], strict=True)]
    return b"\xd1" + b"".join(varint(_zigzag(change) << 1) for change in changes) + bytes(4)


def _zigzag(change: int) -> int:
    return 2 * change if change >= 0 else -2 * change - 1


def varint(value: int) -> bytes:
    written = b""
    while value > 127:
        written += bytes([value & 127 | 128])
        value >>= 7
    return written + bytes([value])
