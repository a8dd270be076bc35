"""Tests of scenes from files and from trimesh, and of the report."""

from __future__ import annotations

import gzip
from pathlib import Path

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from nearfar._base import data as data_files
from nearfar._scene.options import Up
from tests.support import need
from tests.support.reduce_cases import place as shift


def sorted_triangles(triangles: NDArray[np.floating]) -> NDArray[np.float64]:
    """Triangles in a canonical order, each with its least corner first, so that a file's order does not matter.

    The order is by millimetres, so that rounding does not affect it.
    """

    def key(corners: list[list[float]]) -> list[list[float]]:
        return [[round(x, 3) + 0.0 for x in corner] for corner in corners]

    turned = (min((t[k:] + t[:k] for k in range(3)), key=key) for t in np.asarray(triangles, np.float64).tolist())
    return np.array(sorted(turned, key=key))


def reference_triangles(path: Path | trimesh.Scene) -> NDArray[np.float32]:
    """trimesh's result, through its scene graph."""
    scene = path if isinstance(path, trimesh.Scene) else trimesh.load_scene(path, process=False)
    return np.asarray(scene.to_mesh().triangles, np.float32)


@pytest.fixture
def town() -> trimesh.Scene:
    """Two houses of one mesh, the second rotated and mirrored, under a translated node; and a single tower."""
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
        assert (scene.report.instances, scene.report.meshes) == (3, 3)  # The mirrored house is a twin.
        expected = town.graph.get("house_b")[0]
        np.testing.assert_allclose(scene.transform("house_b"), expected, atol=1e-12)


DATA = {
    "city/manhattan_deckgl/manhattan_core.glb": (34_321, 999, 1),
    "interior/garage/garage.gltf": (11_358, 1, 17),
    "objects/gltf/FlightHelmet/FlightHelmet.gltf": (94_722, 6, 6),
    "objects/gltf/Duck.glb": (4_212, 1, 1),
    "objects/armadillo.obj": (86_482, 1, 1),
    "objects/bun_zipper.ply": (69_451, 1, 1),
}
"""Files with their numbers of triangles, objects and materials; the garage has a node of many primitives."""


@pytest.mark.parametrize("name", DATA)
def test_real_files_agree_with_trimesh(name: str) -> None:
    need("data")
    path = data_files.require(name)
    scene = nf.Scene.load(path)
    assert (scene.triangle_count, len(scene.object_names), scene.report.materials) == DATA[name]
    expected = reference_triangles(path)
    # Half a float32 step at 3 km, 1.2e-4 m, twice: trimesh rounds once more.
    reach = float(np.abs(expected).max())
    np.testing.assert_allclose(scene.bounds, [expected.min((0, 1)), expected.max((0, 1))], rtol=0, atol=reach * 1.2e-7)
    areas = [
        np.linalg.norm(np.cross(t[:, 1] - t[:, 0], t[:, 2] - t[:, 0]), axis=1).sum() / 2
        for t in (scene.triangles().astype(np.float64), expected.astype(np.float64))
    ]
    # Rounding of corners by 1e-7 of the reach averages out over thousands of triangles.
    assert areas[0] == pytest.approx(areas[1], rel=1e-5)


def test_ten_thousand_nodes_load_without_the_slow_scene_graph(monkeypatch: pytest.MonkeyPatch) -> None:
    need("data")
    path = data_files.require("city/tokyo23/tokyo_core_lod1.glb")

    def refuse(*_: object, **__: object) -> None:
        raise AssertionError("trimesh's scene graph takes a second for ten thousand nodes")

    monkeypatch.setattr(trimesh.scene.transforms.SceneGraph, "get", refuse)
    monkeypatch.setattr(trimesh.scene.transforms.SceneGraph, "update", refuse)
    scene = nf.Scene.load(path)
    assert (scene.triangle_count, len(scene.object_names), scene.report.instances) == (232_986, 12_408, 1)
    assert scene.object_names[0] == "13103-bldg-23581"


def test_many_nodes_are_many_objects(tmp_path: Path) -> None:
    scene = trimesh.Scene()
    box = trimesh.creation.box()
    for k in range(50):
        scene.add_geometry(box.copy(), node_name=f"house {k}", geom_name=f"g{k}", transform=shift(3 * k))
    scene.export(tmp_path / "many.glb")
    loaded = nf.Scene.load(tmp_path / "many.glb")
    assert loaded.object_names == tuple(f"house {k}" for k in range(50))
    assert loaded.report.instances == 1
    np.testing.assert_array_equal(loaded.subset(objects=["house 7"]).bounds[:, 0], [20.5, 21.5])


@pytest.mark.parametrize(
    ("up", "expected"),
    [
        ("y", (1, 2, 3)),
        ("z", (1, 3, -2)),
        ("x", (-2, 1, 3)),
        ("-y", (1, -2, -3)),
        ("-z", (1, -3, 2)),
        ("-x", (-2, -1, -3)),
    ],
)
def test_the_upward_axis_becomes_y(tmp_path: Path, up: Up, expected: tuple[float, ...]) -> None:
    mesh = trimesh.Trimesh([[1, 2, 3], [0, 0, 0], [0, 1, 1]], [[0, 1, 2]], process=False)
    mesh.export(tmp_path / "a.ply")
    for scene in (nf.Scene.load(tmp_path / "a.ply", up=up), nf.Scene.from_trimesh(mesh, up=up)):
        np.testing.assert_array_equal(scene.triangles()[0, 0], expected)


@pytest.mark.parametrize("suffix", ["blend", "max", "3ds", "skp", "ifc", "las"])
def test_errors_about_known_formats_name_a_converter(tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"model.{suffix.upper()}"
    path.write_bytes(b"whatever")
    with pytest.raises(nf.SceneError, match=f"model.{suffix.upper()}: nearfar does not read"):
        nf.Scene.load(path)


def test_a_packed_file_is_unpacked(tmp_path: Path) -> None:
    packed = tmp_path / "ball.ply.gz"
    packed.write_bytes(gzip.compress(trimesh.creation.icosphere(2).export(file_type="ply")))
    scene = nf.Scene.load(packed)
    assert (scene.triangle_count, scene.object_names) == (320, ("ball",))


def test_other_things_than_trimesh_objects_are_refused() -> None:
    with pytest.raises(nf.SceneError, match="trimesh object: no triangles"):
        nf.Scene.from_trimesh(trimesh.Trimesh())


def test_a_lone_mesh_keeps_its_vertices() -> None:
    ball = trimesh.creation.icosphere(2)
    scene = nf.Scene.from_trimesh(ball)
    assert scene.object_names == ("object",)
    np.testing.assert_array_equal(scene.triangles(), ball.vertices[ball.faces].astype(np.float32))


@pytest.mark.parametrize("on_invalid", ["raise", "drop"])
def test_unusable_vertices_are_counted(tmp_path: Path, on_invalid: str) -> None:
    lines = ["v 0 0 0", "v 1 0 0", "v 0 1 0", "v nan 0 0", "v 0 inf 0", "v 1e300 0 0"]
    faces = ["f 1 2 3", "f 2 3 4", "f 1 2 5", "f 6 1 2"]
    (tmp_path / "bad.obj").write_text("\n".join(["o wall", *lines, *faces]))
    if on_invalid == "raise":
        words = (
            "bad.obj: 2 vertices with coordinates that are not finite and "
            r"1 vertex with coordinates too large for 32-bit floats, up to 1e\+300, in mesh 'wall'; on_invalid='drop'"
        )
        with pytest.raises(nf.SceneError, match=words):
            nf.Scene.load(tmp_path / "bad.obj")
    else:
        scene = nf.Scene.load(tmp_path / "bad.obj", on_invalid="drop")
        assert (scene.triangle_count, scene.report.dropped_faces) == (1, 3)
        assert "3 unusable faces dropped" in str(scene.report)
        np.testing.assert_array_equal(scene.bounds, [[0, 0, 0], [1, 1, 0]])


def test_flat_instances_are_kept_as_geometry(tmp_path: Path) -> None:
    scene = trimesh.Scene()
    box = trimesh.creation.box()
    scene.add_geometry(box, node_name="solid", geom_name="box")
    scene.graph.update(frame_to="shadow", frame_from="world", matrix=np.diag([1.0, 0, 1, 1]), geometry="box")
    scene.export(tmp_path / "flat.glb")
    loaded = nf.Scene.load(tmp_path / "flat.glb")
    assert loaded.triangle_count == 24
    np.testing.assert_array_equal(loaded.subset(objects=["shadow"]).bounds[:, 1], [0, 0])
    with pytest.raises(ValueError, match="did you mean"):
        loaded.with_dynamic(["shadows"])


def test_the_same_file_gives_the_same_bytes(tmp_path: Path, town: trimesh.Scene) -> None:
    town.export(tmp_path / "town.glb")
    first, second = (nf.Scene.load(tmp_path / "town.glb") for _ in range(2))
    assert first.triangles().tobytes() == second.triangles().tobytes()
    assert first.object_names == second.object_names


def test_options_are_made_once_for_many_files(tmp_path: Path) -> None:
    path = tmp_path / "box.stl"
    trimesh.creation.box((1.0, 2.0, 3.0)).export(path)
    options = nf.LoadOptions(up="z", scale=0.001)
    np.testing.assert_array_equal(nf.Scene.load(path, options).bounds, nf.Scene.load(path, up="z", scale=0.001).bounds)
    np.testing.assert_array_equal(nf.Scene.load(path, options, scale=1).bounds, nf.Scene.load(path, up="z").bounds)
    np.testing.assert_array_equal(nf.open_source(path, options).bounds, nf.Scene.load(path, options).bounds)
    with pytest.raises(TypeError, match=r"^options: expected LoadOptions, got dict"):
        nf.Scene.load(path, {"up": "z"})  # type: ignore[arg-type]
    with pytest.raises(TypeError, match=r"^upwards: expected a parameter .* such as LoadOptions \(up, scale, "):
        nf.Scene.load(path, upwards="z")  # type: ignore[call-arg]
