"""Simulates flights over a link on a virtual clock."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal, SupportsFloat, SupportsIndex, Unpack, get_args

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check, plot
from nearfar._base.settings import gather
from nearfar._camera.camera import Camera
from nearfar.orthoview._client import Client
from nearfar.orthoview._cut import RECORD, Part, kind
from nearfar.orthoview._meter import Received
from nearfar.orthoview._pilot import Pilot, Plan
from nearfar.orthoview._settings import FlightKeywords, FlightSettings
from nearfar.orthoview._tree import OrthoTree
from nearfar.stream._link import Link

if TYPE_CHECKING:
    from matplotlib.axes import Axes

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
        stalled: NDArray[np.bool_] = self.missing > 0
        return stalled

    @property
    def coarser(self) -> NDArray[np.bool_]:
        """Whether a frame's cut was coarser than wanted, because the viewer was too fast (N,)."""
        coarser: NDArray[np.bool_] = self.error_px > self.error_px.min()
        return coarser

    def plot(self, ax: Axes | None = None, *, value: Value = "bytes") -> Axes:
        """Plot one value over time with matplotlib.

        Parameters
        ----------
        ax
            Matplotlib axes; new ones by default.
        value
            "bytes" received, "missing" or "error_px".

        Raises
        ------
        ImportError
            If matplotlib is not installed.
        ValueError, TypeError
            Another name, or a value that is not axes.
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
    take no time.

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

    Returns
    -------
    FlightLog
        Results, frame by frame.

    Raises
    ------
    ValueError
        Values out of range, no cameras, or an incomplete tree.
    TypeError
        Arguments of another type.
    FormatError, OSError
        Damaged or unreadable parts of the store.
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

    def plan(camera: Camera, time: float, received: Received, busy: bool, held: Callable[[Part], bool]) -> Plan:
        """Plan a frame; all records are read at once, without the link."""
        pilot.meter.note(time, received, had_requests=busy)
        pilot.look(camera, time)
        while True:
            plan_of_frame = pilot.plan(held)
            unknown = [part for part in plan_of_frame.order if kind(part) == RECORD]
            if not unknown:
                return plan_of_frame
            for tier, place, _ in unknown:
                cutter.learn(tier, place)

    cache_size = check.integer("cache_bytes", cache_bytes, 0, 1 << 62)
    client = Client(plan, opened.sizes, link, cache_size, check.integer("seed", seed, 0, 2**63 - 1))
    return fly_through(client, checked_cameras, frames)


def fly_through(client: Client, cameras: Sequence[Camera], rate: float) -> FlightLog:
    """Run a client through the frames of a flight."""
    frames = [client.frame(camera, number / rate) for number, camera in enumerate(cameras)]
    missing, wanted, error_px, received = (np.array(column) for column in zip(*frames, strict=True))
    return FlightLog(np.arange(len(frames)) / rate, missing, wanted, error_px, received, client.requested_bytes)
