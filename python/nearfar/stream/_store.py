"""Files of a bundle in a local folder, or behind a URL that fsspec knows."""

from __future__ import annotations

import hashlib
import importlib.util
import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Protocol

from nearfar._base import check, files
from nearfar._base.errors import FormatError

MANIFEST = "manifest.json"
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


class _Folder:
    def __init__(self, path: Path) -> None:
        self._path, self.place = path, os.fspath(path)

    def read(self, name: str) -> bytes:
        return (self._path / name).read_bytes()


class _Remote:
    def __init__(self, url: str) -> None:
        self._system, self._path = _system(url)
        self.place = url

    def read(self, name: str) -> bytes:
        content: bytes = self._system.cat_file(f"{self._path}/{name}")
        return content


def is_url(path: object) -> bool:
    """Whether a place is a URL, such as https://… or s3://…."""
    return isinstance(path, str) and "://" in path


def _system(url: str) -> tuple[Any, str]:
    """The file system of a URL, and the path in it."""
    if not importlib.util.find_spec("fsspec"):
        raise ValueError(f"path: expected a folder, or fsspec installed (pip install fsspec), got {url}")
    import fsspec

    try:
        system, path = fsspec.core.url_to_fs(url)
    except (ImportError, ValueError) as error:
        raise ValueError(
            f"path: expected a URL that fsspec can open, got {url}: {check.one_line(str(error))}"
        ) from None
    return system, path.rstrip("/")


def reader(path: str | os.PathLike[str]) -> Reader:
    """Open the place of a bundle; a path may also be that of its manifest."""
    if is_url(path):
        return _Remote(str(path).removesuffix(f"/{MANIFEST}").rstrip("/"))
    folder = check.path("path", path)
    if folder.name == MANIFEST:
        folder = folder.parent
    files.restore(folder)
    return _Folder(folder)


def write(path: str | os.PathLike[str], content: Mapping[str, bytes]) -> None:
    """Write the files of a bundle, which include the manifest.

    A local folder is written aside and takes its place at once; of a URL the manifest is written last, and no file with
    a name of its content changes, so that a reader never sees a part.
    """
    if is_url(path):
        system, root = _system(str(path))
        system.makedirs(f"{root}/{FOLDER}", exist_ok=True)
        for name in sorted(content, key=lambda name: (name == MANIFEST, name)):
            system.pipe_file(f"{root}/{name}", content[name])
        return
    with files.atomic_folder(check.path("path", path), marker=MANIFEST) as folder:
        (folder / FOLDER).mkdir()
        for name, data in content.items():
            files.write(folder / name, data)


@contextmanager
def naming(place: str, name: str) -> Iterator[None]:
    """Name a bundle's file in errors about its content."""
    try:
        yield
    except ValueError as error:
        raise FormatError(f"{place}/{name}: {error}") from None


def checked(place: str, name: str, data: bytes, expected: Mapping[str, Any]) -> bytes:
    """Return a file's bytes if they have the size and the hash that a manifest lists; FormatError otherwise."""
    found = described(data)
    for field in ("bytes", "sha256"):
        if found[field] != expected[field]:
            raise FormatError(
                f"{place}/{name}: expected {expected[field]} as {field}, as the manifest lists it, got {found[field]}"
            )
    return data
