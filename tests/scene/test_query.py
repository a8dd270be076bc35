"""Tests of `Scene.query`, mostly against a test of every triangle with thirteen axes."""

from __future__ import annotations

import pickle

import numpy as np
import pytest
from numpy.typing import ArrayLike, NDArray

import nearfar as nf
from tests.support import leveled_cases
from tests.support.query_cases import BOXES, contents, soup, touching

CENTERS = ((0.0, 0.0, 0.0), (300.0, -2.0, 40.0), (4.0e6, 10.0, -9.0e5))
"""Centres of scenes: the last one has a nonzero origin."""


@pytest.fixture(scope="module", params=CENTERS, ids=["near", "off", "far"])
def scene(request: pytest.FixtureRequest) -> nf.Scene:
    return soup(request.param)


INF = float("inf")
EVERYWHERE = ((-INF, -INF, -INF), (INF, INF, INF))


def about(scene: nf.Scene, box: ArrayLike) -> NDArray[np.float64]:
    corners: NDArray[np.float64] = np.asarray(box, np.float64) + np.rint(scene.bounds.mean(axis=0))
    return corners


@pytest.mark.parametrize("box", BOXES)
def test_queries_return_touching_triangles_with_their_attributes(scene: nf.Scene, box: ArrayLike) -> None:
    aabb = about(scene, box)
    mask = touching(scene, aabb)
    assert mask.any()
    assert not mask.all()
    part = scene.query(aabb)
    assert np.array_equal(part.triangles(), scene.triangles()[mask])
    expected = contents(scene.subset(triangles=mask))
    for name, values in contents(part).items():
        assert np.array_equal(values, expected[name]), name
    assert np.array_equal(part.origin, scene.origin)


def test_many_small_boxes_return_touching_triangles(scene: nf.Scene) -> None:
    random, corners = np.random.default_rng(5), scene.triangles()
    for _ in range(15):
        middle = random.uniform(-9, 9, 3)
        size = 10 ** random.uniform(-3, 0.8, 3)
        aabb = about(scene, [middle - size, middle + size])
        found = scene.query(aabb).triangles()
        assert np.array_equal(found, corners[touching(scene, aabb)])
        assert scene.touches(aabb) or not len(found)
    assert scene.touches(scene.bounds)
    assert not scene.touches(scene.bounds + 1000)


def test_only_vertices_in_use_remain(scene: nf.Scene) -> None:
    part = scene.query(about(scene, BOXES[4]))
    used = sum(len(np.unique(mesh["faces"])) for mesh in _meshes(part))
    assert 0 < used == sum(len(mesh["positions"]) for mesh in _meshes(part))


def _meshes(scene: nf.Scene) -> list[dict[str, np.ndarray]]:
    from nearfar import _core

    ids = scene._core.mesh_ids()
    _, first = np.unique(ids, return_index=True)
    return [_core.mesh_parts(_core.scene_parts(scene._core)["meshes"][at]) for at in first]


def test_names_and_surfaces_are_shared_and_the_source_is_unchanged(scene: nf.Scene) -> None:
    before = scene.triangles().copy()
    part = scene.query(about(scene, BOXES[0]))
    assert part._names is scene._names
    assert part.object_names == scene.object_names
    assert part._undrawn is scene._undrawn
    assert part.report.notes == scene.report.notes
    assert part._core.material_count == scene._core.material_count
    assert np.array_equal(scene.triangles(), before)


def test_instances_inside_stay_instances_of_the_same_mesh() -> None:
    scene = soup()
    part = scene.query([[-5, -20, -20], [20, 20, 20]])
    shared = np.isin(part._core.mesh_ids(), scene._core.mesh_ids())
    _, counts = np.unique(part._core.mesh_ids()[shared], return_counts=True)
    assert counts.max() > 10
    assert (~shared).sum() > 3


def test_a_cell_of_a_large_world_takes_the_memory_of_the_cell() -> None:
    builder, places = nf.SceneBuilder(), np.tile(np.eye(4), (10_000, 1, 1))
    places[:, 0, 3], places[:, 2, 3] = np.divmod(3.0 * np.arange(10_000), 600)
    tree = builder.mesh(np.random.default_rng(2).random((30, 3)), np.arange(30).reshape(-1, 3))
    builder.place_many(tree, places, "tree")
    world = builder.build(dynamic=[f"tree_{number}" for number in range(0, 10_000, 2)])
    part = world.query([[10, 0, 10], [12, 1, 40]])
    assert np.array_equal(part.triangles(), world.triangles()[touching(world, [[10, 0, 10], [12, 1, 40]])])
    assert part.triangle_count
    assert part._core.bytes() * 120 < world._core.bytes()
    assert len(part._load_placements) * 120 < len(world._load_placements)


def test_an_infinite_box_returns_the_whole_scene(scene: nf.Scene) -> None:
    whole = scene.query(EVERYWHERE)
    assert np.array_equal(whole._core.mesh_ids(), scene._core.mesh_ids())
    assert np.array_equal(whole.bounds, scene.bounds)
    assert whole.poses.keys() == scene.poses.keys()


def test_moving_objects_keep_their_pose_and_can_be_posed_again(scene: nf.Scene) -> None:
    turned = scene.poses["car 2"].copy()
    turned[0, 3] += 3.0
    moved = scene.at({"car 2": turned})
    aabb = about(scene, BOXES[1])
    part = moved.query(aabb)
    assert np.array_equal(part.triangles(), moved.triangles()[touching(moved, aabb)])
    assert part.poses
    for name, pose in part.poses.items():
        assert np.allclose(pose, moved.poses[name], atol=1e-9)
        assert np.array_equal(
            part.at({name: scene.poses[name]}).poses[name], part.at({name: scene.poses[name]}).poses[name]
        )
    only = part.subset(objects=list(part.poses))
    back = only.at({name: scene.poses[name] for name in part.poses})
    assert back.triangle_count == only.triangle_count


def test_boxes_include_their_faces() -> None:
    scene = nf.Scene.from_arrays([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    assert scene.query([[1, 0, 0], [2, 1, 1]]).triangle_count == 1
    assert scene.query(((0.5, 0.5, 0.0), (2.0, 2.0, 2.0))).triangle_count == 1
    assert scene.query(((0.5, 0.5000001, 0.0), (2.0, 2.0, 2.0))).triangle_count == 0
    assert scene.query([[0.25, 0.25, 0], [0.25, 0.25, 0]]).triangle_count == 1


def test_all_copies_of_a_triangle_are_returned() -> None:
    faces = [[0, 1, 2], [3, 4, 5], [0, 1, 2], [2, 0, 1]]
    corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [9, 0, 0], [10, 0, 0], [9, 1, 0]]
    scene = nf.Scene.from_arrays(corners, faces, [0, 1, 2, 3])
    assert contents(scene.query([[-1, -1, -1], [2, 2, 2]]))["objects"].tolist() == [0, 2, 3]


def test_an_empty_box_gives_an_empty_scene(scene: nf.Scene) -> None:
    empty = scene.query(about(scene, [[1e5] * 3, [2e5] * 3]))
    assert empty.triangle_count == 0
    assert empty.object_names == scene.object_names
    assert empty.query(EVERYWHERE).triangle_count == 0
    assert scene.query(np.full((2, 3), np.inf)).triangle_count == 0


def test_parts_of_parts_and_pickles(scene: nf.Scene) -> None:
    aabb, inner = about(scene, BOXES[1]), about(scene, [[1, -np.inf, 1], [2, np.inf, 2]])
    part = scene.query(aabb)
    assert np.array_equal(part.query(inner).triangles(), scene.query(inner).triangles())
    assert np.array_equal(pickle.loads(pickle.dumps(part)).triangles(), part.triangles())


def test_a_scene_with_levels_returns_its_displayed_levels() -> None:
    leveled = nf.lod.place([leveled_cases.model_of((1, 0))], [0, 0], _row(2), names=["one", "two"])
    coarse = leveled.at_levels([1, 0])
    aabb = ((-1e9, -1e9, -1e9), (1.5, 1e9, 1e9))
    part = coarse.query(aabb)
    assert part.leveled is None
    assert np.array_equal(part.triangles(), coarse.triangles()[touching(coarse, aabb)])


def _row(count: int) -> np.ndarray:
    places = np.tile(np.eye(4), (count, 1, 1))
    places[:, 0, 3] = 3.0 * np.arange(count)
    return places
