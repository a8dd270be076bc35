"""Waits for another thread or program, bounded by the number of checks, so that a busy machine passes."""

from __future__ import annotations

import time
from collections.abc import Callable

LOOKS = 2400
PAUSE = 0.05


def wait_until(happened: Callable[[], object]) -> None:
    """Poll until an event has happened."""
    for _ in range(LOOKS):
        if happened():
            return
        time.sleep(PAUSE)
    raise AssertionError(f"it had not happened after {LOOKS} looks")
