"""The tileset of a bundle: its boxes contain the geometry, in the axes to which 3D Tiles viewers rotate it."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar.stream._tileset import GRID
from tests.support import valid

CENTER = (3.0, 1.7, -2.0)
SETTINGS: dict[str, Any] = {"center": CENTER, "radii": [10.0, 22.0, 63.0], "face_size": 64, "samples": 1}


@pytest.fixture(scope="module")
def city() -> nf.Scene:
    return nf.datasets.city(blocks=2, detail=0)


@pytest.fixture(scope="module", params=["meshopt", None])
def bundle(city: nf.Scene, request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("tilesets") / "city"
    nf.stream.export(city, path, **SETTINGS, compression=request.param)
    return path


def box_in_glb_axes(tile: dict[str, Any]) -> NDArray[np.float64]:
    """Corners (2, 3) of a tile's box, rotated back to y-up."""
    numbers = np.array(tile["boundingVolume"]["box"])
    axes = numbers[3:].reshape(3, 3)
    assert (axes == np.diag(np.diag(axes))).all()
    (x, y, z), (dx, dy, dz) = numbers[:3], np.diag(axes)
    return np.array([[x - dx, z - dz, -y - dy], [x + dx, z + dz, -y + dy]])


def documents(folder: Path) -> tuple[dict[str, Any], dict[str, Any]]:
    tileset, manifest = (json.loads((folder / f"{name}.json").read_text()) for name in ("tileset", "manifest"))
    return tileset, manifest


def test_every_ring_with_geometry_is_a_tile(bundle: Path) -> None:
    tileset, manifest = documents(bundle)
    assert valid(tileset, "tileset")
    root = tileset["root"]
    rings = [
        (number, ring) for number, ring in enumerate(manifest["regions"][0]["rings"]) if ring["geometry"] is not None
    ]
    tiles = [tile for tile in root["children"] if "ring" in tile["extras"]]
    assert [tile["extras"] for tile in tiles] == [{"ring": n, "radius": ring["radius"]} for n, ring in rings]
    assert [tile["content"]["uri"] for tile in tiles] == [ring["geometry"] for _, ring in rings]
    moving = [tile["content"]["uri"] for tile in root["children"] if "dynamic" in tile["extras"]]
    assert moving == [manifest["dynamic"]["geometry"]]
    # Viewers refine the root, which is empty, from anywhere that shows a pixel of it.
    extent = np.linalg.norm(np.ptp(box_in_glb_axes(root), axis=0))
    assert root["geometricError"] >= extent - 4 * GRID
    assert "content" not in root


def test_boxes_are_tight(bundle: Path) -> None:
    root = documents(bundle)[0]["root"]
    whole = box_in_glb_axes(root)
    for tile in root["children"]:
        bounds = nf.Scene.load(bundle / tile["content"]["uri"]).bounds
        box = box_in_glb_axes(tile)
        outside = np.stack([bounds[0] - box[0], box[1] - bounds[1]])
        assert outside.min() > 0.5 * GRID  # Half of the step to the outside, for float32 in rotated copies.
        # Boxes of rotated copies are boxes around rotated boxes.
        assert outside.max() < 3.0
        assert (whole[0] <= box[0]).all()
        assert (whole[1] >= box[1]).all()


def test_boxes_follow_the_rotation_by_viewers(tmp_path: Path) -> None:
    # East 1 to 2 m, 3 to 5 m high, 7 to 10 m north, which is -z in glTF and +y in tilesets.
    corners = [[1, 3, -7], [2, 3, -7], [2, 5, -10]]
    bundle = nf.stream.export(
        nf.Scene.from_arrays(corners, [[0, 1, 2]]), tmp_path / "b", **{**SETTINGS, "center": (0, 0, 0)}
    )
    tile = documents(tmp_path / "b")[0]["root"]["children"][0]
    grown = np.array([0.5, 1.5, 1.0]) + GRID
    expected = [1.5, 8.5, 4.0, grown[0], 0, 0, 0, grown[1], 0, 0, 0, grown[2]]
    assert tile["boundingVolume"]["box"] == expected
    assert bundle.read("tileset.json") == (tmp_path / "b" / "tileset.json").read_bytes()


def test_a_scene_far_from_the_origin_has_boxes_there(tmp_path: Path) -> None:
    place = np.array([500_000.0, 20.0, -300_000.0])
    scene = nf.Scene.from_arrays(np.add(place, [[-5, 0, -8], [5, 0, -8], [5, 5, -8]]), [[0, 1, 2]])
    nf.stream.export(scene, tmp_path / "b", **{**SETTINGS, "center": place})
    box = box_in_glb_axes(documents(tmp_path / "b")[0]["root"]["children"][0])
    np.testing.assert_allclose(box - place, [[-5, 0, -8], [5, 5, -8]], atol=2.5 * GRID)


def test_a_bundle_without_near_geometry_has_a_tileset_without_tiles(tmp_path: Path) -> None:
    wall = nf.Scene.from_arrays([[-5, -5, -80], [5, -5, -80], [5, 5, -80]], [[0, 1, 2]])
    nf.stream.export(wall, tmp_path / "b", **SETTINGS | {"radii": [10.0]})
    tileset, _ = documents(tmp_path / "b")
    assert valid(tileset, "tileset")
    assert "children" not in tileset["root"]
