"""Tests of nearest points against a search of all triangles."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from nearfar._scene.builder import SceneBuilder
from tests.support import printed_by_threads

Array = NDArray[np.float64]


def segment(a: Array, b: Array, p: Array) -> Array:
    """Squared distances of points (N, 1, 3) from segments (1, T, 3)."""
    edge = b - a
    length = (edge * edge).sum(-1)
    t = np.clip(((p - a) * edge).sum(-1) / np.where(length > 0, length, 1), 0, 1)
    return np.asarray((((a + t[..., None] * edge) - p) ** 2).sum(-1))


def oracle(triangles: NDArray[Any], points: Array) -> Array:
    """Squared distances (N, T): to the foot of the perpendicular if it lies inside, else to the edges."""
    a, b, c = (corner[None] for corner in triangles.astype(np.float64).transpose(1, 0, 2))
    p = points[:, None]
    normal = np.cross(b - a, c - a)
    area = (normal * normal).sum(-1)
    inside = area > 1e-20 * ((b - a) ** 2).sum(-1) * ((c - a) ** 2).sum(-1)
    for one, other in ((a, b), (b, c), (c, a)):
        inside = inside & ((np.cross(other - one, p - one) * normal).sum(-1) >= 0)
    plane = ((p - a) * normal).sum(-1) ** 2 / np.where(area > 0, area, 1)
    edges = np.minimum(np.minimum(segment(a, b, p), segment(b, c, p)), segment(c, a, p))
    return np.where(inside, plane, edges)


def places(triangles: NDArray[Any], found: nf.Nearest) -> Array:
    a, b, c = triangles[found.triangle_index].astype(np.float64).transpose(1, 0, 2)
    u, v = found.barycentric.T[:, :, None]
    return np.asarray(a + u * (b - a) + v * (c - a))


def check(scene: nf.Scene, points: Array, slack: float = 1e-12) -> None:
    """Check distances against float64 distances to the float32 triangles, up to some roundings, more for slivers."""
    triangles = scene.triangles().astype(np.float64)
    local = points - scene.origin
    squares = oracle(triangles, local)
    found = nf.nearest_points(scene, points)
    tolerance = slack * (np.abs(triangles).max() + np.abs(local).max())
    assert np.abs(found.distance - np.sqrt(squares.min(axis=1))).max() <= tolerance
    reached = np.linalg.norm(places(triangles, found) - local, axis=1)
    assert np.abs(reached - found.distance).max() <= tolerance
    weights = found.barycentric
    assert weights.min() >= -1e-12
    assert weights.sum(axis=1).max() <= 1 + 1e-12


def soup(random: np.random.Generator, count: int) -> tuple[Array, NDArray[np.uint32]]:
    """Triangles of many sizes; some are slivers, segments and points."""
    middle = random.normal(size=(count, 1, 3))
    corners = middle + random.normal(size=(count, 3, 3)) * 10 ** random.uniform(-3, 0, (count, 1, 1))
    corners[::7, 2] = corners[::7, 0] + (corners[::7, 1] - corners[::7, 0]) * 0.3 + 1e-6
    corners[::11, 2] = corners[::11, 1]
    corners[::13] = corners[::13, :1]
    return corners.reshape(-1, 3), np.arange(3 * count, dtype=np.uint32).reshape(-1, 3)


def test_triangle_soups_equal_brute_force() -> None:
    random = np.random.default_rng(1)
    for count in (1, 5, 40, 700):
        scene = nf.Scene.from_arrays(*soup(random, count))
        check(scene, random.normal(size=(300, 3)) * 2)
        check(scene, scene.triangles().reshape(-1, 3)[:200].astype(np.float64))
        check(scene, random.normal(size=(20, 3)) * 1e4, 1e-11)


def test_instances_are_searched_at_their_poses() -> None:
    random = np.random.default_rng(2)
    builder = SceneBuilder()
    mesh = builder.mesh(*soup(random, 60))
    for number in range(6):
        matrix = np.eye(4)
        matrix[:3, :3] = random.normal(size=(3, 3)) * (1, 0.2, 3)[number % 3]
        matrix[:3, 3] = random.normal(size=3) * 4
        builder.instance(mesh, matrix, name=f"part {number}")
    builder.instance(builder.mesh(*soup(random, 30)), name="standing")
    scene = builder.build(dynamic=["part 2"])
    assert scene._core.instance_count > 4
    check(scene, random.normal(size=(400, 3)) * 5)


def test_positions_far_from_the_origin_keep_their_precision() -> None:
    random = np.random.default_rng(3)
    vertices, faces = soup(random, 50)
    offset = np.array([4e6, 100, -3e6])
    scene = nf.Scene.from_arrays(vertices + offset, faces)
    assert np.abs(scene.origin - offset).max() < 10
    check(scene, random.normal(size=(100, 3)) + offset)


def test_only_triangles_that_face_a_direction_count() -> None:
    random = np.random.default_rng(4)
    scene = nf.Scene.from_arrays(*soup(random, 200))
    points, facing = random.normal(size=(200, 3)), random.normal(size=(200, 3)).astype(np.float32)
    triangles = scene.triangles().astype(np.float64)
    normal = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    squares = np.where(facing.astype(np.float64) @ normal.T > 0, oracle(triangles, points), np.inf)
    found = nf.nearest_points(scene, points, facing=facing)
    assert np.abs(found.distance - np.sqrt(squares.min(axis=1))).max() < 1e-12


def test_missing_neighbours_are_reported() -> None:
    scene = nf.Scene.from_arrays([[0, 0, 0], [0, 0, 1], [1, 0, 0]], [[0, 1, 2]])
    found = nf.nearest_points(scene, np.array([[0, 1, 0], [0.25, 2, 0.25]]), facing=np.array([[0, -1, 0], [0, 1, 0]]))
    assert found.triangle_index.tolist() == [-1, 0]
    assert found.distance.tolist() == [np.inf, 2.0]
    assert np.isnan(found.barycentric[0]).all()
    assert len(nf.nearest_points(scene, np.zeros((0, 3)))) == 0


def test_ties_are_resolved_by_the_lowest_triangle() -> None:
    corners = np.array([[0, 0, 0], [0, 0, 1], [1, 0, 0]], np.float32)
    stacked = np.concatenate([corners + np.array([0, height, 0]) for height in (2, -2, 2, -2)])
    scene = nf.Scene.from_arrays(stacked, np.arange(12).reshape(-1, 3))
    assert nf.nearest_points(scene, [[0.2, 0, 0.2], [0.3, -0.1, 0.3]]).triangle_index.tolist() == [0, 1]


def test_nearest_points_do_not_depend_on_threads() -> None:
    code = (
        "import numpy as np, nearfar as nf; r = np.random.default_rng(0);"
        "s = nf.Scene.from_arrays(r.normal(size=(3000, 3)), np.arange(3000).reshape(-1, 3));"
        "f = nf.nearest_points(s, r.normal(size=(20000, 3)));"
        "print(hash(f.distance.tobytes() and f.distance.sum()), f.triangle_index.sum(), f.barycentric.sum())"
    )
    assert len(printed_by_threads(code)) == 1


def test_an_empty_scene_has_no_nearest_point() -> None:
    scene = SceneBuilder().build()
    assert nf.nearest_points(scene, [[0, 0, 0]]).triangle_index.tolist() == [-1]
