"""Tests of cuts: which cells of a tree a viewer sees at which level, from which directions, and which as geometry."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, reject, strategies as st
from numpy.typing import NDArray

import nearfar as nf
from nearfar import _core
from nearfar.orthoview._cut import OrthoCut
from nearfar.orthoview._directions import Direction, directions_of
from nearfar.orthoview._grid import Grid
from tests.support import cut_oracle as oracle, need
from tests.support.orthoview_cases import CORNER, boxes
from tests.support.orthoview_stores import CELL, SIZE, Counted, of_cells, world_of

need("zarr")

MIDDLE = CORNER + 40.0
PITCH = CELL / SIZE
"""Width of a pixel of a leaf's views: from 5 directions they show the leaf's sides."""

WIDE, NARROW, ASKEW = nf.Fov.symmetric(100, 4 / 3), nf.Fov.symmetric(25), nf.Fov(-1.3, 0.2, -0.1, 0.9)
PLAN = nf.Orthographic(-31.7, 24.3, -18.1, 40.9)

Shown = dict[oracle.Cell, int]


def looking(eye: Iterable[float], target: Iterable[float], fov: Any = WIDE, width: int = 64) -> nf.Camera:
    return nf.Camera.look_at(list(eye), list(target), fov=fov, size=(width, 48))


def face(number: int, eye: Sequence[float]) -> nf.Camera:
    x, y, z = map(float, eye)
    return nf.Camera((x, y, z), fov=nf.CubeFace(number), size=(48, 48))


CAMERAS = {
    "inside": looking(MIDDLE + (1.3, -2.1, 7.7), MIDDLE + (20, 3, -9)),
    "inside, narrow": looking(MIDDLE + (-21.2, 4.4, 12.9), MIDDLE, NARROW),
    "inside, askew": looking(MIDDLE + (3.1, 11.4, 2.9), MIDDLE + (1, 0, 0), ASKEW, 17),
    "above": looking(MIDDLE + (4.2, 77.7, 1.3), MIDDLE + (2, 0, 1)),
    "outside": looking(MIDDLE + (-117.3, 23.9, 40.2), MIDDLE),
    "outside, narrow": looking(MIDDLE + (171.9, 61.1, -40.7), MIDDLE + (20, 10, -5), NARROW),
    "far away": looking(MIDDLE + (2131.3, 523.9, 40.2), MIDDLE, NARROW),
    "away from it": looking(MIDDLE + (-91.3, 23.9, 40.2), MIDDLE + (-131.3, 20, 50)),
    "a plan": looking(MIDDLE + (1.7, 100.3, 2.3), MIDDLE + (0, 0, 1), PLAN),
    "a plan, fine": looking(MIDDLE + (1.7, 9.3, 2.3), MIDDLE + (0, 5, 33), PLAN, 640),
} | {f"face {number}": face(number, MIDDLE + (2.2, -3.3, 5.1)) for number in range(6)}


@pytest.fixture(scope="module")
def shown(world: nf.Scene) -> Shown:
    """The cells in which something is, computed without a store, with the bits of the directions that show it."""
    cells = of_cells(world).items()
    return {cell: sum(1 << n for n, empty in enumerate(views.empty()) if not empty) for cell, views in cells}


@pytest.fixture(scope="module")
def grid(world: nf.Scene) -> Grid:
    return Grid.over(world.bounds, CELL)


def rows(places: NDArray[np.int64]) -> list[tuple[int, int, int]]:
    return [(x, y, z) for x, y, z in places.tolist()]


def cells_of(cut: OrthoCut) -> dict[oracle.Cell, bool]:
    """All cells and leaves of a cut with whether they are in the picture; each is there once."""
    cells = list(zip(cut.level.tolist(), rows(cut.place), strict=True))
    found = dict(zip(cells, cut.in_picture.tolist(), strict=True))
    found |= zip([(0, place) for place in rows(cut.leaves)], cut.leaf_in_picture.tolist(), strict=True)
    assert len(found) == len(cut.level) + len(cut.leaves)
    return found


class Doubtful(Exception):
    """Roundings decide about the result."""


def check(
    tree: nf.orthoview.OrthoTree, shown: Shown, grid: Grid, camera: nf.Camera, error_px: float, geometry: bool
) -> oracle.Expected:
    """Compare the cuts of a viewer, within the picture and around, with those of the oracle."""
    right = oracle.expected(shown, grid, camera, PITCH, error_px, geometry=geometry)
    if right.is_doubtful:
        raise Doubtful
    around = tree.cut(camera, error_px=error_px, geometry=geometry, around=True)
    within = tree.cut(camera, error_px=error_px, geometry=geometry)
    assert around.unknown == within.unknown == []
    assert math.isclose(around.reach, right.reach, rel_tol=1e-12)
    drawn = zip(around.level.tolist(), rows(around.place), strict=True)
    assert (set(drawn), set(rows(around.leaves))) == (right.cells, right.leaves)
    for cell, is_in in cells_of(around).items():
        margin = oracle.margin(camera, oracle.corners_of(grid, cell))
        assert is_in == (margin >= 0) or abs(margin) < oracle.DOUBT, cell
        assert is_in or not oracle.is_sampled(camera, oracle.corners_of(grid, cell, 5)), cell
    assert cells_of(within) == {cell: True for cell, is_in in cells_of(around).items() if is_in}
    eye = np.array(camera.position)
    for places, levels, distances in (
        (around.place, around.level, around.distance),
        (around.leaves, np.zeros(len(around.leaves), int), around.leaf_distance),
    ):
        assert (np.diff(distances) >= 0).all()
        boxes = [grid.box(level, place) for level, place in zip(levels.tolist(), rows(places), strict=True)]
        assert np.allclose(distances, [oracle.nearest(eye, low, high) for low, high in boxes], rtol=0, atol=1e-9)
    return right


@pytest.mark.parametrize("name", CAMERAS)
def test_a_cut_is_that_of_a_recursion_over_all_cells(
    tree: nf.orthoview.OrthoTree, shown: Shown, grid: Grid, name: str
) -> None:
    levels, leaves = set(), 0
    for error_px, geometry in itertools.product((0.3, 1.0, 3.7, 20.0), (True, False)):
        right = check(tree, shown, grid, CAMERAS[name], error_px, geometry)
        assert geometry or not right.leaves
        levels |= {level for level, _ in right.cells}
        leaves += len(right.leaves)
    assert len(levels) > 1
    assert leaves > 0 or name == "far away"


coordinate = st.floats(-150, 150)
fov = st.sampled_from([WIDE, NARROW, ASKEW, PLAN, *map(nf.CubeFace, range(6))])
turn = st.lists(st.floats(-1, 1), min_size=4, max_size=4).filter(lambda parts: np.linalg.norm(parts) > 0.1)


@given(st.tuples(coordinate, coordinate, coordinate), turn, fov, st.floats(0.2, 30), st.booleans())
def test_a_cut_of_any_viewer(
    tree: nf.orthoview.OrthoTree,
    shown: Shown,
    grid: Grid,
    place: tuple[float, float, float],
    turn: list[float],
    fov: Any,
    error_px: float,
    geometry: bool,
) -> None:
    eye = (MIDDLE + place).tolist()
    camera = nf.Camera(eye, np.array(turn) / np.linalg.norm(turn), fov=fov, size=(48, 48))  # type: ignore[arg-type]
    try:
        check(tree, shown, grid, camera, error_px, geometry)
    except Doubtful:
        reject()


@pytest.mark.parametrize("name", CAMERAS)
def test_each_leaf_is_covered_once(tree: nf.orthoview.OrthoTree, shown: Shown, name: str) -> None:
    leaves = [place for level, place in shown if level == 0]
    assert len(leaves) == tree.held["leaves"]
    for error_px in (0.5, 4.0):
        cells = cells_of(tree.cut(CAMERAS[name], error_px=error_px, around=True))
        for x, y, z in leaves:
            above = [(level, (x >> level, y >> level, z >> level)) for level in range(tree.levels)]
            assert sum(cell in cells for cell in above) == 1, (x, y, z)


# directions ---------------------------------------------------------------------------------------------------------
def angle(one: Any, other: Any) -> float:
    return math.acos(np.clip(np.dot(one, other) / np.linalg.norm(one) / np.linalg.norm(other), -1, 1))


def nearest(toward: Any, directions: Sequence[Direction], views: int, mask: int) -> list[int]:
    """Those of the nearest directions that show something, filled up with −1."""
    angles = [angle(direction, toward) for direction in directions]
    if min(np.diff(sorted(angles))) < 1e-7:
        raise Doubtful
    numbers = [number for number in np.argsort(angles).tolist()[:views] if mask >> number & 1]
    return numbers + [-1] * (views - len(numbers))


def one_cell(mask: int) -> _core.OrthoCells:
    """A tree of one leaf, 2 m wide about the origin."""
    cells = _core.OrthoCells((-1.0, -1.0, -1.0), 2.0, 1, 1)
    cells.add(0, (0, 0, 0), [np.array([mask] + 7 * [0], np.uint32)])
    return cells


def directions_in(cells: _core.OrthoCells, camera: nf.Camera, directions: Sequence[Direction], views: int) -> list[int]:
    arrays, _, unknown = cells.cut(
        camera._core, pitch=1.0, error=1.0, directions=directions, views=views, geometry=False, around=True
    )
    assert unknown == []
    (numbers,) = arrays["directions"].tolist()
    assert set(numbers[views:]) <= {-1}
    return list(numbers[:views])


@given(
    st.tuples(coordinate, coordinate, coordinate).filter(lambda eye: np.linalg.norm(eye) > 0.1),
    st.sampled_from([5, 9, 13, 26]),
    st.integers(1, 8),
    st.integers(1, 2**26 - 1),
    st.booleans(),
)
def test_directions_are_the_nearest_to_the_viewer_by_angle(
    eye: tuple[float, float, float], count: int, views: int, mask: int, is_parallel: bool
) -> None:
    directions = directions_of(count)
    mask &= 2**count - 1
    assume(mask)
    camera = nf.Camera(eye, fov=NARROW, size=(8, 8))
    toward = np.array(eye)
    if is_parallel:
        assume(abs(toward[0]) + abs(toward[2]) > 0.1)
        camera = looking((0.3, 0.2, 0.1), np.array([0.3, 0.2, 0.1]) - toward, nf.Orthographic(-1, 1, -1, 1))
    try:
        right = nearest(toward, directions, views, mask)
    except Doubtful:
        reject()
    assert directions_in(one_cell(mask), camera, directions, views) == right


def test_views_that_show_nothing_are_left_out_and_none_takes_their_place() -> None:
    directions = directions_of(5)  # +z, +x, −z, −x, +y
    camera = nf.Camera((5.0, 9.0, 2.0), fov=NARROW, size=(8, 8))  # nearest to +y, then +x, +z, −z, −x
    for mask, right in {
        0b11111: [4, 1, 0],
        0b01111: [1, 0, -1],
        0b11101: [4, 0, -1],
        0b00001: [0, -1, -1],
        0b01100: [-1, -1, -1],
    }.items():
        assert directions_in(one_cell(mask), camera, directions, 3) == right


def test_directions_of_a_tree_are_those_of_its_views(
    tree: nf.orthoview.OrthoTree, shown: Shown, grid: Grid
) -> None:
    camera, missing = CAMERAS["inside"], 0
    cut = tree.cut(camera, views=4, around=True)
    for level, place, numbers in zip(cut.level.tolist(), rows(cut.place), cut.directions.tolist(), strict=True):
        toward = np.array(camera.position) - grid.box(level, place).mean(axis=0)
        assert numbers == nearest(toward, tree.directions, 4, shown[level, place])
        missing += numbers.count(-1)
    assert missing > 0


@pytest.mark.parametrize(("count", "widest"), [(5, 1.0), (9, math.sqrt(2)), (13, 4 / math.sqrt(6))])
def test_the_widest_view_decides_the_reach(count: int, widest: float, tmp_path: Path) -> None:
    """A cube of side 1 is √2 high from between two sides, and 4/√6 from a corner."""
    scene = boxes(1, 8.0)[0]
    tree = nf.orthoview.build(scene, tmp_path / "tree.zarr", cell=20.0, size=SIZE, directions=count)
    # Pixels of 1/8 × 1/32 at 1 m: a square of their area has a side of 1/16.
    camera = nf.Camera((0, 0, 0), fov=nf.Fov(-1, 1, -1, 1), size=(16, 64))
    assert math.isclose(tree.cut(camera, error_px=2.0).reach, widest * 20.0 / SIZE * 16 / 2)


# growth -------------------------------------------------------------------------------------------------------------
def flat(leaves: int) -> _core.OrthoCells:
    """A world of leaves of 1 m on one floor, with something everywhere."""
    levels = leaves.bit_length()
    cells = _core.OrthoCells((0.0, 0.0, 0.0), 1.0, levels, 3)
    for tier in range(-(-levels // 3)):
        lowest = 3 * tier
        sides = [2 ** (3 - n) for n in range(min(3, levels - lowest))]
        masks = [np.zeros((side, side, side), np.uint32) for side in sides]
        for level, mask in enumerate(masks, lowest):
            mask[: leaves >> level, 0, : leaves >> level] = 0b11111
        for x, z in itertools.product(range(max(1, leaves >> lowest + 3)), repeat=2):
            cells.add(tier, (x, 0, z), [mask.reshape(-1) for mask in masks])
    return cells


def counted(leaves: int, pitch: float, height: float = 0.0) -> tuple[int, int]:
    """Cells and leaves of a cut for a viewer in the middle of a flat world."""
    camera = nf.Camera((leaves / 2, height, leaves / 2), fov=nf.Fov(-1, 1, -1, 1), size=(64, 64))
    arrays, _, unknown = flat(leaves).cut(
        camera._core, pitch=pitch, error=1.0, directions=directions_of(5), views=3, geometry=True, around=True
    )
    assert unknown == []
    return len(arrays["level"]), len(arrays["leaf_level"])


def test_a_cut_grows_by_as_many_cells_with_each_doubling_of_the_world() -> None:
    for leaves in (16, 32, 64, 128):
        # With a reach of a leaf's side, of the four cells of a level about the viewer each gives way to four children:
        # one touches the viewer, the others are one side away or √2 sides, which is just far enough.
        assert counted(leaves, 1 / 32) == (4 * 3 * (leaves.bit_length() - 2), 4)
    for pitch, height in ((0.1, 0.3), (0.2, 1.7)):
        numbers = [sum(counted(leaves, pitch, height)) for leaves in (16, 32, 64, 128)]
        added = np.diff(numbers)
        assert (added > 0).all()
        assert (np.diff(added) <= 0).all(), numbers


# lists, and bad calls -----------------------------------------------------------------------------------------------
def test_keys_are_the_views_of_the_cut(tree: nf.orthoview.OrthoTree) -> None:
    cut = tree.cut(CAMERAS["inside"], error_px=2.0, around=True)
    assert len(cut) == len(cut.level)
    for in_picture in (False, True):
        keys, leaves = [], []
        for n in range(len(cut)):
            if cut.in_picture[n] or not in_picture:
                x, y, z = (int(number) for number in cut.place[n])
                keys += [(int(cut.level[n]), (x, y, z), int(number)) for number in cut.directions[n] if number != -1]
        for n in range(len(cut.leaves)):
            if cut.leaf_in_picture[n] or not in_picture:
                leaves.append(tuple(cut.leaves[n].tolist()))
        assert cut.keys(in_picture) == keys
        assert cut.leaf_places(in_picture) == leaves
        assert len(set(keys)) == len(keys)
    assert 0 < len(cut.keys(in_picture=True)) < len(cut.keys())
    assert 0 < len(cut.leaf_places(in_picture=True)) < len(cut.leaf_places())
    assert all(tree.view(*key) is not None for key in cut.keys()[:200])
    within = tree.cut(CAMERAS["inside"], error_px=2.0)
    assert within.keys() == within.keys(in_picture=True) == cut.keys(in_picture=True)
    assert within.leaf_places() == cut.leaf_places(in_picture=True)


BAD: dict[str, tuple[dict[str, Any], type[Exception], str]] = {
    "a camera that is none": ({"camera": (0, 0, 0)}, TypeError, "camera: expected a Camera, got tuple"),
    "no views": ({"views": 0}, ValueError, "views: expected"),
    "many views": ({"views": 9}, ValueError, "views: expected"),
    "views in parts": ({"views": 2.5}, TypeError, "views: expected"),
    "no error": ({"error_px": 0}, ValueError, "error_px: expected"),
    "an error of NaN": ({"error_px": math.nan}, ValueError, "error_px: expected"),
    "an endless error": ({"error_px": math.inf}, ValueError, "error_px: expected"),
    "an error below 0": ({"error_px": -1.0}, ValueError, "error_px: expected"),
    "an error in words": ({"error_px": "1"}, TypeError, "error_px: expected"),
    "a number for geometry": ({"geometry": 1}, TypeError, "geometry: expected"),
    "a number for around": ({"around": 0}, TypeError, "around: expected"),
    "a word for around": ({"around": "yes"}, TypeError, "around: expected"),
}


@pytest.mark.parametrize("name", BAD)
def test_bad_calls_are_named(tree: nf.orthoview.OrthoTree, name: str) -> None:
    arguments, kind, message = BAD[name]
    call: Callable[..., OrthoCut] = tree.cut
    with pytest.raises(kind, match=message):
        call(**{"camera": CAMERAS["inside"]} | arguments)


def test_a_tree_that_is_not_complete_has_no_cut(tmp_path: Path) -> None:
    source = Counted(world_of(range(3)), {5})
    tree = nf.orthoview.build(source, tmp_path / "part.zarr", cell=40.0, size=SIZE, directions=5)
    assert not tree.is_complete
    with pytest.raises(ValueError, match=r"part\.zarr is not complete, build it again"):
        tree.cut(CAMERAS["inside"])
