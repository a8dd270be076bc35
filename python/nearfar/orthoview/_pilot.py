"""Plans what a client reads: the parts of the present cut, then those of cuts along its motion.

A part is a view, the geometry of a leaf, or the record of a subtree. Cuts are as fine as the link allows.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from itertools import chain

import numpy as np
from numpy.typing import NDArray

from nearfar._camera.camera import Camera
from nearfar._camera.rotation import compose_rotations, rotation
from nearfar.orthoview._cut import Cutter, OrthoCut, Part, Settings, leaf_parts, records_of
from nearfar.orthoview._meter import Meter
from nearfar.orthoview._prefetch import Frustums, PrefetchQueue, offsets, queue, seen_parts, smallest_side
from nearfar.orthoview._standins import PartsByCell

WINDOW = 0.25
"""Seconds over which speed is measured."""

MAX_TURN = math.pi / 2
"""Greatest extrapolated turn, radians."""


class Motion:
    """Velocity and turn rate of a viewer, from its last cameras."""

    def __init__(self) -> None:
        self._cameras: deque[tuple[float, Camera]] = deque()

    def add(self, camera: Camera, time: float) -> None:
        """Add the viewer's camera at a time; a time that is not later restarts the measurement."""
        if self._cameras and time <= self._cameras[-1][0]:
            self._cameras.clear()
        self._cameras.append((time, camera))
        while len(self._cameras) > 2 and self._cameras[1][0] <= time - WINDOW:
            self._cameras.popleft()

    @property
    def velocity(self) -> NDArray[np.float64]:
        """Velocity (3,), metres a second."""
        if len(self._cameras) < 2:
            return np.zeros(3)
        (begin, first), (end, last) = self._cameras[0], self._cameras[-1]
        return np.asarray(np.subtract(last.position, first.position) / (end - begin))

    @property
    def turn(self) -> NDArray[np.float64]:
        """Angular velocity about the world axes (3,), radians a second."""
        if len(self._cameras) < 2:
            return np.zeros(3)
        (begin, first), (end, last) = self._cameras[0], self._cameras[-1]
        i, j, k, real = first.orientation
        x, y, z, w = compose_rotations((-i, -j, -k, real), last.orientation)
        axis = np.array([x, y, z]) * (1.0 if w >= 0.0 else -1.0)
        length = float(np.linalg.norm(axis))
        angle = 2.0 * math.atan2(length, abs(w))
        return axis * (angle / length / (end - begin)) if length > 0.0 else np.zeros(3)

    def extrapolate(self, seconds: float, offset: NDArray[np.float64]) -> Camera:
        """Extrapolate the camera by some seconds of the present turn, and move it by an offset in metres."""
        camera = self._cameras[-1][1]
        turn = self.turn * seconds
        angle = float(np.linalg.norm(turn))
        if angle > MAX_TURN:
            turn *= MAX_TURN / angle
            angle = MAX_TURN
        x, y, z = (turn * (math.sin(angle / 2.0) / angle)).tolist() if angle > 0.0 else (0.0, 0.0, 0.0)
        px, py, pz = (np.array(camera.position) + offset).tolist()
        return replace(
            camera,
            position=(px, py, pz),
            orientation=compose_rotations(camera.orientation, (x, y, z, math.cos(angle / 2.0))),
        )


RENEWED_TURN = math.radians(5.0)
"""Turn after which the queue is renewed, radians; it is also renewed when the speed has doubled or halved."""

MAX_TURN_SECONDS = 1.0
"""Maximum number of seconds for which a turn is extrapolated."""

HORIZON_SECONDS = 1.0
"""Seconds of motion that are looked ahead; the distance is at most the side of the smallest cell."""

STEPS = 10
"""Maximum number of steps, each a factor of √2, by which the error grows when the viewer is too fast."""

HYSTERESIS = 1.5
"""Factor by which the speed limit must exceed the speed before the picture becomes finer again."""

RATE_SHARE = 0.8
"""Share of the link's rate that is available for the parts ahead."""

MIN_SPEED, MIN_COMPARED_SPEED = 1e-3, 1.0
"""Speed in metres a second below which a viewer counts as resting; speed below which changes of speed are ignored."""


@dataclass(frozen=True)
class PrefetchSettings:
    """Prefetch settings of a client."""

    prefetch: bool = True
    """Whether the client also reads parts that it will need soon."""
    margin: float | None = math.radians(5.0)
    """Margin around the picture for prefetching, radians; None for all directions."""
    adapt: bool = True
    """Whether pictures become coarser when the viewer moves faster than the link allows."""


@dataclass(frozen=True)
class Plan:
    """Parts that a client needs."""

    wanted: PartsByCell
    """Cells of the picture's cut, and the parts from which each should be drawn."""
    order: list[Part]
    """Parts to read, the most urgent first; it may include parts already read."""
    error_px: float
    """Greatest width on screen, in pixels, of a splat of the cut."""
    further_pictures: list[PartsByCell] = field(default_factory=list)
    """Cells and parts of further pictures drawn at the same time."""
    unknown: list[int] = field(default_factory=list)
    """Number of subtrees, for each picture's cut, whose records have not been read; see `OrthoCut.unknown`."""
    unbuilt: list[int] = field(default_factory=list)
    """Number of cells of each picture's cut that an unfinished build has not reached."""


@dataclass(frozen=True)
class _QueueState:
    """A queue, and the state of the viewer for which it was made."""

    queue: PrefetchQueue
    camera: Camera
    error_px: float
    speed: float


class Pilot:
    """Plans reads for a viewer."""

    def __init__(self, cutter: Cutter, settings: Settings, prefetch_settings: PrefetchSettings) -> None:
        self._cutter, self._settings, self._prefetch_settings = cutter, settings, prefetch_settings
        self._motion = Motion()
        self.camera: Camera | None = None
        self._further_cameras: Sequence[Camera] = ()
        self._error = settings.error_px
        self._target_error = settings.error_px
        self._queue_state: _QueueState | None = None
        self._coarsest: list[Part] = []
        self.meter = Meter()
        self.speed_limit = math.inf
        """Speed that the link allows at the error of the settings, metres a second; greater where cells are large."""

    @property
    def settings(self) -> Settings:
        """Settings with the present error."""
        return replace(self._settings, error_px=self._error)

    def switch_to(self, cutter: Cutter) -> None:
        """Switch to the tree as a running build has extended it."""
        self._cutter, self._queue_state = cutter, None

    def look(self, camera: Camera, time: float, further_cameras: Sequence[Camera] = ()) -> None:
        """Set the viewer's camera at a time in seconds, and the cameras of further pictures."""
        self._motion.add(camera, time)
        self.camera, self._further_cameras = camera, further_cameras

    def plan(self, is_read: Callable[[Part], bool]) -> Plan:
        """Plan for the viewer's camera; `is_read` says which parts have been read."""
        camera = self.camera
        if camera is None:
            raise RuntimeError("expected a look before a plan")
        records: list[Part] = []
        soon: list[Part] = []
        if self._prefetch_settings.prefetch:
            prefetched = self._queue(camera)
            records, soon = [*prefetched.unknown], [*prefetched.needed, *prefetched.soon]
        cut, next_parts = self._cut(camera, is_read)
        parts_by_cell = self.parts_of_cut(cut)
        if not self._coarsest:
            self._coarsest = self._coarsest_views(camera)
        # The parts of a finer picture are read last.
        later = [*soon, *next_parts] if self._target_error < self._error else [*next_parts, *soon]
        further_cuts = [self._cutter.cut(further_camera, self.settings) for further_camera in self._further_cameras]
        further_pictures = [self.parts_of_cut(further_cut) for further_cut in further_cuts]
        records += [record for further_cut in further_cuts for record in records_of(further_cut)]
        parts = [part for cells in (parts_by_cell, *further_pictures) for part in chain(*cells.values())]
        order = [*records_of(cut), *self._coarsest, *records, *parts, *later]
        cuts = (cut, *further_cuts)
        unknown, unbuilt = [len(each.unknown) for each in cuts], [each.unbuilt for each in cuts]
        return Plan(parts_by_cell, list(dict.fromkeys(order)), self._error, further_pictures, unknown, unbuilt)

    def parts_of_cut(self, cut: OrthoCut) -> PartsByCell:
        """Cells of a picture's cut with the parts of each: leaves as geometry, then cells as views, by distance."""
        parts: PartsByCell = {(0, leaf): leaf_parts([leaf], self._cutter) for leaf in cut.leaf_places(in_picture=True)}
        for level, place, direction in cut.keys(in_picture=True):
            parts.setdefault((level, place), []).append((level, place, direction))
        return parts

    def _cut(self, camera: Camera, is_read: Callable[[Part], bool]) -> tuple[OrthoCut, list[Part]]:
        """Return the cut at the present error, and the parts of the cut at the target error if that differs.

        The target error replaces the present one once all parts of its cut have been read, or at once if it is coarser
        and parts of the present cut are missing.
        """
        current = self._cutter.cut(camera, self.settings)
        if self._target_error == self._error:
            return current, []
        next_cut = self._cutter.cut(camera, replace(self._settings, error_px=self._target_error))
        next_parts = [*chain(*self.parts_of_cut(next_cut).values())]
        is_next_complete = all(map(is_read, next_parts)) and not next_cut.unknown
        is_coarser = self._target_error > self._error
        if is_next_complete or (is_coarser and not all(map(is_read, chain(*self.parts_of_cut(current).values())))):
            self._error = self._target_error
            return next_cut, []
        return current, next_parts

    def _coarsest_views(self, camera: Camera) -> list[Part]:
        """Views of the coarsest cells, whose sections stand in for cells that have not been read."""
        coarsest = replace(self._settings, error_px=1e30, geometry=False)
        return self._cutter.cut(camera, coarsest, around=True).keys()

    def _queue(self, camera: Camera) -> PrefetchQueue:
        """Return the prefetch queue; make a new one if the viewer has moved or turned, or the old one lacks records."""
        old = self._queue_state
        speed = float(np.linalg.norm(self._motion.velocity))
        if speed <= MIN_SPEED:
            self._target_error = self._settings.error_px
        if old is not None and self._is_current(old, camera, speed):
            return old.queue
        course = self._motion.velocity / speed if speed > MIN_SPEED else None
        settings = self.settings
        distance = smallest_side(self._cutter.cut(camera, settings, around=True), self._cutter.grid)
        if course is not None:
            distance = min(distance, speed * HORIZON_SECONDS)
        seconds = min(distance / speed, MAX_TURN_SECONDS) if speed > MIN_SPEED else MAX_TURN_SECONDS
        cameras = [self._motion.extrapolate(seconds, offset) for offset in offsets(distance, course)]
        frustums = Frustums([camera, *cameras[:1]], self._prefetch_settings.margin)
        renewed = queue(self._cutter, settings, camera, cameras, frustums)
        self._queue_state = _QueueState(renewed, camera, self._error, speed)
        if self._prefetch_settings.adapt and course is not None:
            self._adapt(speed, (camera, self._motion.extrapolate(0.0, distance * course)), distance, frustums)
        return renewed

    def _is_current(self, old: _QueueState, camera: Camera, speed: float) -> bool:
        """Whether a queue is still good: it lacks no records, and error, camera and speed have hardly changed."""
        if old.queue.unknown or self._error != old.error_px:
            return False
        distance = np.linalg.norm(np.subtract(camera.position, old.camera.position))
        cosine = np.clip(rotation(camera.orientation)[:, 2] @ rotation(old.camera.orientation)[:, 2], -1.0, 1.0)
        is_as_fast = 0.5 <= max(speed, MIN_COMPARED_SPEED) / max(old.speed, MIN_COMPARED_SPEED) <= 2.0
        return bool(is_as_fast and distance <= old.queue.renewed_after and math.acos(cosine) <= RENEWED_TURN)

    def _adapt(self, speed: float, ends: tuple[Camera, Camera], metres: float, frustums: Frustums) -> None:
        """Set the target error: the least one at which the link keeps up with the viewer."""
        base_error = self._settings.error_px
        for step in range(STEPS + 1):
            error = base_error * 2.0 ** (step / 2.0)
            limit = self._speed_limit(ends, metres, frustums, replace(self._settings, error_px=error))
            if step == 0:
                self.speed_limit = limit
            if limit >= speed * (HYSTERESIS if error < self._error else 1.0):
                break
        self._target_error = error

    def _speed_limit(self, ends: tuple[Camera, Camera], metres: float, frustums: Frustums, settings: Settings) -> float:
        """Speed at which the link delivers the parts that come into view between two cameras just in time."""
        cuts = (self._cutter.cut(camera, settings, around=True) for camera in ends)
        parts_now, parts_at_end = (
            seen_parts(self._cutter, cut, camera, frustums) for cut, camera in zip(cuts, ends, strict=True)
        )
        size = sum(self.meter.bytes_of(part) for part in parts_at_end.keys() - parts_now.keys())
        return RATE_SHARE * self.meter.rate * metres / size if size > 0.0 else math.inf
