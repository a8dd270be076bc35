"""Files of a bundle in a local folder, or behind a URL that fsspec knows."""

from __future__ import annotations

import errno
import hashlib
import os
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any, Protocol

from nearfar._base import check, files, formats, remote
from nearfar._base.errors import FormatError
from nearfar._base.remote import READ_ONLY, as_os_errors, is_url, local

MANIFEST = "manifest.json"
TILESET = "tileset.json"
FOLDER = "files"
"""Folder of the files that are named by their content."""


def named(data: bytes, kind: str) -> str:
    """Name of a file by its content: a quarter of its SHA-256, which no two files share by chance, and its kind."""
    return f"{FOLDER}/{hashlib.sha256(data).hexdigest()[:16]}.{kind}"


def described(data: bytes) -> dict[str, Any]:
    """Size and hash of a file, as manifests list them."""
    return {"bytes": len(data), "sha256": hashlib.sha256(data).hexdigest()}


class Reader(Protocol):
    """Where the files of a bundle are read from."""

    place: str
    """The folder or URL, for messages."""

    def read(self, name: str) -> bytes:
        """Bytes of a file; OSError if it is missing."""

    def sizes(self) -> Mapping[str, int] | None:
        """Sizes of the files that are there, bytes; None where that takes a request for each."""


class _Folder:
    def __init__(self, path: Path) -> None:
        self._path, self.place = path, os.fspath(path)

    def read(self, name: str) -> bytes:
        return (self._path / name).read_bytes()

    def sizes(self) -> Mapping[str, int] | None:
        paths = [self._path / TILESET, *self._path.glob(f"{FOLDER}/*")]
        return {path.relative_to(self._path).as_posix(): path.stat().st_size for path in paths if path.is_file()}


class _Remote:
    def __init__(self, url: str) -> None:
        self._system, self._path = remote.system(url)
        self.place = url

    def read(self, name: str) -> bytes:
        with as_os_errors(f"{self.place}/{name}", "read"):
            content: bytes = self._system.cat_file(f"{self._path}/{name}")
            return content

    def sizes(self) -> Mapping[str, int] | None:
        return None


def reader(path: str | os.PathLike[str]) -> Reader:
    """Open the place of a bundle; a path may also be that of its manifest."""
    if is_url(path):
        return _Remote(str(path).removesuffix(f"/{MANIFEST}").rstrip("/"))
    folder = local(path)
    if folder.name == MANIFEST:
        folder = folder.parent
    files.restore(folder)
    return _Folder(folder)


def check_target(path: str | os.PathLike[str], wanted: str) -> None:
    """Refuse a place that cannot take a bundle, before the work starts.

    Parameters
    ----------
    path
        The folder or URL.
    wanted
        Format of the manifests whose folders may be replaced.

    Raises
    ------
    ValueError
        For a URL whose file system is not known or only reads, and where fsspec is missing.
    OSError
        For a local folder that cannot be written, has no folder above or contains other files.
    """
    if is_url(path):
        remote.system(str(path))
        if str(path).partition("://")[0] in READ_ONLY:
            raise ValueError(f"path: expected a place that can be written, got {check.shortened(path)}")
        return
    folder = Path(os.path.abspath(local(path)))
    if not folder.parent.is_dir():
        message = "expected a path whose parent is a folder, got one without"
        raise FileNotFoundError(errno.ENOENT, f"path: {message}", os.fspath(folder))
    _refuse_foreign_manifest(folder / MANIFEST, wanted)
    with suppress(_TrialError), files.atomic_folder(folder, marker=MANIFEST):
        raise _TrialError


class _TrialError(Exception):
    """Ends a trial, so that the target stays unchanged."""


def _refuse_foreign_manifest(path: Path, wanted: str) -> None:
    """Web pages have a file of this name, too: their folder would be replaced. One that is damaged may be ours."""
    try:
        document = formats.from_json(path.read_bytes())
    except (OSError, ValueError, RecursionError):
        return
    if not isinstance(document, dict) or document.get("format") != wanted:
        message = f"path: holds a {MANIFEST} of another program, expected a new or empty folder, or a bundle"
        raise FileExistsError(errno.EEXIST, message, os.fspath(path.parent))


def write(path: str | os.PathLike[str], content: Mapping[str, bytes]) -> None:
    """Write the files of a bundle, which include the manifest and the tileset.

    A local folder is written aside and takes its place at once. At a URL the tileset and last the manifest are written
    after all files, and files that are there already, by name and size, are not touched: until then a reader sees the
    bundle that was there before.
    """
    if not is_url(path):
        with files.atomic_folder(local(path), marker=MANIFEST) as folder:
            (folder / FOLDER).mkdir()
            for name, data in content.items():
                files.write(folder / name, data)
        return
    system, root = remote.system(str(path))
    with as_os_errors(str(path), "written"):
        system.makedirs(f"{root}/{FOLDER}", exist_ok=True)
        present = _sizes_at(system, f"{root}/{FOLDER}")
        for name in sorted(content, key=lambda name: (name == MANIFEST, name == TILESET, name)):
            if name == MANIFEST or present.get(name) != len(content[name]):
                system.pipe_file(f"{root}/{name}", content[name])


def _sizes_at(system: Any, folder: str) -> dict[str, int]:
    """Sizes of the files of a folder, by their names in manifests; object stores have no folder before its files."""
    system.invalidate_cache()
    try:
        entries = system.ls(folder, detail=True)
    except FileNotFoundError:
        return {}
    return {f"{FOLDER}/{entry['name'].rpartition('/')[2]}": entry["size"] for entry in entries}


def checked(place: str, name: str, data: bytes, expected: Mapping[str, Any]) -> bytes:
    """Return a file's bytes if they have the size and the hash that a manifest lists; FormatError otherwise."""
    found = described(data)
    for field in ("bytes", "sha256"):
        if found[field] != expected[field]:
            raise differs(place, name, field, expected[field], found[field])
    return data


def missing(place: str, name: str) -> FormatError:
    """The error for a file that a manifest lists and that is not there."""
    return FormatError(f"{place}/{name}: expected the file that the manifest lists, found none")


def differs(place: str, name: str, field: str, expected: object, found: object) -> FormatError:
    """The error for a file whose size or hash is not the listed one."""
    return FormatError(f"{place}/{name}: expected {expected} as {field}, as the manifest lists it, got {found}")


def check_presence(source: Reader, listed: Mapping[str, Mapping[str, Any]]) -> None:
    """Compare the files of a local folder with a manifest's sizes; FormatError that names the first wrong one."""
    sizes = source.sizes()
    if sizes is None:
        return
    for name, entry in listed.items():
        if name not in sizes:
            raise missing(source.place, name)
        if sizes[name] != entry["bytes"]:
            raise differs(source.place, name, "bytes", entry["bytes"], sizes[name])
