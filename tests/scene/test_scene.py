"""Tests of scenes: merged, shared and moving meshes."""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, strategies as st
from numpy.typing import NDArray

import nearfar as nf
from nearfar._scene.builder import SceneBuilder
from tests.support.reduce_cases import place as shift

TRIANGLE = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], np.float32)
FACE = np.array([[0, 1, 2]], np.uint32)


def turn(angle: float) -> NDArray[np.float64]:
    matrix = np.eye(4)
    matrix[0, 0] = matrix[2, 2] = np.cos(angle)
    matrix[0, 2], matrix[2, 0] = np.sin(angle), -np.sin(angle)
    return matrix


def street() -> tuple[SceneBuilder, list[int]]:
    """A wall and a house placed once, three trees of one mesh, and a car."""
    builder = SceneBuilder()
    meshes = [builder.mesh(TRIANGLE, FACE, material=builder.material((r, 0, 0, 1))) for r in (0, 0.25, 0.5, 1)]
    builder.instance(meshes[0], name="wall")
    builder.instance(meshes[1], shift(5), name="house")
    builder.place_many(meshes[2], np.stack([shift(z=k) for k in range(3)]), "tree")
    builder.instance(meshes[3], shift(y=2), name="car")
    return builder, meshes


def test_handles_of_any_type_and_no_placements_are_accepted() -> None:
    builder = SceneBuilder()
    mesh = builder.mesh(TRIANGLE, FACE)
    builder.instance(np.uint64(mesh), name="a")  # type: ignore[arg-type]  # NumPy's numbers are accepted.
    builder.instance(mesh, shift(x=9), name="b")
    builder.place_many(mesh, np.zeros((0, 4, 4)), "none")
    assert builder.build().object_names == ("a", "b")


def test_meshes_used_once_are_merged_and_others_are_instances() -> None:
    scene = street()[0].build()
    assert scene.object_names == ("wall", "house", "tree_0", "tree_1", "tree_2", "car")
    assert (scene.report.instances, scene.report.meshes, scene.triangle_count) == (4, 2, 6)
    assert street()[0].build(["car"]).report.instances == 5
    np.testing.assert_array_equal(scene.bounds, [[0, 0, 0], [6, 3, 2]])


def test_moving_objects_are_separated_and_posed_in_the_world() -> None:
    scene = street()[0].build()
    moving = scene.with_dynamic(["car", "tree_1"])
    assert scene.report.dynamic == 0  # Scenes are immutable.
    assert (moving.report.dynamic, moving.triangle_count) == (2, scene.triangle_count)
    pose = shift(x=100) @ turn(0.3)
    posed = moving.at({"car": pose})
    car = posed.subset(objects=["car"]).triangles()[0]
    # The pose replaces the loaded transform: corners are the mesh's own, moved. One rounding to float32 at 100 m: 4e-6.
    np.testing.assert_allclose(car, TRIANGLE @ pose[:3, :3].T + pose[:3, 3], atol=4e-6)
    rest = ["wall", "house", "tree_0", "tree_1", "tree_2"]
    np.testing.assert_array_equal(posed.subset(objects=rest).triangles(), moving.subset(objects=rest).triangles())


@pytest.mark.parametrize("early", [False, True])
def test_merged_and_separate_objects_move_equally(early: bool) -> None:
    builder, _ = street()
    scene = builder.build(["house"]) if early else builder.build().with_dynamic(["house"])
    posed = scene.at({"house": shift(z=3)})
    # One rounding to float32 below 4 m is 1.2e-7.
    np.testing.assert_allclose(
        posed.subset(objects=["house"]).triangles()[0], TRIANGLE + np.array([0, 0, 3]), atol=1e-6
    )


def test_the_loaded_transform_restores_positions_bit_for_bit() -> None:
    scene = street()[0].build(["car", "house", "tree_2"])
    away = scene.at({name: shift(1, 2, 3) for name in ("car", "house", "tree_2")})
    back = away.at({name: scene.transform(name) for name in ("car", "house", "tree_2")})
    assert not np.array_equal(away.triangles(), scene.triangles())
    np.testing.assert_array_equal(back.triangles(), scene.triangles())


def test_poses_are_kept_until_replaced_and_survive_subsets() -> None:
    scene = street()[0].build(["car", "house"])
    posed = scene.at({"car": shift(y=50)}).at({"house": shift(y=60)}).with_dynamic(["wall"])
    tops = {name: posed.subset(objects=[name]).bounds[1, 1] for name in ("car", "house", "wall")}
    assert tops == {"car": 51, "house": 61, "wall": 1}
    assert posed.subset(objects=["house", "wall"]).at({"house": shift(y=5)}).bounds[1, 1] == 6
    kept = np.arange(posed.triangle_count) >= posed.triangle_count - 2
    assert posed.subset(triangles=kept).at({"wall": shift(y=7)}).bounds[1, 1] == 51  # The car.


def test_a_rigid_object_of_several_meshes_moves_as_one() -> None:
    builder = SceneBuilder()
    body, wheel = builder.mesh(TRIANGLE, FACE), builder.mesh(TRIANGLE, FACE)
    builder.instance(body, shift(10), name="cart")
    builder.instance(wheel, shift(11), name="cart")
    scene = builder.build(["cart"]).at({"cart": shift(y=1)})
    np.testing.assert_array_equal(scene.triangles()[:, 0], [[0, 1, 0], [1, 1, 0]])


def test_scenes_made_from_a_scene_share_meshes_and_trees() -> None:
    count = 60_000
    vertices = np.random.default_rng(0).uniform(0, 100, (count * 3, 3)).astype(np.float32)
    faces = np.arange(count * 3, dtype=np.uint32).reshape(-1, 3)
    owner = np.repeat(np.arange(100, dtype=np.int32), count // 100)
    scene = nf.Scene.from_arrays(vertices, faces, owner).with_dynamic(["object_7"])
    start = time.process_time()
    scene._core.build()
    built = time.process_time() - start
    others = [scene.at({"object_7": shift(5)}), scene.subset(objects=scene.object_names), scene.with_dynamic([])]
    for other in others:
        np.testing.assert_array_equal(other._core.mesh_ids(), scene._core.mesh_ids())
        start = time.process_time()
        other._core.build()
        # Trees over 60,000 triangles take hundredths of a second; to find an existing one takes microseconds.
        assert time.process_time() - start < built / 3


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda s: s.with_dynamic(["cat"]), "names: the scene has no object 'cat'; did you mean 'car'"),
        (lambda s: s.subset(objects=["tre_1"]), "did you mean 'tree_1'"),
    ],
)
def test_invalid_calls_of_scenes_are_errors(call: Callable[[nf.Scene], object], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        call(street()[0].build(["car"]))


@given(st.data())
def test_subsets_equal_numpy_selections(data: st.DataObject) -> None:
    scene = street()[0].build(["car"]).at({"car": shift(9)})
    numbers = data.draw(st.lists(st.integers(0, 5), unique=True))
    part = scene.subset(triangles=np.array(numbers, np.int64))
    np.testing.assert_array_equal(part.triangles(), scene.triangles()[sorted(numbers)])
    mask = np.isin(np.arange(6), numbers)
    np.testing.assert_array_equal(scene.subset(triangles=mask).triangles(), scene.triangles()[mask])
    assert part.object_names == scene.object_names
