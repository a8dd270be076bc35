"""A simulated client of a tree on a virtual clock: its requests, what has arrived, and the frames that stall."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import chain

from nearfar._base.recent import Recent
from nearfar._camera.camera import Camera
from nearfar.orthoview._cut import GEOMETRY, Part, kind
from nearfar.orthoview._meter import Received
from nearfar.orthoview._pilot import Plan
from nearfar.stream._link import Link
from nearfar.stream._transport import Transport

AT_ONCE = 16
"""Concurrent requests of a client: two threads with eight views each."""


Planner = Callable[[Camera, float, Received, bool, Callable[[Part], bool]], Plan]
"""Plans a frame's parts: from the camera, the time in seconds, what has been received until then, whether requests were
outstanding since the frame before, and whether a part has been received."""


class Client:
    """Fetches the parts that a planner wants over a link; `sizes` returns their sizes in bytes."""

    def __init__(
        self, planner: Planner, sizes: Callable[[Sequence[Part]], list[int]], link: Link, cache_bytes: int, seed: int
    ) -> None:
        self._planner, self._sizes, self._cache_bytes = planner, sizes, cache_bytes
        self._transport = Transport(link, seed=seed, at_once=AT_ONCE)
        self._cache: Recent[Part, int] = Recent(int)
        """Bytes of the parts received."""
        self._requests: dict[str, tuple[Part, int]] = {}
        self._outstanding: set[Part] = set()
        self._queue: list[Part] = []
        self._received = Received()
        self.requested_bytes = 0

    def frame(self, camera: Camera, time: float) -> tuple[int, int, float, int]:
        """Advance to a frame; return its fields of `FlightLog`: `missing`, `wanted`, `error_px` and `received`."""
        had_requests = bool(self._outstanding)
        self._advance(time)
        plan = self._planner(camera, time, self._received, had_requests, self._cache.__contains__)
        wanted = list(chain(*plan.wanted.values()))
        missing = [part for part in wanted if part not in self._cache]
        received_bytes = self._received.bytes
        for part in wanted:
            self._cache.get(part)
        self._cache.trim({*plan.order, *wanted}, self._cache_bytes)
        self._queue = [part for part in plan.order[::-1] if part not in self._cache and part not in self._outstanding]
        self._request()
        return len(missing), len(wanted), plan.error_px, received_bytes

    def _advance(self, time: float) -> None:
        """Receive what arrives until a time; each request slot that becomes free is used at once."""
        while (moment := self._transport.next_time()) <= time:
            for name in self._transport.advance(moment):
                self._receive(name)
            self._request()
        self._transport.advance(time)

    def _request(self) -> None:
        count = min(self._transport.free, len(self._queue))
        if not count:
            return
        parts = [self._queue.pop() for _ in range(count)]
        for part, size in zip(parts, self._sizes(parts), strict=True):
            name = str(len(self._requests))
            self._requests[name] = part, size
            self._outstanding.add(part)
            self.requested_bytes += size
            self._transport.ask(name, size)

    def _receive(self, name: str) -> None:
        part, size = self._requests[name]
        self._outstanding.discard(part)
        self._cache.put(part, size)
        before = self._received
        if kind(part) == GEOMETRY:
            self._received = Received(before.views, before.view_bytes, before.leaves + 1, before.leaf_bytes + size)
        else:
            self._received = Received(before.views + 1, before.view_bytes + size, before.leaves, before.leaf_bytes)
