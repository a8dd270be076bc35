"""Unit of work of a build: the cells of a subtree, depth first, each written once to the subtree's shards."""

from __future__ import annotations

import hashlib
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Set as AbstractSet
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Protocol

from nearfar import _core
from nearfar._base import formats
from nearfar._base.errors import FormatError
from nearfar.orthoview import _codec
from nearfar.orthoview._chunks import UNLISTED, Chunks
from nearfar.orthoview._files import Local
from nearfar.orthoview._geometry_store import names
from nearfar.orthoview._grid import Place, name_of
from nearfar.orthoview._index import ListedShard
from nearfar.orthoview._layout import FOLDER, Key, Layout
from nearfar.orthoview._owners import Guests, encode_guests
from nearfar.orthoview._presence import Presence
from nearfar.orthoview._shard import Chunk, Journal, ShardWriter, has_bytes

Views = _core.OrthoViews | None
"""Views of a cell; None for an empty cell."""

Described = dict[str, tuple[int, str]]
"""Sizes and SHA-256 of files by path."""

Shards = dict[str, ListedShard]
"""Entries of shards by path."""

DONE = "done"
"""Folder in `FOLDER` with a record of each complete subtree."""

JOURNALS = "journal"
"""Folder in `FOLDER` with the journal of each subtree in work."""

NO_HASH = ""
"""Hash of a file that is listed by its size alone."""

RECORD, VERSION = "orthoview_subtree", 1


@dataclass
class Outcome:
    """Result of the work on a cell or a subtree."""

    views: Views = None
    is_complete: bool = True
    """False if a leaf below failed."""
    failed: dict[str, str] = field(default_factory=dict)
    """Errors of failed leaves, which show nothing or a part, by name."""
    guests: list[Place] = field(default_factory=list)
    """Guests of a leaf."""
    counts: Counter[str] = field(default_factory=Counter)
    """Counts of work: leaves drawn and found empty, cells composed, chunks reloaded."""


def record_of(store: Path, tier: int, place: Place) -> Path:
    """Path of a subtree's record, which exists once the subtree has been built, with or without failed leaves."""
    return store / FOLDER / DONE / f"{tier}_{'_'.join(map(str, place))}.json"


def journal_of(store: Path, tier: int, place: Place) -> Path:
    """Path of a subtree's journal, which exists from its first cell until all its cells are complete."""
    return store / FOLDER / JOURNALS / f"{record_of(store, tier, place).stem}.jsonl"


def size_and_hash(path: Path) -> tuple[int, str]:
    """Size and SHA-256 of a file."""
    content = path.read_bytes()
    return len(content), hashlib.sha256(content).hexdigest()


def is_complete(record: Path) -> bool:
    """Whether the record of a subtree exists and names no failed leaf."""
    return record.exists() and not formats.read_json(record, RECORD, VERSION).get("failed")


def record_document(
    shards: Shards,
    geometry: Described,
    presence: Presence,
    guests: Guests,
    failed: Mapping[str, str] | None = None,
    empty: int = 0,
) -> dict[str, Any]:
    """Return the record of a subtree.

    `failed` has the reasons, by name, why leaves are incomplete, which the next build repeats. `empty` is the number of
    leaves that were drawn and show nothing.
    """
    content = {"shards": shards, "geometry": geometry, "held": presence.counts(), "empty": empty}
    content |= {"views": presence.to_json(), "guests": encode_guests(guests)}
    return formats.header(RECORD, VERSION) | content | ({"failed": dict(failed)} if failed else {})


def write_record(path: Path, document: dict[str, Any]) -> None:
    """Write the record of a subtree."""
    path.parent.mkdir(parents=True, exist_ok=True)
    formats.write_json(path, document)


class LowerCells(Protocol):
    """Interface of a subtree to the world and to the subtrees below."""

    unchanged: int
    """Initial mask of cells that are not computed: 0 for empty, or `UNCHANGED`."""

    def base(self, tier: int, place: Place) -> Outcome:
        """Return the outcome of a cell of a tier's lowest level: of a rendered leaf, or of a subtree below."""

    def finished_outcome(self, level: int, place: Place) -> Outcome | None:
        """Return the outcome of a cell that needs no work; None if it must be visited."""

    def chunks_before(self, level: int, place: Place) -> AbstractSet[int]:
        """Chunks of a cell in an older generation of the store."""

    def pass_over(self, level: int, place: Place) -> None:
        """Count a cell that needs no work as done."""


class Subtree:
    """Builds the cells below one cell, whose views are returned to the parent subtree, not written.

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
        """Chunks and guests of cells with failed leaves; the journal omits them, so the next build repeats them."""
        self._outcome = Outcome()

    def run(self) -> Outcome:
        """Build what is missing; the outcome has the views of the top cell."""
        if is_complete(self._record):
            self._journal.remove()  # an earlier build may have ended before this
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
        """Remove the record of an incomplete subtree, and the shards that have chunks of its incomplete cells only."""
        kept = {self._layout.shard_path(key) for key in self._journal.sizes()}
        for path in formats.read_json(self._record, RECORD, VERSION)["shards"]:
            if path not in kept:
                (self._store / path).unlink(missing_ok=True)
        self._record.unlink()

    def _views(self, level: int, place: Place) -> tuple[Views, bool]:
        """Views of a cell of this subtree, and whether everything below it is complete."""
        if (level, place) in self._journal.cells:
            self._lower_cells.pass_over(level, place)
            return self._reread(level, place), True
        if (finished := self._lower_cells.finished_outcome(level, place)) is not None:
            self._lower_cells.pass_over(level, place)
            self._outcome.counts += finished.counts
            return finished.views, True
        if level == self._lowest:
            outcome = self._lower_cells.base(self._tier, place)
            self._outcome.failed |= outcome.failed
            self._outcome.counts += outcome.counts
            views, is_complete, guests = outcome.views, outcome.is_complete, outcome.guests
        else:
            (views, is_complete), guests = self._build_parent(level, place), []
        return self._write(level, place, views, guests, is_complete=is_complete), is_complete

    def _build_parent(self, level: int, place: Place) -> tuple[Views, bool]:
        """Compose the views of a cell, after its children have been built."""
        views, is_complete = self._compose(level, place, self._views)
        if views is not None:
            self._outcome.counts["composed"] += 1
        return views, is_complete

    def _compose(
        self, level: int, place: Place, child_views: Callable[[int, Place], tuple[Views, bool]]
    ) -> tuple[Views, bool]:
        """Compose the views of a cell from those of its children; say whether these are complete."""
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

        Parents are composed of these, as in a build that resumes. Views of an incomplete cell are written at the end,
        behind all others, so that a build that resumes drops them.
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
            chunks = [(self._layout.shard_of(level, place)[1], chunk) for place, chunk in self._journal.of_array(array)]
            path = self._store / self._layout.shard_path(key)
            self._writers[array] = ShardWriter(path, self._layout.shard_side(level), chunks)
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
        """Decode a cell's views, and count their chunks."""
        self._outcome.counts["reloaded"] += len(chunks)
        return _codec.decode_cell(chunks, self._layout)

    def _finish_shards(self, incomplete: Mapping[str, tuple[int, Place]]) -> Shards:
        """Write the index of all shards and rename them; return their entries for the record by path.

        `incomplete` has an incomplete cell for each array with chunks of such cells. Shards of an incomplete subtree
        become `PART` again when it resumes; until then readers find its cells.
        """
        keys = {array: (level, place, array) for level, place, array in self._journal.sizes()}
        keys |= {array: (level, place, array) for array, (level, place) in incomplete.items() if array not in keys}
        shards = {self._layout.shard_path(key): self._writer(key).finish() for key in keys.values()}
        self._writers.clear()
        return shards

    def _write_record(self, shards: Shards, incomplete: dict[tuple[int, Place], dict[str, Chunk]]) -> None:
        presence, cells = Presence(self._layout, self._tier, self._lower_cells.unchanged), self._journal.cells
        for (level, place), chunks in (cells | incomplete).items():
            presence.add_computed(level, place)
            for array, (_, length) in chunks.items():
                presence.add((level, place, array), length)
        guests = {place: guests for (_, place), (_, guests) in self._incomplete.items() if guests}
        geometry = self._geometry(place for level, place in (*cells, *incomplete) if level == 0)
        all_guests, empty = self._journal.guests | guests, self._journal.empty_leaves()
        document = record_document(shards, geometry, presence, all_guests, self._outcome.failed, empty)
        write_record(self._record, document)
        if self._outcome.is_complete:
            self._journal.remove()

    def _geometry(self, leaves: Iterable[Place]) -> Described:
        """Sizes and SHA-256 of the files of leaves' geometry."""
        if not self._layout.geometry or self._tier:
            return {}
        paths = [name for place in sorted(leaves) for name in names(self._layout.grid, place)]
        return {path: size_and_hash(self._store / path) for path in paths if (self._store / path).exists()}

    def _reload(self) -> Outcome:
        """Outcome of a complete subtree: its views are composed again from those of its highest level."""
        if self._top > self._root:
            return self._outcome
        for path in formats.read_json(self._record, RECORD, VERSION)["shards"]:
            if not (self._store / path).exists():
                raise FormatError(f"{self._store / path}: damaged orthoviews: the shard is gone")
        chunks = Chunks(Local(self._store), self._layout, [UNLISTED])

        def read(level: int, place: Place) -> tuple[Views, bool]:
            with formats.guarded(self._store, "orthoviews"):
                return self._decode(chunks.read_views(level, place)), True

        self._outcome.views, _ = self._compose(self._top, self._place, read)
        return self._outcome
