"""Updates a tree: renders the cells that a change of the world touches again, into a new generation of the store.

A generation is a folder of shards with the changed cells only. Readers take each chunk from the newest generation that
has it. Files of older generations never change, so trees that are open stay valid.
"""

from __future__ import annotations

import shutil
from collections import Counter
from collections.abc import Set as AbstractSet
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nearfar._base import formats, locks, progress
from nearfar._scene.scene import Scene
from nearfar._source.protocol import SceneSource, bounds_of, may_touch
from nearfar.orthoview import _codec, _store
from nearfar.orthoview._chunks import Chunks
from nearfar.orthoview._files import Local
from nearfar.orthoview._geometry_store import names
from nearfar.orthoview._grid import Place
from nearfar.orthoview._layout import FOLDER, Layout
from nearfar.orthoview._leaves import Leaves
from nearfar.orthoview._presence import UNCHANGED
from nearfar.orthoview._subtree import Outcome
from nearfar.orthoview._unfinished import open_store, unbuilt_leaves


def update(path: Path, aabb: NDArray[np.float64], source: SceneSource) -> None:
    """Write a new generation in which a box of the world comes from a changed source; see `OrthoTree.update`."""
    with locks.hold(path / FOLDER / "lock", f"another build writes into {path}"):
        store, attributes, layout = open_store(Local(path))
        _store.check_complete(attributes, path, unbuilt_leaves(store))
        _check_reach(layout, aabb, source)
        newest = int(attributes["generation"])
        folder = path / _store.overlay_folder(newest + 1)
        shutil.rmtree(folder, ignore_errors=True)  # left by an interrupted update
        chunks, _ = _store.open_generation(store, layout, newest)
        changed = ChangedLeaves(source, folder, layout, chunks, aabb)
        with progress.bar("orthoviews") as report:
            outcome = changed.run(report)
        held = Counter(attributes["held"])
        held.subtract(changed.replaced)
        written = _store.held_below(folder)
        held.update(written)
        _store.finish_generation(path, newest + 1, aabb, written)
        shutil.rmtree(folder / FOLDER)
        _store.change(path, generation=newest + 1, held=dict(held), done=dict(outcome.counts))


def _check_reach(layout: Layout, aabb: NDArray[np.float64], source: SceneSource) -> None:
    """Raise a ValueError if, within the box, the source has something outside the tree."""
    grid = layout.grid
    (low, high), bounds = grid.bounds, bounds_of(source)
    part = np.array([np.maximum(aabb[0], bounds[0]), np.minimum(aabb[1], bounds[1])])
    margin = 1e-9 * grid.cell
    for axis in range(3):
        lower, upper = part.copy(), part.copy()
        lower[1, axis], upper[0, axis] = low[axis] - margin, high[axis] + margin
        for slab in (lower, upper):
            if (slab[0] <= slab[1]).all() and may_touch(source, slab):
                raise ValueError(
                    f"aabb: expected a change within the tree's box {[low.tolist(), high.tolist()]}, "
                    f"but the source has something in {slab.tolist()}"
                )


class ChangedLeaves(Leaves):
    """Renders the leaves that a change touches, and reads all other cells from the store."""

    unchanged = UNCHANGED

    def __init__(
        self, source: SceneSource, folder: Path, layout: Layout, chunks: Chunks, aabb: NDArray[np.float64]
    ) -> None:
        super().__init__(source, folder, layout)
        self._chunks, self._aabb = chunks, aabb
        self.replaced: Counter[str] = Counter()
        """Cells, leaves, chunks and bytes of older generations that this one replaces."""

    def write_geometry(self, part: Scene, place: Place) -> None:
        """Write the geometry of a leaf; an empty file removes the file of an older generation."""
        super().write_geometry(part, place)
        if self.geometry is None:
            return
        for name in names(self.layout.grid, place):
            path = self.folder / name
            if not path.exists() and self._chunks.has_geometry(name):
                path.parent.mkdir(parents=True, exist_ok=True)
                path.touch()

    def failure(self, _place: Place, error: Exception, *, is_partial: bool = False) -> Outcome:
        """Abort the update: the store stays as it was."""
        raise error

    def finished_outcome(self, level: int, place: Place) -> Outcome | None:
        """Read the views of a cell that the change does not touch; None for a cell that must be rendered again."""
        with formats.guarded(self.folder, "orthoviews"):
            if not self.layout.grid.touches(level, place, self._aabb):
                chunks = self._chunks.read_views(level, place)
                return Outcome(_codec.decode_cell(chunks, self.layout), counts=Counter(reloaded=len(chunks)))
            had_views = any(self._chunks.lengths([*self.layout.keys(level, place).values()]))
        if had_views or self._had_geometry(level, place):
            return None
        return super().finished_outcome(level, place)

    def _had_geometry(self, level: int, place: Place) -> bool:
        """Whether the store may have geometry of a cell's leaves; its triangles may be too small for any view."""
        if not self.layout.geometry or level >= self.layout.subtree:
            return self.layout.geometry
        leaves = self.layout.grid.descendants(level, place, 0)
        return any(self._chunks.has_geometry(name) for leaf in leaves for name in names(self.layout.grid, leaf))

    def chunks_before(self, level: int, place: Place) -> AbstractSet[int]:
        """Return the direction numbers of a cell's chunks in the store, and count the chunks as replaced."""
        keys = self.layout.keys(level, place)
        lengths = dict(zip(keys, self._chunks.lengths(list(keys.values())), strict=True))
        existing = {number for number, length in lengths.items() if length}
        cells, size = int(bool(existing)), sum(lengths.values())
        self.replaced.update(cells=cells, leaves=cells if level == 0 else 0, chunks=len(existing), bytes=size)
        return existing
