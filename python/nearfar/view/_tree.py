"""Files of a tree of orthoviews for its viewer page, and the page's own files."""

from __future__ import annotations

import os
from functools import cache
from importlib import resources
from pathlib import Path

from nearfar._base import formats, remote
from nearfar._base.errors import FormatError
from nearfar.orthoview import _store
from nearfar.orthoview._files import Local
from nearfar.orthoview._layout import FOLDER, Layout
from nearfar.orthoview._record import DONE
from nearfar.orthoview._unfinished import UnfinishedFiles

GEOMETRY_SUFFIXES = (".glb", ".webp")
"""Suffixes of geometry files that the page reads; the tileset is not among them."""

File = bytes | tuple[str, int]
"""Content of a file, or its path and size."""


@cache
def tree_page() -> dict[str, bytes]:
    """Return the files of the orthoview page by name; they may be placed in a store's folder."""
    folder = resources.files("nearfar.view") / "dist" / "orthoview"
    return {file.name: file.read_bytes() for file in folder.iterdir()}


def tree_folder(path: str | os.PathLike[str]) -> Path | None:
    """Return the folder of a tree's store at a path; None if there is none."""
    if remote.is_url(path):
        return None
    folder = remote.local(path)
    if not (folder / _store.DOCUMENT).is_file():
        return None
    try:
        _store.read(Local(folder))
    except FormatError:
        return None
    return folder


def tree_files(folder: Path) -> dict[str, File]:
    """Return documents, shards and geometry of a store, by their paths below it.

    Before the build of the store has ended, these are the files of this moment, without subtrees of leaves in work:
    their shards grow. FormatError for a missing or damaged record.
    """
    store: Local = Local(folder)
    attributes = _store.read(store)
    with formats.guarded(folder / _store.DOCUMENT):
        layout, has_ended = Layout.from_json(attributes["layout"]), _store.has_ended(attributes)
    unfinished_shards: dict[str, bytes] = {}
    if not has_ended:
        store = unfinished = UnfinishedFiles(folder, layout, unfinished_leaves=False)
        unfinished_shards = unfinished.unfinished_shards()
    files: dict[str, File] = {}
    documents = [_store.DOCUMENT, _store.RECORDS_FILE]
    with formats.guarded(folder):
        for recorded in _store.folder_records(store, int(attributes["generation"])):
            if recorded.folder:
                documents.append(f"{recorded.folder}generation.json")
            elif recorded.name:
                documents.append(f"{FOLDER}/{DONE}/{recorded.name}.json")
            files |= {
                recorded.folder + path: (os.fspath(folder.resolve() / recorded.folder / path), size)
                for path, size, _ in recorded.files()
                # An update lists removed geometry with size 0.
                if size > 0 and (path in recorded.shards or path.endswith(GEOMETRY_SUFFIXES))
            }
    contents = {name: content for name in documents if (content := store.read(name)) is not None}
    return files | contents | unfinished_shards
