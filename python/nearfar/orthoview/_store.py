"""Documents of a store: its attributes, its generations, and the list of all records."""

from __future__ import annotations

import errno
import hashlib
import json
import os
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check, files, formats
from nearfar._base.errors import FormatError
from nearfar.orthoview import _record
from nearfar.orthoview._chunks import Chunks, Generation
from nearfar.orthoview._files import Files, Local
from nearfar.orthoview._geometry_store import FOLDER as GEOMETRY, IMAGES, MOVING, SHARED_FOLDERS, TILESET, GeometryStore
from nearfar.orthoview._grid import Place
from nearfar.orthoview._index import ShardEntry
from nearfar.orthoview._layout import FOLDER, Layout
from nearfar.orthoview._owners import Guests, guests_of
from nearfar.orthoview._presence import UNCHANGED, Masks, masks_of, newest_of
from nearfar.orthoview._record import DONE, RECORD, FileEntries, FolderRecord, Shards, list_files, record_of

KIND, VERSION = "orthoview", 2

DOCUMENT = "zarr.json"

NO_FILE = "nearfar/none"
"""Name of a file that no folder has: `files.atomic_folder` replaces only empty folders then."""

_KEY = "nearfar"
"""Name of the group's attribute."""

NO_CONTENT = {"cells": 0, "leaves": 0, "chunks": 0, "bytes": 0}
"""Counts of a store without cells."""

_RECORDS, _RECORDS_VERSION = "orthoview_records", 1
RECORDS_FILE = f"{FOLDER}/records.json"
"""Names and hashes of the records of all subtrees, since folders behind URLs cannot be listed."""

_GENERATION, _GENERATION_VERSION = "orthoview_generation", 1
_GENERATION_FILE = "generation.json"


def begin(path: Path, layout: Layout) -> None:
    """Create a store atomically, or check that an existing one was begun with the same layout.

    Raises ValueError for a store that was begun with another layout or updated since it was built, OSError for a folder
    that holds other files.
    """
    if not (path / DOCUMENT).is_file():
        try:
            with new_folder(path) as temporary:
                create(temporary, layout)
            return
        except FileExistsError:
            if not (path / DOCUMENT).is_file():  # else another build has created it meanwhile
                raise
    attributes, described = read(Local(path)), layout.to_json()
    with formats.guarded(path / DOCUMENT):
        Layout.from_json(attributes["layout"])
    if attributes["layout"] != described:
        different = [key for key in described if attributes["layout"].get(key) != described[key]]
        raise ValueError(f"path: {path} was begun with other values of {', '.join(different)}")
    if attributes["generation"]:
        raise ValueError(f"path: {path} was updated since it was built, expected a new folder")


@contextmanager
def new_folder(path: Path) -> Iterator[Path]:
    """Write a new store atomically; a folder that is not empty is never replaced."""
    try:
        with files.atomic_folder(path, marker=NO_FILE) as temporary:
            yield temporary
    except FileExistsError:
        message = f"holds other files, expected a new or empty folder for a store of orthoviews (no {DOCUMENT} in it)"
        if (path / DOCUMENT).exists():
            message = "holds a Zarr store, expected a new or empty folder"
        raise FileExistsError(errno.EEXIST, message, os.fspath(path)) from None


def create(folder: Path, layout: Layout) -> None:
    """Create a store without chunks in an empty folder."""
    attributes = {"layout": layout.to_json(), "complete": False, "failed": {}, "held": NO_CONTENT, "done": {}}
    attributes |= {"generation": 0, "geometry": None}
    layout.create(folder, {_KEY: formats.header(KIND, VERSION, color_space="sRGB") | attributes})


def reopen(path: Path) -> None:
    """Mark a store whose build ended with failures as unfinished: its records change until the next build ends."""
    if read(Local(path))["failed"]:
        change(path, failed={})
        (path / RECORDS_FILE).unlink(missing_ok=True)


def finish(path: Path, *, failed: Mapping[str, str], done: Mapping[str, int] | None = None) -> None:
    """End a build: write the geometry's tileset, the list of all records, and the counts in the attributes.

    A store without `failed` leaves becomes complete. `done` are the counts of work, by default those of a build.
    """
    described = read(Local(path))
    if described["complete"]:
        return
    layout = Layout.from_json(described["layout"])
    facts = GeometryStore(path, layout.grid).finish() if layout.geometry else None
    digests = {record.name: hashlib.sha256(record.read_bytes()).hexdigest() for record in _records(path)}
    # Records of subtrees list the files of leaves; these files belong to all leaves.
    shared_files = [path / GEOMETRY / name for name in (TILESET, MOVING)]
    shared_files += sorted(file for folder in SHARED_FOLDERS for file in (path / GEOMETRY / folder).glob("*"))
    formats.write_json(path / RECORDS_FILE, records_document(digests, list_files(path, shared_files)))
    held = held_below(path)
    if done is None:
        empty = sum(formats.read_json(record, RECORD, _record.VERSION)["empty"] for record in _records(path))
        done = done_of(held, empty)
    change(path, complete=not failed, failed=dict(failed), held=dict(held), done=dict(done), geometry=facts)


def records_document(digests: Mapping[str, str], geometry: FileEntries) -> dict[str, Any]:
    """List the SHA-256 of all records by name, and the geometry files that no record lists."""
    return formats.header(_RECORDS, _RECORDS_VERSION) | {"records": digests, "geometry": geometry}


def done_of(held: Mapping[str, int], empty: int) -> dict[str, int]:
    """Counts of a build's work, from the counts of its content and the number of leaves that were drawn but are empty.

    They do not depend on interruptions of the build, nor on its processes.
    """
    return {"drawn": held["leaves"], "empty": empty, "composed": held["cells"] - held["leaves"]}


def check_complete(attributes: Mapping[str, Any], address: object, unbuilt: int = 0) -> None:
    """Raise a ValueError for a store that lacks leaves; `unbuilt` is the number of leaves that are not built yet."""
    if attributes["complete"]:
        return
    failed = len(attributes["failed"])
    counts = [f"{unbuilt:,} leaves not built yet"] * (unbuilt > 0) + [f"{failed:,} failed"] * (failed > 0)
    missing = ", ".join(counts) or "its build has not ended"
    raise ValueError(f"path: expected a complete tree, {address}: {missing}; the same call of build completes it")


def has_ended(attributes: Mapping[str, Any]) -> bool:
    """Whether the build of a store has ended, with or without failed leaves."""
    return bool(attributes["complete"] or attributes["failed"])


def held_below(folder: Path) -> Counter[str]:
    """Count cells, leaves, chunks and bytes of the complete subtrees of a store or a generation."""
    counts: Counter[str] = Counter(NO_CONTENT)
    for record in _records(folder):
        counts.update(formats.read_json(record, RECORD, _record.VERSION)["held"])
    return counts


def _records(folder: Path) -> list[Path]:
    return sorted((folder / FOLDER / DONE).glob("*.json"))


def change(path: Path, **attributes: Any) -> None:
    """Change attributes of the store atomically."""
    document = _document(Local(path))
    document["attributes"][_KEY] |= attributes
    with files.atomic_file(path / DOCUMENT) as temporary:
        temporary.write_text(json.dumps(document, indent=2), encoding="utf-8")


def read(store: Files) -> dict[str, Any]:
    """Return the attributes of a store; FormatError if it is not a store."""
    attributes = _document(store).get("attributes")
    described = attributes.get(_KEY) if isinstance(attributes, dict) else None
    checked = formats.check(described, KIND, VERSION, store.address)
    if checked["version"] < VERSION:
        raise FormatError(f"{store.address}: version {checked['version']} stores views in another way, build it again")
    return checked


def _document(store: Files) -> dict[str, Any]:
    content = store.read(DOCUMENT)
    if content is None:
        raise FileNotFoundError(errno.ENOENT, f"no store of orthoviews (no {DOCUMENT})", store.address)
    address = f"{store.address}/{DOCUMENT}"
    with formats.guarded(address):
        document = formats.from_json(content)
    if not isinstance(document, dict) or document.get("node_type") != "group":
        raise FormatError(f"{address}: expected a group of Zarr v3")
    return document


def overlay_folder(number: int) -> str:
    """Folder of a generation below the store, with a trailing slash."""
    return f"{FOLDER}/generations/{number}/"


def finish_generation(path: Path, number: int, aabb: NDArray[np.float64], counts: Mapping[str, int]) -> None:
    """Write the record of a generation from the records of its subtrees."""
    folder = path / overlay_folder(number)
    shards: Shards = {}
    geometry: FileEntries = {}
    cells: dict[str, dict[str, Any]] = {}
    for record in _records(folder):
        document = formats.read_json(record, RECORD, _record.VERSION)
        cells[record.stem] = {key: document[key] for key in ("views", "guests")}
        shards |= document["shards"]
        geometry |= document["geometry"]
    geometry |= list_files(folder, sorted((folder / GEOMETRY / IMAGES).glob("*")))
    box = [[x if np.isfinite(x) else None for x in corner] for corner in aabb.tolist()]
    content = {"aabb": box, "shards": shards, "geometry": geometry, "held": dict(counts), "cells": cells}
    formats.write_json(folder / _GENERATION_FILE, formats.header(_GENERATION, _GENERATION_VERSION) | content)


def overlays(store: Files, newest: int) -> list[FolderRecord]:
    """Records of a store's generations after the first one, newest first."""
    folders = [overlay_folder(number) for number in range(newest, 0, -1)]
    return [_read_record(store, folder, _GENERATION_FILE, _GENERATION, _GENERATION_VERSION) for folder in folders]


def folder_records(store: Files, newest: int) -> Iterator[FolderRecord]:
    """Records of a complete store: of all subtrees of the first generation, then of the later generations."""
    digests, geometry = _read_list(store)
    yield from (_read_subtree(store, name, digest) for name, digest in digests.items())
    yield FolderRecord("", "", {}, geometry)
    yield from reversed(overlays(store, newest))


def _read_subtree(store: Files, name: str, digest: str) -> FolderRecord:
    return _read_record(store, "", f"{FOLDER}/{DONE}/{name}", RECORD, _record.VERSION, digest)


def _read_record(
    store: Files, folder: str, name: str, kind: str, version: int, digest: str | None = None
) -> FolderRecord:
    document = _read_json(store, folder + name, kind, version, digest)
    with formats.guarded(f"{store.address}/{folder}{name}"):
        return FolderRecord.from_document(folder, Path(name).stem, document)


def _read_list(store: Files) -> tuple[Mapping[str, str], FileEntries]:
    """Read the SHA-256 of all records by name, and the entries of the geometry files that no record lists."""
    document = _read_json(store, RECORDS_FILE, _RECORDS, _RECORDS_VERSION)
    with formats.guarded(f"{store.address}/{RECORDS_FILE}"):
        digests = check.mapping("records", document["records"], "hashes by names")
        return digests, _record.parse_geometry(document["geometry"])


def _read_json(store: Files, name: str, kind: str, version: int, digest: str | None = None) -> dict[str, Any]:
    content, address = store.read(name), f"{store.address}/{name}"
    if content is None:
        raise FormatError(f"{address}: expected a file that the store refers to, found none")
    if digest is not None and hashlib.sha256(content).hexdigest() != digest:
        raise FormatError(f"{address}: damaged: its SHA-256 is not {digest}")
    with formats.guarded(address):
        return formats.check(formats.from_json(content), kind, version, address)


@dataclass(frozen=True)
class Cells:
    """Cells of a subtree, according to its records."""

    masks: Masks
    guests: Guests


def open_generation(store: Files, layout: Layout, newest: int) -> tuple[Chunks, Callable[[int, Place], Cells]]:
    """Return a reader of chunks, and a function that reads the cells of a subtree by its tier and place.

    Both look up chunks and geometry in the records, so that lost files are detected.
    """
    first, records = FirstGeneration(store, layout), overlays(store, newest)
    later = [Generation(record.folder, record.shards.get, record.geometry.__contains__) for record in records]
    chunks = Chunks(store, layout, [*later, Generation("", first.shard, first.has_geometry)])
    cells_by_file = {}
    for record in records:
        file = record.folder + _GENERATION_FILE
        with formats.guarded(f"{store.address}/{file}"):
            cells_by_file[file] = check.mapping("cells", record.cells, "cells by subtrees")

    def read_cells(tier: int, place: Place) -> Cells:
        name = record_of(Path(), tier, place)
        by_file = [(file, cells[name.stem]) for file, cells in cells_by_file.items() if name.stem in cells]
        if (record := first.record(tier, place)) is not None:
            by_file.append((name.as_posix(), record.cells))
        generations: list[Masks] = []
        guests: Guests = {}
        for file, cells in by_file:
            with formats.guarded(f"{store.address}/{file}"):
                in_file = guests_of(cells["guests"], layout, tier, place)
                is_unchanged = newest_of(generations, layout, tier, UNCHANGED)[0] == UNCHANGED
                guests |= {
                    leaf: places for leaf, places in in_file.items() if is_unchanged[layout.shard_of(0, leaf)[1]]
                }
                generations.append(masks_of(cells["views"], layout, tier))
        return Cells(newest_of(generations, layout, tier), guests)

    return chunks, read_cells


class FirstGeneration:
    """Files of a store's first generation, from its records, which are read on demand."""

    def __init__(self, store: Files, layout: Layout) -> None:
        self._store, self._layout = store, layout
        self._records: dict[str, FolderRecord] = {}

    @cached_property
    def _digests(self) -> Mapping[str, str]:
        return _read_list(self._store)[0]

    def record(self, tier: int, place: Place) -> FolderRecord | None:
        """Read the record of a subtree; None for an empty subtree."""
        name = record_of(Path(), tier, place).name
        if name in self._digests and name not in self._records:
            self._records[name] = _read_subtree(self._store, name, self._digests[name])
        return self._records.get(name)

    def shard(self, path: str) -> ShardEntry | None:
        """Return the entry of a shard; None if it was not written."""
        record = self.record(*self._layout.subtree_of(path))
        return None if record is None else record.shards.get(path)

    def has_geometry(self, path: str) -> bool:
        """Whether a geometry file of a leaf was written; textures count as written, since leaves refer to them."""
        if path.startswith(f"{GEOMETRY}/{IMAGES}/"):
            return True
        side = 1 << self._layout.subtree
        x, y, z = (int(number) // side for number in path.removesuffix(".glb").split("/")[-3:])
        record = self.record(0, (x, y, z))
        return record is not None and path in record.geometry
