"""Calls a function for many items in worker processes of this machine, which end on Ctrl-C and with their parent."""

from __future__ import annotations

import concurrent.futures
import multiprocessing
import os
import signal
import threading
import time
from collections.abc import Callable, Sequence
from concurrent.futures.process import BrokenProcessPool
from multiprocessing.process import BaseProcess
from multiprocessing.synchronize import Event
from typing import Any, TypeVar

from nearfar._base import progress

Item = TypeVar("Item")
Result = TypeVar("Result")

END_TIMEOUT = 0.2
"""Seconds that an interrupted caller waits until its workers end by themselves."""

_is_stopped: Callable[[], bool] | None = None
"""In a worker process, returns whether the parent process was interrupted; None elsewhere."""


def map_over_processes(
    function: Callable[[Item, progress.Report], Result], items: Sequence[Item], label: str, workers: int
) -> list[Result]:
    """Call a function for each item in worker processes; `nearfar._base.distribute` documents the arguments."""
    # Graphics drivers hang in forked processes, hence "spawn".
    context = multiprocessing.get_context("spawn")
    stop = context.Event()
    workers = min(workers, len(items))
    threads = max(1, (os.cpu_count() or 1) // workers)
    pool = concurrent.futures.ProcessPoolExecutor(
        workers, mp_context=context, initializer=_set_up_worker, initargs=(stop, threads)
    )
    try:
        futures = [pool.submit(_in_worker, function, item) for item in items]
        with progress.bar(label) as report:
            for number, future in enumerate(concurrent.futures.as_completed(futures)):
                future.result()  # raises the function's exception
                report(number, len(items))
        return [future.result() for future in futures]
    except BrokenProcessPool:
        message = "workers: a process ended at once; a script needs `if __name__ == '__main__':` around its statements"
        raise RuntimeError(message) from None
    except Exception:
        stop.set()
        raise
    except BaseException:
        stop.set()
        # The pool exposes its processes only here, and forgets them at shutdown.
        processes = list((pool._processes or {}).values())
        # A worker that is terminated while it writes a result leaves a part, and a reader would wait for the rest.
        results: Any = pool._result_queue
        results._writer.close()
        pool.shutdown(wait=False, cancel_futures=True)
        _end(processes)
        raise
    finally:
        pool.shutdown(wait=True, cancel_futures=True)


def _end(processes: Sequence[BaseProcess]) -> None:
    """Give processes a short time to end, then terminate them, since starting processes do not check the event yet."""
    deadline = time.monotonic() + END_TIMEOUT
    for process in processes:
        process.join(max(0.0, deadline - time.monotonic()))
    for process in processes:
        # Safe, since files are written atomically.
        process.terminate()


def _set_up_worker(stop: Event, threads: int) -> None:
    """Set up a worker process before its first kernel."""
    global _is_stopped
    _is_stopped = stop.is_set
    # Ctrl-C reaches all processes of a terminal; only the parent process reacts to it and stops the workers.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end_with_parent, name="nearfar worker's parent", daemon=True).start()
    os.environ.setdefault("NEARFAR_NUM_THREADS", str(threads))
    os.environ["NEARFAR_PROGRESS"] = "0"


def _end_with_parent() -> None:
    """End this process when its parent has ended, even by SIGKILL, because the system closes the parent's pipe."""
    parent = multiprocessing.parent_process()
    assert parent is not None
    parent.join()
    # Safe, since files are written atomically.
    os._exit(1)


def _in_worker(function: Callable[[Item, progress.Report], Result], item: Item) -> Result:
    def raise_if_stopped(_done: int, _total: int) -> None:
        if _is_stopped is not None and _is_stopped():
            raise concurrent.futures.CancelledError

    return function(item, raise_if_stopped)
