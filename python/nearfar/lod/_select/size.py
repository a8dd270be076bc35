"""Sizes: the largest size at which levels are measured, and the effect of lens and eye on apparent sizes."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Any, SupportsFloat

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar._camera.camera import Camera, Fov
from nearfar._lens.lens import RadialLens, check_symmetric
from nearfar.hmd._hmd import GENERIC_LENS, Hmd

ACUITY_SLOPE = 0.0275
"""Degrees by which the least visible angle grows per degree from the gaze (Guenter et al. 2012)."""
ACUITY_LIMIT_DEG = 1 / 48
"""The least visible angle at the gaze, degrees (Guenter et al. 2012)."""


def reference_solid_angle(view: Hmd | Camera | Fov) -> float:
    """Solid angle of a sphere that covers 1/16 of the screen, steradians: the largest size for measurements.

    σ₁/₁₆ = 2π (1 − cos asin(¼ tan ω)), with ω half the horizontal field of view: `lens_radius` of a headset, or its
    `tan_half_angle` if it has none; the larger of left and right of a camera with a `Fov`, or of a `Fov`. ValueError
    for a view whose tangent is 4 or more: no sphere covers 1/16 of it; TypeError for a value of another type. Source:
    Liebisch (2021), Sec. 3.3.1, Eq. 3.2.
    """
    sine = half_tangent(view) / 4
    if sine >= 1:
        raise ValueError(f"view: expected a tangent to the side below 4, got {4 * sine:g}")
    return sphere_solid_angle(sine)


def sphere_solid_angle(sine: float) -> float:
    """Solid angle of a sphere, steradians, by the sine of its half angle."""
    # 1 − cos as sin² / (1 + cos), which loses no digits.
    return 2 * math.pi * sine * sine / (1 + math.sqrt((1 - sine) * (1 + sine)))


def pixel_area(sides: Sequence[float], size: tuple[int, int]) -> float:
    """Area of a pixel in squared tangents, for a view with sides (left, right, down, up) and its pixels."""
    left, right, down, up = sides
    return (right - left) / size[0] * ((up - down) / size[1])


def acuity(
    eccentricity_deg: ArrayLike,
    *,
    slope: SupportsFloat = ACUITY_SLOPE,
    limit_deg: SupportsFloat = ACUITY_LIMIT_DEG,
    pixel_deg: SupportsFloat = 0.0,
) -> NDArray[np.float64]:
    """Linear factor by which objects look smaller to the eye away from its gaze.

    The least visible angle grows as ω(e) = m e + ω₀, and a picture at e = 0 need not be finer than ω* = max(ω₀, pixel):
    objects at e look like objects of ω*/ω(e) times their size. Returns float64 in the shape of the eccentricities, 0 to
    1. Its square applies to solid angles. ValueError and TypeError for numbers out of range. Source: Guenter, Finch,
    Drucker, Tan, Snyder (2012), Eq. 1.

    Parameters
    ----------
    eccentricity_deg
        Degrees from the gaze, of any shape; at least 0.
    slope
        m, degrees per degree: 0.022 is conservative, 0.034 less so.
    limit_deg
        ω₀, degrees.
    pixel_deg
        Degrees spanned by a pixel on the axis; 0 for screens finer than the eye.
    """
    eccentricity = _eccentricities(eccentricity_deg)
    rise, pixel = check.at_least_zero("slope", slope), check.at_least_zero("pixel_deg", pixel_deg)
    least = check.positive("limit_deg", limit_deg)
    with np.errstate(over="ignore"):
        return np.asarray(np.minimum(1.0, max(least, pixel) / (rise * eccentricity + least)))


def distortion(
    eccentricity_deg: ArrayLike, *, lens: RadialLens, view: Hmd | Camera | Fov, lens_radius: float | None = None
) -> NDArray[np.float64]:
    """Factor σ′/σ by which a lens changes a small object's solid angle, as in `select` with `size="axis"`.

    Returns float64 in the shape of the eccentricities: dα′/dα of α′ = atan(tan ω · f⁻¹(tan α / tan ω)). 1 from 90° on
    and beyond the lens's domain. ValueError and TypeError for invalid numbers or lenses. Source: Liebisch (2021),
    Eq. 4.10–4.12, where the half angle goes to 0.

    Parameters
    ----------
    eccentricity_deg
        Degrees from the lens's axis, of any shape; at least 0.
    lens
        A lens without tangential terms.
    view
        A headset, a camera or a `Fov`, as in `reference_solid_angle`.
    lens_radius
        The tangent at which r = 1; by default the view's.
    """
    tangent = _tangents(eccentricity_deg)
    scale = checked_lens(lens, view, lens_radius)
    r, slope = _radius_and_slope(lens, tangent, scale)
    factor = (1 + tangent**2) / (1 + (scale * r) ** 2) / slope
    return np.asarray(np.where(np.isfinite(factor), factor, 1.0))


def panel_magnification(
    eccentricity_deg: ArrayLike, *, lens: RadialLens | None, view: Hmd | Camera | Fov, lens_radius: float | None = None
) -> NDArray[np.float64]:
    """Number of panel pixels that a small object covers, divided by the number that it covers on the axis.

    ValueError and TypeError for invalid numbers or lenses. Source: Liebisch (2021), Eq. 4.10, for r and f; D is the
    ratio of areas that follows from it.

    Parameters
    ----------
    eccentricity_deg, view, lens_radius
        As in `distortion`.
    lens
        A lens without tangential terms; None for a screen seen without a lens.

    Returns
    -------
    NDArray
        float64 in the shape of the eccentricities: D(α) = (r′/r) (1/f′(r′)) / cos³ α with r = tan α / tan ω and
        r′ = f⁻¹(r); without a lens 1 / cos³ α: perspective stretches, the lens shrinks. ∞ from 90° and from the lens's
        fold on.
    """
    tangent = _tangents(eccentricity_deg)
    spread = (1 + tangent**2) ** 1.5
    if lens is None:
        fov_of(view)  # rejects anything but a view
        return np.asarray(spread)
    r, slope = _radius_and_slope(lens, tangent, checked_lens(lens, view, lens_radius))
    shrinks = np.polynomial.polynomial.polyval(np.nan_to_num(r) ** 2, (1.0, *lens.k))
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(np.where(np.isfinite(r), spread / (shrinks * slope), np.inf))


def _eccentricities(value: ArrayLike) -> NDArray[np.float64]:
    """Check angles from the axis or the gaze, degrees of any shape."""
    eccentricity = check.array("eccentricity_deg", value, columns=None, dtype=np.float64)
    if not (eccentricity >= 0).all():
        raise ValueError(f"eccentricity_deg: expected numbers of at least 0, got {eccentricity.min()}")
    return eccentricity


def _tangents(eccentricity_deg: ArrayLike) -> NDArray[np.float64]:
    """Tangents of angles from the axis; ∞ from 90° on."""
    eccentricity = _eccentricities(eccentricity_deg)
    return np.where(eccentricity < 90, np.tan(np.radians(np.minimum(eccentricity, 89.999999999))), np.inf)


def _radius_and_slope(
    lens: RadialLens, tangent: NDArray[np.float64], scale: float
) -> tuple[NDArray[Any], NDArray[Any]]:
    """Panel radii that a lens shows at tangents, NaN beyond its domain, and the lens's slope at these radii."""
    with np.errstate(over="ignore"):
        r = lens.undistort(tangent / scale, outside="nan")
    return r, lens.derivative(np.nan_to_num(r), outside="nan")


def half_tangent(view: Hmd | Camera | Fov) -> float:
    """Tangent of half the horizontal field of view; the larger side of an asymmetric one.

    For a headset it is the radius of its lens, if that is known: beyond it, the screen is not seen through the lens.
    """
    fov = fov_of(view)
    if not isinstance(view, Hmd):
        return max(abs(fov.left), abs(fov.right))
    return view.tan_half_angle if view.lens_radius is None or view.lens == GENERIC_LENS else view.lens_radius


def fov_of(view: Hmd | Camera | Fov) -> Fov:
    """Return the field of view, a headset's of its left eye; TypeError for anything but a view."""
    fov = view.left.fov if isinstance(view, Hmd) else view.fov if isinstance(view, Camera) else view
    if not isinstance(fov, Fov):
        raise TypeError(f"view: expected a headset, a camera with a Fov, or a Fov, got {type(view).__name__}")
    return fov


def checked_lens(lens: RadialLens, view: Hmd | Camera | Fov, lens_radius: SupportsFloat | None) -> float:
    """Check that sizes are defined for a lens; return tan ω."""
    check_symmetric(lens)
    return half_tangent(view) if lens_radius is None else check.positive("lens_radius", lens_radius)


def widest(views: Iterable[Camera]) -> Camera:
    """Return the view with the greatest tangent to a side, since a headset's eyes share a reference and a lens."""
    return max(views, key=half_tangent)
