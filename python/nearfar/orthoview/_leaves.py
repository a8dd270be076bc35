"""Renders the leaves of a tree from a source: the part of a build that reads the world."""

from __future__ import annotations

import math
import shutil
from collections import Counter
from collections.abc import Callable, Set as AbstractSet
from dataclasses import replace
from pathlib import Path

from nearfar import _core
from nearfar._base import check, locks, progress
from nearfar._base.errors import SceneError
from nearfar._scene.scene import Scene
from nearfar._source.protocol import SceneSource, may_touch, unread_in
from nearfar.orthoview import _codec
from nearfar.orthoview._geometry_store import GeometryStore
from nearfar.orthoview._grid import Place, name_of
from nearfar.orthoview._layout import FOLDER, Layout
from nearfar.orthoview._owners import guests
from nearfar.orthoview._subtree import Outcome, Subtree

MAX_FAILED_LEAVES = 1000
"""Number of failed leaves at which the build stops."""

LOCKS = "locks"
"""Folder with a lock for each subtree of leaves that is being built."""

RemoteOutcome = Callable[[Place], Outcome | None]
"""Returns the outcome of a subtree of leaves that another process built, else None."""


class Leaves:
    """Renders leaves and builds the subtrees that hold them, when the subtrees above need them.

    `folder` is that of the store, or of one of its generations.
    """

    unchanged = 0
    """Mask value for cells that are not computed: empty."""

    def __init__(
        self, source: SceneSource, folder: Path, layout: Layout, remote_outcome: RemoteOutcome = lambda _place: None
    ) -> None:
        self.source, self.folder, self.layout, self._remote_outcome = source, folder, layout, remote_outcome
        self.geometry = GeometryStore(folder, layout.grid) if layout.geometry else None
        self._passed, self._failures = 0, 0
        self._report: progress.Report | None = None

    def run(self, report: progress.Report) -> Outcome:
        """Build the whole tree."""
        self._report = report
        outcome = Subtree(self.layout, self.folder, self.layout.tiers - 1, (0, 0, 0), self).run()
        shutil.rmtree(self.folder / FOLDER / LOCKS, ignore_errors=True)
        return outcome

    def run_one(self, place: Place, report: progress.Report) -> Outcome:
        """Build one subtree of leaves."""
        self._report = report
        return self._subtree(place)

    def _subtree(self, place: Place) -> Outcome:
        """Build a subtree of leaves. Wait for its lock first: a disconnected worker may still be building it."""
        with locks.hold(self.folder / FOLDER / LOCKS / name_of(place), None):
            return Subtree(self.layout, self.folder, 0, place, self).run()

    def build_lowest(self, tier: int, place: Place) -> Outcome:
        """Render a leaf in the lowest tier; in other tiers, build the subtree below a cell."""
        if not tier:
            self.pass_over(0, place)
            return self._leaf(place)
        if tier == 1 and (outcome := self._remote_outcome(place)) is not None:
            self.pass_over(self.layout.subtree, place)
            self._count_failures(outcome)
            return outcome
        if tier == 1:
            return self._subtree(place)
        return Subtree(self.layout, self.folder, tier - 1, place, self).run()

    def _leaf(self, place: Place) -> Outcome:
        try:
            part = self.source.query(self.layout.grid.box(0, place))
        except Exception as error:  # a source may raise anything; the other leaves are still built
            return self.failure(place, error)
        self.write_geometry(part, place)
        unread = unread_in(self.source, part)
        leaf_guests = guests(part, self.layout.grid, place) if self.layout.geometry else []
        views = render_leaf(part, self.layout, place)
        outcome = self.failure(place, SceneError("; ".join(unread)), is_partial=True) if unread else Outcome()
        counts = Counter(empty=views is None, drawn=views is not None)
        return replace(outcome, views=views, guests=leaf_guests, counts=counts)

    def write_geometry(self, part: Scene, place: Place) -> None:
        """Write the geometry of a leaf, if the store has any; call it before the journal records the leaf."""
        if self.geometry is not None:
            self.geometry.write(part, place)

    def failure(self, place: Place, error: Exception, *, is_partial: bool = False) -> Outcome:
        """Return the outcome of a leaf that the source failed to return, or returned in part."""
        reason = check.one_line(f"{type(error).__name__}: {error}", 180)
        outcome = Outcome(is_complete=False, failed={name_of(place): reason})
        if not is_partial:
            self._count_failures(outcome)
        return outcome

    def _count_failures(self, outcome: Outcome) -> None:
        self._failures += len(outcome.failed)
        if outcome.failed and self._failures >= MAX_FAILED_LEAVES:
            reason = list(outcome.failed.values())[-1]
            raise SceneError(f"source: it failed for {self._failures:,} leaves, the last one with {reason}")

    def finished_outcome(self, level: int, place: Place) -> Outcome | None:
        """Return an empty outcome for a cell that the source does not touch, else None."""
        return None if may_touch(self.source, self.layout.grid.box(level, place)) else Outcome()

    def chunks_before(self, _level: int, _place: Place) -> AbstractSet[int]:
        """Return no directions: a build makes the first generation."""
        return frozenset()

    def pass_over(self, level: int, place: Place) -> None:
        """Count the leaves of a cell as done, for the progress bar."""
        self._passed += self.layout.grid.leaves(level, place)
        if self._report is not None:
            self._report(self._passed, math.prod(self.layout.grid.counts))


def render_leaf(scene: Scene, layout: Layout, place: Place) -> _core.OrthoViews | None:
    """Render the views of a leaf; None if it shows nothing."""
    if not scene.triangle_count:
        return None
    grid = layout.grid
    cell, behind = (grid.corner(0, place), grid.cell), layout.layers == 2
    views = _core.OrthoViews.of_cell(scene._core, cell, layout.directions, layout.format, behind=behind)
    return None if all(views.empty()) else _codec.drop_unneeded_layers(views, layout)
