"""The store's own attributes: what it holds, and whether it is complete."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from nearfar._base import files, formats
from nearfar._base.errors import FormatError
from nearfar.orthoview._layout import Layout

KIND, VERSION = "orthoview", 1

DOCUMENT = "zarr.json"

_KEY = "nearfar"
"""Name of the group's attribute."""


def begin(path: Path, layout: Layout) -> None:
    """Make a store, or check that one was begun with the same layout.

    Raises
    ------
    ValueError
        One that was begun with another layout.
    FileExistsError
        A folder that holds other files.
    """
    if (path / DOCUMENT).is_file():
        found = read(path)["layout"]
        wanted = layout.described()
        if found != wanted:
            different = [key for key in wanted if found.get(key) != wanted[key]]
            raise ValueError(f"path: {path} was begun with other values of {', '.join(different)}")
        return
    path.mkdir(exist_ok=True)
    if any(path.iterdir()):
        raise FileExistsError(f"{path}: holds other files (no {DOCUMENT}), expected a new or empty folder")
    # The group's document comes last: without it a store that was begun is begun again.
    attributes = formats.header(KIND, VERSION, color_space="sRGB") | {"layout": layout.described(), "complete": False}
    layout.create(path, {_KEY: attributes})


def end(path: Path, *, failed: Mapping[str, str], counts: Mapping[str, int]) -> None:
    """Note what the build did; a store without failures is complete."""
    attributes = read(path)
    attributes |= {"complete": not failed, "failed": dict(failed), "counts": dict(counts)}
    document = _document(path)
    document["attributes"][_KEY] = attributes
    with files.atomic_file(path / DOCUMENT) as temporary:
        temporary.write_text(json.dumps(document, indent=2), encoding="utf-8")


def read(path: Path) -> dict[str, Any]:
    """Return the attributes of a store; FormatError for what is none."""
    attributes = _document(path).get("attributes", {}).get(_KEY)
    return formats.check(attributes, KIND, VERSION, path)


def _document(path: Path) -> dict[str, Any]:
    place = path / DOCUMENT
    if not place.is_file():
        raise FileNotFoundError(f"{path}: no store of orthoviews (no {DOCUMENT})")
    with formats.guarded(place):
        document = formats.from_json(place.read_bytes())
    if not isinstance(document, dict) or document.get("node_type") != "group":
        raise FormatError(f"{place}: expected a group of Zarr v3")
    return document
