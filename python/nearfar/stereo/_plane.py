"""Chooses the mono plane for a maximum error or kink: once, or in each frame from the depths in view."""

from __future__ import annotations

import math

from nearfar._base import check
from nearfar.hmd._hmd import EYES, Hmd
from nearfar.stereo._geometry import AXES
from nearfar.stereo._rig import HybridRig

NEAREST, FARTHEST = 0.1, 1e5
"""Minimum and maximum distance of a chosen plane, metres."""
_HALVINGS = 80


def mono_plane_for(
    *,
    hmd: Hmd,
    error_px: float | None = None,
    kink_deg: float | None = None,
    size: tuple[int, int] | None = None,
    depth: float = math.inf,
    axis: str = "horizontal",
    slope: float = 1.0,
) -> float:
    """Return the smallest distance of the mono plane, metres, for a maximum error in pixels or kink in degrees.

    The result is never below 0.1 m. ValueError and TypeError for neither or both of
    `error_px` and `kink_deg`, values out of range, or an error that no plane within 100 km achieves.

    Parameters
    ----------
    hmd
        The headset.
    error_px
        Maximum error in pixels of points up to `depth` (`HybridRig.max_error`).
    kink_deg
        Instead of `error_px`: maximum angle in degrees, below 90, by which straight lines may bend at the plane.
    size
        Width and height of an eye's picture in pixels; `Hmd.render_size` by default.
    depth
        Greatest depth of the scene in metres, for `error_px`.
    axis
        "horizontal", "vertical" or "both", for `error_px`.
    slope
        For `kink_deg`: minimum slope of the lines considered, in metres sideways per metre of depth. Lines along the
        line of sight, with slope 0, may bend by any angle, at any plane.

    Notes
    -----
    Let m be the plane, z the depth, and e the maximum error in tangents; a, s and p are as in `HybridRig`, and E is the
    maximum of |a s − p| over both views. For eyes that are not rotated, E (z − m)/((z + s) m) = e gives
    m = z E/(E + e (z + s)), and a line bends by at most asin(E/((m + s) slope)).
    """
    check.instance("hmd", hmd, Hmd, "an Hmd")
    check.choice("axis", axis, AXES)
    depth_m = _check_depth(depth)
    min_slope = check.positive("slope", slope)
    if (error_px is None) == (kink_deg is None):
        raise ValueError("error_px: expected either error_px or kink_deg, got both or none")
    if error_px is not None:
        return _plane_for_error(hmd, size, check.positive("error_px", error_px), depth_m, axis)
    assert kink_deg is not None
    return _plane_for_kink(hmd, size, check.number("kink_deg", kink_deg), min_slope)


def _check_depth(depth: float) -> float:
    """Check a depth in metres above 0, which may be infinite."""
    metres = check.number("depth", depth, finite=False)
    if metres <= 0.0:
        raise ValueError(f"depth: expected a distance above 0 metres, got {metres:g}")
    return metres


def _plane_for_kink(hmd: Hmd, size: tuple[int, int] | None, bend: float, slope: float) -> float:
    if not 0.0 < bend < 90.0:
        raise ValueError(f"kink_deg: expected an angle between 0 and 90 degrees, got {bend:g}")
    rig = HybridRig.of(hmd, mono_plane=1.0, size=size)
    # For m = 1 and infinitely far points the error in tangents is E.
    max_error = max(math.dist(rig.shown(eye, tangents), tangents) for eye in EYES for tangents in _corners(rig, eye))
    return max(max_error / (slope * math.sin(math.radians(bend))) - rig.center_offset, NEAREST)


def _plane_for_error(hmd: Hmd, size: tuple[int, int] | None, error: float, depth: float, axis: str) -> float:
    rig = HybridRig.of(hmd, mono_plane=FARTHEST, size=size)
    if rig.max_error(depth, axis) > error:
        raise ValueError(f"error_px: no mono plane within {FARTHEST:g} m has an error of at most {error:g} pixels")
    low, high = NEAREST, FARTHEST
    if rig.with_plane(low).max_error(depth, axis) <= error:
        return low
    # The error decreases with the plane's distance.
    for _ in range(_HALVINGS):
        middle = math.sqrt(low * high)
        if not low < middle < high:
            break
        if rig.with_plane(middle).max_error(depth, axis) <= error:
            high = middle
        else:
            low = middle
    return high


def _corners(rig: HybridRig, eye: str) -> list[tuple[float, float]]:
    fov = getattr(rig, eye).fov
    return [(x, y) for x in (fov.left, fov.right) for y in (fov.down, fov.up)]


class AdaptivePlane:
    """Moves the mono plane to the smallest distance with a small enough error at the depths in view.

    ValueError and TypeError for values out of range.

    Parameters
    ----------
    hmd
        The headset.
    error_px
        Maximum horizontal error in pixels.
    nearest
        Minimum distance of the plane, 0.1 to 100,000 metres.
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
        # The plane m∞ for an infinite depth, from which `wanted` computes those for other depths.
        self._plane_for_infinity = mono_plane_for(hmd=hmd, error_px=error_px, size=size)
        self._rig = HybridRig.of(hmd, mono_plane=max(self._plane_for_infinity, self._nearest), size=size)

    @property
    def rig(self) -> HybridRig:
        """The rig with the present plane; at first the plane for an infinite depth."""
        return self._rig

    def wanted(self, depth: float) -> float:
        """Return the smallest distance of the plane in metres for points up to a depth in metres from the eyes."""
        depth_m, s = _check_depth(depth), self._rig.center_offset
        if math.isinf(depth_m):
            return max(self._plane_for_infinity, self._nearest)
        # m = z m∞/(m∞ + z + s): the equation in `mono_plane_for` with E = e m∞; z is `depth_m`.
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
