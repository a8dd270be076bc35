"""Growth of rings: a client's morph changes continuously over time after a ring has arrived."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any

from nearfar._base import check
from nearfar._base.settings import set_fields
from nearfar.stream._assign import check_radii
from nearfar.stream._manifest import NEAR_SHARE

SAFETY_METRES = 0.5
"""Safety margin: a chosen radius folds only for users at least this much farther from the axis."""

_ROUNDING_FACTOR = 1.0 - 1e-9
"""Factor that keeps the last radius large enough despite rounding of its product with the near share."""


@dataclass(frozen=True)
class Growth:
    """Speed at which the morph grows after a ring has arrived. Times are seconds since its arrival.

    First the previous ring's picture is cross-faded to the new one, then the morph grows. A point at ρ between the
    radii has the weight w = (R − ρ) / ((1 − n) R), n = 0.7. While R grows, its direction turns by (|U−O| / ρ) dw/dt =
    |U−O| Ṙ / ((1 − n) R²), the same for all ρ. So at constant speed 1/R falls linearly. Ring 1 has no radius to start
    from: small radii fold for a user beside the centre. It is shown at its own radius while the strength grows
    linearly, which turns a point at ρ by |U−O| / (ρ T) in a growth of T seconds.

    ValueError and TypeError for radii that are not positive and ascending, a `speed` or `reach` of 0 or less, and a
    `fade` below 0. Source: CloVR (2024) lets R grow over a second; constant speed and growth of ring 1 by strength are
    our additions.
    """

    radii: tuple[float, ...]
    """Radii of the rings 1 to n in metres, ascending."""
    speed: float = 0.7
    """Speed of the picture in degrees per second for a user at `reach`; for ring 1, of points at 0.7 of its radius."""
    reach: float = 1.0
    """Distance |U−O| in metres for which `speed` holds. The speed is proportional to the distance."""
    fade: float = 0.5
    """Duration of the cross-fade, seconds."""

    def __post_init__(self) -> None:
        speed, reach = check.positive("speed", self.speed), check.positive("reach", self.reach)
        fade = check.at_least_zero("fade", self.fade)
        set_fields(self, radii=check_radii("radii", self.radii), speed=speed, reach=reach, fade=fade)

    def seconds(self, ring: int) -> float:
        """Return the duration of a ring's cross-fade and growth; 0 for ring 0, which has neither."""
        number = self._check_ring(ring)
        return self.fade + self._full_turn(number) / self._rate if number else 0.0

    def share(self, time: float) -> float:
        """Return the share of the newer picture in the cross-fade, 0 to 1, at a time since a ring's arrival."""
        elapsed = check.at_least_zero("time", time)
        return min(elapsed / self.fade, 1.0) if self.fade else 1.0

    def radius(self, ring: int, time: float) -> float:
        """Return the morph's radius in metres at a time since a ring's arrival; 0 for ring 0."""
        number, grown = self._check_ring(ring), self._turn_at(time)
        if number < 2:
            return self._radius(number)
        before, full = self._radius(number - 1), self._radius(number)
        inverse = 1.0 / before - (1.0 - NEAR_SHARE) * grown
        return full if inverse <= 1.0 / full else 1.0 / inverse

    def strength(self, ring: int, time: float) -> float:
        """Return the morph's strength, 0 to 1, at a time since a ring's arrival; 1 for all rings but the first."""
        number, grown = self._check_ring(ring), self._turn_at(time)
        return min(grown / self._full_turn(1), 1.0) if number == 1 else 1.0

    def pixels(self, focal: float) -> float:
        """Return the speed in pixels per second in the middle of a picture with a focal length in pixels."""
        return math.radians(self.speed) * check.positive("focal", focal)

    def to_manifest(self) -> dict[str, Any]:
        """Return the manifest entry."""
        return {"first": "strength", "speed": self.speed, "reach": self.reach, "fade": self.fade}

    @property
    def _rate(self) -> float:
        """Radians per second for each metre of |U−O|."""
        return math.radians(self.speed) / self.reach

    def _full_turn(self, ring: int) -> float:
        """Return the radians by which the growth of a ring turns the picture, per metre of |U−O|."""
        radius = self._radius(ring)
        if ring == 1:
            return 1.0 / (NEAR_SHARE * radius)
        return (1.0 / self._radius(ring - 1) - 1.0 / radius) / (1.0 - NEAR_SHARE)

    def _turn_at(self, time: float) -> float:
        """Return the picture's turn at a time in radians per metre of |U−O|; not limited to the growth's end."""
        return max(check.at_least_zero("time", time) - self.fade, 0.0) * self._rate

    def _radius(self, ring: int) -> float:
        return (0.0, *self.radii)[ring]

    def _check_ring(self, ring: int) -> int:
        return check.integer("ring", ring, 0, len(self.radii))


@dataclass(frozen=True)
class PictureState:
    """Ring, morph and cross-fade of the picture that a frame shows."""

    ring: int = -1
    """Number of the shown ring; −1 for a blank picture."""
    radius: float = 0.0
    """Radius R of the morph, metres."""
    strength: float = 0.0
    """Strength of the morph, 0 to 1."""
    share: float = 0.0
    """Opacity of the next ring's picture during its cross-fade, 0 to 1."""


BLANK = PictureState()


def least_radius(axis_distance: float, fold_margin: float) -> float:
    """Return the smallest radius whose picture does not fold for a user at a distance in metres from the axis."""
    return _ROUNDING_FACTOR * min(axis_distance + SAFETY_METRES, fold_margin) / NEAR_SHARE


def grow(now: PictureState, seconds: float, radii: tuple[float, ...], rate: float, least: float) -> PictureState:
    """Return the state after some seconds: first the strength grows, then 1/R falls at a constant speed.

    `rate` is the picture's turn in radians per second for each metre of |U−O|; radii below `least` would fold.
    """
    if not 1 <= now.ring <= len(radii):
        return replace(now, radius=0.0, strength=0.0)
    goal = radii[now.ring - 1]
    strength = 0.0 if now.radius == 0.0 else now.strength
    first_radius = next((radius for radius in radii if radius >= least), math.inf)
    if strength == 0.0 and first_radius > goal:
        return replace(now, radius=goal, strength=0.0)
    radius = first_radius if strength == 0.0 else now.radius
    seconds_left = seconds
    if strength < 1.0:
        growth_seconds = 1.0 / (NEAR_SHARE * radius * rate)
        remaining = (1.0 - strength) * growth_seconds
        strength = 1.0 if seconds_left >= remaining else strength + seconds_left / growth_seconds
        seconds_left = max(0.0, seconds_left - remaining)
    if strength < 1.0 or radius >= goal:
        return replace(now, radius=min(radius, goal), strength=strength)
    inverse = 1.0 / radius - (1.0 - NEAR_SHARE) * rate * seconds_left
    return replace(now, radius=goal if inverse <= 1.0 / goal else 1.0 / inverse, strength=strength)


class PictureTimeline:
    """State of a region's picture over time, while rings arrive; the `radii` of portions by footprint are all equal."""

    def __init__(self, radii: tuple[float, ...], growth: Growth, *, is_smooth: bool, is_whole: bool) -> None:
        self._radii, self._growth, self._is_smooth = radii, growth, is_smooth
        self._first_shown = len(radii) if is_whole else 0
        self._arrived, self._fade_seconds, self._is_fading = -1, 0.0, False
        self._state = self._last_frame = BLANK

    def arrive(self, ring: int) -> None:
        """Record that a ring has arrived."""
        self._arrived = ring
        if not self._is_smooth or self._state.ring < 0:
            self._state = replace(self._state, ring=ring)

    def may_replace(self, ring: int) -> bool:
        """Return whether a ring's map may overwrite the map of the ring before the previous one."""
        return self._state.ring >= ring - 1 or self._arrived < 1

    def is_still(self, *, moves: bool) -> bool:
        """Return whether the picture stays the same until something arrives; `moves` tells whether the user moves."""
        now = self._state
        if now.ring < max(self._first_shown, 0):
            return True
        if now != self._last_frame or self._is_fading or self._arrived != now.ring:
            return False
        # A picture that would fold waits until the user is closer to the centre.
        is_waiting = now.strength == 0.0 and not moves
        return now.ring < 1 or (now.radius == self._goal and (now.strength == 1.0 or is_waiting))

    def advance(self, seconds: float, least: float) -> PictureState:
        """Advance by some seconds; radii below `least` would fold."""
        self._last_frame = self._next(seconds, least)
        return self._last_frame

    def _next(self, seconds: float, least: float) -> PictureState:
        if self._state.ring < max(self._first_shown, 0):
            return BLANK
        if self._is_smooth:
            growing_seconds = 0.0 if self._is_fading else seconds
            self._state = grow(self._state, growing_seconds, self._radii, self._growth._rate, least)
        else:
            self._state = self._next_at_once(least)
        if not self._is_fading:
            if self._arrived > self._state.ring:
                self._is_fading, self._fade_seconds = True, 0.0
            return self._state
        self._fade_seconds += seconds
        share = self._growth.share(self._fade_seconds)
        if share < 1.0:
            return replace(self._state, share=share)
        self._state = replace(self._state, ring=self._state.ring + 1)
        self._is_fading = False
        return self._state

    @property
    def _goal(self) -> float:
        """Radius of the shown ring."""
        return self._radii[self._state.ring - 1]

    def _next_at_once(self, least: float) -> PictureState:
        if not 1 <= self._state.ring <= len(self._radii):
            return replace(self._state, radius=0.0, strength=0.0)
        strength = 1.0 if self._state.strength == 1.0 or self._goal >= least else 0.0
        return replace(self._state, radius=self._goal, strength=strength)
