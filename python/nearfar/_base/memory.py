"""Memory that results may take: what cannot fit is refused before work begins."""

from __future__ import annotations

from pathlib import Path

_SMALL = 1 << 28
"""Bytes that are not checked: a check takes as long as a small picture."""

_SYSTEM, _GROUP = Path("/proc/meminfo"), Path("/sys/fs/cgroup/memory.max")
"""Files in which Linux says how much memory there is, and how much a container may have."""


def check_room(argument: str, what: str, size: int) -> None:
    """Refuse a result of `size` bytes that `argument` asks for; MemoryError if the system says that it cannot fit."""
    if size <= _SMALL:
        return
    room = _room()
    if room is not None and size > room:
        raise MemoryError(f"{argument}: {what} takes {size / 1e9:.1f} GB of memory, and {room / 1e9:.1f} GB are free")


def _room() -> int | None:
    """Bytes that a process may still take; None where the system does not say."""
    try:
        lines = (line.split() for line in _SYSTEM.read_text(encoding="ascii").splitlines())
        kilobytes = {words[0]: int(words[1]) for words in lines if len(words) > 1}
        room = 1024 * (kilobytes["MemAvailable:"] + kilobytes.get("SwapFree:", 0))
    except (OSError, KeyError, ValueError):
        return None
    try:
        return min(room, int(_GROUP.read_text(encoding="ascii")))
    except (OSError, ValueError):  # there is no limit
        return room
