"""Compares kernels with peers by run time and error in one run, with the machine's limits, as table and plot."""

from __future__ import annotations

import functools
import os
import re
import threading
import unicodedata
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.harness.report import FOLDER, save_figure, subplots, table
from benchmarks.harness.timing import Timing, best, least, timed

OURS = "nearfar"
"""Beginning of the names of nearfar's cases."""


@dataclass(frozen=True)
class Work:
    """Least work of a kernel."""

    multiply_adds: float = 0.0
    """Number of multiply-adds, in float32, or in float64 if `double`."""
    bytes: float = 0.0
    """Number of bytes that must be read and written."""
    double: bool = False


@dataclass(frozen=True)
class Case:
    """One implementation of a job, with the function that computes the error of its result."""

    name: str
    job: Callable[[], Any]
    error: Callable[[Any], float] | None = None


def greatest_error(truth: Any, part: Any = ...) -> Callable[[Any], float]:
    """Return a function that computes the greatest difference of a result from the truth, or of a part of both."""
    return lambda result: float(np.abs(np.subtract(result, truth))[part].max())


@dataclass(frozen=True)
class Result:
    """Time and error of a case."""

    name: str
    timing: Timing
    error: float | None


@dataclass(frozen=True)
class Limits:
    """Measured limits of this machine with all of its cores."""

    multiply_adds: dict[bool, float] = field(default_factory=dict)
    """Multiply-adds per second in float32 (False) and float64 (True) of NumPy's matrix product, close to the limit."""
    read: float = 0.0
    """Bytes per second read from memory."""

    def seconds(self, work: Work) -> float:
        """Least time in seconds for some work."""
        return max(work.multiply_adds / self.multiply_adds[work.double], work.bytes / self.read)


@functools.cache
def limits() -> Limits:
    """Measure the machine's limits once."""
    rates, side = {}, 1536
    for double in (False, True):
        matrix = np.ones((side, side), np.float64 if double else np.float32)
        rates[double] = side**3 / best(functools.partial(np.matmul, matrix, matrix), warm=False).wall
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    arrays = [np.zeros(1 << 24, np.float32) for _ in range(cores)]

    def read() -> None:
        threads = [threading.Thread(target=part.max) for part in arrays]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()

    return Limits(rates, sum(part.nbytes for part in arrays) / best(read, warm=False).wall)


def print_limits() -> None:
    """Print the machine's limits in one line."""
    limit = limits()
    print(
        f"limits of this machine, measured: {limit.multiply_adds[False] / 1e9:.0f} · 10⁹ multiply-adds a second in "
        f"float32, {limit.multiply_adds[True] / 1e9:.0f} · 10⁹ in float64, {limit.read / 1e9:.0f} GB/s read\n",
        flush=True,
    )


def compare(title: str, cases: Sequence[Case], *, work: Work | None = None, repeat: int = 7, unit: str = "") -> str:
    """Time cases alternately, because machines are noisy; returns a table, and saves a plot of time against error.

    The first case is nearfar's, and ratios are relative to it. With `work` the table also lists each case's time
    relative to the machine's limit for that work. The time of a case is the least of `repeat` rounds; cases that take
    seconds run fewer times. `unit` is the unit of the errors.
    """
    outcomes, first_times = zip(*(timed(case.job) for case in cases), strict=True)
    errors = [case.error(outcome) if case.error else None for case, outcome in zip(cases, outcomes, strict=True)]
    # The first run decides how often a case runs. Its CPU time may include compilation and does not count.
    timings = [Timing(timing.wall, np.inf) for timing in first_times]
    for round_number in range(repeat):
        for n, case in enumerate(cases):
            # Cases that take seconds would dominate the run.
            if round_number > 1 and timings[n].wall > 1.0:
                continue
            if timings[n].wall < 0.5:
                # Another job ran before: wake this case's threads and fill the caches with its data.
                case.job()
            # Fast cases run more often, because a shared machine is quiet only for moments.
            for _ in range(1 if timings[n].wall > 0.05 else 5):
                timings[n] = least(timings[n], timed(case.job)[1])
    results = [Result(case.name, timing, error) for case, timing, error in zip(cases, timings, errors, strict=True)]
    min_seconds = limits().seconds(work) if work else None
    first = results[0].timing.wall
    rows = [
        [
            result.name,
            _milliseconds(result.timing.wall),
            _milliseconds(result.timing.cpu),
            result.timing.wall / first,
            *([result.timing.wall / min_seconds] if min_seconds else []),
            "-" if result.error is None else result.error,
        ]
        for result in results
    ]
    ratios = ["wall ms", "CPU ms", f"× {results[0].name} {{:.2f}}", *(["× limit {:.1f}"] if min_seconds else [])]
    text = table(title, ["", *ratios, f"error{', ' + unit if unit else ''} {{:.1e}}"], rows)
    comparisons[title] = Comparison(title, results, min_seconds, unit)
    picture = draw([comparisons[title]], title)
    return text if picture is None else f"{text}\n![{title}]({picture})\n"


@dataclass(frozen=True)
class Comparison:
    """Result of `compare`."""

    title: str
    results: Sequence[Result]
    min_seconds: float | None
    """Least time in seconds that the work takes on this machine."""
    unit: str


comparisons: dict[str, Comparison] = {}
"""Results by title, so that several can be drawn together."""


def draw(comparisons: Sequence[Comparison], title: str) -> str | None:
    """Save a plot of time against error and return its name; None if no folder is set or no case has an error."""
    folder = os.environ.get(FOLDER)
    if not folder or not all(any(result.error for result in comparison.results) for comparison in comparisons):
        return None
    figure, grid = subplots(1, len(comparisons), figsize=(6.5 * len(comparisons), 4.2), squeeze=False)
    for axes, comparison in zip(grid[0], comparisons, strict=True):
        _panel(axes, comparison)
    # Superscripts become digits, so that names of 10⁴ and 10⁶ differ.
    plain = unicodedata.normalize("NFKC", title)
    name = re.sub(r"[^a-z0-9]+", "-", plain.lower()).strip("-") + ".png"
    save_figure(figure, Path(folder) / name)
    return name


def _panel(axes: Any, comparison: Comparison) -> None:
    """Draw cases by time and error, nearfar's in red, with the Pareto front and the machine's limit."""
    errors = [(result, result.error) for result in comparison.results if result.error is not None]
    # Zero errors have no place on a logarithmic axis and are drawn below all others.
    floor = min(error for _, error in errors if error) / 10
    points = [(result.timing.wall * 1e3, max(error, floor)) for result, error in errors]
    label_positions: list[tuple[float, float]] = []
    for (x, y), (result, error) in zip(points, errors, strict=True):
        axes.scatter(x, y, s=60, color="#c8102e" if result.name.startswith(OURS) else "#888888", zorder=3)
        label = result.name if error else f"{result.name} (0)"
        # Labels of close points are stacked.
        position = (np.log10(x), np.log10(y))
        level = sum(abs(position[0] - a) < 0.8 and abs(position[1] - b) < 0.6 for a, b in label_positions)
        label_positions.append(position)
        axes.annotate(label, (x, y), xytext=(6, 5 + 11 * level), textcoords="offset points", fontsize=8)
    front = sorted(point for point in points if not any(_dominates(other, point) for other in points))
    axes.step([x for x, _ in front], [y for _, y in front], where="post", color="#c8102e", alpha=0.4)
    if comparison.min_seconds:
        axes.axvline(comparison.min_seconds * 1e3, linestyle=":", color="black")
        axes.text(comparison.min_seconds * 1e3, 0.03, " limit", fontsize=8, transform=axes.get_xaxis_transform())
    label = f"error{', ' + comparison.unit if comparison.unit else ''}"
    axes.set(xscale="log", yscale="log", xlabel="milliseconds", ylabel=label, title=comparison.title)
    axes.margins(0.35, 0.2)
    axes.grid(alpha=0.3)


def _dominates(one: tuple[float, float], other: tuple[float, float]) -> bool:
    """Whether `one` is at least as good in both values and better in one."""
    return one != other and one[0] <= other[0] and one[1] <= other[1]


def _milliseconds(seconds: float) -> str:
    value = seconds * 1e3
    return f"{value:.0f}" if value >= 100 else f"{value:.1f}" if value >= 10 else f"{value:.2f}"
