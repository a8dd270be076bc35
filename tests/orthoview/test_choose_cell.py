"""Tests of the choice of the leaves' side, and of the number of leaves that a build expects."""

from __future__ import annotations

import functools
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.orthoview import _choose_cell, _sampling
from nearfar.orthoview._grid import Grid
from tests.support import need
from tests.support.orthoview_stores import Counted, Late, Telling, places

SIDE, PITCH = 640.0, 2.0
PER_SQUARE_METRE = 2 / PITCH**2
"""Triangles of the plain."""


@functools.cache
def plain(side: float = SIDE) -> nf.Scene:
    """A square of equal triangles, so that leaves' triangles are proportional to their area."""
    count = int(side / PITCH)
    x, z = np.meshgrid(PITCH * np.arange(count + 1), PITCH * np.arange(count + 1), indexing="ij")
    corners = np.stack([x, np.zeros_like(x), z], axis=-1).reshape(-1, 3).astype(np.float32)
    first = (np.arange(count)[:, None] * (count + 1) + np.arange(count)).reshape(-1, 1)
    offsets = np.array([[0, 1, count + 1], [1, count + 2, count + 1]])
    faces = (first[:, None] + offsets).reshape(-1, 3)
    return nf.Scene.from_arrays(corners, faces.astype(np.uint32))


@pytest.mark.parametrize("kind", [None, Telling, Counted])
def test_the_side_is_the_greatest_with_few_enough_triangles_near_a_viewer(
    kind: type[Counted] | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A circle of radius r/s sides touches 1 + 4 r/s + π (r/s)² leaves of a plane on average."""
    world: Any = plain() if kind is None else kind(plain())
    for size, directions, width in ((512, 5, 1.0), (128, 9, np.sqrt(2)), (64, 26, np.sqrt(8 / 3))):
        reach = width / size * 1920 / 2
        limit = 1e6 / (1 + 4 * reach + np.pi * reach**2)
        # Queries return triangles that touch, so sampled leaves have some more than their area's share.
        sides = [
            side
            for side in (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000)
            if (side + PITCH) ** 2 * PER_SQUARE_METRE <= limit
        ]
        choice = nf.orthoview.choose_cell(world, size=size, directions=directions)
        expected = min(sides[-1], 1000)
        leaves = (SIDE / expected) ** 2
        if leaves <= 2000:
            assert (choice.cell, choice.finer) == (expected, None)
            assert choice.triangles <= limit
            assert f"leaves of {expected} m" in str(choice)
        else:
            assert choice.finer == expected < choice.cell
            assert choice.leaves <= 2000
            assert f"leaves of {expected} m would suit" in str(choice)
    assert choice == nf.orthoview.choose_cell(world, size=size, directions=directions)
    monkeypatch.setattr(_choose_cell, "MAX_LEAVES", 10)
    few = nf.orthoview.choose_cell(world, size=64)
    assert few.leaves <= 10
    assert few.cell > (few.finer or np.inf)


def test_worlds_without_many_triangles_get_one_leaf(tmp_path: Path) -> None:
    need("zarr")
    triangle = nf.Scene.from_arrays(
        np.array([[0, 0, 0], [7, 1, 0], [0, 2, 9]], np.float32), np.array([[0, 1, 2]], np.uint32)
    )
    assert nf.orthoview.choose_cell(triangle) == nf.orthoview.CellChoice(10.0, 1.0, 1)
    assert nf.orthoview.build(triangle, tmp_path / "one.zarr", size=16, directions=5).cells(0) == (1, 1, 1)
    empty = triangle.query([[90] * 3, [91] * 3])
    with pytest.raises(ValueError, match="source: expected finite bounds"):
        nf.orthoview.choose_cell(empty)
    assert nf.orthoview.choose_cell(triangle, aabb=[[1, 0, 5], [2, 1, 6]]).cell == 1.0


def test_a_resumed_build_keeps_the_chosen_side(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    need("zarr")
    path = tmp_path / "world.zarr"
    settings: dict[str, Any] = {"size": 16, "directions": 5, "geometry": False}
    scene = plain(60)
    with pytest.raises(KeyboardInterrupt):
        nf.orthoview.build(Late(scene, path), path, **settings)
    side = nf.orthoview.open(path).cell
    assert side == nf.orthoview.choose_cell(Counted(scene), size=16, directions=5).cell
    with monkeypatch.context() as patched:
        patched.setattr(_choose_cell, "NEAR_TRIANGLES", 10)
        assert nf.orthoview.choose_cell(scene, size=16, directions=5).cell < side
        resumed = nf.orthoview.build(scene, path, **settings)
    assert (resumed.cell, resumed.is_complete) == (side, True)


@pytest.mark.parametrize("cell", [5.0, 20.0, 90.0])
def test_leaves_are_counted_by_sampled_levels(few: nf.Scene, cell: float) -> None:
    """Exact where all cells are visited; else within a third for a world that is alike everywhere."""
    grid = Grid.from_bounds(few.bounds, cell)
    touched = sum(few.touches(grid.box(0, place)) for place in places(grid.counts))
    expected = _sampling.expected_leaves(few, grid)
    if touched <= _sampling.CELLS_PER_LEVEL:
        assert expected == touched
    assert _sampling.expected_leaves(Counted(few), grid) == np.prod(grid.counts)
    field = plain()
    grid = Grid.from_bounds(field.bounds, cell)
    assert 2 / 3 < _sampling.expected_leaves(field, grid) / np.prod(grid.counts) < 3 / 2
