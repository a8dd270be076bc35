"""A client's wishes at each moment: the cut of its picture, what comes next, and how coarse both may be."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from itertools import chain

import numpy as np

from nearfar._camera.camera import Camera
from nearfar._camera.rotation import rotation
from nearfar.orthoview._cut import Cutter, OrthoCut, Settings
from nearfar.orthoview._meter import Meter
from nearfar.orthoview._motion import Motion
from nearfar.orthoview._parts import Part, leaf_parts, records_of
from nearfar.orthoview._prefetch import Outlook, PrefetchQueue, offsets, queue, seen_parts, smallest
from nearfar.orthoview._standins import Wanted

RENEWED_TURN = math.radians(5.0)
"""Turn after which the queue is renewed; it also is when the viewer has become twice or half as fast."""

LONGEST = 1.0
"""Greatest number of seconds for which a turn is foreseen."""

HORIZON = 1.0
"""Seconds of its way that a viewer looks ahead, at most the side of the smallest cell."""

STEPS = 10
"""Number of steps by which a picture becomes coarser when the viewer is too fast; each step is a factor of √2."""

SLACK = 1.5
"""Factor by which the limit of the speed must exceed the speed before the picture becomes finer again."""

SHARE = 0.8
"""Share of the link's rate that a viewer's course may ask for."""

LEAST_SPEED, SLOW = 1e-3, 1.0
"""Metres a second below which a viewer rests, and below which a change of its speed does not count."""


@dataclass(frozen=True)
class Ahead:
    """How a client looks ahead."""

    prefetch: bool = True
    """Whether it reads what comes next, besides what the picture shows."""
    margin: float | None = math.radians(5.0)
    """Radians around the picture within which it does; None for all around."""
    adapt: bool = True
    """Whether pictures become coarser when the viewer moves faster than the link allows."""


@dataclass(frozen=True)
class Plan:
    """A client's wishes."""

    wanted: Wanted
    """Cells of the picture's cut, and the parts that each of them is to be drawn from."""
    order: list[Part]
    """Parts to be read, the most urgent first; some that are there may be among them."""
    error_px: float
    """Greatest width of a view's pixels, in pixels of the picture, of the picture's cut."""
    beside: list[Wanted] = field(default_factory=list)
    """Cells and parts of the pictures that are drawn beside it."""


@dataclass(frozen=True)
class _Renewed:
    """A queue, and where it was made."""

    queue: PrefetchQueue
    camera: Camera
    error_px: float
    speed: float


class Pilot:
    """Plans for a viewer.

    Parameters
    ----------
    cutter
        Cuts the tree.
    settings
        How it is viewed.
    ahead
        How the client looks ahead.
    """

    def __init__(self, cutter: Cutter, settings: Settings, ahead: Ahead) -> None:
        self._cutter, self._settings, self._ahead = cutter, settings, ahead
        self._motion = Motion()
        self.camera: Camera | None = None
        """Where the viewer is."""
        self._beside: Sequence[Camera] = ()
        self._error = settings.error_px
        self._wished = settings.error_px
        self._renewed: _Renewed | None = None
        self._base: list[Part] = []
        self.meter = Meter()
        """Of the link."""
        self.limit = math.inf
        """Metres a second that the link allows at the wanted error; it grows with the distance from what is small."""

    @property
    def settings(self) -> Settings:
        """How the tree is viewed now."""
        return replace(self._settings, error_px=self._error)

    def take(self, cutter: Cutter) -> None:
        """Go on with a newer generation of the tree."""
        self._cutter, self._renewed = cutter, None

    def look(self, camera: Camera, time: float, beside: Sequence[Camera] = ()) -> None:
        """Note where the viewer is at a time in seconds, and the cameras of pictures beside its own."""
        self._motion.add(camera, time)
        self.camera, self._beside = camera, beside

    def plan(self, held: Callable[[Part], bool]) -> Plan:
        """The wishes where the viewer is; `held` tells what is there."""
        camera = self.camera
        if camera is None:
            raise RuntimeError("expected a look before a plan")
        records: list[Part] = []
        soon: list[Part] = []
        if self._ahead.prefetch:
            renewed = self._renew(camera)
            records, soon = [*renewed.unknown], [*renewed.needed, *renewed.soon]
        cut, coming = self._cut(camera, held)
        wanted = self.wanted(cut)
        if not self._base:
            self._base = self._top(camera)
        # A finer picture can wait until nothing else does.
        then = [*soon, *coming] if self._wished < self._error else [*coming, *soon]
        others = [self._cutter.cut(other, self.settings) for other in self._beside]
        beside = [self.wanted(other) for other in others]
        records += [record for other in others for record in records_of(other)]
        parts = [part for each in (wanted, *beside) for part in chain(*each.values())]
        order = [*records_of(cut), *self._base, *records, *parts, *then]
        return Plan(wanted, list(dict.fromkeys(order)), self._error, beside)

    def wanted(self, cut: OrthoCut) -> Wanted:
        """The cells of a picture's cut with the parts of each: leaves as geometry, then cells as views, by distance."""
        found: Wanted = {(0, leaf): leaf_parts([leaf], self._cutter) for leaf in cut.leaf_places(in_picture=True)}
        for level, place, direction in cut.keys(in_picture=True):
            found.setdefault((level, place), []).append((level, place, direction))
        return found

    def _cut(self, camera: Camera, held: Callable[[Part], bool]) -> tuple[OrthoCut, list[Part]]:
        """The picture's cut at the error in force, and the parts of that at the wished one.

        A coarser cut comes into force when it is there, or when the finer one is not; a finer one when it is there.
        """
        now = self._cutter.cut(camera, self.settings)
        if self._wished == self._error:
            return now, []
        next_cut = self._cutter.cut(camera, replace(self._settings, error_px=self._wished))
        coming = [*chain(*self.wanted(next_cut).values())]
        is_there = all(map(held, coming)) and not next_cut.unknown
        if is_there or (self._wished > self._error and not all(map(held, chain(*self.wanted(now).values())))):
            self._error = self._wished
            return next_cut, []
        return now, coming

    def _top(self, camera: Camera) -> list[Part]:
        """The coarsest views, parts of which stand for all else until it comes."""
        coarsest = replace(self._settings, error_px=1e30, geometry=False)
        return self._cutter.cut(camera, coarsest, around=True).keys()

    def _renew(self, camera: Camera) -> PrefetchQueue:
        """The queue, made anew where the viewer has moved or turned, or what was unknown may be known."""
        old = self._renewed
        speed = float(np.linalg.norm(self._motion.velocity))
        if speed <= LEAST_SPEED:
            self._wished = self._settings.error_px
        if (
            old is not None
            and not old.queue.unknown
            and self._error == old.error_px
            and self._is_near(old, camera, speed)
        ):
            return old.queue
        course = self._motion.velocity / speed if speed > LEAST_SPEED else None
        settings = self.settings
        ahead = smallest(self._cutter.cut(camera, settings, around=True), self._cutter.grid)
        if course is not None:
            ahead = min(ahead, speed * HORIZON)
        seconds = min(ahead / speed, LONGEST) if speed > LEAST_SPEED else LONGEST
        cameras = [self._motion.after(seconds, offset) for offset in offsets(ahead, course)]
        outlook = Outlook([camera, *cameras[:1]], self._ahead.margin)
        made = queue(self._cutter, settings, camera, cameras, outlook)
        self._renewed = _Renewed(made, camera, self._error, speed)
        if self._ahead.adapt and course is not None:
            self._adapt(speed, (camera, self._motion.after(0.0, ahead * course)), ahead, outlook)
        return made

    def _is_near(self, old: _Renewed, camera: Camera, speed: float) -> bool:
        moved = np.linalg.norm(np.subtract(camera.position, old.camera.position))
        cosine = np.clip(rotation(camera.orientation)[:, 2] @ rotation(old.camera.orientation)[:, 2], -1.0, 1.0)
        is_as_fast = 0.5 <= max(speed, SLOW) / max(old.speed, SLOW) <= 2.0
        return bool(is_as_fast and moved <= old.queue.renewed_after and math.acos(cosine) <= RENEWED_TURN)

    def _adapt(self, speed: float, way: tuple[Camera, Camera], metres: float, outlook: Outlook) -> None:
        """Wish for the least error at which the link brings what the viewer's course asks for."""
        own = self._settings.error_px
        for step in range(STEPS + 1):
            error = own * 2.0 ** (step / 2.0)
            limit = self._limit(way, metres, outlook, replace(self._settings, error_px=error))
            if step == 0:
                self.limit = limit
            if limit >= speed * (SLACK if error < self._error else 1.0):
                break
        self._wished = error

    def _limit(self, way: tuple[Camera, Camera], metres: float, outlook: Outlook, settings: Settings) -> float:
        """Speed at which the parts that come into sight on a way are read as fast as they are needed."""
        cutter = self._cutter
        here, there = (seen_parts(cutter, cutter.cut(camera, settings, around=True), camera, outlook) for camera in way)
        count = sum(self.meter.bytes_of(part) for part in there.keys() - here.keys())
        return SHARE * self.meter.rate * metres / count if count > 0.0 else math.inf
