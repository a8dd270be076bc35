"""Tests of guests: the leaves whose triangles extend into a leaf that is drawn as geometry."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import nearfar as nf
from nearfar._base.errors import UnusableError
from nearfar.orthoview import _owners
from nearfar.orthoview._grid import Grid, Place, directions_of
from nearfar.orthoview._layout import Layout
from nearfar.orthoview._owners import owned_mask, owners
from tests.support import need
from tests.support.geometry_cases import parts, places
from tests.support.orthoview_stores import box_about, of_subtrees, world_of

need("zarr")

CELL = 10.0
Guests = dict[Place, set[Place]]


def of_tree(tree: nf.orthoview.OrthoTree) -> Guests:
    """Guests of all leaves that have any, from the records of a tree."""
    read = of_subtrees(tree)
    counts = np.array(tree.cells(0))
    shards = [(x, y, z) for x, y, z in np.ndindex(*(-(-counts // 8)).tolist())]
    return {leaf: set(own) for shard in shards for leaf, own in read(0, shard).guests.items()}


def by_hand(world: nf.Scene, grid: Grid) -> Guests:
    """Guests by definition: leaves that own triangles touching another leaf."""
    of_leaf = {place: {bytes(t) for t in part.triangles()} for place, part in parts(world, grid)}
    masks = {place: owned_mask(part, grid, place) for place, part in parts(world, grid)}
    mine = {place: {bytes(t) for t in part.triangles()[masks[place]]} for place, part in parts(world, grid)}
    found: Guests = {}
    for place, touching in of_leaf.items():
        others = {other for other, own in mine.items() if other != place and own & touching}
        if others:
            found[place] = others
    return found


@pytest.fixture(scope="module")
def world() -> nf.Scene:
    """Boxes, and a large triangle that has corners in three far leaves."""
    boxes = world_of(range(8))
    low, high = boxes.bounds
    large = nf.Scene.from_arrays([[low[0], low[1], low[2]], [high[0], low[1], low[2]], high], [[0, 1, 2]])
    vertices = np.concatenate([boxes.triangles().reshape(-1, 3), large.triangles().reshape(-1, 3)])
    return nf.Scene.from_arrays(vertices, np.arange(len(vertices)).reshape(-1, 3))


def build(world: nf.Scene, path: Path) -> nf.orthoview.OrthoTree:
    return nf.orthoview.build(world, path, cell=CELL, size=8, directions=5)


def test_owners_of_triangles_are_found(world: nf.Scene) -> None:
    grid = Grid.from_bounds(world.bounds, CELL)
    seen = 0
    for place, part in parts(world, grid):
        np.testing.assert_array_equal((owners(part, grid) == place).all(axis=1), owned_mask(part, grid, place))
        seen += part.triangle_count
    assert seen > 100
    assert set(map(tuple, owners(world, grid).tolist())) <= set(places(grid))


def test_records_list_the_guests_of_all_leaves(world: nf.Scene, tmp_path: Path) -> None:
    tree = build(world, tmp_path / "world.zarr")
    right = by_hand(world, Grid.from_bounds(world.bounds, CELL))
    assert of_tree(tree) == right
    assert max(map(len, right.values())) > 2


@pytest.mark.slow
def test_updates_and_copies_list_guests_of_the_new_world(tmp_path: Path) -> None:
    before, after = world_of(range(12)), world_of(range(1, 12))
    tree = build(before, tmp_path / "world.zarr").update(box_about({0}), after)
    fresh = build(after, tmp_path / "fresh.zarr")
    right = by_hand(after, tree._layout.grid)
    assert {leaf: own for leaf, own in of_tree(tree).items() if own} == right
    assert of_tree(tree.compact(tmp_path / "compact.zarr")) == right
    assert of_tree(fresh) == right
    assert right != by_hand(before, tree._layout.grid)


GRID = Grid((0.0, 0.0, 0.0), 1.0, (20, 4, 20))
LAYOUT = Layout(GRID, directions_of(5), 8, 12, 16, 3)


def test_guests_are_parsed_from_text() -> None:
    known: _owners.Guests = {(8, 2, 9): [(0, 0, 0), (19, 3, 19)], (15, 0, 15): [(5, 1, 7)]}
    text = _owners.encode_guests(known)
    assert _owners.guests_of(text, LAYOUT, 0, (1, 0, 1)) == known
    assert _owners.guests_of(_owners.encode_guests({}), LAYOUT, 1, (0, 0, 0)) == {}
    for wrong in (text[:-4], "AAAA", "é", text + text, _owners.encode_guests({})[:8]):
        with pytest.raises(UnusableError, match="guests"):
            _owners.guests_of(wrong, LAYOUT, 0, (1, 0, 1))


@pytest.mark.parametrize(
    ("leaf", "guest"),
    [
        *(((0, 0, 0), (5, 1, 7)), ((8, 0, 8), (8, 0, 8)), ((8, 0, 8), (20, 0, 0))),
        *(((8, 0, 8), (0, -1, 0)), ((8, 4, 8), (0, 0, 0))),
    ],
)
def test_impossible_guests_are_refused(leaf: Place, guest: Place) -> None:
    with pytest.raises(UnusableError, match="expected leaves of the subtree, and others of the tree"):
        _owners.guests_of(_owners.encode_guests({leaf: [guest]}), LAYOUT, 0, (1, 0, 1))
    with pytest.raises(UnusableError, match="expected leaves of the subtree"):
        _owners.guests_of(_owners.encode_guests({(8, 0, 8): [(0, 0, 0)]}), LAYOUT, 1, (1, 0, 1))
