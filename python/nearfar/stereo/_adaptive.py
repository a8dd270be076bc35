"""The `AdaptivePlane` class: a mono plane that follows the depths in view."""

from __future__ import annotations

import math

from nearfar._base import check
from nearfar.hmd._hmd import Hmd
from nearfar.stereo._plane import FARTHEST, NEAREST, mono_plane_for
from nearfar.stereo._rig import HybridRig


class AdaptivePlane:
    """Moves the mono plane to the least distance with a small enough error at the depths in view.

    ValueError and TypeError for values out of range.

    Parameters
    ----------
    hmd
        The headset.
    error_px
        Maximum horizontal error in pixels.
    nearest
        Least distance of the plane, 0.1 to 100,000 metres.
    size
        Width and height of an eye's picture in pixels; `Hmd.render_size` by default.
    hysteresis
        Share by which the plane may be farther than necessary before it is moved nearer.
    rate
        Maximum change of the plane's distance per second, as the natural logarithm of a ratio: 1 allows a factor of 2.7
        per second.
    """

    def __init__(
        self,
        hmd: Hmd,
        *,
        error_px: float = 1.0,
        nearest: float = 0.5,
        size: tuple[int, int] | None = None,
        hysteresis: float = 0.1,
        rate: float = 1.0,
    ) -> None:
        self._hmd, self._size = check.instance("hmd", hmd, Hmd, "an Hmd"), size
        self._error = check.positive("error_px", error_px)
        self._nearest = check.in_range("nearest", nearest, NEAREST, FARTHEST)
        self._hysteresis, self._rate = check.at_least_zero("hysteresis", hysteresis), check.positive("rate", rate)
        # For an infinite depth, the plane of the closed form: e = E/m.
        self._plane_for_infinity = mono_plane_for(hmd=hmd, error_px=error_px, size=size)
        self._rig = HybridRig.of(hmd, mono_plane=max(self._plane_for_infinity, self._nearest), size=size)

    @property
    def rig(self) -> HybridRig:
        """The rig with the present plane; at first the plane for an infinite depth."""
        return self._rig

    def wanted(self, depth: float) -> float:
        """Return the least distance of the plane in metres for points up to a depth in metres from the eyes."""
        depth_m, s = check.number("depth", depth, finite=False), self._rig.center_offset
        if depth_m <= 0.0:
            raise ValueError(f"depth: expected a distance above 0 metres, got {depth_m:g}")
        if math.isinf(depth_m):
            return max(self._plane_for_infinity, self._nearest)
        # (z − m) E/((z + s) m) = e with E = e m∞, m∞ being the plane for an infinite depth.
        return max(depth_m * self._plane_for_infinity / (self._plane_for_infinity + depth_m + s), self._nearest)

    def update(self, depth: float, seconds: float) -> HybridRig:
        """Move the plane for the greatest depth in view, metres, within a time in seconds; return the rig."""
        wanted, present = self.wanted(depth), self._rig.planes[0]
        step = self._rate * check.at_least_zero("seconds", seconds)
        if wanted > present or present > wanted * (1.0 + self._hysteresis):
            change = min(max(math.log(wanted / present), -step), step)
            if change != 0.0:
                self._rig = self._rig.with_plane(present * math.exp(change))
        return self._rig
