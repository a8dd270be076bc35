"""Tests of cuts: the cells, levels and directions that a viewer needs, and which cells are geometry."""

from __future__ import annotations

import itertools
import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, reject, strategies as st
from numpy.typing import NDArray

import nearfar as nf
from nearfar.orthoview._cut import BAND, OrthoCut
from nearfar.orthoview._grid import Grid
from tests.support import cut_oracle as oracle, need
from tests.support.orthoview_cases import CORNER, boxes
from tests.support.orthoview_stores import CELL, SIZE, masks_of

need("zarr")

MIDDLE = CORNER + 40.0
PITCH = CELL / SIZE
"""Width of a pixel of a leaf's views: with 5 directions they show the leaf's sides."""

WIDE, NARROW, ASKEW = nf.Fov.symmetric(100, 4 / 3), nf.Fov.symmetric(25), nf.Fov(-1.3, 0.2, -0.1, 0.9)
PLAN = nf.Orthographic(-31.7, 24.3, -18.1, 40.9)


def looking(eye: Any, target: Any, fov: Any = WIDE, width: int = 64) -> nf.Camera:
    """A view between two points given relative to the world's middle."""
    return nf.Camera.look_at(MIDDLE + eye, MIDDLE + target, fov=fov, size=(width, 48))


CAMERAS = {
    "inside": looking((1.3, -2.1, 7.7), (20, 3, -9)),
    "inside, narrow": looking((-21.2, 4.4, 12.9), (0, 0, 0), NARROW),
    "inside, askew": looking((3.1, 11.4, 2.9), (1, 0, 0), ASKEW, 17),
    "above": looking((4.2, 77.7, 1.3), (2, 0, 1)),
    "outside": looking((-91.3, 23.9, 40.2), (0, 0, 0)),
    "outside, narrow": looking((171.9, 61.1, -40.7), (20, 10, -5), NARROW),
    "far away": looking((2131.3, 523.9, 40.2), (0, 0, 0), NARROW),
    "away from it": looking((-91.3, 23.9, 40.2), (-131.3, 20, 50)),
    "a plan": looking((1.7, 100.3, 2.3), (0, 0, 1), PLAN),
    "a plan, fine": looking((1.7, 9.3, 2.3), (0, 5, 33), PLAN, 640),
} | {
    f"face {number}": nf.Camera(MIDDLE + np.array([2.2, -3.3, 5.1]), fov=nf.CubeFace(number), size=(48, 48))
    for number in range(6)
}


@pytest.fixture(scope="module")
def cells(world: nf.Scene, tree: nf.orthoview.OrthoTree) -> oracle.World:
    """Non-empty cells, with bit masks of their non-empty directions; test_build.py checks them."""
    return oracle.World.from_cells(Grid.from_bounds(world.bounds, CELL), masks_of(tree))


def rows(places: NDArray[np.int64]) -> list[tuple[int, int, int]]:
    return [(x, y, z) for x, y, z in places.tolist()]


def cells_of(cut: OrthoCut) -> dict[oracle.Cell, bool]:
    """All cells and leaves of a cut with their visibility; asserts that each occurs once."""
    cells = list(zip(cut.level.tolist(), rows(cut.place), strict=True))
    found = dict(zip(cells, cut.in_picture.tolist(), strict=True))
    found |= zip([(0, place) for place in rows(cut.leaves)], cut.leaf_in_picture.tolist(), strict=True)
    assert len(found) == len(cut.level) + len(cut.leaves)
    return found


def check(
    tree: nf.orthoview.OrthoTree,
    cells: oracle.World,
    camera: nf.Camera,
    error_px: float,
    geometry: bool,
    continuous: bool = False,
    gaze: tuple[float, float] | None = None,
) -> oracle.Expected:
    """Compare the cuts of a viewer, within the picture and all around, with those of the oracle."""
    band = BAND if continuous else None
    right = oracle.expected(cells, camera, PITCH, error_px, geometry=geometry, band=band, gaze=gaze)
    if right.is_doubtful:
        raise oracle.DoubtfulError
    settings: dict[str, Any] = {"error_px": error_px, "geometry": geometry, "continuous": continuous, "gaze": gaze}
    around = tree.cut(camera, around=True, **settings)
    within = tree.cut(camera, **settings)
    assert around.unknown == within.unknown == []
    assert math.isclose(around.reach, right.reach, rel_tol=1e-12)
    drawn = zip(around.level.tolist(), rows(around.place), strict=True)
    assert (set(drawn), set(rows(around.leaves))) == (right.cells, right.leaves)
    partial = zip(around.level[around.partial].tolist(), rows(around.place[around.partial]), strict=True)
    assert set(partial) == right.partial
    found = cells_of(around)
    low, high = np.moveaxis(np.array([cells.grid.box(*cell) for cell in found]).reshape(-1, 2, 3), 1, 0)
    is_in, margins = np.array([*found.values()], bool), oracle.margins(camera, oracle.lattice(low, high))
    is_sure = np.abs(margins) >= oracle.DOUBT
    np.testing.assert_array_equal(is_in[is_sure], margins[is_sure] >= 0)
    out = is_sure & ~is_in
    assert not oracle.are_sampled(camera, oracle.lattice(low[out], high[out], 5)).any()
    assert cells_of(within) == {cell: True for cell, is_in in found.items() if is_in}
    distances = np.concatenate([around.distance, around.leaf_distance])
    np.testing.assert_allclose(distances, oracle.nearest(np.array(camera.position), low, high), rtol=0, atol=1e-9)
    assert (np.diff(around.distance) >= 0).all()
    assert (np.diff(around.leaf_distance) >= 0).all()
    return right


@pytest.mark.parametrize("name", CAMERAS)
def test_a_cut_equals_a_recursion_over_all_cells(tree: nf.orthoview.OrthoTree, cells: oracle.World, name: str) -> None:
    levels, leaves, partial = set(), 0, 0
    for error_px, geometry in ((0.3, True), (3.7, False), (20.0, True)):
        right = check(tree, cells, CAMERAS[name], error_px, geometry)
        assert geometry or not right.leaves
        levels |= {level for level, _ in right.cells}
        leaves += len(right.leaves)
    assert len(levels) > 1
    assert leaves > 0 or name == "far away"
    for error_px, geometry in ((1.0, False), (3.7, True), (12.0, True)):
        right = check(tree, cells, CAMERAS[name], error_px, geometry, continuous=True)
        assert not any(level == 0 for level, _ in right.partial)
        partial += len(right.partial)
    assert partial > 0 or name.startswith(("a plan", "far away"))


@pytest.mark.parametrize("name", [name for name in CAMERAS if not name.startswith("a plan")])
@pytest.mark.parametrize("continuous", [False, True])
def test_cuts_are_coarser_away_from_the_gaze(
    tree: nf.orthoview.OrthoTree, cells: oracle.World, name: str, continuous: bool
) -> None:
    # Pixels of a degree or more are coarser than visual acuity almost everywhere.
    finer_by, fewer = 12, 0
    width, height = CAMERAS[name].size
    camera = replace(CAMERAS[name], size=(finer_by * width, finer_by * height))
    for gaze, error_px in itertools.product([(100.0, 290.0), (181.0, 480.0)], (6.0, 24.0)):
        right = check(tree, cells, camera, error_px, False, continuous, gaze)
        evenly = tree.cut(camera, error_px=error_px, geometry=False, continuous=continuous, around=True)
        if not continuous:
            fewer += len(evenly) - len(right.cells)
            # Each of its cells is, or contains, a cell of the cut with uniform resolution.
            finer = set(zip(evenly.level.tolist(), rows(evenly.place), strict=True))
            for level, (x, y, z) in finer:
                ups = range(tree.levels - level)
                assert any((level + up, (x >> up, y >> up, z >> up)) in right.cells for up in ups)
    assert fewer > 0 or continuous or name in ("far away", "outside, narrow")


coordinate = st.floats(-150, 150)
fov = st.sampled_from([WIDE, NARROW, ASKEW, PLAN, *map(nf.CubeFace, range(6))])
turn = st.lists(st.floats(-1, 1), min_size=4, max_size=4).filter(lambda parts: np.linalg.norm(parts) > 0.1)


@given(st.tuples(coordinate, coordinate, coordinate), turn, fov, st.floats(0.2, 30), st.booleans(), st.booleans())
def test_cuts_of_random_viewers_equal_the_oracle(
    tree: nf.orthoview.OrthoTree,
    cells: oracle.World,
    place: tuple[float, float, float],
    turn: list[float],
    fov: Any,
    error_px: float,
    geometry: bool,
    continuous: bool,
) -> None:
    eye = (MIDDLE + place).tolist()
    camera = nf.Camera(eye, np.array(turn) / np.linalg.norm(turn), fov=fov, size=(48, 48))
    try:
        check(tree, cells, camera, error_px, geometry, continuous)
    except oracle.DoubtfulError:
        reject()


SLANTED = looking((-31.7, 15.3, 22.3), (0, 5, 3), PLAN)


@pytest.mark.parametrize("camera", [CAMERAS["inside"], CAMERAS["outside"], CAMERAS["face 3"], SLANTED])
def test_directions_of_a_cut_have_views_in_the_tree(
    tree: nf.orthoview.OrthoTree, cells: oracle.World, camera: nf.Camera
) -> None:
    """Directions nearest to the viewer's, or to it raised by an angle; the rest of the cut does not change."""
    missing, doubtful, chosen = 0, 0, []
    paper = tree.cut(camera, views=4, error_px=2.0, geometry=False, around=True)
    for lift_deg in (0.0, 7.5, 30.0, 90.0):
        cut = tree.cut(camera, views=4, error_px=2.0, geometry=False, around=True, lift_deg=lift_deg)
        for level, place, numbers in zip(cut.level.tolist(), rows(cut.place), cut.directions.tolist(), strict=True):
            toward = np.array(camera.position) - cells.grid.box(level, place).mean(axis=0)
            if isinstance(camera.fov, nf.Orthographic):
                toward = -oracle.camera_axis(camera)
            try:
                right = oracle.nearest_directions(toward, tree.directions, 4, cells.shown[level, place], lift_deg)
            except oracle.DoubtfulError:
                doubtful += 1
                continue
            assert numbers == right
            missing += numbers.count(-1)
        for field in ("level", "place", "distance", "in_picture", "partial"):
            np.testing.assert_array_equal(getattr(cut, field), getattr(paper, field))
        chosen.append(cut.directions.tobytes())
    assert chosen[0] == paper.directions.tobytes()
    assert len(set(chosen)) > 1
    assert missing > 0 or camera == CAMERAS["outside"]
    assert doubtful == 0


@pytest.mark.parametrize(("count", "widest"), [(5, 1.0), (9, math.sqrt(2)), (13, 4 / math.sqrt(6))])
def test_the_widest_view_decides_the_reach(count: int, widest: float, tmp_path: Path) -> None:
    """A cube of side 1 is √2 high seen from an edge, and 4/√6 from a corner."""
    scene = boxes(1, 8.0)[0]
    tree = nf.orthoview.build(scene, tmp_path / "tree.zarr", cell=20.0, size=SIZE, directions=count)
    # Pixels of 1/8 × 1/32 at 1 m have the area of a square of side 1/16.
    camera = nf.Camera((0, 0, 0), fov=nf.Fov(-1, 1, -1, 1), size=(16, 64))
    assert math.isclose(tree.cut(camera, error_px=2.0).reach, widest * 20.0 / SIZE * 16 / 2)


# lists, and bad calls -----------------------------------------------------------------------------------------------
def test_keys_list_the_views_of_the_cut(tree: nf.orthoview.OrthoTree) -> None:
    cut = tree.cut(CAMERAS["inside"], error_px=1.0, around=True)
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
    within = tree.cut(CAMERAS["inside"], error_px=1.0)
    assert within.keys() == within.keys(in_picture=True) == cut.keys(in_picture=True)
    assert within.leaf_places() == cut.leaf_places(in_picture=True)


def test_a_plan_has_no_gaze(tree: nf.orthoview.OrthoTree) -> None:
    with pytest.raises(ValueError, match="gaze: expected a camera with"):
        tree.cut(CAMERAS["a plan"], gaze=(1, 2))
