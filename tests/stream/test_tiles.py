"""A mesh of many objects is divided spatially for regions on demand, invisibly for clients."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar.stream import _on_demand, _store, _tiles
from nearfar.stream._on_demand import OnDemand
from nearfar.stream._tiles import Tiles

ACROSS, STEP = 12, 11.0
PLACE = (3.3, 1.75, -2.2)
SETTINGS: dict[str, Any] = {"grid": 2.0, "radii": (10.0, 22.0, 40.0), "face_size": 128, "samples": 2}


@pytest.fixture(autouse=True)
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(_on_demand, "COARSE_FACE_SIZE", 64)
    for name, value in {"MIN_FACES": 500, "TILE_FACES": 50, "MIN_SIDE": 20.0}.items():
        monkeypatch.setattr(_tiles, name, value)


def houses() -> tuple[NDArray[np.float32], NDArray[np.uint32], NDArray[np.int32]]:
    """Boxes in a square, whose faces are in random order."""
    random = np.random.default_rng(3)
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], np.float32)
    sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    box = np.array([face for a, b, c, d in sides for face in ((a, b, c), (a, c, d))], np.uint32)
    places = np.array([[x, 0.0, z] for x in range(ACROSS) for z in range(ACROSS)]) * STEP - STEP * ACROSS / 2.0
    places[:, 1] = 0.0
    sizes = random.uniform((3, 2, 3), (8, 30, 8), (len(places), 3))
    vertices = (places[:, None] + sizes[:, None] * corners).reshape(-1, 3).astype(np.float32)
    faces = (8 * np.arange(len(places))[:, None, None] + box).reshape(-1, 3).astype(np.uint32)
    order = random.permutation(len(faces))
    return vertices, faces[order], np.repeat(np.arange(len(places), dtype=np.int32), len(box))[order]


@pytest.fixture(scope="module")
def scene() -> nf.Scene:
    vertices, faces, objects = houses()
    return nf.Scene.from_arrays(vertices, faces, face_object=objects)


def triangles_of(scene: nf.Scene, name: str) -> NDArray[np.float32]:
    corners = scene.subset(objects=[name]).triangles().reshape(-1, 9)
    return corners[np.lexsort(corners.T)]


def test_tiles_contain_whole_objects(scene: nf.Scene) -> None:
    tiles = Tiles.divide(scene)
    assert len(tiles.boxes) > 9
    assert tiles.scene.object_names == scene.object_names
    assert tiles.scene.triangle_count == scene.triangle_count
    for name in scene.object_names[:: ACROSS - 1]:
        np.testing.assert_array_equal(triangles_of(tiles.scene, name), triangles_of(scene, name))
    # Along each axis a tile is no wider than its side and a house.
    assert np.ptp(tiles.boxes, axis=1)[:, [0, 2]].max() < 20.0 + 8.0 + 12.0


def test_far_tiles_are_one_object_and_near_ones_keep_theirs(scene: nf.Scene) -> None:
    tiles = Tiles.divide(scene)
    about = tiles.scene_about(PLACE, 22.0)
    for divided in (tiles.scene, about):
        rings = nf.stream.assign(divided, center=PLACE, radii=(10.0, 22.0))
        expected = nf.stream.assign(scene, center=PLACE, radii=(10.0, 22.0))
        np.testing.assert_array_equal(rings.ring, expected.ring)
        assert rings.summary() == expected.summary()
        assert rings.measured < expected.measured
    # Seen from above, near houses have separate numbers, and far ones do not.
    view = nf.Camera.look_at((0, 150, 1), (0, 0, 0), fov=nf.Fov.symmetric(90), size=(200, 200))
    counts = [
        len(np.unique(nf.render(each, view, channels=("object_id",)).require("object_id"))) for each in (scene, about)
    ]
    assert 1 + int((expected.ring < 3).sum()) < counts[1] < counts[0] // 2


def test_a_region_equals_an_export_and_shows_the_scene(scene: nf.Scene, tmp_path: Path) -> None:
    maker = OnDemand(scene, **SETTINGS)
    assert len(maker._tiles.boxes)
    parts = list(maker.parts(PLACE))
    nf.stream.export(maker.scene, tmp_path / "tiles", center=PLACE, **SETTINGS)
    for name in (_store.MANIFEST, _store.TILESET):
        assert parts[-1].files[name] == (tmp_path / "tiles" / name).read_bytes()
    # Maps are named by their content: they equal those of the undivided scene. Triangles are in another order.
    nf.stream.export(scene, tmp_path / "whole", center=PLACE, **SETTINGS)
    found, expected = (
        json.loads((tmp_path / name / _store.MANIFEST).read_text())["regions"][0]["rings"]
        for name in ("tiles", "whole")
    )
    for one, other in zip(found, expected, strict=True):
        for key in ("map", "radius", "objects", "triangles", "stored"):
            assert one[key] == other[key]
    view = nf.Camera.look_at((2.6, 1.5, -1.4), (30, 3, -20), fov=nf.Fov.symmetric(90, 1.6), size=(160, 100))
    pictures = [
        nf.stream.open(tmp_path / name).at(3).render(view, samples=1, method="vertex").to_image()
        for name in ("tiles", "whole")
    ]
    np.testing.assert_array_equal(pictures[0], pictures[1])


def test_faces_and_vertices_keep_their_attributes() -> None:
    vertices, faces, objects = houses()
    random = np.random.default_rng(5)
    builder = nf.SceneBuilder()
    builder.objects(int(objects.max()) + 1)
    for color in random.uniform(0.2, 1.0, (5, 3)):
        builder.material((*color, 1.0))
    mesh = builder.mesh(
        vertices,
        faces,
        material=random.integers(0, 5, len(faces)).astype(np.int32),
        colors=random.integers(0, 256, (len(vertices), 4)).astype(np.uint8),
        uvs=random.uniform(0, 1, (len(vertices), 2)),
        normals=random.normal(size=(len(vertices), 3)),
        face_object=objects,
    )
    builder.instance(mesh)
    scene = builder.build()
    tiles = Tiles.divide(scene)
    assert len(tiles.boxes) > 9
    view = nf.Camera.look_at((-5, 40, 60), (0, 0, 0), fov=nf.Fov.symmetric(60), size=(120, 120))
    found, expected = (nf.render(each, view, channels=("color", "object_id")) for each in (tiles.scene, scene))
    np.testing.assert_array_equal(found.require("color"), expected.require("color"))
    np.testing.assert_array_equal(found.require("object_id"), expected.require("object_id"))


def test_objects_of_several_meshes_and_faces_without_one_stay_together() -> None:
    vertices, faces, objects = houses()
    objects[objects == 7] = -1
    builder = nf.SceneBuilder()
    builder.objects(["shared", *(f"house {n}" for n in range(1, objects.max() + 1))])
    builder.instance(builder.mesh(vertices, faces, face_object=objects))
    post = builder.mesh(np.diag([0.2, 3.0, 0.2]), [[0, 1, 2]])
    builder.place_many(post, np.tile(np.eye(4), (2, 1, 1)), ["shared", "post"])
    scene = builder.build()
    tiles = Tiles.divide(scene)
    assert len(tiles.boxes) > 9
    assert tiles.scene.triangle_count == scene.triangle_count
    meshes = [nf._core.mesh_parts(mesh) for mesh in tiles.parts["meshes"]]
    assert not any(np.isin(mesh["objects"], [0, -1]).any() for mesh in meshes[: len(tiles.boxes)])
    assert set(meshes[len(tiles.boxes)]["objects"].tolist()) == {0, -1}
    expected = nf.stream.assign(scene, center=PLACE, radii=(10.0, 22.0))
    rings = nf.stream.assign(tiles.scene_about(PLACE, 22.0), center=PLACE, radii=(10.0, 22.0))
    np.testing.assert_array_equal(rings.ring, expected.ring)
    assert rings.rest == expected.rest
    assert rings.summary() == expected.summary()


def test_small_meshes_are_not_divided(scene: nf.Scene, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(_tiles, "MIN_FACES", scene.triangle_count + 1)
    tiles = Tiles.divide(scene)
    assert tiles.scene is scene
    assert tiles.scene_about(PLACE, 22.0) is scene
