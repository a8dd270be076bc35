"""File locks between processes, on every system."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from filelock import FileLock


@contextmanager
def hold(path: Path, other_task: str | None) -> Iterator[None]:
    """Hold a lock file; the system releases it when the process ends, even if it is killed.

    Its folder is created. On a file system without locks, the file's existence is the lock, and the file names the
    process that created it; after that process has ended, the next one on the same machine removes the file. If another
    process holds the lock, BlockingIOError with the text `other_task`, such as "another build writes into world.zarr";
    with `other_task` None the call waits for the lock.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    lock = _lock(path)
    try:
        lock.acquire(blocking=other_task is None)
    except TimeoutError:
        raise BlockingIOError(f"{path}: {other_task}") from None
    try:
        yield
    finally:
        lock.release()


def try_hold(path: Path) -> FileLock | None:
    """Hold a lock file until `remove`; None if another process holds it."""
    lock = _lock(path)
    try:
        lock.acquire(blocking=False)
    except TimeoutError:
        return None
    return lock


def remove(lock: FileLock) -> None:
    """Release a lock without waiters, and remove its file."""
    lock.release()
    with suppress(OSError):
        Path(lock.lock_file).unlink(missing_ok=True)


def _lock(path: Path) -> FileLock:
    from filelock import FileLock  # it imports logging and asyncio

    # Several users may build into one folder.
    return FileLock(path, mode=0o666)
