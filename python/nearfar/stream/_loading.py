"""Loading of a region over a link on a virtual clock: requested files, arrivals, and the content of frames."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field

from nearfar.stream._stage import BLANK, Rates, Shown, Stage
from nearfar.stream._strategies import Plan, Step
from nearfar.stream._transport import Transport

MAX_PREFETCH_BYTES = 16 * 2**20
"""Greatest number of bytes that the page requests ahead."""
MANIFEST = "manifest.json"


@dataclass
class _Work:
    """Decoding of a part of a step, in its own worker."""

    files: tuple[str, ...]
    ends: float | None = None
    """Time at which decoding ends; None until it has begun."""


@dataclass
class Loader:
    """Requests the files of a plan as the page does, and reports the rings that have been decoded."""

    plan: Plan
    sizes: Mapping[str, tuple[int, int]]
    """Transfer size and unpacked size of each file, including the manifest, in bytes."""
    transport: Transport
    seconds_per_byte: float
    """Decoding time per byte in a worker."""
    may_replace: Callable[[int], bool]
    place: int = -1
    """Number of the current step; −1 while the manifest is loading."""
    _map: _Work | None = None
    _geometry: _Work | None = None
    _ahead: set[str] = field(default_factory=set)

    def begin(self) -> None:
        """Request the manifest."""
        self.transport.ask(MANIFEST, self.sizes[MANIFEST][0])

    @property
    def is_done(self) -> bool:
        """Return whether all steps have ended."""
        return self.place >= len(self.plan.steps)

    def next_time(self) -> float:
        """Return the next time at which a running decoding ends; infinite if none runs."""
        works = (self._map, self._geometry)
        ends = [work.ends for work in works if work is not None and work.ends is not None]
        later = [end for end in ends if end > self.transport.now]
        return min(later, default=math.inf)

    def go_on(self) -> Iterator[Step]:
        """Start and end all work that can start and end now; yield each ended step before the next one starts."""
        if self.place < 0:
            if MANIFEST not in self.transport.arrived:
                return
            self._begin_next()
        while not self.is_done:
            step = self.plan.steps[self.place]
            self._decode(step)
            works = [work for work in (self._map, self._geometry) if work is not None]
            if any(work.ends is None or work.ends > self.transport.now for work in works):
                return
            yield step
            self._begin_next()

    def _decode(self, step: Step) -> None:
        for work in (self._map, self._geometry):
            if work is None or work.ends is not None:
                continue
            if any(name not in self.transport.arrived for name in work.files):
                continue
            if work is self._map and step.ring and not self.may_replace(step.ring):
                continue
            work.ends = self.transport.now + self.seconds_per_byte * sum(self.sizes[name][1] for name in work.files)

    def _begin_next(self) -> None:
        self.place += 1
        if self.is_done:
            return
        steps = self.plan.steps
        step = steps[self.place]
        self._map = None if step.map is None else _Work(step.map)
        self._geometry = _Work(step.geometry) if step.geometry else None
        for name in step.requests:
            self._ahead.discard(name)
            self.transport.ask(name, self.sizes[name][0])
        if self.place + 1 < len(steps) and steps[self.place + 1].is_ahead:
            self._ask_ahead(steps[self.place + 1])

    def _ask_ahead(self, step: Step) -> None:
        for name in step.files:
            held = sum(self.sizes[other][1] for other in self._ahead)
            if name in self.transport.arrived or name in self._ahead or held + self.sizes[name][1] > MAX_PREFETCH_BYTES:
                continue
            self._ahead.add(name)
            self.transport.ask(name, self.sizes[name][0])


@dataclass(frozen=True)
class Frame:
    """A frame whose state differs from that of the previous frame."""

    time: float
    shown: Shown
    triangles: int


@dataclass
class Course:
    """Events during the loading of a region."""

    files: list[tuple[str, float]] = field(default_factory=list)
    """Files and their arrival times."""
    rings: list[tuple[int, float]] = field(default_factory=list)
    """Rings and the times at which they were decoded."""
    frames: list[Frame] = field(default_factory=list)


def follow(
    plan: Plan,
    loader: Loader,
    rates: Rates,
    *,
    rate: float,
    duration: float,
    least: Callable[[float], float],
    moves: Callable[[float], bool],
) -> Course:
    """Simulate a client that loads and shows all steps, until nothing changes any more or the duration is over.

    `least` returns the least radius for the user at a time; `moves` returns whether the user moves after a time.
    """
    stage = Stage(rates, is_smooth=plan.is_smooth, is_whole=plan.is_whole)
    loader.may_replace = stage.may_replace
    course, transport = Course(), loader.transport
    drawn = _triangles_by_ring(plan)
    loader.begin()
    before, last = 0.0, BLANK
    """Time of the previous frame, and what it showed."""
    course.frames.append(Frame(0.0, BLANK, 0))
    while True:
        is_still = stage.is_still(moves=moves(transport.now))
        frame = math.inf if is_still else (math.floor(before * rate + 0.5) + 1) / rate
        time = min(transport.next_time(), loader.next_time(), frame)
        if time > duration or time == math.inf:
            break
        course.files += [(name, transport.arrived[name]) for name in transport.advance(time)]
        if time == frame:
            shown = stage.advance(frame - before, least(frame))
            before = frame
            if shown != last:
                course.frames.append(Frame(frame, shown, drawn(shown)))
                last = shown
        for step in loader.go_on():
            if step.ring is not None:
                stage.arrive(step.ring)
                course.rings.append((step.ring, transport.now))
                if is_still:
                    # Skipped frames showed the same state.
                    before = math.floor(transport.now * rate) / rate
    return course


def _triangles_by_ring(plan: Plan) -> Callable[[Shown], int]:
    """Return a function that counts a frame's drawn triangles; a cross-fade draws the pictures of both rings."""
    own = {step.ring: step.triangles for step in plan.steps}
    moving = own.pop(None, 0)
    totals = [moving + sum(own.get(ring, 0) for ring in range(last + 1)) for last in range(len(plan.radii) + 1)]

    def triangle_count(shown: Shown) -> int:
        if shown.ring < 0:
            return 0
        return totals[shown.ring] + (totals[shown.ring + 1] if shown.share > 0.0 else 0)

    return triangle_count
