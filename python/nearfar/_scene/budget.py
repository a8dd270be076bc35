"""Limits the bytes that a file may unpack to, so that no file fills the memory; rejects pipes, which may block."""

from __future__ import annotations

import gzip
import io
import os
import stat
import zipfile
from pathlib import Path
from typing import Any

from nearfar._base.errors import UnusableError

FREE = 256 << 20
"""Bytes that even a small file may unpack to: pictures of one colour compress to a thousandth or less."""

RATIO = 100
"""Ratio of unpacked to stored bytes that larger files may have."""

MAX = 16 << 30
"""Maximum number of bytes that a file may unpack to, unless the caller allows more."""

_BLOCK_BYTES = 1 << 22
_GZIP = b"\x1f\x8b"


class TooLargeError(UnusableError):
    """Error: a file unpacks to more than its budget."""


class Budget:
    """Limit of the bytes that a file may unpack to: compressed text, archive members, pixels, copies of its arrays.

    By default it is `RATIO` times the bytes read, at least `FREE` and at most `MAX`.
    """

    def __init__(self, max_bytes: int | None = None) -> None:
        self._max_bytes, self._read_bytes, self._unpacked_bytes, self._array_bytes = max_bytes, 0, 0, 0

    @property
    def limit(self) -> int:
        """Bytes that the data read so far may unpack to."""
        return min(max(FREE, RATIO * self._read_bytes), MAX) if self._max_bytes is None else self._max_bytes

    def add_read(self, size: int) -> None:
        """Count bytes that were read from files."""
        self._read_bytes += size

    def count_unpacked(self, size: int) -> None:
        """Count bytes before they are unpacked; TooLargeError above the limit."""
        self._unpacked_bytes += size
        self._check()

    def count_arrays(self, size: int) -> None:
        """Count bytes of arrays before they are created; only those beyond the bytes read count towards the limit."""
        self._array_bytes += size
        self._check()

    def _check(self) -> None:
        if self._unpacked_bytes + max(0, self._array_bytes - self._read_bytes) > self.limit:
            more = f"{self.limit:,} bytes from {self._read_bytes:,}; max_bytes allows more"
            raise TooLargeError(f"it unpacks to more than {more}")

    def unpacked(self, data: bytes) -> bytes:
        """Unpack gzip data within the budget."""
        blocks: list[bytes] = []
        with gzip.GzipFile(fileobj=io.BytesIO(data)) as file:
            while block := file.read(_BLOCK_BYTES):
                self.count_unpacked(len(block))
                blocks.append(block)
        return b"".join(blocks)

    def unpacked_if_gzip(self, data: bytes) -> bytes:
        """Unpack gzip data within the budget; return other data as they are."""
        return self.unpacked(data) if data.startswith(_GZIP) else data

    def count_members(self, data: bytes) -> None:
        """Count the unpacked sizes that a ZIP archive such as a 3MF states; `zipfile` never unpacks more."""
        if data.startswith(b"PK"):
            try:
                with zipfile.ZipFile(io.BytesIO(data)) as archive:
                    self.count_unpacked(sum(member.file_size for member in archive.infolist()))
            except zipfile.BadZipFile:
                return


def check_regular(path: Path) -> None:
    """Reject pipes and devices, which may never end."""
    if not stat.S_ISREG(os.stat(path).st_mode):
        raise UnusableError(f"{path.name} is not a regular file, but a pipe, a socket or a device")


def read_file(path: Path, budget: Budget) -> bytes:
    """Read a regular file."""
    check_regular(path)
    data = path.read_bytes()
    budget.add_read(len(data))
    return data


def resolver(path: Path, budget: Budget) -> Any:
    """Trimesh resolver for files beside `path`; reads only regular files, each once."""
    import trimesh

    class Regular(trimesh.resolvers.FilePathResolver):  # type: ignore[misc]  # trimesh has no types
        def __init__(self, source: str) -> None:
            super().__init__(source)
            self._content: dict[str, bytes] = {}

        def absolute(self, name: str) -> Path:
            path: Path = super().absolute(name)
            if path.exists():
                check_regular(path)
            return path

        def get(self, name: str) -> bytes:
            if name not in self._content:
                self._content[name] = super().get(name)
                budget.add_read(len(self._content[name]))
            return self._content[name]

    return Regular(os.path.abspath(path))
