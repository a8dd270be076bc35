"""Background threads that read the parts of a flight, the most urgent first."""

from __future__ import annotations

import threading
import time
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager

from nearfar._base.errors import FormatError
from nearfar.orthoview._cut import Part

FIRST_PAUSE, MAX_PAUSE = 0.5, 30.0
"""Seconds until a failed read is retried; each failure in a row doubles the pause, up to the second value."""


class Loader:
    """Reads parts in background threads, one at a time in each.

    `read` reads a part and returns whether the store was asked for it; `is_read` says whether a part has been read.
    """

    def __init__(self, read: Callable[[Part], bool], is_read: Callable[[Part], bool], threads: int) -> None:
        self._read, self._is_read = read, is_read
        self._queue: deque[Part] = deque()
        self._in_progress: set[Part] = set()
        self._damaged: set[Part] = set()
        self._pause, self._retry_time = FIRST_PAUSE, 0.0
        self._errors: list[Exception] = []
        self._is_failing = self._is_closed = False
        self._changed = threading.Condition()
        self._threads: list[threading.Thread] = []
        self._count = threads

    def want(self, parts: Sequence[Part]) -> None:
        """Replace the queue by parts in order of urgency; no effect once closed."""
        with self._changed:
            if self._is_closed:
                return
            self._start_threads()
            excluded = self._in_progress | self._damaged
            self._queue = deque(part for part in parts if part not in excluded and not self._is_read(part))
            self._changed.notify_all()

    @property
    def waiting(self) -> int:
        """Number of parts that are being read or queued."""
        with self._changed:
            return len(self._queue) + len(self._in_progress)

    def wait(self, seconds: float | None) -> bool:
        """Wait until the queue is empty; False after a timeout, or if the rest cannot be read now."""
        with self._changed:
            return self._changed.wait_for(self._is_done, seconds) and not self._queue

    def _is_done(self) -> bool:
        return not self._in_progress and (not self._queue or self._is_failing or self._is_closed)

    def errors(self) -> list[Exception]:
        """Errors since the last call: one for each damaged part, and the first one of an outage."""
        with self._changed:
            errors, self._errors = self._errors, []
            return errors

    def forget(self) -> None:
        """Allow damaged parts to be read again."""
        with self._changed:
            self._damaged.clear()

    def close(self) -> None:
        """Stop the threads, and wait for reads in progress."""
        with self._changed:
            self._is_closed = True
            self._queue.clear()
            self._changed.notify_all()
        for thread in self._threads:
            thread.join()

    def _start_threads(self) -> None:
        while len(self._threads) < self._count:
            thread = threading.Thread(target=self._work, name="nearfar-flight", daemon=True)
            self._threads.append(thread)
            thread.start()

    def _work(self) -> None:
        while (part := self._take_next()) is not None:
            self._read_next(part)

    def _take_next(self) -> Part | None:
        """Wait for the next part to read; None once the loader is closed."""
        with self._changed:
            while not self._is_closed and (not self._queue or time.monotonic() < self._retry_time):
                self._changed.wait(max(self._retry_time - time.monotonic(), 0.0) if self._queue else None)
            if self._is_closed:
                return None
            part = self._queue.popleft()
            self._in_progress.add(part)
            return part

    def _read_next(self, part: Part) -> None:
        try:
            is_answer = self._read(part)
        except FormatError as error:
            with self._ending(part):
                self._errors.append(error)
                self._damaged.add(part)
        except Exception as error:
            with self._ending(part):
                if not self._is_failing:
                    self._errors.append(error)
                if time.monotonic() >= self._retry_time:  # else another thread has failed in the same outage
                    self._retry_time = time.monotonic() + self._pause
                    self._pause = min(2.0 * self._pause, MAX_PAUSE)
                self._is_failing = True
                self._queue.appendleft(part)
        else:
            with self._ending(part):
                if is_answer:
                    self._pause, self._retry_time, self._is_failing = FIRST_PAUSE, 0.0, False

    @contextmanager
    def _ending(self, part: Part) -> Iterator[None]:
        """Lock the state for changes after an attempt to read a part, and wake waiting threads."""
        with self._changed:
            yield
            self._in_progress.discard(part)
            self._changed.notify_all()
