"""Tests of scenes from arrays: borrowed, converted and refused arrays, and memory."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, strategies as st
from numpy.typing import NDArray

import nearfar as nf
from nearfar._scene.builder import SceneBuilder
from tests.support import need
from tests.support.thread_counts import output_of


def soup(count: int, seed: int = 0) -> tuple[NDArray[np.float32], NDArray[np.uint32]]:
    """Return `count` triangles within 100 m, no two of which share a vertex."""
    vertices = np.random.default_rng(seed).uniform(-100, 100, (3 * count, 3)).astype(np.float32)
    return vertices, np.arange(3 * count, dtype=np.uint32).reshape(-1, 3)


def test_arrays_of_the_right_types_are_borrowed_and_frozen() -> None:
    vertices, faces = soup(10)
    owner = np.arange(10, dtype=np.int32)
    scene = nf.Scene.from_arrays(vertices, faces, owner)
    np.testing.assert_array_equal(scene.triangles(), vertices[faces])
    for array in (vertices, faces, owner):
        assert not array.flags.writeable
    # A write behind the scene's back shows that the memory is shared.
    before = vertices[0, 0]
    vertices.setflags(write=True)
    vertices[0, 0] = 55
    assert scene.triangles()[0, 0, 0] == 55 != before


def test_copies_do_not_change_the_arrays() -> None:
    vertices, faces = soup(10)
    owner = np.arange(10, dtype=np.int32)
    scene = nf.Scene.from_arrays(vertices, faces, owner, copy=True)
    vertices[:] = 0
    faces[:] = 0
    owner[:] = 0
    assert scene.triangles().any()
    assert scene.subset(objects=["object_9"]).triangle_count == 1


@pytest.mark.parametrize("kind", [np.float32, np.float64, np.float16])
@pytest.mark.parametrize("order", ["C", "F"])
@pytest.mark.parametrize("whole", [np.uint8, np.int32, np.int64, np.uint64])
def test_other_types_and_layouts_are_converted(kind: type, order: Any, whole: type) -> None:
    vertices, faces = soup(10)
    given_vertices: NDArray[Any] = np.asarray(vertices.astype(kind), order=order)
    scene = nf.Scene.from_arrays(given_vertices, np.asarray(faces.astype(whole), order=order))
    np.testing.assert_array_equal(scene.triangles(), given_vertices.astype(np.float32)[faces])


def test_slices_and_lists_are_accepted() -> None:
    vertices, faces = soup(10)
    wide = np.concatenate([vertices, vertices], axis=1)
    np.testing.assert_array_equal(nf.Scene.from_arrays(wide[:, :3], faces[::2]).triangles(), vertices[faces[::2]])
    assert nf.Scene.from_arrays(vertices.tolist(), faces.tolist()).triangle_count == 10


def test_an_empty_scene_is_valid() -> None:
    scene = nf.Scene.from_arrays(np.zeros((0, 3)), np.zeros((0, 3), int))
    assert (scene.triangle_count, scene.triangles().shape) == (0, (0, 3, 3))
    assert np.isposinf(scene.bounds[0]).all()
    assert SceneBuilder().build().triangle_count == 0
    assert nf.Scene.from_arrays(*soup(3)).subset(objects=[]).triangle_count == 0


@given(st.lists(st.integers(-1, 3), min_size=1, max_size=300))
def test_objects_are_found_in_every_face_order(owner: list[int]) -> None:
    vertices, faces = soup(len(owner))
    scene = nf.Scene.from_arrays(vertices, faces, owner, object_names=["a", "b", "c", "d"])
    for number, name in enumerate(scene.object_names):
        mine = np.array(owner) == number
        np.testing.assert_array_equal(scene.subset(objects=[name]).triangles(), vertices[faces[mine]])


@pytest.mark.parametrize("offset", [(1e7, 0, -2.5e7), (40_000, 0, 0)])
def test_far_coordinates_keep_their_digits(offset: tuple[float, float, float]) -> None:
    vertices, faces = soup(100)
    world = vertices.astype(np.float64) + offset
    scene = nf.Scene.from_arrays(world, faces)
    np.testing.assert_array_equal(scene.origin, np.rint(scene.bounds.mean(axis=0)))
    # Coordinates within 100 m of the origin: half a float32 step is 4e-6 m; as float32 they would be off by 1 m.
    np.testing.assert_allclose(scene.triangles() + scene.origin, world[faces], rtol=0, atol=4e-6)
    np.testing.assert_allclose(scene.bounds, [world.min(axis=0), world.max(axis=0)], rtol=0, atol=4e-6)


def test_far_float32_coordinates_are_exact() -> None:
    vertices, faces = soup(100)
    far = vertices + np.float32(1e6)
    scene = nf.Scene.from_arrays(far, faces)
    # Differences of neighbouring float32 numbers, and an origin in whole metres, are float32 numbers.
    np.testing.assert_array_equal(scene.triangles() + scene.origin, far[faces].astype(np.float64))


def test_unused_vertices_do_not_affect_bounds() -> None:
    vertices, faces = soup(4)
    builder = SceneBuilder()
    stray = builder.mesh(np.concatenate([vertices, np.full((1, 3), 9e4, np.float32)]), faces)
    angle = np.deg2rad(45)
    matrix = np.array(
        [[np.cos(angle), 0, np.sin(angle), 3], [0, 1, 0, 0], [-np.sin(angle), 0, np.cos(angle), 0], [0, 0, 0, 1.0]]
    )
    builder.place_many(stray, np.stack([matrix, np.eye(4)]), "thing")
    scene = builder.build()
    np.testing.assert_array_equal(scene.origin, 0)
    corners = vertices.astype(np.float64) @ matrix[:3, :3].T + matrix[:3, 3]
    # Float32 of at most 200 m: half a step is 8e-6 m. A rotated box of the mesh would be 40 % too large.
    turned = scene.subset(objects=["thing_0"]).bounds
    np.testing.assert_allclose(turned, [corners.min(axis=0), corners.max(axis=0)], rtol=0, atol=8e-6)


def test_far_transforms_keep_the_digits_of_near_meshes() -> None:
    vertices, faces = soup(5)
    builder = SceneBuilder()
    far = np.eye(4)
    far[:3, 3] = 1e7, 5, -1e7
    for name in ("standing", "moving"):
        builder.instance(builder.mesh(vertices, faces), far, name=name)
    scene = builder.build(["moving"])
    there = np.eye(4)
    there[:3, 3] = 1e7 + 200.125, 5, -1e7
    posed = scene.at({"moving": there})
    world = vertices[faces].astype(np.float64) + np.array([1e7, 5, -1e7])
    # Within 400 m of the origin half a float32 step is 1.5e-5 m.
    np.testing.assert_allclose(posed.triangles()[:5] + scene.origin, world, rtol=0, atol=2e-5)
    np.testing.assert_allclose(
        posed.triangles()[5:] + scene.origin, world + np.array([200.125, 0, 0]), rtol=0, atol=2e-5
    )
    # Posing never moves the origin.
    np.testing.assert_array_equal(posed.origin, scene.origin)


def test_coordinates_within_the_limit_have_no_origin() -> None:
    vertices, faces = soup(5)
    vertices[0] = 32_767, 0, 0
    scene = nf.Scene.from_arrays(vertices, faces)
    np.testing.assert_array_equal(scene.origin, 0)
    np.testing.assert_array_equal(scene.triangles(), vertices[faces])


MEMORY = """
import numpy as np, nearfar as nf
def kilobytes(key):
    return int(next(line for line in open("/proc/self/status") if line.startswith(key)).split()[1])
def arrays(count):  # Buildings of 17 triangles, as in Tokyo.
    vertices = np.random.default_rng(0).uniform(-1e4, 1e4, (count * 3 // 4, 3)).astype(np.float32)
    faces = np.random.default_rng(1).integers(0, len(vertices), (count, 3), np.uint32)
    return vertices, faces, (np.arange(count) // 17).astype(np.int32)
nf.Scene.from_arrays(*arrays(10_000)).bounds  # Threads and libraries are not the scene's.
given = arrays(3_000_000)
open("/proc/self/clear_refs", "w").write("5")
before = kilobytes("VmRSS")
scene = nf.Scene.from_arrays(*given)
scene.bounds, scene.triangle_count, scene.origin
size = sum(array.nbytes for array in given) / 1024
print((kilobytes("VmHWM") - before + size) / size)
"""


def test_a_scene_of_large_arrays_takes_little_memory_besides() -> None:
    need("linux")
    # The documented limit is 1.5 times the arrays' memory, including the arrays.
    assert float(output_of(MEMORY)) < 1.5
