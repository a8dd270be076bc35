"""Times a function against its peers in one run: best of several, wall and CPU seconds, ratios in a table."""

from __future__ import annotations

import os
import platform
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass


@dataclass(frozen=True)
class Timing:
    """Best of several runs."""

    wall: float
    """Wall-clock seconds."""
    cpu: float
    """CPU seconds of all threads of this process."""


def best(job: Callable[[], object], *, repeat: int = 5) -> Timing:
    """Run `job` once to warm up and then `repeat` times; return the least wall and CPU seconds."""
    job()
    walls, cpus = [], []
    for _ in range(repeat):
        wall, cpu = time.perf_counter(), time.process_time()
        job()
        walls.append(time.perf_counter() - wall)
        cpus.append(time.process_time() - cpu)
    return Timing(min(walls), min(cpus))


def machine() -> str:
    """Describe the machine in one line."""
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    return f"{platform.machine()}, {cores} cores, {platform.system()}, Python {platform.python_version()}"


def table(title: str, header: list[str], rows: list[list[str]]) -> str:
    """Format a Markdown table under a title."""
    lines = [f"### {title}", "", "| " + " | ".join(header) + " |", "|" + " --- |" * len(header)]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join([*lines, ""])


@contextmanager
def ahead_of_others() -> Iterator[None]:
    """Give this process, and processes that it starts meanwhile, the highest priority, if that is allowed."""
    kind, parameters = os.sched_getscheduler(0), os.sched_getparam(0)
    try:
        with suppress(OSError):
            os.sched_setscheduler(0, os.SCHED_RR, os.sched_param(1))
        yield
    finally:
        os.sched_setscheduler(0, kind, parameters)
