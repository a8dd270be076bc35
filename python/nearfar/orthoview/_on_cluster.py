"""Lets the workers of a cluster build subtrees of leaves; the calling process composes the levels above."""

from __future__ import annotations

import pickle
from collections import Counter
from collections.abc import Iterator
from contextlib import closing, contextmanager
from dataclasses import dataclass
from functools import lru_cache, partial
from pathlib import Path
from typing import Any

from nearfar._base import check, cluster, files, progress
from nearfar._source.protocol import SceneSource, may_touch
from nearfar.orthoview import _codec
from nearfar.orthoview._grid import Place
from nearfar.orthoview._layout import FOLDER, Layout
from nearfar.orthoview._leaves import Elsewhere, Leaves
from nearfar.orthoview._subtree import Outcome, record_of

SUBTREES_AHEAD = 8
"""Number of subtrees per cluster thread that may be finished before their parents use them."""


@dataclass(frozen=True)
class _Job:
    """The task of a worker."""

    folder: Path
    """Folder of the store, at the same path for all workers."""
    layout: Layout
    source: Path
    """The pickled source."""
    changed: int
    """Time when it was written, nanoseconds: a worker caches the source that it read last."""


@dataclass(frozen=True)
class _Sent:
    """Outcome of a subtree as sent to the caller; it has the views of the subtree's top cell only."""

    place: Place
    chunks: _codec.Encoded
    is_complete: bool
    failed: dict[str, str]
    counts: Counter[str]


@contextmanager
def subtrees(source: SceneSource, folder: Path, layout: Layout, client: Any) -> Iterator[Elsewhere]:
    """Let a cluster build the incomplete subtrees of leaves; yields a function that returns their outcomes in order.

    These must be requested depth first.
    """
    pickled = (folder / FOLDER / "source.pickle").absolute()
    try:
        _write_source(source, pickled)
        job = _Job(folder.absolute(), layout, pickled, pickled.stat().st_mtime_ns)
        places = _places(source, folder, layout, layout.tiers - 1, (0, 0, 0))
        with closing(cluster.in_order(partial(_build, job), places, client, backlog=SUBTREES_AHEAD)) as results:
            yield _InOrder(results, layout)
    finally:
        pickled.unlink(missing_ok=True)


def _write_source(source: SceneSource, path: Path) -> None:
    """Write the source to a file for the workers: as part of each task it would pass through the scheduler."""
    with files.atomic_file(path) as temporary, temporary.open("wb") as file:
        try:
            pickle.dump(source, file, protocol=5)
        except OSError:
            raise
        except Exception as error:  # pickling user classes may raise anything
            reason = check.one_line(str(error), 180)
            raise TypeError(f"source: expected one that can be pickled, for other processes: {reason}") from None


def _places(source: SceneSource, folder: Path, layout: Layout, tier: int, place: Place) -> Iterator[Place]:
    """Incomplete subtrees of leaves, in the order in which their parents request them."""
    if record_of(folder, tier, place).exists():
        return
    if not tier:
        yield place
        return
    lowest = tier * layout.subtree

    def descend(level: int, place: Place) -> Iterator[Place]:
        for _, child in layout.grid.children(level, place):
            if not may_touch(source, layout.grid.box(level - 1, child)):
                continue
            if level - 1 == lowest:
                yield from _places(source, folder, layout, tier - 1, child)
            else:
                yield from descend(level - 1, child)

    top = lowest + layout.subtree
    root = layout.grid.levels - 1
    if root == lowest:  # the root is the only cell of its tier
        yield from _places(source, folder, layout, tier - 1, (0, 0, 0))
    else:
        yield from descend(min(top, root), place)


class _InOrder:
    """Returns the cluster's outcomes in order."""

    def __init__(self, results: Iterator[_Sent], layout: Layout) -> None:
        self._results, self._layout = results, layout
        self._next: _Sent | None = None

    def __call__(self, place: Place) -> Outcome | None:
        """Outcome of a subtree; None if it was complete before."""
        self._next = self._next or next(self._results, None)
        if self._next is None or self._next.place != place:
            return None
        sent, self._next = self._next, None
        views = _codec.decode_cell(sent.chunks, self._layout.lossless)
        return Outcome(views, sent.is_complete, sent.failed, counts=sent.counts)


def _build(job: _Job, place: Place, report: progress.Report) -> _Sent:
    """Build a subtree in a worker."""
    outcome = Leaves(_source(job.source, job.changed), job.folder, job.layout).run_one(place, report)
    chunks = _codec.encode(outcome.views, job.layout.lossless)
    counts = outcome.counts + Counter(sent=len(chunks))
    return _Sent(place, chunks, outcome.is_complete, outcome.failed, counts)


@lru_cache(maxsize=1)
def _source(path: Path, _changed: int) -> SceneSource:
    with path.open("rb") as file:
        source: SceneSource = pickle.load(file)
    return source
