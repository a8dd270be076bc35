"""Shards: files of Zarr's codec `sharding_indexed`, written chunk by chunk.

A shard is the chunks of some cells, one after the other in the order in which they came, and an index: first byte and
length of each chunk as little-endian uint64, both 2⁶⁴ − 1 for a chunk that is not there, and the index's CRC32C. So a
chunk is written once, when its cell is done, and lies in its final place.
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nearfar._base.errors import UnusableError
from nearfar.orthoview._grid import Place
from nearfar.orthoview._journal import Chunk

ABSENT = (1 << 64) - 1
"""First byte and length of a chunk that is not there."""

PART = ".part"
"""Suffix of a shard that still grows."""

_CHECKSUM = 4
_PIECE = 1 << 20


class ShardWriter:
    """Appends chunks to a shard, and ends it with its index. Between two calls no file is open.

    Parameters
    ----------
    path
        The shard's file; until it has its index it has the suffix `PART`.
    side
        Number of its chunks along each axis of the grid.
    chunks
        Places and chunks that an earlier writer finished; what follows them in the file is dropped.
    """

    def __init__(self, path: Path, side: int, chunks: Iterable[tuple[Place, Chunk]] = ()) -> None:
        self._path, self._part = path, path.with_name(path.name + PART)
        self._index = np.full((side, side, side, 2), ABSENT, "<u8")
        self._hash = hashlib.sha256()
        self._size = 0
        for place, (start, length) in chunks:
            self._index[place] = start, length
            self._size = max(self._size, start + length)
        if self._size:
            self._resume()

    def _resume(self) -> None:
        # A shard of cells that are there has its name while other cells of the subtree are missing.
        if not self._part.exists():
            os.replace(self._path, self._part)
        os.truncate(self._part, self._size)
        with self._part.open("rb") as file:
            while piece := file.read(_PIECE):
                self._hash.update(piece)

    def append(self, place: Place, chunk: bytes) -> Chunk:
        """Write a chunk; returns its first byte and its length."""
        start = self._size
        self._write(chunk, sync=False)
        self._index[place] = start, len(chunk)
        return start, len(chunk)

    def _write(self, data: bytes, *, sync: bool) -> None:
        if not self._size:
            self._part.parent.mkdir(parents=True, exist_ok=True)
        with self._part.open("r+b" if self._size else "wb", buffering=0) as file:
            file.seek(self._size)
            rest = memoryview(data)
            while rest:
                rest = rest[file.write(rest) :]
            if sync:
                os.fsync(file.fileno())
        self._hash.update(data)
        self._size += len(data)

    def read(self, place: Place) -> bytes | None:
        """Read a chunk again, for work that was interrupted; None for one that is not there."""
        return _chunk(self._part, self._index, place)

    def finish(self) -> tuple[int, str]:
        """Write the index and give the file its name; returns its size and the SHA-256 of its bytes."""
        import google_crc32c  # `import nearfar` does without it

        index = self._index.tobytes()
        self._write(index + google_crc32c.value(index).to_bytes(_CHECKSUM, "little"), sync=True)
        os.replace(self._part, self._path)
        return self._size, self._hash.hexdigest()


def holds(path: Path, size: int) -> bool:
    """Whether a shard, growing or complete, has at least so many bytes."""
    part = path.with_name(path.name + PART)
    found = part if part.exists() else path
    return found.exists() and found.stat().st_size >= size


def read_chunk(path: Path, side: int, place: Place) -> bytes | None:
    """Read a chunk of a complete shard; None for one that is not there.

    Raises
    ------
    UnusableError
        A file that ends too early, or whose index has another checksum.
    OSError
        One that cannot be read.
    """
    return _chunk(path, _read_index(path, side), place)


def _read_index(path: Path, side: int) -> NDArray[np.uint64]:
    """First bytes and lengths (side, side, side, 2) of a complete shard's chunks."""
    import google_crc32c

    length = side**3 * 2 * 8
    with path.open("rb") as file:
        size = file.seek(0, os.SEEK_END)
        if size < length + _CHECKSUM:
            raise UnusableError(f"{path}: expected a shard of at least {length + _CHECKSUM} bytes, got {size}")
        file.seek(-length - _CHECKSUM, os.SEEK_END)
        index, checksum = file.read(length), file.read(_CHECKSUM)
    if google_crc32c.value(index) != int.from_bytes(checksum, "little"):
        raise UnusableError(f"{path}: the checksum of the shard's index is wrong")
    return np.frombuffer(index, "<u8").reshape(side, side, side, 2)


def _chunk(path: Path, index: NDArray[np.uint64], place: Place) -> bytes | None:
    start, length = (int(number) for number in index[place])
    if start == ABSENT:
        return None
    with path.open("rb") as file:
        file.seek(start)
        chunk = file.read(length)
    if len(chunk) < length:
        raise UnusableError(f"{path}: expected {length} bytes at {start}, got {len(chunk)}")
    return chunk
