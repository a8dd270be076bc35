"""Subtrees of implicit tilings: availability bits of tiles, contents and child subtrees."""

from __future__ import annotations

import struct
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Any

import numpy as np

from nearfar._base import check, glb
from nearfar._base.errors import UnusableError
from nearfar._scene.tileset import metadata, values
from nearfar._scene.tileset.frames import Floats
from nearfar._scene.tileset.metadata import BoxProperty

MAX_LEVELS = {2: 16, 3: 10}
"""Maximum number of levels of a subtree by number of axes; it then has about a thousand million tiles."""

_CHECKED = 1 << 26
"""Greatest number of bits to check for consistency, which takes a byte for each."""

_HEADER = struct.Struct("<4sIQQ")

_ONES = np.array([byte.bit_count() for byte in range(256)], np.uint8)


@dataclass(frozen=True)
class Bits:
    """Availability bits: one for each of `count` items, or one constant for all."""

    count: int
    stored: bytes | None
    constant: bool = False

    def bit(self, number: int) -> bool:
        """Bit at an index."""
        if self.stored is None:
            return self.constant
        return bool(self.stored[number >> 3] >> (number & 7) & 1)

    def rank(self, number: int) -> int:
        """Number of set bits before an index."""
        if self.stored is None:
            return number if self.constant else 0
        byte = number >> 3
        rest = self.stored[byte : byte + 1]
        return int(self._ones[byte]) + ((rest[0] & ((1 << (number & 7)) - 1)).bit_count() if rest else 0)

    @cached_property
    def _ones(self) -> np.ndarray[Any, np.dtype[np.int32]]:
        """Numbers of set bits before each byte, and in total."""
        assert self.stored is not None
        return np.append(0, np.cumsum(_ONES[np.frombuffer(self.stored, np.uint8)], dtype=np.int32)).astype(np.int32)

    def unpacked(self) -> np.ndarray[Any, np.dtype[np.bool_]]:
        """All bits (N,)."""
        if self.stored is None:
            return np.broadcast_to(self.constant, (self.count,))
        packed = np.frombuffer(self.stored, np.uint8, (self.count + 7) // 8)
        return np.unpackbits(packed, count=self.count, bitorder="little").astype(bool)


@dataclass(frozen=True)
class Subtree:
    """Availability of a subtree's tiles by level and Morton number, of their contents, and of child subtrees."""

    tiles: Bits
    contents: tuple[Bits, ...]
    children: Bits
    boxes: Floats | None = None
    """Boxes of the available tiles (N, 4, 3): the centre, then half of each edge. None if not stated."""


@cache
def start_of(level: int, axes: int) -> int:
    """Number of a subtree's tiles above a level."""
    return int(((1 << axes * level) - 1) // ((1 << axes) - 1))


def read(
    data: bytes, axes: int, levels: int, load: Callable[[str], bytes], properties: dict[str, BoxProperty] | None = None
) -> Subtree:
    """Read a subtree, binary or JSON.

    `load` returns the bytes of a referenced file; `properties` are the tileset's properties with boxes.
    """
    document, binary = _parts(data)
    views = _Views(document, binary, load)
    inner, leaves = start_of(levels, axes), 1 << axes * levels
    listed = document.get("contentAvailability", [])
    listed = listed if isinstance(listed, list) else [listed]
    others = document.get("extensions", {})
    if isinstance(others, dict) and "3DTILES_multiple_contents" in others:
        several = values.entries("3DTILES_multiple_contents", others["3DTILES_multiple_contents"])
        listed = values.items("contentAvailability", several.get("contentAvailability"))
    tiles = views.bits("tileAvailability", document.get("tileAvailability"), inner)
    subtree = Subtree(
        tiles,
        tuple(views.bits(f"contentAvailability[{n}]", entry, inner) for n, entry in enumerate(listed)),
        views.bits("childSubtreeAvailability", document.get("childSubtreeAvailability"), leaves),
        metadata.boxes(document, properties, tiles.rank(inner), views.view) if properties else None,
    )
    _check(subtree, axes, levels)
    return subtree


def _parts(data: bytes) -> tuple[dict[str, Any], bytes]:
    """Split into the JSON document and the binary part."""
    if not data.startswith(b"subt"):
        return glb.json_object(data), b""
    if len(data) < _HEADER.size:
        raise UnusableError(f"it ends within its header of {_HEADER.size} bytes")
    _, version, text, rest = _HEADER.unpack_from(data)
    if version != 1:
        raise UnusableError(f"it is a subtree of version {version}, and only version 1 is read")
    if _HEADER.size + text + rest > len(data):
        raise UnusableError(f"it states {_HEADER.size + text + rest} bytes, and has {len(data)}")
    start = _HEADER.size + text
    return glb.json_object(data[_HEADER.size : start]), data[start : start + rest]


class _Views:
    """Buffers and buffer views of a subtree's document."""

    def __init__(self, document: dict[str, Any], binary: bytes, load: Callable[[str], bytes]) -> None:
        self._buffers = values.items("buffers", document.get("buffers", []))
        self._views = values.items("bufferViews", document.get("bufferViews", []))
        self._binary, self._load = binary, load
        self._loaded: dict[int, bytes] = {}

    def bits(self, place: str, described: Any, count: int) -> Bits:
        """Read an availability entry."""
        described = values.entries(place, described)
        if "constant" in described:
            return Bits(count, None, bool(values.whole(f"{place}.constant", described["constant"], 0, 1)))
        number = described.get("bitstream", described.get("bufferView"))
        data = self.view(f"{place}.bitstream", number)
        if 8 * len(data) < count:
            raise UnusableError(f"{place}: expected {count} bits, got {8 * len(data)}")
        bits = Bits(count, data)
        stated = described.get("availableCount")
        if stated is not None and count <= _CHECKED and stated != (found := int(bits.unpacked().sum())):
            raise UnusableError(f"{place}: it states {check.shortened(stated)} as available, and its bits {found}")
        return bits

    def view(self, place: str, number: Any) -> bytes:
        """Bytes of a buffer view that an entry refers to."""
        return self._bytes(f"bufferViews[{number}]", values.entries(place, _item(place, self._views, number)))

    def _bytes(self, place: str, view: dict[str, Any]) -> bytes:
        number = view.get("buffer")
        buffer = values.entries(place, _item(f"{place}.buffer", self._buffers, number))
        assert isinstance(number, int)
        if number not in self._loaded:
            uri = buffer.get("uri")
            self._loaded[number] = self._binary if uri is None else self._load(values.text(f"{place}.uri", uri))
        data = self._loaded[number]
        start = values.whole(f"{place}.byteOffset", view.get("byteOffset", 0), 0, len(data))
        length = values.whole(f"{place}.byteLength", view.get("byteLength"), 0, len(data) - start)
        return data[start : start + length]


def _item(place: str, listed: list[Any], number: Any) -> Any:
    if type(number) is not int or not 0 <= number < len(listed):
        raise UnusableError(f"{place}: expected the number of one of {len(listed)}, got {check.shortened(number)}")
    return listed[number]


def _check(subtree: Subtree, axes: int, levels: int) -> None:
    """Reject tiles without a parent, and contents and subtrees without a tile: no traversal would find them."""
    if subtree.tiles.count > _CHECKED or (subtree.tiles.stored is None and subtree.tiles.constant):
        return
    tiles = subtree.tiles.unpacked()
    starts = [start_of(level, axes) for level in range(levels + 1)]
    for level in range(1, levels):
        parents, here = tiles[starts[level - 1] : starts[level]], tiles[starts[level] : starts[level + 1]]
        _refuse(here & ~np.repeat(parents, 1 << axes), f"tile {{}} of its level {level}", "its parent")
    for bits in subtree.contents:
        if bits.stored is not None:
            _refuse(bits.unpacked() & ~tiles, "the content of tile {}", "the tile")
    if subtree.children.stored is not None:
        parents = tiles[starts[levels - 1] :]
        _refuse(subtree.children.unpacked() & ~np.repeat(parents, 1 << axes), "subtree {}", "the tile above it")


def _refuse(wrong: np.ndarray[Any, np.dtype[np.bool_]], thing: str, other: str) -> None:
    if wrong.any():
        raise UnusableError(f"its bits say that {thing.format(int(wrong.argmax()))} is there, but not {other}")
