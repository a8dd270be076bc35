"""Temporary files and folders beside the ones that they will replace: names, owners, and what dead owners left."""

from __future__ import annotations

import os
import re
import secrets
import shutil
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

try:
    import fcntl
except ImportError:  # Windows; what was left there stays
    fcntl = None  # type: ignore[assignment]

MAX_NAME = 255
"""Bytes of a name that file systems take."""

_TAG = 6
"""Random bytes of a name."""


def replaced(target: Path) -> Path:
    """Return the path where the target waits while another one takes its place, on systems that cannot exchange two."""
    start, end = _affixes(target)
    return target.with_name(f"{start}replaced{end}")


def restore(target: Path) -> None:
    """Put back what was set aside, if the process died before anything took its place."""
    waiting = replaced(target)
    if not target.exists() and waiting.exists():
        with suppress(OSError):
            os.rename(waiting, target)


@contextmanager
def held(target: Path, *, folder: bool) -> Iterator[Path]:
    """Make an empty file or folder beside the target, because a rename across file systems would copy.

    It is locked, so that others see that its owner lives. If the block raises, what is at its path is removed.
    """
    start, end = _affixes(target)
    path, lock = target.with_name(f"{start}{secrets.token_hex(_TAG)}{end}"), None
    try:
        with naming_errors(target):
            lock = _make(path, folder=folder)
        yield path
    except BaseException:
        with suppress(OSError):
            _remove(path)
        raise
    finally:
        _close(lock)


@contextmanager
def naming_errors(target: Path) -> Iterator[None]:
    """Replace the temporary path in errors by the caller's path."""
    try:
        yield
    except OSError as error:
        raise OSError(error.errno, f"cannot be written: {error.strerror}", str(target)) from None


def _make(path: Path, *, folder: bool) -> int | None:
    """Make an empty file or folder and lock it; returns the lock. Before it is locked, another process may clear it."""
    while True:
        if folder:
            path.mkdir()
        made = None if folder else os.open(path, os.O_CREAT | os.O_EXCL | os.O_RDWR, 0o666)
        if fcntl is None:
            _close(made)
            return None
        with suppress(FileNotFoundError):
            lock = os.open(path, os.O_RDONLY) if made is None else made
            try:
                _lock(lock, wait=True)
            except BaseException:
                _close(lock)
                raise
            if path.exists():
                return lock
            _close(lock)


def clear(target: Path) -> None:
    """Remove the temporaries of a target whose owners died. Nothing happens where files cannot be locked."""
    if fcntl is None:
        return
    start, end = _affixes(target)
    pattern = re.compile(re.escape(start) + f"[0-9a-f]{{{2 * _TAG}}}" + re.escape(end))
    with suppress(OSError):
        for name in os.listdir(target.parent):
            if pattern.fullmatch(name):
                _remove_if_dead(target.with_name(name))


def _remove_if_dead(path: Path) -> None:
    with suppress(OSError):
        lock = os.open(path, os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0))
        try:
            if _lock(lock, wait=False):
                _remove(path)
        finally:
            _close(lock)


def _lock(lock: int | None, *, wait: bool) -> bool:
    """Lock an open file; returns whether it is locked. Some network file systems have no locks."""
    if lock is None:
        return False
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | (0 if wait else fcntl.LOCK_NB))
    except OSError:
        return False
    return True


def _close(lock: int | None) -> None:
    if lock is not None:
        os.close(lock)


def _remove(path: Path) -> None:
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path, ignore_errors=True)
    else:
        path.unlink(missing_ok=True)


def _affixes(target: Path) -> tuple[str, str]:
    """Beginning and end of the names of temporaries: the target's name, shortened to what fits."""
    tag = 2 * _TAG
    suffix = target.suffix if len(os.fsencode(target.suffix)) <= MAX_NAME // 2 else ""
    room = MAX_NAME - len("..") - tag - len(os.fsencode(suffix))
    stem = target.name.removesuffix(suffix)
    while len(os.fsencode(stem)) > room:
        stem = stem[:-1]
    return f".{stem}.", suffix
