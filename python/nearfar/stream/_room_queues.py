"""Bounded queues of a room: events that wait for the iterating consumer, and poses that await acknowledgement."""

from __future__ import annotations

import asyncio
from collections import OrderedDict, deque
from itertools import count

import numpy as np
from numpy.typing import NDArray

from nearfar.stream._room_events import Event, Left, Posed, Said, Settled, Signalled

MAX_EVENTS = 4096
MAX_BYTES = 1 << 20
"""Limits of the queue: number of events, and payload bytes; the oldest events are discarded."""

MAX_ROUND_TRIPS = 10_000
"""Greatest number of stored round-trip times, and of poses that await acknowledgement."""


class Inbox:
    """Events in order. A newer pose replaces a queued one of the same user, as on the server."""

    def __init__(self) -> None:
        self._waiting: OrderedDict[tuple[str, int], Event] = OrderedDict()
        self._numbers = count()
        self._bytes = 0
        self._is_ended = False
        self._change = asyncio.Event()
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
            self._pop()
            self.dropped += 1
        self._change.set()

    def end(self) -> None:
        """Mark the end: no event follows the queued ones."""
        self._is_ended = True
        self._change.set()

    async def take(self) -> Event | None:
        """Remove and return the first event, waiting for one; None after the last."""
        while not self._waiting:
            if self._is_ended:
                return None
            self._change.clear()
            await self._change.wait()
        return self._pop()

    def _pop(self) -> Event:
        _, event = self._waiting.popitem(last=False)
        self._bytes -= _payload(event)
        return event


def _payload(event: Event) -> int:
    return len(event.data) if isinstance(event, Said | Signalled) else 0


class RoundTrips:
    """Poses that await acknowledgement, and the time until all users have acknowledged them.

    That is the paper's Eq. 3: Δᵢ = T_is + max over j ≠ i of (T_sj + T_js) + T_si.
    """

    def __init__(self) -> None:
        self._sent: deque[tuple[int, float]] = deque(maxlen=MAX_ROUND_TRIPS)
        self._seconds: deque[float] = deque(maxlen=MAX_ROUND_TRIPS)

    def send(self, sequence: int, now: float) -> None:
        """Record a sent pose that others acknowledge."""
        self._sent.append((sequence, now))

    def settle(self, sequence: int, now: float) -> list[Settled]:
        """Record that all others have this pose or a later one; return the poses that this settles."""
        settled = []
        while self._sent and self._sent[0][0] <= sequence:
            number, sent = self._sent.popleft()
            settled.append(Settled(number, now - sent))
        self._seconds.extend(event.seconds for event in settled)
        return settled

    def forget(self) -> None:
        """Discard outstanding poses, because no user is left to acknowledge them."""
        self._sent.clear()

    @property
    def seconds(self) -> NDArray[np.float64]:
        """Return the last round-trip times, the newest last."""
        return np.array(self._seconds, np.float64)
