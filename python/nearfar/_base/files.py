"""Atomic writing of files and folders: a temporary one is written, flushed to disk, and renamed to the target."""

from __future__ import annotations

import errno
import os
import shutil
import stat
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from nearfar import _core
from nearfar._base import aside, background

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
    aside.clear(target)
    with aside.temporary_beside(target, folder=False) as temporary:
        yield temporary
        _flush(temporary)
        _keep_mode(target, temporary)
        with aside.naming_errors(target):
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
    aside.restore(target)
    _check_replaceable(target, marker)
    aside.clear(target)
    with aside.temporary_beside(target, folder=True) as temporary:
        yield temporary
        for item in sorted(temporary.rglob("*")):
            _flush(item)
        _flush(temporary)
        _keep_mode(target, temporary)
        _check_replaceable(target, marker)
        with aside.naming_errors(target):
            _take_place(temporary, target)
        _flush(target.parent)


def write(path: Path, data: bytes | memoryview) -> None:
    """Write bytes in pieces: Ctrl-C waits for the end of each. A view must consist of bytes."""
    whole = memoryview(data)
    with open(path, "wb", buffering=0) as file:
        while len(whole):
            whole = whole[file.write(whole[:_PIECE]) :]


def write_with_mode(path: Path, data: bytes, mode: int) -> None:
    """Write a file atomically, with its mode set before any content is readable."""
    with atomic_file(path) as temporary:
        temporary.chmod(mode)
        temporary.write_bytes(data)


def restore(path: str | os.PathLike[str]) -> None:
    """Restore a folder whose replacement was interrupted by the process's death, on systems without an exchange."""
    aside.restore(_absolute(path))


def _take_place(temporary: Path, target: Path) -> None:
    """Replace a folder and remove the old one; if the system supports it, one of them exists at any time."""
    if not target.exists():
        os.rename(temporary, target)
        return
    if _core.exchange_paths(str(temporary), str(target)):
        shutil.rmtree(temporary, ignore_errors=True)
        return
    old = aside.replaced(target)
    shutil.rmtree(old, ignore_errors=True)
    try:
        os.rename(target, old)
        os.rename(temporary, target)
    finally:
        # Also after an error between the two; after a crash the next caller of `restore` does this.
        aside.restore(target)
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
    """Absolute path, which has a name even for "."; symbolic links are resolved, so that the link itself stays."""
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
