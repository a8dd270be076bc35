"""A client's measurements of its link: bytes a second, and bytes of a view and of a leaf's geometry."""

from __future__ import annotations

import math
from dataclasses import dataclass

from nearfar.orthoview._parts import GEOMETRY, Part, kind

HALF_LIFE = 1.0
"""Seconds of reading after which a measurement counts half."""


@dataclass(frozen=True)
class Received:
    """All that has come until a time."""

    views: int = 0
    view_bytes: int = 0
    leaves: int = 0
    leaf_bytes: int = 0

    @property
    def bytes(self) -> int:
        """Bytes of all."""
        return self.view_bytes + self.leaf_bytes


class Meter:
    """Measures a link while something is read."""

    def __init__(self) -> None:
        self._time, self._received = 0.0, Received()
        self._weight = self._bytes = 0.0

    def note(self, time: float, received: Received, *, busy: bool) -> None:
        """Note what has come until a time, and whether something was awaited since the last note."""
        seconds = time - self._time
        if busy and seconds > 0.0:
            fade = 0.5 ** (seconds / HALF_LIFE)
            self._weight = fade * self._weight + seconds
            self._bytes = fade * self._bytes + (received.bytes - self._received.bytes)
        self._time, self._received = time, received

    @property
    def rate(self) -> float:
        """Bytes a second; infinite while nothing was measured."""
        return self._bytes / self._weight if self._weight > 0.0 and self._bytes > 0.0 else math.inf

    def bytes_of(self, part: Part) -> float:
        """Bytes that a part is expected to have: the mean of those that came."""
        own = self._received
        if kind(part) == GEOMETRY:
            return own.leaf_bytes / max(own.leaves, 1)
        return own.view_bytes / max(own.views, 1)
