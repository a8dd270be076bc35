"""Pictures of a user who walks between regions, with cross-fades or hard cuts."""

from __future__ import annotations

import math
import time
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from nearfar._base import check
from nearfar._camera.camera import Camera
from nearfar._reduce.impostors import Impostors
from nearfar._reduce.reduced_scene import ReducedScene
from nearfar._reduce.walk.folds import walkable_distance
from nearfar._render.frame import Frame, blend

TRANSITIONS = ("fade", "cut")
"""Names of transitions between regions."""

MAX_FADE = 60.0
"""Greatest duration of a cross-fade, seconds."""

Point = tuple[float, float, float]


@dataclass(frozen=True)
class _ShownRegion:
    number: int
    reduced: ReducedScene | Impostors

    def margin(self, user: Point) -> float:
        """Metres that the user can still walk before its picture folds; infinite for impostors."""
        if isinstance(self.reduced, Impostors):
            return math.inf
        reduced, (x, y, z) = self.reduced, np.subtract(user, self.reduced.center)
        return walkable_distance(reduced.morph, reduced.r1, reduced.r2, abs(y)) - math.hypot(x, z)


class Walk:
    """Pictures of one user's walk through regions; created by `Regions.walk`.

    A walk remembers the present region, and the previous one during a cross-fade.
    """

    def __init__(self, regions: Any, *, fade: float = 0.5, transition: str = "fade", ahead: bool = True) -> None:
        for name in ("index", "ready", "reduced", "prefetch", "jump"):
            if not callable(getattr(regions, name, None)):
                raise TypeError(f"regions: expected Regions, got {check.type_and_value(regions)}")
        self._regions, self._fade = regions, check.in_range("fade", fade, 0.0, MAX_FADE)
        self._transition = check.choice("transition", transition, TRANSITIONS)
        self._ahead = check.flag("ahead", ahead)
        self._current: _ShownRegion | None = None
        self._previous: _ShownRegion | None = None
        self._change_time = -math.inf
        self._last_position: tuple[Point, float] | None = None
        self._velocity = (0.0, 0.0, 0.0)

    @property
    def region(self) -> int | None:
        """Number of the region that the user is in; None before the first picture."""
        return None if self._current is None else self._current.number

    def render(self, camera: Camera, seconds: float, **options: Any) -> Frame:
        """Render the picture for the user at a time. Errors as in `ReducedScene.render` and `Regions.reduced`.

        Parameters
        ----------
        camera
            The view.
        seconds
            Time on any clock. The user's velocity is computed from the last picture with another time. Views of the
            same moment, such as two eyes, must have the same `seconds` and `user`.
        options
            Arguments of `ReducedScene.render`. `user` is the eye U where that is not the camera's position.

        Returns
        -------
        Frame
            During a cross-fade, colour is the linear blend of both pictures, and all other images are those of the
            newer region. A fade ends early if the older region's picture would fold. `stats` are those of the newer
            region's picture, plus: `region`, its number; `fade`, its share of the colour, 1 without a fade; `jump`, the
            predicted jump in pixels at r2 of the present change, 0 without a change; `waited`, seconds spent waiting
            for the region; `fold_margin`, the least one of the shown pictures in metres, where the height of the user
            above or below the centre is rounded up to decimetres.
        """
        view, time_s = check.instance("camera", camera, Camera), check.number("seconds", seconds)
        user_position: ArrayLike | None = options.get("user")
        user = view.position if user_position is None else check.vector("user", user_position)
        region_before = self._current
        waited = self._step(user, time_s)
        current = self._current
        assert current is not None
        if self._ahead:
            self._regions.prefetch(user, self._velocity, current.number)
        frame = current.reduced.render(view, **options)
        fading_region, weight = self._previous, self._fade_weight(time_s)
        if fading_region is not None and frame.color is not None:
            fading_frame = fading_region.reduced.render(view, **{**options, "channels": ("color",)})
            frame = blend(fading_frame, frame, weight)
        jump, previous = 0.0, region_before if fading_region is None else fading_region
        if previous is not None and (fading_region is not None or previous.number != current.number):
            jump = self._regions.jump(previous.number, current.number, view)
        facts = {
            "region": current.number,
            "fade": weight,
            "jump": jump,
            "waited": waited,
            "fold_margin": min(region.margin(user) for region in (current, fading_region) if region is not None),
        }
        return replace(frame, stats={**frame.stats, **facts})

    def _step(self, user: Point, now: float) -> float:
        """Move the user; return the seconds spent waiting for a region."""
        waited = 0.0
        number = self._regions.index(user, self.region)
        if number != self.region:
            started, was_ready = time.perf_counter(), self._regions.ready(number)
            reduced = self._regions.reduced(number)
            waited = 0.0 if was_ready else time.perf_counter() - started
            self._previous = self._current if self._transition == "fade" else None
            self._current, self._change_time = _ShownRegion(number, reduced), now
        if self._previous is not None and (self._fade_weight(now) >= 1.0 or self._previous.margin(user) <= 0.0):
            self._previous = None
        self._measure_velocity(user, now)
        return waited

    def _measure_velocity(self, user: Point, now: float) -> None:
        if self._last_position is not None and now != self._last_position[1]:
            with np.errstate(all="ignore"):
                velocity = np.subtract(user, self._last_position[0]) / (now - self._last_position[1])
            # The velocity between nearly equal times overflows.
            if np.isfinite(velocity).all():
                self._velocity = (float(velocity[0]), float(velocity[1]), float(velocity[2]))
        if self._last_position is None or now != self._last_position[1]:
            self._last_position = user, now

    def _fade_weight(self, now: float) -> float:
        """Share of the newer region's colour."""
        if self._previous is None or self._fade == 0.0:
            return 1.0
        return min(max((now - self._change_time) / self._fade, 0.0), 1.0)

    def __repr__(self) -> str:
        return f"Walk({self._transition!r}, {self._fade:g} s, region {self.region})"
