"""Progress of work longer than half a second: bars on a terminal or in a notebook, else lines of text."""

from __future__ import annotations

import contextvars
import os
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rich.progress import Progress, TaskID

Report = Callable[[int, int], None]
"""Callback that takes the finished and the total amount of work, in any unit."""

DELAY = 0.5
"""Seconds before a bar appears; shorter work shows none."""

UPDATE = 0.1
"""Seconds between two updates of a bar in a notebook."""

INTERVAL = 10.0
"""Seconds between two lines of text."""

_writes_lines = False
"""Whether progress is written as lines of text if no bar can be shown."""
_last_line = 0.0
"""Time of the last line, or of the start of the command."""
_visible_bar: _Bar | None = None
"""The visible bar. Only one is shown at a time, so nested bars stay invisible."""
_hidden = contextvars.ContextVar("_hidden", default=False)
"""Whether progress is hidden; separate for each thread."""
_step = contextvars.ContextVar("_step", default="")
"""Name set by `step`; separate for each thread."""
_watcher: contextvars.ContextVar[Callable[[], None] | None] = contextvars.ContextVar("_look", default=None)
"""Function set by `watched`, called at each report; separate for each thread."""


@contextmanager
def bar(label: str) -> Iterator[Report]:
    """Show the progress of work with a label of one or two words: yield a `Report`, which kernels take as `report=`.

    `NEARFAR_PROGRESS=0` hides all progress.
    """
    with closing(_Bar(label)) as visible:
        yield visible.report


@contextmanager
def step(name: str) -> Iterator[None]:
    """Name the step of a command before the labels of all bars that begin within the block, in this thread."""
    token = _step.set(name)
    try:
        yield
    finally:
        _step.reset(token)


@contextmanager
def lines() -> Iterator[None]:
    """Within the block, write a line to standard error every `INTERVAL` seconds of work if no bar can be shown."""
    global _writes_lines, _last_line
    previous, _writes_lines, _last_line = _writes_lines, True, time.monotonic()
    try:
        yield
    finally:
        _writes_lines = previous


@contextmanager
def hidden() -> Iterator[None]:
    """Show no progress within the block, for work that no user waits for."""
    token = _hidden.set(True)
    try:
        yield
    finally:
        _hidden.reset(token)


@contextmanager
def watched(watcher: Callable[[], None]) -> Iterator[None]:
    """Call a function several times a second during work in the block; its exceptions end the work."""
    token = _watcher.set(watcher)
    try:
        yield
    finally:
        _watcher.reset(token)


def duration(seconds: float) -> str:
    """Format a duration roughly: in seconds below 2 minutes, in minutes below 2 hours, else in hours."""
    if seconds < 120:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 7200 else f"{seconds / 3600:.0f} h"


def look() -> None:
    """Call the function set by `watched`, if any; for loops that wait."""
    watch = _watcher.get()
    if watch is not None:
        watch()


class _Bar:
    def __init__(self, label: str) -> None:
        name = _step.get()
        self._label = f"{name}: {label}" if name and name != label else label
        self._started = time.monotonic()
        self._is_silent = _hidden.get() or os.environ.get("NEARFAR_PROGRESS", "").strip() == "0"
        self._progress: Progress | None = None
        self._task: TaskID | None = None
        self._cell: Any = None
        self._next = 0.0
        self._latest = (self._started, 0)
        """Time of the latest line, and the work that was finished then."""

    def report(self, done: int, total: int) -> None:
        look()
        if self._is_silent:
            return
        if _writes_lines and not _visible():
            self._write(done, total)
            return
        if self._progress is None and self._cell is None and not self._open(done, total):
            return
        if self._cell is not None and time.monotonic() >= self._next:
            self._next = time.monotonic() + UPDATE
            self._cell.update(_html(self._label, done, total))
        if self._progress is not None and self._task is not None:
            self._progress.update(self._task, completed=done, total=total or None)

    def _write(self, done: int, total: int) -> None:
        global _last_line
        if time.monotonic() - _last_line < INTERVAL or sys.stderr is None:
            return
        _last_line = time.monotonic()
        percentage = f", {100.0 * done / total:.0f} %" if total > 0 else ""
        # The latest speed counts: work that resumes passes over what is done in no time.
        since, before = self._latest
        seconds = (_last_line - since) * (total - done) / (done - before) if total > 0 and done > before else None
        self._latest = (_last_line, done)
        left = "" if seconds is None else f", about {duration(seconds)} left"
        print(
            f"nearfar: {self._label}{percentage}, {_last_line - self._started:.0f} s{left}", file=sys.stderr, flush=True
        )

    def _open(self, done: int, total: int) -> bool:
        global _visible_bar
        if _visible_bar is not None or time.monotonic() - self._started < DELAY or 0 < total <= done:
            return False
        if not _visible():
            self._is_silent = True
            return False
        _visible_bar = self
        if _in_notebook():
            # rich needs widgets in notebooks, and leaves broken ones behind in saved notebooks.
            from IPython.display import display

            self._cell = display(_html(self._label, done, total), display_id=True)
            return True
        from rich.console import Console
        from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeRemainingColumn

        columns = (TextColumn("{task.description}"), BarColumn(), TaskProgressColumn(), TimeRemainingColumn())
        self._progress = Progress(*columns, console=Console(stderr=True), transient=True)
        self._progress.start()
        self._task = self._progress.add_task(self._label)
        return True

    def close(self) -> None:
        global _visible_bar
        if self._progress is not None:
            self._progress.stop()
            self._progress = None
        if self._cell is not None:
            self._cell.update(_html("", 0, 0))
            self._cell = None
        if _visible_bar is self:
            _visible_bar = None


def _visible() -> bool:
    return _in_notebook() or (sys.stderr is not None and sys.stderr.isatty())


def _in_notebook() -> bool:
    if "ipykernel" not in sys.modules:
        return False
    from IPython import get_ipython

    return getattr(get_ipython(), "kernel", None) is not None


def _html(label: str, done: int, total: int) -> Any:
    """Return the HTML of a notebook's bar; empty without a label, when the work is done."""
    from IPython.display import HTML

    attributes = f'value="{done}" max="{total}"' if total else ""
    return HTML(f"<label>{label} <progress {attributes}></progress></label>" if label else "<span></span>")
