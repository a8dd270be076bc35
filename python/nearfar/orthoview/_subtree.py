"""One piece of a build: the cells of a subtree, depth first, each written once to the subtree's shards."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Protocol

from nearfar import _core
from nearfar._base import formats
from nearfar._base.errors import UnusableError
from nearfar.orthoview import _codec
from nearfar.orthoview._grid import Place
from nearfar.orthoview._journal import Journal
from nearfar.orthoview._layout import CHANNELS, Layout
from nearfar.orthoview._shard import ShardWriter, holds, read_chunk

Views = _core.OrthoViews | None
"""Views of a cell; None for one in which nothing is."""

FOLDER = "nearfar"
"""Folder of the store for what Zarr does not know."""

DONE = "done"
"""Folder in it with a record of each complete subtree."""

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
    """What was done: leaves drawn and found empty, cells composed, chunks reloaded."""


class Below(Protocol):
    """What a subtree knows of the world and of the subtrees below it."""

    def base(self, tier: int, place: Place) -> Outcome:
        """Return the outcome of a cell of a tier's lowest level: a leaf that is drawn, or a subtree below."""

    def may_hold(self, level: int, place: Place) -> bool:
        """Whether anything may be in a cell."""

    def pass_over(self, level: int, place: Place) -> None:
        """Take note that nothing is to be done in a cell."""


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
    below
        Gives the cells of this subtree's lowest level.
    """

    def __init__(self, layout: Layout, store: Path, tier: int, place: Place, below: Below) -> None:
        self._layout, self._store, self._tier, self._place, self._below = layout, store, tier, place, below
        self._lowest, self._top = tier * layout.subtree, (tier + 1) * layout.subtree
        name = f"{tier}_{'_'.join(map(str, place))}"
        self._record = store / FOLDER / DONE / f"{name}.json"
        self._journal = Journal(store / FOLDER / "journal" / f"{name}.jsonl")
        self._writers: dict[str, ShardWriter] = {}
        self._outcome = Outcome()

    def run(self) -> Outcome:
        """Build what is not there yet; the outcome has the views of the cell on top."""
        if self._record.exists():
            self._journal.remove()  # the build may have ended before it did
            self._below.pass_over(min(self._top, self._root), self._place)
            return self._reloaded()
        if not self._is_sound():
            self._journal.remove()  # what the system had promised to write is gone, so all is drawn again
        if self._top > self._root:
            _, self._outcome.is_complete = self._views(self._root, (0, 0, 0))
        else:
            self._outcome.views, self._outcome.is_complete = self._composed(self._top, self._place)
        shards = self._named()
        if self._outcome.is_complete:
            self._note(shards)
        return self._outcome

    @property
    def _root(self) -> int:
        return self._layout.grid.levels - 1

    def _is_sound(self) -> bool:
        """Whether the shards have all bytes that the journal tells of."""
        return all(
            holds(self._store / self._layout.shard_path(array, self._layout.shard_of(level, place)[0]), size)
            for (level, place, array), size in self._journal.sizes().items()
        )

    def _views(self, level: int, place: Place) -> tuple[Views, bool]:
        """The views of a cell of this subtree, and whether all below it is there."""
        if (level, place) in self._journal.cells:
            self._below.pass_over(level, place)
            return self._reread(level, place), True
        if not self._below.may_hold(level, place):
            self._below.pass_over(level, place)
            return None, True
        if level == self._lowest:
            below = self._below.base(self._tier, place)
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
        with formats.guarded(self._store, "orthoviews"):
            for direction in range(len(self._layout.directions)):
                for channel in CHANNELS:
                    array = self._layout.array(level, direction, channel)
                    if array in self._journal.cells[level, place]:
                        chunk = self._writer(array, level, shard).read(within)
                        if chunk is not None:
                            chunks[direction, channel] = chunk
            self._outcome.counts["reloaded"] += len(chunks)
            return _codec.decoded(chunks, self._layout) if chunks else None

    def _named(self) -> dict[str, tuple[int, str]]:
        """Give all shards their index and their names; their sizes and SHA-256 by their paths.

        Those of a subtree that is not complete become `PART` again when it goes on; until then readers find its cells.
        """
        shards = {}
        for level, place, array in self._journal.sizes():
            shard, _ = self._layout.shard_of(level, place)
            path = self._layout.shard_path(array, shard).as_posix()
            shards[path] = self._writer(array, level, shard).finish()
        self._writers.clear()
        return shards

    def _note(self, shards: dict[str, tuple[int, str]]) -> None:
        """Write the record of a complete subtree."""
        chunks = [length for cell in self._journal.cells.values() for _, length in cell.values()]
        held = {
            "cells": sum(bool(cell) for cell in self._journal.cells.values()),
            "leaves": sum(level == 0 and bool(cell) for (level, _), cell in self._journal.cells.items()),
            "chunks": len(chunks),
            "bytes": sum(chunks),
        }
        self._record.parent.mkdir(parents=True, exist_ok=True)
        formats.write_json(self._record, formats.header(RECORD, VERSION) | {"shards": shards, "held": held})
        self._journal.remove()

    def _reloaded(self) -> Outcome:
        """The outcome of a subtree that is complete: its views are composed again of those of its highest level."""
        outcome = Outcome()
        if self._top > self._root:
            return outcome
        shards = formats.read_json(self._record, RECORD, VERSION)["shards"]
        parent = None
        for octant, child in self._layout.grid.children(self._top, self._place):
            with formats.guarded(self._store, "orthoviews"):
                chunks = self._stored(self._top - 1, child, shards)
                outcome.counts["reloaded"] += len(chunks)
                if chunks:
                    parent = parent or _core.OrthoParent(self._layout.directions, self._layout.format)
                    parent.add(octant, _codec.decoded(chunks, self._layout))
        outcome.views = parent.finish() if parent else None
        return outcome

    def _stored(self, level: int, place: Place, shards: dict[str, Any]) -> _codec.Chunks:
        """Chunks of a cell in complete shards; UnusableError if one of the record's shards is gone or damaged."""
        chunks: _codec.Chunks = {}
        shard, within = self._layout.shard_of(level, place)
        for direction in range(len(self._layout.directions)):
            for channel in CHANNELS:
                relative = self._layout.shard_path(self._layout.array(level, direction, channel), shard)
                if relative.as_posix() not in shards:
                    continue
                if not (self._store / relative).exists():
                    raise UnusableError(f"{self._store / relative}: the shard is gone")
                chunk = read_chunk(self._store / relative, self._layout.shard_side(level), within)
                if chunk is not None:
                    chunks[direction, channel] = chunk
        return chunks
