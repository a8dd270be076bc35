"""Copies a store's newest generation into a new store, which is plain Zarr; compares stores with their records."""

from __future__ import annotations

import hashlib
import os
import shutil
from collections import defaultdict
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from nearfar._base import files, formats, progress
from nearfar._base.errors import FormatError
from nearfar.orthoview import _store
from nearfar.orthoview._files import Files, Local
from nearfar.orthoview._geometry_store import FOLDER as GEOMETRY, IMAGES, names
from nearfar.orthoview._grid import Place
from nearfar.orthoview._index import ListedShard
from nearfar.orthoview._layout import FOLDER, Key, Layout
from nearfar.orthoview._presence import Presence
from nearfar.orthoview._shard import ShardWriter
from nearfar.orthoview._subtree import (
    NO_HASH,
    Described,
    Shards,
    record_document,
    record_of,
    size_and_hash,
    write_record,
)


def compact(store: Files, attributes: dict[str, Any], target: Path) -> None:
    """Write the newest generation of a complete store as a new store; see `OrthoTree.compact`."""
    layout, newest = Layout.from_described(attributes["layout"]), int(attributes["generation"])
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

Subtree = tuple[int, Place]
"""Tier and place of a subtree."""


class _Copy:
    def __init__(self, store: Files, layout: Layout, newest: int, folder: Path) -> None:
        self._store, self._layout, self._folder = store, layout, folder
        self._chunks, self._read_cells = _store.open_generation(store, layout, newest)
        self._records = list(_store.recorded(store, newest))
        self._size_and_digest = {
            path: (listed.size, listed.digest) for recorded in self._records for path, listed in recorded.shards.items()
        }
        self._geometry = self._newest_geometry()

    def subtrees(self) -> dict[Subtree, dict[str, ListedShard | None]]:
        """Shards of all subtrees by path, with their entries if no update changed them, else None."""
        subtrees: defaultdict[Subtree, dict[str, ListedShard | None]] = defaultdict(dict)
        for recorded in self._records:
            for path, listed in recorded.shards.items():
                subtrees[self._layout.subtree_of(path)][path] = None if recorded.folder else listed
            if not recorded.folder and recorded.name and not recorded.shards:  # an empty subtree
                tier, *place = map(int, recorded.name.split("_"))
                subtrees.setdefault((tier, (place[0], place[1], place[2])), {})
        for path in self._geometry:
            if path.endswith(".glb"):
                x, y, z = (int(number) >> self._layout.subtree for number in path[:-4].split("/")[-3:])
                subtrees.setdefault((0, (x, y, z)), {})
        return dict(sorted(subtrees.items()))

    def _newest_geometry(self) -> dict[str, str]:
        """Map the names of geometry files in the copy to their paths below the store."""
        sources: dict[str, str] = {}
        for recorded in self._records:
            for path, (size, digest) in recorded.geometry.items():
                sources.pop(path, None)
                if size:
                    sources[path] = recorded.folder + path
                    self._size_and_digest[recorded.folder + path] = size, digest
        return sources

    def write(self, subtree: Subtree, shards: dict[str, ListedShard | None]) -> None:
        """Write a subtree's shards and its record."""
        presence = Presence(self._layout, subtree[0])
        written: Shards = {}
        for path, listed in sorted(shards.items()):
            level, array = int(path.partition("/")[0]), "/".join(path.split("/")[:2])
            keys = [(level, place, array) for place in self._places(level, subtree[1])]
            with formats.guarded(self._store.address, "orthoviews"):
                for key, length in zip(keys, self._chunks.lengths(keys), strict=True):
                    presence.add(key, length)
                if listed is None:
                    listed = self._merge(path, level, keys)
                else:
                    self._copy(path, path)
            if listed is not None:
                written[path] = listed
        record, guests = record_of(self._folder, *subtree), self._read_cells(*subtree).guests
        write_record(record, record_document(written, self._leaves(subtree), presence, guests))

    def _leaves(self, subtree: Subtree) -> Described:
        """Copy the geometry of a subtree's leaves; return sizes and hashes."""
        tier, shard = subtree
        if not self._layout.geometry or tier:
            return {}
        places = sorted(self._places(0, shard))
        paths = [name for place in places for name in names(self._layout.grid, place) if name in self._geometry]
        for path in paths:
            self._copy(self._geometry[path], path)
        return {path: size_and_hash(self._folder / path) for path in paths}

    def images(self) -> None:
        """Copy the textures of the geometry."""
        for path, source in self._geometry.items():
            if path.startswith(f"{GEOMETRY}/{IMAGES}/"):
                self._copy(source, path)

    def _places(self, level: int, shard: Place) -> list[Place]:
        """Places of a shard's cells within the world, depth first."""
        subtree = self._layout.subtree
        return list(self._layout.grid.descendants((level // subtree + 1) * subtree, shard, level))

    def _merge(self, path: str, level: int, keys: list[Key]) -> ListedShard | None:
        """Write a shard of the newest chunks; None if there are none."""
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
            with _naming_lost(self._store, source):
                shutil.copyfile(self._store.folder / source, target)
            return
        files.write(target, _read_checked(self._store, source, *self._size_and_digest[source]))


@contextmanager
def _naming_lost(store: Files, name: str) -> Iterator[None]:
    try:
        yield
    except FileNotFoundError:
        raise FormatError(f"{store.address}/{name}: damaged orthoviews: the file is gone") from None


def verify(store: Files, newest: int) -> int:
    """Check the size and the SHA-256 of all shards and geometry files; return their number.

    Files of subtrees in work are listed by their size alone.
    """
    listed = [
        (recorded.folder + path, size, digest)
        for recorded in _store.recorded(store, newest)
        for path, size, digest in recorded.files()
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
        raise FormatError(f"{store.address}/{name}: damaged orthoviews: the file is gone")
    if len(content) != size:
        raise FormatError(f"{store.address}/{name}: damaged orthoviews: expected {size} bytes, got {len(content)}")
    if digest != NO_HASH and hashlib.sha256(content).hexdigest() != digest:
        raise FormatError(f"{store.address}/{name}: damaged orthoviews: its SHA-256 is not {digest}")
    return content
