"""Stores of orthoviews, and sources that count queries, for tests that compare stores."""

from __future__ import annotations

import functools
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Collection, Iterable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from numpy.typing import ArrayLike, NDArray

import nearfar as nf
from nearfar import _core
from nearfar.orthoview import _store
from nearfar.orthoview._grid import Grid, Place, directions_of
from tests.support import need
from tests.support.orthoview_cases import CORNER, boxes
from tests.support.shared_folders import make_once

CELL, SIZE = 10.0, 16
FORMAT = (SIZE, 12, 16)


def few_boxes() -> nf.Scene:
    """Boxes in some of the leaves of four subtrees, and in one more above them."""
    return boxes(8, 80.0, 0.35)[0]


def places(counts: tuple[int, int, int]) -> list[tuple[int, int, int]]:
    x, y, z = counts
    return [(column, layer, row) for column in range(x) for layer in range(y) for row in range(z)]


@functools.cache
def of_cells(world: nf.Scene) -> dict[tuple[int, tuple[int, int, int]], _core.OrthoViews]:
    """Views of all non-empty cells, level by level, all of them in memory."""
    grid, directions = Grid.from_bounds(world.bounds, CELL), directions_of(5)
    cells: dict[tuple[int, tuple[int, int, int]], _core.OrthoViews] = {}
    for place in places(grid.counts):
        # The renderer depends on the number of triangles, and depths may differ at the border of two steps.
        part = world.query(grid.box(0, place))._core
        views = _core.OrthoViews.of_cell(part, (grid.corner(0, place), CELL), directions, FORMAT)
        if not all(views.empty()):
            cells[0, place] = views
    for level in range(1, grid.levels):
        parents: dict[tuple[int, int, int], _core.OrthoParent] = {}
        # In the order of octants: x changes last.
        for (below, (x, y, z)), views in sorted(cells.items()):
            if below == level - 1:
                parent = parents.setdefault((x // 2, y // 2, z // 2), _core.OrthoParent(directions, FORMAT))
                parent.add((x % 2, y % 2, z % 2), views)
        cells |= {(level, place): parent.finish() for place, parent in parents.items()}
    return cells


def of_subtrees(tree: nf.orthoview.OrthoTree) -> Callable[[int, Place], _store.Cells]:
    """Reader of the cells that the records of a tree list for the subtree at a tier and a place."""
    return _store.open_generation(tree._files, tree._layout, tree.generation)[1]


def masks_of(tree: nf.orthoview.OrthoTree) -> dict[tuple[int, Place], int]:
    """For each cell the bits of the non-empty directions, from the records."""
    read, found = of_subtrees(tree), {}
    for tier in range(tree._layout.tiers):
        x, y, z = (-(-count // 8 ** (tier + 1)) for count in tree.cells(0))
        for i, j, k in places((x, y, z)):
            for level, mask in enumerate(read(tier, (i, j, k)).masks, 3 * tier):
                side = 8 >> level % 3
                assert mask.shape == (side, side, side)
                for x, y, z in np.argwhere(mask).tolist():
                    found[level, (i * side + x, j * side + y, k * side + z)] = int(mask[x, y, z])
    return found


def built_once(factory: pytest.TempPathFactory, name: str, scene: Any, **settings: Any) -> nf.orthoview.OrthoTree:
    """The tree of a scene or another source, built once in a run."""
    need("zarr")
    return nf.orthoview.open(make_once(factory, name, lambda path: nf.orthoview.build(scene, path, **settings)))


def layered_tree(factory: pytest.TempPathFactory) -> nf.orthoview.OrthoTree:
    """A tree of thirty boxes for pictures: large leaves in two layers, seen from nine directions."""
    return built_once(factory, "layered.zarr", world_of(range(30)), cell=20, size=32, directions=9, layers=2)


def contents(path: Path) -> dict[str, bytes]:
    """Files of a store by their paths below it, except those that only builds need."""
    files = (file for file in path.rglob("*") if file.is_file() and "nearfar" not in file.relative_to(path).parts)
    return {str(file.relative_to(path)): file.read_bytes() for file in files if file.name != "zarr.json"}


class Counted:
    """A source that counts its queries, and fails as configured."""

    def __init__(self, scene: nf.Scene, fails: Collection[int] = ()) -> None:
        self._scene, self._fails, self.queries = scene, fails, 0

    @property
    def bounds(self) -> NDArray[np.float64]:
        return self._scene.bounds

    def query(self, aabb: ArrayLike, detail: Any = 0.0) -> nf.Scene:
        self.queries += 1
        if self.queries in self._fails:
            raise OSError("the disk is gone")
        return self._scene.query(aabb, detail)


class Interrupted(Counted):
    """A source that is interrupted as by Ctrl-C, in a query by its number."""

    def __init__(self, scene: nf.Scene, at: int) -> None:
        super().__init__(scene)
        self._at = at

    def query(self, aabb: ArrayLike, detail: Any = 0.0) -> nf.Scene:
        if self.queries + 1 == self._at:
            raise KeyboardInterrupt
        return super().query(aabb, detail)


class Late(Counted):
    """A source that is interrupted by its first query after a store was begun."""

    def __init__(self, scene: nf.Scene, path: Path) -> None:
        super().__init__(scene)
        self._path = path

    def query(self, aabb: ArrayLike, detail: Any = 0.0) -> nf.Scene:
        if (self._path / "zarr.json").exists():
            raise KeyboardInterrupt
        return super().query(aabb, detail)


class Partial(Counted):
    """A source that is empty in some leaves, or everywhere else."""

    def __init__(self, scene: nf.Scene, boxes: Iterable[NDArray[np.float64]], *, is_empty_there: bool) -> None:
        super().__init__(scene)
        self._boxes, self._is_empty_there = {box.tobytes() for box in boxes}, is_empty_there

    def query(self, aabb: ArrayLike, detail: Any = 0.0) -> nf.Scene:
        if (np.asarray(aabb).tobytes() in self._boxes) == self._is_empty_there:
            return self._scene.query([[1e6] * 3, [1e6 + 1] * 3])
        return super().query(aabb, detail)


class Telling(Counted):
    """A source that also reports where it is empty."""

    def touches(self, aabb: ArrayLike) -> bool:
        return self._scene.touches(aabb)


def ended(program: str, changes: Mapping[str, str]) -> None:
    """Run a program once for each change in a process that kills itself as by `kill -9`.

    Parameters
    ----------
    program
        Code to run. `source` is a source of few boxes that counts, `name` the name of the change.
    changes
        Code that runs before the program and calls `die`, by name.
    """
    need("linux")
    code = f"""
import os, signal, sys
import nearfar as nf
from nearfar.orthoview import _layout, _shard, _store, _subtree
from tests.support.orthoview_stores import Counted, few_boxes
def die():
    os.kill(os.getpid(), signal.SIGKILL)
for name, change in {dict(changes)!r}.items():
    if not (child := os.fork()):
        source = Counted(few_boxes())
        query = source.query
        exec(change + {program!r})
        os._exit(1)
    if os.waitpid(child, 0)[1] != signal.SIGKILL:
        sys.exit(f"{{name}}: it was not killed")
"""
    root = Path(__file__).resolve().parents[2]
    process = subprocess.run([sys.executable, "-c", code], cwd=root, capture_output=True, text=True, check=False)
    assert process.returncode == 0, process.stderr[-2000:]


def box(number: int) -> trimesh.Trimesh:
    """A rotated box with its own colour, in a world of 80 m."""
    rng = np.random.default_rng(number)
    mesh = trimesh.creation.box(rng.uniform(4, 18, 3))
    turn = trimesh.transformations.random_rotation_matrix(rng.random(3))
    turn[:3, 3] = CORNER + rng.uniform(16, 64, 3)
    mesh.apply_transform(turn)
    mesh.visual = trimesh.visual.ColorVisuals(mesh, face_colors=rng.integers(0, 256, 3))
    return mesh


def world_of(numbers: Iterable[int]) -> nf.Scene:
    """Boxes between two small ones, so that all such worlds have the same bounds."""
    ends = [trimesh.creation.box((1, 1, 1)).apply_translation(CORNER + shift) for shift in (0.5, 79.5)]
    return nf.Scene.from_trimesh(trimesh.util.concatenate([*ends, *map(box, numbers)]))


def box_about(numbers: Iterable[int]) -> NDArray[np.float64]:
    """World box of some boxes."""
    bounds = [box(number).bounds for number in numbers]
    return np.array([np.min(bounds, axis=0)[0], np.max(bounds, axis=0)[1]])


class Deadly(Counted):
    """A source that kills its process, once in all processes, in a query for a cell."""

    def __init__(self, scene: nf.Scene, place: ArrayLike, sign: Path) -> None:
        super().__init__(scene)
        self._place, self._sign = np.asarray(place), sign

    def query(self, aabb: ArrayLike, detail: Any = 0.0) -> nf.Scene:
        low, high = np.asarray(aabb)
        if (low <= self._place).all() and (self._place < high).all() and not self._sign.exists():
            self._sign.touch()
            os.kill(os.getpid(), signal.SIGKILL)
        return super().query(aabb, detail)


class Waiting(Counted):
    """A source that creates a file when queried, and waits for another one."""

    def __init__(self, scene: nf.Scene, folder: Path) -> None:
        super().__init__(scene)
        self._folder = folder

    def query(self, aabb: ArrayLike, detail: Any = 0.0) -> nf.Scene:
        (self._folder / "asked").touch()
        while not (self._folder / "go").exists():
            time.sleep(0.01)
        return super().query(aabb, detail)
