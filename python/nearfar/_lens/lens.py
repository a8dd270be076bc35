"""Lenses of headsets: what they show where, pictures through them, and how large things look."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._base.pickling import WithTwin
from nearfar._camera.camera import Camera, Fov
from nearfar._lens.warp import WarpMesh, radius_of, warp, warp_mesh

METHODS = ("newton", "fixed_point", "lut")

OUTSIDE = ("raise", "nan")


@dataclass(frozen=True)
class RadialLens(WithTwin):
    """A lens that shows radius r at f(r) = r (1 + k₁r² + k₂r⁴ + …).

    Radii are tangents: r = tan α / tan ω with α the angle from the lens's axis and ω half the horizontal field of view
    (the larger side of an asymmetric one), so that r = 1 at the screen's edge.

    Parameters
    ----------
    k
        k₁, k₂, …: any number of coefficients up to 64; none is a lens that changes nothing.
    tangential
        p₁ and p₂ of Brown's model, for lenses that are not quite centred. They move points, not radii.

    Raises
    ------
    ValueError, TypeError
        For coefficients that are not finite numbers, and for those whose terms are as large as r already at 10⁻³⁰ or
        not before 10³⁰.

    References
    ----------
    Liebisch (2021), Eq. 4.10 and Alg. 1; Brown (1966) for the tangential terms.
    """

    k: Sequence[float]
    tangential: Sequence[float] = (0.0, 0.0)

    def __post_init__(self) -> None:
        object.__setattr__(self, "k", _coefficients("k", self.k))
        pair = _coefficients("tangential", self.tangential)
        if len(pair) != 2:
            raise ValueError(f"tangential: expected two numbers, got {len(pair)}")
        object.__setattr__(self, "tangential", pair)
        _ = self._core

    @property
    def r_max(self) -> float:
        """Radius at which the lens folds, f′ = 0, and the domain of f ends; inf for lenses that never fold."""
        return self._core.r_max

    @property
    def distorted_max(self) -> float:
        """f(`r_max`), where the domain of `undistort` ends; 10²⁹⁰ for lenses that never fold, whatever overflows."""
        return self._core.x_max

    @property
    def point_r_max(self) -> float:
        """Radius of the disc in which `distort_points` is known to map no two points to one.

        It is `r_max` without tangential terms, and less with them.
        """
        return self._core.reach

    @property
    def lut_bound(self) -> float:
        """Greatest error of `undistort` with "lut", as a share of the result: a bound that holds for every radius.

        (Of at least 10⁻²⁷⁰: the smallest floats have fewer digits.) It is at most 5e-10. Where no table holds that,
        beside a fold and beyond 16 times the radius at which the first term is as large as r, "lut" is Newton's method.
        """
        return self._core.table_bound()[0]

    def distort(self, r: ArrayLike, *, outside: str = "raise") -> NDArray[Any]:
        """Radii at which the lens shows radii.

        Parameters
        ----------
        r
            Numbers of any shape and sign (f is odd). float32 and float64 are kept.
        outside
            "raise": a radius beyond `r_max` is an error. "nan": its result is NaN.

        Returns
        -------
        NDArray
            f(r), rounded once: within one unit in the last place.

        Raises
        ------
        ValueError
            For radii beyond `r_max` and for NaN, unless `outside` is "nan".
        """
        values = check.array("r", r, columns=None)
        return self._core.distort(values.reshape(-1), _refuse(outside)).reshape(values.shape)

    def derivative(self, r: ArrayLike, *, outside: str = "raise") -> NDArray[Any]:
        """f′ at radii; arguments and errors as in `distort`. It is 1 on the axis and 0 at `r_max`."""
        values = check.array("r", r, columns=None)
        return self._core.derivative(values.reshape(-1), _refuse(outside)).reshape(values.shape)

    def undistort(
        self, r: ArrayLike, *, method: str = "newton", iterations: int = 5, outside: str = "raise"
    ) -> NDArray[Any]:
        """Radii that the lens shows at radii: the inverse of `distort`.

        Parameters
        ----------
        r
            Numbers of any shape and sign. float32 and float64 are kept; everything is computed in float64.
        method
            "newton": f(result) is within 2 units in the last place of r, or the result within one of the true root.
            "lut": cubics between nodes, off by at most `lut_bound` of the result. "fixed_point": as published,
            r ← r_d / (1 + k₁r² + …), so many `iterations`. It converges slowly or not at all where the lens is strong,
            and says nothing about it.
        iterations
            Of "fixed_point".
        outside
            "raise": a radius beyond `distorted_max` is an error. "nan": its result is NaN. "fixed_point" knows no
            domain.

        Returns
        -------
        NDArray
            Radii up to `r_max`, in the type of `r`.

        Raises
        ------
        ValueError
            For radii that the lens shows nothing at and for NaN, unless `outside` is "nan".
        """
        check.choice("method", method, METHODS)
        steps = check.integer("iterations", iterations, 0, 1000)
        values = check.array("r", r, columns=None)
        return self._core.undistort(values.reshape(-1), method, steps, _refuse(outside)).reshape(values.shape)

    def distort_points(self, points: ArrayLike, *, outside: str = "raise") -> NDArray[Any]:
        """Where the lens shows points, with its tangential terms.

        Parameters
        ----------
        points
            (N, 2), x to the right and y up from the axis, in units of the lens (r = 1 at the screen's edge).
        outside
            What becomes of points beyond `point_r_max`: "raise" or "nan".

        Returns
        -------
        NDArray
            (N, 2) in the type of `points`.
        """
        return self._core.distort_points(check.array("points", points, columns=2), _refuse(outside))

    def undistort_points(self, points: ArrayLike, *, outside: str = "raise") -> NDArray[Any]:
        """Points that the lens shows at points, the inverse of `distort_points`; arguments and results as there."""
        return self._core.undistort_points(check.array("points", points, columns=2), _refuse(outside))

    def warp(
        self,
        image: ArrayLike,
        inverse: bool = False,
        *,
        fov: Fov | None = None,
        output_fov: Fov | None = None,
        lens_radius: float | None = None,
        size: tuple[int, int] | None = None,
        filter: str = "linear",  # noqa: A002
        fill: float = 0.0,
    ) -> NDArray[Any]:
        """Show a picture as the lens does, or warp it so that the lens puts it right.

        Parameters
        ----------
        image
            (H, W) or (H, W, C): uint8, uint16, float32 or float64, in the colour space in which it should be mixed.
        inverse
            False: what is at r is shown at f(r). True: what is at f(r) is shown at r, which the lens then moves back.
        fov
            What the picture shows, as tangents from the lens's axis. By default the axis is in the middle, pixels are
            square, and r = 1 at the left and right edges.
        output_fov, size
            The same of the result, and its (width, height); as those of `image` where they are not given.
        lens_radius
            The tangent at which r = 1, such as `Hmd.tan_half_angle`: the same for both eyes, and for pictures that
            show more or less than the screen. By default the larger of left and right of `fov`.
        filter
            "linear" or "cubic" (Keys 1981, a = −1/2, as Catmull and Rom have it).
        fill
            For pixels that show nothing of the picture.

        Returns
        -------
        NDArray
            The picture, in the type of `image`. Each pixel is taken from within 5·10⁻¹⁰ of the right place, as a share
            of the distance from the axis.

        Raises
        ------
        ValueError, TypeError
            For other shapes, types and filters.
        """
        return warp([self._core], image, inverse, (fov, output_fov, lens_radius), size, filter, fill)

    def warp_mesh(
        self,
        size: tuple[int, int],
        inverse: bool = True,
        *,
        fov: Fov | None = None,
        output_fov: Fov | None = None,
        lens_radius: float | None = None,
        cells: tuple[int, int] | None = None,
        tolerance_px: float = 0.25,
    ) -> WarpMesh:
        """Mesh with which a runtime warps pictures of one size, and by how many pixels it is off between vertices.

        Parameters
        ----------
        size
            (width, height) of the picture that is read, in pixels.
        inverse, fov, output_fov, lens_radius
            As in `warp`. Runtimes want the inverse one: the lens does the rest.
        cells
            Columns and rows. By default as many as `tolerance_px` needs.
        tolerance_px
            Greatest error in pixels of the picture that is read.

        Returns
        -------
        WarpMesh
            Cells that reach beyond the lens's domain are left out.

        Raises
        ------
        ValueError
            For a tolerance that 2¹⁸ cells do not hold, as beside the fold of an inverse, and for a field of view
            beyond the lens's domain.
        """
        return warp_mesh([self._core], size, inverse, (fov, output_fov, lens_radius), cells, tolerance_px)

    @cached_property
    def _core(self) -> _core.RadialLens:
        return _core.RadialLens(list(self.k), (self.tangential[0], self.tangential[1]))


@dataclass(frozen=True)
class ChromaticLens:
    """A lens that shows colours at different radii: one `RadialLens` for each of red, green and blue."""

    red: RadialLens
    green: RadialLens
    blue: RadialLens

    def __post_init__(self) -> None:
        for name in ("red", "green", "blue"):
            if not isinstance(getattr(self, name), RadialLens):
                raise TypeError(f"{name}: expected a RadialLens, got {type(getattr(self, name)).__name__}")

    def warp(
        self,
        image: ArrayLike,
        inverse: bool = False,
        *,
        fov: Fov | None = None,
        output_fov: Fov | None = None,
        lens_radius: float | None = None,
        size: tuple[int, int] | None = None,
        filter: str = "linear",  # noqa: A002
        fill: float = 0.0,
    ) -> NDArray[Any]:
        """Show a picture (H, W, 3) as the lens does, or put it right; see `RadialLens.warp`."""
        return warp(self._cores, image, inverse, (fov, output_fov, lens_radius), size, filter, fill)

    def warp_mesh(
        self,
        size: tuple[int, int],
        inverse: bool = True,
        *,
        fov: Fov | None = None,
        output_fov: Fov | None = None,
        lens_radius: float | None = None,
        cells: tuple[int, int] | None = None,
        tolerance_px: float = 0.25,
    ) -> WarpMesh:
        """Mesh with places for red, green and blue; see `RadialLens.warp_mesh`."""
        return warp_mesh(self._cores, size, inverse, (fov, output_fov, lens_radius), cells, tolerance_px)

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
    """Solid angles that spheres take once a warped picture is seen through its lens's distortion.

    With μ half the angle that a sphere takes and α its centre's angle from the axis, α± = atan(tan ω ·
    f⁻¹(tan(α ± μ) / tan ω)) and σ′ = σ (α⁺ − α⁻) / 2μ.

    Parameters
    ----------
    centers
        (N, 3), metres.
    radii
        (N,) or one, metres, at least 0.
    camera
        The eye, with a `Fov`: the lens's axis is its line of sight.
    lens
        One without tangential terms.
    lens_radius
        tan ω, the tangent at which r = 1, such as `Hmd.tan_half_angle`. By default the larger of left and right.
    exact
        The published σ′ shrinks along the radius only. True gives the area of what is shown, which shrinks around the
        axis too.

    Returns
    -------
    NDArray
        (N,) float64, steradians. Within 10⁻¹² of the definition, as a share, except for small spheres just before 90°
        or the fold, whose area (`exact`) is within 10⁻¹⁵ over the sine of the half angle. Spheres that reach 90° from
        the axis, or beyond the lens's domain, keep their own solid angle; 4π where the eye is inside.

    Raises
    ------
    ValueError, TypeError
        For other shapes, numbers that are not finite, radii below 0, and cameras without a `Fov`.

    References
    ----------
    Liebisch (2021), Eq. 4.10–4.12.
    """
    if not isinstance(camera, Camera):
        raise TypeError(f"camera: expected a Camera, got {type(camera).__name__}")
    if not isinstance(camera.fov, Fov):
        raise TypeError(f"camera: expected one with a Fov, got {type(camera.fov).__name__}")
    if not isinstance(lens, RadialLens):
        raise TypeError(f"lens: expected a RadialLens, got {type(lens).__name__}")
    if any(lens.tangential):
        raise ValueError(f"lens: expected one without tangential terms, got {lens.tangential}")
    x, y, z, w = camera.orientation
    return _core.corrected_solid_angles(
        lens._core,
        *check.spheres(centers, radii),
        eye=camera.position,
        # −z turned by the orientation.
        forward=(-2 * (x * z + w * y), -2 * (y * z - w * x), 2 * (x * x + y * y) - 1),
        tan_omega=radius_of(camera.fov, lens_radius),
        exact=bool(exact),
    )


def _coefficients(name: str, value: ArrayLike) -> tuple[float, ...]:
    given = check.array(name, value, columns=None, dtype=np.float64, finite=True)
    if given.ndim != 1:
        raise ValueError(f"{name}: expected a sequence of numbers, got shape {given.shape}")
    return tuple(float(c) for c in given)


def _refuse(outside: str) -> bool:
    return check.choice("outside", outside, OUTSIDE) == "raise"
