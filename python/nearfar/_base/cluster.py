"""Runs work on a Dask cluster, local or remote, and returns results in the order of the items."""

from __future__ import annotations

import os
from collections import deque
from collections.abc import Callable, Generator, Iterable, Iterator
from contextlib import contextmanager
from itertools import islice
from typing import Any, TypeVar

from nearfar._base import check, progress

Item = TypeVar("Item")
Result = TypeVar("Result")

LOCAL = "local"
"""Name of the local cluster, with one worker per core."""

_METHODS = ("submit", "scatter", "cancel", "ncores")


def check_client(name: str, client: object) -> None:
    """Raise a TypeError for anything but a `distributed.Client`."""
    if not all(callable(getattr(client, method, None)) for method in _METHODS):
        raise TypeError(f"{name}: expected a distributed.Client, got {check.type_and_value(client)}")


@contextmanager
def client_of(cluster: object) -> Iterator[Any]:
    """Open a client for `LOCAL`, whose workers end with the block; pass on a `distributed.Client`.

    ValueError or TypeError for anything else, ImportError if the package distributed is missing.
    """
    if not isinstance(cluster, str):
        check_client("cluster", cluster)
        yield cluster
        return
    if cluster != LOCAL:
        raise ValueError(f"cluster: expected {LOCAL!r} or a distributed.Client, got {check.shortened(cluster)}")
    try:
        from distributed import Client, LocalCluster
    except ImportError:
        raise ImportError('clusters need the Python package distributed: pip install "nearfar[cluster]"') from None
    settings = {"NEARFAR_NUM_THREADS": "1", "NEARFAR_PROGRESS": "0"}
    count = os.cpu_count() or 1
    with (
        LocalCluster(n_workers=count, threads_per_worker=1, dashboard_address=":0", env=settings) as workers,
        Client(workers) as client,
    ):
        yield client


def in_order(
    function: Callable[[Item, progress.Report], Result],
    items: Iterable[Item],
    client: Any,
    *,
    backlog: int | None = None,
) -> Generator[Result, None, None]:
    """Call a function for each item on a cluster, and yield the results in the order of the items.

    `function` and `items` are those of `nearfar._base.distribute`; `client` is a `distributed.Client`. If a worker is
    lost, another one does its unfinished items. `backlog` is the greatest number of unconsumed results per thread of
    the cluster, None for no limit. The function's first exception is raised; then, and on Ctrl-C, items that have not
    begun are cancelled. ConnectionError if the scheduler is lost, or if an item ended several workers one after the
    other.
    """
    pending: deque[tuple[Any, Any]] = deque()
    iterator = iter(items)
    try:
        while True:
            if client.status != "running":
                raise ConnectionError(f"cluster: the scheduler is lost: the client is {client.status}")
            limit = None if backlog is None else max(0, backlog * max(1, sum(client.ncores().values())) - len(pending))
            for item in islice(iterator, limit):
                # Scattered items go directly to workers; arguments would pass through the scheduler.
                scattered = client.scatter([item], hash=False)[0] if backlog is None else item
                pending.append((client.submit(_on_cluster, function, scattered, pure=False), scattered))
            if not pending:
                return
            future, _ = pending.popleft()
            yield _result(future, client)
    finally:
        # Cancel items that have not begun, unless the scheduler is lost.
        if pending and client.status == "running":
            client.cancel([future for future, _ in pending])


def _result(future: Any, client: Any) -> Any:
    from concurrent.futures import CancelledError

    from distributed import KilledWorker
    from distributed.comm import CommClosedError

    try:
        return future.result()
    except (CancelledError, CommClosedError) as error:
        raise ConnectionError(f"cluster: the scheduler is lost: {check.one_line(str(error), 180)}") from None
    except KilledWorker as error:
        reason = check.one_line(str(error), 180)
        raise ConnectionError(f"cluster: workers ended one after the other: {reason}") from None
    except BaseException:
        client.cancel([future])
        raise


def _on_cluster(function: Callable[[Item, progress.Report], Result], item: Item) -> Result:
    return function(item, lambda _done, _total: None)
