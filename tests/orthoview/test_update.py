"""Tests of updates: which cells are drawn again, what readers see, and equality with a new build."""

from __future__ import annotations

import itertools
import pickle
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import ArrayLike, NDArray

import nearfar as nf
from tests.support import need
from tests.support.orthoview_stores import CELL, SIZE, Counted, box_about, contents, ended, masks_of, places, world_of
from tests.support.shared_folders import make_once

need("zarr")

pytestmark = pytest.mark.slow

BEFORE = range(10)
REMOVED, ADDED = {7, 8}, {101}
AFTER = [number for number in (*BEFORE, *ADDED) if number not in REMOVED]

Trees = dict[str, nf.orthoview.OrthoTree]


def built(scene: Any, path: Path) -> nf.orthoview.OrthoTree:
    return nf.orthoview.build(scene, path, cell=CELL, size=SIZE, directions=5)


@pytest.fixture(scope="module")
def trees(tmp_path_factory: pytest.TempPathFactory) -> Trees:
    """The trees of the world before and after the change."""
    worlds = {"before": world_of(BEFORE), "after": world_of(AFTER)}
    paths = {name: make_once(tmp_path_factory, f"{name}.zarr", partial(built, world)) for name, world in worlds.items()}
    return {name: nf.orthoview.open(path) for name, path in paths.items()}


@pytest.fixture
def tree(trees: Trees, tmp_path: Path) -> nf.orthoview.OrthoTree:
    """A copy of the tree before the change."""
    return trees["before"].compact(tmp_path / "world.zarr")


def assert_same(one: nf.orthoview.OrthoTree, other: nf.orthoview.OrthoTree) -> None:
    """Assert that all views of two trees are equal."""
    shown = masks_of(one)
    assert shown == masks_of(other)
    keys = [(*cell, direction) for cell, mask in shown.items() for direction in range(5) if mask >> direction & 1]
    assert len(keys) > 200
    for key in keys:
        left, right = (opened.view(*key) for opened in (one, other))
        assert left is not None
        assert right is not None
        for name in ("color", "depth", "normal", "surfel"):
            np.testing.assert_array_equal(getattr(left, name), getattr(right, name))


def touched(tree: nf.orthoview.OrthoTree, aabb: NDArray[np.float64]) -> list[set[tuple[int, int, int]]]:
    """Places of the cells that a box touches, level by level."""

    def touches(level: int, place: tuple[int, int, int]) -> bool:
        low, high = tree.box(level, place)
        return bool((low <= aabb[1]).all() and (aabb[0] <= high).all())

    return [{place for place in places(tree.cells(level)) if touches(level, place)} for level in range(tree.levels)]


def test_an_update_computes_the_leaves_in_its_box_and_the_cells_above_them(
    trees: Trees, tree: nf.orthoview.OrthoTree, tmp_path: Path
) -> None:
    """The result is the tree of the new world; a tree opened before keeps its generation."""
    first, before = contents(Path(tree.path)), trees["before"]
    box, source = box_about(REMOVED | ADDED), Counted(world_of(AFTER))
    updated = tree.update(box, source)
    assert (tree.generation, updated.generation) == (0, 1)
    assert updated.held == trees["after"].held != before.held
    assert_same(updated, trees["after"])
    leaves = places(updated.cells(0))
    assert [updated.leaf_glb(place) for place in leaves] == [trees["after"].leaf_glb(place) for place in leaves]
    assert [tree.leaf_glb(place) for place in leaves] == [before.leaf_glb(place) for place in leaves]
    assert_same(tree, before)
    now = contents(Path(tree.path))
    assert {path: now[path] for path in first} == first
    check_work(updated, touched(tree, box), source)
    compacted = updated.compact(tmp_path / "compact.zarr")
    assert compacted.generation == 0
    assert compacted.held == trees["after"].held
    assert contents(Path(compacted.path)) == contents(Path(trees["after"].path))
    assert compacted.verify() == trees["after"].verify()


def check_work(updated: nf.orthoview.OrthoTree, levels: list[set[tuple[int, int, int]]], source: Counted) -> None:
    """Check that the changed cells were drawn and composed, and that only their neighbours were read."""
    done = updated.done
    assert source.queries == len(levels[0]) == done["drawn"] + done["empty"]
    above = [(level, place) for level, cells in enumerate(levels) for place in cells if level]
    shown = [cell for cell in above if any(updated.view(*cell, direction) is not None for direction in range(5))]
    assert done["composed"] == len(shown)
    assert len(shown) > len(above) / 2
    # A contiguous change costs k + log n, not k · log n.
    assert sum(map(len, levels)) < len(levels[0]) * updated.levels / 2
    # Neighbouring cells are read at most once each.
    beside = sum(8 * len(above) - len(below) for below, above in itertools.pairwise(levels))
    assert 0 < done["reloaded"] <= 15 * beside


def test_consecutive_updates_are_applied(trees: Trees, tree: nf.orthoview.OrthoTree, tmp_path: Path) -> None:
    """Applies a change and its inverse, and a change in two steps."""
    without = world_of(number for number in BEFORE if number not in REMOVED)
    first = tree.update(box_about(REMOVED), without)
    second = first.update(box_about(ADDED), world_of(AFTER))
    assert second.generation == 2
    assert_same(pickle.loads(pickle.dumps(second)), trees["after"])
    # A tree that is open and not the newest updates the newest.
    back = tree.update(box_about(REMOVED | ADDED), world_of(BEFORE))
    assert back.generation == 3
    assert back.held == trees["before"].held
    compacted = back.compact(tmp_path / "compact.zarr")
    assert contents(Path(compacted.path)) == contents(Path(trees["before"].path))
    assert back.verify() > compacted.verify()


def test_readers_see_one_generation_while_an_update_runs(trees: Trees, tree: nf.orthoview.OrthoTree) -> None:
    place, level = (0, 0, 0), tree.levels - 1

    class Read(Counted):
        """Reads the store at each query: through the open tree, and through one opened then."""

        def query(self, aabb: ArrayLike, detail: Any = 0.0) -> nf.Scene:
            for opened in (tree, nf.orthoview.open(tree.path)):
                assert opened.generation == 0
                view, expected = opened.view(level, place, 4), trees["before"].view(level, place, 4)
                assert view is not None
                assert expected is not None
                np.testing.assert_array_equal(view.color, expected.color)
            return super().query(aabb, detail)

    source = Read(world_of(AFTER))
    updated = tree.update(box_about(REMOVED | ADDED), source)
    assert source.queries > 10
    new, old = updated.view(level, place, 4), tree.view(level, place, 4)
    assert new is not None
    assert old is not None
    assert not np.array_equal(new.color, old.color)


def test_a_failed_update_changes_nothing(trees: Trees, tree: nf.orthoview.OrthoTree) -> None:
    document = (Path(tree.path) / "zarr.json").read_bytes()
    with pytest.raises(OSError, match="the disk is gone"):
        tree.update(box_about(REMOVED | ADDED), Counted(world_of(AFTER), {9}))
    assert (Path(tree.path) / "zarr.json").read_bytes() == document
    assert_same(nf.orthoview.open(tree.path), trees["before"])
    # Files that it left behind do not count.
    assert_same(tree.update(box_about(REMOVED | ADDED), world_of(AFTER)), trees["after"])


FATAL = {
    "a query": "source.query = lambda box: die() if source.queries == 9 else query(box)",
    "the pointer": "_store.change = lambda *_, **__: die()",
}
UPDATE = """
from tests.support.orthoview_stores import box_about, world_of
source._scene = world_of(after)
nf.orthoview.open(f"{folder}/{name}.zarr").update(box_about(changed), source)
"""


def test_a_killed_update_changes_nothing(trees: Trees, tmp_path: Path) -> None:
    """Kills within a query, and just before the final document is replaced."""
    for moment in FATAL:
        trees["before"].compact(tmp_path / f"{moment}.zarr")
    given = f"\nfolder, after, changed = {str(tmp_path)!r}, {AFTER!r}, {REMOVED | ADDED!r}"
    ended(given + UPDATE, FATAL)
    for moment in FATAL:
        tree = nf.orthoview.open(tmp_path / f"{moment}.zarr")
        assert tree.generation == 0
        assert_same(tree, trees["before"])
        assert_same(tree.update(box_about(REMOVED | ADDED), world_of(AFTER)), trees["after"])


def test_changes_beyond_the_tree_are_refused(tree: nf.orthoview.OrthoTree) -> None:
    wider = world_of([*BEFORE, 5000])
    low, high = tree.bounds
    beyond = np.array([low, high + 100])
    shifted = nf.Scene.from_arrays(
        np.array([high + 5, high + 6, high + np.array([5, 9, 5])], np.float64), np.array([[0, 1, 2]], np.uint32)
    )
    with pytest.raises(ValueError, match="aabb: expected a change within the tree's box"):
        tree.update(beyond, shifted)
    assert tree.update(beyond, wider).generation == 1  # Nothing lies beyond.


def test_invalid_calls_of_update_are_named(tree: nf.orthoview.OrthoTree, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="path: expected another folder"):
        tree.compact(tree.path)
    failing = built(Counted(world_of(BEFORE), {5}), tmp_path / "part.zarr")
    with pytest.raises(ValueError, match=r"expected a complete tree, .*part\.zarr: 1 failed"):
        failing.update(tree.bounds, world_of(BEFORE))
    with pytest.raises(ValueError, match=r"expected a complete tree, .*part\.zarr: 1 failed"):
        failing.compact(tmp_path / "new.zarr")
    tree.update(box_about(ADDED), world_of([*BEFORE, *ADDED]))
    with pytest.raises(ValueError, match="was updated since it was built"):
        built(world_of(BEFORE), Path(tree.path))


def test_geometry_without_pixels_is_added_and_removed(tmp_path: Path) -> None:
    """A triangle too small for any pixel, in a part of the world that is otherwise empty."""
    corners = np.array([[1, 1, 1], [6, 1, 1], [1, 1, 6]], np.float32)
    small = np.array([[0, 0, 0], [1e-3, 0, 0], [0, 0, 1e-3]], np.float32) + 333.0
    faces = np.arange(6, dtype=np.uint32).reshape(2, 3)
    ends = np.concatenate([corners, corners + 630])
    without = nf.Scene.from_arrays(ends, faces)
    having = nf.Scene.from_arrays(np.concatenate([ends, small]), np.arange(9, dtype=np.uint32).reshape(3, 3))
    place = (33, 33, 33)
    box = np.array([[330.0] * 3, [339.0] * 3])
    bare, full = built(without, tmp_path / "bare.zarr"), built(having, tmp_path / "full.zarr")
    assert full.leaf_glb(place) is not None
    assert all(full.view(0, place, direction) is None for direction in range(5))
    gone = full.update(box, without)
    assert gone.leaf_glb(place) is None
    assert contents(Path(gone.compact(tmp_path / "gone.zarr").path)) == contents(Path(bare.path))
    come = bare.update(box, having)
    assert come.leaf_glb(place) == full.leaf_glb(place)
    assert contents(Path(come.compact(tmp_path / "come.zarr").path)) == contents(Path(full.path))
