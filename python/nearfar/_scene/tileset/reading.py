"""Reads the files of chosen tiles, caches their content, and places it in the scene's frame."""

from __future__ import annotations

import os
import threading
from collections import OrderedDict
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from nearfar._scene.budget import Budget, TooLargeError
from nearfar._scene.content import Content, Nodes
from nearfar._scene.materials import Materials
from nearfar._scene.reasons import sentence
from nearfar._scene.tileset.content import Reader, TileContent, join_contents
from nearfar._scene.tileset.files import Files, OutsideError, read_all
from nearfar._scene.tileset.frames import Floats
from nearfar._scene.tileset.tile import Tile

_AT_ONCE = 64
"""Number of files held in memory before they are decoded."""


class Key(NamedTuple):
    """A file together with how a tile uses it."""

    name: str
    """Path or URL."""
    up: str
    """Up axis of its glTF."""
    place: bytes
    """The tile's transform if the content depends on it; else empty."""


class ContentCache:
    """Cache of tiles' contents with a size limit, and reasons why others are unusable; thread-safe."""

    def __init__(self, most: float) -> None:
        self._most, self._held = most, 0
        self._contents: OrderedDict[Key, TileContent] = OrderedDict()
        self._lock = threading.Lock()
        self.failed: dict[Key, str] = {}
        """Reasons, phrased to follow a file's name."""

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle without contents: another process reads them itself."""
        return ContentCache, (self._most,)

    def find(self, key: Key) -> TileContent | None:
        """Content of a file; None if it is not cached."""
        with self._lock:
            for known in (key._replace(place=b""), key):
                if known in self._contents:
                    self._contents.move_to_end(known)
                    return self._contents[known]
            return None

    def keep(self, key: Key, content: TileContent) -> None:
        """Cache a content; the least recently used ones are evicted."""
        with self._lock:
            self._contents[key if content.depends_on_place else key._replace(place=b"")] = content
            self._held += content.nbytes
            while self._held > self._most and len(self._contents) > 1:
                self._held -= self._contents.popitem(last=False)[1].nbytes


class Reading:
    """Reads tiles for one result; `cache` has contents read before, and `budget` counts unpacked bytes of the files."""

    def __init__(self, files: Files, kept: ContentCache, budget: Budget) -> None:
        self._files, self._kept, self._budget = files, kept, budget
        self._reader = Reader(files, budget, Materials(budget))
        self._contents: dict[Key, TileContent] = {}
        self._failed: dict[Key, str] = {}
        self._known: dict[Tile, list[Key]] = {}

    def sizes(self, tiles: Sequence[Tile]) -> list[int | None]:
        """Numbers of triangles of tiles; None for tiles none of whose content can be read."""
        keys = [self._keys(tile) for tile in tiles]
        self._read({key: tile for tile, of_tile in zip(tiles, keys, strict=True) for key in of_tile})
        found: list[int | None] = []
        for of_tile in keys:
            good = [self._contents[key].triangles for key in of_tile if key in self._contents]
            found.append(sum(good) if good else None)
        return found

    def _keys(self, tile: Tile) -> list[Key]:
        if tile not in self._known:
            source, place = tile.source, tile.transform.tobytes()
            names = [self._files.resolve(source.name, uri) if uri else source.name for uri in tile.contents]
            self._known[tile] = [Key(name, source.up, place) for name in names]
        return self._known[tile]

    def _read(self, wanted: dict[Key, Tile]) -> None:
        missing: list[Key] = []
        for key in wanted:
            if key in self._contents or key in self._failed:
                continue
            kept = self._kept.find(key)
            if kept is not None:
                self._contents[key] = kept
            elif key in self._kept.failed:
                self._failed[key] = self._kept.failed[key]
            else:
                missing.append(key)
        for start in range(0, len(missing), _AT_ONCE):
            batch = missing[start : start + _AT_ONCE]
            files = read_all(self._files, list(dict.fromkeys(key.name for key in batch)), self._budget)
            for key in batch:
                self._decode(key, wanted[key], files[key.name])

    def _decode(self, key: Key, tile: Tile, data: bytes | OSError) -> None:
        # Another tile of this batch may use the same file.
        content = self._kept.find(key)
        reason = ""
        if content is None and isinstance(data, FileNotFoundError):
            reason = "is missing"
        elif content is None and isinstance(data, OSError):
            raise data
        elif content is None:
            assert isinstance(data, bytes)
            try:
                content = self._reader.read(key.name, data, key.up, tile.transform)
            except (TooLargeError, OutsideError) as error:
                raise type(error)(f"{self._files.display_name(key.name)}: {error}") from error
            except Exception as error:  # damage may raise anything
                reason = f"cannot be used: {sentence(error)}"
        if content is None:
            self._failed[key] = self._kept.failed[key] = reason
        else:
            self._contents[key] = content
            self._kept.keep(key, content)

    @property
    def failures(self) -> dict[str, str]:
        """Reasons by name for messages, for files that cannot be read."""
        return {self._files.display_name(key.name): reason for key, reason in self._failed.items()}

    def place_contents(self, tiles: Sequence[Tile], to_scene: Floats, label: str) -> tuple[Content, int]:
        """Content of tiles whose `sizes` were requested, and the number of files with feature properties.

        `to_scene` (4, 4) is the transform tileset→scene, `label` the tileset's name for messages.
        """
        parts: list[tuple[str, str, Content]] = []
        properties = 0
        for tile in tiles:
            for key in self._keys(tile):
                found = self._contents.get(key)
                if found is None:
                    continue
                nodes = found.content.nodes
                with np.errstate(over="ignore", invalid="ignore"):
                    placed = Nodes(nodes.objects, to_scene @ tile.transform @ nodes.transforms, nodes.shapes)
                name = self._files.display_name(key.name)
                content = Content(key.name, found.content.shapes, placed, found.content.notes)
                parts.append((os.path.splitext(name)[0], f"{name}#", content))
                properties += found.has_properties
        return join_contents(label, parts), properties
