"""Tests of cells' availability in a store's records, which saves cuts from reading shards, and of lazy reading."""

from __future__ import annotations

import base64
import hashlib
import json
import shutil
import zlib
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh

import nearfar as nf
from nearfar.orthoview import _owners, _store
from nearfar.orthoview._cut import Cutter, OrthoCut, Settings
from nearfar.orthoview._grid import Place
from tests.support import need, valid
from tests.support.orthoview_stores import CELL, SIZE, box_about, masks_of, of_subtrees, places, world_of

need("zarr")

Tree = nf.orthoview.OrthoTree

SIDE = 240.0
"""A flat world of 24 × 1 × 24 leaves, in 3 × 1 × 3 subtrees of 8 × 8 × 8."""

INHABITED = {(0, 0, 0), (0, 0, 2), (1, 0, 0), (2, 0, 2)}
"""Subtrees that are not empty."""


def built(scene: nf.Scene, path: Path) -> Tree:
    return nf.orthoview.build(scene, path, cell=CELL, size=SIZE, directions=5)


def ends(side: float) -> list[trimesh.Trimesh]:
    """Two small boxes that span a world."""
    return [trimesh.creation.box((1, 1, 1)).apply_translation((end, 0.5, end)) for end in (0.5, side - 0.5)]


AMID = ((37, 37), (45, 37), (37, 45), (44, 52))
"""Places of four boxes in the middle of a subtree."""


def flat(subtrees: set[Place], side: float = SIDE, shifts: Iterable[tuple[int, int]] = AMID) -> nf.Scene:
    """A world with boxes at some places in each of the given subtrees, which are 80 m wide."""
    parts = ends(side)
    for x, _, z in sorted(subtrees):
        for dx, dz in shifts:
            turn = trimesh.transformations.rotation_matrix(dx + dz, (0, 1, 0))
            box = trimesh.creation.box((3, 4 + dx / 20, 5)).apply_transform(turn)
            parts.append(box.apply_translation((80 * x + dx, 4, 80 * z + dz)))
    return nf.Scene.from_trimesh(trimesh.util.concatenate(parts))


@pytest.fixture(scope="module")
def wide(tmp_path_factory: pytest.TempPathFactory) -> Tree:
    tree = built(flat(INHABITED), tmp_path_factory.mktemp("wide") / "wide.zarr")
    assert (tree.cells(0), tree.levels) == ((24, 1, 24), 6)
    return tree


@pytest.fixture(scope="module")
def updated(wide: Tree, tmp_path_factory: pytest.TempPathFactory) -> Tree:
    """A copy of the same after an update."""
    copy = shutil.copytree(wide.path, tmp_path_factory.mktemp("updated") / "copy.zarr")
    return nf.orthoview.open(copy).update([[20, 0, 20], [60, 9, 60]], flat(INHABITED - {(0, 0, 0)}))


def bare(tree: Tree, path: Path) -> Path:
    """Copy a store's documents without its shards and its geometry."""
    return Path(shutil.copytree(tree.path, path, ignore=shutil.ignore_patterns("[pn][xyz]", "geometry")))


def count_views(tree: Tree) -> dict[tuple[int, Place], int]:
    """The same counts from its views."""
    cells = [(level, place) for level in range(tree.levels) for place in places(tree.cells(level))]
    masks = {cell: sum(1 << n for n in range(5) if tree.view(*cell, n) is not None) for cell in cells}
    return {cell: mask for cell, mask in masks.items() if mask}


def test_records_list_non_empty_views(wide: Tree) -> None:
    found = masks_of(wide)
    assert found == count_views(wide)
    assert {level for level, _ in found} == set(range(6))
    assert {place for level, place in found if level == 3} == INHABITED
    assert len(found) == wide.held["cells"]


def test_records_list_views_of_two_layers(tmp_path: Path) -> None:
    scene = flat({(0, 0, 0), (1, 0, 1)}, 90.0, [(4, 4)])
    tree = nf.orthoview.build(scene, tmp_path / "world.zarr", cell=CELL, size=SIZE, directions=5, layers=2)
    assert masks_of(tree) == count_views(tree)
    assert {place for level, place in masks_of(tree) if level == 0} == {(0, 0, 0), (8, 0, 8)}


FIRST = {(0, 0, 0), (1, 0, 0), (1, 0, 1)}
SECOND = FIRST | {(0, 0, 1)}
THIRD = SECOND - {(1, 0, 0)}
"""Non-empty subtrees of a small world: one is filled, then another one is emptied."""


@pytest.fixture(scope="module")
def three_generations(tmp_path_factory: pytest.TempPathFactory) -> list[Tree]:
    """Three generations of a store, each opened when it was the newest."""
    first, second, third = (flat(here, 90.0, [(4, 4)]) for here in (FIRST, SECOND, THIRD))
    tree = built(first, tmp_path_factory.mktemp("changed") / "world.zarr")
    assert tree.cells(0) == (9, 1, 9)
    once = tree.update([[1, 0, 81], [7, 9, 87]], second)
    return [tree, once, once.update([[81, 0, 1], [87, 9, 7]], third)]


def test_records_list_views_of_each_generation_and_of_a_copy(three_generations: list[Tree], tmp_path: Path) -> None:
    """Open trees keep their generation."""
    for tree, here in zip(three_generations, (FIRST, SECOND, THIRD), strict=True):
        found = masks_of(tree)
        assert found == count_views(tree)
        assert {place for level, place in found if level == 3} == here
        assert len(found) == tree.held["cells"]
    compacted = tree.compact(tmp_path / "compact.zarr")
    assert compacted.generation == 0
    assert masks_of(compacted) == count_views(compacted) == found


def test_records_follow_changed_directions(tmp_path: Path) -> None:
    """A wall is rotated: other views are empty now."""

    def wall(x: float, z: float) -> nf.Scene:
        corners = np.array([[15, 1, 15], [15 + x, 1, 15 + z], [15 + x, 4, 15 + z], [15, 4, 15]], float)
        standing = trimesh.Trimesh(corners, [[0, 1, 2], [0, 2, 3]], process=False)
        return nf.Scene.from_trimesh(trimesh.util.concatenate([*ends(40.0), standing]))

    tree = built(wall(3, 0), tmp_path / "wall.zarr")
    turned = tree.update([[11, 0, 11], [19, 9, 19]], wall(0, 3))
    assert masks_of(tree)[0, (1, 0, 1)] == 0b00101  # Visible from +z and −z.
    assert masks_of(turned)[0, (1, 0, 1)] == 0b01010  # Visible from +x and −x.
    assert masks_of(turned) == count_views(turned)


def test_a_world_may_become_empty(tmp_path: Path) -> None:
    tree = nf.orthoview.build(world_of(range(6)), tmp_path / "world.zarr", cell=20.0, size=SIZE, directions=5)
    emptied = tree.update(box_about(range(6)), world_of([]))
    assert masks_of(emptied) == count_views(emptied)
    assert {place for level, place in masks_of(emptied) if level == 0} == {(0, 0, 0), (3, 3, 3)}
    assert len(masks_of(tree)) > len(masks_of(emptied))


def test_a_subtree_that_was_not_built_is_empty(wide: Tree) -> None:
    for tier, place in ((0, (7, 3, 9)), (0, (1, 1, 1)), (1, (4, 0, 0))):
        masks = of_subtrees(wide)(tier, place).masks
        assert [mask.shape for mask in masks] == [(8, 8, 8), (4, 4, 4), (2, 2, 2)]
        assert not any(mask.any() for mask in masks)


def text(content: bytes) -> str:
    return base64.b64encode(content).decode()


def long(size: int) -> str:
    return text(zlib.compress(bytes(size)))


FULL = [long(4 * 8**3), long(4 * 4**3), long(4 * 2**3)]

DAMAGED: dict[str, Any] = {
    "truncated": [FULL[0][:-5], *FULL[1:]],
    "cut at a whole byte": [text(base64.b64decode(FULL[0])[:-8]), *FULL[1:]],
    "no base64": ["*" * 40, *FULL[1:]],
    "beyond ASCII": ["ä", *FULL[1:]],
    "wrong zlib": [text(b"\0\1\2\3" * 8), *FULL[1:]],
    "a wrong sum": [text(zlib.compress(bytes(2048))[:-1] + b"\7"), *FULL[1:]],
    "cut before its sum": [text(base64.b64decode(FULL[0])[:-4]), *FULL[1:]],
    "with more behind it": [text(base64.b64decode(FULL[0]) + b"more"), *FULL[1:]],
    "of a level too few": FULL[:2],
    "of a level too many": [*FULL, FULL[2]],
    "none": [],
    "short": [FULL[1], FULL[1], FULL[2]],
    "a little long": [long(4 * 8**3 + 1), *FULL[1:]],
    "huge": [long(1 << 27), *FULL[1:]],
    "numbers": [1, 2, 3],
    "a number": 3,
    "null": None,
    "one text": "abc",
    "a mapping": {"0": FULL[0], "1": FULL[1], "2": FULL[2]},
}


def damage(file: Path, change: Callable[[dict[str, Any]], Any]) -> None:
    document = json.loads(file.read_text())
    change(document)
    file.write_text(json.dumps(document))
    records = file.parents[1] / "records.json"
    if records.exists():
        listed = json.loads(records.read_text())
        listed["records"][file.name] = hashlib.sha256(file.read_bytes()).hexdigest()
        records.write_text(json.dumps(listed))


CAMERA = nf.Camera.look_at((50, 10, 50), (40, 4, 40), fov=nf.Fov.symmetric(90), size=(64, 64))


def test_cuts_read_no_shards(wide: Tree, updated: Tree, tmp_path: Path) -> None:
    lengths = []
    for tree in (wide, updated):
        opened = nf.orthoview.open(bare(tree, tmp_path / f"{tree.generation}.zarr"))
        assert not (Path(opened.path) / "0" / "py").exists()
        found, right = opened.cut(CAMERA, around=True), tree.cut(CAMERA, around=True)
        assert found.keys() == right.keys()
        assert found.leaf_places() == right.leaf_places()
        lengths.append(len(found) + len(found.leaves))
    assert lengths[0] > lengths[1] > 0


@pytest.mark.parametrize("name", DAMAGED)
def test_damaged_records_are_named(wide: Tree, tmp_path: Path, name: str) -> None:
    store = bare(wide, tmp_path / "bare.zarr")
    damage(store / "nearfar" / "done" / "0_0_0_0.json", lambda document: document.update(views=DAMAGED[name]))
    with pytest.raises(nf.FormatError, match=r"nearfar/done/0_0_0_0\.json: damaged"):
        nf.orthoview.open(store).cut(CAMERA)


def test_records_without_views_are_named(wide: Tree, tmp_path: Path) -> None:
    """The format of builds before there were cuts."""
    store = bare(wide, tmp_path / "bare.zarr")
    file = store / "nearfar" / "done" / "0_0_0_0.json"
    assert valid(json.loads(file.read_text()), "orthoview_subtree")
    damage(file, lambda document: document.pop("views"))
    assert not valid(json.loads(file.read_text()), "orthoview_subtree")
    with pytest.raises(nf.FormatError, match=r"nearfar/done/0_0_0_0\.json: damaged: 'views' is missing"):
        nf.orthoview.open(store).cut(CAMERA)


NO_GUESTS = _owners.encode_guests({})
WRONG: dict[str, Any] = {
    f"views {name}": {"0_0_0_0": {"views": views, "guests": NO_GUESTS}} for name, views in DAMAGED.items()
}
WRONG |= {"nothing of a subtree": {"0_0_0_0": None}, "guests": {"0_0_0_0": {"views": [], "guests": "AAAA"}}}
WRONG |= {"a list": [], "a number": 3, "null": None, "a text": "0_0_0_0"}


@pytest.mark.parametrize("name", [*WRONG, "missing"])
def test_damaged_generations_are_named(updated: Tree, tmp_path: Path, name: str) -> None:
    store = bare(updated, tmp_path / "bare.zarr")
    file = store / "nearfar" / "generations" / "1" / "generation.json"
    assert valid(json.loads(file.read_text()), "orthoview_generation")
    damage(file, lambda document: document.update(cells=WRONG[name]) if name in WRONG else document.pop("cells"))
    with pytest.raises(nf.FormatError, match=r"nearfar/generations/1/generation\.json: damaged"):
        nf.orthoview.open(store).cut(CAMERA)


# lazy reading -------------------------------------------------------------------------------------------------------
class Noted:
    """Reads a tree's records, and records which."""

    def __init__(self, tree: Tree) -> None:
        self._read = of_subtrees(tree)
        self.subtrees: list[tuple[int, Place]] = []

    def __call__(self, tier: int, place: Place) -> _store.Cells:
        self.subtrees.append((tier, place))
        return self._read(tier, place)


def looking(eye: tuple[float, float, float], target: tuple[float, float, float], width: int = 64) -> nf.Camera:
    return nf.Camera.look_at(eye, target, fov=nf.Fov(-1, 1, -1, 1), size=(width, width))


def columns(cut: OrthoCut) -> set[tuple[int, Place]]:
    return {(level, (x, y, z)) for level, (x, y, z) in zip(cut.level.tolist(), cut.place.tolist(), strict=True)}


def test_a_distant_viewer_reads_fewer_subtrees(wide: Tree) -> None:
    known = []
    for eye in ((5000.0, 3000.0, 5000.0), (120.0, 400.0, 120.0), (40.0, 10.0, 40.0)):
        opened = nf.orthoview.open(wide.path)
        opened.cut(looking(eye, (120.0, 0.0, 121.0)), around=True)
        known.append(len(opened._viewer.cutter._known))
    # Pixels of 1/32 at 1 m, those of leaves are 10/16 m wide: level 3 is fine enough from 160 m on. Far away the top
    # is, from above level 3 is, and from the first subtree that and those 40 and 120 m away are not.
    assert known == [1, 1, 1 + 3]


def test_subtrees_are_read_once_and_empty_ones_never(wide: Tree) -> None:
    read = Noted(wide)
    cutter = Cutter(wide._layout, read)
    turning = [looking((120, 30, 120), (120 + x, 0, 120 + z), 1024) for x in (-9, 9) for z in (-9, 9)]
    for camera in turning:
        cutter.complete_cut(camera, Settings(), around=True)
    assert len(read.subtrees) == len(set(read.subtrees)) == len(cutter._known)
    assert set(read.subtrees) == {(1, (0, 0, 0))} | {(0, place) for place in INHABITED}


def test_subtrees_outside_of_the_picture_are_not_read(wide: Tree) -> None:
    read = Noted(wide)
    camera = looking((100, 30, 220), (220, 0, 200), 1024)  # Towards (2, 0, 2), away from (0, 0, 2).
    found = Cutter(wide._layout, read).complete_cut(camera, Settings())
    assert set(read.subtrees) == {(1, (0, 0, 0)), (0, (2, 0, 2))}
    assert set(found.keys()) == set(wide.cut(camera, around=True).keys(in_picture=True))


def test_cells_above_stand_in_for_unknown_ones(wide: Tree) -> None:
    camera = looking((40, 10, 40), (120, 0, 121))
    cutter = Cutter(wide._layout, of_subtrees(wide))
    nothing = cutter.cut(camera, Settings(), around=True)
    assert (len(nothing), len(nothing.leaves), nothing.unknown) == (0, 0, [(1, (0, 0, 0))])
    cutter.read_record(1, (0, 0, 0))
    coarse = cutter.cut(camera, Settings(), around=True)
    assert columns(coarse) == {(3, place) for place in INHABITED}
    assert len(coarse.leaves) == 0
    # The cell in the far corner is fine enough.
    assert sorted(coarse.unknown) == [(0, place) for place in sorted(INHABITED - {(2, 0, 2)})]
    assert coarse.keys()
    cutter.read_record(0, (0, 0, 0))
    mixed = cutter.cut(camera, Settings(), around=True)
    assert columns(mixed) > columns(coarse) - {(3, (0, 0, 0))}
    assert {(x >> 3, y >> 3, z >> 3) for x, y, z in mixed.leaf_places()} == {(0, 0, 0)}
    assert sorted(mixed.unknown) == [(0, (0, 0, 2)), (0, (1, 0, 0))]
    whole, right = cutter.complete_cut(camera, Settings(), around=True), wide.cut(camera, around=True)
    assert whole.unknown == []
    assert (whole.keys(), whole.leaf_places()) == (right.keys(), right.leaf_places())
    assert set(whole.level.tolist()) >= {0, 3}
    assert len(cutter._known) == 4
