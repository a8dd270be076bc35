"""Large objects are divided into pieces, so that rings contain only their near parts."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar.stream import _pieces, _store
from nearfar.stream._on_demand import OnDemand
from nearfar.stream._pieces import divide

ACROSS, WIDTH = 40, 200.0
CENTER = (3.1, 1.7, -2.3)
SETTINGS: dict[str, Any] = {"radii": (10.0, 22.0), "face_size": 64, "samples": 1}


@pytest.fixture(autouse=True)
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(_pieces, "MIN_FACES", 1000)
    monkeypatch.setattr(_pieces, "PIECE_FACES", 4)


def ground() -> tuple[NDArray[np.float64], NDArray[np.uint32]]:
    """Hilly ground of 5 m squares, two triangles each."""
    x, z = np.meshgrid(np.linspace(-0.5, 0.5, ACROSS + 1), np.linspace(-0.5, 0.5, ACROSS + 1))
    vertices = np.column_stack([WIDTH * x.ravel(), np.sin(20.0 * x.ravel()) * 0.3, WIDTH * z.ravel()])
    corner = (np.arange(ACROSS)[:, None] * (ACROSS + 1) + np.arange(ACROSS)).ravel()
    a, b, c, d = corner, corner + 1, corner + ACROSS + 1, corner + ACROSS + 2
    return vertices, np.concatenate([np.column_stack(t) for t in ((a, c, b), (b, c, d))]).astype(np.uint32)


def town(**kwargs: Any) -> nf.Scene:
    """Ground with all attributes in one turned instance, a small box, and a large mesh with two placements."""
    vertices, faces = ground()
    random = np.random.default_rng(7)
    builder = nf.SceneBuilder()
    for color in random.uniform(0.2, 1.0, (3, 3)):
        builder.material((*color, 1.0))
    turn = np.array([[0, 0, 1, 0], [0, 1, 0, 0], [-1, 0, 0, 0], [0, 0, 0, 1]], np.float64)
    mesh = builder.mesh(
        vertices,
        faces,
        material=random.integers(0, 3, len(faces)).astype(np.int32),
        colors=random.integers(0, 256, (len(vertices), 4)).astype(np.uint8),
        uvs=random.uniform(0, 1, (len(vertices), 2)),
        normals=np.tile([0.0, 1.0, 0.0], (len(vertices), 1)),
    )
    builder.instance(mesh, turn, name="ground")
    builder.instance(builder.mesh([[4, 0, 0], [5, 0, 0], [4, 2, 0]], [[0, 1, 2]]), name="post")
    shared = builder.mesh(0.2 * vertices, faces)
    placements = np.tile(np.eye(4), (2, 1, 1))
    placements[:, :3, 3] = (0, 20, 300), (0, 20, -300)
    builder.place_many(shared, placements, ["roof a", "roof b"])
    return builder.build(**kwargs)


def rows(triangles: NDArray[Any]) -> NDArray[Any]:
    corners = triangles.reshape(-1, 9)
    return corners[np.lexsort(corners.T)]


def test_each_face_is_in_one_piece_and_keeps_its_place_and_surface() -> None:
    scene = town()
    divided = divide(scene)
    assert divided.object_names[: len(scene.object_names)] == scene.object_names
    assert divided.object_names[len(scene.object_names)] == "ground, piece 2"
    np.testing.assert_array_equal(divided.triangles(), scene.triangles())
    pieces = [name for name in divided.object_names if name.startswith("ground")]
    parts = [divided.subset(objects=[name]).triangles() for name in pieces]
    np.testing.assert_array_equal(rows(np.concatenate(parts)), rows(scene.subset(objects=["ground"]).triangles()))
    # Centroids lie in squares of 10 m: 16 m² per face, 4 faces, but no less than 8 m.
    spans = [np.ptp(part.mean(axis=1)[:, [0, 2]], axis=0).max() for part in parts]
    assert max(spans) <= 10.0
    assert len(parts) > 100
    assert len(np.unique(divided._core.mesh_ids())) == len(np.unique(scene._core.mesh_ids()))
    view = nf.Camera.look_at((-60, 40, 60), (0, 0, 0), fov=nf.Fov.symmetric(80), size=(80, 60))
    for channel in ("color", "range", "shading_normal", "albedo"):
        found, expected = (nf.render(each, view, channels=(channel,)).require(channel) for each in (divided, scene))
        np.testing.assert_array_equal(found, expected)


def test_rings_have_the_near_faces_alone(tmp_path: Path) -> None:
    scene = town()
    radii = nf.triangle_radii(scene.subset(objects=["ground"]).triangles(), center=CENTER)
    near = int((radii[:, 0] <= 22.0).sum())
    nf.stream.export(scene, tmp_path / "bundle", center=CENTER, **SETTINGS)
    manifest = json.loads((tmp_path / "bundle" / _store.MANIFEST).read_text())
    on_demand = json.loads(list(OnDemand(scene, grid=0.1, **SETTINGS).parts(CENTER))[-1].files[_store.MANIFEST])
    counts = [[ring["triangles"] for ring in each["regions"][0]["rings"]] for each in (manifest, on_demand)]
    assert counts[0] == counts[1]
    # The post has one triangle; pieces reach up to 10 m beyond the last radius.
    assert near < sum(counts[0]) <= 2 * near


def test_the_picture_of_all_rings_has_no_cracks(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    vertices, faces = ground()
    scene = nf.Scene.from_arrays(vertices, faces)
    nf.stream.export(scene, tmp_path / "pieces", center=CENTER, **SETTINGS)
    monkeypatch.setattr(_pieces, "MIN_FACES", len(faces) + 1)
    nf.stream.export(scene, tmp_path / "whole", center=CENTER, **SETTINGS)
    view = nf.Camera(CENTER, fov=nf.Fov.symmetric(90), size=(96, 96))
    below = nf.Camera.look_at(CENTER, (8, -3, 2), fov=nf.Fov.symmetric(100), size=(96, 96))
    # A whole ground is morphed as far as it reaches, the divided one ends in the map, whose texels are 1.4 degrees.
    for camera in (view, below):
        found, expected = (
            nf.stream.open(tmp_path / name).at(2).render(camera, samples=1, method="vertex").to_image()
            for name in ("pieces", "whole")
        )
        assert np.mean(np.abs(found.astype(float) - expected.astype(float)).max(axis=-1) > 16) < 0.005


@pytest.mark.parametrize("owner", [0, -1])
def test_faces_without_an_object_are_divided_too(owner: int) -> None:
    vertices, faces = ground()
    scene = nf.Scene.from_arrays(vertices, faces, np.full(len(faces), owner, np.int32), object_names=["all"])
    rings = nf.stream.assign(divide(scene), center=CENTER, radii=(10.0, 22.0))
    near = (nf.triangle_radii(scene.triangles(), center=CENTER)[:, 0] <= 22.0).sum()
    assert near <= sum(row["triangles"] for row in rings.summary()[:2]) < 3 * near


def test_small_narrow_and_moving_objects_stay_whole(monkeypatch: pytest.MonkeyPatch) -> None:
    vertices, faces = ground()
    narrow = nf.Scene.from_arrays(0.09 * vertices, faces)
    assert divide(narrow) is narrow
    moving = town(dynamic=["ground"])
    assert divide(moving) is moving
    monkeypatch.setattr(_pieces, "MIN_FACES", len(faces) + 1)
    scene = town()
    assert divide(scene) is scene
