"""Runs a function over many items: in this process, in processes of this machine, or on a Dask cluster."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, TypeVar

from nearfar._base import check, cluster, progress

Item = TypeVar("Item")
Result = TypeVar("Result")

BAR_STEPS_PER_ITEM = 1000
"""Steps of the progress bar per item, if items run in this process."""


def distribute(
    function: Callable[[Item, progress.Report], Result],
    items: Sequence[Item],
    *,
    label: str,
    workers: int | None = None,
    client: Any = None,
) -> list[Result]:
    """Call a function for each item; results are in the order of the items, and do not depend on where it runs.

    `function` takes an item and a function `report`, which it calls as `report(done, total)` between its steps. In
    another process `report` raises an exception after the caller was interrupted; a worker that has not ended 0.2 s
    later is terminated. Workers import the function, so it must be defined at the top of a module, or be a
    `functools.partial` of such a function. Its first exception is raised; items that have not begun are then cancelled.
    Items for other processes must be picklable. `label` is the text of the progress bar, such as "measuring".

    `workers` is the number of processes; None stays in this one. As always with `multiprocessing`, the program's main
    module must be importable: RuntimeError if processes end at once, as in scripts without a guard for `__main__`. Each
    process gets an equal part of the machine's threads. Alternatively `client` is a `distributed.Client`, whose workers
    have nearfar.
    """
    if workers is not None and client is not None:
        raise ValueError("workers: expected None with a client, which has its own workers")
    if workers is not None:
        workers = check.integer("workers", workers, 1, 4096)
    if client is not None:
        cluster.check_client("client", client)
    if not items:
        return []
    if client is not None:
        results: list[Result] = []
        with progress.bar(label) as report:
            for result in cluster.in_order(function, items, client):
                results.append(result)
                report(len(results), len(items))
        return results
    if workers is None:
        return _in_this_process(function, items, label)
    # Imported here, because processes need libraries that `import nearfar` does not load.
    from nearfar._base import processes

    return processes.map_over_processes(function, items, label, workers)


def _in_this_process(
    function: Callable[[Item, progress.Report], Result], items: Sequence[Item], label: str
) -> list[Result]:
    results = []
    with progress.bar(label) as report:
        for number, item in enumerate(items):

            def report_item(done: int, total: int, number: int = number) -> None:
                steps = BAR_STEPS_PER_ITEM * done // max(total, 1)
                report(BAR_STEPS_PER_ITEM * number + steps, BAR_STEPS_PER_ITEM * len(items))

            results.append(function(item, report_item))
    return results
