"""Headers and feature tables of the tiles of 3D Tiles 1.0."""

from __future__ import annotations

import struct
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check, glb
from nearfar._base.errors import UnusableError
from nearfar._scene.tileset import values

_COMMON = struct.Struct("<4sII")
_LENGTHS = struct.Struct("<IIII")
_VERSION = 1


@dataclass(frozen=True)
class Parts:
    """Parts of a tile's file."""

    features: Features
    has_properties: bool
    """Whether its batch table has properties, which are not drawn."""
    format: int
    """Format of an i3dm's model: 0 for a URI of a glTF file, 1 for an embedded GLB."""
    body: bytes
    """Bytes after the tables."""


def framed(data: bytes) -> bytes:
    """Return the bytes of the tile at the start of `data`; UnusableError if its header does not match."""
    if len(data) < _COMMON.size:
        raise UnusableError(f"it ends within its header, after {len(data)} bytes")
    magic, version, length = _COMMON.unpack_from(data)
    name = magic.decode("latin-1")
    if version != _VERSION:
        raise UnusableError(f"it is {name} of version {version}, and only version 1 is read")
    if not _COMMON.size <= length <= len(data):
        raise UnusableError(f"its header states {length:,} bytes, and it has {len(data):,}")
    return data[:length]


def parts(data: bytes, *, has_format: bool) -> Parts:
    """Split a b3dm or, with `has_format`, an i3dm."""
    data = framed(data)
    start = _COMMON.size + _LENGTHS.size + 4 * has_format
    if len(data) < start:
        raise UnusableError(f"it ends within its header of {start} bytes")
    lengths = _LENGTHS.unpack_from(data, _COMMON.size)
    ends = [start, *(start + sum(lengths[: n + 1]) for n in range(4))]
    if ends[-1] > len(data):
        sizes = " + ".join(f"{length:,}" for length in lengths)
        raise UnusableError(f"its tables have {sizes} bytes as its header states, and it has {len(data) - start:,}")
    text, binary, properties, _ = (data[a:b] for a, b in pairwise(ends))
    kind = int.from_bytes(data[start - 4 : start], "little") if has_format else 1
    document = glb.json_object(text) if text.strip(b" \0") else {}
    return Parts(Features(document, binary), len(properties.strip(b" \0")) > 2, kind, data[ends[-1] :])


class Features:
    """A feature table: values for the whole tile, and rows for each of its features."""

    def __init__(self, document: dict[str, Any], binary: bytes) -> None:
        self._document, self._binary = document, binary

    def __contains__(self, name: str) -> bool:
        return self._document.get(name) is not None

    def count(self, name: str) -> int:
        """A number of features or instances."""
        value = self._document.get(name)
        if isinstance(value, dict):
            value = int(self.rows(name, 1, 1, np.uint32)[0, 0])
        return values.whole(f"feature table, {name}", value, 0, (1 << 32) - 1)

    def flag(self, name: str) -> bool:
        """A boolean value."""
        return self._document.get(name) is True

    def vector(self, name: str, width: int = 3) -> NDArray[np.float64]:
        """A vector (K,) for the whole tile, in the document or in the binary part."""
        value = self._document.get(name)
        if isinstance(value, dict):
            value = self.rows(name, 1, width, np.float32)[0].astype(float).tolist()
        return values.numbers(f"feature table, {name}", value, width)

    def rows(self, name: str, count: int, width: int, kind: type[np.generic]) -> NDArray[Any]:
        """Rows (N, K) for each feature, in the binary part or as a list."""
        value = self._document.get(name)
        json_path = f"feature table, {name}"
        if isinstance(value, list):
            if len(value) != count * width:
                raise UnusableError(f"{json_path}: expected {count * width:,} numbers, got {len(value):,}")
            return np.array(values.numbers(json_path, value, count * width), kind).reshape(count, width)
        if not isinstance(value, dict):
            raise UnusableError(f"{json_path}: expected a place of its binary part, got {check.shortened(value)}")
        start = values.whole(f"{json_path}.byteOffset", value.get("byteOffset"), 0, len(self._binary))
        byte_count = count * width * np.dtype(kind).itemsize
        if start + byte_count > len(self._binary):
            available = f"from byte {start:,}, and the table has {len(self._binary):,}"
            raise UnusableError(f"{json_path}: {count:,} rows take {byte_count:,} bytes {available}")
        return np.frombuffer(self._binary, np.dtype(kind).newbyteorder("<"), count * width, start).reshape(count, width)
