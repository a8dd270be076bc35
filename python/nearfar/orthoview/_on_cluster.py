"""Lets the workers of a cluster build subtrees of leaves; the calling process composes the levels above."""

from __future__ import annotations

import pickle
from collections import Counter
from collections.abc import Iterator
from contextlib import closing, contextmanager
from dataclasses import replace
from functools import lru_cache, partial
from pathlib import Path
from typing import Any

from nearfar._base import check, cluster, files, progress
from nearfar._source.protocol import SceneSource, may_touch
from nearfar.orthoview import _codec
from nearfar.orthoview._grid import Place
from nearfar.orthoview._layout import FOLDER, Layout
from nearfar.orthoview._leaves import Leaves, RemoteOutcome
from nearfar.orthoview._record import is_complete, record_of
from nearfar.orthoview._subtree import Outcome

SUBTREES_AHEAD = 8
"""Number of subtrees per cluster thread that may be finished before their parents use them."""


_Result = tuple[Place, Outcome, _codec.Encoded]
"""Message from a worker: place of a subtree, its outcome without views, and the encoded views of its top cell."""


@contextmanager
def subtrees(source: SceneSource, folder: Path, layout: Layout, client: Any) -> Iterator[RemoteOutcome]:
    """Let a cluster build the incomplete subtrees of leaves; yields a function that returns their outcomes.

    The caller must request the outcomes in the order of the build, depth first.
    """
    pickled = (folder / FOLDER / "source.pickle").absolute()
    try:
        _write_source(source, pickled)
        build = partial(_build, folder.absolute(), layout, pickled, pickled.stat().st_mtime_ns)
        places = _incomplete_subtrees(source, folder, layout, layout.tiers - 1, (0, 0, 0))
        with closing(cluster.in_order(build, places, client, backlog=SUBTREES_AHEAD)) as results:
            yield _Outcomes(results, layout)
    finally:
        pickled.unlink(missing_ok=True)


def _write_source(source: SceneSource, path: Path) -> None:
    """Pickle the source into a file for the workers: as an argument of tasks it would pass through the scheduler."""
    with files.atomic_file(path) as temporary, temporary.open("wb") as file:
        try:
            pickle.dump(source, file, protocol=5)
        except OSError:
            raise
        except Exception as error:  # pickling user classes may raise anything
            reason = check.one_line(str(error), 180)
            raise TypeError(f"source: expected one that can be pickled, for other processes: {reason}") from None


def _incomplete_subtrees(source: SceneSource, folder: Path, layout: Layout, tier: int, place: Place) -> Iterator[Place]:
    """Places of incomplete subtrees of leaves below a subtree, in the order of the build."""
    if is_complete(record_of(folder, tier, place)):
        return
    if not tier:
        yield place
        return
    grid, lowest = layout.grid, tier * layout.subtree

    def may_touch_source(level: int, cell: Place) -> bool:
        return may_touch(source, grid.box(level, cell))

    for child in grid.descendants(min(lowest + layout.subtree, grid.levels - 1), place, lowest, may_touch_source):
        yield from _incomplete_subtrees(source, folder, layout, tier - 1, child)


class _Outcomes:
    """Outcomes of subtrees, from the cluster's results in the order of the build."""

    def __init__(self, results: Iterator[_Result], layout: Layout) -> None:
        self._results, self._layout = results, layout
        self._next: _Result | None = None

    def __call__(self, place: Place) -> Outcome | None:
        """Return the outcome of a subtree; None for a subtree that an earlier build completed."""
        self._next = self._next or next(self._results, None)
        if self._next is None or self._next[0] != place:
            return None
        (_, outcome, chunks), self._next = self._next, None
        return replace(outcome, views=_codec.decode_cell(chunks, self._layout.lossless))


def _build(
    folder: Path, layout: Layout, source: Path, source_time: int, place: Place, report: progress.Report
) -> _Result:
    """Build a subtree in a worker, which sees the store at the same path and reads the pickled source."""
    outcome = Leaves(_source(source, source_time), folder, layout).run_one(place, report)
    chunks = _codec.encode(outcome.views, layout.lossless)
    return place, replace(outcome, views=None, counts=outcome.counts + Counter(sent=len(chunks))), chunks


@lru_cache(maxsize=1)
def _source(path: Path, _changed_ns: int) -> SceneSource:
    """Read the source. A worker caches the last one by path and modification time."""
    with path.open("rb") as file:
        source: SceneSource = pickle.load(file)
    return source
