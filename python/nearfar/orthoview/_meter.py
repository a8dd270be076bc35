"""Measures a client's link: bytes a second, and mean sizes of views and of leaves' geometry."""

from __future__ import annotations

import math
from dataclasses import dataclass

from nearfar.orthoview._cut import GEOMETRY, Part, kind

HALF_LIFE = 1.0
"""Seconds of reading after which a measurement's weight is halved."""


@dataclass(frozen=True)
class LinkTotals:
    """Counts and bytes of the views and leaves received until a time."""

    views: int = 0
    view_bytes: int = 0
    leaves: int = 0
    leaf_bytes: int = 0

    @property
    def bytes(self) -> int:
        return self.view_bytes + self.leaf_bytes


class Meter:
    """Measures a link during the times at which requests are outstanding."""

    def __init__(self) -> None:
        self._time, self._received = 0.0, LinkTotals()
        self._weight = self._bytes = 0.0

    def note(self, time: float, received: LinkTotals, *, had_requests: bool) -> None:
        """Record the totals at a time; `had_requests` says whether requests were outstanding since the last call."""
        seconds = time - self._time
        if had_requests and seconds > 0.0:
            fade = 0.5 ** (seconds / HALF_LIFE)
            self._weight = fade * self._weight + seconds
            self._bytes = fade * self._bytes + (received.bytes - self._received.bytes)
        self._time, self._received = time, received

    @property
    def rate(self) -> float:
        """Bytes a second; infinite before the first measurement."""
        return self._bytes / self._weight if self._weight > 0.0 and self._bytes > 0.0 else math.inf

    def bytes_of(self, part: Part) -> float:
        """Expected bytes of a part: the mean of the received parts of its kind."""
        received = self._received
        if kind(part) == GEOMETRY:
            return received.leaf_bytes / max(received.leaves, 1)
        return received.view_bytes / max(received.views, 1)
