"""Atomic writing of files and folders: a temporary one is written, flushed to disk, and renamed."""

from __future__ import annotations

import errno
import os
import secrets
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def atomic_file(path: str | os.PathLike[str]) -> Iterator[Path]:
    """Write a file completely or not at all.

    Parameters
    ----------
    path
        The file to make or replace. Its folder must exist.

    Yields
    ------
    Path
        An empty temporary file in the folder of `path`, with the same suffix. It replaces `path` when the block ends,
        and is removed if the block raises.

    Raises
    ------
    OSError
        Before the block runs, if the folder is missing or not writable or `path` is a folder; the error names `path`.
    """
    target = _absolute(path)
    if target.is_dir():
        raise IsADirectoryError(errno.EISDIR, "is a folder, expected a place for a file", str(target))
    temporary = _temporary_path(target)
    with _errors_name(target):
        os.close(os.open(temporary, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o666))
    try:
        yield temporary
        _flush(temporary)
        with _errors_name(target):
            os.replace(temporary, target)
        _flush(target.parent)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise


@contextmanager
def atomic_folder(path: str | os.PathLike[str], *, marker: str = "manifest.json") -> Iterator[Path]:
    """Write a folder completely or not at all.

    Parameters
    ----------
    path
        The folder to make. An existing one is replaced only if it is empty or contains `marker`. The folder above must
        exist.
    marker
        Name of the file that every folder of this kind contains.

    Yields
    ------
    Path
        An empty temporary folder beside `path`. It replaces `path` when the block ends, and is removed if the block
        raises.

    Raises
    ------
    OSError
        Before the block runs, if the folder above is missing or not writable, or `path` is a file or a folder with
        other files; the error names `path`.
    """
    target = _absolute(path)
    _check_replaceable(target, marker)
    temporary = _temporary_path(target)
    with _errors_name(target):
        temporary.mkdir()
    try:
        yield temporary
        for item in sorted(temporary.rglob("*")):
            _flush(item)
        _flush(temporary)
        _swap(temporary, target, marker)
        _flush(target.parent)
    except BaseException:
        shutil.rmtree(temporary, ignore_errors=True)
        raise


def _swap(temporary: Path, target: Path, marker: str) -> None:
    _check_replaceable(target, marker)
    old = _temporary_path(target)
    replaced = target.exists()
    with _errors_name(target):
        if replaced:
            os.rename(target, old)
        try:
            os.rename(temporary, target)
        except OSError:
            if replaced:
                os.rename(old, target)
            raise
    if replaced:
        shutil.rmtree(old, ignore_errors=True)


def _check_replaceable(target: Path, marker: str) -> None:
    if not target.exists():
        return
    if not target.is_dir():
        raise NotADirectoryError(errno.ENOTDIR, "is a file, expected a place for a folder", str(target))
    if any(target.iterdir()) and not (target / marker).is_file():
        message = f"holds other files (no {marker}), expected a new or empty folder"
        raise FileExistsError(errno.EEXIST, message, str(target))


def _absolute(path: str | os.PathLike[str]) -> Path:
    """Absolute path, which has a name even for "."."""
    return Path(os.path.abspath(path))


def _temporary_path(target: Path) -> Path:
    """Unique temporary path in the same folder, because a rename across file systems would copy."""
    return target.with_name(f".{target.stem}.{secrets.token_hex(6)}{target.suffix}")


@contextmanager
def _errors_name(target: Path) -> Iterator[None]:
    """Replace the temporary path in errors by the caller's path."""
    try:
        yield
    except OSError as error:
        raise OSError(error.errno, f"cannot be written: {error.strerror}", str(target)) from None


def _flush(path: Path) -> None:
    if path.is_dir() and os.name == "nt":
        return
    descriptor = os.open(path, os.O_RDONLY if path.is_dir() else os.O_RDWR)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)
