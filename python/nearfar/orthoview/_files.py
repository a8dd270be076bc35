"""Reads files of a store, whole or in part, from a local folder or a URL that fsspec knows."""

from __future__ import annotations

import math
import os
import threading
import warnings
from bisect import bisect_right
from collections import defaultdict
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import NamedTuple, Protocol

from nearfar._base import files, remote
from nearfar._base.recent import Recent

MAX_WHOLE_BYTES = 1 << 28
"""Size of the cache of whole files from servers without byte ranges."""


class ByteRange(NamedTuple):
    """Part of a file."""

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
                file.seek(part.first)
                return file.read(part.length)
        except (FileNotFoundError, NotADirectoryError):
            return None


class Remote:
    """Files behind a URL; a call of `read_parts` makes all its requests at once if the file system can. Thread-safe.

    A server without byte ranges sends whole files. Once it has sent one, whole files are requested and cached, up to
    `MAX_WHOLE_BYTES` in total; a warning says so.
    """

    def __init__(self, url: str) -> None:
        self._system, self._path = remote.system(url)
        self.address = url
        self._sends_whole_files = False
        self._whole: Recent[str, bytes] = Recent(len)
        self._lock = threading.Lock()
        self._lock_by_file: defaultdict[str, threading.Lock] = defaultdict(threading.Lock)

    def __reduce__(self) -> tuple[type[Remote], tuple[str]]:
        """Pickle without cached files."""
        return Remote, (self.address,)

    def read(self, name: str) -> bytes | None:
        with remote.as_os_errors(f"{self.address}/{name}", "read"):
            try:
                return bytes(self._system.cat_file(f"{self._path}/{name}"))
            except FileNotFoundError:
                return None

    def read_parts(self, byte_ranges: Sequence[ByteRange]) -> list[bytes | None]:
        requests = join_ranges(byte_ranges)
        if self._sends_whole_files:
            contents = [self._part_of_whole(request) for request in requests]
        else:
            contents = self._request(requests)
        by_request = dict(zip(requests, contents, strict=True))
        return [_part_within(part, by_request, requests) for part in byte_ranges]

    def _request(self, requests: Sequence[ByteRange]) -> list[bytes | None]:
        """Request parts of files, all at once."""
        if not requests:
            return []
        paths = [f"{self._path}/{name}" for name, _, _ in requests]
        ends = [first + length for _, first, length in requests]
        with remote.as_os_errors(self.address, "read"):
            contents = self._system.cat_ranges(paths, [first for _, first, _ in requests], ends, on_error="return")
            for content, request in zip(contents, requests, strict=True):
                if not isinstance(content, Exception) and len(content) > request.length:
                    self._cache_whole(request.file, bytes(content))
            return [_part_of(content, request) for content, request in zip(contents, requests, strict=True)]

    def _part_of_whole(self, request: ByteRange) -> bytes | None:
        """Return a part of a cached file; a file that is not cached is read first."""
        with self._lock:
            lock = self._lock_by_file[request.file]
        with lock:  # threads that need other parts of the same file wait for it
            content = self._whole.get(request.file)
            if content is None:
                content = self.read(request.file)
                if content is not None:
                    self._cache_whole(request.file, content)
        return None if content is None else _slice(content, request)

    def _cache_whole(self, name: str, content: bytes) -> None:
        """Cache a whole file; the first time, warn about the server."""
        with self._lock:
            is_first, self._sends_whole_files = not self._sends_whole_files, True
        self._whole.put(name, content)
        self._whole.trim((), MAX_WHOLE_BYTES)
        if is_first:
            message = (
                f"{self.address}: the server sends whole files where parts are requested: "
                f"each file is read once, and up to {MAX_WHOLE_BYTES >> 20} MiB of files are cached"
            )
            warnings.warn(message, RuntimeWarning, stacklevel=2)


def join_ranges(byte_ranges: Iterable[ByteRange]) -> list[ByteRange]:
    """Join parts of a file that touch or overlap, so that one request reads them."""
    joined: list[ByteRange] = []
    for part in sorted(set(byte_ranges)):
        before = joined[-1] if joined else None
        if before and before.file == part.file and part.first <= before.first + before.length:
            length = max(before.length, part.first + part.length - before.first)
            joined[-1] = ByteRange(part.file, before.first, length)
        else:
            joined.append(part)
    return joined


def _part_within(
    part: ByteRange, contents: dict[ByteRange, bytes | None], requests: Sequence[ByteRange]
) -> bytes | None:
    """Part of a file from the content of the request that covers it."""
    request = requests[bisect_right(requests, (part.file, part.first, math.inf)) - 1]
    content = contents[request]
    if content is None or request == part:
        return content
    return content[part.first - request.first :][: part.length]


def _part_of(content: bytes | Exception, part: ByteRange) -> bytes | None:
    """Extract a part from a server's response, which may be the whole file."""
    if isinstance(content, FileNotFoundError):
        return None
    if isinstance(content, Exception):
        if getattr(content, "status", None) == 416:  # the file ends before the part
            return b""
        raise content
    return _slice(bytes(content), part) if len(content) > part.length else bytes(content)


def _slice(content: bytes, part: ByteRange) -> bytes:
    return content[part.first : part.first + part.length]
