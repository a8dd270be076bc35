"""Tests of opening files and folders as sources, and of the protocol."""

from __future__ import annotations

import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar._scene.options import Blend
from nearfar._source.tiles import TileFolder
from tests.support.city_cases import everything, write_json
from tests.support.gltf_cases import MATERIALS, gltf
from tests.support.query_cases import BOXES, soup
from tests.support.tile_cases import tile, tileset, write


class Halves:
    """A user-defined source: the part of a scene with x below 0."""

    def __init__(self, scene: nf.Scene) -> None:
        self._scene = scene

    @property
    def bounds(self) -> NDArray[np.float64]:
        return np.minimum(self._scene.bounds, [np.inf, np.inf, np.inf])

    def query(self, aabb: Any, detail: Any = 0.0) -> nf.Scene:
        return self._scene.query(aabb, detail)


def test_scenes_and_users_classes_are_sources() -> None:
    scene = soup()
    assert isinstance(scene, nf.SceneSource)
    assert isinstance(Halves(scene), nf.SceneSource)
    assert not isinstance(object(), nf.SceneSource)


def test_a_scene_file_is_read_completely(tmp_path: Path) -> None:
    nf.lod.export(soup(), tmp_path / "soup.glb", view=nf.Fov.symmetric(90))
    source, loaded = nf.open_source(tmp_path / "soup.glb"), nf.Scene.load(tmp_path / "soup.glb")
    assert np.array_equal(source.query(BOXES[0]).triangles(), loaded.query(BOXES[0]).triangles())
    assert np.array_equal(source.bounds, loaded.bounds)
    scaled = nf.open_source(tmp_path / "soup.glb", scale=2.0)
    assert np.allclose(scaled.bounds, 2 * loaded.bounds)


def test_cities_are_read_up_to_a_level(tmp_path: Path) -> None:
    path = write_json(tmp_path / "town.city.json", everything())
    source, loaded = nf.open_source(path, lod=1), nf.Scene.load(path, lod=1)
    assert isinstance(source, nf.Scene)
    assert 0 < source.triangle_count == loaded.triangle_count < nf.Scene.load(path).triangle_count


@pytest.mark.parametrize("kind", ["glb", "json"])
def test_materials_that_blend_are_cut_out(tmp_path: Path, kind: str) -> None:
    data = gltf([MATERIALS[0]])
    write(tmp_path, {"t.glb": data, "t.json": tileset(tile(0.0, "t.glb"))})
    notes: dict[Blend, str] = {"opaque": "opaque", "cutout": "where alpha is at least 1/2"}
    for blend, note in notes.items():
        part = nf.open_source(tmp_path / f"t.{kind}", blend=blend).query([[-np.inf] * 3, [np.inf] * 3])
        assert f"1 material with blending drawn {note}" in part.report.notes


@pytest.fixture(scope="module")
def tiles(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("written") / "tiles"
    nf.write_tiles(soup(), folder, cell=30)
    return folder


def test_folders_of_tiles_open_by_folder_and_by_index(tiles: Path) -> None:
    for path in (tiles, tiles / "tiles.json"):
        assert isinstance(nf.open_source(path), TileFolder)


def test_other_folders_are_refused(tmp_path: Path) -> None:
    with pytest.raises(nf.SceneError, match="expected a file, or a folder of tiles"):
        nf.open_source(tmp_path)
    with pytest.raises(FileNotFoundError):
        nf.open_source(tmp_path / "nowhere.glb")


@pytest.mark.parametrize(
    "given", [{"up": "z"}, {"scale": 2.0}, {"max_bytes": 9}, {"lod": 1}, {"blend": "cutout"}, {"error": 2.0}]
)
def test_unsupported_arguments_of_tile_folders_are_refused(tiles: Path, given: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match=f"^{next(iter(given))}: expected none"):
        nf.open_source(tiles, **given)


def assert_same_in_another_process(source: nf.SceneSource, box: NDArray[np.float64]) -> None:
    """Check that a source gives the same results after pickling, as for cluster workers, and after use."""
    expected = source.query(box)
    again = pickle.loads(pickle.dumps(source))
    np.testing.assert_array_equal(again.bounds, source.bounds)
    assert expected.triangle_count > 0
    np.testing.assert_array_equal(again.query(box).triangles(), expected.triangles())


def test_sources_can_be_pickled(tiles: Path, tmp_path: Path) -> None:
    write(tmp_path, {"t.glb": gltf([MATERIALS[0]]), "t.json": tileset(tile(0.0, "t.glb"))})
    for source in (
        soup(),
        nf.open_source(tiles),
        nf.open_source(tmp_path / "t.json"),
        nf.datasets.asteroids(count=5, polygons=48),
    ):
        assert_same_in_another_process(source, np.array([[-np.inf] * 3, [np.inf] * 3]))
    assert_same_in_another_process(nf.datasets.world(1), np.array([[0.0, 0.0, 0.0], [30.0, 90.0, 30.0]]))
