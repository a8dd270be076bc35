"""Transfers over a link on a virtual clock: HTTP requests, TCP's congestion control and losses, and a queue.

Time is that of arrival at the client; data wait in the queue in pieces of at most an HTTP/2 frame. A piece is
acknowledged one round trip after it has begun to arrive, which frees its place in the window.
"""

from __future__ import annotations

import heapq
import itertools
import math
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from nearfar.stream._link import SEGMENT, Link

AT_ONCE = 6
"""Concurrent requests of the page, and connections that browsers open to a server for HTTP/1.1."""
FIRST_WINDOW = 10 * SEGMENT
"""Initial congestion window, bytes (RFC 6928)."""
PIECE = 16_384
"""Bytes of an HTTP/2 frame, after which another response is served."""
DECREASE = 0.7
"""Factor on the window after a loss (RFC 9438, 4.6)."""
INCREASE = 3.0 * (1.0 - DECREASE) / (1.0 + DECREASE)
"""Segments per round trip by which a window then grows, so that its mean is that of Reno (RFC 9438, 4.3)."""


@dataclass(eq=False)
class _Flow:
    """Response to a request."""

    name: str
    left: int


@dataclass(eq=False)
class _Connection:
    """A connection; its congestion window is the sum of the bytes in flight and the bytes that may be sent."""

    ready: float
    """Time at which the handshake is done."""
    window: float = FIRST_WINDOW
    credits: deque[list[float]] = field(default_factory=deque)
    """Times, and bytes that may be sent from each time on."""
    flows: deque[_Flow] = field(default_factory=deque)
    since: float = 0.0
    """Time from which it has had data to send without a break."""
    requests: int = 0
    """Number of outstanding requests."""
    is_slow: bool = True
    """Whether it is in slow start."""
    spare: float = 0.0
    """Growth of the window in bytes that does not make a full segment yet."""
    debt: float = 0.0
    """Bytes in flight beyond the window since it shrank."""
    recovery: float = -math.inf
    """Time of the last reduction; losses of pieces that began to arrive earlier cause no further one."""

    @property
    def turn(self) -> float:
        """Time at which its next data entered the queue; infinite if there are none."""
        return max(self.credits[0][0], self.since) if self.flows and self.credits else math.inf


class Transport:
    """Fetches files over a link, each name once, in the order of the requests."""

    def __init__(self, link: Link, *, seed: int = 0, at_once: int = AT_ONCE) -> None:
        self.now = 0.0
        self.arrived: dict[str, float] = {}
        self.curve: list[tuple[float, int]] = [(0.0, 0)]
        """Times and bytes received until then, to be interpolated linearly."""
        self._link, self._at_once = link, at_once
        self._clock = link._clock()
        self._dice = np.random.default_rng(seed)
        self._events: list[tuple[float, int, Callable[[], None]]] = []
        self._order = itertools.count()
        self._connections: list[_Connection] = []
        self._waiting: deque[_Flow] = deque()
        self.asked: dict[str, int] = {}
        """Bytes of the requested files, in the order of the requests."""
        self._open = 0
        self._is_busy = False

    def ask(self, name: str, count: int) -> None:
        """Request a file of `count` bytes, unless it was requested already."""
        if name not in self.asked:
            self.asked[name] = count
            self._waiting.append(_Flow(name, count))
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
        known = len(self.arrived)
        while self._events and self._events[0][0] <= time:
            self.now, _, deed = heapq.heappop(self._events)
            deed()
        self.now = time
        return list(itertools.islice(self.arrived, known, None))

    def _later(self, time: float, deed: Callable[[], None]) -> None:
        heapq.heappush(self._events, (time, next(self._order), deed))

    def _fill(self) -> None:
        """Send requests while there are free slots; with HTTP/1.1 each gets its own connection."""
        while self._waiting and self._open < self._at_once:
            flow = self._waiting.popleft()
            connection = self._connection()
            connection.requests += 1
            self._open += 1
            begins = max(self.now, connection.ready) + self._link.rtt
            self._later(begins, lambda own=connection, flow=flow: self._answer(own, flow))  # type: ignore[misc]

    def _connection(self) -> _Connection:
        free = [each for each in self._connections if self._link.http == 2 or each.requests == 0]
        if free:
            return max(free, key=lambda each: each.window)
        new = _Connection(self.now + self._link.handshake * self._link.rtt)
        new.credits.append([new.ready, new.window])
        self._connections.append(new)
        return new

    def _answer(self, connection: _Connection, flow: _Flow) -> None:
        if flow.left == 0:
            self._complete(connection, flow)
            return
        if not connection.flows:
            connection.since = self.now
        connection.flows.append(flow)
        self._serve()

    def _serve(self) -> None:
        """Transmit the first piece of the queue, if the link is idle."""
        if self._is_busy:
            return
        first = min(self._connections, key=lambda each: each.turn)
        if first.turn > self.now:
            return
        flow = first.flows.popleft()
        size = self._spend(first, min(flow.left, PIECE))
        began, ends = self.now, self._clock.end_of_transfer(self.now, size)
        self._is_busy = True
        lost = self._lost(size)
        flow.left -= size - lost
        if flow.left > lost:
            first.flows.append(flow)
        self._later(ends, lambda: self._come(first, flow, size, lost, began))
        self._later(began + self._link.rtt, lambda: self._acknowledge(first, flow, size, lost, began))

    def _spend(self, connection: _Connection, most: int) -> int:
        """Consume credits that are valid now; returns the bytes to send, at most `most`."""
        size = 0.0
        while size < most and connection.credits and connection.credits[0][0] <= self.now:
            credit = connection.credits[0]
            part = min(credit[1], most - size)
            size += part
            credit[1] -= part
            if credit[1] <= 0.0:
                connection.credits.popleft()
        return int(size)

    def _lost(self, size: int) -> int:
        """Draw the number of lost bytes of a piece."""
        if self._link.loss == 0.0:
            return 0
        # Poisson-distributed, so that the loss rate does not depend on the sizes of pieces.
        return min(int(self._dice.poisson(self._link.loss * size / SEGMENT)) * SEGMENT, size)

    def _come(self, connection: _Connection, flow: _Flow, size: int, lost: int, began: float) -> None:
        """Process a piece that the link has transmitted."""
        self._is_busy = False
        self._note(began, size - lost)
        if flow.left == 0:
            self._complete(connection, flow)
        self._serve()

    def _complete(self, connection: _Connection, flow: _Flow) -> None:
        self.arrived[flow.name] = self.now
        connection.requests -= 1
        self._open -= 1
        self._fill()

    def _acknowledge(self, connection: _Connection, flow: _Flow, size: int, lost: int, began: float) -> None:
        """Process a piece's acknowledgement: the server gains credit for its size and the change of the window."""
        grown = 0.0
        if lost:
            self._shrink(connection, began)
            if flow.left > 0 and flow not in connection.flows:
                # Lost bytes are sent first.
                connection.since = connection.since if connection.flows else self.now
                connection.flows.appendleft(flow)
        elif connection.is_slow:
            grown = size
        else:
            grown = INCREASE * SEGMENT * size / connection.window
        connection.window += grown
        connection.spare += grown
        whole = SEGMENT * (connection.spare // SEGMENT)
        connection.spare -= whole
        free = size + whole
        paid = min(connection.debt, free)
        connection.debt -= paid
        if free > paid:
            connection.credits.append([self.now, free - paid])
        self._serve()

    def _shrink(self, connection: _Connection, began: float) -> None:
        connection.is_slow = False
        if began >= connection.recovery:
            connection.recovery = self.now
            window = max(DECREASE * connection.window, 2.0 * SEGMENT)
            connection.debt += max(connection.window - window, 0.0)
            connection.window = window

    def _note(self, began: float, count: int) -> None:
        time, before = self.curve[-1]
        if time < began:
            self.curve.append((began, before))
        elif len(self.curve) > 1:
            start, first = self.curve[-2]
            slopes = (before - first) * (self.now - time), count * (time - start)
            if math.isclose(*slopes, rel_tol=1e-9):
                self.curve.pop()
        self.curve.append((self.now, before + count))
