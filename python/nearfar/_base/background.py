"""Runs code that does not check for signals in a separate thread, so that Ctrl-C does not wait for it.

Python raises KeyboardInterrupt in the main thread only. Code of other packages may catch it and continue, leave an
import half done, or stay in a compiled function. NumPy on large arrays and disk access do not check for signals either.
A separate thread is never interrupted: the main thread waits for it, raises at once, and drops its result.
"""

from __future__ import annotations

import _thread
import atexit
import contextlib
import contextvars
import importlib
import itertools
import os
import queue
import sys
import threading
import time
from collections.abc import Callable
from types import ModuleType
from typing import Any, Generic, TypeVar, cast

from nearfar._base import progress

Result = TypeVar("Result")

_POLL = 0.05
"""Seconds between two checks for signals; on some systems a signal does not end a wait."""

_END_TIMEOUT, _END_INTERRUPTS = 0.3, 10
"""Seconds that the end of the program waits for an abandoned thread, and least number of interrupts that it sends."""


class _Ended(SystemExit):
    """Raised in abandoned threads when the program ends; a SystemExit ends a thread without a message."""


class _Task:
    """Work in a thread. `threading.Thread` and its events are avoided: an interrupt can leave their locks held."""

    def __init__(self, work: Callable[[], Any]) -> None:
        self._work: Callable[[], Any] | None = work
        self._context = contextvars.copy_context()
        self._outcome: queue.SimpleQueue[tuple[Any, BaseException | None]] | None = queue.SimpleQueue()
        self._process = os.getpid()
        self._thread = 0
        self.has_begun = self._has_ended = False

    @property
    def is_running(self) -> bool:
        """Whether the work is running. A forked child has none of its parent's threads."""
        return self.has_begun and not self._has_ended and self._process == os.getpid()

    def begin(self) -> None:
        """Begin the work; RuntimeError if no thread can be started."""
        self.has_begun = True
        try:
            _thread.start_new_thread(self._run, ())
        except RuntimeError:
            self.has_begun = False
            raise

    def result(self) -> Any:
        """Begin the work, wait for it, and return its result or raise its exception.

        RuntimeError if no thread can be started; then `has_begun` is False, unlike for a RuntimeError of the work.
        """
        assert self._outcome is not None
        try:
            self.begin()
            while True:
                with contextlib.suppress(queue.Empty):
                    value, error = self._outcome.get(timeout=_POLL)
                    break
        finally:
            # A later result is dropped.
            self._outcome = None
        if error is None:
            return value
        try:
            raise error
        finally:
            del error

    def end(self, deadline: float) -> None:
        """Interrupt the work repeatedly, since it may catch the exception, until it ends or the deadline passes.

        The least number of interrupts counts from the first one: the thread may hold the interpreter beyond the
        deadline, for example while it loads a library.
        """
        import ctypes

        for number in itertools.count():
            if not self.is_running or (number >= _END_INTERRUPTS and time.monotonic() >= deadline):
                return
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
            # Released here, because the value may be large and an exception refers to this frame.
            value = error = outcome = None
            self._has_ended = True


_tasks: list[_Task] = []
"""Tasks that were begun. A running task without a waiting caller has been abandoned."""

_tasks_alone: list[_Task] = []


def run(work: Callable[[], Result], *, alone: bool = False) -> Result:
    """Call a function in a separate thread and return its result; Ctrl-C raises at once and abandons the thread.

    In other threads, which are never interrupted, this is an ordinary call. An abandoned function runs until it
    returns, with its side effects, and its result is dropped. Exceptions are raised with their traceback. The function
    sees the caller's context variables. `alone` is for work that changes shared state, such as imports and reads by
    packages with caches: the call first waits for abandoned work of this kind.
    """
    if threading.current_thread() is not threading.main_thread():
        return work()
    while alone and _running(_tasks_alone):
        time.sleep(_POLL / 5)
    task = _Task(work)
    _tasks[:] = [*_running(_tasks), task]
    if alone:
        _tasks_alone[:] = [task]
    try:
        return cast(Result, task.result())
    except RuntimeError:
        if task.has_begun:
            raise
        return work()  # no thread can be started: too many, or the interpreter is shutting down


class Later(Generic[Result]):
    """Work done in a separate thread while the caller continues; no progress is shown.

    Ctrl-C ends a wait for the result, but not the work, so that a later wait gets the result. If no thread can be
    started, or in a forked child, which has none of its parent's threads, the work is done when the result is
    requested.
    """

    def __init__(self, work: Callable[[], Result]) -> None:
        self._work, self._process = work, os.getpid()
        self._outcome: tuple[Result | None, BaseException | None] | None = None
        task = _Task(self._keep)
        _tasks[:] = [*_running(_tasks), task]
        with contextlib.suppress(RuntimeError):
            task.begin()
        self._is_alone = not task.has_begun

    @property
    def ready(self) -> bool:
        """Whether the work has ended, with a result or an error."""
        return self._outcome is not None

    def result(self) -> Result:
        """Wait for the work, and return its result or raise its exception; may be called repeatedly."""
        while self._outcome is None:
            if self._is_alone or self._process != os.getpid():
                self._outcome = (self._work(), None)
            else:
                time.sleep(_POLL / 10)
        value, error = self._outcome
        if error is not None:
            raise error
        return cast(Result, value)

    def _keep(self) -> None:
        value = error = None
        try:
            with progress.hidden():
                value = self._work()
        except BaseException as raised:
            error = raised
        # Set last: `ready` reads it in another thread.
        self._outcome = (value, error)


def _running(tasks: list[_Task]) -> list[_Task]:
    return [task for task in tasks if task.is_running]


def module(name: str) -> ModuleType:
    """Import a module whose import catches interrupts; later calls only look it up."""
    if name in sys.modules and not _running(_tasks_alone):
        return importlib.import_module(name)
    return run(lambda: importlib.import_module(name), alone=True)


@atexit.register
def _end() -> None:
    """End abandoned work before interpreter shutdown, which would freeze threads at any place."""
    hook = sys.unraisablehook

    def ignore_ended(unraisable: sys.UnraisableHookArgs) -> None:
        # Python prints exceptions in destructors and in callbacks of weak references; each import has such a callback.
        if unraisable.exc_type is not _Ended:
            hook(unraisable)

    sys.unraisablehook = ignore_ended
    deadline = time.monotonic() + _END_TIMEOUT
    for task in _running(_tasks):
        task.end(deadline)
