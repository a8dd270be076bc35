"""Picture that the page shows over time; a port of `web/src/show/stage.ts`."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from nearfar.stream._growth import Growth
from nearfar.stream._manifest import NEAR_SHARE

SAFETY_METRES = 0.5
"""Safety margin: a chosen radius folds only for users at least this much farther from the axis."""
_ROUNDING_FACTOR = 1.0 - 1e-9
"""Factor that keeps the last radius large enough despite rounding of its product with the near share."""


@dataclass(frozen=True)
class Shown:
    """State that a frame shows."""

    ring: int = -1
    """Number of the shown ring; −1 for a blank picture."""
    radius: float = 0.0
    """Radius R of the morph, metres."""
    strength: float = 0.0
    """Strength of the morph, 0 to 1."""
    share: float = 0.0
    """Opacity of the next ring's picture during its cross-fade, 0 to 1."""


BLANK = Shown()


def least_radius(axis_distance: float, fold_margin: float) -> float:
    """Return the least radius whose picture does not fold for a user at a distance in metres from the axis."""
    return _ROUNDING_FACTOR * min(axis_distance + SAFETY_METRES, fold_margin) / NEAR_SHARE


def grow(now: Shown, seconds: float, radii: tuple[float, ...], rate: float, least: float) -> Shown:
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


class Stage:
    """Picture of a region while its rings arrive, whose radii may be those of portions: equal ones."""

    def __init__(self, radii: tuple[float, ...], growth: Growth, *, is_smooth: bool, is_whole: bool) -> None:
        self._radii, self._growth, self._is_smooth = radii, growth, is_smooth
        self._first = len(radii) if is_whole else 0
        self._arrived, self._fade_seconds, self._is_fading = -1, 0.0, False
        self._now = self._last = BLANK

    def arrive(self, ring: int) -> None:
        """Record that a ring has arrived."""
        self._arrived = ring
        if not self._is_smooth or self._now.ring < 0:
            self._now = replace(self._now, ring=ring)

    def may_replace(self, ring: int) -> bool:
        """Return whether a ring's map may overwrite the map of the ring before the previous one."""
        return self._now.ring >= ring - 1 or self._arrived < 1

    def is_still(self, *, moves: bool) -> bool:
        """Return whether the picture stays the same until something arrives; `moves` tells whether the user moves."""
        now = self._now
        if now.ring < max(self._first, 0):
            return True
        if now != self._last or self._is_fading or self._arrived != now.ring:
            return False
        # A picture that would fold waits until the user is closer to the centre.
        return now.ring < 1 or (
            now.radius == self._goal and (now.strength == 1.0 or (now.strength == 0.0 and not moves))
        )

    def advance(self, seconds: float, least: float) -> Shown:
        """Advance by some seconds; radii below `least` would fold."""
        self._last = self._next(seconds, least)
        return self._last

    def _next(self, seconds: float, least: float) -> Shown:
        if self._now.ring < max(self._first, 0):
            return BLANK
        if self._is_smooth:
            growing_seconds = 0.0 if self._is_fading else seconds
            self._now = grow(self._now, growing_seconds, self._radii, self._growth._rate, least)
        else:
            self._now = self._next_at_once(least)
        if not self._is_fading:
            if self._arrived > self._now.ring:
                self._is_fading, self._fade_seconds = True, 0.0
            return self._now
        self._fade_seconds += seconds
        share = self._growth.share(self._fade_seconds)
        if share < 1.0:
            return replace(self._now, share=share)
        self._now = replace(self._now, ring=self._now.ring + 1)
        self._is_fading = False
        return self._now

    @property
    def _goal(self) -> float:
        """Radius of the shown ring."""
        return self._radii[self._now.ring - 1]

    def _next_at_once(self, least: float) -> Shown:
        if not 1 <= self._now.ring <= len(self._radii):
            return replace(self._now, radius=0.0, strength=0.0)
        strength = 1.0 if self._now.strength == 1.0 or self._goal >= least else 0.0
        return replace(self._now, radius=self._goal, strength=strength)
