"""Temporary files and folders beside the targets that they replace: names, owners, and clean-up after dead owners."""

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
"""Greatest length of a file name, bytes."""

_TAG = 6
"""Random bytes in a name."""

_LOCK = ".lock"
"""Suffix of a lock file, added to the name of its temporary."""


def replaced(target: Path) -> Path:
    """Return the path of the old target during a replacement, on systems that cannot exchange two paths."""
    start, end = _affixes(target)
    return target.with_name(f"{start}replaced{end}")


def restore(target: Path) -> None:
    """Put back the old target, if the process died before it was replaced."""
    waiting = replaced(target)
    if not target.exists() and waiting.exists():
        with suppress(OSError):
            os.rename(waiting, target)


@contextmanager
def temporary_beside(target: Path, *, folder: bool) -> Iterator[Path]:
    """Create an empty file or folder beside the target: a rename across file systems would copy.

    A lock file beside it marks it as owned by a running process. If the block raises, the temporary is removed.
    """
    start, end = _affixes(target)
    path, lock = target.with_name(f"{start}{secrets.token_hex(_TAG)}{end}"), None
    try:
        with naming_errors(target):
            os.stat(target.parent / ".")  # creating the lock would create the folder
            # The lock is created first and removed last, so that no temporary is ever seen without an owner.
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


def _lock_path(path: Path) -> Path:
    return path.with_name(path.name + _LOCK)


def _remove(path: Path) -> None:
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path, ignore_errors=True)
    else:
        path.unlink(missing_ok=True)


def _affixes(target: Path) -> tuple[str, str]:
    """Prefix and suffix of temporaries' names: parts of the target's name, shortened to fit."""
    tag = 2 * _TAG
    suffix = target.suffix if len(os.fsencode(target.suffix)) <= MAX_NAME // 2 else ""
    max_stem_bytes = MAX_NAME - len("..") - tag - len(os.fsencode(suffix + _LOCK))
    stem = target.name.removesuffix(suffix)
    while len(os.fsencode(stem)) > max_stem_bytes:
        stem = stem[:-1]
    return f".{stem}.", suffix
