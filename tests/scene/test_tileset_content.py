"""Tests of the content of tiles: instances, batches, composites, and the frames of their glTF."""

from __future__ import annotations

import gzip
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, strategies as st
from numpy.typing import NDArray

import nearfar as nf
from nearfar._scene.frames import earth_centred, east_north_up
from nearfar._scene.tileset import tables
from nearfar._scene.tileset.tileset import Tileset
from tests.support.tile_cases import Y_UP_TO_Z_UP, b3dm, cmpt, glb, instanced, tile, tileset, write

TO_SCENE = np.array([[1.0, 0, 0, 0], [0, 0, 1, 0], [0, -1, 0, 0], [0, 0, 0, 1]])


def model_transforms(path: Path) -> NDArray[np.float64]:
    """Transforms model→tile (N, 4, 4) of a tile without a position on the Earth, z up."""
    nodes = Tileset.open(path).read().nodes
    return np.asarray(np.linalg.inv(TO_SCENE) @ nodes.transforms)


def rigid(turn: Any, place: Any, size: Any = 1.0) -> NDArray[np.float64]:
    matrix = np.eye(4)
    matrix[:3, :3] = np.asarray(turn) * size
    matrix[:3, 3] = place
    return np.asarray(matrix @ Y_UP_TO_Z_UP)


PLACES = np.array([[0, 0, 0], [10, -20, 30], [1.5, 2.5, -3.5]], np.float32)


def turns(seed: int, count: int = 3) -> NDArray[np.float64]:
    """Rotations (N, 3, 3)."""
    matrices = np.linalg.qr(np.random.default_rng(seed).normal(size=(count, 3, 3)))[0]
    return np.asarray(matrices * np.sign(np.linalg.det(matrices))[:, None, None])


def test_instances_are_rotated_and_scaled(tmp_path: Path) -> None:
    rotations = turns(1)
    sizes = np.array([[1, 2, 3], [0.5, 0.5, 0.5], [4, 1, 1]], np.float32)
    rows: dict[str, Any] = {
        "POSITION": PLACES,
        "NORMAL_RIGHT": rotations[:, :, 0].astype(np.float32),
        "NORMAL_UP": rotations[:, :, 1].astype(np.float32),
        "SCALE": np.array([1, 2, 3], np.float32),
        "SCALE_NON_UNIFORM": sizes,
    }
    path = write(tmp_path, {"a.i3dm": instanced(glb(), 3, **rows)})
    expected = [rigid(rotations[n], PLACES[n], sizes[n] * (n + 1)) for n in range(3)]
    np.testing.assert_allclose(model_transforms(path), expected, atol=2e-6)


def encoded(vectors: NDArray[np.float64]) -> NDArray[np.uint16]:
    """Unit vectors as two numbers of 16 bits, one at a time and by the definition."""
    codes = []
    for x, y, z in vectors.tolist():
        total = abs(x) + abs(y) + abs(z)
        u, v = x / total, y / total
        if z < 0:
            u, v = (1 - abs(v)) * (1 if u >= 0 else -1), (1 - abs(u)) * (1 if v >= 0 else -1)
        codes.append([round((u + 1) / 2 * 65535), round((v + 1) / 2 * 65535)])
    return np.array(codes, np.uint16)


def test_packed_instances(tmp_path: Path) -> None:
    rotations = turns(2)
    rows: dict[str, Any] = {
        "POSITION_QUANTIZED": np.array([[0, 0, 0], [65535, 65535, 65535], [13107, 26214, 52428]], np.uint16),
        "QUANTIZED_VOLUME_OFFSET": [-10, 5, 1000],
        "QUANTIZED_VOLUME_SCALE": [100, 10, 1],
        "NORMAL_RIGHT_OCT32P": encoded(rotations[:, :, 0]),
        "NORMAL_UP_OCT32P": encoded(rotations[:, :, 1]),
        "RTC_CENTER": [7, 8, 9],
    }
    path = write(tmp_path, {"a.i3dm": instanced(glb(), 3, **rows)})
    expected = np.array([[-3, 13, 1009], [97, 23, 1010], [17, 17, 1009.8]])
    for n, matrix in enumerate(model_transforms(path)):
        # Axes of 16 bits are off by up to 4e-5.
        np.testing.assert_allclose(matrix, rigid(rotations[n], expected[n]), atol=1e-4)


@given(st.lists(st.tuples(*[st.floats(-1, 1)] * 3).filter(lambda v: np.linalg.norm(v) > 0.1), min_size=1, max_size=9))
def test_packed_axes_are_near_the_originals(vectors: list[tuple[float, float, float]]) -> None:
    units = np.array(vectors) / np.linalg.norm(vectors, axis=1, keepdims=True)
    found = tables.from_octahedron(encoded(units))
    # Half a step of each of two numbers, which the sphere stretches by up to 3.
    assert np.linalg.norm(found - units, axis=1).max() < 3 * np.sqrt(2) / 65535


def test_instances_stand_upright_on_the_earth(tmp_path: Path) -> None:
    """Includes instances of a rotated tile, whose axes are not the Earth's."""
    angles = np.array([[0.3, 0.6, 100.0], [0.3001, 0.6001, 0.0]])
    center = earth_centred(angles[0])
    turn = turns(4, 1)[0]
    local = (earth_centred(angles) - center) @ turn  # The tile's frame has its origin at the centre.
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = turn, center
    tile_file = instanced(glb(), 2, POSITION=local.astype(np.float32), EAST_NORTH_UP=True)
    described = tile(0.0, "a.i3dm", transform=matrix.T.ravel().tolist())
    path = write(tmp_path, {"tileset.json": tileset(described), "a.i3dm": tile_file})
    degrees = (*np.degrees(angles[0, :2]).tolist(), 100.0)
    scene = nf.Scene.load(path, origin=degrees)
    # The model's x, y and z point east, up and south, like the scene's at its origin.
    np.testing.assert_allclose(scene.bounds[:, 1] - scene.bounds[0, 1], [0, scene.bounds[1, 1] - scene.bounds[0, 1]])
    np.testing.assert_allclose(scene.transform("a/0"), np.eye(4), atol=1e-6)
    up = east_north_up(angles)
    expected = up[0].T @ up[1]
    turned = np.linalg.inv(TO_SCENE[:3, :3]) @ scene.transform("a/1")[:3, :3] @ np.linalg.inv(Y_UP_TO_Z_UP[:3, :3])
    np.testing.assert_allclose(turned, expected, atol=1e-9)


@pytest.mark.parametrize("embedded", [True, False])
def test_external_models_of_an_i3dm(tmp_path: Path, embedded: bool) -> None:
    model = glb()
    data = instanced(model if embedded else b"models/box%20one.glb  \0", 3, embedded=embedded, POSITION=PLACES)
    path = write(tmp_path, {"a.i3dm": data, "models/box one.glb": model})
    scene = nf.Scene.load(path)
    assert (scene.report.instances, scene.report.meshes) == (3, 1)
    assert scene.object_names == ("a/0", "a/1", "a/2")
    np.testing.assert_allclose(np.ptp(scene.bounds, axis=0), [11, 34.5, 23.5])


def test_a_model_of_several_parts_keeps_their_names(tmp_path: Path) -> None:
    nodes = [{"mesh": 0, "name": "stem", "children": [1]}, {"mesh": 0, "name": "crown", "translation": [0, 2, 0]}]
    path = write(tmp_path, {"tree.i3dm": instanced(glb(nodes=nodes), 2, POSITION=PLACES[:2])})
    scene = nf.Scene.load(path)
    assert sorted(scene.object_names) == [f"tree/{n}/{name}" for n in (0, 1) for name in ("crown", "stem")]
    np.testing.assert_allclose(scene.transform("tree/1/crown")[:3, 3], [10, 32, 20])


@pytest.mark.parametrize("up", ["X", "Y", "Z"])
def test_the_axis_that_points_up(tmp_path: Path, up: str) -> None:
    corners = np.eye(3)["XYZ".index(up)] * 5
    model = glb(np.array([corners, [0.1, 0.2, 0.3], [0.3, 0.1, 0.2]]), [[0, 1, 2]])
    document = tileset(tile(0.0, "a.glb"), asset={"version": "1.0", "gltfUpAxis": up.lower()})
    scene = nf.Scene.load(write(tmp_path, {"tileset.json": document, "a.glb": model}))
    np.testing.assert_allclose(scene.bounds[1, 1], 5.0)


@pytest.mark.parametrize("kind", ["b3dm", "extension", "both"])
def test_centres_are_in_the_tile_s_frame(tmp_path: Path, kind: str) -> None:
    center = [1_215_000.25, -4_736_000.5, 4_081_000.125]
    extension: dict[str, Any] = {
        "extensionsUsed": ["CESIUM_RTC"],
        "extensionsRequired": ["CESIUM_RTC"],
        "extensions": {"CESIUM_RTC": {"center": center}},
    }
    model = glb(**(extension if kind != "b3dm" else {}))
    features = {"BATCH_LENGTH": 0} | (
        {"RTC_CENTER": [0, 0, 0] if kind == "both" else center} if kind != "extension" else {}
    )
    tileset_of = Tileset.open(write(tmp_path, {"a.b3dm": b3dm(model, features)}))
    content = tileset_of.read()
    matrix = np.linalg.inv(tileset_of.frame.to_scene) @ content.nodes.transforms[0]
    # A step of float64 at the Earth's radius is 1e-9 m.
    np.testing.assert_allclose(matrix, rigid(np.eye(3), center), rtol=0, atol=1e-8)
    assert not any("RTC" in note for note in content.notes)


def test_a_composite_tile(tmp_path: Path) -> None:
    inner = cmpt(b3dm(glb(), {"BATCH_LENGTH": 0, "RTC_CENTER": [0, 0, 50]}))
    data = cmpt(b3dm(glb()), instanced(glb(), 3, POSITION=PLACES), inner, points())
    scene = nf.Scene.load(write(tmp_path, {"a.cmpt": data}))
    assert scene.object_names == ("a/0", "a/1/0", "a/1/1", "a/1/2", "a/2")
    assert scene.triangle_count == 5 * 12
    assert scene.bounds[1, 1] == pytest.approx(50.5)
    assert "tile of points ignored" in scene.report.notes


def points() -> bytes:
    """A tile of points; only its header is read."""
    return b"pnts" + np.array([1, 28, 0, 0, 0, 0], "<u4").tobytes()


def test_tables_without_bytes_have_their_stated_rows(tmp_path: Path) -> None:
    data = instanced(glb(), 2, POSITION=[0, 0, 0, 10, 0, 0], SCALE=[1, 2])
    np.testing.assert_allclose(
        model_transforms(write(tmp_path, {"a.i3dm": data})), [rigid(np.eye(3), 0), rigid(np.eye(3), [10, 0, 0], 2)]
    )


def test_packed_tiles(tmp_path: Path) -> None:
    document = gzip.compress(tileset(tile(0.0, "a.b3dm")))
    scene = nf.Scene.load(write(tmp_path, {"tileset.json.gz": document, "a.b3dm": gzip.compress(b3dm(glb()))}))
    assert scene.triangle_count == 12
    alone = write(tmp_path, {"b.b3dm.gz": gzip.compress(b3dm(glb()))})
    assert nf.Scene.load(alone).triangle_count == 12


def test_a_gltf_with_external_files(tmp_path: Path) -> None:
    document = glb()
    size = int.from_bytes(document[12:16], "little")
    text, binary = document[20 : 20 + size], document[28 + size :]
    text = text.replace(b'"byteLength": 240}]', b'"byteLength": 240, "uri": "parts/a%20b.bin"}]')
    files = {"tileset.json": tileset(tile(0.0, "models/a.gltf")), "models/a.gltf": text, "models/parts/a b.bin": binary}
    assert nf.Scene.load(write(tmp_path, files)).triangle_count == 12


def test_one_file_used_by_many_tiles_is_one_mesh(tmp_path: Path) -> None:
    shifts = [np.array([1.0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 10 * n, 0, 0, 1]).tolist() for n in range(4)]
    children = [tile(0.0, "a.b3dm", transform=shift) for shift in shifts]
    scene = nf.Scene.load(
        write(tmp_path, {"tileset.json": tileset(tile(9.0, children=children)), "a.b3dm": b3dm(glb())})
    )
    assert (scene.report.instances, scene.report.meshes) == (4, 1)
    assert scene.object_names == ("a", "a_1", "a_2", "a_3")
    np.testing.assert_allclose(np.ptp(scene.bounds, axis=0), [31, 1, 1])
