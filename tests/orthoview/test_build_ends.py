"""Tests of interrupted builds: errors, signals, a full disk, a power failure; what is repeated, and what is kept."""

from __future__ import annotations

import errno
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import ArrayLike

import nearfar as nf
from nearfar.orthoview import _update
from nearfar.orthoview._shard import ShardWriter
from tests.support import need
from tests.support.flight_cases import camera_at
from tests.support.orthoview_cases import boxes
from tests.support.orthoview_stores import (
    CELL,
    SIZE,
    Counted,
    Interrupted,
    Late,
    Partial,
    built_once,
    contents,
    ended,
    of_cells,
)

need("zarr")

Tree = nf.orthoview.OrthoTree

SETTINGS: dict[str, Any] = {"cell": CELL, "size": SIZE, "directions": 5}
AMID = 100
"""Number of the query for a leaf in the middle of a subtree, with non-empty leaves before and after it."""


@pytest.fixture(scope="session")
def whole(few: nf.Scene, tmp_path_factory: pytest.TempPathFactory) -> Tree:
    """A tree of a source that does not report where it is empty, built without interruption."""
    return built_once(tmp_path_factory, "counted.zarr", Counted(few), **SETTINGS)


def check_resumed(source: Any, path: Path, whole: Tree) -> None:
    """Check that a build resumes and writes the same files as an uninterrupted one."""
    resumed = nf.orthoview.build(source, path, **SETTINGS)
    assert resumed.is_complete
    assert resumed.held == whole.held
    assert contents(path) == contents(Path(whole.path))
    for name in ("zarr.json", "nearfar/records.json"):  # with the counts of work, and the hashes of all records
        assert (path / name).read_bytes() == (Path(whole.path) / name).read_bytes()
    assert not list(path.rglob("*.part"))
    assert not list((path / "nearfar" / "journal").glob("*"))


def test_cells_whose_query_fails_are_named_and_built_later(few: nf.Scene, few_tree: Tree, tmp_path: Path) -> None:
    path = tmp_path / "world.zarr"
    first = nf.orthoview.build(Counted(few, {60, AMID}), path, **SETTINGS)
    assert not first.is_complete
    assert len(first.failed) == 2
    assert set(first.failed.values()) == {"OSError: the disk is gone"}
    assert "incomplete" in repr(first)
    # All other cells are whole; those above the two are as in a world without them.
    cells, failed = of_cells(few), [*first.failed]
    empty = Partial(few, [few_tree.box(0, leaf) for leaf in failed], is_empty_there=True)
    without = nf.orthoview.build(empty, tmp_path / "b", **SETTINGS)
    for leaf in failed:
        with pytest.raises(ValueError, match="is missing: OSError: the disk is gone"):
            first.view(0, leaf, 4)
    for level, place in cells:
        is_above = level > 0 and any(tuple(number >> level for number in leaf) == place for leaf in failed)
        if (level, place) not in [(0, leaf) for leaf in failed]:
            assert same_view(first, without if is_above else few_tree, level, place)
    camera = camera_at(few_tree, 90)
    frame = first.render(camera)
    assert np.array_equal(frame.require("color"), without.render(camera).require("color"))
    assert frame.stats["failed"] == 2
    with first.fly() as flight:
        flight.render(camera)
        assert flight.wait(60.0)
        flown = flight.render(camera)
        assert (flown.stats["missing"], flown.stats["failed"]) == (0, 2)
        assert np.array_equal(flown.require("color"), frame.require("color"))
    assert first.verify() > 0
    assert first.export_splats(tmp_path / "world.glb")["failed"] == 2
    again = nf.orthoview.build(Counted(few, {1}), path, **SETTINGS)
    assert len(again.failed) == 1
    source = Counted(few)
    second = nf.orthoview.build(source, path, **SETTINGS)
    assert second.is_complete
    assert second.failed == {}
    assert source.queries == 1
    assert (second.held, second.done["drawn"]) == (few_tree.held, few_tree.done["drawn"])
    # Chunks of a shard are in the order of creation, so bytes differ where cells are built later.
    assert all(same_view(second, few_tree, level, place) for level, place in cells)


def same_view(one: Tree, other: Tree, level: int, place: tuple[int, int, int]) -> bool:
    """Whether two trees have the same view of a cell from above."""
    left, right = (opened.view(level, place, 4) for opened in (one, other))
    if left is None or right is None:
        return left is right
    return np.array_equal(left.color, right.color) and np.array_equal(left.depth, right.depth)


IN_QUERY = f"source.query = lambda box: die() if source.queries == {AMID - 1} else query(box)"
KILLS = {
    "while the store is made": "_layout.Layout.shard_side = lambda self, level: die()",
    "in a query": IN_QUERY,
    "between two shards": """
finish, numbers = _shard.ShardWriter.finish, iter(range(1000))
_shard.ShardWriter.finish = lambda self: die() if next(numbers) == 11 else finish(self)
""",
    "before the record": "_subtree.formats.write_json = lambda *_: die()",
    "before the journal goes": """
remove = _subtree.Journal.remove
_subtree.Journal.remove = lambda self: die() if self.cells else remove(self)
""",
}
BUILD = """
nf.orthoview.build(source, f"{folder}/{name}.zarr", **settings)
"""


@pytest.mark.slow
def test_a_killed_build_is_resumed(few: nf.Scene, whole: Tree, tmp_path: Path) -> None:
    """Only the current cell is lost."""
    given = f"\nfolder, settings = {str(tmp_path)!r}, {SETTINGS!r}"
    ended(given + BUILD, KILLS)
    with pytest.raises(ValueError, match="is missing: the build has not ended"):
        nf.orthoview.open(tmp_path / "in a query.zarr").view(whole.levels - 1, (0, 0, 0), 0)
    for moment in KILLS:
        source = Counted(few)
        check_resumed(source, tmp_path / f"{moment}.zarr", whole)
        assert (source.queries == np.prod(whole.cells(0)) - (AMID - 1)) == (moment == "in a query"), moment


@pytest.mark.slow
def test_data_lost_in_a_power_failure_is_drawn_again(few: nf.Scene, whole: Tree, tmp_path: Path) -> None:
    """A shard may be shorter than its journal states, and a line of the journal may be damaged."""
    path = tmp_path / "world.zarr"
    with pytest.raises(KeyboardInterrupt):
        nf.orthoview.build(Interrupted(few, 150), path, **SETTINGS)
    part = max(path.rglob("*.part"), key=lambda file: file.stat().st_size)
    part.write_bytes(part.read_bytes()[:-10])
    (journal,) = (path / "nearfar" / "journal").glob("0_*")
    journal.write_bytes(journal.read_bytes() + bytes(3) + b"\n")
    check_resumed(Counted(few), path, whole)


def test_ctrl_c_ends_the_build_and_loses_nothing(few: nf.Scene, whole: Tree, tmp_path: Path) -> None:
    with pytest.raises(KeyboardInterrupt):
        nf.orthoview.build(Interrupted(few, AMID), tmp_path / "world.zarr", **SETTINGS)
    source = Counted(few)
    check_resumed(source, tmp_path / "world.zarr", whole)
    assert source.queries == np.prod(whole.cells(0)) - (AMID - 1)


def test_a_full_disk_ends_the_build_and_loses_nothing(
    few: nf.Scene, whole: Tree, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Half of a chunk is written when the disk becomes full."""
    write, left = ShardWriter._write, [50_000]

    def limited(self: ShardWriter, data: bytes, *, sync: bool) -> None:
        left[0] -= len(data)
        if left[0] < 0:
            write(self, data[: len(data) // 2], sync=sync)
            raise OSError(errno.ENOSPC, "No space left on device")
        write(self, data, sync=sync)

    with monkeypatch.context() as patched:
        patched.setattr(ShardWriter, "_write", limited)
        with pytest.raises(OSError, match="No space left on device"):
            nf.orthoview.build(Counted(few), tmp_path / "world.zarr", **SETTINGS)
    source = Counted(few)
    check_resumed(source, tmp_path / "world.zarr", whole)
    assert source.queries < np.prod(whole.cells(0))


def test_a_source_that_always_fails_ends_the_build(world: nf.Scene, tmp_path: Path) -> None:
    source = Counted(world, range(10**6))
    with pytest.raises(nf.SceneError, match="it failed for 1,000 leaves, the last one with OSError: the disk is gone"):
        nf.orthoview.build(source, tmp_path / "world.zarr", cell=CELL, size=SIZE, directions=5)


def test_concurrent_builds_of_one_store_are_refused(world: nf.Scene, tmp_path: Path) -> None:
    need("linux")
    path = tmp_path / "world.zarr"

    class Second(Counted):
        def query(self, aabb: ArrayLike, detail: Any = 0.0) -> nf.Scene:
            with pytest.raises(BlockingIOError, match="another build writes into"):
                nf.orthoview.build(world, path, cell=40.0, size=SIZE, directions=5)
            with pytest.raises(BlockingIOError, match="another build writes into"):
                _update.update(path, world.bounds, world)
            return super().query(aabb, detail)

    assert nf.orthoview.build(Second(world), path, cell=40.0, size=SIZE, directions=5).is_complete


@pytest.mark.parametrize("quality", [None, 80])
def test_webp_colours_are_resumed(few: nf.Scene, tmp_path: Path, quality: int | None) -> None:
    """Lossless colours are equal. Parents are composed of decoded lossy ones, so a resumed build has the same bytes."""
    large: dict[str, Any] = SETTINGS | {"cell": 2 * CELL, "geometry": False}
    settings = large | {"color": "webp", "quality": quality}
    made = nf.orthoview.build(few, tmp_path / "world.zarr", **settings)
    exact = nf.orthoview.build(few, tmp_path / "exact.zarr", **large)
    differences = []
    for place in np.ndindex(*exact.cells(1)):
        one, other = made.view(1, place, 4), exact.view(1, place, 4)
        if one is not None and other is not None:
            np.testing.assert_array_equal(one.depth, other.depth)
            assert not one.color[~np.isfinite(one.depth)].any()
            differences.append(np.abs(one.color.astype(int) - other.color).max())
    assert len(differences) > 5
    assert (max(differences) > 0) == (quality is not None)
    if quality is not None:
        with pytest.raises(KeyboardInterrupt):
            nf.orthoview.build(Interrupted(few, 60), tmp_path / "again.zarr", **settings)
        nf.orthoview.build(few, tmp_path / "again.zarr", **settings)
        assert contents(tmp_path / "again.zarr") == contents(Path(made.path))


def test_a_resumed_build_keeps_the_chosen_directions(tmp_path: Path) -> None:
    path = tmp_path / "world.zarr"

    class Leaf(Late):
        bounds = np.array([[40.0, -3.0, -60.0], [59.0, 16.0, -41.0]])

    corners = np.array([[-99, 0, -99], [-99, 0, 99], [99, 0, 99], [99, 0, -99]], np.float32)
    ground = nf.Scene.from_arrays(corners, np.array([[0, 1, 2], [0, 2, 3]], np.uint32))
    settings: dict[str, Any] = {"cell": 20.0, "size": SIZE, "directions": "auto", "geometry": False}
    with pytest.raises(KeyboardInterrupt):
        nf.orthoview.build(Leaf(ground, path), path, **settings)
    assert len(nf.orthoview.open(path).directions) == 5
    dense = boxes(40)[0]
    assert len(nf.orthoview.build(Leaf(dense, tmp_path), path, **settings).directions) == 5
    assert len(nf.orthoview.build(Leaf(dense, tmp_path), tmp_path / "fresh.zarr", **settings).directions) > 5
