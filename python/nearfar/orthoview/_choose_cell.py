"""Chooses the side of leaves from a few sampled leaves, and estimates how long a build takes."""

from __future__ import annotations

import math
import time
from dataclasses import dataclass
from itertools import islice
from typing import SupportsIndex

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check, progress
from nearfar._scene.scene import Scene
from nearfar._source.protocol import SceneSource, bounds_of, source_of
from nearfar.orthoview import _codec, _sampling
from nearfar.orthoview._geometry import cell_glb
from nearfar.orthoview._grid import Grid, Place, directions_of, widest
from nearfar.orthoview._layout import Layout
from nearfar.orthoview._leaves import render_leaf
from nearfar.orthoview._settings import MAX_SIZE, ViewSettings

NEAR_TRIANGLES = 1_000_000
"""Maximum number of triangles of all leaves near a viewer, which are drawn as geometry."""

MAX_LEAVES = 2000
"""Maximum expected number of leaves that may contain something; each takes at least a tenth of a second."""

DISPLAY = 1920
"""Width in pixels of the assumed display, whose field of view is 90°."""

SAMPLED_LEAVES = 12
"""Number of leaves whose triangles are counted for each side that is tried."""

SAMPLED_TRIANGLES = 3_000_000
"""Sampling ends early once the leaves have this many triangles."""

TIMED_LEAVES = 5
"""Number of leaves that are built to estimate the duration of a build."""

PARENTS_SHARE = 0.1
"""Time for the cells above the leaves, as a share of the time for the leaves."""

_FIRST_SHARE = 64
"""The first side that is tried is about the world's greatest extent divided by this number."""

_STEPS = (1.0, 2.0, 5.0)
"""Sides are these numbers times powers of ten."""


@dataclass(frozen=True)
class CellChoice:
    """Side of the leaves that `choose_cell` chose, with its reasons; `str` explains the choice."""

    cell: float
    """Side of the leaves, metres."""
    triangles: float
    """Mean number of triangles of sampled leaves of this side. A scene in memory is sampled mostly at dense leaves."""
    leaves: int
    """Expected number of leaves that may contain something."""
    finer: float | None = None
    """Side in metres that suits the number of triangles but needs too many leaves; None if that is the chosen side."""

    def __str__(self) -> str:
        chosen = f"about {self.leaves:,} leaves of {self.cell:g} m with about {self.triangles:,.0f} triangles each"
        if self.finer is None:
            near = "the leaves near a viewer, which are drawn as geometry"
            return f"{chosen}; {near}, have at most {NEAR_TRIANGLES:,} triangles"
        return (
            f"{chosen}: leaves of {self.finer:g} m would suit the number of triangles, but more than {MAX_LEAVES:,} "
            "would be needed; build a part of the world with small leaves, or state their side"
        )


def choose_cell(
    source: SceneSource,
    *,
    aabb: ArrayLike | None = None,
    size: SupportsIndex = 512,
    directions: SupportsIndex = 9,
) -> CellChoice:
    """Choose the side of the leaves with which `build` builds a world by default.

    Viewers draw near leaves as geometry, up to the distance at which views become as fine as a display of 1920 pixels
    and 90°. The chosen side is the greatest one with which these leaves have at most a million triangles, as estimated
    from 12 sampled leaves. If more than about 2,000 leaves of that side may contain something, a greater side is
    chosen. Sides are 1, 2 or 5 times a power of ten. The same arguments give the same side. Errors as in `build`.

    Parameters
    ----------
    source, aabb, size, directions
        As in `build`. With coarser views more leaves are drawn as geometry, so the leaves must be smaller.
    """
    world, pixels = source_of("source", source), check.integer("size", size, 4, MAX_SIZE)
    bounds = finite_bounds(world, None if aabb is None else check.box("aabb", aabb))
    reach = widest(directions_of(directions)) / pixels * DISPLAY / 2
    # A circle about a viewer in a plane of leaves touches 1 + 4 r + π r² of them, r its radius in sides of a leaf.
    max_triangles = NEAR_TRIANGLES / (1 + 4 * reach + math.pi * reach**2)
    extent = float((bounds[1] - bounds[0]).max())
    with progress.bar("leaf size"):
        finer, triangles = _side_by_triangles(world, bounds, extent, max_triangles)
        step = _step_of(finer)
        while (leaves := _sampling.expected_leaves(world, grid := Grid.from_bounds(bounds, _side(step)))) > MAX_LEAVES:
            step += 1
        if _side(step) != finer:
            triangles = _mean_triangles(world, grid)
    return CellChoice(_side(step), triangles, leaves, None if _side(step) == finer else finer)


def usual_directions(views: ViewSettings) -> int:
    """Return the number of directions; 9 for "auto", whose number is chosen later."""
    return 9 if isinstance(views.directions, str) else views.directions


def finite_bounds(source: SceneSource, box: NDArray[np.float64] | None) -> NDArray[np.float64]:
    """Intersect a source's bounds with a box; ValueError unless the result is finite and not empty."""
    bounds = bounds_of(source)
    if box is not None:
        bounds = np.array([np.maximum(bounds[0], box[0]), np.minimum(bounds[1], box[1])])
    if not np.isfinite(bounds).all() or (bounds[0] > bounds[1]).any():
        expected = "source: expected finite bounds" if box is None else "aabb: expected a finite part of the source"
        raise ValueError(f"{expected}, got {bounds.tolist()}")
    return bounds


def _side_by_triangles(
    source: SceneSource, bounds: NDArray[np.float64], extent: float, max_triangles: float
) -> tuple[float, float]:
    """Return the greatest side whose sampled leaves have at most `max_triangles` on average, and their average.

    In a world that is empty or has few triangles it is at least the world's extent.
    """
    last = _step_of(max(extent, 1e-3))
    step = min(_step_of(max(extent, 1e-3) / _FIRST_SHARE), last)
    counts: dict[int, float] = {}

    def count(step: int) -> float:
        if step not in counts:
            counts[step] = _mean_triangles(source, Grid.from_bounds(bounds, _side(step)))
        return counts[step]

    while step < last and count(step + 1) <= max_triangles:
        step += 1
    while count(step) > max_triangles and Grid.fits(bounds, _side(step - 1)):
        step -= 1
    return _side(step), count(step)


def _mean_triangles(source: SceneSource, grid: Grid) -> float:
    """Mean number of triangles of sampled leaves that are not empty; 0 if there are none."""
    counts: list[int] = []
    # Many sampled leaves of a sparse source are empty.
    for place in islice(_sampling.leaves(source, grid), 8 * SAMPLED_LEAVES):
        if (part := _query(source, grid, place)) is not None and part.triangle_count:
            counts.append(part.triangle_count)
        if len(counts) == SAMPLED_LEAVES or sum(counts) >= SAMPLED_TRIANGLES:
            break
    return float(np.mean(counts)) if counts else 0.0


def _query(source: SceneSource, grid: Grid, place: Place) -> Scene | None:
    """Query the scene of a leaf; None if the source fails."""
    try:
        return source.query(grid.box(0, place))
    except Exception:  # a source may raise anything; the build names the leaves that it cannot return
        return None


def _side(step: int) -> float:
    """Side with a number in the series 1, 2, 5, 10 … metres, which begins with number 0."""
    power, digit = divmod(step, len(_STEPS))
    return float(f"{_STEPS[digit]:g}e{power}")


def _step_of(length: float) -> int:
    """Number of the least side in the series that is at least a length, metres."""
    step = len(_STEPS) * (math.floor(math.log10(length)) - 1)
    while _side(step) < length:
        step += 1
    return step


def expected_seconds(
    source: SceneSource, cell: float, *, aabb: ArrayLike | None, settings: ViewSettings, geometry: bool
) -> tuple[int, float]:
    """Estimate the number of leaves that may contain something, and the seconds that one process takes to build all.

    Builds and times a few leaves that are spread over the world. Arguments as in `build`.
    """
    bounds = finite_bounds(source, None if aabb is None else check.box("aabb", aabb))
    grid, seconds = Grid.from_bounds(bounds, cell), []
    directions = directions_of(usual_directions(settings))
    bits = settings.depth_bits, settings.normal_bits
    layout = Layout(grid, directions, settings.size, *bits, 1, geometry=geometry, layers=settings.layers)
    count = _sampling.expected_leaves(source, grid)
    for place in islice(_sampling.spread_leaves(source, grid), TIMED_LEAVES):
        started = time.monotonic()
        part = _query(source, grid, place)
        if part is not None:
            _codec.encode(render_leaf(part, layout, place), layout)
            if layout.geometry:
                cell_glb(part, grid, place)
        seconds.append(time.monotonic() - started)
    return count, count * float(np.mean(seconds or [0.0])) * (1 + PARENTS_SHARE)
