"""Simulates flights over a link on a virtual clock: the client's requests, arriving data, and frames that stall."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import chain
from typing import TYPE_CHECKING, Literal, SupportsFloat, SupportsIndex, Unpack, get_args

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check, plot
from nearfar._base.recent import Recent
from nearfar._base.settings import gather
from nearfar._camera.camera import Camera
from nearfar.orthoview._cut import GEOMETRY, RECORD, Part, kind
from nearfar.orthoview._meter import LinkTotals
from nearfar.orthoview._pilot import Pilot, Plan
from nearfar.orthoview._requests import FlightRequests, Request
from nearfar.orthoview._settings import FlightKeywords, FlightSettings
from nearfar.orthoview._tree import OrthoTree
from nearfar.stream._link import Link
from nearfar.stream._transport import Transport

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Planner = Callable[[Camera, float, LinkTotals, bool, Callable[[Part], bool]], Plan]
"""Plans a frame's parts. Arguments: the camera, the time in seconds, the totals received until then, whether requests
were outstanding since the previous frame, and a function that says whether a part has been received."""

Value = Literal["bytes", "missing", "error_px"]
"""Value that a plot shows."""


@dataclass(frozen=True, eq=False, repr=False)
class FlightLog:
    """Frame-by-frame results of a simulated flight, (N,) each."""

    time: NDArray[np.float64]
    """Time of the frame, seconds."""
    missing: NDArray[np.int64]
    """Number of parts of the picture's cut that had not arrived: views, leaves, records of subtrees."""
    wanted: NDArray[np.int64]
    """Number of parts of the picture's cut."""
    error_px: NDArray[np.float64]
    """Greatest width of a view's pixels in the cut, in pixels of the picture."""
    received: NDArray[np.int64]
    """Bytes received by the frame."""
    asked: int
    """Bytes requested in total."""
    requests: int
    """Number of requests in total."""

    @property
    def stalled(self) -> NDArray[np.bool_]:
        """Whether a frame lacked a part of its cut (N,)."""
        return np.asarray(self.missing > 0)

    @property
    def coarser(self) -> NDArray[np.bool_]:
        """Whether a frame's cut was coarser than wanted, because the viewer was too fast (N,)."""
        return np.asarray(self.error_px > self.error_px.min())

    def plot(self, ax: Axes | None = None, *, value: Value = "bytes") -> Axes:
        """Plot one value over time with matplotlib, by default on new axes.

        `value` is "bytes" (received), "missing" or "error_px". ImportError if matplotlib is not installed; ValueError
        for another name; TypeError for a value that is not axes.
        """
        check.choice("value", value, get_args(Value))
        rows = {"bytes": self.received, "missing": self.missing, "error_px": self.error_px}
        return plot.over_time(ax, self.time, rows[value], value, steps=True)

    def __repr__(self) -> str:
        return (
            f"FlightLog({len(self.time):,} frames, {self.stalled.mean():.1%} stalled, "
            f"{self.coarser.mean():.1%} coarser, {self.requests:,} requests, {self.asked:,} bytes)"
        )


def simulate(
    tree: OrthoTree,
    cameras: Sequence[Camera],
    *,
    link: Link,
    rate: SupportsFloat = 72.0,
    cache_bytes: SupportsIndex = 1 << 30,
    seed: SupportsIndex = 0,
    settings: FlightSettings | None = None,
    **keywords: Unpack[FlightKeywords],
) -> FlightLog:
    """Fly through a tree over a link as `OrthoTree.fly` does, on a virtual clock; nothing is drawn.

    The requests are those of a flight through a tree that has just been opened behind a URL. Each of `threads` threads
    makes one request at a time over its own connection, which is HTTP/1.1 whatever `link.http` is, since fsspec
    supports nothing else. A view takes one request, the record of a subtree one, a leaf one for each of its files and
    for each texture that no earlier leaf has requested; if another leaf has, it waits for the response. The planner
    runs once a frame. Decoding takes no time. Returns the results, frame by frame. ValueError for values out of range,
    no cameras, or an incomplete tree; TypeError for arguments of another type; FormatError and OSError for damaged or
    unreadable parts of the store.

    Parameters
    ----------
    tree
        The tree.
    cameras
        The view of each frame.
    link
        The link to the store.
    rate
        Frames a second, 1 to 1000.
    cache_bytes
        Size of the cache, bytes; the parts of one picture and of the positions ahead are always cached.
    seed
        Random seed of packet loss.
    settings
        The flight, as `FlightSettings`.
    keywords
        Fields of `settings`, which they replace: `views`, `error_px`, `geometry`, `prefetch`, `margin_deg`, `adapt`,
        `threads`.
    """
    checked_tree = check.instance("tree", tree, OrthoTree)
    checked_cameras = check.items("cameras", cameras, Camera, "a sequence of Cameras")
    if not checked_cameras:
        raise ValueError("cameras: expected at least one, got none")
    check.instance("link", link, Link)
    frames = check.in_range("rate", rate, 1.0, 1000.0)
    flight = gather(FlightSettings, settings, keywords)
    requests = FlightRequests(checked_tree)
    pilot = Pilot(requests.opened.viewer.cutter, flight.cut, flight.ahead)

    def plan(camera: Camera, time: float, received: LinkTotals, busy: bool, is_read: Callable[[Part], bool]) -> Plan:
        pilot.meter.note(time, received, had_requests=busy)
        pilot.look(camera, time)
        return pilot.plan(is_read)

    cache_size = check.integer("cache_bytes", cache_bytes, 0, 1 << 62)
    transport = Transport(replace(link, http=1), seed=check.integer("seed", seed, 0, 2**63 - 1), at_once=flight.threads)
    return fly_through(Client(plan, requests, transport, flight.threads, cache_size), checked_cameras, frames)


class Client:
    """Reads the parts that a planner wants as `Loader` does: each thread takes the first one of the queue.

    A thread makes the requests for its part one after the other over `transport`.
    """

    def __init__(
        self, planner: Planner, requests: FlightRequests, transport: Transport, threads: int, cache_bytes: int
    ) -> None:
        self._planner, self._requests, self._cache_bytes = planner, requests, cache_bytes
        self._transport, self._idle_threads = transport, threads
        self._cache: Recent[Part, int] = Recent(int)
        """Bytes of the parts received."""
        self._remaining: dict[Part, deque[Request]] = {}
        """Requests that must still be made for the parts being read."""
        self._textures: Recent[str, int] = Recent(int)
        """Bytes of the textures received."""
        self._waiting: dict[str, list[Part]] = {}
        """Parts that wait for a texture that another part has requested, by file."""
        self._part_by_request: dict[str, tuple[Part, Request]] = {}
        self._bytes_by_part: dict[Part, int] = {}
        self._queue: deque[Part] = deque()
        self._received = LinkTotals()
        self._received_bytes = 0
        self.requested: list[Request] = []
        """All requests, in the order in which they were made."""

    def frame(self, camera: Camera, time: float) -> tuple[int, int, float, int]:
        """Advance to a frame; return its `missing`, `wanted`, `error_px` and `received`, as in `FlightLog`."""
        had_requests = bool(self._remaining)
        self._advance(time)
        plan = self._planner(camera, time, self._received, had_requests, self._cache.__contains__)
        parts = list(chain(*plan.wanted.values()))
        unknown = sum(plan.unknown[:1])
        missing = [part for part in parts if part not in self._cache]
        received_bytes = self._received_bytes
        for part in parts:
            self._cache.get(part)
        self._cache.trim({*plan.order, *parts}, self._cache_bytes)
        self._queue = deque(part for part in plan.order if part not in self._cache and part not in self._remaining)
        self._start_threads()
        return len(missing) + unknown, len(parts) + unknown, plan.error_px, received_bytes

    def _advance(self, time: float) -> None:
        """Receive data until a time; each thread that becomes idle takes the next part at once."""
        while (moment := self._transport.next_time()) <= time:
            for name in self._transport.advance(moment):
                self._receive_response(*self._part_by_request.pop(name))
            self._start_threads()
        self._transport.advance(time)

    def _start_threads(self) -> None:
        while self._idle_threads and self._queue:
            part = self._queue.popleft()
            self._idle_threads -= 1
            self._remaining[part] = deque(self._requests.list_requests(part))
            self._bytes_by_part[part] = 0
            self._continue(part)

    def _receive_response(self, part: Part, request: Request) -> None:
        """Continue with a part, and with those that have waited for the same texture."""
        waiting = self._waiting.pop(request.file, [])
        if request.is_texture:
            self._textures.put(request.file, request.bytes)
            self._textures.trim((), self._requests.opened.viewer.near.max_bytes)
        for each in (part, *waiting):
            self._continue(each)

    def _continue(self, part: Part) -> None:
        """Make the next request for a part, or wait for another part's; without further requests it has been read."""
        remaining = self._remaining[part]
        while remaining and remaining[0].is_texture and self._textures.get(remaining[0].file) is not None:
            remaining.popleft()
        if not remaining:
            del self._remaining[part]
            self._idle_threads += 1
            self._receive(part, self._bytes_by_part.pop(part))
        elif remaining[0].file in self._waiting:
            self._waiting[remaining[0].file].append(part)
        else:
            request = remaining.popleft()
            if request.is_texture:
                self._waiting[request.file] = []
            name = str(len(self.requested))
            self.requested.append(request)
            self._bytes_by_part[part] += request.bytes
            self._part_by_request[name] = (part, request)
            self._transport.ask(name, request.bytes)

    def _receive(self, part: Part, size: int) -> None:
        self._requests.receive(part)
        self._received_bytes += size
        before = self._received
        if kind(part) == RECORD:
            return
        self._cache.put(part, size)
        if kind(part) == GEOMETRY:
            self._received = LinkTotals(before.views, before.view_bytes, before.leaves + 1, before.leaf_bytes + size)
        else:
            self._received = LinkTotals(before.views + 1, before.view_bytes + size, before.leaves, before.leaf_bytes)


def fly_through(client: Client, cameras: Sequence[Camera], rate: float) -> FlightLog:
    """Run a client through the frames of a flight."""
    frames = [client.frame(camera, number / rate) for number, camera in enumerate(cameras)]
    missing, wanted, error_px, received = (np.array(column) for column in zip(*frames, strict=True))
    asked = sum(request.bytes for request in client.requested)
    times = np.arange(len(frames)) / rate
    return FlightLog(times, missing, wanted, error_px, received, asked, len(client.requested))
