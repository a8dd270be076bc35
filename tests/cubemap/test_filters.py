"""Tests of cubic look-ups, cones, mip chains and solid angles of cube maps against slow definitions."""

from __future__ import annotations

import itertools
from typing import Any, Literal

import numpy as np
import pytest
from hypothesis import given, strategies as st
from numpy.typing import NDArray

import nearfar as nf
from nearfar._cubemap.lookup import Filter, MipFilter
from tests.support import printed_by_threads

Array = NDArray[np.float64]


def unit(d: Array) -> Array:
    return np.asarray(d / np.linalg.norm(d, axis=-1, keepdims=True))


def smooth(d: Array) -> Array:
    d = unit(d)
    return np.asarray(np.sin(3 * d[..., 0] - d[..., 1]) + np.cos(2 * d[..., 2] + d[..., 1]))


def everywhere(size: int, count: int = 40_000) -> Array:
    """Return directions over the whole sphere, a quarter of them near edges, a quarter near corners."""
    d = np.random.default_rng(size).uniform(-1, 1, (count, 3))
    near = np.sign(d) + 4 * d / size
    d[::4] = near[::4]
    d[1::4, :2] = near[1::4, :2]
    return d


def from_edge(d: Array, size: int) -> Array:
    """Return the distance in texels from the nearest edge of the face that a direction hits."""
    ordered = np.sort(np.abs(d), axis=1)
    return np.asarray((1 - ordered[:, 1] / ordered[:, 2]) * size / 2)


def keys(s: float) -> Array:
    """Evaluate Keys' kernel for a = −1/2 at the distances of four texels, from its definition by intervals."""
    x = np.abs(np.array([s + 1, s, 1 - s, 2 - s]))
    inner = 1.5 * x**3 - 2.5 * x**2 + 1
    outer = -0.5 * x**3 + 2.5 * x**2 - 4 * x + 2
    return np.asarray(np.where(x <= 1, inner, outer))


def test_cubic_is_keys_interpolation_within_faces() -> None:
    size = 9
    rng = np.random.default_rng(0)
    faces = rng.uniform(-1, 1, (6, size, size, 2))
    for x, y in rng.uniform(1, size - 2, (50, 2)):
        u, v = ((p + 0.5) * 2 / size - 1 for p in (x, y))
        i, j = int(x), int(y)
        expected = np.einsum("j,i,jic->c", keys(y - j), keys(x - i), faces[4, j - 1 : j + 3, i - 1 : i + 3])
        # Coordinates of up to 9 texels in float64, times slopes of about 2.
        np.testing.assert_allclose(nf.cube_lookup(faces, (u, -v, 1), filter="cubic"), expected, atol=1e-13)


@pytest.mark.parametrize("size", [1, 2, 3, 4, 7])
def test_cubic_keeps_constants_and_texels(size: int) -> None:
    directions = everywhere(size, 2000)
    constant = nf.cube_lookup(np.full((6, size, size), 0.3), directions, filter="cubic")
    # 16 weights of which each is up to 16 others, all of size 1.
    np.testing.assert_allclose(constant, 0.3, rtol=0, atol=1e-14)
    faces = np.random.default_rng(size).uniform(-1, 1, (6, size, size))
    at_centers = nf.cube_lookup(faces, nf.envmap_directions(size), filter="cubic")
    # At these centres the neighbour face has no weight, and this face's other weights vanish.
    np.testing.assert_allclose(at_centers, faces, rtol=0, atol=1e-13)


def test_cubic_is_exact_for_quadratics_of_face_coordinates() -> None:
    size = 16
    d = nf.envmap_directions(size)
    u, v = d[4, ..., 0], -d[4, ..., 1]
    faces = np.zeros((6, size, size))
    faces[4] = 1 + 2 * u - v + u * u - 3 * u * v + 0.5 * v * v
    u, v = np.random.default_rng(0).uniform(-1 + 3 / size, 1 - 3 / size, (2, 1000))
    values = nf.cube_lookup(faces, np.stack([u, -v, np.ones(1000)], 1), filter="cubic")
    # Values up to 8, coordinates off by 2e-16 · 16.
    np.testing.assert_allclose(values, 1 + 2 * u - v + u * u - 3 * u * v + 0.5 * v * v, rtol=0, atol=1e-13)


def test_cubic_errors_at_seams_are_no_larger_and_fall_as_fast() -> None:
    worst = []
    for size in (8, 16, 32, 64, 128):
        faces, d = smooth(nf.envmap_directions(size)), everywhere(size)
        error = np.abs(nf.cube_lookup(faces, d, filter="cubic") - smooth(d))
        seam = from_edge(d, size) < 1.5
        corner = np.sort(np.abs(unit(d)), axis=1)[:, 0] > 0.57
        assert seam.sum() > 1000
        assert error[seam].max() <= error[~seam].max()
        assert error[corner].max() <= error[~seam].max()
        worst.append((error[~seam].max(), error[seam].max()))
    # Keys' interpolation has the third order: a factor of 8 per doubling. A border of the second order would give 4 at
    # seams.
    ratios = np.array(worst)[1:-1] / np.array(worst)[2:]
    assert (ratios > 6).all(), ratios


@given(st.integers(1, 12), st.integers(0, 2**32 - 1), st.sampled_from(["linear", "cubic"]))
def test_lookups_are_continuous(size: int, seed: int, name: Filter) -> None:
    rng = np.random.default_rng(seed)
    faces = rng.uniform(-1, 1, (6, size, size))
    d = everywhere(size + 1, 64) * rng.choice([-1, 1], (64, 3))
    d[:16, 0] = d[:16, 1]
    d[16:32] = np.sign(d[16:32])
    here = nf.cube_lookup(faces, d, filter=name)
    step = rng.normal(size=(64, 3)) * 1e-9 * np.abs(d).max(1, keepdims=True)
    # Slopes of up to 2 a texel, of size/2 texels a unit, two faces' weights that turn within half a texel, and what
    # lies beyond edges, which exceeds the texels by up to 4 times for faces of one or two texels.
    assert np.abs(nf.cube_lookup(faces, d + step, filter=name) - here).max() < 1e-7 * (size + 1)


def test_cubic_joins_faces_smoothly() -> None:
    """The slope is the same on both sides of an edge."""
    size = 16
    faces = np.random.default_rng(0).uniform(-1, 1, (6, size, size))
    angle, z = np.meshgrid(np.pi / 4 + np.array([-2e-4, -1e-4, 0, 1e-4, 2e-4]), np.linspace(-0.6, 0.6, 50))
    d = np.stack([np.cos(angle), np.sin(angle), z], -1)
    value = nf.cube_lookup(faces, d, filter="cubic")
    before, after = (value[:, 2] - value[:, 0]) / 2e-4, (value[:, 4] - value[:, 2]) / 2e-4
    # Second derivatives of about (16/2)² · 10 per unit of angle, over 2e-4; a break in the slope would be as large as
    # the slopes, 10.
    assert np.abs(before).max() > 5
    assert np.abs(after - before).max() < 0.3


def angles_to_texels(d: Array, size: int) -> Array:
    """Return the angle between a direction and each texel (6, S, S): 0 inside it, else to its nearest border point."""
    edges = np.arange(size + 1) * 2 / size - 1
    v, u = np.meshgrid(edges, edges, indexing="ij")
    one = np.ones_like(u)
    # The axes of the faces, in the orientation of Vulkan.
    corners = np.stack(
        [
            np.stack(p, -1)
            for p in ((one, -v, -u), (-one, -v, u), (u, one, v), (u, -one, -v), (u, -v, one), (-u, -v, -one))
        ]
    )
    p = [corners[:, :-1, :-1], corners[:, :-1, 1:], corners[:, 1:, 1:], corners[:, 1:, :-1]]
    d = unit(d)
    best = np.full((6, size, size), np.inf)
    inside = np.ones((6, size, size), bool)
    for a, b in zip(p, p[1:] + p[:1], strict=True):
        normal = unit(np.cross(a, b))
        height = normal @ d
        inside &= height * np.einsum("...k,...k", normal, p[0] + p[2]) >= 0
        foot = d - normal * height[..., None]
        between = (np.einsum("...k,...k", np.cross(a, foot), normal) >= 0) & (
            np.einsum("...k,...k", np.cross(foot, b), normal) >= 0
        )
        # The perpendicular may be as short as rounding; its angle is still valid.
        best = np.where(between, np.minimum(best, np.arctan2(np.abs(height), np.linalg.norm(foot, axis=-1))), best)
        for point in (a, b):
            best = np.minimum(best, np.arctan2(np.linalg.norm(np.cross(point, d), axis=-1), point @ d))
    return np.asarray(np.where(inside, 0.0, best))


@given(st.integers(1, 20), st.integers(0, 2**32 - 1), st.floats(0, 1.5), st.integers(0, 3))
def test_cones_contain_all_texels_that_they_touch(size: int, seed: int, radius: float, scale: int) -> None:
    check_cone(everywhere(size, 4)[seed % 4], size, radius * 0.1**scale, seed)


def check_cone(d: Array, size: int, radius: float, seed: int = 0) -> None:
    angles = angles_to_texels(d, size)
    faces = np.random.default_rng(seed).uniform(-1, 1, (6, size, size))
    # The documented tolerance, and the oracle's own rounding.
    surely, perhaps = faces[angles <= radius - 1e-13], faces[angles <= radius + 6.5e-8]
    least, greatest = (float(nf.cube_lookup(faces, d, filter=name, radius=radius)) for name in ("min", "max"))
    assert perhaps.min() <= least <= surely.min(initial=np.inf)
    assert surely.max(initial=-np.inf) <= greatest <= perhaps.max()


def check_every_texel(d: Array, size: int, radius: float) -> None:
    """Use one channel for each texel, so that no texel hides another."""
    angles = angles_to_texels(d, size).ravel()
    faces = np.eye(angles.size, dtype=np.float32).reshape(6, size, size, -1)
    taken = nf.cube_lookup(faces, d, filter="max", radius=radius) == 1
    assert taken[angles <= radius - 1e-13].all()
    assert not taken[angles > radius + 6.5e-8].any()


@pytest.mark.parametrize("below", [0.0, 1e-12, 1e-9, 6e-8, 6.3e-8, 6.4e-8, 7e-8, 1e-6])
def test_cones_of_almost_a_right_angle(below: float) -> None:
    radius = float(np.nextafter(np.pi / 2, 0)) - below
    rng = np.random.default_rng(0)
    in_planes = [rng.uniform(-2, 2, 3) * keep for keep in ((1, 1, 0), (1, 0, 1), (0, 1, 1)) for _ in range(2)]
    signs = [np.array(d, float) for d in itertools.product((-1, 0, 1), repeat=3) if any(d)]
    known = [(0, 1, 0.1), (-1.28164037, -0.837277, 0), (1.3, -1.27, 0), (1, 1e-8, 0), (1e-17, 1, 0), (1, 1, 1e-16)]
    for d in (*in_planes, *signs, *map(np.array, known), *rng.normal(size=(4, 3))):
        for size in (1, 3, 6):
            check_every_texel(d, size, radius)
        check_cone(d, 16, radius)


def test_cones_by_channel_in_both_types() -> None:
    size = 33
    faces = np.random.default_rng(0).uniform(-1, 1, (6, size, size, 3)).astype(np.float32)
    d = everywhere(size, 50).astype(np.float32)
    extremes: tuple[Filter, ...] = ("min", "max")
    for name, radius in itertools.product(extremes, (0.02, 0.9)):
        together = nf.cube_lookup(faces, d, filter=name, radius=radius)
        assert together.dtype == np.float32
        for channel in range(3):
            alone = nf.cube_lookup(faces[..., channel].astype(np.float64), d, filter=name, radius=radius)
            np.testing.assert_array_equal(together[:, channel], alone)


def test_a_cone_is_narrower_than_a_half_space() -> None:
    with pytest.raises(ValueError, match="radius: expected radians"):
        nf.cube_lookup(np.zeros((6, 2, 2)), (1, 0, 0), filter="max", radius=np.pi / 2)


def solid_angle(low: tuple[float, float], high: tuple[float, float]) -> float:
    """Return the solid angle of a rectangle on a face by Gauss–Legendre; 40 points leave an error of 1e-30."""
    x, w = np.polynomial.legendre.leggauss(40)
    u, v = ((b - a) / 2 * x + (a + b) / 2 for a, b in zip(low, high, strict=True))
    density = (1 + u[:, None] ** 2 + v**2) ** -1.5
    return float(w @ density @ w * (high[0] - low[0]) * (high[1] - low[1]) / 4)


@pytest.mark.parametrize("size", [1, 2, 3, 10, 64, 1000])
def test_solid_angles(size: int) -> None:
    angles = nf.cube_solid_angles(size)
    rng = np.random.default_rng(size)
    for row, column in {(0, 0), (size - 1, 0), (size // 2, size - 1), *map(tuple, rng.integers(0, size, (20, 2)))}:
        u, v = column * 2 / size - 1, row * 2 / size - 1
        expected = solid_angle((u, v), ((column + 1) * 2 / size - 1, (row + 1) * 2 / size - 1))
        # Corners are rounded to 1.1e-16, of which a texel's width 2/size keeps 1e-16 · size as a share.
        assert angles[row, column] == pytest.approx(expected, rel=2e-15 + 3e-16 * size)
    np.testing.assert_array_equal(angles, angles[::-1])
    np.testing.assert_array_equal(angles, angles.T)
    # Rounding of texels is independent, and NumPy adds pairwise.
    assert angles.sum() == pytest.approx(4 * np.pi / 6, rel=4e-16 + 2e-16 * np.log2(size))


def shares(size: int) -> Array:
    """Return coverage of each row of a level by each row of the next: (S', S, 2) positions −1..1, empty ones 0."""
    after = max(1, size // 2)
    low = np.maximum(np.arange(after)[:, None] * 2 / after, np.arange(size) * 2 / size)
    high = np.minimum((np.arange(after)[:, None] + 1) * 2 / after, (np.arange(size) + 1) * 2 / size)
    return np.stack([low - 1, np.maximum(low, high) - 1], -1)


@pytest.mark.parametrize("size", [2, 3, 5, 8, 11])
def test_mips_cover_what_they_should(size: int) -> None:
    faces = np.random.default_rng(size).uniform(-1, 1, (6, size, size, 2))
    part, after = shares(size), size // 2
    weight = np.zeros((after, after, size, size))
    for j, i, row, column in np.ndindex(weight.shape):
        v, u = part[j, row], part[i, column]
        if v[1] - v[0] > 1e-12 and u[1] - u[0] > 1e-12:
            weight[j, i, row, column] = solid_angle((u[0], v[0]), (u[1], v[1]))
    mean = np.einsum("jirk,frkc->fjic", weight, faces) / weight.sum((2, 3))[..., None]
    levels = nf.cube_mips(faces)
    assert levels[0] is faces
    # Shares of 9 pieces, each within a few roundings.
    np.testing.assert_allclose(levels[1], mean, rtol=0, atol=2e-15)
    extremes: dict[MipFilter, Any] = {"min": np.min, "max": np.max}
    for name, choose in extremes.items():
        found = nf.cube_mips(faces.astype(np.float32), filter=name)[1]
        for j, i in np.ndindex(after, after):
            covered = faces.astype(np.float32)[:, weight[j, i] > 0]
            np.testing.assert_array_equal(found[:, j, i], choose(covered, axis=1))
        for channel in range(2):
            alone = nf.cube_mips(faces[..., channel].astype(np.float32), filter=name)[1]
            np.testing.assert_array_equal(alone, found[..., channel])
    for channel in range(2):
        alone = nf.cube_mips(faces[..., channel])[1]
        np.testing.assert_allclose(alone, levels[1][..., channel], rtol=0, atol=1e-15)


@pytest.mark.parametrize("size", [1, 2, 37, 96])
def test_mips_keep_the_mean_over_the_sphere(size: int) -> None:
    faces = np.random.default_rng(size).uniform(-1, 1, (6, size, size))
    levels = nf.cube_mips(faces)
    assert [level.shape[1] for level in levels] == [max(1, size >> k) for k in range(size.bit_length())]
    means = [float((level * nf.cube_solid_angles(level.shape[1])).sum() / (4 * np.pi)) for level in levels]
    # Sums of 55,000 numbers below 1e-3, pairwise.
    np.testing.assert_allclose(means, means[0], rtol=0, atol=1e-15)


def test_mips_are_as_good_at_seams_as_inside() -> None:
    for level in nf.cube_mips(smooth(nf.envmap_directions(256)))[1:6]:
        size = level.shape[1]
        d = everywhere(size)
        error = np.abs(nf.cube_lookup(level, d, filter="linear") - smooth(d))
        seam = from_edge(d, size) < 0.5
        assert error[seam].max() <= error[~seam].max()
        # Second derivatives in both directions add up to 10 + 5. Texels of width 2/S are means, with an error of 1/24
        # of that times their squared width; interpolation adds 1/8.
        assert error.max() < 15 * (1 / 24 + 1 / 8) * (2 / size) ** 2


def test_mips_refuse() -> None:
    assert nf.cube_mips(np.zeros((6, 2, 2, 0)))[1].shape == (6, 1, 1, 0)
    assert nf.cube_mips(np.ones((6, 2, 2), np.int32))[1].dtype == np.float64
    np.testing.assert_array_equal(nf.cube_mips(np.ones((6, 2, 2), bool))[1], np.ones((6, 1, 1)))


def test_results_do_not_depend_on_threads() -> None:
    code = """
import hashlib, numpy as np, nearfar as nf
rng = np.random.default_rng(0)
faces, d = rng.uniform(size=(6, 37, 37, 3)), rng.normal(size=(50_000, 3))
results = [nf.cube_lookup(faces, d, filter=name) for name in ("nearest", "linear", "cubic", "min", "max")]
results += [nf.cube_lookup(faces, d[:2000], filter="max", radius=0.4), *nf.cube_mips(faces), nf.cube_solid_angles(37)]
results += [nf.convert_envmap(faces, source="cube", target="octahedral", size=99, samples=2)]
print([hashlib.sha256(r.tobytes()).hexdigest() for r in results])
"""
    assert len(printed_by_threads(code)) == 1


def with_nan(size: int, channels: int, share: float, seed: int) -> Array:
    rng = np.random.default_rng(seed)
    faces = rng.uniform(-1, 1, (6, size, size, channels))
    faces[rng.uniform(size=faces.shape) < 0.1] = rng.choice([-np.inf, np.inf])
    faces[rng.uniform(size=faces.shape) < share] = np.nan
    return faces


def extremum(values: Array, name: str) -> Array:
    """Return the minimum or maximum of rows (N, C), NaN if all are NaN, without NumPy's warning."""
    choose, nothing = (np.min, np.inf) if name == "min" else (np.max, -np.inf)
    found = choose(np.where(np.isnan(values), nothing, values), axis=0, initial=nothing)
    return np.asarray(np.where(np.isnan(values).all(axis=0), np.nan, found))


@given(
    st.integers(1, 16),
    st.sampled_from([1, 2, 3]),
    st.sampled_from([0.2, 0.9, 0.99, 1]),
    st.integers(0, 2**32 - 1),
    st.sampled_from(["min", "max"]),
)
def test_extremes_skip_nan(size: int, channels: int, share: float, seed: int, name: Literal["min", "max"]) -> None:
    faces = with_nan(size, channels, share, seed)
    texels = faces.reshape(-1, channels)
    d = everywhere(size, 8)
    # A face with a single texel keeps that texel's weight.
    weights = nf.cube_lookup(np.eye(len(texels)).reshape(6, size, size, -1), d, filter="linear")
    expected = np.array([extremum(texels[row > 0], name) for row in weights])
    np.testing.assert_array_equal(nf.cube_lookup(faces, d, filter=name), expected)
    for channel in range(channels):
        alone = nf.cube_lookup(faces[..., channel], d, filter=name)
        np.testing.assert_array_equal(alone, expected[:, channel])
    for radius in (0.01, 0.3, 1.2):
        inside = [angles_to_texels(way, size).ravel() <= radius for way in d]
        expected = np.array([extremum(texels[touched], name) for touched in inside])
        for kind in (np.float32, np.float64):
            found = nf.cube_lookup(faces.astype(kind), d, filter=name, radius=radius)
            np.testing.assert_array_equal(found, expected.astype(kind))
    while size > 1:
        part, after = shares(size), size // 2
        wide = part[..., 1] - part[..., 0] > 1e-12
        level = nf.cube_mips(faces, filter=name)[1]
        for j, i in np.ndindex(after, after):
            covered = faces[:, wide[j]][:, :, wide[i]].reshape(6, -1, channels).swapaxes(0, 1)
            np.testing.assert_array_equal(level[:, j, i], extremum(covered, name))
        for channel in range(channels):
            alone = nf.cube_mips(faces[..., channel], filter=name)[1]
            np.testing.assert_array_equal(alone, level[..., channel])
        faces, size = level, after


@pytest.mark.parametrize("name", ["min", "max"])
def test_nan_handling_does_not_depend_on_position(name: Filter) -> None:
    """A mirrored map, whose first texels are the last ones, gives the results of the mirrored cone."""
    for size, radius in itertools.product((4, 5, 16, 33), (None, 0.1, 0.9)):
        faces = with_nan(size, 1, 0.7, size)[..., 0]
        d = everywhere(size, 200)
        # A half turn about z: opposite faces except ±z change places, and all six turn by half.
        turned = faces[[1, 0, 3, 2, 4, 5], ::-1, ::-1]
        one = nf.cube_lookup(faces, d, filter=name, radius=radius)
        other = nf.cube_lookup(turned, d * (-1, -1, 1), filter=name, radius=radius)
        np.testing.assert_array_equal(one, other)
