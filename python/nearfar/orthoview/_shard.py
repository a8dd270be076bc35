"""Shards, files of Zarr's codec `sharding_indexed` that are written chunk by chunk, and a journal of written cells.

A shard consists of the chunks of some cells, in the order in which they were written, and an index: first byte and
length of each chunk as little-endian uint64, both 2⁶⁴ − 1 for a missing chunk, then the index's CRC32C. So a chunk is
written only once, as soon as its cell is finished.

In shards of an update, a chunk of length 0, which Zarr does not know, removes the chunk of older generations.
"""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

from nearfar._base.errors import UnusableError
from nearfar.orthoview._files import ByteRange
from nearfar.orthoview._grid import Place
from nearfar.orthoview._index import ABSENT, Index, ShardEntry, pack_index
from nearfar.orthoview._layout import Chunk, Layout

PART = ".part"
"""Suffix of an unfinished shard."""

CHECKSUM_BYTES = 4
_PIECE = 1 << 20


class ShardWriter:
    """Appends chunks to a shard of side³ chunks, and finishes it with its index. No file stays open between calls.

    Until the index is written, the file has the suffix `PART`. `chunks` are the chunks that an interrupted writer
    finished, with their places; the bytes after them in the file are dropped.
    """

    def __init__(self, path: Path, side: int, chunks: Iterable[tuple[Place, Chunk]] = ()) -> None:
        self._path, self._part = path, path.with_name(path.name + PART)
        earlier = list(chunks)
        self._index = index_of_chunks(side, earlier)
        self._hash = hashlib.sha256()
        self._size = max((start + length for _, (start, length) in earlier), default=0)
        if self._size:
            self._resume()

    def _resume(self) -> None:
        # A shard may have been finished, and thus renamed, before its subtree was complete.
        if not self._part.exists():
            os.replace(self._path, self._part)
        os.truncate(self._part, self._size)
        with self._part.open("rb") as file:
            while piece := file.read(_PIECE):
                self._hash.update(piece)

    def append(self, place: Place, chunk: bytes) -> Chunk:
        """Write a chunk; return its first byte and its length."""
        start = self._size
        self._write(chunk, sync=False)
        self._index[place] = start, len(chunk)
        return start, len(chunk)

    def _write(self, data: bytes, *, sync: bool) -> None:
        if not self._size:
            self._part.parent.mkdir(parents=True, exist_ok=True)
        with self._part.open("r+b" if self._size else "wb") as file:
            file.seek(self._size)
            file.write(data)
            if sync:
                file.flush()
                os.fsync(file.fileno())
        self._hash.update(data)
        self._size += len(data)

    def read(self, place: Place) -> bytes | None:
        """Read a chunk back, for a build that resumes; None if it is missing."""
        start, length = (int(number) for number in self._index[place])
        if start == ABSENT:
            return None
        with self._part.open("rb") as file:
            file.seek(start)
            return check_complete(file.read(length), ByteRange(str(self._path), start, length))

    def finish(self) -> ShardEntry:
        """Write the index and rename the file; return its entry for the record."""
        self._write(index_bytes(self._index), sync=True)
        os.replace(self._part, self._path)
        return ShardEntry(self._size, self._hash.hexdigest(), pack_index(self._index))


def checksum(data: bytes) -> bytes:
    """CRC32C of bytes, as Zarr's codec `crc32c` appends it."""
    import google_crc32c  # imported here: `import nearfar` does not need it

    return int(google_crc32c.value(data)).to_bytes(CHECKSUM_BYTES, "little")


def index_of_chunks(side: int, chunks: Iterable[tuple[Place, Chunk]]) -> Index:
    """Index of a shard of side³ chunks, from the places and byte ranges of the existing ones."""
    index = np.full((side, side, side, 2), ABSENT, "<u8")
    for place, chunk in chunks:
        index[place] = chunk
    return index


def index_bytes(index: Index) -> bytes:
    """Encode the index at the end of a shard."""
    data = index.tobytes()
    return data + checksum(data)


def has_bytes(path: Path, size: int) -> bool:
    """Whether the file of a finished or unfinished shard has at least `size` bytes."""
    part = path.with_name(path.name + PART)
    file = part if part.exists() else path
    return file.exists() and file.stat().st_size >= size


def check_complete(chunk: bytes | None, listed: ByteRange) -> bytes:
    """Return a chunk; UnusableError if its shard is missing, or ends before the end of the chunk."""
    name, start, length = listed
    if chunk is None:
        raise UnusableError(f"{name}: the shard is gone")
    if len(chunk) < length:
        raise UnusableError(f"{name}: expected {length} bytes at {start}, got {len(chunk)}")
    return chunk


class Journal:
    """Finished cells, each with the byte ranges of its chunks by array name.

    With `is_writer` False the file is not changed, since another process may be writing it.
    """

    def __init__(self, path: Path, *, is_writer: bool = True) -> None:
        self._path = path
        self.cells: dict[tuple[int, Place], dict[str, Chunk]] = {}
        self.guests: dict[Place, list[Place]] = {}
        """Guests of finished leaves, without leaves that have none."""
        self.failed: dict[Place, str] = {}
        """Reasons why leaves are incomplete; a build that resumes repeats them."""
        if path.exists():
            valid_bytes = self._read()
            if is_writer:
                os.truncate(path, valid_bytes)

    def _read(self) -> int:
        """Read up to the first invalid line, which a killed writer leaves; return the valid lines' size in bytes."""
        valid_bytes = 0
        for line in self._path.read_bytes().splitlines(keepends=True):
            try:
                self._apply(json.loads(line if line.endswith(b"\n") else b""))
            except (KeyError, TypeError, ValueError):
                break
            valid_bytes += len(line)
        return valid_bytes

    def _apply(self, entry: dict[str, Any]) -> None:
        x, y, z = entry["place"]
        if "failed" in entry:
            self.failed[x, y, z] = str(entry["failed"])
            return
        if entry["level"] == 0:
            self.failed.pop((x, y, z), None)
        chunks = {str(array): (int(start), int(length)) for array, (start, length) in entry["chunks"].items()}
        self.cells[entry["level"], (x, y, z)] = chunks
        if guests := [(u, v, w) for u, v, w in entry.get("guests", [])]:
            self.guests[x, y, z] = guests

    def add(self, level: int, place: Place, chunks: dict[str, Chunk], guests: list[Place]) -> None:
        """Record a finished cell and its guests; call this after its chunks have been written."""
        self._write({"level": level, "place": place, "chunks": chunks} | ({"guests": guests} if guests else {}))

    def add_failed(self, leaf: Place, reason: str) -> None:
        """Record why a leaf is incomplete."""
        self._write({"level": 0, "place": leaf, "failed": reason})

    def _write(self, entry: dict[str, Any]) -> None:
        self._path.parent.mkdir(parents=True, exist_ok=True)
        with self._path.open("ab") as file:
            file.write(json.dumps(entry, separators=(",", ":")).encode() + b"\n")
        self._apply(entry)

    def chunks_of(self, array: str, layout: Layout) -> Iterator[tuple[Place, Chunk]]:
        """Chunks of an array, each with its cell's place in the shard."""
        for (level, place), chunks in self.cells.items():
            if array in chunks:
                yield layout.shard_of(level, place)[1], chunks[array]

    def sizes(self) -> dict[tuple[int, Place, str], int]:
        """Least size of each shard, bytes, by the key of one of its chunks."""
        ends: dict[str, tuple[int, Place, int]] = {}
        for (level, place), chunks in self.cells.items():
            for array, (start, length) in chunks.items():
                _, _, end = ends.get(array, (level, place, 0))
                ends[array] = level, place, max(end, start + length)
        return {(level, place, array): size for array, (level, place, size) in ends.items()}

    def empty_leaves(self) -> int:
        """Number of finished leaves that show nothing."""
        return sum(level == 0 and not chunks for (level, _), chunks in self.cells.items())

    def remove(self) -> None:
        """Forget all cells and delete the file."""
        self.cells.clear()
        self.guests.clear()
        self.failed.clear()
        self._path.unlink(missing_ok=True)
