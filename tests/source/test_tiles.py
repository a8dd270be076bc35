"""Tests of folders of tiles: written from sources, read back box by box."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import pytest
from numpy.typing import ArrayLike, NDArray

import nearfar as nf
from nearfar._scene.report import Unread
from nearfar._source.protocol import unread_in
from nearfar._source.tiles import TileFolder
from tests.support import load_schema
from tests.support.query_cases import BOXES, contents, soup

EVERYWHERE = np.array([[-np.inf] * 3, [np.inf] * 3])


@pytest.fixture(scope="module", params=[(0, 0, 0), (4.0e6, 10.0, -9.0e5)], ids=["near", "far"])
def scene_and_folder(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[nf.Scene, Path]:
    scene = soup(request.param)
    folder = tmp_path_factory.mktemp("written") / "tiles"
    nf.write_tiles(scene, folder, cell=5)
    return scene, folder


def open_tiles(folder: Path, **given: Any) -> TileFolder:
    source = nf.open_source(folder, **given)
    assert isinstance(source, TileFolder)
    return source


def rows(scene: nf.Scene) -> NDArray[np.bytes_]:
    """Bytes of all triangles with object names and materials' colours, sorted, since tiles are in another order."""
    found = contents(scene)
    names = np.array([*scene.object_names, ""], "S16")[found["objects"]]
    fields = [names, *(found[name].reshape(len(names), -1) for name in ("corners", "uvs", "colors"))]
    table = np.hstack([np.ascontiguousarray(field).reshape(len(names), -1).view(np.uint8) for field in fields])
    return np.sort(table.view(f"S{table.shape[1]}").ravel())


def test_every_triangle_is_in_one_tile_bit_for_bit(scene_and_folder: tuple[nf.Scene, Path]) -> None:
    scene, folder = scene_and_folder
    source = open_tiles(folder)
    assert len(source) > 10
    assert source.triangle_count == scene.triangle_count
    assert np.array_equal(source.bounds, scene.bounds)
    whole = source.query(EVERYWHERE)
    assert np.array_equal(whole.origin, scene.origin)
    assert np.array_equal(rows(whole), rows(scene))


@pytest.mark.parametrize("box", BOXES)
def test_queries_equal_those_of_the_scene(scene_and_folder: tuple[nf.Scene, Path], box: ArrayLike) -> None:
    scene, folder = scene_and_folder
    aabb = np.asarray(box, np.float64) + np.rint(scene.bounds.mean(axis=0))
    part, expected = open_tiles(folder).query(aabb), scene.query(aabb)
    assert expected.triangle_count
    assert np.array_equal(rows(part), rows(expected))
    assert open_tiles(folder).touches(aabb)
    assert not open_tiles(folder).touches(aabb + 10**6) or np.isinf(aabb).any()


def test_materials_and_pictures_are_unchanged(scene_and_folder: tuple[nf.Scene, Path]) -> None:
    scene, folder = scene_and_folder
    middle = scene.bounds.mean(axis=0)
    camera = nf.Camera.look_at(middle + np.array([0, 5, 30]), middle, fov=nf.Fov.symmetric(40), size=(96, 96))
    shown = nf.render(open_tiles(folder).query(EVERYWHERE), camera, channels=("color", "range"))
    truth = nf.render(scene, camera, channels=("color", "range"))
    assert shown.range is not None
    assert truth.range is not None
    assert np.array_equal(np.isfinite(shown.range), np.isfinite(truth.range))
    assert shown.color is not None
    assert truth.color is not None
    assert (np.abs(shown.color - truth.color).max(axis=2) < 1 / 255).mean() > 0.999


def test_a_moving_object_stays_one_moving_object(scene_and_folder: tuple[nf.Scene, Path]) -> None:
    scene, folder = scene_and_folder
    whole = open_tiles(folder).query(EVERYWHERE)
    assert whole.poses.keys() == scene.poses.keys()
    pose = scene.poses["car 2"].copy()
    pose[:3, 3] += (1, 2, 3)
    moved, expected = whole.at({"car 2": pose}), scene.at({"car 2": pose})
    assert np.array_equal(rows(moved.subset(objects=["car 2"])), rows(expected.subset(objects=["car 2"])))
    assert np.array_equal(whole.transform("car 2"), scene.transform("car 2"))


def test_only_touching_tiles_are_read(scene_and_folder: tuple[nf.Scene, Path]) -> None:
    scene, folder = scene_and_folder
    source = open_tiles(folder)
    aabb = np.asarray(BOXES[0], np.float64) + np.rint(scene.bounds.mean(axis=0))
    source.query(aabb)
    index = json.loads((folder / "tiles.json").read_text())
    boxes = np.array([tile["box"] for tile in index["tiles"]])
    touching = ((boxes[:, 0] <= aabb[1]) & (boxes[:, 1] >= aabb[0])).all(axis=1)
    assert set(source._cache) == {tile["file"] for tile, near in zip(index["tiles"], touching, strict=True) if near}
    assert 0 < touching.sum() < len(boxes)


@pytest.mark.parametrize("most", [0, 100_000])
def test_the_cache_is_bounded_and_changes_nothing(scene_and_folder: tuple[nf.Scene, Path], most: int) -> None:
    scene, folder = scene_and_folder
    source = open_tiles(folder, cache_bytes=most)
    middle = np.rint(scene.bounds.mean(axis=0))
    for box in (BOXES[0], BOXES[5], BOXES[0]):
        aabb = np.asarray(box, np.float64) + middle
        assert np.array_equal(rows(source.query(aabb)), rows(scene.query(aabb)))
        assert source.cached_bytes <= most
    assert (len(source._cache) > 0) == (most > 0)


def test_indexes_have_tight_boxes_and_fit_their_schema(scene_and_folder: tuple[nf.Scene, Path]) -> None:
    _, folder = scene_and_folder
    document = json.loads((folder / "tiles.json").read_text())
    jsonschema.validate(document, load_schema("tiles"))
    for tile in document["tiles"]:
        loaded = nf.Scene.load(folder / tile["file"])
        assert loaded.triangle_count == tile["triangles"]
        assert np.allclose(loaded.bounds, tile["box"], atol=1e-3)


def test_nameless_objects_keep_their_numbers(tmp_path: Path) -> None:
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]]) + 3.0 * np.arange(5)[:, None, None] * (1, 0, 0)
    scene = nf.Scene.from_arrays(corners.reshape(-1, 3), np.arange(15).reshape(-1, 3), [4, 3, 2, 1, 0])
    nf.write_tiles(scene, tmp_path / "tiles", cell=3)
    part = open_tiles(tmp_path / "tiles").query([[2, -1, -1], [7, 2, 1]])
    assert sorted(contents(part)["objects"].tolist()) == [2, 3]
    assert part.object_names == scene.object_names


def test_a_box_selects_by_centroid_so_that_parts_add_up(tmp_path: Path) -> None:
    scene = soup()
    halves = []
    for name, box in (("low", [[-99, -99, -99], [0, 99, 99]]), ("high", [[0, -99, -99], [99, 99, 99]])):
        nf.write_tiles(scene, tmp_path / name, cell=5, aabb=box)
        halves.append(open_tiles(tmp_path / name).query(EVERYWHERE))
    assert sum(half.triangle_count for half in halves) == scene.triangle_count


def test_an_empty_world_makes_an_empty_folder(tmp_path: Path) -> None:
    empty = soup().query([[900, 900, 900], [901, 901, 901]])
    nf.write_tiles(empty, tmp_path / "tiles", cell=5)
    assert open_tiles(tmp_path / "tiles").query(EVERYWHERE).triangle_count == 0


class Breaking:
    """A source that raises after some queries."""

    def __init__(self, scene: nf.Scene, queries: int) -> None:
        self._scene, self.left = scene, queries

    @property
    def bounds(self) -> NDArray[np.float64]:
        return self._scene.bounds

    def query(self, aabb: ArrayLike, detail: Any = 0.0) -> nf.Scene:
        if not self.left:
            raise KeyboardInterrupt
        self.left -= 1
        return self._scene.query(aabb, detail)


def test_interrupted_work_is_resumed(tmp_path: Path) -> None:
    scene, folder, turns = soup(), tmp_path / "tiles", 0
    cells = json_cells(scene, tmp_path / "other")
    while True:
        breaking = Breaking(scene, 7)
        try:
            nf.write_tiles(breaking, folder, cell=5)
            break
        except KeyboardInterrupt:
            turns += 1
            with pytest.raises(nf.FormatError, match=r"write_tiles with the same arguments"):
                nf.open_source(folder)
    assert turns == -(-cells // 7) - 1
    assert np.array_equal(rows(open_tiles(folder).query(EVERYWHERE)), rows(scene))
    assert (folder / "tiles.json").read_bytes() == (tmp_path / "other" / "tiles.json").read_bytes()


class Failing(Breaking):
    """A source that gives a part of one cell with a note, and fails for another; both are in the middle."""

    def __init__(self, scene: nf.Scene, queries: int) -> None:
        super().__init__(scene, queries)
        self.middle = queries // 2

    def query(self, aabb: ArrayLike, detail: Any = 0.0) -> nf.Scene:
        self.left -= 1
        if self.left == self.middle:
            raise OSError("the disk is gone")
        part = self._scene.query(aabb, detail)
        if self.left == self.middle + 1:
            half = part.subset(triangles=np.arange(part.triangle_count) % 2 == 0)
            return nf.Scene(half._core, half._names, notes=(Unread("1 file of tiles left out: a.glb is missing"),))
        return part


def test_cells_that_cannot_be_read_are_named_and_written_later(tmp_path: Path) -> None:
    scene, folder = soup(), tmp_path / "tiles"
    cells = json_cells(scene, tmp_path / "other")
    failed = nf.write_tiles(Failing(scene, cells), folder, cell=5)
    reasons = ["1 file of tiles left out: a.glb is missing", "OSError: the disk is gone"]
    assert list(failed.values()) == reasons
    jsonschema.validate(json.loads((folder / "tiles.json").read_text()), load_schema("tiles"))
    source, other = open_tiles(folder), open_tiles(tmp_path / "other")
    assert source.failed == failed
    assert source.triangle_count < other.triangle_count
    assert {note for note in source.query(EVERYWHERE).report.notes if "incomplete" in note} == {
        f"the tile of cell {x}_{z} is incomplete: {reason}" for (x, z), reason in failed.items()
    }
    # Only parts that touch an incomplete cell say so, and they are not called empty.
    for x in range(-4, 4):
        for z in range(-4, 4):
            box = np.array([[5 * x + 1, -99, 5 * z + 1], [5 * x + 4, 99, 5 * z + 4]])
            part = source.query(box)
            assert len(unread_in(source, part)) == ((x, z) in failed)
            assert source.touches(box) or (x, z) not in failed
            if (x, z) not in failed:
                assert part.triangle_count <= other.query(box).triangle_count
    # In a folder of tiles written from the folder these cells, and those beside them, are incomplete.
    assert nf.write_tiles(source, tmp_path / "again", cell=5).keys() > failed.keys()
    assert nf.write_tiles(scene, folder, cell=5) == {}
    assert (folder / "tiles.json").read_bytes() == (tmp_path / "other" / "tiles.json").read_bytes()
    assert np.array_equal(rows(open_tiles(folder).query(EVERYWHERE)), rows(scene))


def json_cells(scene: nf.Scene, folder: Path) -> int:
    nf.write_tiles(scene, folder, cell=5)
    cells: int = json.loads((folder / "tiles.json").read_text())["cells"]
    return cells


def test_folders_of_other_content_are_left_alone(tmp_path: Path) -> None:
    scene = soup()
    nf.write_tiles(scene, tmp_path / "tiles", cell=9)
    with pytest.raises(ValueError, match=r"^folder: expected tiles in .* made with these arguments"):
        nf.write_tiles(scene, tmp_path / "tiles", cell=8)
    nf.write_tiles(scene, tmp_path / "tiles", cell=9)  # Nothing is left to do.
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "note.txt").write_text("mine")
    with pytest.raises(FileExistsError, match="holds other files"):
        nf.write_tiles(scene, tmp_path / "mine", cell=9)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda d: d["tiles"][0].update(file="../secret.glb"), "expected names such as tile_0_0.glb"),
        (lambda d: d["tiles"][0].update(box=[[0, 0, 0]]), "box: expected shape"),
        (lambda d: d["tiles"][0].update(triangles=-1), "triangles: expected"),
        (lambda d: d.update(done=10**9), "done: expected"),
        (lambda d: d.pop("settings"), "'settings' is missing"),
        (lambda d: d.update(version=99), "version 99"),
        (lambda d: d.update(format="nearfar.report"), "expected format"),
        (lambda d: d.update(tiles={"a": 1}), "tiles: expected a list"),
    ],
)
def test_damaged_indexes_are_named(
    scene_and_folder: tuple[nf.Scene, Path], tmp_path: Path, change: Any, words: str
) -> None:
    document = json.loads((scene_and_folder[1] / "tiles.json").read_text())
    change(document)
    (tmp_path / "tiles.json").write_text(json.dumps(document))
    with pytest.raises(nf.FormatError, match=r"tiles\.json: ") as raised:
        nf.open_source(tmp_path)
    assert words in str(raised.value)


def test_damaged_and_missing_tiles_are_named(tmp_path: Path) -> None:
    nf.write_tiles(soup(), tmp_path / "tiles", cell=9)
    source = open_tiles(tmp_path / "tiles")
    files = sorted((tmp_path / "tiles").glob("*.glb"))
    files[0].write_bytes(files[0].read_bytes()[:-100])
    with pytest.raises(nf.FormatError, match=files[0].name):
        source.query(EVERYWHERE)
    files[0].unlink()
    with pytest.raises(FileNotFoundError, match=files[0].name):
        source.query(EVERYWHERE)
    files[1].replace(files[0])
    with pytest.raises(nf.FormatError, match=f"{files[0].name}.*expected .* triangles"):
        source.query(EVERYWHERE)


def test_too_many_cells_are_refused(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"^cell: expected"):
        nf.write_tiles(soup(), tmp_path / "tiles", cell=1e-9)
    assert not (tmp_path / "tiles").exists()


def test_infinite_worlds_need_a_box(tmp_path: Path) -> None:
    class Endless(Breaking):
        @property
        def bounds(self) -> NDArray[np.float64]:
            return EVERYWHERE

    with pytest.raises(ValueError, match=r"^aabb: expected a finite box"):
        nf.write_tiles(Endless(soup(), 99), tmp_path / "tiles", cell=3)
    nf.write_tiles(Endless(soup(), 99), tmp_path / "tiles", cell=3, aabb=[[-9, -99, -9], [9, 99, 9]])
