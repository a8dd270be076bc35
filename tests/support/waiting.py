"""Waits for what another thread or program does; a wait is bounded by looks, so that a busy machine passes."""

from __future__ import annotations

import time
from collections.abc import Callable

LOOKS = 2400
PAUSE = 0.05


def wait_until(happened: Callable[[], object]) -> None:
    """Look until something has happened."""
    for _ in range(LOOKS):
        if happened():
            return
        time.sleep(PAUSE)
    raise AssertionError(f"it had not happened after {LOOKS} looks")
