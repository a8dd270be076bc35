"""Silences warnings of Python and NumPy, and log messages of trimesh, in a thread that reads a file."""

from __future__ import annotations

import logging
import threading
import warnings
from collections.abc import Iterator
from contextlib import contextmanager, suppress

import numpy as np

_silent: dict[int, list[str]] = {}
"""Warnings of trimesh collected in each silent thread."""
_changes = threading.Lock()


class _AnyWarning(type):
    """Makes every warning count as a subclass in silent threads."""

    def __subclasscheck__(cls, _category: type) -> bool:
        return threading.get_ident() in _silent


class _SilentThreadWarning(Warning, metaclass=_AnyWarning):
    """Warning category that matches all warnings of silent threads.

    `warnings.catch_warnings` is no alternative: it replaces the filters of all threads, and overlapping uses restore
    each other's filters.
    """


_IGNORED = ("ignore", None, _SilentThreadWarning, None, 0)
"""The filter in the form stored by `warnings`."""


class _Collector(logging.Handler):
    """Collects the warnings of silent threads; forwards the records of other threads."""

    def emit(self, record: logging.LogRecord) -> None:
        messages = _silent.get(threading.get_ident())
        if messages is None and _LOGGER.parent is not None:
            _LOGGER.parent.callHandlers(record)
        elif messages is not None and record.levelno >= logging.WARNING:
            messages.append(record.getMessage().partition("\n")[0])


_LOGGER, _COLLECTOR = logging.getLogger("trimesh"), _Collector()


@contextmanager
def silence() -> Iterator[list[str]]:
    """Hide this thread's warnings within a block; collect the first lines of trimesh's logged warnings."""
    global _propagates
    messages: list[str] = []
    with _changes:
        if not _silent:
            _propagates, _LOGGER.propagate = _LOGGER.propagate, False
            _LOGGER.addHandler(_COLLECTOR)
        _silent[threading.get_ident()] = messages
        # The filter must come before those added since another thread became silent.
        warnings.filterwarnings("ignore", category=_SilentThreadWarning)
    try:
        with np.errstate(all="ignore"):
            yield messages
    finally:
        with _changes:
            del _silent[threading.get_ident()]
            if not _silent:
                _LOGGER.removeHandler(_COLLECTOR)
                _LOGGER.propagate = _propagates
                with suppress(ValueError):  # the filters have been reset
                    warnings.filters.remove(_IGNORED)  # type: ignore[attr-defined]


_propagates = True
"""Original value of the logger's `propagate`."""
