"""Files and folders that are either complete or absent: written aside, flushed, and renamed."""

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
    """Write a file whole or not at all.

    Parameters
    ----------
    path
        The file to make or replace. Its folder must exist.

    Yields
    ------
    Path
        Where to write: an empty file beside `path` with the same suffix. It takes the place of `path` when the block
        ends, and is removed when the block raises.

    Raises
    ------
    OSError
        Before the block runs, where the folder is missing or not writable or `path` is a folder; names `path`.
    """
    target = _absolute(path)
    if target.is_dir():
        raise IsADirectoryError(errno.EISDIR, "is a folder, expected a place for a file", str(target))
    aside = _aside(target)
    with _named(target):
        os.close(os.open(aside, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o666))
    try:
        yield aside
        _flush(aside)
        with _named(target):
            os.replace(aside, target)
        _flush(target.parent)
    except BaseException:
        aside.unlink(missing_ok=True)
        raise


@contextmanager
def atomic_folder(path: str | os.PathLike[str], *, marker: str = "manifest.json") -> Iterator[Path]:
    """Write a folder whole or not at all.

    Parameters
    ----------
    path
        The folder to make. One that exists is replaced if it is empty or holds `marker`, the file by which we know
        our own; the folder above must exist.
    marker
        Name of the file that every folder of this kind holds.

    Yields
    ------
    Path
        An empty folder beside `path` to write into. It takes the place of `path` when the block ends, and is removed
        when the block raises.

    Raises
    ------
    OSError
        Before the block runs, where the folder above is missing or not writable, or `path` is a file or a folder with
        other people's files; names `path`.
    """
    target = _absolute(path)
    _replaceable(target, marker)
    aside = _aside(target)
    with _named(target):
        aside.mkdir()
    try:
        yield aside
        for item in sorted(aside.rglob("*")):
            _flush(item)
        _flush(aside)
        _swap(aside, target, marker)
        _flush(target.parent)
    except BaseException:
        shutil.rmtree(aside, ignore_errors=True)
        raise


def _swap(aside: Path, target: Path, marker: str) -> None:
    _replaceable(target, marker)
    old = _aside(target)
    replaced = target.exists()
    with _named(target):
        if replaced:
            os.rename(target, old)
        try:
            os.rename(aside, target)
        except OSError:
            if replaced:
                os.rename(old, target)
            raise
    if replaced:
        shutil.rmtree(old, ignore_errors=True)


def _replaceable(target: Path, marker: str) -> None:
    if not target.exists():
        return
    if not target.is_dir():
        raise NotADirectoryError(errno.ENOTDIR, "is a file, expected a place for a folder", str(target))
    if any(target.iterdir()) and not (target / marker).is_file():
        message = f"holds other files (no {marker}), expected a new or empty folder"
        raise FileExistsError(errno.EEXIST, message, str(target))


def _absolute(path: str | os.PathLike[str]) -> Path:
    """The place with a name of its own, which "." has not."""
    return Path(os.path.abspath(path))


def _aside(target: Path) -> Path:
    """Make a unique name in the same folder, because a rename across file systems is a copy."""
    return target.with_name(f".{target.stem}.{secrets.token_hex(6)}{target.suffix}")


@contextmanager
def _named(target: Path) -> Iterator[None]:
    """Errors name what the caller asked for, not our name aside."""
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
