"""Many objects at once: over processes of this machine, or over a cluster."""

from __future__ import annotations

import concurrent.futures
import multiprocessing
import os
import signal
from collections.abc import Callable
from concurrent.futures.process import BrokenProcessPool
from typing import Any

from nearfar._base import progress
from nearfar.lod._levels import Levels
from nearfar.lod._measure.one_object import Settings, measure_one
from nearfar.lod._model import LodModel

Done = tuple[LodModel, list[int]]
"""A model without geometry, and the numbers of the levels that it keeps."""

_stopped: Callable[[], bool] | None = None
"""In a worker: whether whoever started it wants no more."""


def over_processes(objects: list[Levels], settings: Settings, workers: int) -> list[Done]:
    """Measure objects in processes of their own; Ctrl-C ends them, and each keeps what it has done in the cache."""
    if not objects:
        return []
    # Graphics drivers hang in forked children, so that children begin anew.
    context = multiprocessing.get_context("spawn")
    stop = context.Event()
    workers = min(workers, len(objects))
    threads = max(1, (os.cpu_count() or 1) // workers)
    pool = concurrent.futures.ProcessPoolExecutor(
        workers, mp_context=context, initializer=_begin, initargs=(stop, threads)
    )
    try:
        futures = [pool.submit(_in_worker, levels, settings) for levels in objects]
        with progress.bar("measuring") as report:
            for number, _ in enumerate(_finished(futures)):
                report(number, len(objects))
        return [future.result() for future in futures]
    except BrokenProcessPool:
        message = "workers: a process ended at once; a script needs `if __name__ == '__main__':` around what it does"
        raise RuntimeError(message) from None
    except BaseException:
        stop.set()
        raise
    finally:
        pool.shutdown(wait=True, cancel_futures=True)


def over_cluster(objects: list[Levels], settings: Settings, client: Any) -> list[Done]:
    """Measure objects on a Dask cluster; where one fails, or at Ctrl-C, those that have not begun are called off."""
    if not objects:
        return []
    # Meshes go to workers by themselves: within a call they would pass through the scheduler.
    meshes = client.scatter(objects, hash=False)
    futures = [client.submit(_on_cluster, levels, settings, pure=False) for levels in meshes]
    try:
        with progress.bar("measuring") as report:
            done = []
            for number, future in enumerate(futures):
                report(number, len(futures))
                done.append(future.result())
            return done
    except BaseException:
        client.cancel([*futures, *meshes])
        raise


def _finished(futures: list[concurrent.futures.Future[Done]]) -> Any:
    """Each as it is done; the first that failed raises."""
    for future in concurrent.futures.as_completed(futures):
        future.result()
        yield future


def _begin(stop: Any, threads: int) -> None:
    """Set up a worker before its first kernel."""
    global _stopped
    _stopped = stop.is_set
    # Ctrl-C goes to all processes of a terminal: who started us decides what becomes of it.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    os.environ.setdefault("NEARFAR_NUM_THREADS", str(threads))
    os.environ["NEARFAR_PROGRESS"] = "0"


def _in_worker(levels: Levels, settings: Settings) -> Done:
    def look(_done: int, _total: int) -> None:
        if _stopped is not None and _stopped():
            raise concurrent.futures.CancelledError

    return measure_one(levels, settings, look)


def _on_cluster(levels: Levels, settings: Settings) -> Done:
    return measure_one(levels, settings, lambda _done, _total: None)
