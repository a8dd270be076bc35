"""Skins, morph targets and hidden nodes of glTF files: shapes are drawn as the nodes at rest place them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from tests.support.gltf_cases import decode, encode, load
from tests.support.gltf_writer import glb_of

CORNERS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], np.float32)
UP = np.array([[0, 0, 1]] * 3, np.float32)
FIRST = np.zeros((3, 4), np.uint8)
ONE = np.array([[1, 0, 0, 0]] * 3, np.float32)
JOINT = {"translation": [0, 5, 0]}


def document(arrays: list[NDArray[Any]], **changes: Any) -> bytes:
    """A GLB with these arrays as accessors, normalised if signed; the corners are accessor 0, normals 1."""
    return glb_of([CORNERS, UP, *arrays], "i", **changes)


def mesh(*, targets: list[dict[str, int]] | None = None, **attributes: int) -> list[dict[str, Any]]:
    primitive: dict[str, Any] = {"attributes": {"POSITION": 0, "NORMAL": 1} | attributes}
    return [{"primitives": [primitive | ({} if targets is None else {"targets": targets})]}]


def normals_of(scene: nf.Scene) -> NDArray[Any]:
    return np.asarray(nf._core.mesh_parts(scene._core.merged())["normals"])


def test_joints_place_skinned_vertices_and_the_node_does_not(tmp_path: Path) -> None:
    meshes = mesh(JOINTS_0=2, WEIGHTS_0=3)
    nodes: list[dict[str, Any]] = [{"mesh": 0, "skin": 0, "translation": [100, 0, 0]}, JOINT]
    entries = {"nodes": nodes, "meshes": meshes, "skins": [{"joints": [1]}], "scenes": [{"nodes": [0, 1]}]}
    scene = load(tmp_path, document([FIRST, ONE], **entries))
    np.testing.assert_allclose(scene.bounds, [[0, 5, 0], [1, 6, 0]])
    assert scene.report.notes == ("1 skin shown at rest",)
    # The same mesh at a node without the skin keeps that node's transform.
    nodes.append({"mesh": 0, "translation": [50, 0, 0]})
    entries["scenes"] = [{"nodes": [0, 1, 2]}]
    scene = load(tmp_path, document([FIRST, ONE], **entries))
    corners = sorted(scene.triangles().tolist())
    np.testing.assert_allclose(corners, [CORNERS + np.array(offset) for offset in ([0, 5, 0], [50, 0, 0])])


@pytest.mark.parametrize("kind", [np.float32, np.int8])
def test_all_sets_of_weights_count(tmp_path: Path, kind: type[Any]) -> None:
    """The slow sum over joints of weight · joint · inverse bind · vertex; weights count relative to their sum."""
    rng = np.random.default_rng(0)
    full = 1 if kind is np.float32 else np.iinfo(kind).max
    weights = [(rng.uniform(0.1, 1, (3, 4)) * full).astype(kind) for _ in range(2)]
    joints = [rng.integers(0, 3, (3, 4)).astype(np.uint16) for _ in range(2)]
    scales, places = rng.uniform(0.5, 2, (3, 3)), rng.uniform(-9, 9, (3, 3))
    binds = np.tile(np.eye(4), (3, 1, 1))
    binds[:, :3, 3] = rng.uniform(-2, 2, (3, 3))
    nodes: list[dict[str, Any]] = [{"mesh": 0, "skin": 0}, {"children": [2, 3, 4], "translation": [0, 0, 3]}]
    nodes += [{"translation": p.tolist(), "scale": s.tolist()} for p, s in zip(places, scales, strict=True)]
    columns = binds.transpose(0, 2, 1).reshape(3, 16).astype(np.float32)
    entries = {"nodes": nodes, "skins": [{"joints": [2, 3, 4], "inverseBindMatrices": 6}]}
    arrays: list[NDArray[Any]] = [joints[0], weights[0], joints[1], weights[1], columns]
    meshes = mesh(JOINTS_0=2, WEIGHTS_0=3, JOINTS_1=4, WEIGHTS_1=5)
    scene = load(tmp_path, document(arrays, meshes=meshes, scenes=[{"nodes": [0, 1]}], **entries))
    for corner in range(3):
        pairs = [(joints[s][corner, k], float(weights[s][corner, k])) for s in range(2) for k in range(4)]
        place, linear = np.zeros(3), np.zeros((3, 3))
        for joint, weight in pairs:
            share = weight / sum(w for _, w in pairs)
            moved = scales[joint] * (CORNERS[corner] + binds[joint, :3, 3]) + places[joint] + [0, 0, 3]
            place += share * moved
            linear += share * np.diag(scales[joint])
        np.testing.assert_allclose(scene.triangles()[0, corner], place, atol=1e-5)
        normal = np.linalg.inv(linear).T @ UP[corner]
        np.testing.assert_allclose(normals_of(scene)[corner], normal / np.linalg.norm(normal), atol=1e-3)


def test_normals_turn_with_joints(tmp_path: Path) -> None:
    half = np.sqrt(0.5)
    nodes: list[dict[str, Any]] = [{"mesh": 0, "skin": 0}, {"rotation": [half, 0, 0, half], "scale": [1, 1, 3]}]
    entries = {"nodes": nodes, "skins": [{"joints": [1]}], "scenes": [{"nodes": [0, 1]}]}
    scene = load(tmp_path, document([FIRST, ONE * 0], meshes=mesh(JOINTS_0=2, WEIGHTS_0=3), **entries))
    np.testing.assert_allclose(scene.triangles()[0], [[0, 0, 0], [1, 0, 0], [0, 0, 1]], atol=1e-6)
    np.testing.assert_allclose(normals_of(scene), [[0, -1, 0]] * 3, atol=1e-3)


@pytest.mark.parametrize(
    ("joints", "skin", "words"),
    [
        (FIRST + np.uint8(1), {"joints": [1]}, "a vertex refers to none of the 1 joints of its skin 0"),
        (FIRST.astype(np.float32), {"joints": [1]}, "a vertex refers to none of the 1 joints"),
        (FIRST, {"joints": [9]}, "does not contain"),
        (FIRST, {"joints": [1], "inverseBindMatrices": 0}, "its skin 0 has 1 joints, but"),
    ],
)
def test_damaged_skins_are_errors(tmp_path: Path, joints: NDArray[Any], skin: dict[str, Any], words: str) -> None:
    nodes: list[dict[str, Any]] = [{"mesh": 0, "skin": 0}, JOINT]
    content = document([joints, ONE], nodes=nodes, skins=[skin], meshes=mesh(JOINTS_0=2, WEIGHTS_0=3))
    with pytest.raises(nf.SceneError, match=rf"a\.glb: .*{words}"):
        load(tmp_path, content)


def test_default_weights_move_morphed_vertices(tmp_path: Path) -> None:
    changes = np.array([[0, 0, 127], [0, 0, 0], [127, 0, 0]], np.int8)
    step = changes / 127
    turn = np.array([[0, 1, -1]] * 3, np.float32)
    meshes = mesh(targets=[{"POSITION": 2}, {"POSITION": 0, "NORMAL": 3}])
    nodes: list[dict[str, Any]] = [{"mesh": 0}, {"mesh": 0, "weights": [0, 0]}, {"mesh": 0, "weights": [0.5, 1]}]
    meshes[0]["weights"] = [2, 0]
    for count, expected in ((1, [CORNERS + 2 * step]), (3, [CORNERS + 2 * step, CORNERS, 2 * CORNERS + step / 2])):
        content = document([changes, turn], meshes=meshes, nodes=nodes, scenes=[{"nodes": list(range(count))}])
        scene = load(tmp_path, content)
        triangles = sorted(np.round(scene.triangles(), 5).tolist())
        np.testing.assert_allclose(triangles, sorted(np.round(np.array(expected), 5).tolist()), atol=1e-5)
        assert scene.report.notes == ("1 morphed primitive shown at rest",)
    meshes[0]["weights"] = [0, 1]
    scene = load(tmp_path, document([changes, turn], meshes=meshes))
    np.testing.assert_allclose(normals_of(scene), [[0, 1, 0]] * 3, atol=1e-3)


def test_sparse_targets_and_skins_are_applied_in_order(tmp_path: Path) -> None:
    """A morph changes the mesh before its skin does (glTF 2.0, 3.7.2.2)."""
    nodes: list[dict[str, Any]] = [{"mesh": 0, "skin": 0, "weights": [1]}, {"scale": [1, 4, 1]}]
    meshes = mesh(targets=[{"POSITION": 6}], JOINTS_0=2, WEIGHTS_0=3)
    arrays: list[NDArray[Any]] = [FIRST, ONE, np.array([[2]], np.uint16), np.array([[0, 2, 0]], np.float32)]
    content = document(arrays, nodes=nodes, skins=[{"joints": [1]}], meshes=meshes, scenes=[{"nodes": [0, 1]}])
    # Only the third row of the target is stored.
    sparse = {"count": 1, "indices": {"bufferView": 4, "componentType": 5123}, "values": {"bufferView": 5}}
    described, binary = decode(content)
    described["accessors"].append({"componentType": 5126, "count": 3, "type": "VEC3", "sparse": sparse})
    scene = load(tmp_path, encode(described, binary))
    np.testing.assert_allclose(scene.triangles()[0], [[0, 0, 0], [1, 0, 0], [0, 12, 0]])


@pytest.mark.parametrize("weights", [["a"], "ab", [None]])
def test_weights_that_are_no_numbers_are_errors(tmp_path: Path, weights: Any) -> None:
    nodes = [{"mesh": 0, "weights": weights}]
    with pytest.raises(nf.SceneError, match=r"a\.glb: expected finite numbers as weights of mesh 0"):
        load(tmp_path, document([], nodes=nodes, meshes=mesh(targets=[{"POSITION": 0}])))


def test_hidden_nodes_are_not_drawn(tmp_path: Path) -> None:
    hidden = {"KHR_node_visibility": {"visible": False}}
    shown = {"KHR_node_visibility": {"visible": True}}
    nodes: list[dict[str, Any]] = [
        {"mesh": 0, "extensions": shown},
        {"extensions": hidden, "children": [2]},
        {"mesh": 0, "translation": [9, 0, 0], "extensions": shown},
    ]
    entries = {"nodes": nodes, "meshes": mesh(), "extensionsRequired": ["KHR_node_visibility"]}
    scene = load(tmp_path, document([], scenes=[{"nodes": [0, 1]}], **entries))
    np.testing.assert_array_equal(scene.bounds, [[0, 0, 0], [1, 1, 0]])
    assert scene.report.notes == ("1 hidden node and all nodes below not drawn",)


def test_only_the_default_scene_is_drawn(tmp_path: Path) -> None:
    nodes: list[dict[str, Any]] = [{"mesh": 0}, {"mesh": 0, "translation": [9, 0, 0]}]
    scenes = [{"nodes": [0]}, {"nodes": [1]}]
    scene = load(tmp_path, document([], meshes=mesh(), nodes=nodes, scenes=scenes, scene=1))
    np.testing.assert_array_equal(scene.bounds, [[9, 0, 0], [10, 1, 0]])
    assert scene.report.notes == ("1 other scene ignored",)


def test_primitives_without_positions_are_noted(tmp_path: Path) -> None:
    meshes = mesh()
    meshes[0]["primitives"] += [{"attributes": {"NORMAL": 1}}, {"attributes": {}}]
    scene = load(tmp_path, document([], meshes=meshes))
    assert scene.triangle_count == 1
    assert scene.report.notes == ("2 primitives without POSITION ignored",)


@pytest.mark.parametrize(("version", "is_read"), [("2.0", True), ("2.1", False), ("3.0", False), ("", False)])
def test_files_that_need_a_later_version_are_refused(tmp_path: Path, version: str, is_read: bool) -> None:
    content = document([], meshes=mesh(), asset={"version": "2.9", "minVersion": version})
    if is_read:
        assert load(tmp_path, content).triangle_count == 1
        return
    with pytest.raises(nf.SceneError, match=rf"a\.glb: it needs glTF .?{version}.? \(asset.minVersion\)"):
        load(tmp_path, content)
