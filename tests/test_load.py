"""Scenes from files and from trimesh: what is kept, and what the report says is not."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from nearfar import _data
from support import need


def shift(x: float = 0.0, y: float = 0.0, z: float = 0.0) -> NDArray[np.float64]:
    matrix = np.eye(4)
    matrix[:3, 3] = x, y, z
    return matrix


def sorted_triangles(triangles: NDArray[np.floating]) -> NDArray[np.float64]:
    """Triangles in an order of their own, each from its least corner on: what a file's order does not change.

    Millimetres decide, so that rounding does not.
    """

    def key(corners: list[list[float]]) -> list[list[float]]:
        return [[round(x, 3) + 0.0 for x in corner] for corner in corners]

    turned = (min((t[k:] + t[:k] for k in range(3)), key=key) for t in np.asarray(triangles, np.float64).tolist())
    return np.array(sorted(turned, key=key))


def reference_triangles(path: Path | trimesh.Scene) -> NDArray[np.float32]:
    """Trimesh's own answer, through its scene graph."""
    scene = path if isinstance(path, trimesh.Scene) else trimesh.load_scene(path, process=False)
    return np.asarray(scene.to_mesh().triangles, np.float32)


@pytest.fixture
def town() -> trimesh.Scene:
    """Two houses of one mesh, the second turned and mirrored, below a moved node; and a lone tower."""
    scene = trimesh.Scene()
    house, tower = trimesh.creation.box((2, 3, 4)), trimesh.creation.icosphere(2, 1.5)
    scene.graph.update(frame_to="block", frame_from="world", matrix=shift(10, 0, -7))
    scene.add_geometry(house, node_name="house_a", geom_name="house", parent_node_name="block")
    turned = trimesh.transformations.rotation_matrix(0.7, (0, 1, 0)) @ np.diag([1.0, 1, -2, 1])
    scene.graph.update(frame_to="house_b", frame_from="block", matrix=turned, geometry="house")
    scene.add_geometry(tower, node_name="tower", geom_name="tower", transform=shift(-5, 2, 1))
    return scene


@pytest.mark.parametrize("suffix", ["glb", "gltf", "obj", "ply", "stl", "off"])
def test_every_format_keeps_the_triangles(tmp_path: Path, town: trimesh.Scene, suffix: str) -> None:
    path = tmp_path / f"town.{suffix}"
    if suffix == "gltf":
        for name, data in town.export(file_type="gltf").items():
            (tmp_path / name).write_bytes(data)
        path = tmp_path / "model.gltf"
    else:
        (town if suffix in ("glb", "obj") else town.to_mesh()).export(path)
    scene = nf.Scene.load(path)
    assert scene.triangle_count == 2 * 12 + 320
    expected = reference_triangles(path)
    # Both round the same float64 products to float32; the order of the sums may differ by a unit in the last place
    # of 12 m, 1e-6.
    np.testing.assert_allclose(sorted_triangles(scene.triangles()), sorted_triangles(expected), atol=2e-6)


def test_instances_stay_instances_and_nodes_are_objects(tmp_path: Path, town: trimesh.Scene) -> None:
    town.export(tmp_path / "town.glb")
    for scene in (nf.Scene.load(tmp_path / "town.glb"), nf.Scene.from_trimesh(town)):
        assert sorted(scene.object_names) == ["house_a", "house_b", "tower"]
        assert (scene.report.instances, scene.report.meshes) == (3, 3)  # the mirrored house is a twin
        expected = town.graph.get("house_b")[0]
        np.testing.assert_allclose(scene.transform("house_b"), expected, atol=1e-12)


def test_primitives_of_one_node_are_one_object(tmp_path: Path) -> None:
    need("data")
    scene = nf.Scene.load(_data.require("interior/garage/garage.gltf"))
    assert scene.object_names == ("mesh308615427",)
    assert (scene.triangle_count, scene.report.materials) == (11_358, 17)
