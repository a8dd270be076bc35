"""The store's own attributes: what it holds, and whether it is complete."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from nearfar._base import files, formats
from nearfar._base.errors import FormatError
from nearfar.orthoview._grid import Place
from nearfar.orthoview._layout import Layout
from nearfar.orthoview._subtree import DONE, FOLDER, RECORD, VERSION as RECORD_VERSION

KIND, VERSION = "orthoview", 1

DOCUMENT = "zarr.json"

_KEY = "nearfar"
"""Name of the group's attribute."""


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
        One that was begun with another layout.
    OSError
        A folder that holds other files.
    """
    if not (path / DOCUMENT).is_file():
        held = {"cells": 0, "leaves": 0, "chunks": 0, "bytes": 0}
        own = {"layout": layout.described(), "complete": False, "failed": {}, "held": held, "done": {}}
        attributes = formats.header(KIND, VERSION, color_space="sRGB") | own
        with files.atomic_folder(path, marker=DOCUMENT) as temporary:
            layout.create(temporary, {_KEY: attributes})
        return
    found, wanted = read(path)["layout"], layout.described()
    if found != wanted:
        different = [key for key in wanted if found.get(key) != wanted[key]]
        raise ValueError(f"path: {path} was begun with other values of {', '.join(different)}")


def end(path: Path, *, failed: Mapping[str, str], done: Mapping[str, int]) -> None:
    """Note what the store holds, and what the build did; a store without failures is complete."""
    attributes = read(path)
    if attributes["complete"]:
        return
    held: Counter[str] = Counter()
    for record in sorted((path / FOLDER / DONE).glob("*.json")):
        held.update(formats.read_json(record, RECORD, RECORD_VERSION)["held"])
    attributes |= {"complete": not failed, "failed": dict(failed), "held": dict(held), "done": dict(done)}
    document = _document(path)
    document["attributes"][_KEY] = attributes
    with files.atomic_file(path / DOCUMENT) as temporary:
        temporary.write_text(json.dumps(document, indent=2), encoding="utf-8")


def read(path: Path) -> dict[str, Any]:
    """Return the attributes of a store; FormatError for what is none."""
    attributes = _document(path).get("attributes")
    return formats.check(attributes.get(_KEY) if isinstance(attributes, dict) else None, KIND, VERSION, path)


def _document(path: Path) -> dict[str, Any]:
    place = path / DOCUMENT
    if not place.is_file():
        raise FileNotFoundError(f"{path}: no store of orthoviews (no {DOCUMENT})")
    with formats.guarded(place):
        document = formats.from_json(place.read_bytes())
    if not isinstance(document, dict) or document.get("node_type") != "group":
        raise FormatError(f"{place}: expected a group of Zarr v3")
    return document
