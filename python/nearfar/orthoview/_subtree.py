"""Builds a subtree, the unit of work of a build: its cells depth first, each written once to the subtree's shards."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Set as AbstractSet
from dataclasses import dataclass, field
from pathlib import Path
from typing import Protocol

from nearfar import _core
from nearfar._base import formats
from nearfar._base.errors import FormatError
from nearfar.orthoview import _codec
from nearfar.orthoview._chunks import Chunks, Generation
from nearfar.orthoview._files import Local
from nearfar.orthoview._grid import Place, name_of
from nearfar.orthoview._layout import Chunk, Key, Layout
from nearfar.orthoview._presence import Presence
from nearfar.orthoview._record import (
    RECORD,
    VERSION,
    Shards,
    is_complete,
    journal_of,
    list_geometry,
    parse_shards,
    record_document,
    record_of,
    write_record,
)
from nearfar.orthoview._shard import Journal, ShardWriter, has_bytes

Views = _core.OrthoViews | None
"""Views of a cell; None for an empty cell."""


@dataclass
class Outcome:
    """Result of the work on a cell or a subtree."""

    views: Views = None
    is_complete: bool = True
    """False if a leaf below failed."""
    failed: dict[str, str] = field(default_factory=dict)
    """Errors of failed leaves by name; such a leaf is empty or lacks a part."""
    guests: list[Place] = field(default_factory=list)
    """Guests of a leaf."""
    counts: Counter[str] = field(default_factory=Counter)
    """Counts of work: leaves drawn and found empty, cells composed, chunks reloaded."""


class LowerCells(Protocol):
    """Source of the cells that a subtree does not compose: leaves, subtrees below, and cells that need no work."""

    unchanged: int
    """Mask of cells that are not computed: 0 for empty, or `UNCHANGED`."""

    def build_lowest(self, tier: int, place: Place) -> Outcome:
        """Build a cell of a tier's lowest level: render a leaf, or build the subtree below."""

    def finished_outcome(self, level: int, place: Place) -> Outcome | None:
        """Return the outcome of a cell that needs no work; None for a cell that must be built."""

    def chunks_before(self, level: int, place: Place) -> AbstractSet[int]:
        """Return the direction numbers of a cell's chunks in older generations of the store."""

    def pass_over(self, level: int, place: Place) -> None:
        """Count a cell as done, for the progress bar."""


class Subtree:
    """Builds the cells below one cell. The views of that cell itself are not written but returned to the subtree above.

    The cell has the place `place` on level (tier + 1) × `Layout.subtree`; there are `tier` subtrees below, down to the
    leaves. `lower_cells` provides the cells of this subtree's lowest level.
    """

    def __init__(self, layout: Layout, store: Path, tier: int, place: Place, lower_cells: LowerCells) -> None:
        self._layout, self._store, self._tier, self._place, self._lower_cells = layout, store, tier, place, lower_cells
        self._lowest, self._top, self._root = tier * layout.subtree, (tier + 1) * layout.subtree, layout.grid.levels - 1
        self._record = record_of(store, tier, place)
        self._journal = Journal(journal_of(store, tier, place))
        self._writers: dict[str, ShardWriter] = {}
        self._incomplete: dict[tuple[int, Place], tuple[_codec.Encoded, list[Place]]] = {}
        """Chunks and guests of cells above failed leaves. The journal omits them, so the next build repeats them."""
        self._outcome = Outcome()

    def run(self) -> Outcome:
        """Build what is missing; the outcome has the views of the top cell."""
        if is_complete(self._record):
            self._journal.remove()  # the process may have been killed before it removed the journal
            self._lower_cells.pass_over(min(self._top, self._root), self._place)
            return self._reload()
        if self._record.exists():
            self._discard_record()
        sizes = self._journal.sizes().items()
        if not all(has_bytes(self._store / self._layout.shard_path(key), size) for key, size in sizes):
            self._journal.remove()  # data lost after a system crash: start the subtree again
        if self._top > self._root:
            _, self._outcome.is_complete = self._views(self._root, (0, 0, 0))
        else:
            self._outcome.views, self._outcome.is_complete = self._build_parent(self._top, self._place)
        written = {cell: self._append(*cell, chunks) for cell, (chunks, _) in self._incomplete.items()}
        arrays = {array: (level, place) for (level, place), chunks in written.items() for array in chunks}
        shards = self._finish_shards(arrays)
        self._write_record(shards, written)
        return self._outcome

    def _discard_record(self) -> None:
        """Remove the record of an incomplete subtree, and the shards that have only chunks of incomplete cells."""
        journaled = {self._layout.shard_path(key) for key in self._journal.sizes()}
        for path in formats.read_json(self._record, RECORD, VERSION)["shards"]:
            if path not in journaled:
                (self._store / path).unlink(missing_ok=True)
        self._record.unlink()

    def _views(self, level: int, place: Place) -> tuple[Views, bool]:
        """Build a cell of this subtree, or read it; return its views, and whether everything below it is complete."""
        if (level, place) in self._journal.cells:
            self._lower_cells.pass_over(level, place)
            return self._reread(level, place), True
        if (finished := self._lower_cells.finished_outcome(level, place)) is not None:
            self._lower_cells.pass_over(level, place)
            self._outcome.counts += finished.counts
            return finished.views, True
        if level == self._lowest:
            outcome = self._lower_cells.build_lowest(self._tier, place)
            self._outcome.failed |= outcome.failed
            self._outcome.counts += outcome.counts
            views, is_complete, guests = outcome.views, outcome.is_complete, outcome.guests
        else:
            (views, is_complete), guests = self._build_parent(level, place), []
        return self._write(level, place, views, guests, is_complete=is_complete), is_complete

    def _build_parent(self, level: int, place: Place) -> tuple[Views, bool]:
        """Build the children of a cell, and compose its views."""
        views, is_complete = self._compose(level, place, self._views)
        if views is not None:
            self._outcome.counts["composed"] += 1
        return views, is_complete

    def _compose(
        self, level: int, place: Place, child_views: Callable[[int, Place], tuple[Views, bool]]
    ) -> tuple[Views, bool]:
        """Compose the views of a cell from its children's views; also return whether the children are complete."""
        parent, is_complete = None, True
        for octant, child in self._layout.grid.children(level, place):
            views, is_child_complete = child_views(level - 1, child)
            is_complete &= is_child_complete
            if views is not None:
                parent = parent or _core.OrthoParent(
                    self._layout.directions, self._layout.format, behind=self._layout.layers == 2
                )
                parent.add(octant, views)
        if parent is None:
            return None, is_complete
        return _codec.drop_unneeded_layers(parent.finish(), self._layout), is_complete

    def _write(self, level: int, place: Place, views: Views, guests: list[Place], *, is_complete: bool) -> Views:
        """Write the views of a cell and record its guests; return the views as readers decode them.

        A build that resumes composes parents from decoded views, so an uninterrupted build does the same. Views of an
        incomplete cell are written at the end of the shards, where a build that resumes drops them.
        """
        encoded = _codec.encode(views, self._layout)
        if is_complete:
            self._journal.add(level, place, self._append(level, place, encoded), guests)
        else:
            self._incomplete[level, place] = encoded, guests
            if level == 0:
                self._journal.add_failed(place, self._outcome.failed[name_of(place)])
        return views if self._layout.quality is None else _codec.decode_cell(encoded, self._layout)

    def _append(self, level: int, place: Place, encoded: _codec.Encoded) -> dict[str, Chunk]:
        """Append the chunks of a cell to their shards; return their byte ranges by array."""
        _, place_in_shard = self._layout.shard_of(level, place)
        keys = self._layout.keys(level, place)
        removed = dict.fromkeys(self._lower_cells.chunks_before(level, place) - encoded.keys(), b"")
        chunks = {keys[number]: chunk for number, chunk in (encoded | removed).items()}
        return {key[2]: self._writer(key).append(place_in_shard, chunk) for key, chunk in chunks.items()}

    def _writer(self, key: Key) -> ShardWriter:
        level, _, array = key
        if array not in self._writers:
            path, side = self._store / self._layout.shard_path(key), self._layout.shard_side(level)
            self._writers[array] = ShardWriter(path, side, self._journal.chunks_of(array, self._layout))
        return self._writers[array]

    def _reread(self, level: int, place: Place) -> Views:
        """Read the views of a cell that an interrupted build wrote."""
        (_, place_in_shard), written = self._layout.shard_of(level, place), self._journal.cells[level, place]
        keys = {number: key for number, key in self._layout.keys(level, place).items() if key[2] in written}
        with formats.guarded(self._store, "orthoviews"):
            return self._decode(
                {number: chunk for number in keys if (chunk := self._writer(keys[number]).read(place_in_shard))}
            )

    def _decode(self, chunks: _codec.Encoded) -> Views:
        """Decode a cell's views, and count their chunks as reloaded."""
        self._outcome.counts["reloaded"] += len(chunks)
        return _codec.decode_cell(chunks, self._layout)

    def _finish_shards(self, incomplete: Mapping[str, tuple[int, Place]]) -> Shards:
        """Write the index of all shards and rename them; return their entries for the record by path.

        `incomplete` has one incomplete cell for each array that has chunks of incomplete cells. Shards of an incomplete
        subtree get the suffix `PART` again when the build resumes; until then they can be read.
        """
        keys = {array: (level, place, array) for level, place, array in self._journal.sizes()}
        keys |= {array: (level, place, array) for array, (level, place) in incomplete.items() if array not in keys}
        shards = {self._layout.shard_path(key): self._writer(key).finish() for key in keys.values()}
        self._writers.clear()
        return shards

    def _write_record(self, shards: Shards, incomplete: dict[tuple[int, Place], dict[str, Chunk]]) -> None:
        presence, cells = Presence(self._layout, self._tier, self._lower_cells.unchanged), self._journal.cells
        for (level, place), chunks in (cells | incomplete).items():
            presence.add_cell(level, place, chunks)
        guests = {place: guests for (_, place), (_, guests) in self._incomplete.items() if guests}
        leaves = [place for level, place in (*cells, *incomplete) if level == 0]
        geometry = list_geometry(self._store, self._layout, leaves)
        all_guests, empty = self._journal.guests | guests, self._journal.empty_leaves()
        document = record_document(shards, geometry, presence, all_guests, self._outcome.failed, empty)
        write_record(self._record, document)
        if self._outcome.is_complete:
            self._journal.remove()

    def _reload(self) -> Outcome:
        """Return the outcome of a complete subtree: compose its views again from the cells of its highest level."""
        if self._top > self._root:
            return self._outcome
        with formats.guarded(self._record):
            shards = parse_shards(formats.read_json(self._record, RECORD, VERSION)["shards"])
        for path in shards:
            if not (self._store / path).exists():
                raise FormatError(f"{self._store / path}: damaged orthoviews: the shard is gone")
        chunks = Chunks(Local(self._store), self._layout, [Generation("", shards.get, lambda _path: False)])

        def read(level: int, place: Place) -> tuple[Views, bool]:
            with formats.guarded(self._store, "orthoviews"):
                return self._decode(chunks.read_views(level, place)), True

        self._outcome.views, _ = self._compose(self._top, self._place, read)
        return self._outcome
