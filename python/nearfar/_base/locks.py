"""Locks of folders that one process writes at a time."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

try:
    import fcntl
except ImportError:  # Windows, where nothing is locked
    fcntl = None  # type: ignore[assignment]


@contextmanager
def alone(path: Path, deed: str | None) -> Iterator[None]:
    """Hold a lock file; the system frees it when the process ends, however it does.

    Parameters
    ----------
    path
        The lock file, which stays. Its folder is made.
    deed
        What another holder does, such as "another build writes into world.zarr"; None waits for its end.

    Raises
    ------
    BlockingIOError
        Another process holds it, and `deed` is given.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    lock = os.open(path, os.O_CREAT | os.O_RDWR, 0o666)
    try:
        if fcntl is not None:
            try:
                fcntl.flock(lock, fcntl.LOCK_EX | (fcntl.LOCK_NB if deed else 0))
            except BlockingIOError:
                raise BlockingIOError(f"{path}: {deed}") from None
            except OSError:
                pass  # some network file systems have no locks
        yield
    finally:
        with suppress(OSError):
            os.close(lock)
