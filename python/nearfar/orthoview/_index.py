"""Positions of chunks in their shards, as records list them: readers with records need not read the shards' indexes.

A shard's list has its chunks in file order: first the differences between successive cell numbers (z varies fastest),
then the chunks' lengths, all as uint32. Each chunk begins where its predecessor ends. The lowest bytes of all numbers
are stored first, then the second lowest and so on, which compresses better.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from nearfar._base.errors import UnusableError
from nearfar.orthoview._presence import pack, unpack

ABSENT = (1 << 64) - 1
"""First byte and length of a missing chunk."""

Index = NDArray[np.uint64]
"""First bytes and lengths (side, side, side, 2) of a shard's chunks."""


class ShardEntry(NamedTuple):
    """Entry of a shard in a record."""

    size: int
    digest: str
    """SHA-256 of the file."""
    chunks: str
    """Packed list of its chunks."""


def pack_index(index: Index) -> str:
    """Pack the list of a shard's chunks, which fill the shard from its first byte without gaps."""
    rows = index.reshape(-1, 2)
    (cells,) = np.nonzero(rows[:, 0] != ABSENT)
    # Sorted by first byte, then by length: an empty chunk precedes the chunk that begins at the same byte.
    cells = cells[np.lexsort((rows[cells, 1], rows[cells, 0]))]
    words = np.concatenate([np.diff(cells, prepend=0), rows[cells, 1].astype(np.int64)]).astype("<i8").astype("<u4")
    return pack(words.view(np.uint8).reshape(-1, 4).T.tobytes())


def unpack_index(name: str, packed: str, side: int) -> Index:
    """Unpack the list of a shard of side³ cells; UnusableError that names the shard for a damaged list."""
    count = side**3
    data = np.frombuffer(unpack(name, packed, 8 * count + 1), np.uint8)
    if len(data) % 8 or len(data) > 8 * count:
        raise UnusableError(f"{name}: expected chunks of at most {count} cells, got {len(data)} bytes")
    steps, lengths = np.ascontiguousarray(data.reshape(4, -1).T).view("<u4").reshape(2, -1)
    cells = np.cumsum(steps.astype(np.int32), dtype=np.int64)
    if len(np.unique(cells)) < len(cells) or (len(cells) and not 0 <= cells.min() <= cells.max() < count):
        raise UnusableError(f"{name}: expected chunks of different cells below {count}")
    index = np.full((count, 2), ABSENT, np.uint64)
    ends = np.cumsum(lengths, dtype=np.uint64)
    index[cells, 0], index[cells, 1] = ends - lengths, lengths
    return index.reshape(side, side, side, 2)
