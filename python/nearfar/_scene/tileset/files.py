"""Reads files of a tileset, which must be in or below its folder, or at the origin of its URL."""

from __future__ import annotations

import errno
import os
import posixpath
import threading
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urljoin, urlsplit

from nearfar._base import cache, check, files, remote
from nearfar._base.errors import UnusableError
from nearfar._scene.budget import Budget, read_file

THREADS = 8
"""Number of files requested concurrently."""

_VALIDATORS = ("ETag", "Content-MD5", "Digest", "Last-Modified", "mtime", "LastModified", "checksum", "md5Hash")
"""Entries of fsspec's file information that change with the file."""


class OutsideError(UnusableError):
    """Error: a file refers to one outside its tileset's folder, or at another origin."""


def open_files(path: str | os.PathLike[str]) -> Files:
    """Return the reader for a local path or a URL."""
    return Remote(str(path)) if remote.is_url(path) else Local(remote.local(path))


def read_all(source: Files, names: Sequence[str], budget: Budget) -> dict[str, bytes | OSError]:
    """Read several files, each as bytes or as the error; several threads request files from a URL."""

    def read(name: str) -> bytes | OSError:
        try:
            return source.read(name, budget)
        except OSError as error:
            return error

    if isinstance(source, Local) or len(names) < 2:
        return {name: read(name) for name in names}
    with ThreadPoolExecutor(min(THREADS, len(names))) as pool:
        return dict(zip(names, pool.map(read, names), strict=True))


class Local:
    """Files in a folder and below it."""

    def __init__(self, path: Path) -> None:
        files.restore(path)
        self._folder = os.path.realpath(path.parent)
        self.top = os.path.join(self._folder, path.name)
        """Name of the top file."""

    def resolve(self, base: str, uri: str) -> str:
        """Resolve a reference in the file `base` to a name; OutsideError if it leads outside."""
        parts = urlsplit(uri)
        if parts.scheme or parts.netloc or uri.startswith(("/", "\\")):
            raise OutsideError(f"it refers to {check.shortened(uri)}, which lies outside its folder")
        if "\0" in unquote(uri) or not parts.path:
            raise UnusableError(f"it refers to {check.shortened(uri)}, which names no file")
        folder = os.path.dirname(base)
        exact = os.path.normpath(os.path.join(folder, uri))
        name = exact if os.path.exists(exact) else os.path.normpath(os.path.join(folder, unquote(parts.path)))
        # Links and percent escapes may lead outside, too. Resolving links also ends loops of folders.
        real = os.path.realpath(name)
        if os.path.commonpath([real, self._folder]) != self._folder:
            raise OutsideError(f"it refers to {check.shortened(uri)}, which lies outside its folder")
        return real

    def display_name(self, name: str) -> str:
        """Name of a file for messages, relative to the top file's folder."""
        return os.path.relpath(name, self._folder)

    def read(self, name: str, budget: Budget) -> bytes:
        """Bytes of a file; FileNotFoundError if it does not exist."""
        return read_file(Path(name), budget)


class Remote:
    """Files at the origin of a URL; files whose version the server states are cached."""

    def __init__(self, url: str) -> None:
        self._system, _ = remote.system(url)
        self.top = url
        self._folder = posixpath.dirname(urlsplit(url).path)
        self._origin = _origin(url)
        self._lock = threading.Lock()

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle the URL: another process opens it itself."""
        return Remote, (self.top,)

    def resolve(self, base: str, uri: str) -> str:
        try:
            name = _resolve_uri(base, uri)
            origin = _origin(name)
        except ValueError:
            raise UnusableError(f"it refers to {check.shortened(uri)}, which names no file") from None
        if origin != self._origin:
            raise OutsideError(f"it refers to {check.shortened(uri)}, which lies at another origin")
        return name

    def display_name(self, name: str) -> str:
        # The query is left out, because it may contain a key.
        return unquote(posixpath.relpath(urlsplit(name).path or "/", self._folder or "/"))

    def read(self, name: str, budget: Budget) -> bytes:
        """Read a file, from the cache if the server states the same version."""
        with remote.as_os_errors(name, "read"):
            path = self._system._strip_protocol(name)
            version = self._version(path)
            key = cache.key("tile", 1, name, version)
            data = _cached_content(key) if version else None
            if data is None:
                data = bytes(self._system.cat_file(path))
                if version:
                    _write_to_cache(key, data)
        with self._lock:
            budget.add_read(len(data))
        return data

    def _version(self, path: str) -> list[str]:
        """Values that identify a file's version; empty if the server states none."""
        try:
            info = self._system.info(path)
        except FileNotFoundError:  # also raised for servers that only support requests for whole files
            return []
        version = [f"{key} {info[key]}" for key in _VALIDATORS if info.get(key)]
        # Dates have a resolution of one second, within which a file may change again.
        return [*version, f"size {info.get('size')}"] if version else []


Files = Local | Remote
"""Reader of a tileset's files; a name is a path or a URL."""


def _cached_content(key: str) -> bytes | None:
    """Content of a key's cached file; None if there is none."""
    path = cache.find(key, ".tile")
    try:
        return None if path is None else path.read_bytes()
    except FileNotFoundError:  # another process removed it
        return None


def _write_to_cache(key: str, data: bytes) -> None:
    """Cache a file's bytes; failure to write the cache folder is ignored."""
    try:
        cache.keep(key, ".tile", partial(files.write, data=data))
    except OSError as error:
        if error.errno not in (errno.EACCES, errno.EROFS, errno.ENOSPC, errno.EPERM):
            raise


def _origin(url: str) -> tuple[str, str, int | None]:
    """Scheme, host and port of a URL."""
    parts = urlsplit(url)
    port = parts.port or {"http": 80, "https": 443}.get(parts.scheme)
    return parts.scheme, (parts.hostname or "").lower(), port


def _resolve_uri(base: str, uri: str) -> str:
    """Resolve a reference against a URL of any scheme: urljoin only supports known schemes."""
    scheme = urlsplit(base).scheme
    if urlsplit(uri).scheme:
        return uri
    joined = urljoin("https:" + base.removeprefix(f"{scheme}:"), uri)
    return f"{scheme}:" + joined.removeprefix("https:")
