"""Thread-safe cache of the most recently used values."""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Callable, Container, Hashable
from typing import Generic, TypeVar

Key = TypeVar("Key", bound=Hashable)
Value = TypeVar("Value")


class Recent(Generic[Key, Value]):
    """Cache of the most recently used values; `size_of` returns a value's size in the unit of `trim`, by default 1.

    After an update of the files that values come from, the old values serve until the new ones are read.
    """

    def __init__(self, size_of: Callable[[Value], int] = lambda value: 1) -> None:
        self._size_of = size_of
        self.values: OrderedDict[Key, Value] = OrderedDict()
        """Values by key, the least recently used first."""
        self._sizes: dict[Key, int] = {}  # values may grow later
        # Keys of values that were changed by an update and not read again.
        self._outdated: set[Key] = set()
        self._lock = threading.Lock()
        self.size = 0
        """Sum of the sizes of all values."""
        self.reads = self.read_bytes = 0
        """Number of values that were put, and of bytes that `count_bytes` added."""

    def __contains__(self, key: Key) -> bool:
        """Whether a value is cached in its newest version."""
        with self._lock:
            return key in self.values and key not in self._outdated

    def get(self, key: Key) -> Value | None:
        """Return a value of any version, which becomes the most recently used; None if it is not cached."""
        with self._lock:
            if key not in self.values:
                return None
            self.values.move_to_end(key)
            return self.values[key]

    def put(self, key: Key, value: Value) -> None:
        """Cache a value as the most recently used."""
        with self._lock:
            self._drop(key)
            self.values[key] = value
            self._sizes[key] = self._size_of(value)
            self.size += self._sizes[key]
            self.reads += 1

    def count_bytes(self, count: int) -> None:
        """Count bytes read for values."""
        with self._lock:
            self.read_bytes += count

    def take_over(self, older: Recent[Key, Value], changed: Callable[[Key], bool]) -> None:
        """Take over values and counts of the cache of older files; changed values serve until they are read again."""
        for key, value in list(older.values.items()):
            self.put(key, value)
            if key in older._outdated or changed(key):
                self._outdated.add(key)
        self.reads, self.read_bytes = older.reads, older.read_bytes

    def trim(self, needed: Container[Key], max_size: float) -> None:
        """Evict the least recently used values except `needed` ones until the sizes add up to at most `max_size`."""
        with self._lock:
            for key in [key for key in self.values if key not in needed]:
                if self.size <= max_size:
                    return
                self._drop(key)

    def _drop(self, key: Key) -> None:
        self._outdated.discard(key)
        if key in self.values:
            del self.values[key]
            self.size -= self._sizes.pop(key)
