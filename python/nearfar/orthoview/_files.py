"""Files of a store, read whole or in part, in a local folder or behind a URL that fsspec knows."""

from __future__ import annotations

import errno
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Protocol

from nearfar._base import files, remote

Part = tuple[str, int, int]
"""Name of a file, first byte and length; a first byte below 0 counts from the file's end, up to which the part goes."""


class Files(Protocol):
    """Where the files of a store are read from."""

    place: str
    """The folder or URL, for messages."""

    def whole(self, name: str) -> bytes | None:
        """Bytes of a file; None if there is none."""

    def parts(self, wanted: Sequence[Part]) -> list[bytes | None]:
        """Parts of files, shorter where a file ends; None where there is none."""


def files_at(path: str | os.PathLike[str]) -> Files:
    """The files of a store."""
    return Remote(str(path).rstrip("/")) if remote.is_url(path) else Local(remote.local(path))


class Local:
    """Files in a folder."""

    def __init__(self, path: Path) -> None:
        files.restore(path)
        self.folder, self.place = path, os.fspath(path)

    def whole(self, name: str) -> bytes | None:
        """Bytes of a file; None if there is none."""
        try:
            return (self.folder / name).read_bytes()
        except (FileNotFoundError, NotADirectoryError):
            return None

    def parts(self, wanted: Sequence[Part]) -> list[bytes | None]:
        """Parts of files, one after the other."""
        return [self._part(*part) for part in wanted]

    def _part(self, name: str, first: int, length: int) -> bytes | None:
        try:
            file = os.open(self.folder / name, os.O_RDONLY | getattr(os, "O_BINARY", 0))
        except (FileNotFoundError, NotADirectoryError):
            return None
        try:
            if first < 0:
                first = max(os.lseek(file, 0, os.SEEK_END) + first, 0)
            os.lseek(file, first, os.SEEK_SET)
            pieces = []
            while length and (piece := os.read(file, length)):
                pieces.append(piece)
                length -= len(piece)
            return b"".join(pieces)
        finally:
            os.close(file)


class Remote:
    """Files behind a URL; the parts of one call are asked for at once, where the file system can."""

    def __init__(self, url: str) -> None:
        self._system, self._path = remote.system(url)
        self.place = url

    def whole(self, name: str) -> bytes | None:
        """Bytes of a file; None if there is none."""
        with remote.as_os_errors(f"{self.place}/{name}", "read"):
            try:
                return bytes(self._system.cat_file(f"{self._path}/{name}"))
            except FileNotFoundError:
                return None

    def parts(self, wanted: Sequence[Part]) -> list[bytes | None]:
        """Parts of files."""
        if not wanted:
            return []
        paths = [f"{self._path}/{name}" for name, _, _ in wanted]
        ends = [None if first < 0 else first + length for _, first, length in wanted]
        with remote.as_os_errors(self.place, "read"):
            found = self._system.cat_ranges(paths, [first for _, first, _ in wanted], ends, on_error="return")
            return [_part_of(data, part) for data, part in zip(found, wanted, strict=True)]


def _part_of(found: bytes | Exception, part: Part) -> bytes | None:
    """The part in what a server answered; some send the whole file."""
    _, first, length = part
    if isinstance(found, FileNotFoundError):
        return None
    if isinstance(found, Exception):
        if getattr(found, "status", None) == 416:  # the file ends before the part
            return b""
        raise found
    if len(found) > length:
        return bytes(found[first:] if first < 0 else found[first : first + length])
    return bytes(found)


def missing(place: str, document: str) -> FileNotFoundError:
    """The error for a place without a store."""
    return FileNotFoundError(errno.ENOENT, f"no store of orthoviews (no {document})", place)
