"""Builds a tree from a source: subtrees from the leaves up, each after those below it."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import SupportsFloat, SupportsIndex

import numpy as np

from nearfar import _core
from nearfar._base import check, locks, progress
from nearfar._scene.scene import Scene
from nearfar._source.protocol import SceneSource, source_of
from nearfar.orthoview import _store
from nearfar.orthoview._directions import directions_of
from nearfar.orthoview._grid import Grid, Place
from nearfar.orthoview._layout import Layout
from nearfar.orthoview._subtree import FOLDER, Outcome, Subtree
from nearfar.orthoview._tree import OrthoTree

SUBTREE = 3
"""Levels of a subtree: its shards hold up to 8 × 8 × 8 leaves."""


def build(
    source: SceneSource,
    path: str | os.PathLike[str],
    *,
    cell: SupportsFloat,
    size: SupportsIndex = 512,
    directions: SupportsIndex = 9,
    depth_bits: SupportsIndex = 12,
    normal_bits: SupportsIndex = 16,
) -> OrthoTree:
    """Build the tree of orthographic depth images of a world.

    The world is queried leaf by leaf, depth first, so memory holds a leaf's scene and a few views for each level,
    however large the world is. A call that ended early, by Ctrl-C, a crash or a source that failed, goes on where it
    was when it is made again with the same arguments.

    Parameters
    ----------
    source
        World with finite `bounds`, and `query`. Moving objects are left out.
    path
        The store, a folder of Zarr v3: new, empty, or one that this function wrote in part.
    cell
        Side of the leaves' cubic cells, metres.
    size
        Width and height of a view, pixels; a multiple of 4.
    directions
        5 views of each cell (from four sides and above), 9 (and from between them), 13 (and from the upper corners) or
        26 (from everywhere).
    depth_bits
        Bits of a depth, 8 to 16: it is known to half a step of 2 to the power of minus this number of a cell's depth.
    normal_bits
        Bits of a normal, 16 or 24: it is known to 0.96° or 0.06°.

    Returns
    -------
    OrthoTree
        Incomplete where the source failed for a cell; `OrthoTree.failed` says which and why.

    Raises
    ------
    ValueError
        A world without end, too many cells, numbers out of range, a store that was begun with other arguments.
    TypeError
        Something that is no source, and values that are not numbers.
    BlockingIOError
        Another build writes into the store.
    OSError
        A folder that holds other files, and files that cannot be written.

    Notes
    -----
    Chaudhuri et al., A System for View-Dependent Rendering of Very Large Scenes Using Orthoviews, section 4.
    """
    world, target = source_of("source", source), check.path("path", path)
    bounds = check.array("source.bounds", world.bounds, dtype=np.float64)
    if not np.isfinite(bounds).all():
        raise ValueError(f"source: expected finite bounds, got {bounds.tolist()}")
    layout = Layout(
        Grid.over(bounds, check.positive("cell", cell)),
        directions_of(directions),
        check.integer("size", size, 4, 4096),
        check.integer("depth_bits", depth_bits, 8, 16),
        check.integer("normal_bits", normal_bits, 16, 24),
        SUBTREE,
    )
    _core.OrthoParent(layout.directions[:1], layout.format)  # refuses what the numbers above let through
    _store.begin(target, layout)
    with locks.alone(target / FOLDER / "lock", f"another build writes into {target}"):
        _Building(world, target, layout).run()
    return OrthoTree(target)


class _Building:
    """The work of `build`."""

    def __init__(self, source: SceneSource, store: Path, layout: Layout) -> None:
        self._source, self._store, self._layout = source, store, layout
        self._drawn = 0

    def run(self) -> None:
        with progress.bar("orthoviews") as report:
            outcome = self._subtree(self._layout.tiers - 1, (0, 0, 0), report)
        _store.end(self._store, failed=outcome.failed, counts=outcome.counts)

    def _subtree(self, tier: int, place: Place, report: progress.Report) -> Outcome:
        leaf, below = partial(self._leaf, report=report), partial(self._subtree, tier - 1, report=report)
        base: Callable[[Place], Outcome] = below if tier else leaf
        return Subtree(self._layout, self._store, tier, place, base).run()

    def _leaf(self, place: Place, report: progress.Report) -> Outcome:
        report(self._drawn, int(np.prod(self._layout.grid.counts)))
        self._drawn += 1
        try:
            views = drawn(self._source.query(self._layout.grid.box(0, place)), self._layout, place)
        except Exception as error:  # a source is anybody's code; the rest of the world goes on
            return Outcome(is_complete=False, failed={_name(place): f"{type(error).__name__}: {error}"})
        return Outcome(views, counts=Counter(empty=views is None, drawn=views is not None))


def drawn(scene: Scene, layout: Layout, place: Place) -> _core.OrthoViews | None:
    """Draw the views of a leaf; None if it shows nothing."""
    if not scene.triangle_count:
        return None
    grid = layout.grid
    views = _core.OrthoViews.of_cell(scene._core, grid.corner(0, place), grid.cell, layout.directions, layout.format)
    return None if all(views.empty()) else views


def _name(place: Place) -> str:
    return "_".join(map(str, place))
