"""Records: documents that list the shards, geometry files and cells of a subtree or a generation."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from nearfar._base import formats
from nearfar.orthoview._geometry_store import names
from nearfar.orthoview._grid import Place, name_of
from nearfar.orthoview._index import ShardEntry
from nearfar.orthoview._layout import FOLDER, Layout
from nearfar.orthoview._owners import Guests, encode_guests
from nearfar.orthoview._presence import Presence

FileEntries = dict[str, tuple[int, str]]
"""Sizes and SHA-256 of files by path."""

Shards = dict[str, ShardEntry]
"""Entries of shards by path."""

DONE = "done"
"""Folder in `FOLDER` with a record of each complete subtree."""

JOURNALS = "journal"
"""Folder in `FOLDER` with the journal of each unfinished subtree."""

NO_HASH = ""
"""Hash of a file that is listed by its size alone."""

RECORD, VERSION = "orthoview_subtree", 1

_SHARD = re.compile(r"[0-9]+/[a-z_]+/c/[0-9]+/[0-9]+/[0-9]+/0")
_GEOMETRY_FILE = re.compile(
    r"geometry/((content|moving)(/[0-9]+){4}[.]glb|images/[0-9a-f]+[.]webp|subtrees/[0-9.]+[.]subtree"
    r"|(tileset|moving)[.]json)"
)
"""Allowed paths in records: copies of stores write to these paths."""


@dataclass(frozen=True)
class FolderRecord:
    """Record of a folder of shards: of a subtree or of a generation."""

    folder: str
    """Path below the store with a trailing slash; empty for the store itself."""
    name: str
    """Name of the record's file without its suffix."""
    shards: Shards
    geometry: FileEntries
    cells: Any = None
    """Entries about cells, not decoded yet."""

    @classmethod
    def from_document(cls, folder: str, name: str, document: Mapping[str, Any]) -> FolderRecord:
        """Decode a record; KeyError, TypeError or ValueError for a damaged one."""
        cells = document["cells"] if folder else {key: document[key] for key in ("views", "guests")}
        return cls(folder, name, parse_shards(document["shards"]), parse_geometry(document["geometry"]), cells)

    def files(self) -> Iterator[tuple[str, int, str]]:
        """Paths, sizes and SHA-256 of the shards and geometry files."""
        yield from ((path, shard.size, shard.digest) for path, shard in self.shards.items())
        yield from ((path, size, digest) for path, (size, digest) in self.geometry.items())


def record_of(store: Path, tier: int, place: Place) -> Path:
    """Path of a subtree's record, which exists once the subtree has been built, with or without failed leaves."""
    return store / FOLDER / DONE / f"{tier}_{name_of(place)}.json"


def journal_of(store: Path, tier: int, place: Place) -> Path:
    """Path of a subtree's journal, which exists from its first cell until all its cells are complete."""
    return store / FOLDER / JOURNALS / f"{record_of(store, tier, place).stem}.jsonl"


def is_complete(record: Path) -> bool:
    """Whether the record of a subtree exists and names no failed leaf."""
    return record.exists() and not formats.read_json(record, RECORD, VERSION).get("failed")


def size_and_hash(path: Path) -> tuple[int, str]:
    """Size and SHA-256 of a file."""
    content = path.read_bytes()
    return len(content), hashlib.sha256(content).hexdigest()


def size_alone(path: Path) -> tuple[int, str]:
    """Size of a file, and `NO_HASH`."""
    return path.stat().st_size, NO_HASH


def list_files(
    folder: Path, paths: Iterable[Path], describe: Callable[[Path], tuple[int, str]] = size_and_hash
) -> FileEntries:
    """List the files that exist, by path below a folder."""
    return {path.relative_to(folder).as_posix(): describe(path) for path in paths if path.is_file()}


def list_geometry(
    folder: Path, layout: Layout, leaves: Iterable[Place], describe: Callable[[Path], tuple[int, str]] = size_and_hash
) -> FileEntries:
    """List the geometry files of leaves, by path below a folder."""
    if not layout.geometry:
        return {}
    return list_files(folder, [folder / name for leaf in sorted(leaves) for name in names(layout.grid, leaf)], describe)


def record_document(
    shards: Shards,
    geometry: FileEntries,
    presence: Presence,
    guests: Guests,
    failed: Mapping[str, str] | None = None,
    empty: int = 0,
) -> dict[str, Any]:
    """Return the record of a subtree.

    `failed` has the reasons, by name, why leaves are incomplete, which the next build repeats. `empty` is the number of
    leaves that were drawn and show nothing.
    """
    content = {"shards": shards, "geometry": geometry, "held": presence.counts(), "empty": empty}
    content |= {"views": presence.to_json(), "guests": encode_guests(guests)}
    return formats.header(RECORD, VERSION) | content | ({"failed": dict(failed)} if failed else {})


def write_record(path: Path, document: dict[str, Any]) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    formats.write_json(path, document)


def parse_shards(listed: Mapping[str, Any]) -> Shards:
    """Decode entries of shards by path; ValueError for a path that does not belong in a store."""
    _check_paths(listed, _SHARD)
    return {path: ShardEntry(int(size), str(digest), str(chunks)) for path, (size, digest, chunks) in listed.items()}


def parse_geometry(listed: Mapping[str, Any]) -> FileEntries:
    """Decode entries of geometry files by path; ValueError for a path that does not belong in a store."""
    _check_paths(listed, _GEOMETRY_FILE)
    return {path: (int(size), str(digest)) for path, (size, digest) in listed.items()}


def _check_paths(listed: Mapping[str, Any], pattern: re.Pattern[str]) -> None:
    wrong = next((path for path in listed if not pattern.fullmatch(path)), None)
    if wrong is not None:
        raise ValueError(f"the path {wrong!r} does not belong in a store")
