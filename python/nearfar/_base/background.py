"""Runs foreign code in a thread of its own, where Ctrl-C cannot reach it, while the caller stays interruptible.

Python raises KeyboardInterrupt in the main thread only. Foreign code may catch it and go on, keep what it half
imported, or stay in a compiled function that never looks for signals. In a thread of its own it never meets an
interrupt: the main thread waits, raises at once, and drops the result.
"""

from __future__ import annotations

import _thread
import atexit
import contextvars
import importlib
import os
import queue
import sys
import threading
import time
from collections.abc import Callable
from types import ModuleType
from typing import Any, TypeVar

Result = TypeVar("Result")

_POLL = 0.05
"""Seconds between two looks for signals, for systems where they do not end a wait."""

_PATIENCE = 0.3
"""Seconds that the end of the program waits for an abandoned thread."""


class _Ended(SystemExit):
    """Raised in an abandoned thread when the program ends; threads end by it without a message."""


class _Task:
    """Work in a thread. Neither `threading.Thread` nor its events are used: an interrupt can leave their locks held."""

    def __init__(self, work: Callable[[], Any]) -> None:
        self._work: Callable[[], Any] | None = work
        self._context = contextvars.copy_context()
        self._outcome: queue.SimpleQueue[tuple[Any, BaseException | None]] | None = queue.SimpleQueue()
        self._process = os.getpid()
        self._thread = 0
        self._has_begun = self._has_ended = False

    @property
    def is_running(self) -> bool:
        """Whether the work goes on. A forked child has none of its parent's threads."""
        return self._has_begun and not self._has_ended and self._process == os.getpid()

    def start(self) -> None:
        self._has_begun = True
        try:
            _thread.start_new_thread(self._run, ())
        except RuntimeError:
            self._has_ended = True
            raise

    def result(self) -> Any:
        """Wait for the work, and return what it returned or raise what it raised."""
        assert self._outcome is not None
        try:
            while True:
                try:
                    value, error = self._outcome.get(timeout=_POLL)
                    break
                except queue.Empty:
                    continue
        finally:
            # What comes later is dropped.
            self._outcome = None
        if error is None:
            return value
        try:
            raise error
        finally:
            del error

    def end(self, deadline: float) -> None:
        """Interrupt the work again and again, because it may catch that, until it ends or time is up."""
        import ctypes

        while self.is_running and time.monotonic() < deadline:
            ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(self._thread), ctypes.py_object(_Ended))
            time.sleep(_POLL / 5)

    def _run(self) -> None:
        value = error = outcome = None
        try:
            self._thread = _thread.get_ident()
            work, self._work = self._work, None
            assert work is not None
            try:
                value = self._context.run(work)
            except BaseException as raised:
                error = raised
            del work
            outcome = self._outcome
            if outcome is not None:
                outcome.put((value, error))
        finally:
            # Freed here, because it may be large, and an exception refers to this frame.
            value = error = outcome = None
            self._has_ended = True


_last: _Task | None = None
"""The work that was begun last; it still runs if it was abandoned."""


def run(work: Callable[[], Result]) -> Result:
    """Call a function in a thread of its own, and wait for it; Ctrl-C raises at once and leaves the thread behind.

    Only the main thread is interrupted, so in other threads this is an ordinary call. An abandoned function runs to its
    end and its result is dropped; the next call waits for that, so that there is never more than one.

    Parameters
    ----------
    work
        Takes nothing. What it changes beside its result, it may change after the caller was interrupted.

    Returns
    -------
    Any
        What `work` returns; what it raises is raised with its traceback. It sees the caller's context variables.
    """
    global _last
    if threading.current_thread() is not threading.main_thread():
        return work()
    while _last is not None and _last.is_running:
        time.sleep(_POLL / 5)
    task = _last = _Task(work)
    try:
        task.start()
    except RuntimeError:  # while the interpreter ends, and where the system grants no more threads
        return work()
    result: Result = task.result()
    return result


def module(name: str) -> ModuleType:
    """Import a module that catches interrupts while it is imported; afterwards this is a look-up."""
    if name in sys.modules and (_last is None or not _last.is_running):
        return importlib.import_module(name)
    return run(lambda: importlib.import_module(name))


@atexit.register
def _end() -> None:
    """End abandoned work before the interpreter does, which freezes threads wherever they are."""
    if _last is not None and _last.is_running:
        _last.end(time.monotonic() + _PATIENCE)
