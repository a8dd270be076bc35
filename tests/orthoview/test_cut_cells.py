"""Tests of cuts through given cells: directions of their views, and growth with the world."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import numpy as np
import pytest
from hypothesis import assume, given, reject, strategies as st

import nearfar as nf
from nearfar import _core
from nearfar.orthoview._grid import Direction, directions_of
from tests.support import cut_oracle as oracle

NARROW = nf.Fov.symmetric(25)

coordinate = st.floats(-150, 150)


# directions ---------------------------------------------------------------------------------------------------------
def one_cell(mask: int) -> _core.OrthoCells:
    """A tree of one leaf, 2 m wide about the origin."""
    cells = _core.OrthoCells((-1.0, -1.0, -1.0), 2.0, 1, 1)
    cells.add(0, (0, 0, 0), [np.array([mask] + 7 * [0], np.uint32)])
    return cells


def directions_in(
    cells: _core.OrthoCells, camera: nf.Camera, directions: Sequence[Direction], views: int, lift_deg: float = 0.0
) -> list[int]:
    rule = _core.OrthoRule(camera._core, pitch=1.0, error=1.0)
    settings = {"directions": directions, "views": views, "geometry": False, "around": True, "lift_deg": lift_deg}
    arrays, _, unknown, _ = cells.cut(camera._core, rule, settings)
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
    st.sampled_from([0.0, 10.0, 30.0, 45.0, 90.0]) | st.floats(0, 90),
)
def test_directions_are_nearest_to_the_viewer_by_angle(
    eye: tuple[float, float, float], count: int, views: int, mask: int, is_parallel: bool, lift_deg: float
) -> None:
    """The viewer's direction is raised by an angle, from above the horizon and below."""
    directions = directions_of(count)
    mask &= 2**count - 1
    assume(mask)
    camera = nf.Camera(eye, fov=NARROW, size=(8, 8))
    toward = np.array(eye)
    if is_parallel:
        assume(abs(toward[0]) + abs(toward[2]) > 0.1)
        place = np.array([0.3, 0.2, 0.1])  # Parallel rays do not depend on it.
        camera = nf.Camera.look_at(place, place - toward, fov=nf.Orthographic(-1, 1, -1, 1), size=(8, 8))
    try:
        right = oracle.nearest_directions(toward, directions, views, mask, lift_deg)
    except oracle.DoubtfulError:
        reject()
    assert directions_in(one_cell(mask), camera, directions, views, lift_deg) == right


NAMES = {"+z": (0, 0, 1), "+x": (1, 0, 0), "-z": (0, 0, -1), "-x": (-1, 0, 0), "top": (0, 1, 0), "bottom": (0, -1, 0)}
NAMES |= {
    f"{side} {end}": (x, y, z) for end, y in (("up", 1), ("down", -1)) for side, (x, _, z) in [*NAMES.items()][:4]
}
"""The sides, the top and the bottom, and the edges between them."""


@pytest.mark.parametrize(
    ("eye", "lift_deg", "right"),
    [
        # At 0°, 30° and 50° above the horizon, slightly towards +x of +z: sides, edges at 45°, the top.
        ((1, 0, 9), 0, ["+z", "+z up", "+z down", "+x"]),
        ((1, 0, 9), 30, ["+z up", "+z", "top", "+x up"]),
        ((1, 5.2, 9), 30, ["+z up", "top", "+x up", "-x up"]),
        ((1, 10.7, 9), 30, ["top", "+z up", "+x up", "-x up"]),
        # At the zenith all edges are equally near: those towards the viewer come first, on any side.
        ((9, 20, 1), 30, ["top", "+x up", "+z up", "-z up"]),
        ((-1, 0, -9), 90, ["top", "-z up", "-x up", "+x up"]),
        # From 60° below to 30° below.
        ((1, -15.6, 9), 0, ["+z down", "bottom", "+x down", "-x down"]),
        ((1, -15.6, 9), 30, ["+z down", "+z", "bottom", "+x down"]),
        # Straight up and down have no azimuth for the rotation: ties are resolved by number.
        ((0, 5, 0), 0, ["top", "+z up", "+x up", "-z up", "-x up", "+z"]),
        ((0, 5, 0), 30, ["top", "+z up", "+x up", "-z up", "-x up", "+z"]),
        ((0, -5, 0), 0, ["bottom", "+z down", "+x down", "-z down", "-x down", "+z"]),
        ((0, -5, 0), 30, ["bottom", "+z down", "+x down", "-z down", "-x down", "+z"]),
        ((1e-12, -5, 0), 90, ["bottom", "+x down", "+z down", "-z down", "-x down", "+x"]),
        # For a viewer in the middle of a cell the direction is +y.
        ((0, 0, 0), 60, ["top", "+z up", "+x up", "-z up", "-x up", "+z"]),
    ],
)
def test_directions_are_raised_at_most_to_the_zenith(
    eye: tuple[float, float, float], lift_deg: float, right: list[str]
) -> None:
    directions = directions_of(26)
    of_edges = sum(1 << directions.index(way) for way in NAMES.values())
    found = directions_in(one_cell(of_edges), nf.Camera(eye, fov=NARROW, size=(8, 8)), directions, len(right), lift_deg)
    names = {way: name for name, way in NAMES.items()}
    assert [names[directions[number]] for number in found] == right


def test_empty_views_are_replaced_by_the_next_directions() -> None:
    directions = directions_of(5)  # +z, +x, −z, −x, +y
    camera = nf.Camera((5.0, 9.0, 2.0), fov=NARROW, size=(8, 8))  # nearest to +y, then +x, +z, −z, −x
    for mask, right in {
        0b11111: [4, 1, 0],
        0b01111: [1, 0, 2],
        0b11101: [4, 0, 2],
        0b00001: [0, -1, -1],
        0b01100: [2, 3, -1],
    }.items():
        assert directions_in(one_cell(mask), camera, directions, 3) == right


# growth -------------------------------------------------------------------------------------------------------------
def flat(leaves: int) -> _core.OrthoCells:
    """A world of 1 m leaves on one floor, all non-empty."""
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


def count_cells(leaves: int, pitch: float, height: float = 0.0) -> tuple[int, int]:
    """Numbers of cells and leaves of a cut for a viewer in the middle of a flat world."""
    camera = nf.Camera((leaves / 2, height, leaves / 2), fov=nf.Fov(-1, 1, -1, 1), size=(64, 64))
    rule = _core.OrthoRule(camera._core, pitch=pitch, error=1.0)
    settings = {"directions": directions_of(5), "views": 3, "geometry": True, "around": True}
    arrays, _, unknown, _ = flat(leaves).cut(camera._core, rule, settings)
    assert unknown == []
    return len(arrays["level"]), len(arrays["leaf_level"])


def test_a_cut_grows_by_a_constant_with_each_doubling_of_the_world() -> None:
    for leaves in (16, 32, 64, 128):
        # With a reach of a leaf's side, each of a level's four cells about the viewer is replaced by four children:
        # one touches the viewer, the others are one side away or √2 sides, which is just far enough.
        assert count_cells(leaves, 1 / 32) == (4 * 3 * (leaves.bit_length() - 2), 4)
    for pitch, height in ((0.1, 0.3), (0.2, 1.7)):
        numbers = [sum(count_cells(leaves, pitch, height)) for leaves in (16, 32, 64, 128)]
        added = np.diff(numbers)
        assert (added > 0).all()
        assert (np.diff(added) <= 0).all(), numbers
