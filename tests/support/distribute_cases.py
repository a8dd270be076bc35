"""Functions that workers of `nearfar._base.distribute` import."""

from __future__ import annotations

import os
import struct
import sys
import time
from collections.abc import Callable
from pathlib import Path

Report = Callable[[int, int], None]


def squared(item: int, report: Report, *, offset: int = 0) -> int:
    report(1, 2)
    if item < 0:
        raise ValueError(f"item: expected a number of at least 0, got {item}")
    return item * item + offset


def environment(item: str, report: Report) -> tuple[int, str | None]:
    """Return the process number and the value of an environment variable."""
    return os.getpid(), os.environ.get(item)


def endless(item: Path, report: Report) -> None:
    """Write a file as a sign of the start, and report until that raises."""
    item.write_text(str(os.getpid()))
    while True:
        time.sleep(0.02)
        report(0, 1)


def deaf(item: Path, report: Report) -> None:
    """Write a file as a sign of the start, and never report."""
    item.write_text(str(os.getpid()))
    while True:
        time.sleep(1)


def half_written(item: Path, report: Report) -> None:
    """Write only the beginning of a result, like a worker that is terminated meanwhile."""
    frame = sys._getframe()
    while "result_queue" not in frame.f_locals and frame.f_back is not None:
        frame = frame.f_back
    os.write(frame.f_locals["result_queue"]._writer.fileno(), struct.pack("!i", 1000))
    item.write_text(str(os.getpid()))
    time.sleep(1000)
