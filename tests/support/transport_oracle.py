"""Transfers packet by packet, slow and simple: TCP Reno over a queue with a rate, a delay and random losses."""

from __future__ import annotations

import heapq
import itertools
from collections import deque
from typing import Any

import numpy as np

SEGMENT = 1460
AT_ONCE = 6


class Oracle:
    """Files requested at time 0, in order, at most six at a time; `arrived` has the completion time of each.

    `http` 1 uses six connections with a request each, 2 uses one, on which responses are interleaved by packets.
    """

    def __init__(
        self,
        sizes: list[int],
        *,
        rate: float,
        rtt: float,
        loss: float,
        http: int,
        handshake: float = 2.0,
        seed: int = 0,
    ) -> None:
        self.rate, self.rtt, self.loss = rate, rtt, loss
        self.dice = np.random.default_rng(seed)
        self.events: list[tuple[float, int, Any, tuple[Any, ...]]] = []
        self.order = itertools.count()
        self.now = self.free_at = 0.0
        self.arrived: dict[int, float] = {}
        self.left = {name: -(-size // SEGMENT) for name, size in enumerate(sizes)}
        self.sizes = sizes
        self.waiting = deque(range(len(sizes)))
        count = 1 if http == 2 else AT_ONCE
        self.connections = [_Sender(self, handshake * rtt) for _ in range(count)]
        self.is_shared = http == 2
        for slot in range(AT_ONCE):
            self.ask(self.connections[0 if self.is_shared else slot])
        while self.events:
            self.now, _, deed, arguments = heapq.heappop(self.events)
            deed(*arguments)

    def later(self, time: float, deed: Any, *arguments: Any) -> None:
        heapq.heappush(self.events, (time, next(self.order), deed, arguments))

    def ask(self, connection: _Sender) -> None:
        if self.waiting:
            name = self.waiting.popleft()
            self.later(max(self.now, connection.ready) + self.rtt / 2, connection.answer, name)

    def receive(self, connection: _Sender, name: int, number: int) -> None:
        self.left[name] -= 1
        self.later(self.now + self.rtt / 2, connection.acknowledged, number)
        if self.left[name] == 0:
            self.arrived[name] = self.now
            self.ask(connection)


class _Sender:
    """A server's end of a connection. The window counts packets."""

    def __init__(self, oracle: Oracle, ready: float) -> None:
        self.oracle, self.ready = oracle, ready
        self.window, self.is_slow = 10.0, True
        self.flying, self.number, self.recover = 0, 0, -1
        self.streams: deque[list[int]] = deque()

    def answer(self, name: int) -> None:
        size = self.oracle.sizes[name]
        packets = [SEGMENT] * (size // SEGMENT) + [size % SEGMENT] * (size % SEGMENT > 0)
        self.streams.append([name, *packets])
        self.send()

    def send(self) -> None:
        oracle = self.oracle
        while self.flying < int(self.window) and self.streams:
            stream = self.streams.popleft()
            name, size = stream[0], stream.pop()
            if len(stream) > 1:
                self.streams.append(stream)
            self.flying += 1
            oracle.free_at = max(oracle.now, oracle.free_at) + size / oracle.rate
            if oracle.dice.random() < oracle.loss:
                oracle.later(oracle.free_at + oracle.rtt, self.lost, name, size, self.number)
            else:
                oracle.later(oracle.free_at + oracle.rtt / 2, oracle.receive, self, name, self.number)
            self.number += 1

    def acknowledged(self, number: int) -> None:
        self.flying -= 1
        self.window += 1.0 if self.is_slow else 1.0 / self.window
        self.send()

    def lost(self, name: int, size: int, number: int) -> None:
        self.flying -= 1
        self.is_slow = False
        if number > self.recover:
            # Once for all losses of a window.
            self.recover, self.window = self.number, max(self.window / 2, 2.0)
        self.streams.appendleft([name, size])
        self.send()
