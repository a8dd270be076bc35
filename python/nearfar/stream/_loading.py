"""Simulates in virtual time how the page loads a region over a network: requests, arrivals and frames."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from nearfar.stream._growth import BLANK, Growth, PictureState, PictureTimeline, least_radius
from nearfar.stream._store import MANIFEST
from nearfar.stream._strategies import HeadPath, Plan, Step
from nearfar.stream._transport import Transport

MAX_PREFETCH_BYTES = 16 * 2**20
"""Maximum number of bytes that the page requests ahead."""


@dataclass
class _Decoding:
    """Decoding of a step's map or geometry, in its own worker."""

    files: tuple[str, ...]
    end: float | None = None
    """Time at which it ends; None until it has begun."""


@dataclass
class Loader:
    """Requests the files of a plan as the page does, and reports the rings that have been decoded."""

    plan: Plan
    sizes: Mapping[str, tuple[int, int]]
    """Transfer size and unpacked size of each file, including the manifest, in bytes."""
    transport: Transport
    seconds_per_byte: float
    """Decoding time per byte in a worker."""
    step_number: int = -1
    """Number of the current step; −1 while the manifest is loading."""
    _map: _Decoding | None = None
    _geometry: _Decoding | None = None
    _prefetched: set[str] = field(default_factory=set)
    """Names of files that were requested before their step."""

    @property
    def is_done(self) -> bool:
        """Return whether all steps have ended."""
        return self.step_number >= len(self.plan.steps)

    @property
    def _decodings(self) -> list[_Decoding]:
        return [decoding for decoding in (self._map, self._geometry) if decoding is not None]

    def next_time(self) -> float:
        """Return the next time at which a running decoding ends; infinite if none runs."""
        ends = (decoding.end for decoding in self._decodings if decoding.end is not None)
        return min((end for end in ends if end > self.transport.now), default=math.inf)

    def advance(self, timeline: PictureTimeline) -> Iterator[Step]:
        """Start and end all decoding that can start and end now; yield each ended step before the next one starts."""
        if self.step_number < 0:
            if MANIFEST not in self.transport.arrived:
                return
            self._begin_next()
        while not self.is_done:
            step = self.plan.steps[self.step_number]
            self._decode(step, timeline)
            if any(decoding.end is None or decoding.end > self.transport.now for decoding in self._decodings):
                return
            yield step
            self._begin_next()

    def _decode(self, step: Step, timeline: PictureTimeline) -> None:
        for decoding in self._decodings:
            is_blocked = decoding is self._map and step.ring and not timeline.may_replace(step.ring)
            if decoding.end is None and not is_blocked and self.transport.arrived.keys() >= {*decoding.files}:
                size = sum(self.sizes[name][1] for name in decoding.files)
                decoding.end = self.transport.now + self.seconds_per_byte * size

    def _begin_next(self) -> None:
        self.step_number += 1
        if self.is_done:
            return
        step, *later = self.plan.steps[self.step_number :]
        self._map = None if step.map is None else _Decoding(step.map)
        self._geometry = _Decoding(step.geometry) if step.geometry else None
        for name in step.requests:
            self._prefetched.discard(name)
            self.transport.ask(name, self.sizes[name][0])
        if not later or not later[0].may_be_prefetched:
            return
        for name in later[0].files:
            size, total = self.sizes[name][1], sum(self.sizes[ahead][1] for ahead in self._prefetched)
            is_known = name in self.transport.arrived or name in self._prefetched
            if not is_known and total + size <= MAX_PREFETCH_BYTES:
                self._prefetched.add(name)
                self.transport.ask(name, self.sizes[name][0])


@dataclass(frozen=True)
class Frame:
    """A frame whose state differs from the previous frame's."""

    time: float
    state: PictureState
    triangles: int


Course = tuple[dict[int, float], list[Frame]]
"""Times at which rings were decoded, by ring, and the frames."""


def follow(
    loader: Loader, growth: Growth, path: HeadPath, fold_margin: float, *, rate: float, duration: float
) -> Course:
    """Simulate a client that loads and shows all steps, until nothing changes any more or the duration is over."""
    plan, transport = loader.plan, loader.transport
    timeline = PictureTimeline(plan.radii, growth, is_smooth=plan.is_smooth, is_whole=plan.is_whole)
    ring_times, frames = dict[int, float](), [Frame(0.0, BLANK, 0)]
    transport.ask(MANIFEST, loader.sizes[MANIFEST][0])
    previous_time = 0.0
    """Time of the previous frame."""
    while True:
        is_still = timeline.is_still(moves=len(path.times) > 1 and bool(transport.now < path.times[-1]))
        frame_time = math.inf if is_still else (math.floor(previous_time * rate + 0.5) + 1) / rate
        time = min(transport.next_time(), loader.next_time(), frame_time)
        if time > duration or time == math.inf:
            break
        transport.advance(time)
        if time == frame_time:
            state = timeline.advance(time - previous_time, least_radius(path.axis_distance(time), fold_margin))
            previous_time = time
            if state != frames[-1].state:
                frames.append(Frame(time, state, _drawn_triangles(plan, state)))
        for step in loader.advance(timeline):
            if step.ring is not None:
                timeline.arrive(step.ring)
                ring_times[step.ring] = transport.now
                if is_still:
                    # No frames were simulated while the picture was still; go on from the last frame before now.
                    previous_time = math.floor(transport.now * rate) / rate
    return ring_times, frames


def _drawn_triangles(plan: Plan, state: PictureState) -> int:
    """Count the triangles that a frame draws; a cross-fade draws the pictures of both rings."""
    pictures = range(state.ring, state.ring + 1 + (state.share > 0.0)) if state.ring >= 0 else ()
    return sum(step.triangles for last in pictures for step in plan.steps if step.ring is None or step.ring <= last)
