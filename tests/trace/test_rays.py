"""Tests of rays against other tracers, at the seams between triangles, and with invalid input."""

from __future__ import annotations

import os
import signal
import threading
import time
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar import _core
from nearfar._base import data
from tests.support import need, printed_by_threads

SCENES = {
    "tokyo": "city/tokyo23/tokyo_core_lod1.glb",
    "garage": "interior/garage/garage.gltf",
    "helmet": "objects/gltf/FlightHelmet/FlightHelmet.gltf",
}
Mesh = tuple[NDArray[np.float32], NDArray[np.uint32]]


@pytest.fixture(scope="module", params=SCENES)
def mesh(request: pytest.FixtureRequest) -> Mesh:
    """Mesh with merged vertices, so that shared edges show in the faces."""
    need("data")
    corners = nf.Scene.load(data.require(SCENES[request.param])).triangles().reshape(-1, 3)
    _, first, inverse = np.unique((corners + 0.0).view("V12"), return_index=True, return_inverse=True)
    points, faces = corners[first], inverse.reshape(-1, 3).astype(np.uint32)
    distinct = (faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 2] != faces[:, 0])
    return points, np.ascontiguousarray(faces[distinct])


def rays_into(points: NDArray[np.float32], count: int, seed: int) -> tuple[NDArray[Any], NDArray[Any]]:
    """Origins in the bounds grown by half, random directions."""
    generator = np.random.default_rng(seed)
    low, high = points.min(0), points.max(0)
    origins = generator.uniform(low - (high - low) / 4, high + (high - low) / 4, (count, 3)).astype(np.float32)
    directions = generator.normal(size=(count, 3))
    return origins, (directions / np.linalg.norm(directions, axis=1, keepdims=True)).astype(np.float32)


def test_no_ray_aimed_at_shared_edges_and_vertices_is_lost(mesh: Mesh) -> None:
    # Per scene 20,000 rays: 12,000 at points of edges that two triangles share, half of them at midpoints, and
    # 8,000 at vertices whose triangles close a fan. The rays pass through the surface: each starts slightly before
    # its target and ends as far behind it, so that it can only hit something around it.
    points, faces = mesh
    targets, normals = shared_places(points, faces)
    generator = np.random.default_rng(4)
    lean = generator.normal(size=targets.shape)
    lean /= np.linalg.norm(lean, axis=1, keepdims=True)
    directions = normals + 0.3 * lean
    size = np.linalg.norm(points.max(0) - points.min(0))
    distance = 0.05 * size * generator.uniform(0.1, 1.0, (len(targets), 1))
    origins = (targets - distance * directions).astype(np.float32)
    # Directions to the float32 target, so that the ray meets the edge exactly.
    hits = nf.cast_rays(nf.Scene.from_arrays(points, faces), origins, targets - origins)
    reach = np.linalg.norm(targets - origins, axis=1)
    # A hit behind the target would mean that the ray passed through the surface. Interpolated targets lie off the edge
    # by the roundings of coordinates (2⁻²⁴ of the bounds), seen under 1/cos of the tilt at most.
    slack = 8 * 2.0**-24 * float(np.abs(points).max() + size)
    lost = ~(hits.t_hit <= reach + slack)
    assert len(targets) == 20_000
    assert np.count_nonzero(lost) == 0


def shared_places(points: NDArray[np.float32], faces: NDArray[np.uint32]) -> tuple[NDArray[Any], NDArray[Any]]:
    """12,000 points of shared edges and 8,000 vertices of closed fans, with a normal that all triangles there face."""
    generator = np.random.default_rng(3)
    corners = points[faces].astype(float)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    areas = np.linalg.norm(normals, axis=1, keepdims=True)
    # Slivers thinner than the roundings of their corners have no definite orientation.
    solid = areas[:, 0] > 1e-12
    normals = np.divide(normals, areas, out=np.zeros_like(normals), where=areas > 0)
    edges = np.sort(faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    owner = np.repeat(np.arange(len(faces)), 3)
    keys, group, count = np.unique(edges, axis=0, return_inverse=True, return_counts=True)
    order = np.argsort(group, kind="stable")
    first = np.concatenate([[0], np.cumsum(count)[:-1]])
    pairs = np.flatnonzero(count == 2)
    one, two = owner[order[first[pairs]]], owner[order[first[pairs] + 1]]
    # Seen from between both normals, the triangles lie on both sides of their edge, unless they fold back.
    facing = (np.einsum("ij,ij->i", normals[one], normals[two]) > 0.0) & solid[one] & solid[two]
    chosen = generator.choice(np.flatnonzero(facing), 12_000)
    weight = np.where(np.arange(12_000) % 2 == 0, 0.5, generator.uniform(0.02, 0.98, 12_000))[:, None]
    start, end = (points[keys[pairs[chosen], side]].astype(float) for side in (0, 1))
    on_edges = (start + weight * (end - start)).astype(np.float32)
    edge_normals = normals[one[chosen]] + normals[two[chosen]]
    # A closed fan: as many edges as triangles around, each edge shared by two, and all normals within 60° of their
    # mean, so that the fan covers the vertex from all sides as seen along it.
    open_edges = count[group] != 2
    is_open = np.zeros(len(points), bool)
    is_open[edges[open_edges]] = True
    is_open[faces[~solid]] = True
    mean = np.zeros(points.shape)
    np.add.at(mean, faces, normals[:, None])
    mean /= np.maximum(np.linalg.norm(mean, axis=1, keepdims=True), 1e-300)
    least = np.full(len(points), np.inf)
    np.minimum.at(least, faces, np.einsum("fj,fcj->fc", normals, mean[faces]))
    fans = np.flatnonzero(~is_open & np.isfinite(least) & (least > 0.5))
    # Two fans that touch at a vertex are two surfaces; around one fan the triangles wind once, by their angles.
    vertices = generator.choice(fans, 8_000)
    places = np.concatenate([on_edges, points[vertices]])
    directions = np.concatenate([edge_normals, mean[vertices]])
    return places, directions / np.linalg.norm(directions, axis=1, keepdims=True)


def test_hits_equal_embree(mesh: Mesh) -> None:
    need("embreex")
    points, faces = mesh
    origins, directions = rays_into(points, 200_000, 1)
    hits = nf.cast_rays(nf.Scene.from_arrays(points, faces), origins, directions)
    theirs = embree(points, faces).run(origins, directions, output=True)
    hit = theirs["primID"] >= 0
    # Embree is not watertight here and resolves ties by its own order: rays within float32 of an edge, of the
    # seam of two triangles or of a coplanar copy may differ. One in 5,000 is far more than was ever observed.
    assert np.count_nonzero(hits.hit != hit) <= 40
    both = hits.hit & hit
    size = float(np.abs(points).max())
    near = np.abs(hits.t_hit[both] - theirs["tfar"][both])
    # Grazing triangles amplify the roundings of coordinates, 2⁻²⁴ of the bounds, by 1/cos of the angle.
    assert np.quantile(near, 0.999) <= 1e-5 * size
    other = hits.triangle_index[both] != theirs["primID"][both]
    # Different triangles may be hit only at the same position: copies, and both sides of a seam.
    assert np.count_nonzero(other & (near > 1e-4 * size)) <= 40


def embree(points: NDArray[np.float32], faces: NDArray[np.uint32]) -> Any:
    from embreex import rtcore_scene
    from embreex.mesh_construction import TriangleMesh

    scene = rtcore_scene.EmbreeScene()
    TriangleMesh(scene, points, faces.astype(np.int32))
    return scene


def test_every_instruction_set_and_order_gives_the_same_bits(mesh: Mesh) -> None:
    points, faces = mesh
    scene = nf.Scene.from_arrays(points, faces)
    scattered, random = rays_into(points, 4_000, 2)
    step = np.stack(np.meshgrid(np.linspace(-0.4, 0.4, 64), np.linspace(-0.3, 0.3, 64)), -1).reshape(-1, 2)
    towards = np.column_stack([step, np.ones(len(step))]).astype(np.float32)
    eye = np.broadcast_to(np.asarray(points.mean(0), np.float32), towards.shape)
    origins, directions = np.concatenate([scattered, eye]), np.concatenate([random, towards])
    shuffled = np.random.default_rng(0).permutation(len(origins))
    results = []
    try:
        for name in _core.instruction_sets():
            _core.use_instruction_set(name)
            results.append(arrays(nf.cast_rays(scene, origins, directions)))
            back = np.argsort(shuffled)
            results.append([a[back] for a in arrays(nf.cast_rays(scene, origins[shuffled], directions[shuffled]))])
    finally:
        _core.use_instruction_set(_core.instruction_sets()[-1])
    for result in results[1:]:
        for expected, actual in zip(results[0], result, strict=True):
            assert expected.tobytes() == actual.tobytes()


def arrays(hits: nf.Hits) -> list[NDArray[Any]]:
    return [hits.t_hit, hits.triangle_index, hits.object_id, hits.barycentric]


def test_hits_have_the_same_bytes_for_any_number_of_threads() -> None:
    code = """
import hashlib, numpy as np, nearfar as nf
draw = np.random.default_rng(0)
scene = nf.Scene.from_arrays(draw.uniform(-1, 1, (3000, 3)), np.arange(3000).reshape(-1, 3))
hits = nf.cast_rays(scene, (0, 0, 0), draw.normal(size=(20000, 3)))
print(hashlib.sha256(hits.t_hit.tobytes() + hits.triangle_index.tobytes() + hits.barycentric.tobytes()).hexdigest())
"""
    assert len(printed_by_threads(code)) == 1


def square(z: float = 0.0) -> nf.Scene:
    return nf.Scene.from_arrays([[-1, -1, z], [1, -1, z], [1, 1, z], [-1, 1, z]], [[0, 1, 2], [0, 2, 3]])


def test_hits_report_their_fields() -> None:
    hits = nf.cast_rays(square(), [[0.5, -0.25, 2], [0.5, 3, 2]], [[0, 0, -4], [0, 0, -1]])
    assert len(hits) == 2
    assert hits.hit.tolist() == [True, False]
    assert hits.t_hit.tolist() == [2.0, np.inf]
    assert hits.triangle_index.tolist() == [0, -1]
    assert hits.object_id.tolist() == [0, -1]
    np.testing.assert_array_equal(hits.position, [[0.5, -0.25, 0], [np.nan] * 3])
    # The point is (1−u−v) a + u b + v c: exact in these halves and quarters.
    corners = square().triangles()[0].astype(float)
    u, v = hits.barycentric[0]
    np.testing.assert_array_equal((1 - u - v) * corners[0] + u * corners[1] + v * corners[2], hits.position[0])
    assert np.isnan(hits.barycentric[1]).all()


@pytest.mark.parametrize("dtype", [np.float32, np.float64, np.int64])
def test_all_number_types_and_a_common_origin_are_accepted(dtype: type) -> None:
    hits = nf.cast_rays(square(), np.array((0, 0, 3), dtype), np.array([[0, 0, -7]] * 9, dtype))
    assert (hits.t_hit == 3).all()


def test_directions_of_any_length() -> None:
    lengths = [1e-300, 1e-30, 1e-6, 1e6, 1e30, 1e300]
    hits = nf.cast_rays(square(), (0.25, 0.5, 3), [[0, 0, -length] for length in lengths])
    assert (hits.t_hit == 3).all()
    np.testing.assert_array_equal(hits.position, np.tile((0.25, 0.5, 0), (6, 1)))


def test_t_max_and_empty_input() -> None:
    directions = [[0, 0, -1]]
    assert nf.cast_rays(square(), (0, 0, 3), directions, t_max=3).hit.all()
    assert not nf.cast_rays(square(), (0, 0, 3), directions, t_max=2.99).hit.any()
    nothing = nf.cast_rays(square(), (0, 0, 3), np.empty((0, 3)))
    assert (len(nothing), nothing.position.shape) == (0, (0, 3))
    empty = nf.Scene.from_arrays(np.empty((0, 3)), np.empty((0, 3), np.uint32))
    assert not nf.cast_rays(empty, (0, 0, 3), directions).hit.any()


def test_world_positions_far_from_zero() -> None:
    # 4·10⁶ m have a step of 0.25 m in float32: only a float64 origin places the rays.
    shift = np.array((4e6, 0.0, -3e6))
    corners = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0.0]]) + shift
    hits = nf.cast_rays(
        nf.Scene.from_arrays(corners, [[0, 1, 2], [0, 2, 3]]), (*shift[:1] + 0.3, 0.2, shift[2] + 2), [[0, 0, -1]]
    )
    # Relative to the scene's origin everything is within metres: half a step of float32 there is 1.2e-7 m.
    np.testing.assert_allclose(hits.position - shift, [[0.3, 0.2, 0]], atol=5e-7)


def test_rays_without_a_direction_are_counted() -> None:
    with pytest.raises(ValueError, match=r"directions.*2 rows without.*index 1"):
        nf.cast_rays(square(), (0, 0, 0), [[0, 0, 1], [0, 0, 0], [0, 0, 0]])


def test_other_types_are_refused() -> None:
    with pytest.raises(ValueError, match="mmx"):
        _core.use_instruction_set("mmx")


@pytest.mark.slow
def test_control_c_stops_a_long_cast() -> None:
    draw = np.random.default_rng(0)
    scene = nf.Scene.from_arrays(draw.uniform(-1, 1, (60_000, 3)), np.arange(60_000).reshape(-1, 3))
    nf.cast_rays(scene, (0, 0, 0), [[0, 0, 1]])
    directions = draw.normal(size=(3_000_000, 3))
    start = time.process_time()
    nf.cast_rays(scene, np.zeros(3), directions[:30_000])
    hundredth = time.process_time() - start
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    start = time.process_time()
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        nf.cast_rays(scene, np.zeros(3), directions)
    # Interrupts are polled every 50 ms and a tile takes milliseconds: most of the work is never done.
    assert time.process_time() - start < 50 * hundredth


def test_twenty_thousand_copies_build_at_once() -> None:
    faces = np.tile(np.arange(3, dtype=np.uint32), (20_000, 1))
    start = time.process_time()
    hits = nf.cast_rays(nf.Scene.from_arrays([[-1, -1, 2], [2, -1, 2], [-1, 2, 2]], faces), (0, 0, 0), [[0, 0, 1]])
    # Clustering 20,000 equal boxes takes 25 CPU seconds; this takes milliseconds.
    assert time.process_time() - start < 5.0
    assert hits.triangle_index[0] == 0
