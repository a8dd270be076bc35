"""Background threads that read the parts a flight needs, the most urgent first."""

from __future__ import annotations

import threading
import time
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager

from nearfar._base.errors import FormatError
from nearfar.orthoview._cut import Part, kind

BATCH = 8
"""Number of views that a thread reads at once."""

FIRST_PAUSE, MAX_PAUSE = 0.5, 30.0
"""Seconds until a failed read is retried; each failure in a row doubles the pause, up to the second value."""


class Loader:
    """Reads parts in background threads: `read` reads some of one kind, `is_read` says which have been read."""

    def __init__(self, read: Callable[[Sequence[Part]], None], is_read: Callable[[Part], bool], threads: int) -> None:
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
        """Replace the queue by these parts, the first ones first; no effect once closed."""
        with self._changed:
            if self._is_closed:
                return
            self._begin()
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

    def _begin(self) -> None:
        while len(self._threads) < self._count:
            thread = threading.Thread(target=self._work, name="nearfar-flight", daemon=True)
            self._threads.append(thread)
            thread.start()

    def _work(self) -> None:
        while batch := self._next():
            self._try(batch)

    def _next(self) -> list[Part]:
        """Wait for the next parts to read; empty once the loader is closed."""
        with self._changed:
            while not self._is_closed and (not self._queue or time.monotonic() < self._retry_time):
                self._changed.wait(max(self._retry_time - time.monotonic(), 0.0) if self._queue else None)
            batch: list[Part] = []
            while self._queue and not self._is_closed and len(batch) < BATCH:
                if batch and kind(batch[0]) != kind(self._queue[0]):
                    break
                batch.append(self._queue.popleft())
            self._in_progress.update(batch)
            return batch

    def _try(self, batch: Sequence[Part]) -> None:
        try:
            self._read(batch)
        except FormatError as error:
            if len(batch) > 1:  # the other parts may be intact
                for part in batch:
                    self._try([part])
                return
            with self._ending(batch):
                self._errors.append(error)
                self._damaged.update(batch)
        except Exception as error:
            with self._ending(batch):
                if not self._is_failing:
                    self._errors.append(error)
                self._retry_time = time.monotonic() + self._pause
                self._pause, self._is_failing = min(2.0 * self._pause, MAX_PAUSE), True
                self._queue.extendleft(reversed(batch))
        else:
            with self._ending(batch):
                self._pause, self._retry_time, self._is_failing = FIRST_PAUSE, 0.0, False

    @contextmanager
    def _ending(self, batch: Sequence[Part]) -> Iterator[None]:
        """Change the state after a batch has been tried."""
        with self._changed:
            yield
            self._in_progress.difference_update(batch)
            self._changed.notify_all()
