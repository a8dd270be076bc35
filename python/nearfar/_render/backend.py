"""Where work is done: the one place that chooses between the CPU and a graphics adapter."""

from __future__ import annotations

import contextlib
import os
import weakref
from collections.abc import Iterator

from nearfar import _core
from nearfar._base import check as checks
from nearfar._base.errors import DeviceError

BACKENDS = ("auto", "cpu", "gpu")
VARIABLE = "NEARFAR_ADAPTER"

Work = tuple[tuple[str, ...], int]
"""A kind of work: the images that are computed, and the samples of a pixel."""

_selected: str | None = None
# Processes that were told something, looked for an adapter, or failed to open one: a forked child starts anew.
_told: set[int] = set()
_looked: set[tuple[int, str | None]] = set()
_failed: set[tuple[int, str | None]] = set()
# For each scene whether the adapter of a label was faster, by kind of work.
_faster: weakref.WeakKeyDictionary[object, dict[tuple[str, Work], bool]] = weakref.WeakKeyDictionary()


def check(backend: str) -> str:
    """Refuse unknown back ends: TypeError or ValueError."""
    return checks.choice("backend", backend, BACKENDS)


def device_for(backend: str, source: object, work: Work | None = None) -> _core.GpuDevice | None:
    """Choose where work on a source is done.

    Parameters
    ----------
    backend
        "cpu"; "gpu" for the selected adapter, or else the best one; "auto" for the same where it is more than the
        processor itself, or was measured to be faster at such work on this source.
    source
        The scene, by whose identity measurements are kept.
    work
        What is done; without it measurements say nothing.

    Returns
    -------
    GpuDevice
        Opened; None for the CPU.

    Raises
    ------
    TypeError, ValueError
        For other names.
    DeviceError
        For "gpu" where no adapter can be used.
    """
    if check(backend) == "cpu":
        return None
    if backend == "gpu":
        return opened()
    here = (os.getpid(), wanted())
    if here in _failed:
        return None
    try:
        return _chosen(source, work)
    except DeviceError as error:
        _failed.add(here)
        _say(str(error))
        return None


def _chosen(source: object, work: Work | None) -> _core.GpuDevice | None:
    """What "auto" takes; DeviceError where an adapter fails or there is none."""
    measured = {} if work is None else _faster.get(source, {})
    if not measured and not is_hardware(wanted()):
        _say_software()
        return None
    device = opened()
    if work is not None and (device.label, work) in measured:
        return device if measured[device.label, work] else None
    if device.kind == "software":
        _say_software()
        return None
    return device


def opened(adapter: str | None = None) -> _core.GpuDevice:
    """Return the device on a named, the selected or the best adapter, opened anew after it was lost.

    DeviceError where there is none.
    """
    adapter = wanted() if adapter is None else adapter
    is_hardware(adapter)
    return _core.GpuDevice(adapter)


def remember(source: object, work: Work, label: str, faster: bool) -> None:
    """Keep whether an adapter was faster than the CPU at some work on a source, as long as the source lives."""
    _faster.setdefault(source, {})[label, work] = faster


def wanted() -> str | None:
    """Return back end or part of a name of the selected adapter; None for the best one."""
    return _selected if _selected is not None else os.environ.get(VARIABLE, "").strip() or None


def select(adapter: str | None) -> None:
    """Select an adapter for this process; None leaves it to `NEARFAR_ADAPTER` again, or to us."""
    global _selected
    _selected = adapter


def is_hardware(adapter: str | None) -> bool:
    """Whether an adapter that a selection leaves is more than the processor itself."""
    with _quietly(adapter):
        return _core.gpu_is_hardware(adapter)


def adapters() -> list[tuple[str, str, str, str, str, int, int]]:
    """Return everything that is found, best first: see `_core.gpu_adapters`."""
    with _quietly(None):
        return _core.gpu_adapters()


@contextlib.contextmanager
def _quietly(adapter: str | None) -> Iterator[None]:
    """Look for adapters without a word on standard error.

    Without XDG_RUNTIME_DIR, as in containers and services, Mesa's layer that sorts devices asks for a display that is
    not there, and its library prints so. We sort adapters ourselves, so the layer is left out, the first time only and
    for this process only.
    """
    variable, looked = "NODEVICE_SELECT", (os.getpid(), adapter)
    silence = looked not in _looked and "XDG_RUNTIME_DIR" not in os.environ and variable not in os.environ
    if silence:
        os.environ[variable] = "1"
    if not _looked and hasattr(os, "register_at_fork"):
        os.register_at_fork(after_in_child=_core.gpu_forked)
    _looked.add(looked)
    try:
        yield
    finally:
        if silence:
            os.environ.pop(variable, None)


def _say_software() -> None:
    """Say why "auto" keeps to the CPU; DeviceError where not even a software adapter can be used."""
    if os.getpid() in _told:
        return
    found = [f"{name} ({backend})" for name, backend, kind, _, refused, *_ in adapters() if not refused]
    if wanted() is not None or not found:
        found = [opened().label]
    _say(
        f"the processor itself is the only graphics adapter found, as {', '.join(found)}; install the driver of a "
        "graphics card, or try backend='gpu' and nearfar.gpu.measure"
    )


def _say(why: str) -> None:
    """Say once in a process why the CPU is taken."""
    if os.getpid() in _told:
        return
    _told.add(os.getpid())
    import logging

    logging.getLogger("nearfar").warning("rendering on the CPU: %s", why)
