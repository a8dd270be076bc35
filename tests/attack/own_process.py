"""The memory and the life of this process, where the system tells and limits them."""

from __future__ import annotations

import signal
import sys

_SET_DEATH_SIGNAL = 1
IS_LINUX = sys.platform == "linux"


def reset_peak() -> int:
    """Forget the peak so far; returns the memory in use, bytes."""
    if not IS_LINUX:
        return 0
    with open("/proc/self/clear_refs", "w", encoding="ascii") as control:
        control.write("5")
    return _status("VmRSS")


def peak() -> int:
    """Return the greatest memory in use since `reset_peak`, bytes."""
    return _status("VmHWM") if IS_LINUX else 0


def _status(name: str) -> int:
    with open("/proc/self/status", encoding="ascii", errors="replace") as status:
        return 1024 * int(next(line for line in status if line.startswith(name)).split()[1])


def limit_addresses(size: int) -> None:
    """Let allocations fail beyond a size, as on a machine with that much memory."""
    if IS_LINUX:
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (size, resource.getrlimit(resource.RLIMIT_AS)[1]))


def die_with_parent() -> None:
    """Let the system kill this process when the one that started it dies, so that no hanging case stays behind."""
    if IS_LINUX:
        import ctypes

        ctypes.CDLL(None).prctl(_SET_DEATH_SIGNAL, signal.SIGKILL)
