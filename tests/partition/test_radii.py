"""Least and greatest radii of triangles against exact fractions."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, strategies as st

import nearfar as nf
from tests.support.partition_cases import exact_radii, numpy_radii, town

grid = st.integers(-6, 6).map(lambda i: 0.5 * i)


free = st.floats(-1e4, 1e4, width=32)


corner = st.one_of(st.tuples(grid, grid, grid), st.tuples(free, free, free))


@given(st.lists(st.tuples(corner, corner, corner), min_size=1, max_size=70), corner)
def test_radii_equal_exact_fractions(triangles: list[Any], center: Any) -> None:
    corners = np.array(triangles)
    double = nf.triangle_radii(corners, center=center)
    single = nf.triangle_radii(corners.astype(np.float32), center=center)
    for triangle, radii in zip(triangles, double, strict=True):
        least, greatest = exact_radii(triangle, center)
        # Two dozen float64 roundings at most, each relative to the greatest distance.
        assert abs(radii[0] - least) <= 3e-15 * greatest
        assert abs(radii[1] - greatest) <= 1e-15 * greatest
    # If float32 holds the corners, the float32 result is the float64 one, rounded once.
    if np.array_equal(corners.astype(np.float32), corners):
        np.testing.assert_array_equal(single, double.astype(np.float32))


def test_faces_and_corner_lists_agree() -> None:
    random = np.random.default_rng(2)
    vertices = random.normal(0, 50, (500, 3)).astype(np.float32)
    faces = random.integers(0, 500, (40_000, 3))
    for dtype in (np.float32, np.float64):
        points = vertices.astype(dtype)
        center = (3.0, 100.0, -2.0)
        radii = nf.triangle_radii(points, faces, center=center)
        assert radii.dtype == dtype
        assert radii.shape == (40_000, 2)
        np.testing.assert_array_equal(radii, nf.triangle_radii(points[faces], center=center))
        # Rounded once to float32, a relative error of 6e-8; the float64 oracle has a smaller one.
        np.testing.assert_allclose(radii, numpy_radii(points[faces], center), rtol=1e-7, atol=1e-12)
        assert (radii[:, 0] <= radii[:, 1]).all()


def test_a_large_ground_triangle_has_radius_zero() -> None:
    ground = [[[-1e3, 0, -1e3], [1e3, 0, -1e3], [0, 0, 1e3]]]
    assert nf.triangle_radii(ground, center=(0, 50, 0))[0, 0] == 0.0
    # Just outside: the distance to the edge, not to a corner.
    assert nf.triangle_radii(ground, center=(0, 0, -1000.5))[0, 0] == 0.5


def test_walls_and_slivers_are_segments() -> None:
    wall = [[[-3, 0, 4], [3, 0, 4], [3, 9, 4]], [[10, 0, 10], [20, 0, 20], [20, 5, 20]], [[3, 0, 4]] * 3]
    np.testing.assert_array_equal(nf.triangle_radii(wall, center=(0, 0, 0))[:, 0], [4.0, math.sqrt(200), 5.0])
    # Slivers on lines through the axis: an inexact side test takes some of them for triangles around it.
    random = np.random.default_rng(3)
    direction = random.normal(size=(5000, 1, 2))
    along = random.uniform(10, 20, (5000, 3, 1)) * direction
    sliver = np.insert(along * (1 + random.integers(-2, 3, (5000, 3, 2)) * 2.0**-52), 1, 0, axis=2)
    radii = nf.triangle_radii(sliver, center=(0, 0, 0))
    corners = np.linalg.norm(sliver[..., [0, 2]], axis=2)
    # Corners were moved by up to four float64 steps, and the foot of the perpendicular may be too.
    np.testing.assert_allclose(radii[:, 0], corners.min(1), rtol=1e-14)


def test_radii_far_from_the_origin_keep_their_precision() -> None:
    near_zero = town(1)
    shift = np.array([2.0**23, 0.0, -(2.0**23)])
    here = nf.triangle_radii(near_zero.astype(np.float64), center=(0.5, 0, 0.25))
    there = nf.triangle_radii(near_zero + shift, center=shift + np.array([0.5, 0, 0.25]))
    # Adding 2²³ rounds the corners to 2⁻³⁰ m.
    np.testing.assert_allclose(there, here, atol=2e-9)


def test_triangles_without_faces_have_three_corners() -> None:
    with pytest.raises(ValueError, match=r"vertices: expected shape \(F, 3, 3\)"):
        nf.triangle_radii([[1, 2, 3]], None, center=(0, 0, 0))


def test_radii_of_no_triangles_are_empty() -> None:
    assert nf.triangle_radii(np.empty((0, 3, 3)), center=(0, 0, 0)).shape == (0, 2)
    assert nf.triangle_radii(np.zeros((5, 3)), np.empty((0, 3), np.uint32), center=(0, 0, 0)).shape == (0, 2)
