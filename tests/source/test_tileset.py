"""Tests of tilesets (3D Tiles) as sources."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar._scene.tileset import select
from nearfar._source.open import TilesetSource
from tests.support import need
from tests.support.query_cases import touching
from tests.support.tile_cases import glb

CUBES = 6


def volume(middle: float, size: float) -> dict[str, Any]:
    return {"box": [middle, 0, 0, size, 0, 0, 0, size, 0, 0, 0, size]}


@pytest.fixture
def row(tmp_path: Path) -> Path:
    """Unit cubes at x = 0, 10, …, in separate tiles that replace one large cube."""
    large = glb()
    (tmp_path / "cube.glb").write_bytes(large)

    def tile(number: int) -> dict[str, Any]:
        matrix = np.eye(4)
        matrix[3, 0] = 10.0 * number
        return {
            "boundingVolume": volume(0, 0.5),
            "geometricError": 0,
            "transform": matrix.ravel().tolist(),
            "content": {"uri": "cube.glb"},
        }

    root = {
        "boundingVolume": volume(25, 30),
        "geometricError": 40,
        "refine": "REPLACE",
        "content": {"uri": "cube.glb"},
        "children": [tile(number) for number in range(CUBES)],
    }
    document = {"asset": {"version": "1.1"}, "geometricError": 100, "root": root}
    (tmp_path / "tileset.json").write_text(json.dumps(document))
    return tmp_path


def source_of(path: Path) -> TilesetSource:
    source = nf.open_source(path)
    assert isinstance(source, TilesetSource)
    return source


def test_folders_and_documents_open(row: Path) -> None:
    for path in (row, row / "tileset.json"):
        source = source_of(path)
        assert isinstance(source, nf.SceneSource)
        whole = nf.Scene.load(row / "tileset.json")
        everything = source.query([[-np.inf] * 3, [np.inf] * 3])
        assert everything.triangle_count == whole.triangle_count == 12 * CUBES
        assert (source.bounds[0] <= whole.bounds[0]).all()
        assert (source.bounds[1] >= whole.bounds[1]).all()


def by_corners(scene: nf.Scene) -> NDArray[np.float64]:
    corners = (scene.triangles().astype(np.float64) + scene.origin).reshape(-1, 9)
    return np.asarray(corners[np.lexsort(corners.T)])


def test_a_box_returns_touching_triangles(row: Path) -> None:
    aabb = [[9.7, -9, -9], [20.2, 9, 9]]
    whole, source = nf.Scene.load(row / "tileset.json"), source_of(row)
    part = source.query(aabb)
    expected = whole.subset(triangles=touching(whole, aabb))
    assert 0 < expected.triangle_count < 24
    assert np.array_equal(by_corners(part), by_corners(expected))
    assert source.query([[3, -1, -1], [6, 1, 1]]).triangle_count == 0


def test_detail_selects_the_tiles(row: Path) -> None:
    source = source_of(row)
    aabb = [[-np.inf] * 3, [np.inf] * 3]
    assert source.query(aabb, 40.0).triangle_count == 12
    assert source.query(aabb, 39.0).triangle_count == 12 * CUBES


def test_tilesets_become_folders_of_tiles(row: Path, tmp_path: Path) -> None:
    nf.write_tiles(source_of(row), tmp_path / "tiles", cell=7)
    again, whole = nf.open_source(tmp_path / "tiles"), nf.Scene.load(row / "tileset.json")
    everything = again.query([[-np.inf] * 3, [np.inf] * 3])
    assert np.array_equal(by_corners(everything), by_corners(whole))


def test_all_parts_have_one_frame(row: Path) -> None:
    document = json.loads((row / "tileset.json").read_text())
    matrix = np.eye(4)
    matrix[3, :3] = (5e5, 100.0, 20.0)
    document["root"]["transform"] = matrix.ravel().tolist()
    (row / "tileset.json").write_text(json.dumps(document))
    source = source_of(row)
    origins = [source.query(source.bounds + shift).origin for shift in (-5.0, 0.0, 25.0)]
    assert (np.ptp(origins, axis=0) == 0).all()
    assert np.abs(origins[0]).max() > 4e5


@pytest.mark.parametrize("given", [{"up": "z"}, {"scale": 2.0}, {"max_bytes": 9}, {"lod": "1"}])
def test_unsupported_arguments_of_tilesets_are_refused(row: Path, given: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match=f"^{next(iter(given))}: expected none with a tileset"):
        nf.open_source(row, **given)


def test_files_that_are_no_tilesets_raise_the_usual_errors(tmp_path: Path) -> None:
    (tmp_path / "other.json").write_text("{}")
    with pytest.raises(nf.SceneError, match=r"other\.json"):
        nf.open_source(tmp_path / "other.json")


def test_a_source_says_where_it_is_empty(row: Path) -> None:
    source = source_of(row)
    for low, high in ((-5.0, -0.6), (0.6, 9.4), (9.4, 9.6), (50.4, 80.0), (-90.0, 90.0), (-9.0, -5.1)):
        aabb = [[low, -0.1, -0.1], [high, 0.1, 0.1]]
        assert source.touches(aabb) == bool(source.query(aabb).triangle_count)


def test_many_tiles_away_from_the_box_do_not_count(row: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(select, "MAX_TILES", CUBES - 1)
    with pytest.raises(nf.SceneError, match="more than 5 tiles show it"):
        source_of(row).query([[-90] * 3, [90] * 3])
    aabb = [[9.7, -9, -9], [20.2, 9, 9]]
    assert source_of(row).touches(aabb)
    assert source_of(row).query(aabb).triangle_count > 0


def test_a_missing_tileset_is_named_whatever_was_queried_before(row: Path) -> None:
    """Only queries that need the missing file name it; a coarser tile stands in, as for a missing tile."""
    document = json.loads((row / "tileset.json").read_text())
    document["root"]["children"][-1]["content"]["uri"] = "last.json"
    (row / "tileset.json").write_text(json.dumps(document))
    at_last, everywhere = [[49, -1, -1], [51, 1, 1]], [[-90] * 3, [90] * 3]
    queries: list[tuple[Any, float]] = [
        (everywhere, 100.0),
        (everywhere, 0.0),
        (at_last, 0.0),
        ([[9] * 3, [11] * 3], 0.0),
    ]

    def answer(source: TilesetSource, box: Any, detail: float) -> tuple[Any, ...]:
        part = source.query(box, detail)
        return part.triangle_count, part.bounds.tolist(), part.report.notes, source.touches(box)

    alone = [answer(source_of(row), *query) for query in queries]
    assert [any("last.json is missing" in note for note in notes) for _, _, notes, _ in alone] == [
        False,
        True,
        True,
        False,
    ]
    for order in (queries, queries[::-1]):
        source = source_of(row)
        found = [answer(source, *query) for query in order]
        assert found == (alone if order is queries else alone[::-1])


@pytest.mark.parametrize("damage", ["missing", "truncated", "a missing tileset"])
def test_a_build_names_the_leaves_of_tiles_that_cannot_be_read(row: Path, tmp_path: Path, damage: str) -> None:
    need("zarr")
    document = json.loads((row / "tileset.json").read_text())
    file = "last.json" if damage == "a missing tileset" else "last.glb"
    document["root"]["children"][-1]["content"]["uri"] = file
    (row / "tileset.json").write_text(json.dumps(document))
    if damage == "truncated":
        (row / file).write_bytes(glb()[:-9])

    def build() -> nf.orthoview.OrthoTree:
        return nf.orthoview.build(nf.open_source(row), tmp_path / "row.zarr", cell=5, size=16, directions=5)

    tree = build()
    assert not tree.is_complete
    assert tree.failed
    for leaf, reason in tree.failed.items():
        assert reason.startswith("SceneError: 1 file of tiles left out: last")
        low, high = tree.box(0, leaf)
        assert (low <= [50.5, 0.5, 0.5]).all()
        assert (high >= [49.5, -0.5, -0.5]).all()
    # A scene in memory, whose report names the file, fails for no leaf.
    scene = nf.Scene.load(row / "tileset.json")
    assert any("left out" in note for note in scene.report.notes)
    assert not nf.orthoview.build(scene, tmp_path / "scene.zarr", cell=5, size=16, directions=5).failed
    camera = nf.Camera.look_at((25, 9, 40), (25, 0, 0), fov=nf.Fov.symmetric(90.0, 4 / 3), size=(64, 48))
    frame = tree.render(camera, channels=("coverage",))
    assert frame.stats["failed"] == len(tree.failed)
    assert frame.require("coverage").any()
    if damage == "a missing tileset":
        inner = {"boundingVolume": volume(0, 0.5), "geometricError": 0, "content": {"uri": "cube.glb"}}
        (row / file).write_text(json.dumps({**document, "root": inner}))
    else:
        (row / file).write_bytes(glb())
    whole = build()
    assert whole.is_complete
    complete = whole.render(camera, channels=("coverage",)).require("coverage")
    assert (complete > 0).sum() > (frame.require("coverage") > 0).sum()
