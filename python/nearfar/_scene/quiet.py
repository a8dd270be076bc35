"""Silence of one thread that reads a file: Python's and NumPy's warnings, and what trimesh logs."""

from __future__ import annotations

import logging
import threading
import warnings
from collections.abc import Iterator
from contextlib import contextmanager, suppress

import numpy as np

_silent: dict[int, list[str]] = {}
"""The warnings of trimesh in each silent thread."""
_changes = threading.Lock()


class _Membership(type):
    """Counts every warning as one of a class while the thread that raises it is silent."""

    def __subclasscheck__(cls, _category: type) -> bool:
        return threading.get_ident() in _silent


class _OfSilentThread(Warning, metaclass=_Membership):
    """Category of all warnings of silent threads.

    `warnings.catch_warnings` would replace the filters of all threads, and two that overlap restore each other's.
    """


_IGNORED = ("ignore", None, _OfSilentThread, None, 0)
"""The filter, as `warnings` stores it."""


class _Collector(logging.Handler):
    """Keeps the warnings of silent threads, and passes on the records of others."""

    def emit(self, record: logging.LogRecord) -> None:
        messages = _silent.get(threading.get_ident())
        if messages is None:
            if _LOGGER.parent is not None:
                _LOGGER.parent.callHandlers(record)
        elif record.levelno >= logging.WARNING:
            messages.append(record.getMessage().partition("\n")[0])


_LOGGER, _COLLECTOR = logging.getLogger("trimesh"), _Collector()


@contextmanager
def silence() -> Iterator[list[str]]:
    """Hide warnings of this thread within a block, and collect the first lines of those that trimesh logs."""
    messages: list[str] = []
    _enter(messages)
    try:
        with np.errstate(all="ignore"):
            yield messages
    finally:
        _leave()


def _enter(messages: list[str]) -> None:
    global _propagates
    with _changes:
        if not _silent:
            _propagates, _LOGGER.propagate = _LOGGER.propagate, False
            _LOGGER.addHandler(_COLLECTOR)
        _silent[threading.get_ident()] = messages
        # Filters that came since another thread was silenced come after this one.
        warnings.filterwarnings("ignore", category=_OfSilentThread)


def _leave() -> None:
    with _changes:
        del _silent[threading.get_ident()]
        if not _silent:
            _LOGGER.removeHandler(_COLLECTOR)
            _LOGGER.propagate = _propagates
            with suppress(ValueError):  # someone has reset the filters
                warnings.filters.remove(_IGNORED)  # type: ignore[attr-defined]


_propagates = True
"""Whether the logger passed records on before any thread was silent."""
