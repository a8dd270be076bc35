"""Copies a store's newest generation into a new store of plain Zarr; compares a store's files with its records."""

from __future__ import annotations

import hashlib
import os
import shutil
from collections import defaultdict
from contextlib import suppress
from pathlib import Path
from typing import Any

from nearfar._base import files, formats, progress
from nearfar._base.errors import FormatError
from nearfar.orthoview import _store
from nearfar.orthoview._files import Files, Local
from nearfar.orthoview._geometry_store import FOLDER as GEOMETRY, IMAGES, names
from nearfar.orthoview._grid import Place
from nearfar.orthoview._index import ShardEntry
from nearfar.orthoview._layout import FOLDER, Key, Layout, SubtreeKey
from nearfar.orthoview._presence import Presence
from nearfar.orthoview._record import (
    NO_HASH,
    Shards,
    list_geometry,
    record_document,
    record_of,
    write_record,
)
from nearfar.orthoview._shard import ShardWriter


def compact(store: Files, attributes: dict[str, Any], target: Path) -> None:
    """Write the newest generation of a complete store as a new store; see `OrthoTree.compact`."""
    layout, newest = Layout.from_json(attributes["layout"]), int(attributes["generation"])
    with _store.new_folder(target) as folder, progress.bar("compacting") as report:
        _store.create(folder, layout)
        (folder / FOLDER).mkdir()
        copy = _Copy(store, layout, newest, folder)
        subtrees = copy.subtrees()
        for done, (subtree, shards) in enumerate(subtrees.items()):
            report(done, len(subtrees))
            copy.write(subtree, shards)
        copy.images()
        _store.finish(folder, failed={}, done=attributes["done"])


_BATCH = 64
"""Number of chunks read at once."""


class _Copy:
    """Writes the newest generation of a store into a new store, subtree by subtree."""

    def __init__(self, store: Files, layout: Layout, newest: int, folder: Path) -> None:
        self._store, self._layout, self._folder = store, layout, folder
        self._chunks, self._read_cells = _store.open_generation(store, layout, newest)
        self._records = list(_store.folder_records(store, newest))
        self._size_and_digest = {
            path: (shard.size, shard.digest) for record in self._records for path, shard in record.shards.items()
        }
        self._geometry = self._newest_geometry()

    def subtrees(self) -> dict[SubtreeKey, dict[str, ShardEntry | None]]:
        """Return the shards of all subtrees by path, with their entries, or None for shards that updates changed."""
        subtrees: defaultdict[SubtreeKey, dict[str, ShardEntry | None]] = defaultdict(dict)
        for record in self._records:
            for path, shard in record.shards.items():
                subtrees[self._layout.subtree_of(path)][path] = None if record.folder else shard
            if not record.folder and record.name and not record.shards:  # an empty subtree
                tier, x, y, z = map(int, record.name.split("_"))
                subtrees.setdefault((tier, (x, y, z)), {})
        for path in self._geometry:
            if path.endswith(".glb"):
                x, y, z = (int(number) >> self._layout.subtree for number in path[:-4].split("/")[-3:])
                subtrees.setdefault((0, (x, y, z)), {})
        return dict(sorted(subtrees.items()))

    def _newest_geometry(self) -> dict[str, str]:
        """Map the names of geometry files in the copy to their paths below the store."""
        sources: dict[str, str] = {}
        for record in self._records:
            for path, (size, digest) in record.geometry.items():
                sources.pop(path, None)
                if size:  # an update lists removed files with size 0
                    sources[path] = record.folder + path
                    self._size_and_digest[record.folder + path] = size, digest
        return sources

    def write(self, subtree: SubtreeKey, shards: dict[str, ShardEntry | None]) -> None:
        """Write a subtree's shards, the geometry of its leaves, and its record."""
        tier, place_of_subtree = subtree
        presence = Presence(self._layout, tier)
        written: Shards = {}
        for path, listed in sorted(shards.items()):
            level, array = int(path.partition("/")[0]), "/".join(path.split("/")[:2])
            keys = [(level, place, array) for place in self._places(level, place_of_subtree)]
            with formats.guarded(self._store.address, "orthoviews"):
                for key, length in zip(keys, self._chunks.lengths(keys), strict=True):
                    presence.add(key, length)
                if listed is None:
                    listed = self._merge(path, level, keys)
                else:
                    self._copy(path, path)
            if listed is not None:
                written[path] = listed
        leaves = [] if tier else self._places(0, place_of_subtree)
        for path in (name for place in leaves for name in names(self._layout.grid, place) if name in self._geometry):
            self._copy(self._geometry[path], path)
        geometry, guests = list_geometry(self._folder, self._layout, leaves), self._read_cells(*subtree).guests
        write_record(record_of(self._folder, *subtree), record_document(written, geometry, presence, guests))

    def images(self) -> None:
        """Copy the textures of the geometry."""
        for path, source in self._geometry.items():
            if path.startswith(f"{GEOMETRY}/{IMAGES}/"):
                self._copy(source, path)

    def _places(self, level: int, shard: Place) -> list[Place]:
        """Places of a shard's cells within the world, depth first."""
        subtree = self._layout.subtree
        return list(self._layout.grid.descendants((level // subtree + 1) * subtree, shard, level))

    def _merge(self, path: str, level: int, keys: list[Key]) -> ShardEntry | None:
        """Write a shard of the newest chunks, and return its entry; None if there are no chunks."""
        writer, is_empty = ShardWriter(self._folder / path, self._layout.shard_side(level)), True
        for start in range(0, len(keys), _BATCH):
            batch = keys[start : start + _BATCH]
            for (_, place, _), chunk in zip(batch, self._chunks.read(batch), strict=True):
                if chunk is not None:
                    writer.append(self._layout.shard_of(level, place)[1], chunk)
                    is_empty = False
        return None if is_empty else writer.finish()

    def _copy(self, source: str, path: str) -> None:
        """Copy a file into the new store, as a hard link if possible: files of a store never change."""
        target = self._folder / path
        target.parent.mkdir(parents=True, exist_ok=True)
        if isinstance(self._store, Local):
            with suppress(OSError):
                os.link(self._store.folder / source, target)
                return
            try:
                shutil.copyfile(self._store.folder / source, target)
            except FileNotFoundError:
                raise _lost(self._store, source) from None
            return
        files.write(target, _read_checked(self._store, source, *self._size_and_digest[source]))


def _lost(store: Files, name: str) -> FormatError:
    return FormatError(f"{store.address}/{name}: damaged orthoviews: the file is gone")


def verify(store: Files, newest: int) -> int:
    """Check the size and the SHA-256 of all shards and geometry files; return their number.

    Records of unfinished subtrees list files by their size alone.
    """
    listed = [
        (record.folder + path, size, digest)
        for record in _store.folder_records(store, newest)
        for path, size, digest in record.files()
    ]
    with progress.bar("checking") as report:
        for done, (name, size, digest) in enumerate(listed, 1):
            _read_checked(store, name, size, digest)
            report(done, len(listed))
    return len(listed)


def _read_checked(store: Files, name: str, size: int, digest: str) -> bytes:
    """Read a file; FormatError if its size, or its SHA-256 if known, is not the recorded one."""
    content = store.read(name)
    if content is None:
        raise _lost(store, name)
    if len(content) != size:
        raise FormatError(f"{store.address}/{name}: damaged orthoviews: expected {size} bytes, got {len(content)}")
    if digest != NO_HASH and hashlib.sha256(content).hexdigest() != digest:
        raise FormatError(f"{store.address}/{name}: damaged orthoviews: its SHA-256 is not {digest}")
    return content
