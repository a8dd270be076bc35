"""Available memory, to reject results that cannot fit before work begins."""

from __future__ import annotations

import functools
import os
import sys
from pathlib import Path

if sys.platform != "win32":
    import resource

_UNCHECKED_BYTES = 1 << 28
"""Bytes up to which sizes are not checked, because a check takes as long as a small picture."""

_SYSTEM, _GROUP = Path("/proc/meminfo"), Path("/sys/fs/cgroup")
"""Files in which Linux states memory, and the limit and use of a container."""

_PROCESS = Path("/proc/self/statm")
"""File in which Linux states the size of this process's address space in pages."""


def check_room(argument: str, result: str, size: int) -> None:
    """Reject a result of `size` bytes for an argument; MemoryError if the system reports too little memory."""
    if size <= _UNCHECKED_BYTES:
        return
    free = _free_bytes()
    if free is not None and size > free:
        raise MemoryError(f"{argument}: {result} takes {size / 1e9:.1f} GB of memory, and {free / 1e9:.1f} GB are free")


@functools.cache
def installed() -> int:
    """Return the bytes of the machine's memory, or a terabyte if unknown."""
    try:
        return os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    except (AttributeError, OSError, ValueError):
        return 1 << 40


def _free_bytes() -> int | None:
    """Return the bytes that this process may still allocate; None if unknown."""
    known = [free for free in (_free_of_system(), _free_of_group(), _free_of_process()) if free is not None]
    return max(0, min(known)) if known else None


def _free_of_system() -> int | None:
    """Return the free bytes of the system; None if unknown."""
    try:
        lines = (line.split() for line in _SYSTEM.read_text(encoding="ascii").splitlines())
        kilobytes = {words[0]: int(words[1]) for words in lines if len(words) > 1}
        return 1024 * (kilobytes["MemAvailable:"] + kilobytes.get("SwapFree:", 0))
    except (OSError, KeyError, ValueError):
        return None


def _free_of_group() -> int | None:
    """Return the free bytes of the container; None without a limit."""
    try:
        limit, used = (int((_GROUP / f"memory.{name}").read_text(encoding="ascii")) for name in ("max", "current"))
        lines = (line.split() for line in (_GROUP / "memory.stat").read_text(encoding="ascii").splitlines())
        # Cached file pages count as used, but are freed on demand.
        files = next((int(words[1]) for words in lines if words[0] == "inactive_file"), 0)
    except (OSError, ValueError):
        return None
    return limit - used + files


def _free_of_process() -> int | None:
    """Return the bytes by which the address space may grow (`ulimit -v`); None without a limit."""
    if sys.platform == "win32":
        return None
    limit = resource.getrlimit(resource.RLIMIT_AS)[0]
    if limit == resource.RLIM_INFINITY:
        return None
    try:
        return limit - int(_PROCESS.read_text(encoding="ascii").split()[0]) * resource.getpagesize()
    except (OSError, ValueError):
        return None
