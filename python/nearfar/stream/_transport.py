"""Transfers over a link on a virtual clock: HTTP requests, TCP's congestion control and losses, and a queue.

Times are arrival times at the client. Data wait in the queue in pieces of at most an HTTP/2 frame. A piece is
acknowledged one round trip after it begins to arrive, which frees its place in the window.
"""

from __future__ import annotations

import heapq
import itertools
import math
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial

import numpy as np

from nearfar.stream._link import SEGMENT, Link

MAX_REQUESTS = 6
"""Greatest number of concurrent requests of the page, and of connections that browsers open for HTTP/1.1."""
INITIAL_WINDOW = 10 * SEGMENT
"""Initial congestion window, bytes (RFC 6928)."""
PIECE_BYTES = 16_384
"""Bytes of an HTTP/2 frame; the server switches between responses after each frame."""
DECREASE = 0.7
"""Factor on the window after a loss (RFC 9438, 4.6)."""
INCREASE = 3.0 * (1.0 - DECREASE) / (1.0 + DECREASE)
"""Segments per round trip by which the window grows after a loss; its mean then equals Reno's (RFC 9438, 4.3)."""


@dataclass(eq=False)
class _Response:
    """Response to a request."""

    name: str
    remaining: int
    """Bytes still to be sent, including those to be sent again after a loss."""


@dataclass(eq=False)
class _Connection:
    """A connection. Its congestion window equals the bytes in flight plus the bytes that may be sent."""

    ready: float
    """Time at which the handshake is done."""
    window: float = INITIAL_WINDOW
    credits: deque[list[float]] = field(default_factory=deque)
    """Pairs of a time and the bytes that may be sent from then on."""
    responses: deque[_Response] = field(default_factory=deque)
    busy_since: float = 0.0
    """Time from which there has always been data to send."""
    requests: int = 0
    """Number of outstanding requests."""
    is_slow: bool = True
    """Whether it is in slow start."""
    spare: float = 0.0
    """Growth of the window in bytes, less than a segment, that is not credited yet."""
    debt: float = 0.0
    """Bytes in flight in excess of the window since it shrank."""
    recovery: float = -math.inf
    """Time of the last reduction of the window; losses of pieces that began to arrive earlier cause no other one."""

    @property
    def queue_time(self) -> float:
        """Time at which its next data entered the queue; infinite if there are none."""
        return max(self.credits[0][0], self.busy_since) if self.responses and self.credits else math.inf


class Transport:
    """Fetches files over a link, each name once, in the order of the requests."""

    def __init__(self, link: Link, *, seed: int = 0, at_once: int = MAX_REQUESTS) -> None:
        self.now = 0.0
        self.arrived: dict[str, float] = {}
        self.curve: list[tuple[float, int]] = [(0.0, 0)]
        """Times and bytes received until then, to be interpolated linearly."""
        self._link, self._at_once = link, at_once
        self._clock = link._clock()
        self._random = np.random.default_rng(seed)
        self._events: list[tuple[float, int, Callable[[], None]]] = []
        self._order = itertools.count()
        self._connections: list[_Connection] = []
        self._waiting: deque[_Response] = deque()
        self.asked: dict[str, int] = {}
        """Bytes of the requested files, in the order of the requests."""
        self._open = 0
        self._is_busy = False

    def ask(self, name: str, count: int) -> None:
        """Request a file of `count` bytes, unless it was requested already."""
        if name not in self.asked:
            self.asked[name] = count
            self._waiting.append(_Response(name, count))
            self._fill()

    @property
    def free(self) -> int:
        """Number of requests that could be sent immediately."""
        return max(self._at_once - self._open - len(self._waiting), 0)

    def next_time(self) -> float:
        """Return the time of the next event; infinite if there is none."""
        return self._events[0][0] if self._events else math.inf

    def advance(self, time: float) -> list[str]:
        """Advance to a time; return the names of files that became complete."""
        known_count = len(self.arrived)
        while self._events and self._events[0][0] <= time:
            self.now, _, action = heapq.heappop(self._events)
            action()
        self.now = time
        return list(itertools.islice(self.arrived, known_count, None))

    def _schedule(self, time: float, action: Callable[[], None]) -> None:
        heapq.heappush(self._events, (time, next(self._order), action))

    def _fill(self) -> None:
        """Send requests while there are free slots; with HTTP/1.1 each gets its own connection."""
        while self._waiting and self._open < self._at_once:
            response = self._waiting.popleft()
            connection = self._connection()
            connection.requests += 1
            self._open += 1
            begin = max(self.now, connection.ready) + self._link.rtt
            self._schedule(begin, partial(self._answer, connection, response))

    def _connection(self) -> _Connection:
        free = [each for each in self._connections if self._link.http == 2 or each.requests == 0]
        if free:
            return max(free, key=lambda each: each.window)
        connection = _Connection(self.now + self._link.handshake * self._link.rtt)
        connection.credits.append([connection.ready, connection.window])
        self._connections.append(connection)
        return connection

    def _answer(self, connection: _Connection, response: _Response) -> None:
        if response.remaining == 0:
            self._complete(connection, response)
            return
        if not connection.responses:
            connection.busy_since = self.now
        connection.responses.append(response)
        self._serve()

    def _serve(self) -> None:
        """Transmit the first piece of the queue, if the link is idle."""
        if self._is_busy:
            return
        first = min(self._connections, key=lambda each: each.queue_time)
        if first.queue_time > self.now:
            return
        response = first.responses.popleft()
        size = self._spend(first, min(response.remaining, PIECE_BYTES))
        begin, end = self.now, self._clock.end_of_transfer(self.now, size)
        self._is_busy = True
        lost = self._draw_lost(size)
        response.remaining -= size - lost
        if response.remaining > lost:
            first.responses.append(response)
        self._schedule(end, partial(self._deliver, first, response, size - lost, begin))
        self._schedule(begin + self._link.rtt, partial(self._acknowledge, first, response, size, lost, begin))

    def _spend(self, connection: _Connection, max_bytes: int) -> int:
        """Consume credits that are valid now; returns the bytes to send, at most `max_bytes`."""
        size = 0.0
        while size < max_bytes and connection.credits and connection.credits[0][0] <= self.now:
            credit = connection.credits[0]
            part = min(credit[1], max_bytes - size)
            size += part
            credit[1] -= part
            if credit[1] <= 0.0:
                connection.credits.popleft()
        return int(size)

    def _draw_lost(self, size: int) -> int:
        """Draw the number of lost bytes of a piece."""
        if self._link.loss == 0.0:
            return 0
        # Poisson-distributed, so that the loss rate does not depend on the sizes of pieces.
        return min(int(self._random.poisson(self._link.loss * size / SEGMENT)) * SEGMENT, size)

    def _deliver(self, connection: _Connection, response: _Response, count: int, begin: float) -> None:
        """Process a piece that the link has transmitted, of which `count` bytes arrive."""
        self._is_busy = False
        self._record_bytes(begin, count)
        if response.remaining == 0:
            self._complete(connection, response)
        self._serve()

    def _complete(self, connection: _Connection, response: _Response) -> None:
        self.arrived[response.name] = self.now
        connection.requests -= 1
        self._open -= 1
        self._fill()

    def _acknowledge(self, connection: _Connection, response: _Response, size: int, lost: int, begin: float) -> None:
        """Process a piece's acknowledgement: the server gains credit for its size and the change of the window."""
        growth = 0.0
        if lost:
            self._shrink(connection, begin)
            if response.remaining > 0 and response not in connection.responses:
                # Lost bytes are sent first.
                connection.busy_since = connection.busy_since if connection.responses else self.now
                connection.responses.appendleft(response)
        else:
            growth = size if connection.is_slow else INCREASE * SEGMENT * size / connection.window
        connection.window += growth
        connection.spare += growth
        segments = SEGMENT * (connection.spare // SEGMENT)
        connection.spare -= segments
        credit = size + segments
        paid = min(connection.debt, credit)
        connection.debt -= paid
        if credit > paid:
            connection.credits.append([self.now, credit - paid])
        self._serve()

    def _shrink(self, connection: _Connection, begin: float) -> None:
        connection.is_slow = False
        if begin >= connection.recovery:
            connection.recovery = self.now
            window = max(DECREASE * connection.window, 2.0 * SEGMENT)
            connection.debt += max(connection.window - window, 0.0)
            connection.window = window

    def _record_bytes(self, begin: float, count: int) -> None:
        time, before = self.curve[-1]
        if time < begin:
            self.curve.append((begin, before))
        elif len(self.curve) > 1:
            start, first = self.curve[-2]
            slopes = (before - first) * (self.now - time), count * (time - start)
            if math.isclose(*slopes, rel_tol=1e-9):
                self.curve.pop()
        self.curve.append((self.now, before + count))
