"""The documents of a store: what it holds, whether it is complete, and its generations."""

from __future__ import annotations

import hashlib
import json
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import files, formats
from nearfar._base.errors import FormatError
from nearfar.orthoview._chunks import Generation
from nearfar.orthoview._files import Files, Local, missing
from nearfar.orthoview._geometry_store import FOLDER as GEOMETRY, IMAGES, MOVING, OTHERS, TILESET, GeometryStore
from nearfar.orthoview._grid import Place
from nearfar.orthoview._layout import FOLDER, Layout
from nearfar.orthoview._subtree import DONE, RECORD, VERSION as RECORD_VERSION, Described, described

KIND, VERSION = "orthoview", 1

DOCUMENT = "zarr.json"

_KEY = "nearfar"
"""Name of the group's attribute."""

_RECORDS, _RECORDS_VERSION = "orthoview_records", 1
_RECORDS_FILE = f"{FOLDER}/records.json"
"""Names and hashes of the records of all subtrees: places behind URLs cannot be listed."""

_GENERATION, _GENERATION_VERSION = "orthoview_generation", 1
_GENERATION_FILE = "generation.json"


@dataclass(frozen=True)
class Recorded:
    """A folder of shards, of a subtree or of a generation, with what its record says."""

    folder: str
    """Below the store, with a slash at its end; empty for the store itself."""
    name: str
    shards: Described
    geometry: Described
    held: dict[str, int]


def name_of(place: Place) -> str:
    """Name of a cell among those of its level."""
    return "_".join(map(str, place))


def place_of(name: str) -> Place:
    """Place of the cell of a name."""
    x, y, z = map(int, name.split("_"))
    return x, y, z


def begin(path: Path, layout: Layout) -> None:
    """Make a store, completely or not at all, or check that one was begun with the same layout.

    Raises
    ------
    ValueError
        One that was begun with another layout, or updated since it was built.
    OSError
        A folder that holds other files.
    """
    if not (path / DOCUMENT).is_file():
        with files.atomic_folder(path, marker=DOCUMENT) as temporary:
            create(temporary, layout)
        return
    attributes, wanted = read(Local(path)), layout.described()
    if attributes["layout"] != wanted:
        different = [key for key in wanted if attributes["layout"].get(key) != wanted[key]]
        raise ValueError(f"path: {path} was begun with other values of {', '.join(different)}")
    if attributes["generation"]:
        raise ValueError(f"path: {path} was updated since it was built, expected a new folder")


def create(folder: Path, layout: Layout) -> None:
    """Make a store without chunks in an empty folder."""
    held = {"cells": 0, "leaves": 0, "chunks": 0, "bytes": 0}
    own = {"layout": layout.described(), "complete": False, "failed": {}, "held": held, "done": {}, "generation": 0}
    own |= {"geometry": None}
    layout.create(folder, {_KEY: formats.header(KIND, VERSION, color_space="sRGB") | own})


def end(path: Path, *, failed: Mapping[str, str], done: Mapping[str, int]) -> None:
    """Note what the store holds, and what the build did; a store without failures is complete."""
    if read(Local(path))["complete"]:
        return
    own = {"failed": dict(failed), "held": dict(held_below(path)), "done": dict(done)}
    change(path, complete=not failed, **own, **_end_files(path))


def _end_files(path: Path) -> dict[str, Any]:
    """Write the tileset of the geometry, and list the records of all subtrees; the attributes that follow."""
    layout = Layout.from_described(read(Local(path))["layout"])
    facts = GeometryStore(path, layout.grid).finish() if layout.geometry else None
    digests = {record.name: hashlib.sha256(record.read_bytes()).hexdigest() for record in _records(path)}
    # The files of leaves stand in the records of their subtrees.
    others = [path / GEOMETRY / name for name in (TILESET, MOVING)]
    others += sorted(file for folder in OTHERS for file in (path / GEOMETRY / folder).glob("*"))
    listed = {file.relative_to(path).as_posix(): described(file) for file in others if file.is_file()}
    own = {"records": digests, "geometry": listed}
    formats.write_json(path / _RECORDS_FILE, formats.header(_RECORDS, _RECORDS_VERSION) | own)
    return {"geometry": facts}


def held_below(folder: Path) -> Counter[str]:
    """Cells, leaves, chunks and bytes of a store's or a generation's complete subtrees."""
    held: Counter[str] = Counter(cells=0, leaves=0, chunks=0, bytes=0)
    for record in _records(folder):
        held.update(formats.read_json(record, RECORD, RECORD_VERSION)["held"])
    return held


def _records(folder: Path) -> list[Path]:
    return sorted((folder / FOLDER / DONE).glob("*.json"))


def change(path: Path, **attributes: Any) -> None:
    """Change attributes of the store, all of them at once."""
    document = _document(Local(path))
    document["attributes"][_KEY] |= attributes
    with files.atomic_file(path / DOCUMENT) as temporary:
        temporary.write_text(json.dumps(document, indent=2), encoding="utf-8")


def end_compact(folder: Path, tree: Mapping[str, Any]) -> None:
    """Complete a store that is the newest generation of another one, whose attributes are given."""
    change(folder, complete=True, held=tree["held"], done=tree["done"], **_end_files(folder))


def read(store: Files) -> dict[str, Any]:
    """Return the attributes of a store; FormatError for what is none."""
    attributes = _document(store).get("attributes")
    found = attributes.get(_KEY) if isinstance(attributes, dict) else None
    return formats.check(found, KIND, VERSION, store.place)


def _document(store: Files) -> dict[str, Any]:
    content = store.whole(DOCUMENT)
    if content is None:
        raise missing(store.place, DOCUMENT)
    place = f"{store.place}/{DOCUMENT}"
    with formats.guarded(place):
        document = formats.from_json(content)
    if not isinstance(document, dict) or document.get("node_type") != "group":
        raise FormatError(f"{place}: expected a group of Zarr v3")
    return document


def overlay(number: int) -> str:
    """Folder of a generation below the store, with a slash at its end."""
    return f"{FOLDER}/generations/{number}/"


def end_generation(path: Path, number: int, aabb: NDArray[np.float64], held: Mapping[str, int]) -> None:
    """Write the record of a generation, from those of its subtrees."""
    folder = path / overlay(number)
    shards: Described = {}
    geometry: Described = {}
    for record in _records(folder):
        document = formats.read_json(record, RECORD, RECORD_VERSION)
        shards |= document["shards"]
        geometry |= document["geometry"]
    images = sorted((folder / GEOMETRY / IMAGES).glob("*"))
    geometry |= {file.relative_to(folder).as_posix(): described(file) for file in images}
    box = [[x if np.isfinite(x) else None for x in corner] for corner in aabb.tolist()]
    own = {"aabb": box, "shards": shards, "geometry": geometry, "held": dict(held)}
    formats.write_json(folder / _GENERATION_FILE, formats.header(_GENERATION, _GENERATION_VERSION) | own)


def generations(store: Files, newest: int) -> list[Generation]:
    """The generations of a store, the newest one first."""
    overlays = (_generation(store, number) for number in range(newest, 0, -1))
    known = (Generation(found.folder, found.shards.keys(), found.geometry.keys()) for found in overlays)
    return [*known, Generation("", None, None)]


def _generation(store: Files, number: int) -> Recorded:
    folder = overlay(number)
    document = _json(store, folder + _GENERATION_FILE, _GENERATION, _GENERATION_VERSION)
    return _recorded(folder, str(number), document)


def _recorded(folder: str, name: str, document: Mapping[str, Any]) -> Recorded:
    shards, geometry = (_listed(document[key]) for key in ("shards", "geometry"))
    return Recorded(folder, name, shards, geometry, document["held"])


def recorded(store: Files, newest: int) -> Iterator[Recorded]:
    """The records of a complete store: of all subtrees of the first generation, then of the others."""
    records = _json(store, _RECORDS_FILE, _RECORDS, _RECORDS_VERSION)
    for name, digest in records["records"].items():
        path = f"{FOLDER}/{DONE}/{name}"
        yield _recorded("", name.removesuffix(".json"), _json(store, path, RECORD, RECORD_VERSION, digest))
    yield Recorded("", "", {}, _listed(records["geometry"]), {})
    for number in range(1, newest + 1):
        yield _generation(store, number)


def _json(store: Files, name: str, kind: str, version: int, digest: str | None = None) -> dict[str, Any]:
    content, place = store.whole(name), f"{store.place}/{name}"
    if content is None:
        raise FormatError(f"{place}: expected a file that the store refers to, found none")
    if digest is not None and hashlib.sha256(content).hexdigest() != digest:
        raise FormatError(f"{place}: damaged: its SHA-256 is not {digest}")
    with formats.guarded(place):
        return formats.check(formats.from_json(content), kind, version, place)


def _listed(listed: Mapping[str, Any]) -> Described:
    return {str(path): (int(size), str(digest)) for path, (size, digest) in listed.items()}
