"""Tests of lenses against arithmetic of 60 digits, at their folds, and where the published iteration fails."""

from __future__ import annotations

import json
import math
import pickle
from typing import Any

import cv2
import mpmath
import numpy as np
import pytest
from hypothesis import assume, given, settings, strategies as st
from mpmath import mpf
from numpy.typing import NDArray

import nearfar as nf
from tests.support import data, printed_by_threads

Array = NDArray[np.float64]

mpmath.mp.dps = 60

RIFT_S = (0.22, 0.24)
"""Lens of the Rift S, from Liebisch (2021)."""

LENSES = (RIFT_S, (), (0.1,), (0.0, 0.0, 0.7), (-0.2, 0.0), (-0.4, 0.05), (-0.3, 0.1), (5.0, -1.0), (0.441, 0.156))

coefficients = st.lists(st.just(0.0) | st.floats(1e-30, 2) | st.floats(-2, -1e-30), max_size=6).map(tuple)


def exactly(k: tuple[float, ...], r: Any) -> Any:
    """Return the exact f(r)."""
    r = mpf(r)
    return r + sum((mpf(c) * r ** (2 * n + 3) for n, c in enumerate(k)), mpf(0))


def slope(k: tuple[float, ...], r: Any) -> Any:
    """Return the exact f′(r)."""
    r = mpf(r)
    return 1 + sum(((2 * n + 3) * mpf(c) * r ** (2 * n + 2) for n, c in enumerate(k)), mpf(0))


def fold(k: tuple[float, ...]) -> float:
    """Return the least positive root of f′, from the eigenvalues of its companion matrix."""
    squares = np.roots([*reversed([(2 * n + 3) * c for n, c in enumerate(k)]), 1.0]) if k else np.empty(0)
    real = squares[(np.abs(squares.imag) < 1e-9 * np.abs(squares)) & (squares.real > 0)].real
    return math.sqrt(real.min()) if len(real) else math.inf


def is_root(k: tuple[float, ...], r: float, x: float) -> bool:
    """Return whether f(r) is within 2 ulps of x, or the true root lies between the neighbours of r."""
    if abs(exactly(k, r) - mpf(x)) <= 2 * mpf(math.ulp(x)):
        return True
    return bool(exactly(k, math.nextafter(r, 0)) <= x <= exactly(k, math.nextafter(r, math.inf)))


def domain_radii(lens: nf.RadialLens, count: int) -> Array:
    """Return distorted radii over the whole domain, dense at both ends of it."""
    end = min(1e3, float(lens.distort(lens.r_max))) if math.isfinite(lens.r_max) else 1e3
    share = np.linspace(0, 1, count)
    return np.unique(np.concatenate([end * share, end * share**8, end * (1 - share**8), [1e-300, 5e-324, 1e-9]]))


def in_data() -> list[tuple[float, ...]]:
    """Return sets of coefficients with even powers in the data."""
    viewers = json.loads(data("optics/lens_distortion.json").read_text())["cardboard"]["viewers"]
    return [tuple(viewer[name]) for viewer in viewers for name in ("k1k2", "inverse")]


@pytest.mark.parametrize("k", LENSES)
def test_forward_is_within_an_ulp(k: tuple[float, ...]) -> None:
    lens = nf.RadialLens(k)
    r = np.linspace(0, min(lens.r_max, 8.0), 997)
    for one, shown, steepness in zip(r, lens.distort(r), lens.derivative(r), strict=True):
        assert abs(exactly(k, one) - mpf(shown)) <= math.ulp(shown)
        # Horner's rule: two roundings for each coefficient, of the sum of the terms' sizes.
        terms = slope(tuple(abs(c) for c in k), one)
        assert abs(slope(k, one) - mpf(steepness)) <= (2 * len(k) + 2) * 2.0**-52 * terms


@pytest.mark.parametrize("k", LENSES)
def test_newton_finds_the_root(k: tuple[float, ...]) -> None:
    lens = nf.RadialLens(k)
    x = domain_radii(lens, 500)
    for shown, root in zip(x, lens.undistort(x), strict=True):
        assert is_root(k, root, shown), (shown, root)
        assert root <= lens.r_max


def test_newton_finds_the_root_for_every_lens_in_the_data() -> None:
    found = in_data()
    assert len(found) == 4
    for k in found:
        lens = nf.RadialLens(k)
        x = domain_radii(lens, 300)
        assert all(is_root(k, root, shown) for shown, root in zip(x, lens.undistort(x), strict=True))


@given(coefficients, st.integers(-3, 3), st.lists(st.floats(0, 1), min_size=1, max_size=50))
def test_newton_finds_the_root_for_any_lens(k: tuple[float, ...], power: int, shares: list[float]) -> None:
    k = tuple(c * 10.0**power for c in k)
    lens = nf.RadialLens(k)
    end = float(lens.distort(lens.r_max)) if math.isfinite(lens.r_max) else 1e3
    x = np.array(shares) * end
    # Copies test the vector instructions and the ends of blocks.
    roots = lens.undistort(np.concatenate([x] * 3))
    assert np.array_equal(roots[: len(x)], roots[-len(x) :])
    assert all(is_root(k, root, shown) for shown, root in zip(x, roots, strict=False))


@pytest.mark.parametrize(
    "k",
    [
        (1e-55,), (-1e-55,), (1e55,), (0.0,) * 10 + (-1e288,), (0.0,) * 30 + (1e288,), (0.0,) * 63 + (1e290,),
        (0.22, *(0.0,) * 62, 1e288), (-0.1, 1e-310), (-0.1, 0.0, 1e-320), (1e-3,) * 64, (0.0,) * 30 + (2.0,),
        (1.19, -3.65e10, 5.04e20, -5.8e13, 1.667e39, -2.7e-25), (1.0, -1e-300), (-1e-29, 1e-300),
    ],
)  # fmt: skip
def test_lenses_at_the_limits_of_floats(k: tuple[float, ...]) -> None:
    lens = nf.RadialLens(k)
    x = lens.distorted_max * np.array([1.0, 0.999, 0.5, 1e-3, 1e-30, 1e-200])
    with mpmath.workdps(400):
        for method in ("newton", "lut"):
            for shown, root in zip(x, lens.undistort(x, method=method), strict=True):
                assert root <= lens.r_max
                if method == "newton":
                    assert is_root(k, root, shown), (shown, root)
    for call in (lens.distort, lens.undistort):
        assert np.isnan(call([math.inf, math.nan], outside="nan")).all()
    # Worked out by hand: the lens folds at the first negative term that is not outweighed.
    assert math.isinf(lens.r_max) == (min(k[:1] + k[-1:]) >= 0 or k[1:] == (-1e-300,)), lens.r_max


@settings(max_examples=settings().max_examples // 2)
@given(st.integers(1, 64), st.floats(-29, 29), st.floats(-10, 10), st.booleans(), st.floats(0, 1))
def test_lenses_of_any_scale_are_inverted(
    power: int, exponent: float, other: float, negative: bool, share: float
) -> None:
    # One term reaches r at 10^exponent, and the first one may be negligible.
    size = -2 * power * exponent
    assume(-288 < size < 288 and -288 < -2 * exponent + other < 288)
    k = [0.0] * power
    k[-1] = (-1.0 if negative else 1.0) * 10.0**size
    k[0] += 10.0 ** (-2 * exponent + other)
    assume(all(c == 0 or 1e-30 < abs(c) ** (-0.5 / (n + 1)) < 1e30 for n, c in enumerate(k)))
    lens = nf.RadialLens(k)
    x = min(lens.distorted_max, 10.0 ** (exponent + 2)) * share
    with mpmath.workdps(400):
        assert is_root(tuple(k), float(lens.undistort(x)), x)
        exact = float(lens.undistort(x))
        assert abs(float(lens.undistort(x, method="lut")) - exact) <= lens.lut_bound * exact + 1e-280


def test_rounded_images_of_the_edge_are_inverted() -> None:
    lens = nf.RadialLens((-0.2, 0.01))
    angle = np.linspace(0, 6.28, 500)
    circle = np.column_stack([np.cos(angle), np.sin(angle)])
    for share in (3e-9, 1e-8, 1e-12):
        points = circle * (lens.r_max * (1 - share))
        back = lens.undistort_points(lens.distort_points(points))
        # Near the fold a rounding of the image moves its root by the square root of it.
        assert np.abs(back - points).max() < 1e-7
        single = points.astype(np.float32) * np.float32(1 - 1e-6)
        assert lens.undistort_points(lens.distort_points(single)).dtype == np.float32
    r = np.linspace(0.999, 1, 1000) * np.float64(np.float32(lens.r_max * (1 - 1e-7)))
    assert np.isfinite(lens.undistort(lens.distort(r.astype(np.float32)))).all()


@given(coefficients)
def test_the_domain_ends_at_the_fold(k: tuple[float, ...]) -> None:
    assume(all(c == 0 or abs(c) > 1e-6 for c in k))
    lens, expected = nf.RadialLens(k), fold(k)
    if math.isfinite(lens.r_max):
        # f rises up to the fold and ends there. Where zeros of f′ are close together, their positions are inexact.
        r = np.linspace(0, lens.r_max * (1 - 1e-6), 50)
        assert (lens.derivative(r) > 0).all()
        terms = slope(tuple(abs(c) for c in k), lens.r_max)
        assert abs(slope(k, lens.r_max)) <= 1e-13 * terms
    else:
        assert math.isinf(expected) or abs(slope(k, expected * (1 + 1e-4))) > 0
        assert all(slope(k, r) > 0 for r in np.geomspace(1e-3, 1e3, 60))


@pytest.mark.parametrize(("k", "place"), [((-0.2, 0.0), 1.291), ((-0.4, 0.05), 1.036), ((-0.3, 0.1), math.inf)])
def test_published_folds(k: tuple[float, ...], place: float) -> None:
    assert nf.RadialLens(k).r_max == pytest.approx(place, abs=5e-4)


def test_radii_beyond_the_fold_are_refused_or_nan() -> None:
    lens = nf.RadialLens((-0.2, 0.0))
    end = float(lens.distort(lens.r_max))
    for call in (lens.distort, lens.derivative):
        with pytest.raises(ValueError, match=r"r: expected radii up to 1\.29.*where the lens"):
            call([0.0, 1.0, 1.3])
    for method in ("newton", "lut"):
        with pytest.raises(ValueError, match=r"r: expected radii up to 0\.86.* at index 1"):
            lens.undistort([end, math.nextafter(end, 1)], method=method)
        found = lens.undistort([[0.1, -2.0], [math.nan, math.inf]], method=method, outside="nan")
        assert found.shape == (2, 2)
        assert np.array_equal(np.isnan(found), [[False, True], [True, True]])
    assert lens.undistort(end) == pytest.approx(lens.r_max, rel=1e-7)


def test_lenses_without_a_fold_refuse_overflow() -> None:
    with pytest.raises(ValueError, match="r: expected numbers with a result below 1e290"):
        nf.RadialLens(RIFT_S).distort(1e160)
    assert nf.RadialLens(()).derivative(1e200) == 1.0
    assert math.copysign(1.0, nf.RadialLens(RIFT_S).distort(-0.0)) == -1.0


@pytest.mark.parametrize("k", LENSES)
def test_tables_keep_their_error_bound(k: tuple[float, ...]) -> None:
    lens = nf.RadialLens(k)
    x = domain_radii(lens, 60_000)
    exact = lens.undistort(x)
    off = np.abs(lens.undistort(x, method="lut") - exact)
    assert lens.lut_bound <= 5e-10
    # Values so small that their rounding exceeds any relative error are left out.
    assert (off <= lens.lut_bound * exact + 1e-320).all()
    if k:
        # The bound must be close to the actual errors to be useful.
        assert off[exact > 0].max() > 0
        assert (off / np.maximum(exact, 1e-300)).max() >= 0.02 * lens.lut_bound


def test_the_published_iteration_fails_where_documented() -> None:
    lens = nf.RadialLens(RIFT_S)

    # r ← x / (1 + k₁r² + k₂r⁴) contracts by r g′/g at r.
    def rate(r: float) -> float:
        return (2 * 0.22 * r**2 + 4 * 0.24 * r**4) / (1 + 0.22 * r**2 + 0.24 * r**4)

    assert rate(1.0) == pytest.approx(0.959, abs=5e-4)
    assert rate(1.0176) < 1.0 < rate(1.0177)
    x = lens.distort([1.0, 1.2])
    off = [np.abs(lens.distort(lens.undistort(x, method="fixed_point", iterations=n)) - x) for n in (5, 10, 50, 400)]
    assert off[0][0] == pytest.approx(0.57, abs=0.01)
    assert off[1][0] == pytest.approx(0.58, abs=0.01)
    assert off[2][0] == pytest.approx(0.077, abs=0.01)
    # At the edge the iteration converges eventually, beyond it never.
    assert off[3][0] < 1e-6
    assert off[3][1] > 0.1
    weak = nf.RadialLens((0.01,))
    assert weak.undistort(weak.distort(1.0), method="fixed_point", iterations=30) == pytest.approx(1.0, abs=1e-15)


def test_opencv_leaves_a_residual() -> None:
    lens = nf.RadialLens(RIFT_S)
    x = np.zeros((1000, 1, 2))
    x[:, 0, 0] = lens.distort(np.linspace(0, 1, 1000))
    given = np.array([*RIFT_S, 0.0, 0.0])
    root = cv2.undistortPoints(x, np.eye(3), given)[:, 0, 0]
    assert np.abs(lens.distort(root) - x[:, 0, 0]).max() == pytest.approx(0.57, abs=0.02)
    ours = lens.undistort_points(x[:, 0])
    assert np.abs(lens.distort_points(ours) - x[:, 0]).max() < 1e-15


def test_all_array_types_and_shapes_are_accepted() -> None:
    lens = nf.RadialLens(RIFT_S)
    r = np.linspace(-1.5, 1.5, 3001)
    assert np.array_equal(lens.undistort(-r), -lens.undistort(r))
    assert np.array_equal(lens.distort(-r), -lens.distort(r))
    single = r.astype(np.float32)
    for call in (lens.distort, lens.undistort, lens.derivative):
        assert call(single).dtype == np.float32
        assert np.array_equal(call(single), call(single.astype(np.float64)).astype(np.float32))
        assert call([]).shape == (0,)
        assert call(0.5).shape == ()
        assert call([[1, 0]]).dtype == np.float64
        assert np.array_equal(call(r[::3]), call(r)[::3])
    identity = nf.RadialLens(())
    assert np.array_equal(identity.undistort(r), r)
    assert identity.r_max == math.inf
    assert nf.RadialLens((0.0, 0.0)).undistort(0.3) == 0.3


def test_lenses_are_values() -> None:
    lens = nf.RadialLens([0.22, 0.24])
    assert lens == nf.RadialLens(RIFT_S)
    assert hash(lens) == hash(nf.RadialLens(RIFT_S))
    assert pickle.loads(pickle.dumps(lens)).undistort(1.0) == lens.undistort(1.0)
    assert "0.24" in repr(lens)


tangentials = st.tuples(st.floats(-0.05, 0.05), st.floats(-0.05, 0.05))


def brown(k: tuple[float, ...], p: tuple[float, float], x: Any, y: Any) -> tuple[Any, Any]:
    """Evaluate Brown's model with 60 digits, as OpenCV documents it."""
    x, y, p1, p2 = mpf(x), mpf(y), mpf(p[0]), mpf(p[1])
    square = x * x + y * y
    factor = 1 + sum((mpf(c) * square ** (n + 1) for n, c in enumerate(k)), mpf(0))
    return (
        x * factor + 2 * p1 * x * y + p2 * (square + 2 * x * x),
        y * factor + p1 * (square + 2 * y * y) + 2 * p2 * x * y,
    )


@given(coefficients, tangentials, st.integers(0, 1000))
def test_points_are_undistorted(k: tuple[float, ...], p: tuple[float, float], seed: int) -> None:
    lens = nf.RadialLens(k, p)
    reach = min(lens.point_r_max, 3.0)
    random = np.random.default_rng(seed)
    angle = random.uniform(0, 2 * np.pi, 40)
    points = np.column_stack([np.cos(angle), np.sin(angle)]) * (reach * random.uniform(0, 0.999, (40, 1)))
    shown = lens.distort_points(points)
    # Terms up to the fifteenth power of 3 · 2, and a few roundings of each.
    size = float(brown(tuple(abs(c) for c in k), (abs(p[0]), abs(p[1])), reach, reach)[0])
    for (x, y), (u, v) in zip(points, shown, strict=True):
        exact = brown(k, p, x, y)
        assert max(abs(exact[0] - mpf(u)), abs(exact[1] - mpf(v))) <= 40 * 2.0**-52 * size
    back = lens.undistort_points(shown)
    # A root in the disc is the only one; its rounding error depends on the slope near the disc's edge.
    assert np.abs(lens.distort_points(back, outside="nan") - shown).max() <= 200 * 2.0**-52 * size


def test_points_agree_with_opencv() -> None:
    k, p = (0.1, -0.02, 0.003), (0.01, -0.02)
    lens = nf.RadialLens(k, p)
    points = np.random.default_rng(0).uniform(-0.7, 0.7, (500, 2))
    # OpenCV's order is k₁ k₂ p₁ p₂ k₃.
    theirs = cv2.projectPoints(
        np.column_stack([points, np.ones(500)]), np.zeros(3), np.zeros(3), np.eye(3), np.array([*k[:2], *p, k[2]])
    )[0][:, 0]
    assert np.abs(lens.distort_points(points) - theirs).max() < 1e-15
    assert np.abs(lens.undistort_points(theirs) - points).max() < 1e-14


def test_points_outside_the_disc_are_refused() -> None:
    lens = nf.RadialLens((-0.2,), (0.02, 0.01))
    assert 0 < lens.point_r_max < lens.r_max
    with pytest.raises(ValueError, match=r"points: expected points of the lens's image.* at index 1"):
        lens.distort_points([[0.0, 0.0], [lens.point_r_max * 1.001, 0.0]])
    far = lens.undistort_points([[5.0, 5.0], [0.1, 0.1], [math.nan, 0.0]], outside="nan")
    assert np.array_equal(np.isnan(far[:, 0]), [True, False, True])
    plain = nf.RadialLens((-0.2,))
    assert plain.point_r_max == plain.r_max
    with pytest.raises(ValueError, match="index 0"):
        plain.undistort_points([[0.9, 0.0]])
    single = nf.RadialLens(RIFT_S).undistort_points(np.array([[0.3, 0.4]], np.float32))
    assert single.dtype == np.float32


def test_the_same_bits_for_any_number_of_threads() -> None:
    code = (
        "import nearfar as nf, numpy as np, hashlib\n"
        "x = np.random.default_rng(0).random(100_000) * 3\n"
        "lens = nf.RadialLens((0.22, 0.24))\n"
        "print([hashlib.sha256(lens.undistort(x, method=m).tobytes()).hexdigest() for m in ('newton', 'lut')])\n"
    )
    assert len(printed_by_threads(code)) == 1


@pytest.mark.stress
def test_many_radii() -> None:
    lens = nf.RadialLens(RIFT_S)
    r = np.random.default_rng(0).random(20_000_000) * 3
    assert np.abs(lens.undistort(lens.distort(r)) - r).max() <= 4 * np.finfo(float).eps * 3
