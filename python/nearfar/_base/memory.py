"""Available memory: results that cannot fit are rejected before work begins."""

from __future__ import annotations

import functools
import os
from pathlib import Path

_UNCHECKED_BYTES = 1 << 28
"""Bytes below which sizes are not checked: a check takes as long as a small picture."""

_SYSTEM, _GROUP = Path("/proc/meminfo"), Path("/sys/fs/cgroup")
"""Files in which Linux states memory, and the limit and use of a container."""


def check_room(argument: str, result: str, size: int) -> None:
    """Reject a result of `size` bytes for an argument; MemoryError if the system reports too little memory."""
    if size <= _UNCHECKED_BYTES:
        return
    free = _free_bytes()
    if free is not None and size > free:
        raise MemoryError(f"{argument}: {result} takes {size / 1e9:.1f} GB of memory, and {free / 1e9:.1f} GB are free")


@functools.cache
def installed() -> int:
    """Bytes of the machine's memory, or a default if unknown."""
    try:
        return os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    except (AttributeError, OSError, ValueError):
        return 1 << 40


def _free_bytes() -> int | None:
    """Bytes that a process may still allocate; None if unknown."""
    try:
        lines = (line.split() for line in _SYSTEM.read_text(encoding="ascii").splitlines())
        kilobytes = {words[0]: int(words[1]) for words in lines if len(words) > 1}
        free = 1024 * (kilobytes["MemAvailable:"] + kilobytes.get("SwapFree:", 0))
    except (OSError, KeyError, ValueError):
        return None
    try:
        limit, used = (int((_GROUP / f"memory.{name}").read_text(encoding="ascii")) for name in ("max", "current"))
        lines = (line.split() for line in (_GROUP / "memory.stat").read_text(encoding="ascii").splitlines())
        # Cached file pages count as used, but are freed on demand.
        files = next((int(words[1]) for words in lines if words[0] == "inactive_file"), 0)
    except (OSError, ValueError):  # there is no limit
        return free
    return max(0, min(free, limit - used + files))
