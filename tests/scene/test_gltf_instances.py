"""Nodes of glTF files that place their mesh many times by arrays (EXT_mesh_gpu_instancing)."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar._scene.srgb import to_linear, to_srgb
from tests.support.gltf_cases import load
from tests.support.gltf_writer import glb_of
from tests.support.meshopt_cases import Stream, attributes, glb, triangles

NAME = "EXT_mesh_gpu_instancing"
CORNERS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], np.float32)
MESH = [{"primitives": [{"attributes": {"POSITION": 0}}]}]
PLACES = np.array([[5, 0, 0], [0, 6, 0], [0, 0, 7]], np.float32)
HALF = np.sqrt(0.5)
QUATERNIONS = np.array([[0, 0, 0, 1], [0, 0, HALF, HALF], [1, 0, 0, 0]])
"""No rotation, a quarter rotation about z, a half one about x."""
TURNED = np.array([CORNERS, [[0, 0, 0], [0, 1, 0], [-1, 0, 0]], [[0, 0, 0], [1, 0, 0], [0, -1, 0]]])
"""The corners after these rotations."""
SCALES = np.array([[1, 1, 1], [2, 3, 1], [1, 2, -1]], np.float32)


def document(arrays: list[NDArray[Any]], **changes: Any) -> bytes:
    """A GLB with these arrays as accessors, normalised if integers; the corners are the first one."""
    entries: dict[str, Any] = {"extensionsRequired": [NAME], "meshes": MESH}
    return glb_of([CORNERS, *arrays], **entries | changes)


def node(**attributes: int) -> dict[str, Any]:
    return {"mesh": 0, "name": "tree", "extensions": {NAME: {"attributes": attributes}}}


def test_instances_share_one_mesh_in_the_files_order(tmp_path: Path) -> None:
    scene = load(tmp_path, document([PLACES], nodes=[node(TRANSLATION=1)]))
    np.testing.assert_array_equal(scene.triangles(), CORNERS + PLACES[:, None])
    assert scene._core.instance_count == 3
    assert len(set(scene._core.mesh_ids().tolist())) == 1
    assert scene.object_names == ("tree", "tree_1", "tree_2")
    assert scene.report.notes == ()


@pytest.mark.parametrize("kind", [np.float32, np.uint8])
@pytest.mark.parametrize("stores", [True, False])
def test_colors_of_instances_multiply_those_of_vertices(tmp_path: Path, kind: type[Any], stores: bool) -> None:
    """Instances of equal colour share a mesh. Strips are read array by array, lists directly from the bytes."""
    full = 1 if kind is np.float32 else 255
    tints = (np.array([[1, 0, 0], [0, 1, 1], [1, 0, 0]]) * full).astype(kind)
    padded = np.column_stack([tints, np.full(3, full, kind)])
    colors = np.array([[1, 1, 0, 1]] * 3, np.float32)
    meshes = [{"primitives": [{"attributes": {"POSITION": 0, "COLOR_0": 3}, "mode": 4 if stores else 5}]}]
    content = document([PLACES, padded, colors], nodes=[node(TRANSLATION=1, _COLOR_0=2)], meshes=meshes)
    scene = load(tmp_path, content)
    np.testing.assert_array_equal(sorted(scene.triangles().tolist()), sorted((CORNERS + PLACES[:, None]).tolist()))
    parts = nf._core.mesh_parts(scene._core.merged())
    expected = np.array([[255, 0, 0, 255], [0, 255, 0, 255], [255, 0, 0, 255]])
    instance = (parts["positions"] >= [5, 6, 7]).argmax(axis=1)
    np.testing.assert_array_equal(parts["colors"], expected[instance])
    assert len(set(scene._core.mesh_ids().tolist())) == 2
    assert scene.report.notes == ()


def test_many_colors_of_instances_are_rounded_with_a_note(tmp_path: Path) -> None:
    """Each colour needs a mesh, and forests have one for each tree."""
    count = 2000
    rgb = np.random.default_rng(1).random((count, 3)).astype(np.float32)
    places = np.arange(3.0 * count, dtype=np.float32).reshape(count, 3)
    content = document([places, rgb], nodes=[node(TRANSLATION=1, _COLOR_0=2)])
    scene = load(tmp_path, content)
    assert scene.triangle_count == count
    assert 100 < len(set(scene._core.mesh_ids().tolist())) <= 256
    assert scene.report.notes == ("colours of instances rounded to 6 values in each channel",)
    parts = nf._core.mesh_parts(scene._core.merged())
    order = np.argsort(parts["positions"][::3, 0])
    stored = to_linear(parts["colors"][::3][order][:, :3] / 255)
    assert np.abs(to_srgb(stored) - to_srgb(rgb)).max() < 0.5 / 5 + 0.01


@pytest.mark.parametrize("kind", [np.float32, np.int8, np.int16])
def test_rotations_may_be_integers(tmp_path: Path, kind: type[Any]) -> None:
    most = 1 if kind is np.float32 else np.iinfo(kind).max
    turns = QUATERNIONS * most
    rows = turns.astype(kind) if kind is np.float32 else np.rint(turns).astype(kind)
    scene = load(tmp_path, document([rows], nodes=[node(ROTATION=1)]))
    # A quaternion of equal parts keeps its direction when it is rounded.
    np.testing.assert_allclose(scene.triangles(), TURNED, atol=1e-6)


def test_transforms_apply_scale_rotation_translation_and_node(tmp_path: Path) -> None:
    parent = {"name": "root", "translation": [100, 0, 0], "children": [1]}
    many = node(TRANSLATION=1, ROTATION=2, SCALE=3) | {"scale": [2, 2, 2]}
    scene = load(tmp_path, document([PLACES, QUATERNIONS.astype(np.float32), SCALES], nodes=[parent, many]))
    quarter = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1]])
    turns = [np.eye(3), quarter, np.diag([1, -1, -1])]
    parts = zip(turns, SCALES, PLACES, strict=True)
    expected = [100 * np.eye(3)[0] + 2 * ((CORNERS * scale) @ turn.T + place) for turn, scale, place in parts]
    found = [scene.subset(objects=[name]).triangles()[0] for name in ("tree", "tree_1", "tree_2")]
    for triangle, corners in zip(found, expected, strict=True):
        # The faces of a mirrored mesh are reversed.
        order = np.lexsort(corners.T), np.lexsort(np.round(triangle, 3).T)
        np.testing.assert_allclose(triangle[order[1]], corners[order[0]], atol=1e-5)


def test_objects_have_all_primitives_and_names_that_no_other_has(tmp_path: Path) -> None:
    nodes = [node(TRANSLATION=1), {"mesh": 0, "name": "tree_1"}, {"mesh": 0, "translation": [9, 9, 9]}]
    meshes = [{"primitives": MESH[0]["primitives"] * 2}]
    scene = load(tmp_path, document([PLACES], nodes=nodes, scenes=[{"nodes": [0, 1, 2]}], meshes=meshes))
    assert scene.triangle_count == 10
    assert scene.object_names == ("tree", "tree_2", "tree_3", "tree_1", "2")
    np.testing.assert_array_equal(scene.subset(objects=["tree_3"]).triangles(), [CORNERS + PLACES[2]] * 2)


def test_children_of_instances_are_placed_once(tmp_path: Path) -> None:
    nodes = [node(TRANSLATION=1) | {"children": [1]}, {"mesh": 0, "name": "bird"}]
    scene = load(tmp_path, document([PLACES], nodes=nodes))
    assert scene.triangle_count == 4
    np.testing.assert_array_equal(scene.subset(objects=["bird"]).triangles()[0], CORNERS)


def test_a_single_instance_is_placed_and_other_attributes_are_ignored(tmp_path: Path) -> None:
    ids = np.zeros((1, 3), np.float32)
    scene = load(tmp_path, document([PLACES[:1], ids], nodes=[node(TRANSLATION=1, _FEATURE_ID_0=2)]))
    np.testing.assert_array_equal(scene.triangles()[0], CORNERS + PLACES[0])
    assert scene.object_names == ("tree",)
    # Nodes without a mesh place nothing.
    nodes = [{"mesh": 0, "children": [1]}, {"extensions": {NAME: {"attributes": {"TRANSLATION": 99}}}}]
    assert load(tmp_path, document([], nodes=nodes)).triangle_count == 1


def test_instances_may_be_compressed(tmp_path: Path) -> None:
    # The largest component of a quaternion is omitted: two bits give its index; 2047 represents √½ (12 bits).
    packed = np.array([[0, 0, 0, 0x7FF], [0, 0, 2047, 0x7FF], [0, 0, 0, 0x7FC]], np.int16)
    streams: list[Stream] = [
        attributes(CORNERS),
        triangles(np.array([[0, 1, 2]], np.uint16)),
        attributes(PLACES),
        attributes(packed, filter="QUATERNION", normalized=True),
    ]
    mesh = [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}]
    scene = load(tmp_path, glb(streams, meshes=mesh, nodes=[node(TRANSLATION=2, ROTATION=3)]))
    np.testing.assert_allclose(scene.triangles(), TURNED + PLACES[:, None], atol=1e-3)


@pytest.mark.parametrize(
    ("attributes", "words"),
    [
        ({"TRANSLATION": 1, "ROTATION": 2}, "node 0's instances, got 3 of TRANSLATION, 2 of ROTATION"),
        ({"TRANSLATION": 1, "_ID": 2}, "node 0's instances, got 3 of TRANSLATION, 2 of _ID"),
        ({}, "node 0's instances, got none"),
        ({"ROTATION": 1}, "expected 4 numbers in each row of ROTATION, got 3"),
        ({"SCALE": 2}, "expected 3 numbers in each row of SCALE, got 4"),
        ({"SCALE": 9}, "does not contain"),
        ({"SCALE": "a"}, "wrong type|does not contain|not well-formed"),
    ],
)
def test_invalid_instance_attributes_are_errors(tmp_path: Path, attributes: dict[str, Any], words: str) -> None:
    content = document([PLACES, QUATERNIONS[:2].astype(np.float32)], nodes=[node(**attributes)])
    with pytest.raises(nf.SceneError, match=rf"a\.glb: .*({words})"):
        load(tmp_path, content)


def test_non_finite_transforms_are_errors_or_omitted(tmp_path: Path) -> None:
    places = PLACES.copy()
    places[1, 0] = np.nan
    content = document([places], nodes=[node(TRANSLATION=1)])
    with pytest.raises(nf.SceneError, match="a transform that is not finite and affine at node"):
        load(tmp_path, content)
    assert load(tmp_path, content, on_invalid="drop").object_names == ("tree", "tree_2")


def test_instances_are_counted_before_allocation(tmp_path: Path) -> None:
    """Many nodes share the same array, and one array claims rows that the file does not have."""
    places = np.zeros((2000, 3), np.float32)
    nodes = [node(TRANSLATION=1)] * 2000
    content = document([places], nodes=nodes, scenes=[{"nodes": list(range(2000))}])
    with pytest.raises(nf.SceneError, match=r"a\.glb: it unpacks to more than 268,435,456 bytes"):
        load(tmp_path, content)
    corners = {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}
    bare = {"componentType": 5126, "count": 1 << 31, "type": "VEC3"}
    with pytest.raises(nf.SceneError, match=r"a\.glb: it unpacks to more than 268,435,456 bytes"):
        load(tmp_path, document([], accessors=[corners, bare], nodes=[node(_ID=1)]))
