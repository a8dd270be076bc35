"""Temporary files and folders beside the ones that they will replace: names, owners, and what dead owners left."""

from __future__ import annotations

import os
import re
import secrets
import shutil
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from nearfar._base import locks

MAX_NAME = 255
"""Bytes of a name that file systems take."""

_TAG = 6
"""Random bytes of a name."""

_LOCK = ".lock"
"""End of the name of a lock file, which is that of the temporary before it."""


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

    A lock file beside it shows others that its owner lives. If the block raises, what is at its path is removed.
    """
    start, end = _affixes(target)
    path, lock = target.with_name(f"{start}{secrets.token_hex(_TAG)}{end}"), None
    try:
        with naming_errors(target):
            os.stat(target.parent / ".")  # making the lock would make the folder
            # The lock is there first and goes last, so that nobody sees a temporary without an owner.
            lock = locks.try_hold(_lock_path(path))
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
        raise OSError(error.errno, f"cannot be written: {error.strerror}", str(target)) from None


def clear(target: Path) -> None:
    """Remove the temporaries of a target whose owners died."""
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


def _lock_path(path: Path) -> Path:
    return path.with_name(path.name + _LOCK)


def _remove(path: Path) -> None:
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path, ignore_errors=True)
    else:
        path.unlink(missing_ok=True)


def _affixes(target: Path) -> tuple[str, str]:
    """Beginning and end of the names of temporaries: the target's name, shortened to what fits."""
    tag = 2 * _TAG
    suffix = target.suffix if len(os.fsencode(target.suffix)) <= MAX_NAME // 2 else ""
    room = MAX_NAME - len("..") - tag - len(os.fsencode(suffix + _LOCK))
    stem = target.name.removesuffix(suffix)
    while len(os.fsencode(stem)) > room:
        stem = stem[:-1]
    return f".{stem}.", suffix
