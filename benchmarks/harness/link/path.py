"""One direction of a link: a queue before a bottleneck, random losses, and a delay."""

from __future__ import annotations

import random
from collections import deque
from dataclasses import dataclass

from nearfar.stream._link import Clock


@dataclass
class Counts:
    """Packets of one direction."""

    taken: int = 0
    """Packets sent by a side."""
    overflowed: int = 0
    """Packets dropped because the queue was full."""
    lost: int = 0
    """Packets lost behind the bottleneck."""
    delivered: int = 0
    delivered_bytes: int = 0
    """Bytes with all headers from IP on."""


class Path:
    """Packets in transit, on a clock that the caller reads. Packets stay in order."""

    def __init__(self, clock: Clock, *, delay: float, loss: float, queue: int, seed: int) -> None:
        """Store the clock of the rate, the delay in seconds, the share lost, and the size of the queue in bytes."""
        self._clock, self._delay, self._loss, self._max_queued = clock, delay, loss, queue
        self._random = random.Random(seed).random
        self._waiting = deque[tuple[float, int]]()
        """Times at which packets leave the bottleneck, and their bytes."""
        self._queued = 0
        self._last_departure = 0.0
        self._flying = deque[tuple[float, bytes]]()
        self.counts = Counts()

    def take(self, now: float, packet: bytes) -> None:
        """Accept a packet that a side sends."""
        counts, waiting, size = self.counts, self._waiting, len(packet)
        counts.taken += 1
        while waiting and waiting[0][0] <= now:
            self._queued -= waiting.popleft()[1]
        if self._queued + size > self._max_queued:
            counts.overflowed += 1
            return
        self._last_departure = self._clock.end_of_transfer(max(now, self._last_departure), size)
        self._queued += size
        waiting.append((self._last_departure, size))
        if self._random() < self._loss:
            counts.lost += 1
            return
        self._flying.append((self._last_departure + self._delay, packet))

    def next(self) -> float | None:
        """Time at which the next packet arrives at the other side."""
        return self._flying[0][0] if self._flying else None

    def due(self, now: float) -> list[bytes]:
        """Remove and return the packets that have arrived."""
        flying, arrived = self._flying, list[bytes]()
        while flying and flying[0][0] <= now:
            arrived.append(flying.popleft()[1])
        self.counts.delivered += len(arrived)
        self.counts.delivered_bytes += sum(map(len, arrived))
        return arrived
