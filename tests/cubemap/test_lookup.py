"""Tests of cube map lookups against independent slow definitions."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np
import pytest
from hypothesis import given, strategies as st
from hypothesis.extra import numpy as hnp
from numpy.typing import NDArray

import nearfar as nf
from nearfar._cubemap.lookup import Filter

FILTERS: tuple[Filter, ...] = ("nearest", "linear", "min", "max")
"""Filters whose values lie between those of texels."""

# Right and down of each face: Vulkan 1.3 specification, table "Cube map face selection".
AXES = {
    0: ((1, 0, 0), (0, 0, -1), (0, -1, 0)),
    1: ((-1, 0, 0), (0, 0, 1), (0, -1, 0)),
    2: ((0, 1, 0), (1, 0, 0), (0, 0, 1)),
    3: ((0, -1, 0), (1, 0, 0), (0, 0, -1)),
    4: ((0, 0, 1), (1, 0, 0), (0, -1, 0)),
    5: ((0, 0, -1), (-1, 0, 0), (0, -1, 0)),
}


def texel_points(size: int) -> dict[tuple[int, int, int], tuple[int, int, int]]:
    """Return centres of all texels on the cube of half edge `size`, which makes them integers."""
    points = {}
    for face, (normal, right, down) in AXES.items():
        for row, column in itertools.product(range(size), repeat=2):
            u, v = 2 * column + 1 - size, 2 * row + 1 - size
            x, y, z = (int(size * n + u * r + v * d) for n, r, d in zip(normal, right, down, strict=True))
            points[x, y, z] = (face, row, column)
    return points


def patches(size: int) -> list[list[tuple[int, int, int]]]:
    """Return quads and triangles between neighbouring texel centres: inside faces, across edges, at corners."""
    centers = range(1 - size, size, 2)
    signs = (-size, size)
    found: list[list[NDArray[np.int64]]] = []
    for axis in range(3):
        for sign, a, b in itertools.product(signs, centers[:-1], centers[:-1]):
            quad = [(sign, a, b), (sign, a + 2, b), (sign, a, b + 2), (sign, a + 2, b + 2)]
            found.append([np.roll(corner, axis) for corner in quad])
        for s, t, c in itertools.product((-1, 1), (-1, 1), centers[:-1]):
            rows = [(s * size, t * (size - 1)), (s * (size - 1), t * size)]
            strip = [(*rows[0], c), (*rows[1], c), (*rows[0], c + 2), (*rows[1], c + 2)]
            found.append([np.roll(corner, axis) for corner in strip])
    for octant in itertools.product((-1, 1), repeat=3):
        corner = np.array(octant)
        found.append([corner * (size - 1) + np.eye(3, dtype=int)[axis] * corner[axis] for axis in range(3)])
    return [[(int(x), int(y), int(z)) for x, y, z in patch] for patch in found]


def oracle(faces: NDArray[np.float64], direction: NDArray[np.float64]) -> float:
    """Find the patch that the direction passes through, and interpolate within it."""
    size = faces.shape[1]
    texels = texel_points(size)
    for patch in patches(size):
        p = np.array(patch, float)
        values = np.array([faces[texels[corner]] for corner in patch])
        if len(patch) == 3:
            weights = np.linalg.solve(p.T, direction)
            if weights.sum() > 0 and (weights / weights.sum() >= -1e-9).all():
                return float(weights @ values / weights.sum())
            continue
        # Newton's method for P(s, t) = k d, from the middle; eight steps suffice, because patches are nearly planar.
        unknown = np.array([0.5, 0.5, np.linalg.norm(p.mean(0)) / np.linalg.norm(direction)])
        for _ in range(8):
            s, t, k = unknown
            residual = mix(p, s, t) - k * direction
            ds, dt = mix(p, 1, t) - mix(p, 0, t), mix(p, s, 1) - mix(p, s, 0)
            jacobian = np.stack([ds, dt, -direction], 1)
            if abs(np.linalg.det(jacobian)) < 1e-12:
                break
            unknown = unknown - np.linalg.solve(jacobian, residual)
        s, t, k = unknown
        solved = np.abs(mix(p, s, t) - k * direction).max() < 1e-9 * size
        if solved and k > 0 and -1e-9 <= s <= 1 + 1e-9 and -1e-9 <= t <= 1 + 1e-9:
            return float(mix(values, s, t))
    raise AssertionError(f"no patch for {direction}")


def mix(corners: NDArray[np.float64], s: float, t: float) -> NDArray[np.float64]:
    weights = np.array([(1 - s) * (1 - t), s * (1 - t), (1 - s) * t, s * t])
    return np.asarray(weights @ corners)


@pytest.mark.parametrize("size", [1, 2, 3, 5])
def test_nearest_finds_every_texel(size: int) -> None:
    faces = np.arange(6.0 * size * size).reshape(6, size, size)
    points = texel_points(size)
    directions = np.array(list(points), float)
    expected = [faces[texel] for texel in points.values()]
    np.testing.assert_array_equal(nf.cube_lookup(faces, directions), expected)
    for kind in (np.int32, np.uint8, np.int16, np.int64, np.float32):
        found = nf.cube_lookup(faces.astype(kind), directions)
        assert found.dtype == kind
        np.testing.assert_array_equal(found, expected)
    swapped = nf.cube_lookup(faces.astype(">i4"), directions)
    assert swapped.dtype.isnative
    np.testing.assert_array_equal(swapped, expected)
    odd = nf.cube_lookup(faces.astype(np.int32) % 2 == 1, directions.astype(np.float32))
    np.testing.assert_array_equal(odd, np.array(expected) % 2 == 1)
    centers = nf.envmap_directions(size)
    np.testing.assert_array_equal(nf.cube_lookup(faces, centers), faces)
    # Weights are quotients of numbers of size 1: 1e-13 of values up to 150.
    np.testing.assert_allclose(nf.cube_lookup(faces, centers, filter="linear"), faces, rtol=0, atol=2e-11)


@pytest.mark.parametrize("size", [1, 2, 3, 4])
def test_linear_is_the_interpolation_within_patches(size: int) -> None:
    rng = np.random.default_rng(size)
    faces = rng.uniform(-1, 1, (6, size, size))
    directions = rng.normal(size=(60, 3))
    directions[:20, 1] = directions[:20, 0]
    directions[20:25] = np.sign(directions[20:25])
    expected = [oracle(faces, d) for d in directions]
    # The oracle solves for its weights to 1e-9.
    np.testing.assert_allclose(nf.cube_lookup(faces, directions, filter="linear"), expected, atol=1e-8)


def test_errors_at_seams_are_no_larger_than_inside() -> None:
    def smooth(d: NDArray[np.float64]) -> NDArray[np.float64]:
        d = d / np.linalg.norm(d, axis=-1, keepdims=True)
        return np.asarray(np.sin(3 * d[..., 0] - d[..., 1]) + np.cos(2 * d[..., 2] + d[..., 1]))

    size = 64
    faces = smooth(nf.envmap_directions(size))
    directions = np.random.default_rng(0).uniform(-1, 1, (200_000, 3))
    directions[:20_000] = np.sign(directions[:20_000]) + directions[20_000:40_000] / size
    error = np.abs(nf.cube_lookup(faces, directions, filter="linear") - smooth(directions))
    ordered = np.sort(np.abs(directions), axis=1)
    ratio = ordered[:, :2] / ordered[:, 2:]
    edge = ratio[:, 1] > 1 - 1 / size
    corner = ratio[:, 0] > 1 - 1 / size
    assert edge.sum() > 1000
    assert corner.sum() > 1000
    assert error[edge].max() <= error[~edge].max()
    assert error[corner].max() <= error[~edge].max()


@given(
    st.integers(1, 9),
    hnp.arrays(np.float64, (20, 3), elements=st.floats(-1, 1, allow_subnormal=False)),
    st.sampled_from([np.float32, np.float64]),
    st.sampled_from([np.float32, np.float64]),
)
def test_filters_agree_with_each_other(size: int, directions: NDArray[np.float64], kind: type, along: type) -> None:
    directions = directions[np.abs(directions).max(1) > 1e-3].astype(along)
    faces: NDArray[Any] = np.random.default_rng(size).uniform(0, 1, (6, size, size, 2)).astype(kind)
    result = {name: nf.cube_lookup(faces, directions, filter=name) for name in FILTERS}
    assert all(r.dtype == kind and r.shape == (len(directions), 2) for r in result.values())
    # The mean of float32 is computed in float64 and rounded once. Of float64 each of the four terms is rounded up to
    # seven times, by half an ulp: two weights, their product, its product with the value, and three sums. The least and
    # the greatest value leave out texels of a weight of at most 1e-10, up to three of the four.
    rounding = np.finfo(kind).eps if kind is np.float32 else 3.5 * np.finfo(kind).eps + 3e-10
    assert (result["min"] <= result["linear"] + rounding).all()
    assert (result["linear"] <= result["max"] + rounding).all()
    assert np.isin(result["nearest"], faces).all()


def test_ranges_with_infinity_do_not_become_nan() -> None:
    faces = np.full((6, 4, 4), np.inf, np.float32)
    faces[4] = 7
    directions = np.random.default_rng(1).normal(size=(1000, 3))
    for name in FILTERS:
        values = nf.cube_lookup(faces, directions, filter=name)
        assert np.isin(values, [7, np.inf]).all()


def test_shapes_follow_the_directions() -> None:
    faces = np.zeros((6, 2, 2, 3), np.float32)
    assert nf.cube_lookup(faces, (0, 0, 1)).shape == (3,)
    assert nf.cube_lookup(faces[..., 0], (0, 0, 1)).shape == ()
    assert nf.cube_lookup(np.zeros((6, 2, 2), np.int32), (0, 0, 1)).shape == ()
    assert nf.cube_lookup(faces, np.ones((4, 5, 3)), filter="linear").shape == (4, 5, 3)
    assert nf.cube_lookup(faces[..., 0], np.ones((4, 5, 3)), filter="max").shape == (4, 5)
    assert nf.cube_lookup(faces[..., 0], np.ones((0, 3))).shape == (0,)


def test_filters_that_do_not_fit_are_refused() -> None:
    with pytest.raises(ValueError, match="filter: expected 'nearest'"):
        nf.cube_lookup(np.zeros((6, 2, 2), np.int32), (1, 0, 0), filter="linear")
    with pytest.raises(ValueError, match="radius: expected None with filter 'linear'"):
        nf.cube_lookup(np.zeros((6, 2, 2)), (1, 0, 0), filter="linear", radius=0.1)
