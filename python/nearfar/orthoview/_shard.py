"""Shards: files of Zarr's codec `sharding_indexed`, written chunk by chunk.

A shard consists of the chunks of some cells in the order in which they were written, and an index: first byte and
length of each chunk as little-endian uint64, both 2⁶⁴ − 1 for a missing chunk, then the index's CRC32C. So a chunk is
written once, when its cell is finished, to its final place.

A chunk of length 0, which Zarr does not know, marks in an overlay that an older generation's chunk has been removed.
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nearfar._base.errors import UnusableError
from nearfar.orthoview._files import Part
from nearfar.orthoview._grid import Place
from nearfar.orthoview._journal import Chunk

ABSENT = (1 << 64) - 1
"""First byte and length of a missing chunk."""

PART = ".part"
"""Suffix of an unfinished shard."""

_CHECKSUM = 4
_PIECE = 1 << 20


class ShardWriter:
    """Appends chunks to a shard, and finishes it with its index. No file stays open between calls.

    Parameters
    ----------
    path
        Path of the shard; until the index is written it has the suffix `PART`.
    side
        Number of chunks along each axis of the grid.
    chunks
        Places and chunks that an earlier writer finished; any bytes after them in the file are dropped.
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
        # A finished shard already has its final name while other cells of the subtree are missing.
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
            return complete(file.read(length), (str(self._path), start, length))

    def finish(self) -> tuple[int, str]:
        """Write the index and rename the file; return its size and the SHA-256 of its bytes."""
        import google_crc32c  # imported here: `import nearfar` does not need it

        index = self._index.tobytes()
        self._write(index + google_crc32c.value(index).to_bytes(_CHECKSUM, "little"), sync=True)
        os.replace(self._part, self._path)
        return self._size, self._hash.hexdigest()


def holds(path: Path, size: int) -> bool:
    """Whether a shard, finished or not, has at least `size` bytes."""
    part = path.with_name(path.name + PART)
    found = part if part.exists() else path
    return found.exists() and found.stat().st_size >= size


def index_length(side: int) -> int:
    """Bytes of the index at the end of a shard with `side` chunks along each axis."""
    return side**3 * 2 * 8 + _CHECKSUM


def index_of(name: str, end: bytes, side: int) -> NDArray[np.uint64]:
    """First bytes and lengths (side, side, side, 2) of a shard's chunks, from the end of its file.

    Raises UnusableError for a file that is too short, or an index with a wrong checksum.
    """
    import google_crc32c

    if len(end) < index_length(side):
        raise UnusableError(f"{name}: expected a shard of at least {index_length(side)} bytes, got {len(end)}")
    index, checksum = end[:-_CHECKSUM], end[-_CHECKSUM:]
    if google_crc32c.value(index) != int.from_bytes(checksum, "little"):
        raise UnusableError(f"{name}: the checksum of the shard's index is wrong")
    return np.frombuffer(index, "<u8").reshape(side, side, side, 2)


def complete(chunk: bytes | None, part: Part) -> bytes:
    """Return a chunk; UnusableError if it is missing, or shorter than the shard's index says."""
    (name, start, length), chunk = part, chunk or b""
    if len(chunk) < length:
        raise UnusableError(f"{name}: expected {length} bytes at {start}, got {len(chunk)}")
    return chunk
