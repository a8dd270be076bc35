"""Tests of bounding spheres against exact arithmetic over all supports, and with degenerate points."""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations, pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import given, strategies as st
from numpy.typing import NDArray

import nearfar as nf
from nearfar._bounds import METHODS
from tests.support import need, printed_by_threads

Array = NDArray[np.float64]
Point = list[Fraction]


def dot(a: Point, b: Point) -> Fraction:
    return sum((x * y for x, y in zip(a, b, strict=True)), Fraction(0))


def solved(matrix: list[Point], right: Point) -> Point | None:
    """Return the solution of a small linear system in rational numbers; None if it is singular."""
    rows = [[*row, value] for row, value in zip(matrix, right, strict=True)]
    size = len(rows)
    for i in range(size):
        pivot = next((r for r in range(i, size) if rows[r][i] != 0), None)
        if pivot is None:
            return None
        rows[i], rows[pivot] = rows[pivot], rows[i]
        rows[i] = [value / rows[i][i] for value in rows[i]]
        for r in range(size):
            if r != i:
                rows[r] = [a - rows[r][i] * b for a, b in zip(rows[r], rows[i], strict=True)]
    return [row[-1] for row in rows]


def least_radius(points: Array) -> float:
    """Return the exact radius of the smallest enclosing sphere, by trying all spheres through two to four points."""
    exact = [[Fraction(float(x)) for x in point] for point in points]
    least: Fraction | None = None
    for count in range(1, 5):
        for chosen in combinations(exact, count):
            from_first = [[a - b for a, b in zip(p, chosen[0], strict=True)] for p in chosen[1:]]
            # The centre lies in the span of the differences: Gram's matrix times its coefficients is half of their
            # squares.
            gram = [[dot(u, v) for v in from_first] for u in from_first]
            shares = solved(gram, [dot(u, u) / 2 for u in from_first])
            if shares is None:
                continue
            center = [
                x + sum((share * u[i] for share, u in zip(shares, from_first, strict=True)), Fraction(0))
                for i, x in enumerate(chosen[0])
            ]
            away = [[a - b for a, b in zip(p, center, strict=True)] for p in exact]
            squared = max(dot(a, a) for a in away)
            least = squared if least is None or squared < least else least
    assert least is not None
    # Scaling avoids overflow and underflow in the conversion to float.
    scale = Fraction(2) ** (2 * (math.floor(math.log2(float(max(map(abs, points.ravel().tolist())) or 1.0)))))
    return math.sqrt(float(least / scale)) * math.sqrt(float(scale)) if least else 0.0


def outside(points: Array, center: Array, radius: float) -> float:
    """Return the distance of the farthest point outside the sphere, in units in the last place of the radius."""
    away = points.astype(np.longdouble) - center.astype(np.longdouble)
    farthest = float(np.sqrt((away**2).sum(axis=1)).max())
    return float((farthest - radius) / np.spacing(radius))


coordinate = st.one_of(st.integers(-3, 3).map(float), st.floats(-1e3, 1e3, allow_subnormal=False))


@pytest.mark.slow
@given(st.lists(st.tuples(coordinate, coordinate, coordinate), min_size=1, max_size=7), st.sampled_from([1e-8, 1, 1e8]))
def test_few_points_have_the_exact_smallest_sphere(rows: list[tuple[float, ...]], scale: float) -> None:
    points = np.array(rows) * scale
    center, radius = nf.bounding_sphere(points)
    assert outside(points, center, radius) <= 4
    # The centre is rounded to float64 at the points' distance from zero.
    rounding = 1e-15 * np.abs(points).max()
    assert radius <= least_radius(points) * (1 + 1e-12) + rounding
    assert radius >= least_radius(points) * (1 - 1e-12) - rounding


def families() -> Iterator[tuple[str, Array, float]]:
    """Yield point sets whose smallest sphere is known."""
    random = np.random.default_rng(5)
    sphere = random.normal(size=(20_000, 3))
    sphere /= np.linalg.norm(sphere, axis=1, keepdims=True)
    yield "one point", np.array([[3.0, -4.0, 5.0]]), 0.0
    yield "duplicates", np.repeat([[1.0, 2.0, 3.0]], 5000, axis=0), 0.0
    yield "two points", np.array([[0.0, 0, 0], [6.0, 0, 8.0]]), 5.0
    line = np.linspace(-1, 1, 10_001)[:, None] * [2.0, -1.0, 2.0]
    yield "collinear", line, 3.0
    circle = np.linspace(0, 2 * np.pi, 5000, endpoint=False)
    yield "coplanar", np.stack([np.cos(circle), np.sin(circle), 0 * circle], axis=1) * 7.0, 7.0
    yield "cospherical", np.concatenate([sphere, -sphere]), 1.0
    yield "a ball", np.concatenate([sphere * random.random((20_000, 1)), [[0, 0, 1], [0, 0, -1]]]), 1.0
    cluster = 1e-6 * sphere[:5000]
    yield "clusters", np.concatenate([cluster, cluster + np.array([10.0, 0, 0])]), math.nan
    grid = np.stack(np.meshgrid(*[np.arange(20.0)] * 3), axis=-1).reshape(-1, 3)
    yield "a grid", grid, 19 * math.sqrt(3) / 2
    tetrahedron = np.array([[1.0, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]])
    yield "a tetrahedron and what is inside", np.concatenate([0.3 * sphere, tetrahedron]), math.sqrt(3)


@pytest.mark.parametrize("case", list(families()), ids=lambda case: case[0])
@pytest.mark.parametrize("scale", [1e-300, 1e-8, 1.0, 1e8, 1e200])
def test_degenerate_points_have_the_smallest_sphere(case: tuple[str, Array, float], scale: float) -> None:
    _, points, radius = case
    center, found = nf.bounding_sphere(points * scale)
    # Differences between points near zero and much smaller ones have no digits below 1e-308.
    assert outside(points * scale, center, found) <= 4 or scale == 1e-300
    if not math.isnan(radius):
        assert found == pytest.approx(radius * scale, rel=1e-12, abs=0 if scale > 1e-300 else 1e-320)
    for method in METHODS:
        middle, other = nf.bounding_sphere(points * scale, method=method)
        assert other >= found * (1 - 1e-12)
        assert outside(points * scale, middle, other) <= 4 or scale == 1e-300


def test_points_far_from_zero_keep_the_digits_of_their_differences() -> None:
    _, points, _ = next(case for case in families() if case[0] == "cospherical")
    grid = np.round(points * 2**20) / 2**20
    _, radius = nf.bounding_sphere(grid)
    center, found = nf.bounding_sphere(grid + 1e8)
    # Steps of 2⁻²⁰ at 1e8 are exact; only the centre is rounded, to 1.5e-8.
    assert found == pytest.approx(radius, abs=2e-8)
    assert outside(grid + 1e8, center, found) <= 4
    np.testing.assert_allclose(center, 1e8, atol=1e-6)


@given(st.integers(0, 2**32 - 1), st.integers(1, 12_000), st.sampled_from([np.float32, np.float64]))
def test_clouds_are_enclosed_and_no_smaller_sphere_encloses_their_extremes(seed: int, count: int, kind: type) -> None:
    random = np.random.default_rng(seed)
    shape = random.choice(["ball", "box", "shell", "needle"])
    points = random.normal(size=(count, 3))
    if shape == "box":
        points = random.uniform(-1, 1, (count, 3))
    elif shape == "shell":
        points /= np.linalg.norm(points, axis=1, keepdims=True) * (1 + 0.01 * random.random((count, 1)))
    elif shape == "needle":
        points *= [1, 1e-3, 1e-6]
    cloud: NDArray[Any] = points.astype(kind)
    center, radius = nf.bounding_sphere(cloud)
    wide = cloud.astype(np.float64)
    assert outside(wide, center, radius) <= 4
    # The points on the sphere alone have the same smallest sphere.
    distance = np.linalg.norm(wide - center, axis=1)
    near = wide[distance >= radius * (1 - 1e-9)]
    assert nf.bounding_sphere(near)[1] == pytest.approx(radius, rel=1e-12)
    assert nf.bounding_sphere(wide)[1] == radius


@pytest.mark.parametrize("scale", [1.0, 1e-8])
def test_another_exact_solver_agrees(scale: float) -> None:
    need("miniball")
    import miniball

    random = np.random.default_rng(7)
    ball = random.normal(size=(300, 3))
    clouds = [ball, ball / np.linalg.norm(ball, axis=1, keepdims=True), random.uniform(-1, 1, (300, 3)) * [9, 1, 0.01]]
    for cloud in clouds:
        center, radius = nf.bounding_sphere(cloud * scale)
        theirs, square = miniball.get_bounding_ball(cloud * scale, rng=np.random.default_rng(0))
        # The peers accept points within 1e-12 of the squared radius; a centre's error is the square root of the radius'
        # error.
        assert radius == pytest.approx(math.sqrt(square), rel=1e-12)
        assert np.linalg.norm(center - theirs) <= 1e-6 * radius


def test_groups_equal_single_calls() -> None:
    random = np.random.default_rng(0)
    counts = [1, 2, 3, 4, 5, 100, 6000, 1]
    offsets = np.concatenate([[0], np.cumsum(counts)])
    for kind in (np.float32, np.float64):
        points = random.normal(size=(offsets[-1], 3)).astype(kind)
        for method in METHODS:
            centers, radii = nf.bounding_spheres(points, offsets, method=method)
            for k, (start, end) in enumerate(pairwise(offsets)):
                center, radius = nf.bounding_sphere(points[start:end], method=method)
                np.testing.assert_array_equal(centers[k], center)
                assert radii[k] == radius
    centers, radii = nf.bounding_spheres(points, [5, 7])
    assert centers.shape == (1, 3)
    assert nf.bounding_spheres(points, [3])[1].shape == (0,)


def test_approximate_methods_equal_their_definitions() -> None:
    points = np.random.default_rng(1).normal(size=(10_000, 3)) * [3, 2, 1] + np.array([5, 0, 0])
    mean, middle = points.mean(axis=0), (points.min(axis=0) + points.max(axis=0)) / 2
    found = {}
    for method, center in (("average", mean), ("minmax", middle)):
        found[method] = nf.bounding_sphere(points, method=method)
        np.testing.assert_allclose(found[method][0], center, atol=1e-13)
        assert found[method][1] == pytest.approx(np.linalg.norm(points - center, axis=1).max(), rel=1e-14)
    assert nf.bounding_sphere(points, method="best")[1] == min(radius for _, radius in found.values())
    assert 1.0 <= nf.bounding_sphere(points, method="ritter")[1] / nf.bounding_sphere(points)[1] < 1.2


def test_no_points_have_no_sphere() -> None:
    with pytest.raises(ValueError, match="points: expected at least one point"):
        nf.bounding_sphere(np.zeros((0, 3)))


BITS = """
import hashlib
import numpy as np
import nearfar as nf
points = np.random.default_rng(0).normal(size=(100_000, 3))
offsets = np.arange(0, 100_001, 500)
parts = [nf.bounding_sphere(points, method=method) for method in ("exact", "average", "ritter")]
parts += [part.tobytes() for part in nf.bounding_spheres(points, offsets)]
print(hashlib.sha256(repr(parts).encode()).hexdigest())
"""


def test_bits_do_not_depend_on_the_number_of_threads() -> None:
    assert len(set(printed_by_threads(BITS))) == 1
