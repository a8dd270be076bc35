"""Reads a store whose build is still running or was interrupted, as if the build had ended at one moment.

Complete subtrees have records. For each other subtree that the build has begun, a record is made from the subtree's
journal: the chunks that a journal lists are whole and never move. An unfinished shard has no index at its end yet, so
its index is made from the journal, too. Anything that the build writes after that moment is ignored.
"""

from __future__ import annotations

import hashlib
import re
from collections import Counter
from collections.abc import Iterator, Set as AbstractSet
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from nearfar._base import formats
from nearfar.orthoview import _shard, _store
from nearfar.orthoview._files import ByteRange, Files, Local
from nearfar.orthoview._geometry_store import FOLDER as GEOMETRY, IMAGES
from nearfar.orthoview._grid import Place, name_of
from nearfar.orthoview._index import ShardEntry, pack_index
from nearfar.orthoview._layout import FOLDER, Layout, SubtreeKey
from nearfar.orthoview._presence import PARTIAL, UNBUILT, Presence, masks_of
from nearfar.orthoview._record import (
    DONE,
    JOURNALS,
    NO_HASH,
    RECORD,
    VERSION,
    journal_of,
    list_files,
    list_geometry,
    record_document,
    record_of,
    size_alone,
)
from nearfar.orthoview._shard import Journal
from nearfar.orthoview._store import NO_FILE

_SUBTREE = re.compile("[0-9]+(_[0-9]+){3}")
"""Name of a subtree's record or journal, without its suffix."""


@dataclass(frozen=True)
class Snapshot:
    """Content of a store at one moment."""

    documents: dict[str, bytes]
    """Records made from journals, and the list of all records, by path."""
    indexes: dict[str, tuple[int, bytes]]
    """Total size of the chunks of each unfinished shard, bytes, and its encoded index, by path."""
    held: dict[str, int]
    """Counts as in `OrthoTree.held`, including unfinished subtrees."""
    done: dict[str, int]
    """Counts as in `OrthoTree.done`."""
    failed: dict[str, str]
    """Reasons why leaves are incomplete, by the leaf's name."""
    unbuilt: int
    """Number of leaves that the build has not reached; some may be empty."""


class UnfinishedFiles(Local):
    """Files of a store in a folder, at the moment of construction.

    Without `unfinished_leaves`, unfinished subtrees of leaves count as not built: their shards change while they are
    read.
    """

    def __init__(self, folder: Path, layout: Layout, *, unfinished_leaves: bool = True) -> None:
        super().__init__(folder)
        self._layout = layout
        self.snapshot = _take_snapshot(Local(folder), layout, 0 if unfinished_leaves else 1)

    def has_built(self, level: int, place: Place) -> bool:
        """Whether the build has finished a cell, or found it empty."""
        tier, level_of_subtree = divmod(level, self._layout.subtree)
        shard, place_in_shard = self._layout.shard_of(level, place)
        record = _store.FirstGeneration(self, self._layout).record(tier, shard)
        if record is None:  # the cell above the subtree shows whether the subtree is empty
            top = (tier + 1) * self._layout.subtree
            x, y, z = (number >> (top - level) for number in place)
            return top < self._layout.grid.levels and self.has_built(top, (x, y, z))
        with formats.guarded(self.folder):
            masks = masks_of(record.cells["views"], self._layout, tier)
        return int(masks[level_of_subtree][place_in_shard]) not in (UNBUILT, PARTIAL)

    def unfinished_shards(self) -> dict[str, bytes]:
        """Read all unfinished shards, each with its index, by path."""
        contents = {name: self.read(name) for name in self.snapshot.indexes}
        return {name: content for name, content in contents.items() if content is not None}

    def read(self, name: str) -> bytes | None:
        if name in self.snapshot.documents:
            return self.snapshot.documents[name]
        if name not in self.snapshot.indexes:
            return super().read(name)
        size, index = self.snapshot.indexes[name]
        chunks = self._part(ByteRange(name, 0, size))
        return None if chunks is None else chunks + index

    def _part(self, part: ByteRange) -> bytes | None:
        if part.file not in self.snapshot.indexes:
            return super()._part(part)
        size, _ = self.snapshot.indexes[part.file]
        # The build renames the file when its subtree is complete, and a build that resumes renames it back.
        for suffix in (_shard.PART, "", _shard.PART):
            length = min(part.length, size - part.first)
            if (content := super()._part(ByteRange(part.file + suffix, part.first, length))) is not None:
                return content
        return None


def unbuilt_leaves(files: Files) -> int:
    """Number of leaves of a store that its build has not reached; 0 if the build has ended."""
    return files.snapshot.unbuilt if isinstance(files, UnfinishedFiles) else 0


def open_store(files: Files) -> tuple[Files, dict[str, Any], Layout]:
    """Return the files of a store, its attributes and its layout.

    If the store is in a folder and its build has not ended, the files are `UnfinishedFiles`, and the attributes are
    those that the store would have if the build had ended now.
    """
    attributes = _store.read(files)
    with formats.guarded(f"{files.address}/{_store.DOCUMENT}"):
        layout = Layout.from_json(attributes["layout"])
        has_ended = _store.has_ended(attributes)
    if has_ended or not isinstance(files, Local):
        return files, attributes, layout
    unfinished = UnfinishedFiles(files.folder, layout)
    now = unfinished.snapshot
    return unfinished, attributes | {"held": now.held, "done": now.done, "failed": now.failed}, layout


def _take_snapshot(store: Local, layout: Layout, lowest_tier: int) -> Snapshot:
    folder = store.folder
    journals = {key for key in _find_subtrees(folder / FOLDER / JOURNALS, ".jsonl") if key[0] >= lowest_tier}
    recorded = set(_find_subtrees(folder / FOLDER / DONE, ".json"))
    top = (layout.tiers - 1, (0, 0, 0))
    begun = {ancestor for key in (*journals, *recorded, top) for ancestor in _with_ancestors(key, layout)}
    documents: dict[str, bytes] = {}
    indexes: dict[str, tuple[int, bytes]] = {}
    digests: dict[str, str] = {}
    held, failed = Counter(_store.NO_CONTENT), {}
    empty = unbuilt = 0
    for key in sorted(begun):
        path = record_of(Path(), *key).as_posix()
        content = store.read(path)
        if content is None:
            subtree = _UnfinishedSubtree(folder, layout, key, begun, has_journal=key in journals)
            # The build may have completed the subtree meanwhile: it writes the record before it removes the journal.
            if (content := store.read(path)) is None:
                content = documents[path] = formats.to_json(subtree.record()).encode()
                indexes |= subtree.indexes
                unbuilt += subtree.unbuilt
        with formats.guarded(folder / path):
            record = formats.check(formats.from_json(content), RECORD, VERSION, folder / path)
            held.update(record["held"])
            failed.update(record.get("failed", {}))
            empty += record["empty"]
        digests[Path(path).name] = hashlib.sha256(content).hexdigest()
    images = list_files(folder, sorted((folder / GEOMETRY / IMAGES).glob("*.webp")), size_alone)
    documents[_store.RECORDS_FILE] = formats.to_json(_store.records_document(digests, images)).encode()
    return Snapshot(documents, indexes, dict(held), _store.done_of(held, empty), failed, unbuilt)


def _find_subtrees(folder: Path, suffix: str) -> Iterator[SubtreeKey]:
    """Subtrees that have a file with a suffix in a folder."""
    for path in folder.glob(f"*{suffix}"):
        if _SUBTREE.fullmatch(name := path.name.removesuffix(suffix)):  # temporary files have other names
            tier, x, y, z = map(int, name.split("_"))
            yield tier, (x, y, z)


def _with_ancestors(key: SubtreeKey, layout: Layout) -> Iterator[SubtreeKey]:
    """A subtree and the subtrees above it."""
    tier, (x, y, z) = key
    for above in range(layout.tiers - tier):
        bits = above * layout.subtree
        yield tier + above, (x >> bits, y >> bits, z >> bits)


class _UnfinishedSubtree:
    """A subtree without a record: its cells according to its journal, if it has one."""

    def __init__(
        self, folder: Path, layout: Layout, key: SubtreeKey, begun: AbstractSet[SubtreeKey], *, has_journal: bool
    ) -> None:
        self._folder, self._layout, self._begun = folder, layout, begun
        self._tier, self._place = key
        self._journal = Journal(journal_of(folder, *key) if has_journal else folder / NO_FILE, is_writer=False)
        sizes = self._journal.sizes().items()
        if not all(_shard.has_bytes(folder / layout.shard_path(key), size) for key, size in sizes):
            # Data was lost in a system crash; the build starts the subtree again.
            self._journal = Journal(folder / NO_FILE, is_writer=False)
        self.indexes: dict[str, tuple[int, bytes]] = {}
        """As in `Snapshot`."""
        self._shards: dict[str, ShardEntry] = {}
        for (level, place, array), size in self._journal.sizes().items():
            path = layout.shard_path((level, place, array))
            index = _shard.index_of_chunks(layout.shard_side(level), self._journal.chunks_of(array, layout))
            self.indexes[path] = size, (encoded := _shard.index_bytes(index))
            self._shards[path] = ShardEntry(size + len(encoded), NO_HASH, pack_index(index))
        self._presence = Presence(layout, self._tier)
        self.unbuilt = 0
        """Number of leaves that the build has not reached."""
        self._find_states()

    def record(self) -> dict[str, Any]:
        """Return the record of the subtree as if it were complete."""
        journal = self._journal
        leaves = [place for level, place in journal.cells if level == 0]
        geometry = list_geometry(self._folder, self._layout, leaves, size_alone)
        failed = {name_of(leaf): reason for leaf, reason in journal.failed.items()}
        return record_document(self._shards, geometry, self._presence, journal.guests, failed, journal.empty_leaves())

    def _find_states(self) -> None:
        """Set the masks of all cells.

        The build visits cells in a fixed order. A cell without an entry in the journal is empty if it comes before the
        last cell that has one; otherwise the build has not reached it.
        """
        journal, lowest, grid = self._journal, self._tier * self._layout.subtree, self._layout.grid
        order = list(_in_build_order(self._layout, self._tier, self._place))
        last = max((n for n, cell in enumerate(order) if cell in journal.cells), default=-1)
        states: dict[tuple[int, Place], int] = {}
        for number, cell in enumerate(order):
            level, place = cell
            if cell in journal.cells:
                self._presence.add_cell(level, place, journal.cells[cell])
                states[cell] = PARTIAL if journal.cells[cell] else 0
                continue
            if level > lowest:
                states[cell] = max(states[level - 1, child] for _, child in grid.children(level, place))
            elif self._tier and (self._tier - 1, place) in self._begun:
                states[cell] = PARTIAL
            elif number > last and not (level == 0 and place in journal.failed):
                states[cell] = UNBUILT
                self.unbuilt += grid.leaves(level, place)
            else:
                states[cell] = 0
            self._presence.mark(level, place, states[cell])


def _in_build_order(layout: Layout, tier: int, place: Place) -> Iterator[tuple[int, Place]]:
    """Cells of a subtree in the order in which a build writes them: children before their parents."""
    grid, lowest, top = layout.grid, tier * layout.subtree, (tier + 1) * layout.subtree

    def visit(level: int, cell: Place) -> Iterator[tuple[int, Place]]:
        if level > lowest:
            for _, child in grid.children(level, cell):
                yield from visit(level - 1, child)
        if level < top:
            yield level, cell

    yield from visit(min(top, grid.levels - 1), place)
