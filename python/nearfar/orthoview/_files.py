"""Reads files of a store, whole or in part, from a local folder or a URL that fsspec knows."""

from __future__ import annotations

import os
import warnings
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple, Protocol

from nearfar._base import files, remote


class ByteRange(NamedTuple):
    """Part of a file; a negative first byte counts from the file's end."""

    file: str
    first: int
    length: int


class Files(Protocol):
    """Reader of a store's files."""

    address: str
    """The folder or URL, for messages."""

    def read(self, name: str) -> bytes | None:
        """Bytes of a file; None if it does not exist."""

    def read_parts(self, byte_ranges: Sequence[ByteRange]) -> list[bytes | None]:
        """Parts of files, shorter where a file ends; None for files that do not exist."""


def files_at(path: str | os.PathLike[str]) -> Files:
    """Return the reader for a folder or URL."""
    return Remote(str(path).rstrip("/")) if remote.is_url(path) else Local(remote.local(path))


class Local:
    """Files in a folder."""

    def __init__(self, path: Path) -> None:
        files.restore(path)
        self.folder, self.address = path, os.fspath(path)

    def read(self, name: str) -> bytes | None:
        try:
            return (self.folder / name).read_bytes()
        except (FileNotFoundError, NotADirectoryError):
            return None

    def read_parts(self, byte_ranges: Sequence[ByteRange]) -> list[bytes | None]:
        """Read parts of files, one after the other."""
        return [self._part(part) for part in byte_ranges]

    def _part(self, part: ByteRange) -> bytes | None:
        try:
            with (self.folder / part.file).open("rb") as file:
                file.seek(part.first if part.first >= 0 else max(file.seek(0, os.SEEK_END) + part.first, 0))
                return file.read(part.length)
        except (FileNotFoundError, NotADirectoryError):
            return None


class Remote:
    """Files behind a URL; one call requests all its parts at once if the file system can."""

    def __init__(self, url: str) -> None:
        self._system, self._path = remote.system(url)
        self.address = url
        self._sends_whole_files = False

    def read(self, name: str) -> bytes | None:
        with remote.as_os_errors(f"{self.address}/{name}", "read"):
            try:
                return bytes(self._system.cat_file(f"{self._path}/{name}"))
            except FileNotFoundError:
                return None

    def read_parts(self, byte_ranges: Sequence[ByteRange]) -> list[bytes | None]:
        if not byte_ranges:
            return []
        paths = [f"{self._path}/{name}" for name, _, _ in byte_ranges]
        ends = [None if first < 0 else first + length for _, first, length in byte_ranges]
        with remote.as_os_errors(self.address, "read"):
            contents = self._system.cat_ranges(paths, [first for _, first, _ in byte_ranges], ends, on_error="return")
            self._warn_of_whole_files(contents, byte_ranges)
            return [_part_of(data, part) for data, part in zip(contents, byte_ranges, strict=True)]

    def _warn_of_whole_files(self, contents: Sequence[bytes | Exception], byte_ranges: Sequence[ByteRange]) -> None:
        """Warn once of a server that ignores ranges: each part of a file costs the bytes of the whole file."""
        pairs = zip(contents, byte_ranges, strict=True)
        if self._sends_whole_files or all(isinstance(data, Exception) or len(data) <= n for data, (_, _, n) in pairs):
            return
        self._sends_whole_files = True
        message = f"{self.address}: the server sends whole files where parts are requested: expect many times the bytes"
        warnings.warn(message, RuntimeWarning, stacklevel=2)


def _part_of(content: bytes | Exception, part: ByteRange) -> bytes | None:
    """Extract the part from a server's response; some servers send the whole file."""
    if isinstance(content, FileNotFoundError):
        return None
    if isinstance(content, Exception):
        if getattr(content, "status", None) == 416:  # the file ends before the part
            return b""
        raise content
    if len(content) > part.length:
        return bytes(content[part.first :] if part.first < 0 else content[part.first : part.first + part.length])
    return bytes(content)
