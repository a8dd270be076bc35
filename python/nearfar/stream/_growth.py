"""Growth of rings: a client's morph changes continuously over time after a ring has arrived."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from nearfar._base import check
from nearfar.stream._assign import ascending
from nearfar.stream._manifest import NEAR_SHARE


@dataclass(frozen=True)
class Growth:
    """Speed at which the morph grows after a ring has arrived. Times are seconds since its arrival.

    First the picture is cross-faded from that of the previous ring, then the morph grows. A point at ρ between the
    radii has the weight w = (R − ρ) / ((1 − n) R), n = 0.7. While R grows, its direction turns by (|U−O| / ρ) dw/dt =
    |U−O| Ṙ / ((1 − n) R²), the same for all ρ. So at constant speed 1/R falls linearly. Ring 1 has no radius to start
    from: small radii fold for a user beside the centre. It is shown at its own radius while the strength grows
    linearly, which turns a point at ρ by |U−O| / (ρ T) in a growth of T seconds.

    Raises
    ------
    ValueError, TypeError
        For radii that are not positive and ascending, a `speed` or `reach` of 0 or less, and a `fade` below 0.

    References
    ----------
    CloVR (2024) lets R grow over a second. Constant speed and growth of ring 1 by strength are our additions.
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
        object.__setattr__(self, "radii", ascending("radii", self.radii))
        for name in ("speed", "reach"):
            object.__setattr__(self, name, check.positive(name, getattr(self, name)))
        object.__setattr__(self, "fade", check.at_least_zero("fade", self.fade))

    def seconds(self, ring: int) -> float:
        """Return the duration of a ring's cross-fade and growth; 0 for ring 0, which has neither."""
        number = self._ring(ring)
        return self.fade + self._turn(number) / self._rate if number else 0.0

    def share(self, time: float) -> float:
        """Return the share of the newer picture in the cross-fade, 0 to 1, at a time since a ring's arrival."""
        elapsed = check.at_least_zero("time", time)
        return min(elapsed / self.fade, 1.0) if self.fade else 1.0

    def radius(self, ring: int, time: float) -> float:
        """Return the morph's radius in metres at a time since a ring's arrival; 0 for ring 0."""
        number, grown = self._ring(ring), self._grown(time)
        if number < 2:
            return self._radius(number)
        before, full = self._radius(number - 1), self._radius(number)
        inverse = 1.0 / before - (1.0 - NEAR_SHARE) * grown
        return full if inverse <= 1.0 / full else 1.0 / inverse

    def strength(self, ring: int, time: float) -> float:
        """Return the morph's strength, 0 to 1, at a time since a ring's arrival; 1 for all rings but the first."""
        number, grown = self._ring(ring), self._grown(time)
        return min(grown / self._turn(1), 1.0) if number == 1 else 1.0

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

    def _turn(self, ring: int) -> float:
        """Return the radians by which the growth of a ring turns the picture, per metre of |U−O|."""
        radius = self._radius(ring)
        if ring == 1:
            return 1.0 / (NEAR_SHARE * radius)
        return (1.0 / self._radius(ring - 1) - 1.0 / radius) / (1.0 - NEAR_SHARE)

    def _grown(self, time: float) -> float:
        """Return the picture's turn at a time in radians per metre of |U−O|; not limited to the growth's end."""
        return max(check.at_least_zero("time", time) - self.fade, 0.0) * self._rate

    def _radius(self, ring: int) -> float:
        return (0.0, *self.radii)[ring]

    def _ring(self, ring: int) -> int:
        return check.integer("ring", ring, 0, len(self.radii))
