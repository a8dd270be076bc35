"""Functions that workers of `nearfar._base.distribute` import."""

from __future__ import annotations

import os
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
