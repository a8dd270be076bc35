"""Wall and CPU seconds of jobs: once, the best of several runs, or several jobs in turns."""

from __future__ import annotations

import functools
import os
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar

Result = TypeVar("Result")


@dataclass(frozen=True)
class Timing:
    """Time of a run, or the best of several runs."""

    wall: float
    """Wall-clock seconds."""
    cpu: float
    """CPU seconds of all threads of this process."""

    @property
    def ms(self) -> float:
        """Wall-clock milliseconds."""
        return 1e3 * self.wall

    @property
    def cpu_ms(self) -> float:
        """CPU milliseconds."""
        return 1e3 * self.cpu


def least(one: Timing, other: Timing) -> Timing:
    """Return the lesser wall and the lesser CPU time of two runs."""
    return Timing(min(one.wall, other.wall), min(one.cpu, other.cpu))


def timed(
    job: Callable[..., Result], *arguments: Any, clock: Callable[[], float] = time.process_time, **settings: Any
) -> tuple[Result, Timing]:
    """Run a job once; return its result and its time. `clock` measures the time that is returned as CPU time."""
    wall, cpu = time.perf_counter(), clock()
    result = job(*arguments, **settings)
    return result, Timing(time.perf_counter() - wall, clock() - cpu)


def best(job: Callable[[], object], *, repeat: int = 5, warm: bool = True) -> Timing:
    """Run `job` once to warm up and then `repeat` times; return the least wall and CPU seconds."""
    if warm:
        job()
    return functools.reduce(least, (timed(job)[1] for _ in range(repeat)))


def best_in_turns(
    jobs: Mapping[str, Callable[[], object]], repeat: int, clock: Callable[[], float] = time.process_time
) -> dict[str, Timing]:
    """Run jobs alternately, because machines are noisy; return the least times of each."""
    rounds = [{name: timed(job, clock=clock)[1] for name, job in jobs.items()} for _ in range(repeat)]
    return {name: functools.reduce(least, (round_times[name] for round_times in rounds)) for name in jobs}


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


def resident(key: str = "VmRSS", process: int | str = "self") -> int:
    """Resident memory of a process in bytes, or with "VmHWM" its peak since `forget_peak`."""
    lines = Path(f"/proc/{process}/status").read_text(encoding="ascii").splitlines()
    return 1024 * int(next(line for line in lines if line.startswith(key)).split()[1])


def forget_peak() -> None:
    """Reset the peak memory of this process to its current memory."""
    Path("/proc/self/clear_refs").write_text("5", encoding="ascii")
