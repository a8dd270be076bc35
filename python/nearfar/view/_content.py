"""Files for the viewer by the names that the page requests, from a bundle or a reduced scene converted to one."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path

from nearfar import stream
from nearfar._base import formats, remote
from nearfar._reduce import folder
from nearfar._reduce.reduced_scene import ReducedScene
from nearfar.stream import _store
from nearfar.stream._bundle import Bundle
from nearfar.view import _reduced

Read = Callable[[], bytes]


def open_files(path: str | os.PathLike[str]) -> Mapping[str, Read]:
    """Return a reader for each file of the bundle or reduced scene at a path; the latter is converted in memory."""
    reduced = reduced_folder(path)
    if reduced is not None:
        return of_reduced(ReducedScene.load(reduced))
    bundle = stream.open(path)
    return of_bundle(bundle, bundle._reader.read)


def reduced_folder(path: str | os.PathLike[str]) -> Path | None:
    """Return the folder of a reduced scene at a path; None if there is none."""
    if remote.is_url(path):
        return None
    place = remote.local(path)
    place = place.parent if place.name == folder.DOCUMENT else place
    return place if (place / folder.DOCUMENT).is_file() else None


def of_bundle(bundle: Bundle, read: Callable[[str], bytes]) -> dict[str, Read]:
    """Return readers for the files of a bundle, which are read on request."""
    manifest = partial(bytes, formats.to_json(bundle._manifest).encode())
    return {**{name: partial(read, name) for name in (*bundle.files, _store.TILESET)}, _store.MANIFEST: manifest}


def of_reduced(reduced: ReducedScene) -> dict[str, Read]:
    """Convert a reduced scene to a bundle and return readers for its files."""
    return {name: partial(bytes, content) for name, content in _reduced.files_of(reduced).items()}
