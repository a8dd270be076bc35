"""Chunks of a complete store, each from the newest generation that has it."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

from nearfar._base.errors import UnusableError
from nearfar._base.recent import Recent
from nearfar.orthoview import _shard
from nearfar.orthoview._files import ByteRange, Files
from nearfar.orthoview._grid import Place
from nearfar.orthoview._index import ABSENT, Index, ListedShard, unpack_index
from nearfar.orthoview._layout import Key, Layout

MAX_INDEXES = 2048
"""Maximum number of cached shard indexes, 8 kB each at most."""


@dataclass(frozen=True)
class Generation:
    """A generation of a store: a folder of shards."""

    folder: str
    """Path below the store with a trailing slash; empty for the store itself."""
    shard: Callable[[str], ListedShard | None] | None
    """Returns the entry of a shard, by path below the folder; None for a shard that it does not have. Without this
    function shards are unknown: each is looked up in the folder, and its index is read from its end."""
    has_geometry: Callable[[str], bool] | None
    """Whether it has a geometry file, likewise."""


UNLISTED = Generation("", None, None)
"""The first generation, if its files are unknown."""


class Chunks:
    """Reads chunks of a store, whose newest generation is the first one; thread-safe."""

    def __init__(self, files: Files, layout: Layout, generations: Sequence[Generation]) -> None:
        self._files, self._layout, self._generations = files, layout, generations
        self._indexes: Recent[str, Index | None] = Recent()
        self._lock = threading.Lock()

    def __reduce__(self) -> tuple[type[Chunks], tuple[Files, Layout, Sequence[Generation]]]:
        """Pickle without the cached indexes."""
        return Chunks, (self._files, self._layout, self._generations)

    def read(self, keys: Sequence[Key]) -> list[bytes | None]:
        """Read chunks; None for missing ones.

        Raises UnusableError for a shard that ends too early or whose index is damaged, OSError for one that cannot be
        read.
        """
        ranges = self.locate(keys)
        parts = iter(self._files.read_parts([byte_range for byte_range in ranges if byte_range is not None]))
        return [None if byte_range is None else _shard.check_complete(next(parts), byte_range) for byte_range in ranges]

    def read_views(self, level: int, place: Place, directions: Iterable[int] | None = None) -> dict[int, bytes]:
        """Read the chunks of a cell's views by direction number (default all), without missing ones."""
        keys = self._layout.keys(level, place, directions)
        chunks = zip(keys, self.read([*keys.values()]), strict=True)
        return {number: chunk for number, chunk in chunks if chunk}

    def geometry(self, name: str) -> bytes | None:
        """Read a geometry file; None if it does not exist, or if an update removed it."""
        for generation in self._generations:
            if generation.has_geometry is None or generation.has_geometry(name):
                content = self._files.read(generation.folder + name)
                if content is None and generation.has_geometry is not None:
                    raise UnusableError(f"{generation.folder}{name}: the file is gone")
                return content or None
        return None

    def has_geometry(self, name: str) -> bool:
        """Whether any generation has, or may have, a geometry file."""
        checks = (generation.has_geometry for generation in self._generations)
        return any(has_geometry is None or has_geometry(name) for has_geometry in checks)

    def lengths(self, keys: Sequence[Key]) -> list[int]:
        """Lengths of chunks, bytes; 0 for missing ones."""
        return [0 if byte_range is None else byte_range[2] for byte_range in self.locate(keys)]

    def locate(self, keys: Sequence[Key]) -> list[ByteRange | None]:
        """Byte ranges of chunks in files; None for missing ones."""
        ranges: dict[Key, ByteRange | None] = {}
        with self._lock:  # no other thread may evict indexes meanwhile
            for generation in self._generations:
                paths = {key: self._layout.shard_path(key) for key in keys if key not in ranges}
                self._load(generation, {path: self._layout.shard_side(key[0]) for key, path in paths.items()})
                for key, path in paths.items():
                    index = self._indexes.get(name := generation.folder + path)
                    if index is None:
                        continue
                    first, length = (int(number) for number in index[self._layout.shard_of(*key[:2])[1]])
                    if first != ABSENT:
                        ranges[key] = ByteRange(name, first, length) if length else None
            self._indexes.trim((), MAX_INDEXES)
        return [ranges.get(key) for key in keys]

    def _load(self, generation: Generation, sides: dict[str, int]) -> None:
        """Take the indexes of shards that are not cached from the records, or read them in one batch of requests."""
        sides = {path: side for path, side in sides.items() if generation.folder + path not in self._indexes}
        if generation.shard is not None:
            for path, side in sides.items():
                listed, name = generation.shard(path), generation.folder + path
                index = None if listed is None else unpack_index(name, listed.chunks, side)
                self._indexes.put(name, index)
            return
        lengths = {generation.folder + path: _shard.index_length(side) for path, side in sides.items()}
        parts = self._files.read_parts([ByteRange(name, -length, length) for name, length in lengths.items()])
        for name, side, end in zip(lengths, sides.values(), parts, strict=True):
            address = f"{self._files.address}/{name}"
            self._indexes.put(name, None if end is None else _shard.index_of(address, end, side))
