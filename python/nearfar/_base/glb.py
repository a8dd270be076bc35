"""Reader and writer of binary glTF 2.0 (GLB): one JSON document and one buffer of arrays, stored bit for bit.

The writer can also add arrays that meshoptimizer packed.
"""

from __future__ import annotations

import json
import struct
from collections.abc import Callable
from typing import Any, Literal, Self

import numpy as np
from numpy.typing import NDArray

from nearfar._base import formats

_HEADER, _CHUNK = struct.Struct("<4sII"), struct.Struct("<I4s")
_VERSION = 2

_COMPONENTS: dict[int, type[np.generic]] = {5121: np.uint8, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}
_KINDS = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4"}

Target = Literal["vertices", "faces"]
_TARGETS = {"vertices": 34962, "faces": 34963}
_MODES = {"vertices": "ATTRIBUTES", "faces": "TRIANGLES"}

MESHOPT = "EXT_meshopt_compression"
_CHUNK_BUFFER, _UNPACKED_BUFFER = 0, 1


class Writer:
    """Collects arrays and images for a GLB; the document refers to them by index."""

    def __init__(self) -> None:
        self._pieces: list[bytes] = []
        self._size = 0
        self._unpacked = 0
        """Bytes of all packed arrays when they are unpacked."""
        self._views: list[dict[str, Any]] = []
        self._accessors: list[dict[str, Any]] = []

    @classmethod
    def adding_to(cls, data: bytes) -> tuple[Self, dict[str, Any]]:
        """Return a writer that has the arrays of a GLB without external buffers, and the rest of its document."""
        document, end = header(data)
        writer = cls()
        writer._views, writer._accessors = document.pop("bufferViews", []), document.pop("accessors", [])
        sizes = [buffer["byteLength"] for buffer in document.pop("buffers", [])]
        content = binary(data, end)[: sizes[_CHUNK_BUFFER]] if sizes else b""
        writer._append(bytes(content))
        writer._unpacked = sizes[_UNPACKED_BUFFER] if len(sizes) > 1 else 0
        return writer, document

    def view(self, values: NDArray[Any] | bytes, target: Target | None = None) -> int:
        """Add bytes to the buffer and return the index of their view."""
        data = values if isinstance(values, bytes) else np.ascontiguousarray(values).tobytes()
        view = self._append(data)
        if target == "vertices" and not isinstance(values, bytes):
            view["byteStride"] = values.itemsize * values.shape[1]
        if target is not None:
            view["target"] = _TARGETS[target]
        self._views.append(view)
        return len(self._views) - 1

    def packed_view(self, data: bytes, target: Target, *, count: int, stride: int, exponential: bool = False) -> int:
        """Add an array of `count` rows of `stride` bytes that meshoptimizer packed; return the index of its view.

        With `exponential`, each word is a signed mantissa of 24 bits and, above it, an exponent of 8 bits.
        """
        packed = {**self._append(data), "byteStride": stride, "count": count, "mode": _MODES[target]}
        if exponential:
            packed["filter"] = "EXPONENTIAL"
        view: dict[str, Any] = {
            "buffer": _UNPACKED_BUFFER,
            "byteOffset": self._unpacked,
            "byteLength": count * stride,
            "target": _TARGETS[target],
            "extensions": {MESHOPT: packed},
        }
        if target == "vertices":
            view["byteStride"] = stride
        self._unpacked += count * stride + -(count * stride) % 4
        self._views.append(view)
        return len(self._views) - 1

    def _append(self, data: bytes) -> dict[str, Any]:
        """Add bytes to the buffer; return their place."""
        place = {"buffer": _CHUNK_BUFFER, "byteOffset": self._size, "byteLength": len(data)}
        padding = -len(data) % 4
        self._pieces += [data, bytes(padding)]
        self._size += len(data) + padding
        return place

    def accessor(
        self, view: int, values: NDArray[Any], start: int, *, normalized: bool = False, extent: Any = None
    ) -> int:
        """Add an accessor for `values`, (N,) or (N, K), the rows of a view from row `start` on; return its index.

        `view` is an index that the method `view` returned. With `normalized`, integers represent 0..1. `extent` has the
        least and the greatest values by column, if the format requires them.
        """
        component = next(code for code, kind in _COMPONENTS.items() if values.dtype == kind)
        width = 1 if values.ndim == 1 else values.shape[1]
        accessor: dict[str, Any] = {
            "bufferView": view,
            "byteOffset": start * width * values.itemsize,
            "componentType": component,
            "count": len(values),
            "type": _KINDS[width],
        }
        if normalized:
            accessor["normalized"] = True
        if extent is not None:
            accessor["min"], accessor["max"] = (np.asarray(corner, np.float64).tolist() for corner in extent)
        self._accessors.append(accessor)
        return len(self._accessors) - 1

    def encode(self, document: dict[str, Any], *, spaces: bool = True) -> bytes:
        """Encode the file, its JSON with spaces or not. Empty lists are left out: glTF does not allow them."""
        content = {
            **document,
            "accessors": self._accessors,
            "bufferViews": self._views,
            "buffers": [{"byteLength": self._size}] if self._size else [],
        }
        if self._unpacked:
            # The extension requires a buffer without data, in which packed arrays have a place.
            content["buffers"].append({"byteLength": self._unpacked, "extensions": {MESHOPT: {"fallback": True}}})
            for key in ("extensionsUsed", "extensionsRequired"):
                content[key] = sorted({*content.get(key, []), MESHOPT})
        content = {key: value for key, value in content.items() if value != []}
        text = json.dumps(content, separators=None if spaces else (",", ":"), allow_nan=False)
        return _file(text, *([_CHUNK.pack(self._size, b"BIN\0"), *self._pieces] if self._size else []))


def with_document(data: bytes, document: dict[str, Any]) -> bytes:
    """Replace the JSON document of a GLB; the other chunks stay."""
    _, end = header(data)
    return _file(json.dumps(document, separators=(",", ":"), allow_nan=False), data[end:])


def header(data: bytes, parse: Callable[[bytes], Any] = formats.from_foreign_json) -> tuple[dict[str, Any], int]:
    """Return the JSON document of a GLB, and the start of the next chunk; ValueError for anything else."""
    start = _HEADER.size + _CHUNK.size
    if len(data) < start:
        raise ValueError("it ends within its header")
    magic, version, _ = _HEADER.unpack_from(data)
    if magic != b"glTF" or version != _VERSION:
        raise ValueError("it does not begin like a GLB of version 2")
    length, _ = _CHUNK.unpack_from(data, _HEADER.size)
    return json_object(data[start : start + length], parse), start + length


def binary(data: bytes, end: int) -> memoryview:
    """Return the content of a GLB's first binary chunk from `end` on; empty if there is none."""
    while len(data) >= end + _CHUNK.size:
        length, kind = _CHUNK.unpack_from(data, end)
        start, end = end + _CHUNK.size, end + _CHUNK.size + length
        if end > len(data):
            raise ValueError(f"it ends within a chunk of {length} bytes")
        if kind == b"BIN\0":
            return memoryview(data)[start:end]
    return memoryview(b"")


def entry(document: dict[str, Any], section: str, number: Any) -> dict[str, Any]:
    """Return an entry of one of the document's lists; IndexError for an invalid index."""
    entries = document.get(section, [])
    if type(number) is not int or not 0 <= number < len(entries):
        raise IndexError(f"entry {number} of {len(entries)} {section}")
    item: dict[str, Any] = entries[number]
    return item


def json_object(text: bytes, parse: Callable[[bytes], Any] = formats.from_foreign_json) -> dict[str, Any]:
    """Parse a JSON object; ValueError for anything else."""
    document = parse(text)
    if not isinstance(document, dict):
        raise ValueError("its JSON is not an object")
    return document


def _file(text: str, *other_chunks: bytes) -> bytes:
    """Encode a GLB with this JSON, padded to whole words, and the bytes of its other chunk."""
    content = text.encode()
    content += b" " * (-len(content) % 4)
    chunks = [_CHUNK.pack(len(content), b"JSON"), content, *other_chunks]
    return b"".join([_HEADER.pack(b"glTF", _VERSION, _HEADER.size + sum(map(len, chunks))), *chunks])


class Reader:
    """Document and arrays of a file written by `Writer`; other files raise any error that their damage causes."""

    def __init__(self, data: bytes) -> None:
        self.document, end = header(data, formats.from_json)
        size = _HEADER.unpack_from(data)[2]
        if size != len(data):
            raise ValueError(f"expected {size} bytes as stated in its header, got {len(data)}")
        self._buffer = memoryview(data)[end + _CHUNK.size :]

    def bytes(self, view: int) -> memoryview:
        described = entry(self.document, "bufferViews", view)
        start, length = described["byteOffset"], described["byteLength"]
        if not 0 <= start <= start + length <= len(self._buffer):
            size = len(self._buffer)
            raise ValueError(f"expected bytes within the buffer of {size}, got {start} to {start + length}")
        return self._buffer[start : start + length]

    def array(self, accessor: int) -> NDArray[Any]:
        """Return the rows of an accessor, (N,) or (N, K), read-only and without a copy."""
        described = entry(self.document, "accessors", accessor)
        kind = np.dtype(_COMPONENTS[described["componentType"]])
        width = next(width for width, name in _KINDS.items() if name == described["type"])
        count, offset = described["count"], described["byteOffset"]
        if count < 0 or offset < 0:
            raise ValueError(f"expected a row count and a byte offset of at least 0, got {count} and {offset}")
        values = np.frombuffer(self.bytes(described["bufferView"]), kind, count * width, offset)
        return values if width == 1 else values.reshape(count, width)
