"""Reads the files of chosen tiles, caches their content, and places it in the scene's frame."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from nearfar._base.recent import Recent
from nearfar._scene.budget import Budget, TooLargeError
from nearfar._scene.content import Content
from nearfar._scene.frames import Floats
from nearfar._scene.materials import Materials
from nearfar._scene.reasons import reason_of
from nearfar._scene.tileset.content import Reader, TileContent, join_contents
from nearfar._scene.tileset.files import Files, OutsideError, read_all
from nearfar._scene.tileset.tile import Tile

_FILES_AT_ONCE = 64
"""Number of files held in memory before they are decoded."""


class Key(NamedTuple):
    """A file together with how a tile uses it."""

    name: str
    """Path or URL."""
    up: str
    """Up axis of its glTF."""
    transform: bytes
    """The tile's transform if the content depends on it, else empty."""


class ContentCache:
    """Thread-safe cache of tiles' contents with a size limit, and of reasons why other contents are unusable."""

    def __init__(self, max_bytes: float) -> None:
        self._max_bytes = max_bytes
        self._contents: Recent[Key, TileContent] = Recent(lambda content: content.nbytes)
        self.failures: dict[Key, str] = {}
        """Reasons, phrased to follow a file's name."""

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle without contents: another process reads them itself."""
        return ContentCache, (self._max_bytes,)

    def find(self, key: Key) -> TileContent | None:
        """Content of a file; None if it is not cached."""
        return self._contents.get(key._replace(transform=b"")) or self._contents.get(key)

    def keep(self, key: Key, content: TileContent) -> None:
        """Cache a content; the least recently used ones are evicted."""
        stored_key = key if content.depends_on_place else key._replace(transform=b"")
        self._contents.put(stored_key, content)
        self._contents.trim((stored_key,), self._max_bytes)


class Reading:
    """Reads tiles for one result; `cache` has contents read earlier, and `budget` counts the files' unpacked bytes."""

    def __init__(self, files: Files, cache: ContentCache, budget: Budget) -> None:
        self._files, self._cache, self._budget = files, cache, budget
        self._reader = Reader(files, budget, Materials(budget))
        self._contents: dict[Key, TileContent] = {}
        self._failures: dict[Key, str] = {}
        self._keys_by_tile: dict[Tile, list[Key]] = {}

    def sizes(self, tiles: Sequence[Tile]) -> list[int | None]:
        """Number of triangles of each tile; None if all of its content is unreadable."""
        self._read({key: tile for tile in tiles for key in self._keys(tile)})
        sizes: list[int | None] = []
        for tile in tiles:
            counts = [self._contents[key].triangles for key in self._keys(tile) if key in self._contents]
            sizes.append(sum(counts) if counts else None)
        return sizes

    def _keys(self, tile: Tile) -> list[Key]:
        if tile not in self._keys_by_tile:
            source, transform = tile.source, tile.transform.tobytes()
            names = [self._files.resolve(source.name, uri) if uri else source.name for uri in tile.contents]
            self._keys_by_tile[tile] = [Key(name, source.up, transform) for name in names]
        return self._keys_by_tile[tile]

    def _read(self, tile_by_key: dict[Key, Tile]) -> None:
        unread: list[Key] = []
        for key in tile_by_key:
            if key in self._contents or key in self._failures:
                continue
            if (content := self._cache.find(key)) is not None:
                self._contents[key] = content
            elif key in self._cache.failures:
                self._failures[key] = self._cache.failures[key]
            else:
                unread.append(key)
        for start in range(0, len(unread), _FILES_AT_ONCE):
            batch = unread[start : start + _FILES_AT_ONCE]
            files = read_all(self._files, list(dict.fromkeys(key.name for key in batch)), self._budget)
            for key in batch:
                self._decode(key, tile_by_key[key], files[key.name])

    def _decode(self, key: Key, tile: Tile, data: bytes | OSError) -> None:
        # Another tile of this batch may use the same file.
        content = self._cache.find(key)
        if content is None:
            try:
                if isinstance(data, OSError):
                    raise data
                content = self._reader.read(key.name, data, key.up, tile.transform)
            except (TooLargeError, OutsideError) as error:
                raise type(error)(f"{self._files.display_name(key.name)}: {error}") from error
            except MemoryError:
                raise
            except Exception as error:  # damaged data may raise any type
                if error is data and not isinstance(error, FileNotFoundError):
                    raise
                reason = "is missing" if error is data else f"cannot be used: {reason_of(error)}"
                self._failures[key] = self._cache.failures[key] = reason
                return
        self._contents[key] = content
        self._cache.keep(key, content)

    @property
    def failures(self) -> dict[str, str]:
        """Reasons why files cannot be read, by the files' names in messages."""
        return {self._files.display_name(key.name): reason for key, reason in self._failures.items()}

    def place_contents(self, tiles: Sequence[Tile], to_scene: Floats, label: str) -> tuple[Content, int]:
        """Place the content of tiles whose `sizes` were read; also return the number of files with feature properties.

        `to_scene` (4, 4) is the transform tileset→scene, `label` the tileset's name for messages.
        """
        parts: list[tuple[str, str, Content]] = []
        property_count = 0
        pairs = [(tile, key) for tile in tiles for key in self._keys(tile) if key in self._contents]
        for tile, key in pairs:
            tile_content = self._contents[key]
            shapes, nodes = tile_content.content.shapes, tile_content.content.nodes
            with np.errstate(over="ignore", invalid="ignore"):
                nodes = replace(nodes, transforms=to_scene @ tile.transform @ nodes.transforms)
            name = self._files.display_name(key.name)
            content = Content(key.name, shapes, nodes, tile_content.content.notes)
            parts.append((os.path.splitext(name)[0], f"{name}#", content))
            property_count += tile_content.has_properties
        return join_contents(label, parts), property_count
