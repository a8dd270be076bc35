"""Subtrees of leaves, built by the workers of a cluster; whoever asked composes what is above them."""

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

AHEAD = 8
"""Subtrees for each thread of a cluster that may be done before their parents take them."""


@dataclass(frozen=True)
class _Job:
    """The task of a worker."""

    folder: Path
    """The store, which all of them see at this path."""
    layout: Layout
    source: Path
    """The pickled source."""
    changed: int
    """When it was written, nanoseconds: a worker keeps the source that it read last."""


@dataclass(frozen=True)
class _Sent:
    """The outcome of a subtree on its way; its views are those of the cell on top, sent once."""

    place: Place
    chunks: _codec.Encoded
    is_complete: bool
    failed: dict[str, str]
    counts: Counter[str]


@contextmanager
def subtrees(source: SceneSource, folder: Path, layout: Layout, client: Any) -> Iterator[Elsewhere]:
    """Let a cluster build the subtrees of leaves that are not complete.

    Yields
    ------
    Elsewhere
        Gives their outcomes, which must be asked for depth first.
    """
    pickled = (folder / FOLDER / "source.pickle").absolute()
    try:
        _keep(source, pickled)
        job = _Job(folder.absolute(), layout, pickled, pickled.stat().st_mtime_ns)
        places = _places(source, folder, layout, layout.tiers - 1, (0, 0, 0))
        with closing(cluster.in_order(partial(_built, job), places, client, ahead=AHEAD)) as results:
            yield _InTurn(results, layout)
    finally:
        pickled.unlink(missing_ok=True)


def _keep(source: SceneSource, path: Path) -> None:
    """Write the source for the workers: within each task it would pass through the scheduler."""
    with files.atomic_file(path) as temporary, temporary.open("wb") as file:
        try:
            pickle.dump(source, file, protocol=5)
        except OSError:
            raise
        except Exception as error:  # whatever the parts of somebody's class raise
            reason = check.one_line(str(error), 180)
            raise TypeError(f"source: expected one that can be pickled, for other processes: {reason}") from None


def _places(source: SceneSource, folder: Path, layout: Layout, tier: int, place: Place) -> Iterator[Place]:
    """Subtrees of leaves that are not complete, in the order in which their parents ask for them."""
    if record_of(folder, tier, place).exists():
        return
    if not tier:
        yield place
        return
    lowest = tier * layout.subtree

    def below(level: int, place: Place) -> Iterator[Place]:
        for _, child in layout.grid.children(level, place):
            if not may_touch(source, layout.grid.box(level - 1, child)):
                continue
            if level - 1 == lowest:
                yield from _places(source, folder, layout, tier - 1, child)
            else:
                yield from below(level - 1, child)

    top = lowest + layout.subtree
    root = layout.grid.levels - 1
    if root == lowest:  # the root is the one cell of its tier
        yield from _places(source, folder, layout, tier - 1, (0, 0, 0))
    else:
        yield from below(min(top, root), place)


class _InTurn:
    """Takes outcomes as they are asked for."""

    def __init__(self, results: Iterator[_Sent], layout: Layout) -> None:
        self._results, self._layout = results, layout
        self._next: _Sent | None = None

    def __call__(self, place: Place) -> Outcome | None:
        """The outcome of a subtree; None for one that was complete before."""
        self._next = self._next or next(self._results, None)
        if self._next is None or self._next.place != place:
            return None
        sent, self._next = self._next, None
        views = _codec.both(sent.chunks, self._layout.lossless) if sent.chunks else None
        return Outcome(views, sent.is_complete, sent.failed, counts=sent.counts)


def _built(job: _Job, place: Place, report: progress.Report) -> _Sent:
    """Build a subtree in a worker."""
    outcome = Leaves(_source(job.source, job.changed), job.folder, job.layout).run_one(place, report)
    chunks = _codec.encoded(outcome.views, job.layout.lossless) if outcome.views is not None else {}
    counts = outcome.counts + Counter(sent=len(chunks))
    return _Sent(place, chunks, outcome.is_complete, outcome.failed, counts)


@lru_cache(maxsize=1)
def _source(path: Path, _changed: int) -> SceneSource:
    with path.open("rb") as file:
        source: SceneSource = pickle.load(file)
    return source
