"""A size-limited cache folder for slow results; keys are hashes of content, settings and algorithm version."""

from __future__ import annotations

import hashlib
import os
import struct
import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import platformdirs

from nearfar._base.files import atomic_file


def folder() -> Path:
    """Return the cache folder: `NEARFAR_CACHE` if set, else nearfar's folder in the platform's cache folder."""
    path = os.environ.get("NEARFAR_CACHE", "").strip()
    if path:
        return Path(path).expanduser()
    return platformdirs.user_cache_path("nearfar", appauthor=False)


def key(*parts: Any) -> str:
    """Hash everything that a result depends on, including the algorithm's name and version, to 40 hexadecimal digits.

    Parts are strings, bytes, numbers, booleans, None, arrays, and tuples, lists and dicts of these. TypeError for other
    types, because their text may contain an address that differs between runs.
    """
    digest = hashlib.blake2b(digest_size=20)
    for piece in _encoded(parts):
        digest.update(piece)
    return digest.hexdigest()


def get_or_make(key: str, suffix: str, make: Callable[[Path], None]) -> Path:
    """Return the cached file of a key, marked as just used; make it first if there is none.

    `key` is a hash that the function `key` returned; the suffix has a dot, such as ".npy". `make` writes the file at
    the path that it receives; if it raises, nothing is cached. While the folder exceeds `NEARFAR_CACHE_MAX_GB` (default
    4) gigabytes of 10⁹ bytes, the least recently used other files are removed. ValueError if
    `NEARFAR_CACHE_MAX_GB` is not a number of at least 0, OSError with the folder's name if it is not writable;
    `NEARFAR_CACHE` sets another folder.
    """
    return find(key, suffix) or keep(key, suffix, make)


def find(key: str, suffix: str) -> Path | None:
    """Return the cached file of a key, marked as just used; None if there is none."""
    # Raises for an invalid NEARFAR_CACHE_MAX_GB.
    _limit()
    path = _path_of(key, suffix)
    try:
        os.utime(path)
    except (FileNotFoundError, NotADirectoryError):
        return None
    return path


def keep(key: str, suffix: str, make: Callable[[Path], None]) -> Path:
    """Cache a new file for a key, replacing the old one; arguments, errors and limits as in `get_or_make`."""
    limit, path = _limit(), _path_of(key, suffix)
    path.parent.mkdir(parents=True, exist_ok=True)
    with atomic_file(path) as temporary:
        make(temporary)
    if _is_due(limit, path):
        _trim(limit, path)
    return path


def _path_of(key: str, suffix: str) -> Path:
    return folder() / key[:2] / f"{key}{suffix}"


def _limit() -> int:
    text = os.environ.get("NEARFAR_CACHE_MAX_GB", "").strip() or "4"
    try:
        limit = float(text)
    except ValueError:
        limit = -1.0
    if not 0.0 <= limit < float("inf"):
        raise ValueError(f"NEARFAR_CACHE_MAX_GB: expected a number of gigabytes of at least 0, got {text!r}")
    return int(limit * 1e9)


_SCANS_PER_LIMIT = 64
"""The folder is scanned each time this process has added 1/64 of the limit."""

_sizes: dict[tuple[Path, int], tuple[int, int]] = {}
"""By folder and limit: bytes in the folder at the last scan, and bytes that this process has added since."""

_lock = threading.Lock()


def _is_due(limit: int, just_made: Path) -> bool:
    """Return whether to scan the folder; scanning after each of thousands of small files would be slow."""
    with _lock:
        key = (folder(), limit)
        size = just_made.stat().st_size
        held, added = _sizes.get(key, (limit, 0))
        _sizes[key] = (held, added + size)
        return held + added + size > limit or added + size > limit // _SCANS_PER_LIMIT


def _trim(limit: int, just_made: Path) -> None:
    """Remove the least recently used files until at most `limit` bytes remain; the file just made always stays."""
    files = []
    for path in folder().glob("??/*"):
        try:
            status = path.stat()
        except FileNotFoundError:
            continue
        files.append((status.st_mtime_ns, status.st_size, path))
    total_size = sum(size for _, size, _ in files)
    for _, size, path in sorted(files):
        if total_size <= limit:
            break
        if path != just_made:
            path.unlink(missing_ok=True)
            total_size -= size
    with _lock:
        _sizes[folder(), limit] = (total_size, 0)


def _encoded(value: Any) -> Iterator[bytes]:
    """Encode values unambiguously as bytes: each piece starts with its type and length."""
    if value is None or isinstance(value, bool | np.bool_):
        yield b"c" + str(value).encode() + b";"
    elif isinstance(value, int | np.integer):
        yield b"i" + str(int(value)).encode() + b";"
    elif isinstance(value, float | np.floating):
        yield b"f" + struct.pack("<d", float(value))
    elif isinstance(value, str):
        text = value.encode()
        yield b"s%d:" % len(text) + text
    elif isinstance(value, bytes):
        yield b"b%d:" % len(value) + value
    elif isinstance(value, np.ndarray) and value.dtype.kind in "biufc":
        little = value.astype(value.dtype.newbyteorder("<"), copy=False)
        yield f"a{little.dtype.str}{little.shape};".encode()
        yield np.ascontiguousarray(little).tobytes()
    elif isinstance(value, tuple | list):
        yield b"t%d:" % len(value)
        for item in value:
            yield from _encoded(item)
    elif isinstance(value, dict):
        yield b"d%d:" % len(value)
        for item in sorted(value.items()):
            yield from _encoded(item)
    else:
        raise TypeError(f"parts: expected strings, numbers, arrays or containers of them, got {type(value).__name__}")
