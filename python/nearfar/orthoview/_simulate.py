"""Simulates flights over a link on a virtual clock: the client's requests, what has arrived, and frames that stall."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
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
from nearfar.orthoview._settings import FlightKeywords, FlightSettings
from nearfar.orthoview._tree import OrthoTree
from nearfar.stream._link import Link
from nearfar.stream._transport import Transport

if TYPE_CHECKING:
    from matplotlib.axes import Axes

MAX_REQUESTS = 16
"""Concurrent requests of a client: two threads with eight views each."""

Planner = Callable[[Camera, float, LinkTotals, bool, Callable[[Part], bool]], Plan]
"""Plans a frame's parts: from the camera, the time in seconds, what has been received until then, whether requests were
outstanding since the frame before, and whether a part has been received."""

Value = Literal["bytes", "missing", "error_px"]
"""Value that a plot shows."""


@dataclass(frozen=True, eq=False, repr=False)
class FlightLog:
    """Frame-by-frame results of a simulated flight, (N,) each."""

    time: NDArray[np.float64]
    """Time of the frame, seconds."""
    missing: NDArray[np.int64]
    """Number of parts of the picture's cut, views or files of geometry, that had not arrived."""
    wanted: NDArray[np.int64]
    """Number of parts of the picture's cut."""
    error_px: NDArray[np.float64]
    """Greatest width of a view's pixels in the cut, in pixels of the picture."""
    received: NDArray[np.int64]
    """Bytes received by the frame."""
    asked: int
    """Bytes requested in total."""

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
            f"{self.coarser.mean():.1%} coarser, {self.asked:,} bytes)"
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

    At most 16 requests are outstanding, each for the bytes of all channels of one part. Reading records and decoding
    take no time. Returns the results, frame by frame. ValueError for values out of range, no cameras, or an incomplete
    tree; TypeError for arguments of another type; FormatError and OSError for damaged or unreadable parts of the store.

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
        Size of the cache, bytes; parts of one picture and of the positions ahead are always kept.
    seed
        Random seed of packet loss.
    settings
        The flight, as `FlightSettings`.
    keywords
        Fields of `settings`, which they replace: `views`, `error_px`, `geometry`, `prefetch`, `margin_deg`, `adapt`.
    """
    checked_tree = check.instance("tree", tree, OrthoTree)
    checked_cameras = check.items("cameras", cameras, Camera, "a sequence of Cameras")
    if not checked_cameras:
        raise ValueError("cameras: expected at least one, got none")
    check.instance("link", link, Link)
    frames = check.in_range("rate", rate, 1.0, 1000.0)
    flight = gather(FlightSettings, settings, keywords)
    opened = checked_tree._open_store()
    cutter = opened.viewer.cutter
    pilot = Pilot(cutter, flight.cut, flight.ahead)

    def plan(camera: Camera, time: float, received: LinkTotals, busy: bool, is_read: Callable[[Part], bool]) -> Plan:
        """Plan a frame; all records are read at once, without the link."""
        pilot.meter.note(time, received, had_requests=busy)
        pilot.look(camera, time)
        while True:
            plan_of_frame = pilot.plan(is_read)
            unknown = [part for part in plan_of_frame.order if kind(part) == RECORD]
            if not unknown:
                return plan_of_frame
            for tier, place, _ in unknown:
                cutter.learn(tier, place)

    cache_size = check.integer("cache_bytes", cache_bytes, 0, 1 << 62)
    client = Client(plan, opened.sizes, link, cache_size, check.integer("seed", seed, 0, 2**63 - 1))
    return fly_through(client, checked_cameras, frames)


class Client:
    """Fetches the parts that a planner wants over a link; `sizes` returns their sizes in bytes."""

    def __init__(
        self, planner: Planner, sizes: Callable[[Sequence[Part]], list[int]], link: Link, cache_bytes: int, seed: int
    ) -> None:
        self._planner, self._sizes, self._cache_bytes = planner, sizes, cache_bytes
        self._transport = Transport(link, seed=seed, at_once=MAX_REQUESTS)
        self._cache: Recent[Part, int] = Recent(int)
        """Bytes of the parts received."""
        self._requests: dict[str, tuple[Part, int]] = {}
        self._outstanding: set[Part] = set()
        self._queue: list[Part] = []
        self._received = LinkTotals()
        self.requested_bytes = 0

    def frame(self, camera: Camera, time: float) -> tuple[int, int, float, int]:
        """Advance to a frame; return its fields of `FlightLog`: `missing`, `wanted`, `error_px` and `received`."""
        had_requests = bool(self._outstanding)
        self._advance(time)
        plan = self._planner(camera, time, self._received, had_requests, self._cache.__contains__)
        parts = list(chain(*plan.wanted.values()))
        missing = [part for part in parts if part not in self._cache]
        received_bytes = self._received.bytes
        for part in parts:
            self._cache.get(part)
        self._cache.trim({*plan.order, *parts}, self._cache_bytes)
        self._queue = [part for part in plan.order[::-1] if part not in self._cache and part not in self._outstanding]
        self._request()
        return len(missing), len(parts), plan.error_px, received_bytes

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
            self._received = LinkTotals(before.views, before.view_bytes, before.leaves + 1, before.leaf_bytes + size)
        else:
            self._received = LinkTotals(before.views + 1, before.view_bytes + size, before.leaves, before.leaf_bytes)


def fly_through(client: Client, cameras: Sequence[Camera], rate: float) -> FlightLog:
    """Run a client through the frames of a flight."""
    frames = [client.frame(camera, number / rate) for number, camera in enumerate(cameras)]
    missing, wanted, error_px, received = (np.array(column) for column in zip(*frames, strict=True))
    return FlightLog(np.arange(len(frames)) / rate, missing, wanted, error_px, received, client.requested_bytes)
