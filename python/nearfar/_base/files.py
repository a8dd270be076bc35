"""Atomic writing of files and folders: a temporary one is written, flushed to disk, and renamed to the target.

The name of a temporary contains its target's name, and a lock file beside it shows whether its owner still runs, so
that leftovers of killed processes can be removed.
"""

from __future__ import annotations

import errno
import os
import re
import secrets
import shutil
import stat
from collections.abc import Iterator
from contextlib import AbstractContextManager, contextmanager, suppress
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import background, locks

MAX_NAME = 255
"""Greatest length of a file name, bytes."""

_TAG = 6
"""Random bytes in a name."""

_LOCK = ".lock"
"""Suffix of a lock file, added to the name of its temporary."""

_PIECE = 1 << 24
"""Bytes written between two checks for Ctrl-C."""


@contextmanager
def atomic_file(path: str | os.PathLike[str]) -> Iterator[Path]:
    """Write a file atomically: yield an empty temporary file in the folder of `path`, with the same suffix.

    It replaces `path` when the block ends, and is removed if the block raises. OSError that names `path`, before the
    block runs, if the folder is missing or not writable, or `path` is a folder, a pipe or a device.
    """
    target = _absolute(path)
    if target.is_dir():
        raise IsADirectoryError(errno.EISDIR, "is a folder, expected a file path", str(target))
    if target.exists() and not target.is_file():
        raise OSError(errno.EINVAL, "is a pipe, a socket or a device, expected a file path", str(target))
    clear(target)
    with temporary_beside(target, folder=False) as temporary:
        yield temporary
        _flush(temporary)
        _keep_mode(target, temporary)
        with naming_errors(target):
            os.replace(temporary, target)
        _flush(target.parent)


@contextmanager
def atomic_folder(path: str | os.PathLike[str], *, marker: str = "manifest.json") -> Iterator[Path]:
    """Write a folder atomically: yield an empty temporary folder beside `path`.

    It replaces `path` when the block ends, and is removed if the block raises. An existing folder is replaced only if
    it is empty or contains `marker`, the name of the file that every folder of this kind contains. OSError that names
    `path`, before the block runs, if the parent folder is missing or not writable, or `path` is a file or a folder with
    other files.
    """
    target = _absolute(path)
    restore(target)
    _check_replaceable(target, marker)
    clear(target)
    with temporary_beside(target, folder=True) as temporary:
        yield temporary
        for item in sorted(temporary.rglob("*")):
            _flush(item)
        _flush(temporary)
        _keep_mode(target, temporary)
        _check_replaceable(target, marker)
        with naming_errors(target):
            _take_place(temporary, target)
        _flush(target.parent)


def check_writable(writing: AbstractContextManager[Path]) -> None:
    """Begin a write, such as `atomic_file(path)`, and abandon it: the target stays unchanged. OSError as there."""
    with suppress(_TrialError), writing:
        raise _TrialError


class _TrialError(Exception):
    """Ends a trial write."""


def write(path: Path, data: bytes | memoryview) -> None:
    """Write bytes in pieces, so that Ctrl-C waits only for the end of a piece. A memoryview must consist of bytes."""
    remaining = memoryview(data)
    with open(path, "wb", buffering=0) as file:
        while len(remaining):
            remaining = remaining[file.write(remaining[:_PIECE]) :]


def write_png(path: Path, pixels: NDArray[np.uint8]) -> None:
    """Write a picture (H, W, 3 or 4) as PNG atomically."""
    from PIL import Image

    with atomic_file(path) as temporary:
        Image.fromarray(pixels).save(temporary, format="PNG")


def write_with_mode(path: Path, data: bytes, mode: int) -> None:
    """Write a file atomically, with its mode set before any content is readable."""
    with atomic_file(path) as temporary:
        temporary.chmod(mode)
        temporary.write_bytes(data)


def _take_place(temporary: Path, target: Path) -> None:
    """Replace a folder and remove the old one; if the system can exchange paths, one of them exists at any time."""
    if not target.exists():
        os.rename(temporary, target)
        return
    if _core.exchange_paths(str(temporary), str(target)):
        shutil.rmtree(temporary, ignore_errors=True)
        return
    old = replaced_path(target)
    shutil.rmtree(old, ignore_errors=True)
    try:
        os.rename(target, old)
        os.rename(temporary, target)
    finally:
        # For an error between the two renames; after a crash the next caller of `restore` repairs it.
        restore(target)
    shutil.rmtree(old, ignore_errors=True)


def _keep_mode(target: Path, temporary: Path) -> None:
    """Copy the permissions of the target to its replacement."""
    with suppress(OSError):
        os.chmod(temporary, stat.S_IMODE(os.stat(target).st_mode))


def _check_replaceable(target: Path, marker: str) -> None:
    if not target.exists():
        return
    if not target.is_dir():
        raise NotADirectoryError(errno.ENOTDIR, "is a file, expected a folder path", str(target))
    if any(target.iterdir()) and not (target / marker).is_file():
        message = f"holds other files (no {marker}), expected a new or empty folder"
        raise FileExistsError(errno.EEXIST, message, str(target))


def _absolute(path: str | os.PathLike[str]) -> Path:
    """Return an absolute path, which has a name even for "."; of a symbolic link the target, so that the link stays."""
    target = Path(os.path.abspath(path))
    return Path(os.path.realpath(target)) if target.is_symlink() else target


def _flush(path: Path) -> None:
    """Flush a file to disk, which takes seconds for large ones; Ctrl-C does not wait for it."""
    if path.is_dir() and os.name == "nt":
        return
    flags = os.O_RDONLY if path.is_dir() else os.O_RDWR

    def flush() -> None:
        descriptor = os.open(path, flags)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)

    background.run(flush)


def replaced_path(target: Path) -> Path:
    """Return the path of the old target during a replacement, on systems that cannot exchange two paths."""
    start, end = _affixes(target)
    return target.with_name(f"{start}replaced{end}")


def restore(path: str | os.PathLike[str]) -> None:
    """Rename the old target back if a process was killed while replacing it, on systems that cannot exchange paths."""
    target = _absolute(path)
    waiting = replaced_path(target)
    if not target.exists() and waiting.exists():
        with suppress(OSError):
            os.rename(waiting, target)


@contextmanager
def temporary_beside(target: Path, *, folder: bool) -> Iterator[Path]:
    """Create an empty file or folder beside the target, because a rename across file systems would copy.

    A lock file beside it marks it as owned by a running process. If the block raises, the temporary is removed.
    """
    start, end = _affixes(target)
    path, lock = target.with_name(f"{start}{secrets.token_hex(_TAG)}{end}"), None
    try:
        with naming_errors(target):
            os.stat(target.parent / ".")  # raises for a missing folder, which creating the lock would create
            # The lock is created first and removed last, so that no temporary is ever seen without an owner.
            lock = locks.try_hold(path.with_name(path.name + _LOCK))
            if folder:
                path.mkdir()
            else:
                path.touch(exist_ok=False)
        yield path
    except BaseException:
        with suppress(OSError):
            _remove(path)
        raise
    finally:
        if lock is not None:
            locks.remove(lock)


@contextmanager
def naming_errors(target: Path) -> Iterator[None]:
    """Replace the temporary path in errors by the caller's path."""
    try:
        yield
    except OSError as error:
        raise OSError(error.errno, f"cannot be written: {reason_of(error)}", str(target)) from None


def reason_of(error: OSError) -> str:
    """Return why an operation failed, also for errors of libraries that have only a text or a number."""
    return error.strerror or (os.strerror(error.errno) if error.errno else str(error) or type(error).__name__)


def clear(target: Path) -> None:
    """Remove temporaries of a target whose owners have died."""
    start, end = _affixes(target)
    pattern = re.compile(re.escape(start) + f"[0-9a-f]{{{2 * _TAG}}}" + re.escape(end + _LOCK))
    with suppress(OSError):
        for name in os.listdir(target.parent):
            if pattern.fullmatch(name):
                _remove_if_dead(target.with_name(name))


def _remove_if_dead(lock_path: Path) -> None:
    with suppress(OSError):
        lock = locks.try_hold(lock_path)
        if lock is not None:
            _remove(lock_path.with_name(lock_path.name.removesuffix(_LOCK)))
            locks.remove(lock)


def _remove(path: Path) -> None:
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path, ignore_errors=True)
    else:
        path.unlink(missing_ok=True)


def _affixes(target: Path) -> tuple[str, str]:
    """Return prefix and suffix of temporaries' names: parts of the target's name, shortened to fit."""
    tag = 2 * _TAG
    suffix = target.suffix if len(os.fsencode(target.suffix)) <= MAX_NAME // 2 else ""
    max_stem_bytes = MAX_NAME - len("..") - tag - len(os.fsencode(suffix + _LOCK))
    stem = target.name.removesuffix(suffix)
    while len(os.fsencode(stem)) > max_stem_bytes:
        stem = stem[:-1]
    return f".{stem}.", suffix
