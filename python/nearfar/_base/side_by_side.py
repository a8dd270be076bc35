"""Runs jobs that release the interpreter, such as encoders of pictures, side by side in threads."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

from nearfar import _core

Result = TypeVar("Result")


def results(jobs: Iterable[Callable[[], Result]]) -> Iterator[Result]:
    """Results of jobs in their order; as many run at once as kernels have threads.

    A job is taken when those before it have begun, so that memory holds few of them. Where there can be no thread, it
    runs in the caller's. What one raises is raised in its turn; those that have not begun then never do.
    """
    workers = _core.thread_count()
    pool = ThreadPoolExecutor(workers)
    waiting: deque[Callable[[], Result]] = deque()
    try:
        for job in jobs:
            waiting.append(_begun(pool, job))
            if len(waiting) > workers:
                yield waiting.popleft()()
        while waiting:
            yield waiting.popleft()()
    finally:
        # Ctrl-C does not wait for what has begun.
        pool.shutdown(wait=False, cancel_futures=True)


def _begun(pool: ThreadPoolExecutor, job: Callable[[], Result]) -> Callable[[], Result]:
    """Begin a job in a thread; the function that waits for its result."""
    try:
        return pool.submit(job).result
    except RuntimeError:
        return job  # the system grants no more threads, or the interpreter ends
