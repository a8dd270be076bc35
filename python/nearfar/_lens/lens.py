"""Radial lens models: distortion and its inverse, warping of pictures, and solid angles seen through a lens."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._base.pickling import WithTwin
from nearfar._base.settings import set_fields
from nearfar._camera.camera import Camera, Fov
from nearfar._lens.warp import Warping, radius_of

Method = Literal["newton", "fixed_point", "lut"]
Outside = Literal["raise", "nan"]


@dataclass(frozen=True)
class RadialLens(WithTwin, Warping):
    """A lens that shows radius r at f(r) = r (1 + k₁r² + k₂r⁴ + …).

    Radii are ratios of tangents: r = tan α / tan ω, where α is the angle from the lens's axis and ω half the horizontal
    field of view (the larger half of an asymmetric one), so that r = 1 at the screen's edge. ValueError and TypeError
    for coefficients that are not finite numbers, or whose terms become as large as r before r = 10⁻³⁰ or only after
    r = 10³⁰. Sources: Liebisch (2021), Eq. 4.10 and Alg. 1; Brown (1966) for the tangential terms.

    Parameters
    ----------
    k
        Coefficients k₁, k₂, …, 0 to 64 of them; without any the lens changes nothing.
    tangential
        Coefficients p₁ and p₂ of Brown's model, for lenses that are slightly off-centre. They affect functions of
        points, but not functions of radii.
    """

    k: Sequence[float]
    tangential: Sequence[float] = (0.0, 0.0)

    def __post_init__(self) -> None:
        k, tangential = _coefficients("k", self.k), _coefficients("tangential", self.tangential)
        if len(tangential) != 2:
            raise ValueError(f"tangential: expected two numbers, got {len(tangential)}")
        set_fields(self, k=k, tangential=tangential)
        _ = self._core

    @property
    def r_max(self) -> float:
        """End of the domain of f: the radius at which the lens folds (f′ = 0); inf for lenses that never fold."""
        return self._core.r_max

    @property
    def distorted_max(self) -> float:
        """End of the domain of `undistort`, f(`r_max`); 10²⁹⁰ for lenses that never fold, whatever f is there."""
        return self._core.x_max

    @property
    def point_r_max(self) -> float:
        """Radius of the disc in which `distort_points` is proven to map different points to different points.

        Without tangential terms it is `r_max`; with them it is smaller.
        """
        return self._core.reach

    @property
    def lut_bound(self) -> float:
        """Bound of the relative error of `undistort` with "lut" for radii of at least 10⁻²⁷⁰; at most 5e-10.

        Smaller floats have fewer digits. Where no table satisfies the bound, "lut" uses Newton's method: near a fold,
        and beyond 16 times the radius at which the first term is as large as r.
        """
        return self._core.table_bound()[0]

    def distort(self, r: ArrayLike, *, outside: Outside = "raise") -> NDArray[Any]:
        """Compute the radii f(r) at which the lens shows radii r of any shape and sign (f is odd).

        float32 and float64 are kept. f(r) is rounded once, with an error of at most one unit in the last place. For
        radii beyond `r_max` and NaN, `outside` "raise" is a ValueError, "nan" gives NaN.
        """
        values = check.array("r", r, columns=None)
        return self._core.distort(values.reshape(-1), _raises_outside(outside)).reshape(values.shape)

    def derivative(self, r: ArrayLike, *, outside: Outside = "raise") -> NDArray[Any]:
        """Compute f′(r), which is 1 on the axis and 0 at `r_max`; arguments and errors as in `distort`."""
        values = check.array("r", r, columns=None)
        return self._core.derivative(values.reshape(-1), _raises_outside(outside)).reshape(values.shape)

    def undistort(
        self, r: ArrayLike, *, method: Method = "newton", iterations: int = 5, outside: Outside = "raise"
    ) -> NDArray[Any]:
        """Compute the radii that the lens shows at radii `r`: the inverse of `distort`.

        Returns radii up to `r_max`, in the type of `r`. ValueError for radii beyond `distorted_max` and NaN, unless
        `outside` is "nan".

        Parameters
        ----------
        r
            Distorted radii of any shape and sign. float32 and float64 are kept; everything is computed in float64.
        method
            "newton": f(result) differs from `r` by at most 2 units in the last place, or the result from the true root
            by at most one. "lut": interpolation by cubics, with a relative error of at most `lut_bound`.
            "fixed_point": the published iteration r ← r_d / (1 + k₁r² + …), where r_d is the distorted radius. For
            strong lenses it converges slowly or not at all, without an error.
        iterations
            Number of iterations of "fixed_point", 0 to 1000.
        outside
            "raise": a radius beyond `distorted_max` is an error. "nan": its result is NaN. "fixed_point" does not check
            this.
        """
        check.choice("method", method, get_args(Method))
        steps = check.integer("iterations", iterations, 0, 1000)
        values = check.array("r", r, columns=None)
        return self._core.undistort(values.reshape(-1), method, steps, _raises_outside(outside)).reshape(values.shape)

    def distort_points(self, points: ArrayLike, *, outside: Outside = "raise") -> NDArray[Any]:
        """Compute the positions (N, 2) at which the lens, with its tangential terms, shows points (N, 2).

        x is to the right and y up from the axis, in units of the lens (r = 1 at the screen's edge), in the type of
        `points`. For points beyond `point_r_max`, `outside` "raise" is a ValueError, "nan" gives NaN.
        """
        return self._core.distort_points(check.array("points", points, columns=2), _raises_outside(outside))

    def undistort_points(self, points: ArrayLike, *, outside: Outside = "raise") -> NDArray[Any]:
        """Compute the points that the lens shows at positions: the inverse of `distort_points`, same arguments."""
        return self._core.undistort_points(check.array("points", points, columns=2), _raises_outside(outside))

    @property
    def _cores(self) -> list[_core.RadialLens]:
        return [self._core]

    @cached_property
    def _core(self) -> _core.RadialLens:
        return _core.RadialLens(list(self.k), (self.tangential[0], self.tangential[1]))


@dataclass(frozen=True)
class ChromaticLens(Warping):
    """A lens with chromatic aberration: one `RadialLens` for each of red, green and blue."""

    red: RadialLens
    green: RadialLens
    blue: RadialLens

    def __post_init__(self) -> None:
        for name in ("red", "green", "blue"):
            check.instance(name, getattr(self, name), RadialLens)

    @property
    def _cores(self) -> list[_core.RadialLens]:
        return [self.red._core, self.green._core, self.blue._core]


def corrected_solid_angle(
    centers: ArrayLike,
    radii: ArrayLike,
    *,
    camera: Camera,
    lens: RadialLens,
    lens_radius: float | None = None,
    exact: bool = False,
) -> NDArray[np.float64]:
    """Compute the solid angles that spheres occupy in an inversely warped picture.

    Let σ be a sphere's solid angle, μ its angular radius, and α the angle of its centre from the axis. Then
    α± = atan(tan ω · f⁻¹(tan(α ± μ) / tan ω)) and the corrected solid angle is σ′ = σ (α⁺ − α⁻) / 2μ. f and ω are
    those of `RadialLens`. ValueError and TypeError for wrong shapes, numbers that are not finite, radii below 0, and
    cameras without a `Fov`. Source: Liebisch (2021), Eq. 4.10–4.12.

    Parameters
    ----------
    centers
        Centres (N, 3), metres.
    radii
        Radii (N,), or one for all spheres, metres, at least 0.
    camera
        The eye, with a `Fov`: the lens's axis is its viewing axis.
    lens
        A lens without tangential terms.
    lens_radius
        tan ω, the tangent at which r = 1, such as `Hmd.tan_half_angle`. By default the larger of left and right.
    exact
        False computes the published σ′, which shrinks along the radius only. True computes the shown area, which
        shrinks around the axis as well.

    Returns
    -------
    NDArray
        (N,) float64, steradians, with a relative error of at most 10⁻¹². For small spheres just before 90° or the fold,
        the relative error of `exact` is at most 10⁻¹⁵ divided by the sine of μ. Spheres that reach 90° from the axis,
        or beyond the lens's domain, keep their solid angle σ; it is 4π if the eye is inside.
    """
    fov = check.instance("camera", check.instance("camera", camera, Camera).fov, Fov, "a camera with a Fov")
    check_symmetric(lens)
    x, y, z, w = camera.orientation
    return _core.corrected_solid_angles(
        lens._core,
        *check.spheres(centers, radii),
        eye=camera.position,
        # The viewing axis: −z rotated by the quaternion.
        forward=(-2 * (x * z + w * y), -2 * (y * z - w * x), 2 * (x * x + y * y) - 1),
        tan_omega=radius_of(fov, lens_radius),
        exact=check.flag("exact", exact),
    )


def check_symmetric(lens: RadialLens) -> None:
    """Raise TypeError for anything but a lens, and ValueError for a lens with tangential terms."""
    if any(check.instance("lens", lens, RadialLens).tangential):
        raise ValueError(f"lens: expected a lens without tangential terms, got {lens.tangential}")


def _coefficients(name: str, value: ArrayLike) -> tuple[float, ...]:
    coefficients = check.array(name, value, columns=None, dtype=np.float64, finite=True)
    if coefficients.ndim != 1:
        raise ValueError(f"{name}: expected a sequence of numbers, got shape {coefficients.shape}")
    return tuple(float(c) for c in coefficients)


def _raises_outside(outside: Outside) -> bool:
    check.choice("outside", outside, get_args(Outside))
    return outside == "raise"
