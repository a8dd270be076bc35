"""Runs jobs that release the interpreter, such as image encoders, in parallel threads."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

from nearfar import _core

Result = TypeVar("Result")


def results(jobs: Iterable[Callable[[], Result]]) -> Iterator[Result]:
    """Run jobs in parallel, as many at once as kernels have threads, and yield their results in order.

    A job is taken from the iterable after the previous ones have begun, so that memory holds few of them. If no thread
    can be started, it runs in the caller's thread. A job's exception is raised when its result is due; jobs that have
    not begun by then never run.
    """
    workers = _core.thread_count()
    pool = ThreadPoolExecutor(workers)
    pending: deque[Callable[[], Result]] = deque()
    try:
        for job in jobs:
            pending.append(_begin(pool, job))
            if len(pending) > workers:
                yield pending.popleft()()
        while pending:
            yield pending.popleft()()
    finally:
        # Ctrl-C does not wait for jobs in progress.
        pool.shutdown(wait=False, cancel_futures=True)


def _begin(pool: ThreadPoolExecutor, job: Callable[[], Result]) -> Callable[[], Result]:
    """Submit a job to a thread; return the function that waits for its result."""
    try:
        return pool.submit(job).result
    except RuntimeError:
        return job  # no thread can be started: too many, or the interpreter is shutting down
