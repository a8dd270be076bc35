"""Tests of the folder of a tree's geometry: nearfar's reader and other programs find the world's triangles in it."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar._base.errors import FormatError
from nearfar._scene.tileset import subtree as subtrees
from nearfar.orthoview import _availability as availability
from nearfar.orthoview._geometry import step_of
from nearfar.orthoview._geometry_store import GeometryStore
from nearfar.orthoview._grid import Grid, Place
from nearfar.orthoview._owners import owned_mask
from tests.support import need, valid
from tests.support.bundle_cases import content
from tests.support.bundled_scenes import balls, farthest
from tests.support.geometry_cases import parts, stored, world_triangles
from tests.support.orthoview_cases import boxes
from tests.support.reader_cases import node

WORLDS: dict[str, tuple[Any, float]] = {
    # Subtrees of two tiers; instances, moving objects and a texture; a world of one leaf.
    "boxes": (lambda: two_ends(), 5.0),
    "balls": (balls, 2.0),
    "leaf": (lambda: boxes(3, 2.0)[0], 16.0),
}


def two_ends() -> nf.Scene:
    """Boxes at both ends of a long world."""
    near = world_triangles(boxes(12, 10.0)[0])
    corners = np.concatenate([near, near + np.array((170.0, 0.0, 0.0))]).reshape(-1, 3)
    return nf.Scene.from_arrays(corners, np.arange(len(corners)).reshape(-1, 3))


class Case:
    """A world and its geometry."""

    def __init__(self, world: nf.Scene, cell: float, folder: Path) -> None:
        self.world, self.grid = world, Grid.from_bounds(world.bounds, cell)
        self.counts = stored(world, self.grid, folder)
        self.folder = folder / "geometry"


@pytest.fixture(scope="module", params=WORLDS)
def case(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Case:
    make, cell = WORLDS[request.param]
    return Case(make(), cell, tmp_path_factory.mktemp("trees"))


# nearfar --------------------------------------------------------------------------------------------------------------
def test_the_tileset_has_the_triangles_of_the_world(case: Case) -> None:
    found = nf.Scene.load(case.folder / "tileset.json")
    assert found.triangle_count == case.counts["triangles"] + case.counts["moving"]["triangles"]
    assert case.counts["triangles"] == case.world._core.standing_triangle_count
    assert farthest(world_triangles(found), world_triangles(case.world)) <= case.counts["error"] + 2.0**-17
    assert 0 < case.counts["error"] <= step_of(case.grid) == case.counts["step"]
    assert case.counts["moving"]["objects"] == len(case.world.poses)
    assert found._core.texture_count == case.world._core.texture_count


def test_parts_of_the_tileset_equal_those_of_the_world(case: Case) -> None:
    opened = nf.open_source(case.folder)
    low, high = case.world.bounds
    slack = case.counts["error"] + 2.0**-17
    np.testing.assert_allclose(opened.bounds, case.world.bounds, atol=4 * step_of(case.grid))
    rng = np.random.default_rng(0)
    numbers = []
    for _ in range(12):
        least = rng.uniform(low, high)
        box = np.array([least, least + rng.uniform(0, 0.3) * (high - low)])
        grown = opened.query(box + slack * np.array([[-1], [1]]))
        # Everything that touches the box is found, and nothing outside a slightly larger box.
        nearest(world_triangles(case.world.query(box)), world_triangles(grown), slack)
        larger = case.world.query(box + 3 * slack * np.array([[-1], [1]]))
        nearest(world_triangles(grown), world_triangles(larger), slack)
        numbers.append(grown.triangle_count)
    assert max(numbers) > 0


def nearest(some: NDArray[np.float64], others: NDArray[np.float64], error: float) -> None:
    """Assert that each of the first triangles is among the others."""
    if len(some):
        extents = (np.stack([t.min(axis=1), t.max(axis=1), t.mean(axis=1)], axis=1) for t in (some, others))
        a, b = (found.reshape(-1, 9) for found in extents)
        assert max(float(np.abs(b - row).max(axis=1).min()) for row in a) <= error


def test_cells_of_the_tileset_have_the_numbers_of_the_grid(case: Case) -> None:
    level = case.grid.levels - 1
    there = {tuple(map(int, path.with_suffix("").parts[-3:])) for path in (case.folder / "content").rglob("*.glb")}
    expected = {
        place
        for place, part in parts(case.world, case.grid)
        if owned_mask(part, case.grid, place)[: part._core.standing_triangle_count].any()
    }
    assert there == expected
    assert {path.parts[-4] for path in case.folder.rglob("*.glb")} == {str(level)}
    assert case.counts["leaves"] == len(there)
    assert case.counts["bytes"] == sum(path.stat().st_size for path in (case.folder / "content").rglob("*.glb"))


def test_moving_objects_are_listed(case: Case) -> None:
    document = json.loads((case.folder / "moving.json").read_text())
    assert valid(document, "orthoview_moving")
    listed = document["files"]
    assert [row["file"] for row in listed] == sorted(
        path.relative_to(case.folder).as_posix() for path in (case.folder / "moving").rglob("*.glb")
    )
    moving = case.world.triangle_count - case.world._core.standing_triangle_count
    assert sum(row["triangles"] for row in listed) == moving == case.counts["moving"]["triangles"]
    assert {instance["object"] for row in listed for instance in row["instances"]} == set(case.world.poses)


def test_an_empty_world_has_an_empty_tileset(tmp_path: Path) -> None:
    counts = GeometryStore(tmp_path, Grid((0.0, 0.0, 0.0), 8.0, (3, 1, 2))).finish()
    assert (counts["leaves"], counts["bytes"], counts["error"]) == (0, 0, 0.0)
    tileset = json.loads((tmp_path / "geometry" / "tileset.json").read_text())
    assert "children" not in tileset["root"]
    np.testing.assert_array_equal(nf.open_source(tmp_path / "geometry").bounds, [[0, 0, 0], [32, 32, 32]])


def test_rewritten_files_have_the_same_bytes(case: Case, tmp_path: Path) -> None:
    copy = tmp_path / "store"
    shutil.copytree(case.folder.parent, copy)
    before = content(copy)
    # A build that was interrupted while it wrote a file leaves a temporary file.
    (copy / "geometry" / "content" / "rest.tmp").write_bytes(b"")
    store = GeometryStore(copy, case.grid)
    place, part = max(parts(case.world, case.grid), key=lambda pair: pair[1].triangle_count)
    assert store.write(part, place) > 0
    assert store.finish() == case.counts
    (copy / "geometry" / "content" / "rest.tmp").unlink()
    assert content(copy) == before


def test_the_lowest_subtrees_have_many_levels() -> None:
    assert [availability.subtree_levels(levels) for levels in range(1, 14)] == [4, 4, 4, 4, 5, 6, 4, 4, 5, 5, 6, 6, 5]
    for levels in range(1, 26):
        own = availability.subtree_levels(levels)
        assert levels - (levels - 1) // own * own >= min(levels, 3)


@pytest.mark.parametrize("levels", [1, 3, 4, 9])
def test_subtrees_list_available_cells(levels: int, tmp_path: Path) -> None:
    """Compares availability and boxes with those of sets of cells, through nearfar's reader."""
    rng = np.random.default_rng(levels)
    leaves = np.unique(rng.integers(0, 1 << (levels - 1), (20, 3)) // np.array([1, 1, 2]), axis=0)
    own = {tuple(place): np.sort(rng.normal(size=(2, 3)), axis=0) for place in leaves.tolist()}
    above: dict[tuple[int, ...], list[NDArray[np.float64]]] = {}
    for place, box in own.items():
        for level in range(levels):
            above.setdefault((level, *(number >> (levels - 1 - level) for number in place)), []).append(box)
    whole = {cell: np.array([np.min(b, axis=0)[0], np.max(b, axis=0)[1]]) for cell, b in above.items()}

    def box_of(place: Place) -> NDArray[np.float64]:
        return own[place]

    found = availability.write(tmp_path, levels, leaves[rng.permutation(len(leaves))], box_of)
    np.testing.assert_array_equal(found, whole[0, 0, 0, 0])
    depths = availability.subtree_levels(levels)
    properties = subtrees.box_properties({"schema": availability.SCHEMA})
    roots = {cell for cell in whole if cell[0] % depths == 0}
    assert (len(roots) > 1) == (levels > depths)
    assert {path.name for path in tmp_path.iterdir()} == {
        availability.NAME.format(level=level, x=x, y=y, z=z) for level, x, y, z in roots
    }
    for level, *corner in roots:
        x, y, z = corner
        data = (tmp_path / availability.NAME.format(level=level, x=x, y=y, z=z)).read_bytes()
        read = subtrees.read(data, 3, depths, lambda uri: b"", properties)
        below = sorted(
            (depth, interleaved([number - (first << depth) for number, first in zip(cell, corner, strict=True)]), box)
            for depth in range(min(depths + 1, levels - level))
            for (own_level, *cell), box in ((cell, box.tolist()) for cell, box in whole.items())
            if own_level == level + depth and [number >> depth for number in cell] == corner
        )
        tiles = [
            (subtrees.tiles_above(depth, 3) + number, depth, box) for depth, number, box in below if depth < depths
        ]
        assert np.flatnonzero(read.tiles.unpack()).tolist() == [bit for bit, _, _ in tiles]
        contents = [bit for bit, depth, _ in tiles if level + depth == levels - 1]
        assert np.flatnonzero(read.contents[0].unpack()).tolist() == contents
        children = [number for depth, number, _ in below if depth == depths]
        assert np.flatnonzero(read.children.unpack()).tolist() == children
        # z up: (x, −z, y).
        low, high = (np.array([box[end] for _, _, box in tiles])[:, [0, 2, 1]] * (1, -1, 1) for end in (0, 1))
        assert read.boxes is not None
        np.testing.assert_allclose(read.boxes[:, 0], (low + high) / 2)
        np.testing.assert_allclose(read.boxes[:, 1:], [np.diag(half) for half in np.abs(high - low) / 2])


def interleaved(place: list[int]) -> int:
    """Number of a cell in Morton order: the bits of x, y and z interleaved, x lowest."""
    bits = range(max(place).bit_length())
    return sum((number >> bit & 1) << (3 * bit + axis) for bit in bits for axis, number in enumerate(place))


# damage ---------------------------------------------------------------------------------------------------------------
def error_after(folder: Path, change: Any) -> str:
    """The error message after a change to the first file of the geometry."""
    world, cell = boxes(3, 2.0)[0], 0.7
    grid = Grid.from_bounds(world.bounds, cell)
    stored(world, grid, folder)
    path = min((folder / "geometry" / "content").rglob("*.glb"))
    change(path)
    with pytest.raises(FormatError) as caught:
        GeometryStore(folder, grid).finish()
    assert str(folder) in str(caught.value)
    return str(caught.value)


@pytest.mark.parametrize("length", [0, 11, 19, 300, -1])
def test_truncated_files_are_refused(length: int, tmp_path: Path) -> None:
    message = error_after(tmp_path, lambda path: path.write_bytes(path.read_bytes()[:length]))
    assert ": damaged geometry: " in message


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        (b'"triangles"', b'"triungles"', "'triangles' is missing"),
        (b'"error":1.', b'"error":-1', "error: expected"),
        (b'"box":[[', b'"box":[[NaN,', "NaN"),
        (b"glTF", b"glTG", "GLB"),
    ],
)
def test_inconsistent_files_are_refused(old: bytes, new: bytes, words: str, tmp_path: Path) -> None:
    def change(path: Path) -> None:
        data = path.read_bytes()
        assert old in data
        path.write_bytes(data.replace(old, new, 1))

    assert words in error_after(tmp_path, change)


def test_files_off_the_grid_are_refused(tmp_path: Path) -> None:
    message = error_after(tmp_path, lambda path: path.rename(path.with_name("99.glb")))
    assert "99.glb: expected a leaf among" in message


# other programs -------------------------------------------------------------------------------------------------------
@pytest.mark.slow
def test_the_gltf_validator_finds_no_errors(case: Case) -> None:
    need("node")
    files = sorted(case.folder.rglob("*.glb"))[:60]
    reports = node("validate.mjs", files)
    assert len(reports) == len(files)
    for path, report in reports.items():
        found = [message for message in report["messages"] if message["severity"] < 2]
        assert not found, f"{path}: {found[:3]}"


@pytest.mark.slow
@pytest.mark.parametrize("name", ["boxes", "balls"])
def test_3d_tiles_renderer_finds_all_content(name: str, tmp_path: Path) -> None:
    need("node")
    # Only balls without an image, because three.js decodes images in browsers only.
    world = balls().subset(objects=[f"ball {n}" for n in range(12)]) if name == "balls" else boxes(20, 40.0)[0]
    case = Case(world, 5.0, tmp_path)
    path = case.folder / "tileset.json"
    found = node("tiles.mjs", [path])[str(path)]
    assert found["errors"] == []
    files = [file.relative_to(case.folder).as_posix() for file in case.folder.rglob("*.glb")]
    assert sorted(found["visible"]) == sorted(tile["uri"] for tile in found["tiles"]) == sorted(files)
    assert sum(tile["uri"].startswith("moving") for tile in found["tiles"]) == case.counts["moving"]["files"]
    for tile in found["tiles"]:
        folder, level, *numbers = tile["uri"].removesuffix(".glb").split("/")
        x, y, z = map(int, numbers)
        cell = case.grid.box(0, (x, y, z))
        part = case.world.query(cell)
        moves = np.arange(part.triangle_count) >= part._core.standing_triangle_count
        mine = owned_mask(part, case.grid, (x, y, z)) & (moves == (folder == "moving"))
        expected = world_triangles(part)[mine]
        bounds = [expected.min(axis=(0, 1)), expected.max(axis=(0, 1))]
        assert int(level) == case.grid.levels - 1
        assert tile["triangles"] == len(expected)
        np.testing.assert_allclose(scene_box(*tile["bounds"]), bounds, atol=case.counts["error"] + 1e-9)
        middle, *axes = np.array(tile["box"]).reshape(4, 3)
        half = np.abs(axes).sum(axis=0)
        stated = scene_box(middle - half, middle + half)
        if folder == "content":
            np.testing.assert_allclose(stated, cell)
        else:
            np.testing.assert_allclose(stated, bounds, atol=4 * case.counts["step"])


def scene_box(low: Any, high: Any) -> NDArray[np.float64]:
    """The box (2, 3) of a tileset, z up, in the axes of scenes."""
    return np.array([[low[0], low[2], -high[1]], [high[0], high[2], -low[1]]])
