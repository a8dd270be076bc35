"""One piece of a build: the cells of a subtree, depth first, each written once to the subtree's shards."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

from nearfar import _core
from nearfar._base import formats
from nearfar.orthoview import _codec
from nearfar.orthoview._grid import Place
from nearfar.orthoview._journal import Journal
from nearfar.orthoview._layout import CHANNELS, Layout
from nearfar.orthoview._shard import ShardWriter, read_chunk

Views = _core.OrthoViews | None
"""Views of a cell; None for one in which nothing is."""

FOLDER = "nearfar"
"""Folder of the store for what Zarr does not know."""

RECORD, VERSION = "orthoview_subtree", 1


@dataclass
class Outcome:
    """What became of a cell or a subtree."""

    views: Views = None
    is_complete: bool = True
    """False if a cell below could not be drawn."""
    failed: dict[str, str] = field(default_factory=dict)
    """Why cells could not be drawn, by their names."""
    counts: Counter[str] = field(default_factory=Counter)
    """Cells drawn, empty, composed; chunks and bytes written; chunks reloaded."""


class Subtree:
    """Builds the cells below one cell of level `top`, which is not written but returned to its parent's subtree.

    Parameters
    ----------
    layout
        Of the tree.
    store
        Its folder.
    tier
        Number of subtrees below.
    place
        Place of the cell on top, on level (tier + 1) × `Layout.subtree`.
    base
        Returns the outcome of a cell of this subtree's lowest level: a leaf that is drawn, or a subtree below.
    """

    def __init__(self, layout: Layout, store: Path, tier: int, place: Place, base: Callable[[Place], Outcome]) -> None:
        self._layout, self._store, self._tier, self._place, self._base = layout, store, tier, place, base
        self._lowest = tier * layout.subtree
        name = f"{tier}_{'_'.join(map(str, place))}"
        self._record = store / FOLDER / "done" / f"{name}.json"
        self._journal = Journal(store / FOLDER / "journal" / f"{name}.jsonl")
        self._writers: dict[str, ShardWriter] = {}
        self._outcome = Outcome()

    def run(self) -> Outcome:
        """Build what is not there yet; the outcome has the views of the cell on top."""
        top, root = self._lowest + self._layout.subtree, self._layout.grid.levels - 1
        if self._record.exists():
            return self._reloaded(top)
        try:
            if top > root:
                _, self._outcome.is_complete = self._views(root, (0, 0, 0))
            else:
                self._outcome.views, self._outcome.is_complete = self._composed(top, self._place)
            if self._outcome.is_complete:
                self._finish()
        finally:
            for writer in self._writers.values():
                writer.close()
            self._journal.close()
        return self._outcome

    def _views(self, level: int, place: Place) -> tuple[Views, bool]:
        """The views of a cell of this subtree, and whether all below it is there."""
        if (level, place) in self._journal.cells:
            return self._reread(level, place), True
        if level == self._lowest:
            below = self._base(place)
            self._outcome.failed |= below.failed
            self._outcome.counts += below.counts
            views, is_complete = below.views, below.is_complete
        else:
            views, is_complete = self._composed(level, place)
        if is_complete:
            self._write(level, place, views)
        return views, is_complete

    def _composed(self, level: int, place: Place) -> tuple[Views, bool]:
        """The views of a cell from those of its children, which are built."""
        parent, is_complete = None, True
        for octant, child in self._layout.grid.children(level, place):
            views, is_whole = self._views(level - 1, child)
            is_complete &= is_whole
            if views is not None and is_complete:
                parent = parent or _core.OrthoParent(self._layout.directions, self._layout.format)
                parent.add(octant, views)
        if parent is None or not is_complete:
            return None, is_complete
        self._outcome.counts["composed"] += 1
        return parent.finish(), True

    def _write(self, level: int, place: Place, views: Views) -> None:
        shard, within = self._layout.shard_of(level, place)
        chunks = {}
        for (direction, channel), chunk in (_codec.encoded(views, self._layout) if views else {}).items():
            array = self._layout.array(level, direction, channel)
            chunks[array] = self._writer(array, level, shard).append(within, chunk)
            self._outcome.counts["chunks"] += 1
            self._outcome.counts["bytes"] += len(chunk)
        self._journal.add(level, place, chunks)

    def _writer(self, array: str, level: int, shard: Place) -> ShardWriter:
        if array not in self._writers:
            done = [(self._layout.shard_of(level, place)[1], chunk) for place, chunk in self._journal.of_array(array)]
            path = self._store / self._layout.shard_path(array, shard)
            self._writers[array] = ShardWriter(path, self._layout.shard_side(level), done)
        return self._writers[array]

    def _reread(self, level: int, place: Place) -> Views:
        """Read the views of a cell that an interrupted build wrote."""
        chunks: _codec.Chunks = {}
        shard, within = self._layout.shard_of(level, place)
        for direction in range(len(self._layout.directions)):
            for channel in CHANNELS:
                array = self._layout.array(level, direction, channel)
                if array in self._journal.cells[level, place]:
                    chunk = self._writer(array, level, shard).read(within)
                    if chunk is not None:
                        chunks[direction, channel] = chunk
        self._outcome.counts["reloaded"] += len(chunks)
        return _codec.decoded(chunks, self._layout) if chunks else None

    def _finish(self) -> None:
        """Give all shards their names, and note that the subtree is complete."""
        shards = {}
        for level, place in self._journal.cells:
            for array in self._journal.cells[level, place]:
                shard, _ = self._layout.shard_of(level, place)
                path = self._layout.shard_path(array, shard)
                if path.as_posix() not in shards:
                    shards[path.as_posix()] = self._writer(array, level, shard).finish()
        self._writers.clear()
        self._record.parent.mkdir(parents=True, exist_ok=True)
        formats.write_json(
            self._record, formats.header(RECORD, VERSION) | {"shards": shards, "counts": dict(self._outcome.counts)}
        )
        self._journal.remove()

    def _reloaded(self, top: int) -> Outcome:
        """The outcome of a subtree that is complete: its views are composed again of those of its highest level."""
        outcome = Outcome()
        if top >= self._layout.grid.levels:
            return outcome
        parent = _core.OrthoParent(self._layout.directions, self._layout.format)
        is_empty = True
        for octant, child in self._layout.grid.children(top, self._place):
            chunks = self._stored(top - 1, child)
            outcome.counts["reloaded"] += len(chunks)
            if chunks:
                parent.add(octant, _codec.decoded(chunks, self._layout))
                is_empty = False
        outcome.views = None if is_empty else parent.finish()
        return outcome

    def _stored(self, level: int, place: Place) -> _codec.Chunks:
        """Chunks of a cell in complete shards."""
        chunks: _codec.Chunks = {}
        shard, within = self._layout.shard_of(level, place)
        for direction in range(len(self._layout.directions)):
            for channel in CHANNELS:
                path = self._store / self._layout.shard_path(self._layout.array(level, direction, channel), shard)
                chunk = read_chunk(path, self._layout.shard_side(level), within) if path.exists() else None
                if chunk is not None:
                    chunks[direction, channel] = chunk
        return chunks
