"""Bounded queue of events that wait for the iterating consumer."""

from __future__ import annotations

import asyncio
from collections import OrderedDict
from itertools import count

from nearfar.stream._room_events import Event, Left, Posed, Said, Signalled

MAX_EVENTS = 4096
MAX_BYTES = 1 << 20
"""Limits of the queue: number of events, and payload bytes; the oldest events are discarded."""


class Inbox:
    """Events in order. A newer pose replaces a queued one of the same user, as on the server."""

    def __init__(self) -> None:
        self._waiting: OrderedDict[tuple[str, int], Event] = OrderedDict()
        self._numbers = count()
        self._bytes = 0
        self._is_ended = False
        self._wake = asyncio.Event()
        self.dropped = 0
        """Number of events discarded because the queue was full."""

    def add(self, event: Event) -> None:
        """Enqueue an event."""
        if isinstance(event, Posed):
            self._waiting[("pose", event.user)] = event
        else:
            if isinstance(event, Left):
                self._waiting.pop(("pose", event.user), None)
            self._waiting[("event", next(self._numbers))] = event
            self._bytes += _payload(event)
        while len(self._waiting) > MAX_EVENTS or self._bytes > MAX_BYTES:
            self._first()
            self.dropped += 1
        self._wake.set()

    def end(self) -> None:
        """Mark the end: no event follows the queued ones."""
        self._is_ended = True
        self._wake.set()

    async def take(self) -> Event | None:
        """Remove and return the first event, waiting for one; None after the last."""
        while not self._waiting:
            if self._is_ended:
                return None
            self._wake.clear()
            await self._wake.wait()
        return self._first()

    def _first(self) -> Event:
        _, event = self._waiting.popitem(last=False)
        self._bytes -= _payload(event)
        return event


def _payload(event: Event) -> int:
    return len(event.data) if isinstance(event, Said | Signalled) else 0
