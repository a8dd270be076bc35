"""Tests of partition, radii and load curve against slow definitions."""

from __future__ import annotations

import math
import sys
import time
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
import trimesh
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

import nearfar as nf
from tests.support import data, need

SETS = ("near", "intermediate", "far", "nsf", "sf")


def exact_least_squared(triangle: Any, axis: tuple[Fraction, Fraction]) -> Fraction:
    """Squared least ρ in rational arithmetic: 0 if the axis pierces the triangle, else the nearest point of an edge."""
    points = [(Fraction(float(x)) - axis[0], Fraction(float(z)) - axis[1]) for x, _, z in triangle]
    pairs = [(points[i], points[(i + 1) % 3]) for i in range(3)]
    sides = [a[0] * b[1] - a[1] * b[0] for a, b in pairs]
    if all(s > 0 for s in sides) or all(s < 0 for s in sides):
        return Fraction(0)
    nearest = []
    for a, b in pairs:
        edge = (b[0] - a[0], b[1] - a[1])
        length = edge[0] ** 2 + edge[1] ** 2
        t = min(max(-(a[0] * edge[0] + a[1] * edge[1]) / length, Fraction(0)), Fraction(1)) if length else Fraction(0)
        nearest.append((a[0] + t * edge[0]) ** 2 + (a[1] + t * edge[1]) ** 2)
    return min(nearest)


def exact_radii(triangle: Any, center: Any) -> tuple[float, float]:
    axis = (Fraction(float(center[0])), Fraction(float(center[2])))
    greatest = max((Fraction(float(x)) - axis[0]) ** 2 + (Fraction(float(z)) - axis[1]) ** 2 for x, _, z in triangle)
    return math.sqrt(exact_least_squared(triangle, axis)), math.sqrt(greatest)


def numpy_radii(corners: NDArray[Any], center: Any) -> NDArray[np.float64]:
    """Least and greatest ρ in float64 arrays, for many triangles."""
    plan = corners[..., [0, 2]].astype(np.float64) - [center[0], center[2]]
    following = np.roll(plan, -1, axis=1)
    edge = following - plan
    length = (edge**2).sum(-1)
    t = np.clip(-(plan * edge).sum(-1) / np.where(length > 0, length, 1), 0, 1)
    distance = np.linalg.norm(plan + t[..., None] * edge, axis=-1).min(1)
    side = plan[..., 0] * following[..., 1] - plan[..., 1] * following[..., 0]
    inside = (side > 0).all(1) | (side < 0).all(1)
    return np.stack([np.where(inside, 0, distance), np.linalg.norm(plan, axis=-1).max(1)], axis=1)


def expected_sets(radii: NDArray[Any], r1: float, r2: float, moving: NDArray[np.bool_]) -> dict[str, NDArray[Any]]:
    least, greatest = radii.astype(np.float64).T
    near, far = least <= r1, least > r2
    masks = {
        "near": near,
        "intermediate": ~near & ~far,
        "far": far,
        "nsf": ~far | moving,
        "sf": (greatest > r2) & ~moving,
    }
    return {name: np.flatnonzero(mask) for name, mask in masks.items()}


def town(seed: int = 0, count: int = 400, size: float = 120.0) -> NDArray[np.float32]:
    """Walls, roofs, slivers, points and two large ground triangles around the middle."""
    random = np.random.default_rng(seed)
    corners = random.uniform(-size, size, (count, 1, 3)) + random.normal(0, 8, (count, 3, 3))
    corners[: count // 2, 2, [0, 2]] = corners[: count // 2, 1, [0, 2]]
    corners[:10] = corners[:10, :1]
    ground = [[[-500, 0, -500], [500, 0, -500], [500, 0, 500]], [[-500, 0, -500], [500, 0, 500], [-500, 0, 500]]]
    return np.concatenate([corners, ground]).astype(np.float32)


def soup(corners: NDArray[Any]) -> nf.Scene:
    return nf.Scene.from_arrays(corners.reshape(-1, 3), np.arange(3 * len(corners)).reshape(-1, 3))


# radii ---------------------------------------------------------------------------------------------------------------

grid = st.integers(-6, 6).map(lambda i: 0.5 * i)
free = st.floats(-1e4, 1e4, width=32)
corner = st.one_of(st.tuples(grid, grid, grid), st.tuples(free, free, free))


@given(st.lists(st.tuples(corner, corner, corner), min_size=1, max_size=70), corner)
def test_radii_against_fractions(triangles: list[Any], center: Any) -> None:
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
        # Rounded once to float32, which is 6e-8 of it; the oracle in float64 is off by less.
        np.testing.assert_allclose(radii, numpy_radii(points[faces], center), rtol=1e-7, atol=1e-12)
        assert (radii[:, 0] <= radii[:, 1]).all()


def test_a_large_ground_triangle_is_at_the_axis() -> None:
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


def test_far_from_the_origin_nothing_is_lost() -> None:
    near_zero = town(1)
    shift = np.array([2.0**23, 0.0, -(2.0**23)])
    here = nf.triangle_radii(near_zero.astype(np.float64), center=(0.5, 0, 0.25))
    there = nf.triangle_radii(near_zero + shift, center=shift + np.array([0.5, 0, 0.25]))
    # Adding 2²³ rounds the corners to 2⁻³⁰ m.
    np.testing.assert_allclose(there, here, atol=2e-9)


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (([[1, 2, 3]], None), r"vertices: expected shape \(F, 3, 3\)"),
        (([[1, 2]], [[0, 0, 0]]), r"vertices: expected shape \(N, 3\)"),
        (([[1, 2, 3]], [[0, 0]]), r"faces: expected shape \(N, 3\)"),
        (([[1, 2, 3]], [[0, 0, 1]]), "faces: expected vertex indices below 1"),
        (([[1, 2, 3]], [[0, 0, -1]]), "faces: expected whole numbers from 0"),
        (([[[1, 2, 3], [np.nan, 0, 0], [0, 0, 0]]], None), "vertices: expected finite"),
        (([[[1, 2, 3], [0, 0, -np.inf], [0, 0, 0]]], None), "vertices: expected finite"),
    ],
)
def test_bad_arrays_are_sentences(arguments: Any, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        nf.triangle_radii(*arguments, center=(0, 0, 0))


def test_no_triangles_have_no_radii() -> None:
    assert nf.triangle_radii(np.empty((0, 3, 3)), center=(0, 0, 0)).shape == (0, 2)
    assert nf.triangle_radii(np.zeros((5, 3)), np.empty((0, 3), np.uint32), center=(0, 0, 0)).shape == (0, 2)
    with pytest.raises(ValueError, match="center: expected 3 finite numbers"):
        nf.triangle_radii(np.empty((0, 3, 3)), center=(0, np.nan, 0))


# partition -----------------------------------------------------------------------------------------------------------


@given(st.integers(0, 100), st.floats(0, 60), st.floats(0.5, 100), st.floats(-80, 80))
def test_partition_against_radii(seed: int, r1: float, width: float, x: float) -> None:
    corners, r2, center = town(seed), r1 + width, (x, 3.0, -x / 2)
    scene = soup(corners)
    partition = nf.partition(scene, center=center, r1=r1, r2=r2)
    partition.validate()
    radii = nf.triangle_radii(scene.triangles(), center=np.subtract(center, scene.origin))
    expected = expected_sets(radii, r1, r2, np.zeros(len(corners), bool))
    for name in SETS:
        found = getattr(partition, name)
        assert found.dtype == np.int64
        np.testing.assert_array_equal(found, expected[name])
    counts = partition.summary()
    assert counts["near"] + counts["intermediate"] + counts["far"] == counts["triangles"] == len(corners)
    assert counts["nsf"] + counts["sf"] - counts["straddling"] == counts["triangles"]
    assert {name: counts[name] for name in SETS} == {name: len(expected[name]) for name in SETS}
    assert counts["measured"] <= counts["examined"] <= counts["triangles"]


def turned(x: float, z: float, angle: float, scale: float = 1.0) -> NDArray[np.float64]:
    matrix = np.eye(4)
    matrix[0, 0] = matrix[2, 2] = math.cos(angle) * scale
    matrix[0, 2], matrix[2, 0] = math.sin(angle) * scale, -math.sin(angle) * scale
    matrix[[0, 2], 3] = x, z
    return matrix


def forest(origin: float) -> nf.Scene:
    """A ground, trees as instances of one mesh, and a car that may move."""
    random = np.random.default_rng(4)
    loaded = trimesh.Scene()
    loaded.add_geometry(trimesh.creation.box((400, 1, 400)), "ground", transform=turned(origin, -origin, 0.1))
    loaded.add_geometry(trimesh.creation.icosphere(subdivisions=1), "tree", geom_name="tree")
    for i, (x, z) in enumerate(random.uniform(-150, 150, (60, 2))):
        placed = turned(origin + x, z - origin, random.uniform(0, 6), random.uniform(1, 6))
        loaded.graph.update(frame_to=f"tree_{i}", geometry="tree", matrix=placed)
    loaded.add_geometry(trimesh.creation.box((4, 1, 2)), "car", transform=turned(origin + 100, -origin, 0.5))
    return nf.Scene.from_trimesh(loaded).with_dynamic(["car"])


@pytest.mark.parametrize("origin", [0.0, 1e6])
def test_instances_divide_as_merged_geometry_does(origin: float) -> None:
    scene = forest(origin)
    corners = scene.triangles()
    merged = soup(corners)
    total, car = len(corners), 12
    moving = np.arange(total) >= total - car
    center = (origin + 3.0, 1.7, -origin)
    local = np.subtract(center, scene.origin)
    for r1, r2 in [(0.0, 10.0), (30.0, 50.0), (50.0, 200.0), (1.0, 1000.0)]:
        partition = nf.partition(scene, center=center, r1=r1, r2=r2)
        partition.validate()
        standing = nf.partition(merged, center=local, r1=r1, r2=r2)
        for name in ("near", "intermediate", "far"):
            np.testing.assert_array_equal(getattr(partition, name), getattr(standing, name))
        expected = expected_sets(nf.triangle_radii(corners, center=local), r1, r2, moving)
        for name in SETS:
            np.testing.assert_array_equal(getattr(partition, name), expected[name])
        assert nf.load_curve(scene, center=center).count(r2) == len(expected["nsf"])
    # At 30 and 50 m boxes decide most trees; only the others are examined.
    counts = nf.partition(scene, center=center, r1=30, r2=50).summary()
    assert counts["far_instances"] > 30
    assert 0 < counts["examined"] < total / 2
    assert counts["near_instances"] + counts["intermediate_instances"] + counts["far_instances"] + counts[
        "mixed_instances"
    ] == len(scene.object_names)


def test_moving_triangles_are_geometry_wherever_they_are() -> None:
    scene = forest(0.0)
    partition = nf.partition(scene, center=(0, 0, 0), r1=30, r2=50)
    car = np.arange(scene.triangle_count - 12, scene.triangle_count)
    assert np.isin(car, partition.nsf).all()
    assert np.isin(car, partition.far).all()
    assert not np.isin(car, partition.sf).any()
    here = scene.at({"car": np.eye(4)})
    assert np.isin(car, nf.partition(here, center=(0, 0, 0), r1=30, r2=50).near).all()
    assert nf.load_curve(scene, center=(0, 0, 0)).moving_count == 12


def test_all_near_and_all_far() -> None:
    scene = soup(town())
    everything = np.arange(scene.triangle_count)
    near = nf.partition(scene, center=(0, 0, 0), r1=1e4, r2=2e4)
    np.testing.assert_array_equal(near.nsf, everything)
    assert near.sf.size == 0
    assert near.summary()["examined"] == 0
    far = nf.partition(scene, center=(1e5, 0, 0), r1=10, r2=20)
    np.testing.assert_array_equal(far.sf, everything)
    assert far.nsf.size == 0
    assert far.summary()["examined"] == 0


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"r1": 50.0}, "r1: expected less than r2"),
        ({"r1": -3.0}, "r1: expected a radius of at least 0"),
        ({"r2": np.inf}, "r2: expected a finite number"),
        ({"center": (np.nan, 0, 0)}, "center: expected 3 finite numbers"),
        ({"center": 3.0}, "center: expected 3 numbers"),
    ],
)
def test_bad_radii_and_centres_are_sentences(change: dict[str, Any], sentence: str) -> None:
    arguments: dict[str, Any] = {"center": (0, 0, 0), "r1": 30.0, "r2": 50.0}
    with pytest.raises(ValueError, match=sentence):
        nf.partition(soup(town()), **(arguments | change))


def test_other_things_are_no_scenes() -> None:
    with pytest.raises(TypeError, match="scene: expected a Scene, got str"):
        nf.partition("city.glb", center=(0, 0, 0), r1=1, r2=2)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="scene: expected a Scene, got list"):
        nf.load_curve([], center=(0, 0, 0))  # type: ignore[arg-type]


def test_a_scene_without_triangles() -> None:
    empty = nf.Scene.from_arrays(np.zeros((3, 3)), np.empty((0, 3), np.uint32))
    partition = nf.partition(empty, center=(0, 0, 0), r1=1, r2=2)
    partition.validate()
    assert partition.nsf.size == partition.sf.size == 0
    curve = nf.load_curve(empty, center=(0, 0, 0))
    assert (curve.count(5.0), curve.radius(0)) == (0, math.inf)


# load curve ----------------------------------------------------------------------------------------------------------


@given(st.integers(0, 20), st.lists(st.floats(0, 200), min_size=1, max_size=20))
def test_counts_are_those_of_partitions(seed: int, radii: list[float]) -> None:
    scene = soup(town(seed))
    curve = nf.load_curve(scene, center=(1, 2, 3))
    counts = curve.count(radii)
    for r2, count in zip(radii, np.atleast_1d(counts), strict=True):
        assert curve.count(r2) == count
        if r2 > 0:
            assert nf.partition(scene, center=(1, 2, 3), r1=0, r2=r2).summary()["nsf"] == count


def test_radius_is_the_greatest_one_within_the_budget() -> None:
    curve = nf.load_curve(soup(town()), center=(0, 0, 0))
    at_axis = curve.count(0.0)
    budgets = np.arange(at_axis, curve.triangle_count)
    radii = np.asarray(curve.radius(budgets))
    assert (np.diff(radii) >= 0).all()
    assert (np.asarray(curve.count(radii)) <= budgets).all()
    assert (np.asarray(curve.count(np.nextafter(radii, np.inf))) > budgets).all()
    assert curve.radius(curve.triangle_count) == math.inf
    assert np.asarray(curve.radius(np.array([[at_axis, 10**9]]))).shape == (1, 2)
    with pytest.raises(
        ValueError, match="budget: expected at least 2: the triangles that move or lie on the axis, got 1"
    ):
        curve.radius(1)
    with pytest.raises(ValueError, match="r2: expected a radius of at least 0"):
        curve.count([1.0, -1.0])
    with pytest.raises(ValueError, match="r2: expected a radius of at least 0, got NaN"):
        curve.count(math.nan)
    with pytest.raises(TypeError, match="budget: expected whole numbers"):
        curve.radius(1.5)
    assert curve.count(math.inf) == curve.triangle_count


def test_a_thousand_budgets_take_less_than_a_millisecond() -> None:
    random = np.random.default_rng(0)
    curve = nf.load_curve(soup(random.normal(0, 300, (300_000, 3, 3)).astype(np.float32)), center=(0, 0, 0))
    budgets = random.integers(curve.count(0.0), curve.triangle_count, 1000)
    times = []
    for _ in range(20):
        start = time.perf_counter()
        curve.radius(budgets)
        times.append(time.perf_counter() - start)
    # Twenty probes each, some tens of microseconds; the best of many runs excludes other programs' time.
    assert min(times) < 1e-3


def test_plot_draws_the_curve() -> None:
    need("matplotlib")
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    curve = nf.load_curve(soup(town()), center=(0, 0, 0))
    axes = curve.plot()
    x, y = axes.lines[0].get_data()
    np.testing.assert_array_equal(y, curve.count(np.asarray(x)))
    assert np.asarray(y)[-1] == curve.triangle_count
    assert (axes.get_xscale(), axes.get_yscale(), len(axes.lines)) == ("log", "log", 3)
    assert curve.plot(axes, published=False) is axes
    assert len(axes.lines) == 5
    pyplot.close("all")
    nothing = nf.Scene.from_arrays(np.zeros((3, 3)), np.empty((0, 3), np.uint32))
    with pytest.raises(ValueError, match="expected a scene with standing triangles"):
        nf.load_curve(nothing, center=(0, 0, 0)).plot()


def test_plot_without_matplotlib_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(ImportError, match="plots need matplotlib: pip install"):
        nf.load_curve(soup(town()), center=(0, 0, 0)).plot()


# real cities ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("city", ["city/tokyo23/tokyo_core_lod1.glb", "city/manhattan_deckgl/manhattan_core.glb"])
def test_real_cities(city: str) -> None:
    scene = nf.Scene.load(data(city))
    low, high = scene.bounds
    center = (low + high) / 2
    corners, local = scene.triangles(), center - scene.origin
    radii = nf.triangle_radii(corners, center=local)
    # Float64 rounding of either form, and one of float32.
    np.testing.assert_allclose(radii, numpy_radii(corners, local), rtol=1e-7, atol=1e-9)
    curve = nf.load_curve(scene, center=center)
    for r1, r2 in [(30.0, 50.0), (300.0, 500.0), (1e3, 2e3)]:
        partition = nf.partition(scene, center=center, r1=r1, r2=r2)
        expected = expected_sets(radii, r1, r2, np.zeros(len(corners), bool))
        for name in SETS:
            np.testing.assert_array_equal(getattr(partition, name), expected[name])
        assert curve.count(r2) == len(expected["nsf"])
    random = np.random.default_rng(0).integers(0, len(corners), 200)
    for triangle, found in zip(corners[random], radii[random], strict=True):
        # Half a step of float32 is 6e-8 of a number.
        np.testing.assert_allclose(found, exact_radii(triangle, local), rtol=6e-8)
