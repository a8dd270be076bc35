"""Presence masks: the directions from which each cell of a subtree shows something, as records list them."""

from __future__ import annotations

import base64
import math
import zlib
from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from nearfar._base.errors import UnusableError
from nearfar.orthoview._grid import Place
from nearfar.orthoview._layout import Chunk, Key, Layout

UNCHANGED = 1 << 31
"""Mask of a cell that an update did not change: older generations have its mask."""

UNBUILT = 1 << 29
"""Mask of a cell that an unfinished build has not reached, nor any cell below it."""

PARTIAL = 1 << 30
"""Mask of a cell whose views an unfinished build has not composed yet, though cells below it may have views."""

Masks = list[NDArray[np.uint32]]
"""Masks (X, Y, Z) for each level of a subtree, lowest first: bit D is set if direction D shows something."""


class Presence:
    """Masks of a subtree's cells, and counts of its chunks; masks begin as `value`: 0 for empty, or `UNCHANGED`."""

    def __init__(self, layout: Layout, tier: int, value: int = 0) -> None:
        self._layout, self._lowest = layout, tier * layout.subtree
        self._masks = [np.full(shape, value, np.uint32) for shape in shapes(layout, tier)]
        self._cells: set[tuple[int, Place]] = set()
        self._chunks, self._bytes = 0, 0

    def mark(self, level: int, place: Place, mask: int) -> None:
        """Set the mask of a cell without chunks: 0, `UNBUILT` or `PARTIAL`."""
        _, place_in_shard = self._layout.shard_of(level, place)
        self._masks[level - self._lowest][place_in_shard] = mask

    def add_cell(self, level: int, place: Place, chunks: Mapping[str, Chunk]) -> None:
        """Record a computed cell and its chunks by array."""
        self.mark(level, place, 0)
        for array, (_, length) in chunks.items():
            self.add((level, place, array), length)

    def add(self, key: Key, length: int) -> None:
        """Record a chunk of a computed cell; length 0 means that it is missing."""
        if not length:
            return
        level, place, array = key
        self._cells.add((level, place))
        self._chunks, self._bytes = self._chunks + 1, self._bytes + length
        _, place_in_shard = self._layout.shard_of(level, place)
        number = self._layout.names.index(array.rpartition("/")[2])
        self._masks[level - self._lowest][place_in_shard] |= np.uint32(1 << number)

    def counts(self) -> dict[str, int]:
        """Numbers of cells and leaves that are not empty, of their chunks and of the chunks' bytes."""
        leaves = sum(level == 0 for level, _ in self._cells)
        return {"cells": len(self._cells), "leaves": leaves, "chunks": self._chunks, "bytes": self._bytes}

    def to_json(self) -> list[str]:
        """Encode the masks as JSON."""
        return [pack(mask.astype("<u4").tobytes()) for mask in self._masks]


def pack(data: bytes) -> str:
    """Encode bytes as text: base64 of zlib."""
    return base64.b64encode(zlib.compress(data, 9)).decode()


def unpack(name: str, text: str, limit: int) -> bytes:
    """Decode text that `pack` returned for at most `limit` bytes; damaged text might decode to any number of bytes.

    Raises UnusableError for damaged text; the message begins with `name`.
    """
    stream = zlib.decompressobj()
    try:
        content = stream.decompress(base64.b64decode(text, validate=True), limit)
    except (ValueError, zlib.error) as error:
        raise UnusableError(f"{name}: {error}") from None
    if not stream.eof or stream.unused_data:  # zlib compares its checksum at the end
        raise UnusableError(f"{name}: expected the compressed bytes to end after their content")
    return content


def shapes(layout: Layout, tier: int) -> list[tuple[int, int, int]]:
    """Numbers of cells of a subtree's levels along each axis, lowest level first."""
    lowest = tier * layout.subtree
    levels = range(lowest, min(lowest + layout.subtree, layout.grid.levels))
    return [(side, side, side) for side in map(layout.shard_side, levels)]


def masks_of(described: Sequence[str], layout: Layout, tier: int) -> Masks:
    """Decode the masks that `Presence.to_json` returned; UnusableError if they are invalid."""
    expected = shapes(layout, tier)
    if len(described) != len(expected):
        raise UnusableError(f"expected views of {len(expected)} levels, got {len(described)}")
    masks = [_mask(text, shape) for text, shape in zip(described, expected, strict=True)]
    special = np.array([UNCHANGED, UNBUILT, PARTIAL], np.uint32)
    if any(((mask >= 1 << len(layout.directions)) & ~np.isin(mask, special)).any() for mask in masks):
        raise UnusableError(f"views: expected bits of {len(layout.directions)} directions")
    return masks


def _mask(text: str, shape: tuple[int, int, int]) -> NDArray[np.uint32]:
    size = 4 * math.prod(shape)
    content = unpack("views", text, size + 1)
    if len(content) != size:
        raise UnusableError(f"views: expected {size} bytes, got {len(content)}")
    return np.frombuffer(content, "<u4").reshape(shape).astype(np.uint32)


def newest_of(generations: Sequence[Masks], layout: Layout, tier: int, unknown: int = 0) -> Masks:
    """Merge masks of generations, newest first: a cell's first mask that is not `UNCHANGED`, or `unknown`."""
    merged = [np.full(shape, UNCHANGED, np.uint32) for shape in shapes(layout, tier)]
    for masks in generations:
        for mask, newer in zip(merged, masks, strict=True):
            np.copyto(mask, newer, where=mask == UNCHANGED)
    for mask in merged:
        mask[mask == UNCHANGED] = unknown
    return merged
