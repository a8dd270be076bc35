"""Tests of tilesets made by other programs: those of cesium-native, and output of 3d-tiles-tools."""

from __future__ import annotations

import base64
import json
import struct
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar._scene import frames
from nearfar._scene.budget import Budget
from nearfar._scene.content import Content
from nearfar._scene.gltf.document import read as read_gltf
from nearfar._scene.materials import Materials
from nearfar._scene.tileset.tileset import Tileset
from tests.support import data, need
from tests.support.tile_cases import write

WILD = "wild/cesium-native/Cesium3DTilesSelection/test/data"
MADE = json.loads((Path(__file__).parent / "tiles.json").read_text(encoding="utf-8"))["files"]
"""Files of 3d-tiles-tools, which takes 208 MB, in base64."""

MILLIMETRE = 1e-3


def write_samples(folder: Path, *names: str) -> Path:
    """Write files of 3d-tiles-tools; returns the path of the first one."""
    return write(folder, {name: base64.b64decode(MADE[name]) for name in names})


def on_earth(path: Path) -> NDArray[np.float64]:
    """Corners (T, 3, 3) of a b3dm of one mesh in the Earth's frame, read by independent code."""
    file = path.read_bytes()
    lengths = struct.unpack_from("<4I", file, 12)
    center = json.loads(file[28 : 28 + lengths[0]])["RTC_CENTER"]
    model = file[28 + sum(lengths) :]
    size = struct.unpack_from("<I", model, 12)[0]
    document, binary = json.loads(model[20 : 20 + size]), model[28 + size :]
    primitive = document["meshes"][0]["primitives"][0]

    def rows(number: int, kind: str, width: int) -> NDArray[np.float64]:
        accessor = document["accessors"][number]
        view = document["bufferViews"][accessor["bufferView"]]
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        step = view.get("byteStride", width * np.dtype(kind).itemsize)
        shape = (accessor["count"], width)
        return np.ndarray(shape, kind, binary, start, (step, np.dtype(kind).itemsize)).astype(np.float64)

    kind = {5123: "<u2", 5125: "<u4"}[document["accessors"][primitive["indices"]]["componentType"]]
    faces = rows(primitive["indices"], kind, 1).astype(int).reshape(-1, 3)
    matrix = np.array(document["nodes"][0]["matrix"]).reshape(4, 4).T
    corners = rows(primitive["attributes"]["POSITION"], "<f4", 3) @ matrix[:3, :3].T + matrix[:3, 3]
    # glTF is y up, tiles are z up.
    return np.asarray((corners[:, [0, 2, 1]] * (1, -1, 1) + center)[faces])


def topocentric(points: NDArray[np.float64], origin: tuple[float, float, float]) -> NDArray[np.float64]:
    """Points (…, 3) of the Earth's frame in the scene's frame about a place, by PROJ."""
    need("pyproj")
    import pyproj

    longitude, latitude, height = origin
    pipeline = f"+proj=topocentric +ellps=WGS84 +lon_0={longitude} +lat_0={latitude} +h_0={height}"
    east, north, up = pyproj.Transformer.from_pipeline(pipeline).transform(*points.reshape(-1, 3).T)
    return np.column_stack([east, up, -north]).reshape(points.shape)


def ordered(triangles: NDArray[np.floating]) -> NDArray[np.float64]:
    """Triangles ordered by centroid in steps of a centimetre."""
    middles = np.rint(triangles.mean(axis=1) * 100)
    return np.asarray(triangles, np.float64)[np.lexsort(middles.T)]


def assert_same(scene: nf.Scene, files: list[Path], origin: tuple[float, float, float]) -> None:
    expected = topocentric(np.concatenate([on_earth(path) for path in files]), origin)
    np.testing.assert_allclose(ordered(scene.triangles() + scene.origin), ordered(expected), rtol=0, atol=MILLIMETRE)


ORIGIN = (-75.612, 40.0425, 12.0)


@pytest.mark.parametrize("version", ["1.0", "1.1"])
def test_implicit_tilings(version: str) -> None:
    folder = data(f"{WILD}/ImplicitTileset")
    scene = nf.Scene.load(folder / f"tileset_{version}.json", origin=ORIGIN)
    assert scene.object_names == tuple(f"content/{key}" for key in ("0/0/0", "1/0/0", "1/1/0", "1/0/1", "1/1/1"))
    assert_same(scene, sorted(folder.glob("content/**/*.b3dm")), ORIGIN)
    coarse = nf.Scene.load(folder / f"tileset_{version}.json", origin=ORIGIN, error=70)
    assert_same(coarse, [folder / "content/0/0/0.b3dm"], ORIGIN)
    assert "1 tile of 3D Tiles, with a geometric error of up to 70 m" in coarse.report.used


@pytest.mark.parametrize(
    ("error", "names"),
    [(None, "ll_ll lr ur ul"), (0, "ll_ll lr ur ul"), (5, "ll lr ur ul"), (69, "ll lr ur ul"), (70, "parent")],
)
def test_tiles_that_replace_others(error: float | None, names: str) -> None:
    folder = data(f"{WILD}/ReplaceTileset")
    scene = nf.Scene.load(folder / "tileset.json", error=error, origin=ORIGIN)
    assert scene.object_names == tuple(names.split())
    assert_same(scene, [folder / f"{name}.b3dm" for name in names.split()], ORIGIN)


def test_the_default_origin_of_a_tileset_is_its_middle() -> None:
    path = data(f"{WILD}/ReplaceTileset/tileset.json")
    scene = nf.Scene.load(path)
    middle = (-1.3197209591796106 - 1.3196390408203893) / 2, (0.6988424218 + 0.6989055782) / 2
    expected = [f"{np.degrees(angle):.9f}°" for angle in middle]
    assert all(text in scene.report.notes[0] for text in (*expected, "height 44.000 m"))
    # The volume's lowest height is 0, where the buildings stand.
    assert scene.bounds[0, 1] == pytest.approx(-44.0, abs=0.01)
    assert not scene.origin.any()


def test_a_damaged_child_is_named_and_omitted() -> None:
    folder = data(f"{WILD}/ErrorChildrenAddTileset")
    scene = nf.Scene.load(folder / "tileset.json", origin=ORIGIN)
    assert scene.object_names == ("parent", "ur", "ul")
    assert_same(scene, [folder / f"{name}.b3dm" for name in scene.object_names], ORIGIN)
    words = "1 file of tiles left out: error_lr.b3dm cannot be used: it begins with b'erro'"
    assert any(note.startswith(words) for note in scene.report.notes)


@pytest.mark.parametrize(
    ("folder", "name"),
    [("InstancedOrientation", "instancedOrientation"), ("InstancedWithBatchIds", "instancedWithBatchIds")],
)
def test_instances_equal_another_program(folder: str, name: str) -> None:
    tileset = Tileset.open(data(f"{WILD}/i3dm/{folder}/{name}.i3dm"))
    content = tileset.read()
    converted: Content = read_gltf(
        name, base64.b64decode(MADE[f"{name}.glb"]), "glb", None, Materials(Budget()), Budget()
    )
    placed = np.linalg.inv(tileset.frame.to_scene) @ content.nodes.transforms
    expected = frames.TO_Z_UP["Y"] @ converted.nodes.transforms
    assert len(placed) == 25
    # The other program rounds to float32 about a centre: 10 micrometres at 100 m.
    np.testing.assert_allclose(placed[:, :3, 3], expected[:, :3, 3], rtol=0, atol=MILLIMETRE / 100)
    np.testing.assert_allclose(placed[:, :3, :3], expected[:, :3, :3], rtol=0, atol=1e-6)


@pytest.mark.parametrize("folder", ["InstancedOrientation", "InstancedWithBatchIds", "InstancedWithBatchTable"])
def test_instances_share_a_mesh(folder: str) -> None:
    scene = nf.Scene.load(data(f"{WILD}/i3dm/{folder}/tileset.json"))
    assert (scene.report.instances, scene.report.meshes, scene.triangle_count) == (25, 1, 300)
    assert "1 file of tiles with properties of features, which are ignored" in scene.report.notes
    if folder != "InstancedOrientation":
        # Cubes of 20 m stand upright: the batch table gives the height of their tops.
        heights = np.unique(np.rint(scene.triangles()[:, :, 1] + 15))
        np.testing.assert_array_equal(heights, [0, 20])


@pytest.mark.parametrize(
    ("folder", "words"),
    [
        ("InvalidFeatureTable", "feature table: expected a POSITION for each of 1 instances, got none"),
        ("ObsoleteGltf", "it holds glTF 1.0, and only glTF 2 is read"),
    ],
)
def test_a_tileset_without_a_usable_tile_is_refused(folder: str, words: str) -> None:
    path = data(f"{WILD}/i3dm/{folder}/tileset.json")
    with pytest.raises(nf.SceneError, match="no triangles") as caught:
        nf.Scene.load(path)
    assert words in str(caught.value)
    tile = next(path.parent.glob("*.i3dm"))
    with pytest.raises(nf.SceneError) as caught:
        nf.Scene.load(tile)
    assert str(caught.value).startswith(f"{tile}: {words}")


@pytest.mark.parametrize("name", ["cube.b3dm", "cube.i3dm", "draco.b3dm"])
def test_tiles_of_3d_tiles_tools(tmp_path: Path, name: str) -> None:
    if name.startswith("draco"):
        need("DracoPy")
    scene = nf.Scene.load(write_samples(tmp_path, name))
    assert scene.triangle_count == 12
    # Draco rounds to 2^-11 of the size.
    np.testing.assert_allclose(scene.bounds, [[0.5, 1.5, 2.5], [1.5, 2.5, 3.5]], atol=1e-3 if "draco" in name else 1e-6)


def test_a_tileset_placed_on_the_earth_by_3d_tiles_tools(tmp_path: Path) -> None:
    path = write_samples(tmp_path, "tileset.json", "cube.i3dm")
    scene = nf.Scene.load(path, origin=(139.767, 35.681, 40))
    # Tilesets rotate y to z, and the scene's frame rotates it back.
    np.testing.assert_allclose(scene.bounds, [[0.5, 1.5, 2.5], [1.5, 2.5, 3.5]], rtol=0, atol=MILLIMETRE / 1000)
