"""Subtrees of implicit tilings: availability bits of tiles, contents and child subtrees, and boxes in the metadata."""

from __future__ import annotations

import struct
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Any

import numpy as np

from nearfar._base import check, glb
from nearfar._base.errors import UnusableError
from nearfar._scene.entries import choice, integer, typed
from nearfar._scene.frames import Floats

MAX_LEVELS = {2: 16, 3: 10}
"""Maximum number of levels of a subtree, by number of axes: 1.4·10⁹ tiles for two axes, 1.5·10⁸ for three."""

_MAX_CHECKED_BITS = 1 << 26
"""Maximum number of bits checked for consistency, which takes a byte of memory for each bit."""

_BOX_SEMANTIC = "TILE_BOUNDING_BOX"
_BOX_NUMBERS = 12
"""Numbers of a box: its centre, then half of each edge."""
_BOX_TYPES: dict[str, np.dtype[Any]] = {"FLOAT32": np.dtype("<f4"), "FLOAT64": np.dtype("<f8")}

_HEADER = struct.Struct("<4sIQQ")

_BYTE_BIT_COUNTS = np.array([byte.bit_count() for byte in range(256)], np.uint8)
"""Number of set bits of each value of a byte."""


@dataclass(frozen=True)
class BoxProperty:
    """Metadata property that contains boxes of tiles."""

    name: str
    dtype: np.dtype[Any]


@dataclass(frozen=True)
class Bits:
    """Availability bits: one for each of `count` items, or one constant for all."""

    count: int
    data: bytes | None
    """Bits packed into bytes, the least significant bit first; None for a constant."""
    constant: bool = False
    """Value of all bits if there is no `data`."""

    def bit(self, index: int) -> bool:
        if self.data is None:
            return self.constant
        return bool(self.data[index >> 3] >> (index & 7) & 1)

    def rank(self, index: int) -> int:
        """Number of set bits before an index."""
        if self.data is None:
            return index if self.constant else 0
        byte_index = index >> 3
        rank = int(self._byte_ranks[byte_index])
        if byte_index < len(self.data):
            rank += (self.data[byte_index] & ((1 << (index & 7)) - 1)).bit_count()
        return rank

    @cached_property
    def _byte_ranks(self) -> np.ndarray[Any, np.dtype[np.int32]]:
        """Numbers of set bits before each byte; the last one is the total."""
        assert self.data is not None
        counts = _BYTE_BIT_COUNTS[np.frombuffer(self.data, np.uint8)]
        return np.concatenate([np.zeros(1, np.int32), np.cumsum(counts, dtype=np.int32)])

    def unpack(self) -> np.ndarray[Any, np.dtype[np.bool_]]:
        """Return all bits as an array (N,)."""
        if self.data is None:
            return np.broadcast_to(self.constant, (self.count,))
        packed = np.frombuffer(self.data, np.uint8, (self.count + 7) // 8)
        return np.unpackbits(packed, count=self.count, bitorder="little").astype(bool)


@dataclass(frozen=True)
class Subtree:
    """Availability of a subtree's tiles, by level and Morton number, of their contents and of child subtrees."""

    tiles: Bits
    contents: tuple[Bits, ...]
    children: Bits
    boxes: Floats | None = None
    """Boxes of the N available tiles (N, 4, 3): the centre, then half of each edge. None if the file has no boxes."""


@cache
def tiles_above(level: int, axes: int) -> int:
    """Number of tiles of a full subtree on all levels above a level."""
    return int(((1 << axes * level) - 1) // ((1 << axes) - 1))


def read(
    data: bytes, axes: int, levels: int, load: Callable[[str], bytes], properties: dict[str, BoxProperty] | None = None
) -> Subtree:
    """Read a subtree, binary or JSON.

    `load` returns the bytes of a referenced file; `properties` are the metadata properties that state boxes of tiles.
    """
    document, binary = _split(data)
    views = _Views(document, binary, load)
    tile_count = tiles_above(levels, axes)
    content_entries = document.get("contentAvailability", [])
    content_entries = content_entries if isinstance(content_entries, list) else [content_entries]
    extensions = document.get("extensions", {})
    if isinstance(extensions, dict) and "3DTILES_multiple_contents" in extensions:
        multiple_contents = typed(extensions["3DTILES_multiple_contents"], dict, "3DTILES_multiple_contents")
        content_entries = typed(multiple_contents.get("contentAvailability"), list, "contentAvailability")
    tiles = views.bits("tileAvailability", document.get("tileAvailability"), tile_count)
    subtree = Subtree(
        tiles,
        tuple(views.bits(f"contentAvailability[{n}]", entry, tile_count) for n, entry in enumerate(content_entries)),
        views.bits("childSubtreeAvailability", document.get("childSubtreeAvailability"), 1 << axes * levels),
        _boxes(document, properties, tiles.rank(tile_count), views.view) if properties else None,
    )
    _check_consistency(subtree, axes, levels)
    return subtree


def _split(data: bytes) -> tuple[dict[str, Any], bytes]:
    """Split into the JSON document and the binary part."""
    if not data.startswith(b"subt"):
        return glb.json_object(data), b""
    if len(data) < _HEADER.size:
        raise UnusableError(f"it ends within its header of {_HEADER.size} bytes")
    _, version, json_length, binary_length = _HEADER.unpack_from(data)
    if version != 1:
        raise UnusableError(f"it is a subtree of version {version}, and only version 1 is read")
    if _HEADER.size + json_length + binary_length > len(data):
        raise UnusableError(f"it states {_HEADER.size + json_length + binary_length} bytes, and has {len(data)}")
    start = _HEADER.size + json_length
    return glb.json_object(data[_HEADER.size : start]), data[start : start + binary_length]


class _Views:
    """Buffers and buffer views of a subtree's document."""

    def __init__(self, document: dict[str, Any], binary: bytes, load: Callable[[str], bytes]) -> None:
        self._buffers = typed(document.get("buffers", []), list, "buffers")
        self._views = typed(document.get("bufferViews", []), list, "bufferViews")
        self._binary, self._load = binary, load
        self._loaded: dict[int, bytes] = {}

    def bits(self, json_path: str, entry: Any, count: int) -> Bits:
        """Read an availability entry."""
        entry = typed(entry, dict, json_path)
        if "constant" in entry:
            return Bits(count, None, bool(integer(entry["constant"], 0, 1, f"{json_path}.constant")))
        data = self.view(f"{json_path}.bitstream", entry.get("bitstream", entry.get("bufferView")))
        if 8 * len(data) < count:
            raise UnusableError(f"{json_path}: expected {count} bits, got {8 * len(data)}")
        bits = Bits(count, data)
        stated_count = entry.get("availableCount")
        if stated_count is not None and count <= _MAX_CHECKED_BITS:
            bit_count, stated = int(bits.unpack().sum()), check.shortened(stated_count)
            if stated_count != bit_count:
                raise UnusableError(f"{json_path}: availableCount is {stated}, but {bit_count} bits are set")
        return bits

    def view(self, json_path: str, index: Any) -> bytes:
        """Bytes of a buffer view that an entry refers to."""
        return self._bytes(f"bufferViews[{index}]", typed(_item(json_path, self._views, index), dict, json_path))

    def _bytes(self, json_path: str, view: dict[str, Any]) -> bytes:
        index = view.get("buffer")
        buffer = typed(_item(f"{json_path}.buffer", self._buffers, index), dict, json_path)
        assert isinstance(index, int)
        if index not in self._loaded:
            uri = buffer.get("uri")
            self._loaded[index] = self._binary if uri is None else self._load(typed(uri, str, f"{json_path}.uri"))
        data = self._loaded[index]
        start = integer(view.get("byteOffset", 0), 0, len(data), f"{json_path}.byteOffset")
        length = integer(view.get("byteLength"), 0, len(data) - start, f"{json_path}.byteLength")
        return data[start : start + length]


def _item(json_path: str, items: list[Any], index: Any) -> Any:
    if type(index) is not int or not 0 <= index < len(items):
        raise UnusableError(f"{json_path}: expected the index of one of {len(items)}, got {check.shortened(index)}")
    return items[index]


def _check_consistency(subtree: Subtree, axes: int, levels: int) -> None:
    """Reject tiles without a parent, and contents and subtrees without a tile, which no traversal would reach."""
    if subtree.tiles.count > _MAX_CHECKED_BITS or (subtree.tiles.data is None and subtree.tiles.constant):
        return
    tiles = subtree.tiles.unpack()
    starts = [tiles_above(level, axes) for level in range(levels + 1)]
    for level in range(1, levels):
        parents, tiles_of_level = tiles[starts[level - 1] : starts[level]], tiles[starts[level] : starts[level + 1]]
        _refuse_if_any(tiles_of_level & ~np.repeat(parents, 1 << axes), f"tile {{}} of its level {level}", "its parent")
    for bits in subtree.contents:
        if bits.data is not None:
            _refuse_if_any(bits.unpack() & ~tiles, "the content of tile {}", "the tile")
    if subtree.children.data is not None:
        parents = tiles[starts[levels - 1] :]
        _refuse_if_any(subtree.children.unpack() & ~np.repeat(parents, 1 << axes), "subtree {}", "the tile above it")


def _refuse_if_any(is_orphan: np.ndarray[Any, np.dtype[np.bool_]], item: str, owner: str) -> None:
    """Reject the first item that is available without its owner; `item` is a format string with its index."""
    if is_orphan.any():
        raise UnusableError(f"its bits mark {item.format(int(is_orphan.argmax()))} as available, but not {owner}")


def box_properties(document: dict[str, Any]) -> dict[str, BoxProperty]:
    """Properties with tiles' boxes in a tileset's schema, by class name."""
    by_class: dict[str, BoxProperty] = {}
    schema = typed(document.get("schema") or {}, dict, "schema")
    for class_name, class_entry in typed(schema.get("classes", {}), dict, "schema.classes").items():
        json_path = f"schema.classes.{check.shortened(class_name)}"
        properties = typed(class_entry, dict, json_path).get("properties", {})
        for name, item in typed(properties, dict, f"{json_path}.properties").items():
            path = f"{json_path}.properties.{check.shortened(name)}"
            if typed(item, dict, path).get("semantic") != _BOX_SEMANTIC:
                continue
            component = choice(item.get("componentType"), tuple(_BOX_TYPES), f"{path}.componentType")
            integer(item.get("count"), _BOX_NUMBERS, _BOX_NUMBERS, f"{path}.count")
            by_class[class_name] = BoxProperty(name, _BOX_TYPES[component])
    return by_class


def _boxes(
    document: dict[str, Any], properties: dict[str, BoxProperty], count: int, view: Callable[[str, Any], bytes]
) -> Floats | None:
    """Boxes (count, 4, 3) of a subtree's available tiles: the centre, then half of each edge; None if it states none.

    `document` is the subtree's, `properties` the result of `box_properties`; `view` returns the bytes of a buffer view
    by index.
    """
    if not properties or document.get("tileMetadata") is None:
        return None
    tables = typed(document.get("propertyTables"), list, "propertyTables")
    table_path = f"propertyTables[{integer(document['tileMetadata'], 0, len(tables) - 1, 'tileMetadata')}]"
    table = typed(tables[document["tileMetadata"]], dict, table_path)
    property_ = properties.get(str(table.get("class")))
    if property_ is None:
        return None
    if table.get("count") != count:
        got = check.shortened(table.get("count"))
        raise UnusableError(f"{table_path}.count: expected {count}, the number of available tiles, got {got}")
    columns = typed(table.get("properties"), dict, f"{table_path}.properties")
    path = f"{table_path}.properties.{check.shortened(property_.name)}"
    data = view(path, typed(columns.get(property_.name), dict, path).get("values"))
    if len(data) != count * _BOX_NUMBERS * property_.dtype.itemsize:
        raise UnusableError(f"{path}: expected {_BOX_NUMBERS} numbers for each of {count} tiles, got {len(data)} bytes")
    rows = np.frombuffer(data, property_.dtype).astype(np.float64).reshape(count, 4, 3)
    if not np.isfinite(rows).all():
        raise UnusableError(f"{path}: expected finite numbers")
    return rows
