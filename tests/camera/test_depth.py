"""Tests of ranges from depth buffers against exact arithmetic, of matrices, and of the bound on rounding errors."""

from __future__ import annotations

import decimal
import math
from decimal import Decimal
from typing import Any

import numpy as np
import pytest
from hypothesis import given, strategies as st
from numpy.typing import NDArray

import nearfar as nf
from nearfar._camera.depth import GPU_FORMATS
from tests.support import printed_by_threads

Array = NDArray[Any]
decimal.getcontext().prec = 60

FOV = nf.Fov(-1.3, 0.9, -1.1, 1.2)
OFF_AXIS = nf.Fov(0.2, 1.7, -2.0, -0.5)
# Sixteen roundings of float64, as the docstring says, and one of float32.
DOUBLE, SINGLE = 16 * 2.0**-53, 2.0**-24 * (1 + 2.0**-20)

tangents = st.tuples(st.floats(-3, 1), st.floats(0.1, 2), st.floats(-3, 1), st.floats(0.1, 2)).map(
    lambda t: nf.Fov(t[0], t[0] + t[1], t[2], t[2] + t[3])
)
nears = st.floats(1e-3, 10)
fars = st.one_of(st.just(math.inf), st.floats(1.001, 1e7))
"""Distances of the far plane as multiples of near."""


def exact_depth(z: Any, near: float, far: float, reverse: bool) -> Any:
    """Return the exact depth at a distance along the axis, by the projections of graphics textbooks."""
    n, z = Decimal(near), Decimal(z)
    if math.isinf(far):
        return n / z if reverse else 1 - n / z
    f = Decimal(far)
    return n * (f - z) / ((f - n) * z) if reverse else f * (z - n) / ((f - n) * z)


def exact_distance(depth: Any, near: float, far: float, reverse: bool) -> Any:
    """Return the exact distance along the axis at a depth."""
    n, t = Decimal(near), Decimal(depth)
    if math.isinf(far):
        return n / t if reverse else n / (1 - t)
    f = Decimal(far)
    return n * f / (n + t * (f - n)) if reverse else n * f / (f - t * (f - n))


def exact_secant(fov: nf.Fov, row: int, column: int, height: int, width: int) -> Any:
    left, right, down, up = (Decimal(v) for v in (fov.left, fov.right, fov.down, fov.up))
    x = left + (right - left) * (column + Decimal("0.5")) / width
    y = up + (down - up) * (row + Decimal("0.5")) / height
    return (1 + x * x + y * y).sqrt()


def off(found: float, true: Any) -> float:
    return float(abs(Decimal(float(found)) / true - 1))


def matrix(fov: nf.Fov, near: float, far: float, *, reverse: bool, opengl: bool, sign: int) -> Array:
    """Return a projection matrix as programs build it, in float64: z is `sign` times the distance."""
    sx, sy = 2 / (fov.right - fov.left), 2 / (fov.up - fov.down)
    ox = (fov.right + fov.left) / (fov.right - fov.left)
    oy = (fov.up + fov.down) / (fov.up - fov.down)
    # Depth is g + h / distance.
    g, h = (1.0, -near) if math.isinf(far) else (far / (far - near), -far * near / (far - near))
    if reverse:
        g, h = 1 - g, -h
        if not math.isinf(far):
            g = -near / (far - near)
    if opengl:
        g, h = 2 * g - 1, 2 * h
    return np.array([[sx, 0, -sign * ox, 0], [0, sy, -sign * oy, 0], [0, 0, sign * g, h], [0, 0, sign, 0]])


# against exact arithmetic --------------------------------------------------------------------------------------------
@given(tangents, nears, fars, st.booleans(), st.integers(1, 150), st.integers(1, 4), st.integers(0, 2**32 - 1))
def test_ranges_equal_exact_arithmetic(
    fov: nf.Fov, near: float, far: float, reverse: bool, width: int, height: int, seed: int
) -> None:
    far *= near
    random = np.random.default_rng(seed)
    depth = random.uniform(0.0, 1.0, (height, width)) ** random.integers(1, 8)
    depth = depth if random.integers(2) else 1.0 - depth
    for dtype, allowed in ((np.float64, DOUBLE), (np.float32, SINGLE + DOUBLE)):
        stored = depth.astype(dtype)
        found = nf.range_from_depth(stored, fov, near=near, far=far, reverse=reverse)
        assert found.dtype == dtype
        for _ in range(6):
            row, column = int(random.integers(height)), int(random.integers(width))
            value = float(stored[row, column])
            if value == (0.0 if reverse else 1.0):
                assert found[row, column] == np.inf
                continue
            true = exact_distance(value, near, far, reverse) * exact_secant(fov, row, column, height, width)
            assert off(found[row, column], true) <= allowed


@given(nears, st.floats(1.001, 1e5), st.booleans(), st.integers(1, 70))
def test_parallel_rays_have_linear_depth(near: float, far: float, reverse: bool, width: int) -> None:
    far *= near
    depth = np.linspace(0, 1, 2 * width).reshape(2, width)
    view = nf.Orthographic(-3, 4, -2, 2)
    found = nf.range_from_depth(depth, view, near=near, far=far, reverse=reverse)
    share = 1 - depth if reverse else depth
    inside = share < 1
    np.testing.assert_allclose(found[inside], (near + share * (far - near))[inside], rtol=DOUBLE)
    assert np.isinf(found[~inside]).all()


@pytest.mark.parametrize("dtype", [np.uint16, np.uint32])
def test_integers_are_fractions_of_their_maximum(dtype: type) -> None:
    most = 2**16 - 1 if dtype is np.uint16 else 2**24 - 1
    stored: Array = np.array([[0, 1, most // 3, most - 1, most]], dtype)
    for reverse in (True, False):
        found = nf.range_from_depth(stored, FOV, near=0.5, far=80.0, reverse=reverse)
        assert found.dtype == np.float32
        for column, value in enumerate(stored[0].tolist()):
            if value == (0 if reverse else most):
                assert found[0, column] == np.inf
            else:
                distance = exact_distance(Decimal(value) / most, 0.5, 80.0, reverse)
                assert off(found[0, column], distance * exact_secant(FOV, 0, column, 1, 5)) <= SINGLE + DOUBLE


@pytest.mark.parametrize("dtype", [np.uint16, np.uint32, np.float32, np.float64])
def test_byte_order_changes_nothing(dtype: type) -> None:
    stored: Array = np.array([[0, 1, 1, 0]], dtype)
    expected = nf.range_from_depth(stored, FOV, near=0.5)
    for swapped in (stored.astype(stored.dtype.newbyteorder("<")), stored.astype(stored.dtype.newbyteorder(">"))):
        found = nf.range_from_depth(swapped, FOV, near=0.5)
        assert found.dtype == expected.dtype
        np.testing.assert_array_equal(found, expected)


def test_all_cube_faces_have_the_same_ranges() -> None:
    depth = np.random.default_rng(0).uniform(0.01, 1, (6, 9, 9)).astype(np.float32)
    found = nf.range_from_depth(depth, nf.CubeFace(0), near=0.1)
    for face in range(6):
        one = nf.range_from_depth(depth[face], nf.CubeFace(face), near=0.1)
        np.testing.assert_array_equal(found[face], one)
    np.testing.assert_array_equal(found, nf.range_from_depth(depth, nf.Fov(-1, 1, -1, 1), near=0.1))


# matrices ------------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("fov", [FOV, OFF_AXIS])
@pytest.mark.parametrize("reverse", [True, False])
@pytest.mark.parametrize("far", [math.inf, 300.0])
@pytest.mark.parametrize("opengl", [True, False])
@pytest.mark.parametrize("sign", [-1, 1])
def test_a_matrix_replaces_all_other_arguments(fov: nf.Fov, reverse: bool, far: float, opengl: bool, sign: int) -> None:
    near, depths = 0.1, "-1..1" if opengl else "0..1"
    rows = matrix(fov, near, far, reverse=reverse, opengl=opengl, sign=sign)
    z = np.geomspace(0.1001, 299.0, 90).reshape(9, 10)
    depth = np.vectorize(lambda z: float(exact_depth(z, near, far, reverse)))(z)
    found = nf.range_from_depth(depth, rows, depth_range=depths)
    # Entries and depths are rounded relative to 1, not to 1/z; at z that error is z/near times as large.
    np.testing.assert_allclose(
        found, nf.range_from_depth(depth, fov, near=near, far=far, reverse=reverse), rtol=16 * 2.0**-53 * 299 / 0.1
    )
    clear = np.full((2, 3), 0.0 if reverse else 1.0)
    assert np.isinf(nf.range_from_depth(clear, rows, depth_range=depths)).all()
    back = nf.depth_from_range(found, rows, depth_range=depths)
    np.testing.assert_allclose(back, depth, rtol=0, atol=1e-14)


def test_an_orthographic_matrix_is_accepted() -> None:
    near, far = 0.5, 20.0
    rows = np.array([[0.5, 0, 0, 0.1], [0, 0.25, 0, 0], [0, 0, -1 / (far - near), -near / (far - near)], [0, 0, 0, 1]])
    depth = np.linspace(0, 0.99, 12).reshape(3, 4)
    np.testing.assert_allclose(
        nf.range_from_depth(depth, rows, depth_range="0..1"), near + depth * (far - near), rtol=1e-14
    )
    flipped = rows * [1, 1, -1, 1]
    np.testing.assert_allclose(
        nf.range_from_depth(depth, flipped, depth_range="0..1"), near + depth * (far - near), rtol=1e-14
    )


def test_a_matrix_with_a_far_plane_beyond_infinity() -> None:
    """Depth is shifted towards the eye, so that nothing at infinity is clipped (Lengyel's 2⁻²²)."""
    rows = matrix(FOV, 0.1, math.inf, reverse=False, opengl=False, sign=-1)
    rows[2, 2] += 2.0**-22
    depth = np.array([[0.5, 1 - 2.0**-22, 1 - 2.0**-23, 1.0]])
    found = nf.range_from_depth(depth, rows, depth_range="0..1")
    assert np.isfinite(found[0, 0])
    assert np.isinf(found[0, 1:]).all()


# back, and beside the renderer ---------------------------------------------------------------------------------------
@given(tangents, nears, fars, st.booleans(), st.integers(0, 2**32 - 1))
def test_depth_and_range_are_inverse(fov: nf.Fov, near: float, far: float, reverse: bool, seed: int) -> None:
    far *= near
    depth = np.random.default_rng(seed).uniform(0, 1, (3, 80))
    depth[:, :2] = 0, 1
    planes: dict[str, Any] = {"near": near, "far": far, "reverse": reverse}
    found = nf.range_from_depth(depth, fov, **planes)
    back = nf.depth_from_range(found, fov, **planes)
    # Inverse distances are rounded relative to 1/near.
    np.testing.assert_allclose(back, depth, rtol=0, atol=64 * 2.0**-53 / (1 - near / far))
    assert nf.depth_from_range(found.astype(np.float32), fov, **planes).dtype == np.float32


def test_ranges_of_a_rendered_scene_are_recovered() -> None:
    scene = nf.datasets.room()
    camera = nf.Camera.look_at((0.3, 1.6, 0.2), (2, 1.2, -3), fov=FOV, size=(160, 120))
    frame = nf.render(scene, camera, channels=("range",))
    ranges = frame.range
    assert ranges is not None
    near = 0.01
    depth = nf.depth_from_range(ranges, FOV, near=near)
    back = nf.range_from_depth(depth, FOV, near=near)
    seen = np.isfinite(ranges)
    np.testing.assert_array_equal(np.isfinite(back), seen)
    # Two roundings to float32: of the depth and of the range.
    np.testing.assert_allclose(back[seen], ranges[seen], rtol=2 * SINGLE)
    # `Camera.project` returns the distance along the axis as depth.
    _, directions = camera.rays()
    points = np.array(camera.position) + directions * np.where(seen, ranges, 1.0)[..., None]
    along = camera.project(points.reshape(-1, 3))[:, 2].reshape(seen.shape)
    np.testing.assert_allclose(depth[seen], near / along[seen], rtol=4 * SINGLE)


def test_beyond_the_far_plane_nothing_is_drawn() -> None:
    view = nf.Fov(-1e-9, 1e-9, -1e-9, 1e-9)
    ranges = np.array([[1.0, 5.0, 10.0, 11.0, np.inf]])
    for reverse, clear in ((True, 0.0), (False, 1.0)):
        depth = nf.depth_from_range(ranges, view, near=1.0, far=10.0, reverse=reverse)
        assert depth[0, 0] == 1.0 - clear
        assert 0.0 < depth[0, 1] < 1.0
        np.testing.assert_array_equal(depth[0, 2:], clear)


# what rounding costs -------------------------------------------------------------------------------------------------
def stored(depth: Any, depth_format: str) -> Array:
    """Return an exact depth rounded once to the nearest value of a format."""
    if depth_format == "float32":
        # The conversion through float64 may round twice, an error of 2⁻²⁹ of a step.
        return np.array([[float(depth)]], np.float32)
    most = 2 ** int(depth_format.removeprefix("uint")) - 1
    return np.array([[int((depth * most).to_integral_value())]], np.uint16 if depth_format == "uint16" else np.uint32)


AXIS = nf.Fov(-1e-9, 1e-9, -1e-9, 1e-9)


@pytest.mark.parametrize("depth_format", GPU_FORMATS)
@pytest.mark.parametrize("reverse", [True, False])
@pytest.mark.parametrize(("near", "far"), [(0.1, math.inf), (0.1, 1e4), (0.01, math.inf), (1.0, 2e4)])
def test_the_bound_holds_and_is_tight(depth_format: str, reverse: bool, near: float, far: float) -> None:
    """Distances from 0.1 m to 10 km."""
    random = np.random.default_rng(1)
    for middle in np.geomspace(max(near, 0.1) * 1.1, 9e3, 12):
        worst, bound = 0.0, 0.0
        for z in middle * random.uniform(0.95, 1.05, 60):
            allowed = float(nf.range_error(z, near=near, far=far, reverse=reverse, depth_format=depth_format))
            kept = stored(exact_depth(z, near, far, reverse), depth_format)
            found = float(nf.range_from_depth(kept, AXIS, near=near, far=far, reverse=reverse)[0, 0])
            error = abs(found - z)
            assert error <= allowed
            if math.isfinite(error):
                worst, bound = max(worst, error), max(bound, allowed if math.isfinite(allowed) else 0.0)
        # A factor of 2 for float32's steps, which double within the interval, and a margin, because sixty distances may
        # miss the worst one. Where the error approaches the distance, too few depths are left.
        if worst and bound < 0.05 * middle:
            assert bound <= 2.6 * worst, middle


@given(nears, fars, st.booleans(), st.sampled_from(GPU_FORMATS), st.floats(0, 1))
def test_the_bound_holds_for_any_planes(
    near: float, far: float, reverse: bool, depth_format: str, share: float
) -> None:
    far *= near
    # Evenly spread in the logarithm, up to a million times the near plane if there is no far plane.
    z = min(near * (1e6 if math.isinf(far) else far / near) ** share, far)
    z = max(z, near)
    allowed = float(nf.range_error(z, near=near, far=far, reverse=reverse, depth_format=depth_format))
    kept = stored(exact_depth(z, near, far, reverse), depth_format)
    found = float(nf.range_from_depth(kept, AXIS, near=near, far=far, reverse=reverse)[0, 0])
    assert abs(found - z) <= allowed


def test_the_bound_has_the_published_orders() -> None:
    z = np.geomspace(0.1, 1e4, 200)
    reverse = nf.range_error(z, near=0.1) / z
    assert (reverse <= 2 * 2.0**-24 * 1.001).all()
    standard = nf.range_error(z, near=0.1, reverse=False)
    half = z > 0.2  # depth above 1/2, where steps are 2⁻²⁴
    np.testing.assert_allclose(standard[half], z[half] ** 2 / 0.1 * 2.0**-25 + z[half] * 2.0**-24, rtol=1e-2)
    # With a 16-bit depth buffer, 0.1 m … infinity ends at 13 km.
    assert np.isinf(nf.range_error(0.1 * 2.0**17, near=0.1, depth_format="uint16"))
    assert nf.range_error([], near=0.1).shape == (0,)


# arguments -----------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("value", [math.nan, -1e-9, 1.0000001, math.inf])
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_values_beyond_0_and_1_are_refused(value: float, dtype: type) -> None:
    depth: Array = np.full((2, 70, 100), 0.5, dtype)
    depth[1, 69, 99] = value
    with pytest.raises(ValueError, match=r"depth: expected values from 0 to 1, got .* row 69"):
        nf.range_from_depth(depth, FOV, near=0.1)


@pytest.mark.parametrize("kind", [np.float16, np.longdouble, np.uint8, np.int8, np.int32, np.int64, np.uint64, bool])
def test_integer_types_without_a_defined_maximum_are_refused(kind: type) -> None:
    words = "depth: expected float32, float64, uint16 or uint32, got "
    if np.dtype(kind) == np.float64:
        pytest.skip("long double is float64 here")
    with pytest.raises(TypeError, match=words):
        nf.range_from_depth(np.ones((2, 3), kind), FOV, near=0.1)
    assert nf.range_from_depth([[1.0, 0.5]], FOV, near=0.1).dtype == np.float64


def test_bounds_are_for_distances_between_the_planes() -> None:
    with pytest.raises(ValueError, match="distance: expected 1 to 10 metres"):
        nf.range_error([0.5, 2.0], near=1.0, far=10.0)


def test_threads_change_nothing() -> None:
    code = """
import hashlib
import numpy as np
import nearfar as nf
depth = np.random.default_rng(0).uniform(0, 1, (3, 301, 403)).astype(np.float32)
found = nf.range_from_depth(depth, nf.Fov(-1, 1.5, -1, 1), near=0.1, far=500.0)
print(hashlib.sha256(found.tobytes()).hexdigest())
"""
    assert len(printed_by_threads(code)) == 1
