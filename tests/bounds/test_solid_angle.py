"""Tests of solid angles against arithmetic of 60 digits, and through lenses against numerical integrals."""

from __future__ import annotations

import math
from typing import Any

import mpmath
import numpy as np
import pytest
from hypothesis import assume, given, strategies as st
from mpmath import mpf
from numpy.typing import NDArray

import nearfar as nf

Array = NDArray[np.float64]

RIFT_S = nf.RadialLens((0.22, 0.24))
VIEW = nf.Camera((1.0, 2.0, 3.0), fov=nf.Fov(-1.03553, 0.965689, -1.15, 1.0), size=(1648, 1776))


def exact_angle(center: Array, radius: float, eye: Array) -> Any:
    """Return the exact solid angle 4π sin²(μ/2)."""
    with mpmath.workdps(60):
        distance = mpmath.sqrt(sum((mpf(float(c)) - mpf(float(e))) ** 2 for c, e in zip(center, eye, strict=True)))
        if distance <= radius:
            return 4 * mpmath.pi
        return 4 * mpmath.pi * mpmath.sin(mpmath.asin(mpf(radius) / distance) / 2) ** 2


def sphere_at_angle(alpha: float, around: float, mu: float, distance: float = 10.0) -> tuple[Array, float]:
    """Return a sphere of angular radius μ whose centre is at the angle α from VIEW's axis."""
    direction = np.array([math.sin(alpha) * math.cos(around), math.sin(alpha) * math.sin(around), -math.cos(alpha)])
    return np.array(VIEW.position) + distance * direction, distance * math.sin(mu)


def published(alpha: float, mu: float, lens: nf.RadialLens, omega: float) -> Any:
    """Return σ′/σ of Eq. 4.12, by 60 digits and bisection."""
    with mpmath.workdps(60):

        def displayed_tangent(angle: Any) -> Any:
            x = mpmath.tan(angle) / omega
            size, low, high = abs(x), mpf(0), abs(x) + 1
            for _ in range(200):
                middle = (low + high) / 2
                value = middle + sum(mpf(c) * middle ** (2 * n + 3) for n, c in enumerate(lens.k))
                low, high = (middle, high) if value < size else (low, middle)
            return mpmath.atan(omega * low * mpmath.sign(x))

        return (displayed_tangent(mpf(alpha) + mpf(mu)) - displayed_tangent(mpf(alpha) - mpf(mu))) / (2 * mpf(mu))


def area(alpha: float, mu: float, lens: nf.RadialLens, omega: float) -> float:
    """Return a sphere's displayed area through a lens: the magnification integrated over its directions."""
    node, weight = np.polynomial.legendre.leggauss(200)
    # u = sin²(θ/2) has equal areas for equal steps, and no cancellation.
    top = math.sin(mu / 2) ** 2
    u, weight = top * (node + 1) / 2, weight * top / 2
    theta = 2 * np.arcsin(np.sqrt(u))[:, None]
    psi = (np.arange(400) + 0.5) * 2 * np.pi / 400
    out = np.cos(theta) * math.sin(alpha) + np.sin(theta) * np.cos(psi) * math.cos(alpha)
    ahead = np.cos(theta) * math.cos(alpha) - np.sin(theta) * np.cos(psi) * math.sin(alpha)
    tangent = np.hypot(out, np.sin(theta) * np.sin(psi)) / ahead
    r = lens.undistort(tangent / omega)
    shown = omega * r
    slope = 1 / lens.derivative(r)
    grows = shown / tangent * slope * ((1 + tangent**2) / (1 + shown**2)) ** 1.5
    return float((grows.mean(axis=1) * weight).sum() * 4 * np.pi)


@given(st.floats(-300, 300), st.floats(-300, 300), st.floats(1e-6, 1e3), st.floats(0, 1.5))
def test_solid_angles_are_right_to_a_few_ulps(x: float, y: float, z: float, share: float) -> None:
    # Rounding of the distance decides whether the eye is inside, so close cases are left out.
    assume(abs(share - 1) > 1e-12)
    eye = np.array([0.5, -1.25, 2.0])
    # Multiples of 1/4 make the differences from the eye exact.
    center = np.round(np.array([x, y, z]) * 4) / 4
    radius = share * float(np.linalg.norm(center - eye))
    exact = exact_angle(center, radius, eye)
    found = nf.solid_angle(center[None], radius, eye=eye)[0]
    # The sine is exact to three roundings. Near the surface 1 − sin μ loses digits, and σ has the square root of that
    # error.
    beside = math.sqrt(max(0.0, 1 - share)) if share < 1 else 1.0
    assert abs(found - exact) <= 12 * 2.0**-52 * exact / max(beside, 1e-8) + 1e-320


def test_solid_angles_of_small_distant_and_enclosing_spheres() -> None:
    for distance, radius in ((1.0, 1e-12), (1e12, 1.0), (1e-170, 1e-171), (1e200, 1e199), (1e-310, 1e-311)):
        found = nf.solid_angle([[0, distance, 0]], radius, eye=(0, 0, 0))[0]
        assert found == pytest.approx(float(exact_angle(np.array([0, distance, 0]), radius, np.zeros(3))), rel=1e-15)
    inside = nf.solid_angle([[0, 0, 0], [1, 0, 0], [0, 0, 0]], [1.0, 1.0, 0.0], eye=(0, 0, 0))
    assert np.array_equal(inside, np.full(3, 4 * np.pi))
    assert nf.solid_angle([[2, 0, 0]], 0.0, eye=(0, 0, 0))[0] == 0.0
    assert nf.solid_angle(np.empty((0, 3)), 1.0, eye=(0, 0, 0)).shape == (0,)


@given(st.floats(0, 1.2), st.floats(0, 6.28), st.floats(-7, 0))
def test_the_size_equals_the_published_formula(alpha: float, around: float, power: float) -> None:
    mu = 10.0**power * 0.3
    center, radius = sphere_at_angle(alpha, around, mu)
    own = nf.solid_angle(center[None], radius, eye=VIEW.position)[0]
    found = nf.corrected_solid_angle(center[None], radius, camera=VIEW, lens=RIFT_S)[0]
    # The centre's position is rounded by 1e-15 of 10 m, which changes α and with it the size.
    assert found / own == pytest.approx(float(published(alpha, mu, RIFT_S, 1.03553)), rel=1e-11)


@pytest.mark.parametrize("number", range(25))
def test_the_size_equals_the_displayed_area(number: int) -> None:
    alpha, mu = (0.0, 0.02, 0.4, 0.75, 1.1)[number % 5], (1e-5, 1.9e-3, 2.1e-3, 0.03, 0.3)[number // 5]
    lens = (RIFT_S, nf.RadialLens((-0.003,)), nf.RadialLens(()))[number % 3]
    center, radius = sphere_at_angle(alpha, 1.0, mu)
    found = nf.corrected_solid_angle(center[None], radius, camera=VIEW, lens=lens, exact=True)[0]
    assert found == pytest.approx(area(alpha, mu, lens, 1.03553), rel=1e-11)


@pytest.mark.parametrize("alpha", [1.5, 1.55, 1.568])
@pytest.mark.parametrize("mu", [1.94e-3, 1e-4])
def test_small_spheres_before_ninety_degrees(alpha: float, mu: float) -> None:
    center, radius = sphere_at_angle(alpha, 0.3, mu)
    found = nf.corrected_solid_angle(center[None], radius, camera=VIEW, lens=RIFT_S, exact=True)[0]
    # The centre's position is rounded by 1e-15 of 10 m, compared with 0.003 to 90°. The sum cancels as documented.
    assert found == pytest.approx(
        area(alpha, mu, RIFT_S, 1.03553), rel=1e-11 + 1e-15 / mu + 1e-14 / (math.pi / 2 - alpha)
    )


def test_the_lens_radius_may_be_given() -> None:
    center, radius = sphere_at_angle(0.6, 0.0, 0.05)
    wide = nf.Camera(VIEW.position, fov=nf.Fov(-2, 2, -1, 1), size=(8, 8))
    expected = nf.corrected_solid_angle(center[None], radius, camera=VIEW, lens=RIFT_S)
    for camera in (VIEW, wide):
        found = nf.corrected_solid_angle(center[None], radius, camera=camera, lens=RIFT_S, lens_radius=1.03553)
        assert np.array_equal(found, expected)


def test_the_rift_lens_shrinks_radially_and_tangentially() -> None:
    view = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(87), size=(100, 100))
    angle = math.radians(43)
    center = np.array([[math.sin(angle), 0.0, -math.cos(angle)]])
    own = nf.solid_angle(center, 1e-3, eye=(0, 0, 0))
    for exact, expected in ((False, 0.627), (True, 0.554)):
        found = nf.corrected_solid_angle(center, 1e-3, camera=view, lens=RIFT_S, exact=exact)
        assert found / own == pytest.approx(expected, abs=2e-3)


def test_sizes_are_unchanged_where_no_lens_applies() -> None:
    centers = np.array([[1, 2, 13.0], [1, 2, 3.1], [4.0, 2, 3.0], [1, 2, -2.0]])
    radii = [1.0, 0.5, 1.0, 0.7]
    own = nf.solid_angle(centers, radii, eye=VIEW.position)
    for exact in (False, True):
        found = nf.corrected_solid_angle(centers, radii, camera=VIEW, lens=RIFT_S, exact=exact)
        # Spheres behind or around the eye or beyond 90° keep their size; those ahead shrink.
        assert np.array_equal(found[:3], own[:3])
        assert 0.9 * own[3] < found[3] < own[3]
        same = nf.corrected_solid_angle(centers, radii, camera=VIEW, lens=nf.RadialLens(()), exact=exact)
        assert same == pytest.approx(own, rel=1e-12)
    # Beyond the fold of a lens its picture is undefined.
    center, radius = sphere_at_angle(1.3, 0.0, 0.05)
    folded = nf.RadialLens((-0.2,))
    own = nf.solid_angle(center[None], radius, eye=VIEW.position)
    assert np.array_equal(nf.corrected_solid_angle(center[None], radius, camera=VIEW, lens=folded), own)


def test_the_lens_turns_with_the_camera() -> None:
    turned = nf.Camera.look_at((1, 2, 3), (5, 7, -2), fov=VIEW.fov, size=VIEW.size)
    forward = np.array([4, 5, -5]) / math.sqrt(66)
    side = np.cross(forward, [0.0, 1.0, 0.0])
    side /= np.linalg.norm(side)
    ahead = np.array(turned.position) + 10 * (math.cos(0.6) * forward + math.sin(0.6) * side)
    expected = nf.corrected_solid_angle(sphere_at_angle(0.6, 0.0, 0.1)[0][None], 1.0, camera=VIEW, lens=RIFT_S)
    assert nf.corrected_solid_angle(ahead[None], 1.0, camera=turned, lens=RIFT_S) == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize(
    ("changed", "error", "message"),
    [
        ({"radii": [-1.0]}, ValueError, "radii: expected finite numbers of at least 0, got -1 at index 0"),
        ({"camera": nf.Camera((0, 0, 0), fov=nf.CubeFace(0), size=(8, 8))}, TypeError, "expected a camera with a Fov"),
        ({"lens": nf.RadialLens((0.1,), (0.1, 0.0))}, ValueError, "lens: expected a lens without tangential terms"),
        (
            {"centers": [[1.7e308, 0, 0]], "camera": nf.Camera((-1.7e308, 0, 0), fov=VIEW.fov, size=(4, 4))},
            ValueError,
            "centers: expected finite numbers, at finite distances",
        ),
    ],
)
def test_bad_arguments(changed: dict[str, Any], error: type[Exception], message: str) -> None:
    arguments: dict[str, Any] = {"centers": [[0.0, 0.0, -5.0]], "radii": [1.0], "camera": VIEW, "lens": RIFT_S}
    arguments.update(changed)
    with pytest.raises(error, match=message):
        nf.corrected_solid_angle(arguments.pop("centers"), arguments.pop("radii"), **arguments)
