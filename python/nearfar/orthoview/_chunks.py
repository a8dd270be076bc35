"""Chunks of a complete store, each from the newest generation that has it."""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Callable, Container, Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nearfar._base.errors import UnusableError
from nearfar.orthoview import _shard
from nearfar.orthoview._files import Files
from nearfar.orthoview._layout import Key, Layout

MAX_INDEXES = 2048
"""Maximum number of cached shard indexes, 8 kB each at most."""


@dataclass(frozen=True)
class Generation:
    """A generation of a store: a folder of shards."""

    folder: str
    """Path below the store with a trailing slash; empty for the store itself."""
    shards: Container[str] | None
    """Paths of its shards below the folder; None if unknown, so that each is looked up in the folder."""
    geometry: Container[str] | None
    """Paths of its geometry files, likewise."""


@dataclass(frozen=True)
class In:
    """Container of the paths that satisfy a predicate."""

    has: Callable[[str], bool]

    def __contains__(self, path: object) -> bool:
        return isinstance(path, str) and self.has(path)


@dataclass(frozen=True)
class _Found:
    """Byte range of a chunk in a file."""

    file: str
    first: int
    length: int


class Chunks:
    """Reads chunks of a store; thread-safe.

    Parameters
    ----------
    files
        Files of the store.
    layout
        Layout of the tree.
    generations
        Generations, the newest one first.
    """

    def __init__(self, files: Files, layout: Layout, generations: Sequence[Generation]) -> None:
        self._files, self._layout, self._generations = files, layout, generations
        self._indexes: OrderedDict[str, NDArray[np.uint64] | None] = OrderedDict()
        self._lock = threading.Lock()

    def __reduce__(self) -> tuple[type[Chunks], tuple[Files, Layout, Sequence[Generation]]]:
        """Pickle without the cached indexes."""
        return Chunks, (self._files, self._layout, self._generations)

    def read(self, keys: Sequence[Key]) -> list[bytes | None]:
        """Read chunks; None for missing ones.

        Raises
        ------
        UnusableError
            A shard that ends too early, or whose index is damaged.
        OSError
            A shard that cannot be read.
        """
        found = self._locate(keys)
        there = {key: place for key, place in zip(keys, found, strict=True) if place is not None}
        parts = self._files.parts([(place.file, place.first, place.length) for place in there.values()])
        chunks = {
            key: _shard.complete(place.file, part or b"", place.first, place.length)
            for (key, place), part in zip(there.items(), parts, strict=True)
        }
        return [chunks.get(key) for key in keys]

    def geometry(self, name: str) -> bytes | None:
        """Read a geometry file; None if it does not exist, or if an update removed it."""
        for generation in self._generations:
            if generation.geometry is None or name in generation.geometry:
                content = self._files.whole(generation.folder + name)
                if content is None and generation.geometry is not None:
                    raise UnusableError(f"{generation.folder}{name}: the file is gone")
                return content or None
        return None

    def has_geometry(self, name: str) -> bool:
        """Whether any generation has, or may have, a geometry file."""
        return any(generation.geometry is None or name in generation.geometry for generation in self._generations)

    def lengths(self, keys: Sequence[Key]) -> list[int]:
        """Lengths of chunks, bytes; 0 for missing ones."""
        return [0 if place is None else place.length for place in self._locate(keys)]

    def _locate(self, keys: Sequence[Key]) -> list[_Found | None]:
        with self._lock:
            return self._look_up(keys)

    def _look_up(self, keys: Sequence[Key]) -> list[_Found | None]:
        found: dict[Key, _Found | None] = {}
        for generation in self._generations:
            missing = {key: self._shard(generation, key) for key in keys if key not in found}
            self._load({name: self._layout.shard_side(key[0]) for key, name in missing.items() if name})
            for key, name in missing.items():
                index = self._indexes[name] if name else None
                if name and index is None and generation.shards is not None:
                    raise UnusableError(f"{name}: the shard is gone")
                if name is None or index is None:
                    continue
                first, length = (int(number) for number in index[self._layout.shard_of(*key[:2])[1]])
                if first != _shard.ABSENT:
                    found[key] = _Found(name, first, length) if length else None
        while len(self._indexes) > MAX_INDEXES:
            self._indexes.popitem(last=False)
        return [found.get(key) for key in keys]

    def _shard(self, generation: Generation, key: Key) -> str | None:
        level, place, array = key
        path = self._layout.shard_path(array, self._layout.shard_of(level, place)[0]).as_posix()
        return generation.folder + path if generation.shards is None or path in generation.shards else None

    def _load(self, sides: dict[str, int]) -> None:
        """Read the shard indexes that are not cached, in one batch of requests."""
        wanted = {name: side for name, side in sides.items() if name not in self._indexes}
        for name in sides.keys() - wanted.keys():
            self._indexes.move_to_end(name)
        parts: Iterable[bytes | None] = self._files.parts(
            [(name, -_shard.index_length(side), _shard.index_length(side)) for name, side in wanted.items()]
        )
        for (name, side), end in zip(wanted.items(), parts, strict=True):
            self._indexes[name] = None if end is None else _shard.index_of(f"{self._files.place}/{name}", end, side)
