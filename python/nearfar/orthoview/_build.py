"""Builds a tree from a source, subtree by subtree from the leaves up."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any, Literal, SupportsFloat, Unpack

from numpy.typing import ArrayLike

from nearfar._base import check, formats, locks, progress
from nearfar._base.cluster import client_of
from nearfar._base.settings import gather
from nearfar._source.protocol import SceneSource, source_of
from nearfar.orthoview import _on_cluster, _store
from nearfar.orthoview._choose_cell import choose_cell, finite_bounds, usual_directions
from nearfar.orthoview._disocclusion import choose_directions
from nearfar.orthoview._files import Local
from nearfar.orthoview._grid import Grid, directions_of
from nearfar.orthoview._layout import FOLDER, Layout, check_zarr
from nearfar.orthoview._leaves import Leaves
from nearfar.orthoview._settings import ViewKeywords, ViewSettings
from nearfar.orthoview._subtree import Outcome
from nearfar.orthoview._tree import OrthoTree

SUBTREE = 3
"""Levels of a subtree: its shards hold up to 8 × 8 × 8 leaves."""


def build(
    source: SceneSource,
    path: str | os.PathLike[str],
    *,
    cell: SupportsFloat | None = None,
    aabb: ArrayLike | None = None,
    geometry: bool = True,
    cluster: Any = None,
    settings: ViewSettings | None = None,
    **keywords: Unpack[ViewKeywords],
) -> OrthoTree:
    """Build the tree of orthographic depth images of a world.

    The world is queried leaf by leaf, depth first: memory holds the scene of one leaf and, for each level, the pictures
    of one parent, 64 bytes for each pixel of its views. If a call was ended by Ctrl-C, a crash or a failing source, the
    same call resumes it. A complete store is opened as it is.

    The tree is incomplete if the source failed for a leaf, or could not read a part of it; `OrthoTree.failed` lists
    these leaves and the reasons. Pictures show the rest; the same call builds these leaves again.
    ValueError for an infinite world without `aabb`, an `aabb` outside the world, too many cells, numbers out of range,
    or a store that was begun with other arguments; TypeError for a value that is not a source, or values that are not
    numbers; SceneError for a source that failed for a thousand leaves; ConnectionError if the cluster's scheduler is
    lost, or its workers fail one after the other; FormatError for a damaged store; BlockingIOError if another build
    writes into the store (where the system has locks); OSError for a folder that holds other files, or files that
    cannot be written; ImportError if the package zarr is missing, or distributed if a cluster is given. Source:
    Chaudhuri et al. (2009), Image-Based Exploration of Massive Online Environments, section 4.

    Parameters
    ----------
    source
        World with `bounds` and `query`; if it has `touches`, empty parts are skipped. Moving objects are left out.
    path
        The store, a folder of Zarr v3: new, empty, or one that this function wrote.
    cell
        Side of the leaves, which are cubes, metres. By default the choice of `choose_cell`, or the side in the store if
        a build is resumed.
    aabb
        World box (2, 3): only the leaves that cover it are built; sides may be infinite. Default: the whole world.
    geometry
        Also write the triangles of leaves, static and moving, as 3D Tiles into the store's folder "geometry": clients
        draw near leaves as triangles.
    cluster
        "local" distributes subtrees over one process for each core of this machine, a `distributed.Client` over its
        workers, which must see the store at the same `path`. Workers read the source from a pickle in the store, so a
        folder of tiles suits better than a scene in memory. Files do not depend on the number of workers. If a worker
        is lost, another one resumes its subtree.
    settings
        The views, as `ViewSettings`.
    keywords
        Fields of `settings`, which they replace: `size`, `directions`, `depth_bits`, `normal_bits`, `color`, `quality`,
        `layers`.
    """
    world, target = source_of("source", source), check.path("path", path)
    bounds = finite_bounds(world, None if aabb is None else check.box("aabb", aabb))
    views = gather(ViewSettings, settings, keywords)
    side = None if cell is None else check.positive("cell", cell)
    begun = _begun_layout(target)
    if side is None:
        side = (
            choose_cell(world, aabb=bounds, size=views.size, directions=usual_directions(views)).cell
            if begun is None
            else begun.grid.cell
        )
    grid = Grid.from_bounds(bounds, side)
    check.flag("geometry", geometry)
    check_zarr()
    layout = Layout(
        grid,
        directions_of(_direction_count(views.directions, world, grid, begun)),
        views.size,
        views.depth_bits,
        views.normal_bits,
        SUBTREE,
        color=views.color,
        quality=views.quality,
        geometry=geometry,
        layers=views.layers,
    )
    _store.begin(target, layout)
    with locks.hold(target / FOLDER / "lock", f"another build writes into {target}"):
        _store.reopen(target)
        outcome = _build(world, target, layout, cluster)
        _store.finish(target, failed=outcome.failed)
    return OrthoTree(target)


def _build(source: SceneSource, target: Path, layout: Layout, cluster: Any) -> Outcome:
    if cluster is None:
        with progress.bar("orthoviews") as report:
            return Leaves(source, target, layout).run(report)
    with (
        client_of(cluster) as client,
        _on_cluster.subtrees(source, target, layout, client) as remote_outcome,
        progress.bar("orthoviews") as report,
    ):
        return Leaves(source, target, layout, remote_outcome).run(report)


def _begun_layout(target: Path) -> Layout | None:
    """Return the layout of a store that was begun; None for a new store."""
    if not (target / _store.DOCUMENT).is_file():
        return None
    attributes = _store.read(Local(target))
    with formats.guarded(target / _store.DOCUMENT):
        return Layout.from_json(attributes["layout"])


def _direction_count(directions: int | Literal["auto"], source: SceneSource, grid: Grid, begun: Layout | None) -> int:
    """Return the number of directions; for "auto", that of a store that was begun, or else the measured choice."""
    if directions != "auto":
        return directions
    return choose_directions(source, grid).count if begun is None else len(begun.directions)
