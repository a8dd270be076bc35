"""Storage of a bundle's files: a local folder, or a URL that fsspec supports."""

from __future__ import annotations

import errno
import hashlib
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from nearfar._base import check, files, formats, remote
from nearfar._base.errors import FormatError
from nearfar._base.remote import READ_ONLY, as_os_errors, is_url, local

MANIFEST = "manifest.json"
TILESET = "tileset.json"
FOLDER = "files"
"""Folder of the files with content-based names."""


def content_name(data: bytes, kind: str) -> str:
    """Name a file by its content: a quarter of its SHA-256, which is unique in practice, and its suffix."""
    return f"{FOLDER}/{hashlib.sha256(data).hexdigest()[:16]}.{kind}"


def file_entry(data: bytes) -> dict[str, Any]:
    """Return size and hash of a file in the format of manifests."""
    return {"bytes": len(data), "sha256": hashlib.sha256(data).hexdigest()}


@dataclass
class Files:
    """Files by name; equal content is stored once."""

    content: dict[str, bytes] = field(default_factory=dict)

    def add(self, data: bytes, kind: str) -> str:
        name = content_name(data, kind)
        self.content[name] = data
        return name

    def file_entries(self) -> dict[str, Any]:
        """Return size and hash of each file by name, sorted by name."""
        return {name: file_entry(self.content[name]) for name in sorted(self.content)}


class Folder:
    """A bundle's files in a local folder."""

    def __init__(self, path: Path) -> None:
        self._path, self.location = path, os.fspath(path)

    def read(self, name: str) -> bytes:
        """Return the bytes of a file; OSError if it is missing."""
        return (self._path / name).read_bytes()

    def sizes(self) -> dict[str, int]:
        """Return the sizes of existing files in bytes."""
        paths = [self._path / TILESET, *self._path.glob(f"{FOLDER}/*")]
        return {path.relative_to(self._path).as_posix(): path.stat().st_size for path in paths if path.is_file()}


class Remote:
    """A bundle's files behind a URL."""

    def __init__(self, url: str) -> None:
        self._system, self._path = remote.system(url)
        self.location = url

    def read(self, name: str) -> bytes:
        """Return the bytes of a file; OSError if it is missing."""
        with as_os_errors(f"{self.location}/{name}", "read"):
            return bytes(self._system.cat_file(f"{self._path}/{name}"))


Reader = Folder | Remote
"""Source of a bundle's files; `location` is the folder or URL, for messages."""


def reader(path: str | os.PathLike[str]) -> Reader:
    """Open a bundle's folder or URL, or the path of its manifest."""
    if is_url(path):
        return Remote(str(path).removesuffix(f"/{MANIFEST}").rstrip("/"))
    folder = local(path)
    if folder.name == MANIFEST:
        folder = folder.parent
    files.restore(folder)
    return Folder(folder)


def check_target(path: str | os.PathLike[str], manifest_format: str) -> None:
    """Reject a folder or URL to which no bundle can be written, before the work starts.

    Folders with manifests of the given format may be replaced. ValueError for a URL whose file system is unknown or
    read-only, and if fsspec is missing; OSError for a local folder that cannot be written, has no parent folder or
    contains other files.
    """
    if is_url(path):
        remote.system(str(path))
        if str(path).partition("://")[0] in READ_ONLY:
            raise ValueError(f"path: expected a URL that can be written, got {check.shortened(path)}")
        return
    folder = Path(os.path.abspath(local(path)))
    if not folder.parent.is_dir():
        message = "expected a path whose parent is a folder, got one without"
        raise FileNotFoundError(errno.ENOENT, f"path: {message}", os.fspath(folder))
    _refuse_foreign_manifest(folder / MANIFEST, manifest_format)
    files.check_writable(files.atomic_folder(folder, marker=MANIFEST))


def _refuse_foreign_manifest(path: Path, manifest_format: str) -> None:
    """Reject a folder with another program's manifest.json, which would be replaced; a damaged one may be ours."""
    try:
        document = formats.from_json(path.read_bytes())
    except (OSError, ValueError, RecursionError):
        return
    if not isinstance(document, dict) or document.get("format") != manifest_format:
        message = f"path: holds a {MANIFEST} of another program, expected a new or empty folder, or a bundle"
        raise FileExistsError(errno.EEXIST, message, os.fspath(path.parent))


def write(path: str | os.PathLike[str], content: Mapping[str, bytes]) -> None:
    """Write the files of a bundle, which include the manifest and the tileset.

    A local folder is written beside its target and then replaces it atomically. At a URL the tileset and then the
    manifest are written last, so that readers see the previous bundle until then. Existing files of equal name and size
    are kept.
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
        sizes = _sizes_at(system, f"{root}/{FOLDER}")
        for name in sorted(content, key=lambda name: (name == MANIFEST, name == TILESET, name)):
            if name == MANIFEST or sizes.get(name) != len(content[name]):
                system.pipe_file(f"{root}/{name}", content[name])


def _sizes_at(system: Any, folder: str) -> dict[str, int]:
    """Return sizes of a folder's files by their names in manifests; object stores have no empty folders."""
    system.invalidate_cache()
    try:
        entries = system.ls(folder, detail=True)
    except FileNotFoundError:
        return {}
    return {f"{FOLDER}/{entry['name'].rpartition('/')[2]}": entry["size"] for entry in entries}


def verify(location: str, name: str, data: bytes, expected: Mapping[str, Any]) -> bytes:
    """Return a file's bytes if they have the listed size and hash; FormatError otherwise."""
    actual = file_entry(data)
    for fact in ("bytes", "sha256"):
        if actual[fact] != expected[fact]:
            raise mismatch_error(location, name, fact, expected[fact], actual[fact])
    return data


def missing_error(location: str, name: str) -> FormatError:
    """Return the error for a listed file that does not exist."""
    return FormatError(f"{location}/{name}: expected the file that the manifest lists, found none")


def mismatch_error(location: str, name: str, fact: str, expected: object, actual: object) -> FormatError:
    """Return the error for a file whose size or hash differs from the manifest."""
    return FormatError(f"{location}/{name}: expected {fact} = {expected}, as the manifest states, got {actual}")


def check_presence(source: Reader, entries: Mapping[str, Mapping[str, Any]]) -> None:
    """Compare the files of a local folder with the listed sizes; FormatError that names the first wrong one."""
    if isinstance(source, Remote):
        return
    sizes = source.sizes()
    for name, entry in entries.items():
        if name not in sizes:
            raise missing_error(source.location, name)
        if sizes[name] != entry["bytes"]:
            raise mismatch_error(source.location, name, "bytes", entry["bytes"], sizes[name])
