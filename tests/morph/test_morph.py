"""Tests of the morph against Eq. 1–3 in high precision, and in special cases."""

from __future__ import annotations

import math
from decimal import Decimal, localcontext
from typing import Any

import numpy as np
import pytest
from hypothesis import given, strategies as st
from numpy.typing import NDArray

import nearfar as nf
from nearfar import _core
from nearfar._morph import kernel_arguments
from tests.support import printed_by_threads

R1, R2 = 30.0, 50.0


def oracle(point: Any, user: Any, center: Any, r1: float = R1, r2: float = R2) -> list[float]:
    """Evaluate Eq. 1–3 as printed, with 50 digits."""
    with localcontext() as context:
        context.prec = 50
        u, o, p = ([Decimal(float(x)) for x in vector] for vector in (user, center, point))
        v = [a - b for a, b in zip(u, o, strict=True)]
        from_o = [a - b for a, b in zip(p, o, strict=True)]
        from_u = [a - b for a, b in zip(p, u, strict=True)]
        rho = (from_o[0] ** 2 + from_o[2] ** 2).sqrt()
        w = min(max((Decimal(r2) - rho) / (Decimal(r2) - Decimal(r1)), Decimal(0)), Decimal(1))
        if w == 1:
            return [float(x) for x in p]
        length_u, length_o = (sum((x * x for x in d), Decimal(0)).sqrt() for d in (from_u, from_o))
        blend = [w * a / length_u + (1 - w) * b / length_o for a, b in zip(from_u, from_o, strict=True)]
        length = sum((x * x for x in blend), Decimal(0)).sqrt()
        t = w * length_u + (1 - w) * length_o
        return [float(a + b + t * d / length) for a, b, d in zip(o, v, blend, strict=True)]


def ring(center: Any, rho: Any, height: Any, count: int = 64) -> NDArray[np.float64]:
    angle = np.linspace(0.0, 2 * math.pi, count, endpoint=False)
    ring = np.stack([rho * np.cos(angle), np.broadcast_to(height, count), rho * np.sin(angle)], axis=1)
    shifted: NDArray[np.float64] = np.asarray(center, np.float64) + ring
    return shifted


finite = st.floats(-60.0, 60.0)
vectors = st.tuples(finite, finite, finite)


@given(st.lists(vectors, min_size=1, max_size=80), st.tuples(*[st.floats(-12.0, 12.0)] * 3), st.floats(-1e7, 1e7))
def test_points_equal_fifty_digit_arithmetic(points: list[Any], user: Any, shift: float) -> None:
    center = np.array([shift, 1.7, -shift])
    eye = center + np.array(user)
    offset = float(np.linalg.norm(eye - center))
    double = center + np.array(points)
    for given_points in (double, double.astype(np.float32)):
        shown = nf.morph(given_points, user=eye, center=center, r1=R1, r2=R2)
        assert shown.dtype == given_points.dtype
        for point, q in zip(given_points, shown, strict=True):
            expected = np.array(oracle(point, eye, center))
            step = np.spacing(np.abs(expected).astype(given_points.dtype)).astype(np.float64)
            unit = 2.0**-24 if given_points.dtype == np.float32 else 2.0**-53
            # The documented bound: half a step of the result, and the rounding of a shift of the size of |U−O|. If
            # the centre is no float32, its float64 form adds 2e-9 at 10⁷ m; float64 itself adds a few steps there.
            bound = 0.5 * step + unit * (6 + 3 * R2 / (R2 - R1)) * offset + 8e-9 * abs(shift) / 1e7 + 1e-13
            assert np.all(np.abs(q.astype(np.float64) - expected) <= bound)


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("far_away", [0.0, 1e7])
def test_points_inside_r1_keep_their_bits_and_beyond_r2_shift(dtype: Any, far_away: float) -> None:
    center = np.array([far_away, 1.7, -far_away])
    user = center + np.array([4.0, 0.3, -5.0])
    rings = [ring(center, rho, 400.0 * (rho < 20) + rho) for rho in (0.0, 1e-3, 10.0, 29.9, 40.0, 50.5, 3e4)]
    # Points exactly on both radii.
    rings.append(center + np.array([[30, 0, 0], [18, 5, -24], [0, 9, -30], [50, 0, 0], [-30, 4, 40]]))
    points = np.concatenate(rings).astype(dtype)
    points[0] = [center[0], -0.0, center[2]]
    shown = nf.morph(points, user=user, center=center, r1=R1, r2=R2)
    local = points.astype(np.float64) - center
    rho = np.hypot(local[:, 0], local[:, 2])
    inside, outside = rho <= R1, rho >= R2
    assert inside.sum() > 200
    assert outside.sum() > 100
    assert shown[inside].tobytes() == points[inside].tobytes()
    expected = (points[outside].astype(np.float64) + (user - center)).astype(dtype)
    np.testing.assert_array_equal(shown[outside], expected)


@pytest.mark.parametrize("kind", ["blend", "cylinder"])
@pytest.mark.parametrize("radius", [R1, R2])
def test_the_morph_is_continuous_at_both_radii(kind: str, radius: float) -> None:
    user, center = (6.0, 2.0, -5.0), (1.0, 1.7, 2.0)
    for height in (-5.0, 1.7, 400.0):
        below, above = (
            nf.morph(ring(center, rho, height), user=user, center=center, r1=R1, r2=R2, kind=kind)
            for rho in (radius - 1e-9, radius + 1e-9)
        )
        # The points are 2e-9 apart; directions differ by at most |U−O| / 30 per unit of w, at 400 m: a factor of 20.
        assert np.abs(below - above).max() < 1e-7


def test_near_towers_keep_their_position() -> None:
    """A tower 400 m high at a distance of 10 m is inside r1 up to its top."""
    tower = ring((0.0, 0.0, 0.0), 10.0, np.linspace(0.0, 400.0, 64)).astype(np.float32)
    np.testing.assert_array_equal(nf.morph(tower, user=(8, 2, 0), center=(0, 1.7, 0), r1=R1, r2=R2), tower)


@pytest.mark.parametrize("kind", ["blend", "cylinder"])
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_for_a_user_at_the_centre_nothing_moves(kind: str, dtype: Any) -> None:
    center = (1e6, 1.7, 3.0)
    points = np.concatenate([ring(center, rho, 2.0 + rho) for rho in (0.0, 10.0, 40.0, 1e4)]).astype(dtype)
    np.testing.assert_array_equal(nf.morph(points, user=center, center=center, r1=R1, r2=R2, kind=kind), points)


@pytest.mark.parametrize("kind", ["blend", "cylinder"])
def test_points_on_the_axis_at_the_eye_and_above(kind: str) -> None:
    center = np.array([5.0, 1.7, -5.0])
    user = center + np.array([1.0, 0.0, 0.0])
    up = np.array([0.0, 400.0, 0.0])
    still = np.array([center, user, center + up, user + up, center - up])
    np.testing.assert_array_equal(nf.morph(still, user=user, center=center, r1=R1, r2=R2, kind=kind), still)
    outside = center + np.array([40.0, 0.0, 0.0])
    # At the eye the user's direction is undefined: the centre's is used, with t = (1−w) |P−O| = 20.
    shown = nf.morph(outside[None], user=outside, center=center, r1=R1, r2=R2)
    np.testing.assert_allclose(shown[0], outside + np.array([20.0, 0.0, 0.0]), atol=1e-13)


def test_opposite_directions_are_counted() -> None:
    points = np.tile([[40.0, 0.0, 0.0]], (100, 1))
    for given_points in (points.astype(np.float32), points):
        shown = np.empty_like(given_points)
        arguments = kernel_arguments((80.0, 0.0, 0.0), (0.0, 0.0, 0.0), R1, R2, "blend")
        opposed = _core.morph(given_points, shown, arguments)
        assert opposed == 100
        # The user's direction, at half of |P−U| + |P−O|.
        np.testing.assert_array_equal(shown, points)


def test_results_are_written_to_the_callers_array() -> None:
    points = np.random.default_rng(0).uniform(-60, 60, (1000, 3))
    where: dict[str, Any] = {"user": (3, 1, 2), "center": (0, 1.7, 0), "r1": R1, "r2": R2}
    for given_points in (points.astype(np.float32), points):
        out = np.empty_like(given_points)
        assert nf.morph(given_points, out=out, **where) is out
        np.testing.assert_array_equal(out, nf.morph(given_points, **where))
    frozen = np.empty_like(points)
    frozen.flags.writeable = False
    for out, words in (
        (points.astype(np.float32), r"out: expected \(1000, 3\) of float64, got \(1000, 3\) of float32"),
        (np.empty((3, 1000)).T, "out: expected a C-contiguous array that can be written"),
        (frozen, "out: expected a C-contiguous array that can be written"),
        (points, "out: expected an array that shares no memory"),
    ):
        with pytest.raises(ValueError, match=words):
            nf.morph(points, out=out, **where)


def cylinder_oracle(p: NDArray[Any], user: Any, center: Any, r1: float, r2: float) -> NDArray[np.float64]:
    """Evaluate CloVR, Alg. 1, by the textbook root in extended precision, for users inside all cylinders."""
    p, u, o = (np.asarray(x, np.longdouble) for x in (p, user, center))
    from_o, from_u, v = p - o, p - u, u - o
    rho = np.sqrt(from_o[:, 0] ** 2 + from_o[:, 2] ** 2)
    w = np.clip((r2 - rho) / (r2 - r1), 0, 1)[:, None]
    d = (
        w * from_u / np.linalg.norm(from_u, axis=1)[:, None]
        + (1 - w) * from_o / np.linalg.norm(from_o, axis=1)[:, None]
    )
    d /= np.sqrt((d**2).sum(1))[:, None]
    a, b = d[:, 0] ** 2 + d[:, 2] ** 2, d[:, 0] * v[0] + d[:, 2] * v[2]
    t = (-b + np.sqrt(b * b - a * (v[0] ** 2 + v[2] ** 2 - rho**2))) / a
    return np.asarray(u + t[:, None] * d, np.float64)


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_cylinder_morph_equals_the_textbook_formula(dtype: Any) -> None:
    center, user = (3.0, 1.7, 4.0), (9.0, 2.5, -2.0)
    points = np.concatenate(
        [ring(center, rho, h) for rho in (12.0, 36.0, 44.0, 49.9, 50.1, 900.0) for h in (0.0, 80.0)]
    )
    points = points.astype(dtype)
    shown = nf.morph(points, user=user, center=center, r1=0.7 * R2, r2=R2, kind="cylinder")
    expected = cylinder_oracle(points, user, center, 0.7 * R2, R2)
    # Computed in float64 (1e-13 at these sizes) and rounded once to the points' type.
    tolerance = 6e-8 * np.abs(expected).max() if dtype == np.float32 else 1e-11
    np.testing.assert_allclose(shown, expected, atol=tolerance, rtol=0)
    local = shown.astype(np.float64) - center
    rho = np.hypot(*(points.astype(np.float64) - center)[:, [0, 2]].T)
    np.testing.assert_allclose(np.hypot(local[:, 0], local[:, 2]), rho, atol=2 * tolerance)


def test_cylinder_morph_for_users_on_the_axis_or_outside() -> None:
    center, user = (0.0, 0.0, 0.0), (10.0, 0.0, 0.0)
    points = ring(center, 40.0, 3.0)
    none = nf.morph(points, user=user, center=center, r1=0, r2=0, kind="cylinder")
    # Some twenty roundings of float64, most of which cancel.
    np.testing.assert_allclose(np.hypot(none[:, 0], none[:, 2]), 40.0, rtol=1e-14)
    # The user is outside the point's cylinder, so the blend's distance is used.
    inner = ring(center, 36.0, 3.0)
    far_user = (39.0, 0.0, 0.0)
    shown, blended = (
        nf.morph(inner, user=far_user, center=center, r1=35, r2=50, kind=kind) for kind in ("cylinder", "blend")
    )
    # The same direction and distance by two formulas, at 40 m: a step of float64 is 7e-15 m.
    np.testing.assert_allclose(shown, blended, atol=1e-12)
    assert np.isfinite(nf.morph([[0.0, 5.0, 0.0]], user=user, center=center, r1=0, r2=0, kind="cylinder")).all()


def test_results_do_not_depend_on_threads() -> None:
    code = (
        "import numpy as np, nearfar as nf, hashlib;"
        "p = np.random.default_rng(1).uniform(-60, 60, (100_003, 3)).astype(np.float32);"
        "q = nf.morph(p, user=(3, 1, 2), center=(0, 1, 0), r1=20, r2=40);"
        "print(hashlib.sha256(q.tobytes()).hexdigest())"
    )
    assert len(printed_by_threads(code)) == 1


def test_shapes_types_and_places() -> None:
    arguments: dict[str, Any] = {"user": (3, 0, 0), "center": (0, 0, 0), "r1": R1, "r2": R2}
    assert nf.morph(np.empty((0, 3)), **arguments).shape == (0, 3)
    assert nf.morph([[1, 2, 3]], **arguments).dtype == np.float64
    points = np.random.default_rng(5).uniform(-60, 60, (3000, 3))
    whole = nf.morph(points, **arguments)
    # The result for a point does not depend on its neighbours or its place in memory.
    np.testing.assert_array_equal(nf.morph(points[::-1], **arguments), whole[::-1])
    np.testing.assert_array_equal(nf.morph(np.asfortranarray(points), **arguments), whole)
    one_by_one = np.concatenate([nf.morph(points[i : i + 1], **arguments) for i in range(300)])
    np.testing.assert_array_equal(one_by_one, whole[:300])
    with_nan = points.copy()
    with_nan[7] = np.nan
    shown = nf.morph(with_nan, **arguments)
    assert np.isnan(shown[7]).all()
    np.testing.assert_array_equal(np.delete(shown, 7, 0), np.delete(whole, 7, 0))


def test_a_blend_has_room_between_its_radii() -> None:
    with pytest.raises(ValueError, match="r1: expected less than r2"):
        nf.morph([[1.0, 2.0, 3.0]], user=(0, 0, 0), center=(0, 0, 0), r1=0, r2=0)
