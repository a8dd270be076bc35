"""Choice between the CPU and a graphics adapter, for all stages that support both."""

from __future__ import annotations

import atexit
import contextlib
import os
import platform
import weakref
from collections.abc import Iterator
from pathlib import Path
from typing import Literal, get_args

from nearfar import _core
from nearfar._base import check as checks
from nearfar._base.errors import DeviceError

Backend = Literal["auto", "cpu", "gpu"]
"""Name of a back end; see `device_for`."""
BACKENDS: tuple[Backend, ...] = get_args(Backend)
VARIABLE = "NEARFAR_ADAPTER"
"""Environment variable that names an adapter."""

Work = tuple[tuple[str, ...], int]
"""A kind of work: names of the computed images, and number of samples per pixel."""

_selected: str | None = None
"""Adapter selected by `select`."""
# The following three sets contain process numbers, so that a forked child starts anew.
_logged: set[int] = set()
"""Processes in which the reason for using the CPU needs no logging any more."""
_searched: set[tuple[int, str | None]] = set()
"""Processes and adapter names for which adapters were searched."""
_failed: set[tuple[int, str | None]] = set()
"""Processes and adapter names for which no adapter could be opened."""
_faster: weakref.WeakKeyDictionary[object, dict[tuple[str, Work], bool]] = weakref.WeakKeyDictionary()
"""For each source, whether an adapter was faster than the CPU, by the adapter's label and the kind of work."""


def check(backend: str | None) -> Backend:
    """Return a backend's name, "auto" for None; TypeError or ValueError for unknown ones."""
    return "auto" if backend is None else checks.choice("backend", backend, BACKENDS)


def device_for(backend: str | None, source: object, work: Work | None = None) -> _core.GpuDevice | None:
    """Open the graphics adapter for a kind of work on a source, or return None for the CPU.

    "gpu" is the selected adapter, else the best one; DeviceError if there is none. "auto" is that adapter if it is
    hardware, or if measurements (`remember`) show that it is faster at this work on this source; else the CPU. Without
    `work`, measurements are ignored. None is like "auto", but logs the use of the CPU only if an adapter is selected.
    """
    if check(backend) == "cpu":
        return None
    if backend == "gpu":
        return open_device()
    # A user who selects an adapter wants to know why it is not used.
    key, should_log = (os.getpid(), selected()), backend is not None or selected() is not None
    if key in _failed:
        return None
    try:
        return _choose_device(source, work, should_log)
    except DeviceError as error:
        _failed.add(key)
        if should_log:
            _log_once(str(error))
        return None


def _choose_device(source: object, work: Work | None, should_log: bool) -> _core.GpuDevice | None:
    """Return the device for "auto", None for the CPU; DeviceError if an adapter fails or there is none.

    With `should_log`, it is logged if the CPU is used because no adapter is hardware.
    """
    measured = {} if work is None else _faster.get(source, {})
    if measured or is_hardware(selected()):
        device = open_device()
        if work is not None and (device.label, work) in measured:
            return device if measured[device.label, work] else None
        if device.kind != "software":
            return device
    if should_log:
        _log_software()
    return None


def open_device(adapter: str | None = None) -> _core.GpuDevice:
    """Return the device of a named adapter, or else of the selected or the best one; a lost device is reopened.

    DeviceError if there is none.
    """
    adapter = selected() if adapter is None else adapter
    is_hardware(adapter)
    return _core.GpuDevice(adapter)


def remember(source: object, work: Work, label: str, faster: bool) -> None:
    """Store, for the lifetime of a source, whether an adapter was faster than the CPU at some work on it."""
    _faster.setdefault(source, {})[label, work] = faster


def selected() -> str | None:
    """Return the back end, or the part of a name, that selects the adapter; None for the best adapter."""
    return _selected if _selected is not None else os.environ.get(VARIABLE, "").strip() or None


def select(adapter: str | None) -> None:
    """Select an adapter for this process; None returns to `NEARFAR_ADAPTER`, or to the best adapter if unset."""
    global _selected
    _selected = adapter


def is_hardware(adapter: str | None) -> bool:
    """Return whether any adapter of that name is hardware, not a software implementation."""
    with _silence_search(adapter):
        return _core.gpu_is_hardware(adapter)


def adapters() -> list[tuple[str, str, str, str, str, int, int]]:
    """Return all adapters, best first; `_core.gpu_adapters` describes the fields."""
    with _silence_search(None):
        return _core.gpu_adapters()


@contextlib.contextmanager
def _silence_search(adapter: str | None) -> Iterator[None]:
    """Prevent messages on standard error during a search for adapters.

    Without XDG_RUNTIME_DIR, as in containers and services, Mesa's device-select layer tries to open a display and
    prints an error. nearfar orders adapters itself, so it disables the layer for the first search of a process.
    """
    variable, search = "NODEVICE_SELECT", (os.getpid(), adapter)
    disables_layer = search not in _searched and "XDG_RUNTIME_DIR" not in os.environ and variable not in os.environ
    if disables_layer:
        os.environ[variable] = "1"
    if not _searched:
        atexit.register(_core.gpu_close)
        if hasattr(os, "register_at_fork"):
            os.register_at_fork(after_in_child=_core.gpu_forked)
    _searched.add(search)
    try:
        yield
    finally:
        if disables_layer:
            os.environ.pop(variable, None)


def _log_software() -> None:
    """Log that "auto" uses the CPU because no adapter is hardware; DeviceError if not even a software one works."""
    if os.getpid() in _logged:
        return
    labels = [f"{name} ({backend})" for name, backend, kind, _, refused, *_ in adapters() if not refused]
    if selected() is not None or not labels:
        labels = [open_device().label]
    _log_once(
        f"the processor itself is the only graphics adapter found, as {', '.join(labels)}; install the driver of a "
        "graphics card, or try backend='gpu' and nearfar.gpu.measure"
    )


def _log_once(reason: str) -> None:
    """Log why the CPU is used, once per machine: the cache folder stores the logged reasons."""
    if os.getpid() in _logged:
        return
    _logged.add(os.getpid())
    import logging

    from nearfar._base import cache

    def write(path: Path) -> None:
        path.write_text(reason, encoding="utf-8")

    key = cache.key("nearfar.backend", 1, platform.node(), reason)
    # Without a usable cache, the message repeats in each process.
    with contextlib.suppress(OSError, ValueError):
        if cache.find(key, ".txt") is not None:
            return
        cache.keep(key, ".txt", write)

    logging.getLogger("nearfar").warning("rendering on the CPU: %s", reason)
