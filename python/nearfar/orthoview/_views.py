"""Reads views of a tree as splats, and caches the most recently used ones."""

from __future__ import annotations

import threading
from collections.abc import Callable, Container, Sequence
from functools import partial

from nearfar import _core
from nearfar._base import formats, side_by_side
from nearfar._base.errors import UnusableError
from nearfar._base.recent import Recent
from nearfar.orthoview import _codec
from nearfar.orthoview._chunks import Chunks
from nearfar.orthoview._grid import Place
from nearfar.orthoview._layout import Layout, ViewKey

Splats = tuple[_core.OrthoSplats, ...]
"""Splats of a view, layer by layer."""

_ASSUMED_SHARE = 0.125
"""Assumed share of non-empty pixels before any view has been read."""

_ALL_LEVELS = -1
"""Key of the totals over all levels."""

_BATCH = 64
"""Number of views whose chunks are read at once."""


class Views:
    """Reads views, and caches the most recently used ones: up to `max_bytes` bytes, or more if one picture needs them.

    Messages name the store by `address`, its folder or URL.
    """

    def __init__(self, address: str, chunks: Chunks, layout: Layout, max_bytes: int) -> None:
        self._address, self._chunks, self._layout, self._max_bytes = address, chunks, layout, max_bytes
        self.cache: Recent[ViewKey, Splats] = Recent(lambda layers: sum(layer.bytes for layer in layers))
        self._lock = threading.Lock()
        self._counts: dict[ViewKey, int] = {}
        self._totals: dict[int, tuple[int, int]] = {}

    def get(self, keys: Sequence[ViewKey]) -> list[_core.OrthoSplats]:
        """Return the splats of views, of both layers; read views that are not cached."""
        return [splats for layers in self.layers(keys) for splats in layers]

    def layers(self, keys: Sequence[ViewKey]) -> list[Splats]:
        """Return the splats of views, layer by layer; read views that are not cached."""
        self.load(keys)
        splats = [self.cached_layers(key) for key in keys]
        self.trim(set(keys))
        return splats

    def expected_count(self, key: ViewKey) -> float:
        """Number of a view's splats; for a view never read, the mean of its level or, failing that, of all views."""
        if key in self._counts:
            return self._counts[key]
        default = self._layout.size**2 * _ASSUMED_SHARE, 1
        total, views = self._totals.get(key[0]) or self._totals.get(_ALL_LEVELS) or default
        return total / views

    def is_counted(self, key: ViewKey) -> bool:
        """Whether a view has ever been read."""
        return key in self._counts

    def load(self, keys: Sequence[ViewKey]) -> None:
        """Read the views that are not cached; thread-safe."""
        missing = [key for key in keys if key not in self.cache]
        for start in range(0, len(missing), _BATCH):
            self._read(missing[start : start + _BATCH])

    def cached_layers(self, key: ViewKey) -> Splats:
        """Layers of a view, which becomes the most recently used; empty if it is not cached."""
        return self.cache.get(key) or ()

    def cached_directions(self, level: int, place: Place) -> frozenset[int]:
        """Directions of a cell's cached views, of any version."""
        keys = ((level, place, direction) for direction in range(len(self._layout.directions)))
        return frozenset(key[2] for key in keys if key in self.cache.values)

    def take_over(self, older: Views, changed: Callable[[ViewKey], bool]) -> None:
        """Take the cached views of an older generation; changed views are shown until they have been read again."""
        self.cache.take_over(older.cache, changed)
        for key, splats in self.cache.values.items():
            self._count(key, sum(layer.count for layer in splats))

    def trim(self, needed: Container[ViewKey]) -> None:
        """Evict the least recently used views, except needed ones, until the cache fits its size."""
        self.cache.trim(needed, self._max_bytes)

    def _read(self, keys: Sequence[ViewKey]) -> None:
        with formats.guarded(self._address, "orthoviews"):
            chunks = self._chunks.read([self._layout.key(key) for key in keys])
            jobs = [partial(self._decode, key, chunk) for key, chunk in zip(keys, chunks, strict=True)]
            decoded = side_by_side.results(jobs) if len(jobs) > 1 else (job() for job in jobs)
            for key, chunk, splats in zip(keys, chunks, decoded, strict=True):
                self.cache.put(key, splats)
                self.cache.count_bytes(len(chunk or b""))
                with self._lock:
                    self._count(key, sum(layer.count for layer in splats))

    def _count(self, key: ViewKey, splats: int) -> None:
        if key not in self._counts:
            self._counts[key] = splats
            for level in (key[0], _ALL_LEVELS):
                total, views = self._totals.get(level, (0, 0))
                self._totals[level] = total + splats, views + 1

    def _decode(self, key: ViewKey, chunk: bytes | None) -> Splats:
        """Decode the splats of a view by layer; UnusableError for a missing chunk."""
        level, place, direction = key
        if chunk is None:
            raise UnusableError(f"{self._layout.key(key)[2]}: the chunk of the cell {place} is missing")
        cell = self._layout.grid.corner(level, place), self._layout.grid.side(level)
        layers = _codec.decode({direction: chunk}, self._layout, (direction,))
        return tuple(_core.OrthoSplats(views, 0, bits, cell) for views, bits in layers)
