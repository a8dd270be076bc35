"""Reads chunks of views and geometry files, each from the newest generation that has it."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

from nearfar._base.errors import UnusableError
from nearfar._base.recent import Recent
from nearfar.orthoview import _shard
from nearfar.orthoview._files import ByteRange, Files
from nearfar.orthoview._grid import Place
from nearfar.orthoview._index import ABSENT, Index, ShardEntry, unpack_index
from nearfar.orthoview._layout import Key, Layout

MAX_INDEXES = 2048
"""Maximum number of cached shard indexes, 8 kB each at most."""


@dataclass(frozen=True)
class Generation:
    """A generation of a store: a folder of shards."""

    folder: str
    """Path below the store with a trailing slash; empty for the store itself."""
    shard: Callable[[str], ShardEntry | None]
    """Returns the recorded entry of a shard, by its path below the folder; None if the generation lacks the shard."""
    has_geometry: Callable[[str], bool]
    """Whether the generation has a geometry file, by its path below the folder."""


class Chunks:
    """Reads chunks of a store; `generations` are listed newest first. Thread-safe."""

    def __init__(self, files: Files, layout: Layout, generations: Sequence[Generation]) -> None:
        self._files, self._layout, self._generations = files, layout, generations
        self._indexes: Recent[str, Index | None] = Recent()
        self._lock = threading.Lock()

    def __reduce__(self) -> tuple[type[Chunks], tuple[Files, Layout, Sequence[Generation]]]:
        """Pickle without the cached indexes."""
        return Chunks, (self._files, self._layout, self._generations)

    def read(self, keys: Sequence[Key]) -> list[bytes | None]:
        """Read chunks; None for missing ones.

        Raises UnusableError for a shard that is gone or ends too early, OSError for one that cannot be read.
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
            if generation.has_geometry(name):
                content = self._files.read(generation.folder + name)
                if content is None:
                    raise UnusableError(f"{generation.folder}{name}: the file is gone")
                return content or None
        return None

    def has_geometry(self, name: str) -> bool:
        """Whether any generation has a geometry file."""
        return any(generation.has_geometry(name) for generation in self._generations)

    def lengths(self, keys: Sequence[Key]) -> list[int]:
        """Lengths of chunks, bytes; 0 for missing ones."""
        return [0 if byte_range is None else byte_range[2] for byte_range in self.locate(keys)]

    def locate(self, keys: Sequence[Key]) -> list[ByteRange | None]:
        """Byte ranges of chunks in files; None for missing ones."""
        ranges: dict[Key, ByteRange | None] = {}
        with self._lock:  # other threads must not evict indexes meanwhile
            for generation in self._generations:
                paths = {key: self._layout.shard_path(key) for key in keys if key not in ranges}
                for key, path in paths.items():
                    index = self._index(generation, path, self._layout.shard_side(key[0]))
                    if index is None:
                        continue
                    first, length = (int(number) for number in index[self._layout.shard_of(*key[:2])[1]])
                    if first != ABSENT:
                        ranges[key] = ByteRange(generation.folder + path, first, length) if length else None
            self._indexes.trim((), MAX_INDEXES)
        return [ranges.get(key) for key in keys]

    def _index(self, generation: Generation, path: str, side: int) -> Index | None:
        """Return the index of a shard of side³ chunks; None if the generation lacks the shard."""
        name = generation.folder + path
        if name not in self._indexes:
            listed = generation.shard(path)
            self._indexes.put(name, None if listed is None else unpack_index(name, listed.chunks, side))
        return self._indexes.get(name)
