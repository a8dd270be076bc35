"""A region that is loaded over a link on a virtual clock: what is asked for, what arrives, and what frames show."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field

from nearfar.stream._stage import BLANK, Rates, Shown, Stage
from nearfar.stream._strategies import Plan, Step
from nearfar.stream._transport import Transport

MOST_AHEAD = 16 * 2**20
"""Bytes that the page asks for ahead, at most."""
MANIFEST = "manifest.json"


@dataclass
class _Work:
    """The decoding of a part of a step, in a worker of its own."""

    files: tuple[str, ...]
    ends: float | None = None
    """When it is done; None until it has begun."""


@dataclass
class Loader:
    """Asks for the files of a plan as the page does, and says which rings are there."""

    plan: Plan
    sizes: Mapping[str, tuple[int, int]]
    """Bytes of each file on its way, and unpacked, the manifest's among them."""
    transport: Transport
    seconds_per_byte: float
    """That decoding takes in a worker."""
    may_replace: Callable[[int], bool]
    place: int = -1
    """Number of the step that runs; −1 while the manifest comes."""
    _map: _Work | None = None
    _geometry: _Work | None = None
    _ahead: set[str] = field(default_factory=set)

    def begin(self) -> None:
        """Ask for the manifest."""
        self.transport.ask(MANIFEST, self.sizes[MANIFEST][0])

    @property
    def is_done(self) -> bool:
        """Whether all steps have ended."""
        return self.place >= len(self.plan.steps)

    def next_time(self) -> float:
        """Return when decoding ends that has begun; infinite if there is none."""
        works = (self._map, self._geometry)
        ends = [work.ends for work in works if work is not None and work.ends is not None]
        later = [end for end in ends if end > self.transport.now]
        return min(later, default=math.inf)

    def go_on(self) -> Iterator[Step]:
        """Begin and end what can begin and end now; yield each step that ended before the next one begins."""
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
        for name in step.asked:
            self._ahead.discard(name)
            self.transport.ask(name, self.sizes[name][0])
        if self.place + 1 < len(steps) and steps[self.place + 1].is_ahead:
            self._ask_ahead(steps[self.place + 1])

    def _ask_ahead(self, step: Step) -> None:
        for name in step.files:
            held = sum(self.sizes[other][1] for other in self._ahead)
            if name in self.transport.arrived or name in self._ahead or held + self.sizes[name][1] > MOST_AHEAD:
                continue
            self._ahead.add(name)
            self.transport.ask(name, self.sizes[name][0])


@dataclass(frozen=True)
class Frame:
    """A frame whose state differs from that of the one before."""

    time: float
    shown: Shown
    triangles: int


@dataclass
class Course:
    """Events while a region was loaded."""

    files: list[tuple[str, float]] = field(default_factory=list)
    """Files and the times at which they were complete."""
    rings: list[tuple[int, float]] = field(default_factory=list)
    """Rings and the times at which they were there."""
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
    """Let a client load and show all, until nothing changes any more or the duration is over.

    `least` is the least radius for the user at a time, and `moves` whether the user moves after it.
    """
    stage = Stage(rates, is_smooth=plan.is_smooth, is_whole=plan.is_whole)
    loader.may_replace = stage.may_replace
    course, transport = Course(), loader.transport
    drawn = _triangles_by_ring(plan)
    loader.begin()
    before, last = 0.0, BLANK
    """Time of the frame before, and what it showed."""
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
                    # Frames in between showed the same.
                    before = math.floor(transport.now * rate) / rate
    return course


def _triangles_by_ring(plan: Plan) -> Callable[[Shown], int]:
    """How many triangles a frame draws: while a picture fades in, those of the next ring, and the last again."""
    own = {step.ring: step.triangles for step in plan.steps}
    moving = own.pop(None, 0)
    totals = [moving + sum(own.get(ring, 0) for ring in range(last + 1)) for last in range(len(plan.radii) + 1)]

    def drawn(shown: Shown) -> int:
        if shown.ring < 0:
            return 0
        return totals[shown.ring] + (totals[shown.ring + 1] if shown.share > 0.0 else 0)

    return drawn
