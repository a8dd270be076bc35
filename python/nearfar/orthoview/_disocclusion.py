"""Measures the share of visible surfaces that views lack (disocclusion), and chooses a set of directions by it.

A client draws a far cell from the 3 directions of the set that are nearest to its viewing direction. Surfaces of
the cell that the viewer sees but none of the 3 views shows are holes in its picture.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import progress
from nearfar._scene.scene import Scene
from nearfar._source.protocol import SceneSource, unread_in
from nearfar._trace.rays import cast_rays
from nearfar.orthoview._grid import COUNTS, Grid, Place, directions_of
from nearfar.orthoview._sampling import leaves

DRAWN_VIEWS = 3
"""Number of views that a client draws of a cell."""

VIEWERS = 32
"""Number of directions from which the world is viewed."""

COUNTED_LEAVES = 32
"""Number of sampled leaves whose triangles are counted."""

MIN_LEAVES, MAX_LEAVES = 4, 16
"""Least and greatest number of leaves whose views are rendered."""

MAX_TRIANGLES = 1_000_000
"""No further leaf is rendered once the leaves have this many triangles, except for the first `MIN_LEAVES`."""

SIZE = 128
"""Width and height of the rendered views, pixels."""

RAYS = 48
"""Number of rays along a leaf's side, for each viewer."""

GOOD_DISOCCLUSION = 0.035
"""Disocclusion that counts as good enough."""

MIN_IMPROVEMENT = 0.01
"""Least decrease of disocclusion that justifies a larger set."""

DEFAULT_COUNT = 9
"""Number of directions for a world in which nothing was found."""

_MAX_DEPTH_DIFFERENCE_PX = 2.0
"""Greatest difference in depth between a point and a neighbouring pixel of the same surface, in pixels of a view.

The kernel that reduces views has the same reach: 4 pixels of a picture of twice the size. The points of a view are one
pixel apart, so the nearest one is at most √½ pixel away. There a plane's depth differs by 2 pixels if its normal is 70°
from the view direction, since tan 70° is about 2 √2.
"""

_MARGIN = 8.0
"""Views show surfaces beyond a cell's sides by up to this number of float32 roundings of the greatest coordinate."""

_FORMAT = (16, 16)
"""Bits of a view's depths and normals."""


@dataclass(frozen=True)
class Choice:
    """Set of directions chosen for a world, with the measurements that led to it."""

    count: int
    """Number of directions."""
    shares: dict[int, float]
    """Disocclusion of each set; empty if nothing was found in the world."""
    cells: int
    """Number of measured leaves."""


def choose_directions(source: SceneSource, grid: Grid, *, below: bool = False) -> Choice:
    """Choose the set of directions for a world by its disocclusion.

    Leaves are sampled at random, and those with the most triangles are rendered. Leaves that the source cannot return
    are skipped. The same world and grid give the same choice. With `below`, viewers look up from below as well.
    """
    hidden: Counter[int] = Counter()
    visible = cells = 0
    with progress.bar("directions") as report:
        for done, place in enumerate(
            _densest(source, grid, lambda number: report(number, COUNTED_LEAVES + MAX_LEAVES))
        ):
            report(COUNTED_LEAVES + done, COUNTED_LEAVES + MAX_LEAVES)
            if (part := _query(source, grid, place)) is not None:
                pixels, holes = _count_holes(part, grid, place, COUNTS, SIZE, viewers(below=below))
                hidden.update(holes)
                visible, cells = visible + pixels, cells + (pixels > 0)
    shares = {count: hidden[count] / visible for count in COUNTS} if visible else {}
    return Choice(smallest_set(shares) if shares else DEFAULT_COUNT, shares, cells)


def _densest(source: SceneSource, grid: Grid, report: Callable[[int], None]) -> list[Place]:
    """Return the leaves with the most triangles among the first `COUNTED_LEAVES` that are not empty."""
    counts: dict[Place, int] = {}
    for place in leaves(source, grid):
        report(len(counts))
        if (part := _query(source, grid, place)) is not None:
            counts[place] = part.triangle_count
        if len(counts) == COUNTED_LEAVES:
            break
    densest = sorted(counts, key=lambda place: -counts[place])[:MAX_LEAVES]
    triangles_before = np.cumsum([0, *(counts[place] for place in densest)])[:-1]
    is_affordable = triangles_before < MAX_TRIANGLES
    return [place for number, place in enumerate(densest) if number < MIN_LEAVES or is_affordable[number]]


def _query(source: SceneSource, grid: Grid, place: Place) -> Scene | None:
    """Query the scene of a leaf; None if it is empty, or if the source cannot return all of it."""
    try:
        part = source.query(grid.box(0, place))
    except Exception:  # a source may raise anything; the build names the leaves that it cannot return
        return None
    return part if part.triangle_count and not unread_in(source, part) else None


def smallest_set(shares: Mapping[int, float]) -> int:
    """Return the size of the smallest set that is good enough, or that no larger one improves by `MIN_IMPROVEMENT`."""

    def is_enough(count: int) -> bool:
        gains = (shares[count] - shares[larger] for larger in shares if larger > count)
        return shares[count] <= GOOD_DISOCCLUSION or all(gain < MIN_IMPROVEMENT for gain in gains)

    return next(filter(is_enough, sorted(shares)))


def viewers(*, below: bool = False) -> NDArray[np.float64]:
    """Unit vectors towards viewers (`VIEWERS`, 3), uniform over the upper hemisphere, or with `below` over the sphere.

    A Fibonacci lattice: heights are the middles of equal steps, so the lowest viewers are 1° above the horizon.
    """
    number = np.arange(VIEWERS)
    height = (number + 0.5) / VIEWERS * 2 - 1 if below else (number + 0.5) / VIEWERS
    azimuth, radius = np.pi * (3 - np.sqrt(5)) * number, np.sqrt(1 - height**2)
    return np.column_stack([radius * np.cos(azimuth), height, radius * np.sin(azimuth)])


def nearest(directions: NDArray[np.float64], viewer: NDArray[np.float64]) -> list[int]:
    """Return the numbers of the `DRAWN_VIEWS` unit vectors nearest to a viewer; equally near ones in their order."""
    order = np.argsort(-np.round(directions @ viewer, 9), kind="stable")
    return [int(number) for number in order[:DRAWN_VIEWS]]


def _count_holes(
    part: Scene, grid: Grid, place: Place, sets: Sequence[int], size: int, viewer_directions: NDArray[np.float64]
) -> tuple[int, Counter[int]]:
    """Count the pixels of all viewers that show a leaf, and the holes among them for each set of directions.

    Moving objects are left out, as in views. `size` is the width and height of views in pixels, a multiple of 4.
    """
    hidden: Counter[int] = Counter()
    if moving := part.poses:
        part = part.subset(objects=[name for name in part.object_names if name not in moving])
    if not part.triangle_count:
        return 0, hidden
    views = _Views(part, grid, place, max(sets), size)
    visible = 0
    for viewer, points in zip(viewer_directions, _visible(part, grid.box(0, place), viewer_directions), strict=True):
        visible += len(points)
        drawn = {count: nearest(views.toward[:count], viewer) for count in sets}
        shows = {number: views.show(number, points) for number in set().union(*drawn.values())}
        for count, numbers in drawn.items():
            hidden[count] += int(np.count_nonzero(~np.any([shows[number] for number in numbers], axis=0)))
    return visible, hidden


def _visible(
    part: Scene, box: NDArray[np.float64], viewer_directions: NDArray[np.float64]
) -> list[NDArray[np.float64]]:
    """Points (N, 3) of a cell that each viewer sees along parallel rays, `RAYS` along a side of the cell."""
    margin = _MARGIN * float(np.finfo(np.float32).eps) * np.abs(box - part.origin).max()
    rays = [_rays(box + np.array([[-margin], [margin]]), viewer) for viewer in viewer_directions]
    counts = [len(starts) for starts, _ in rays]
    starts = np.concatenate([starts for starts, _ in rays])
    toward = np.repeat(viewer_directions, counts, axis=0)
    hits = cast_rays(part, starts, -toward)
    is_inside = hits.t_hit <= np.concatenate([lengths for _, lengths in rays])
    points = starts - np.where(is_inside, hits.t_hit, np.nan).astype(np.float64)[:, None] * toward
    by_viewer = (np.split(values, np.cumsum(counts)[:-1]) for values in (points, is_inside))
    return [entries[mask] for entries, mask in zip(*by_viewer, strict=True)]


def _rays(box: NDArray[np.float64], viewer: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the points (N, 3) where a viewer's rays enter a cubic box, and the lengths (N,) of the rays in it."""
    right = np.cross([0.0, 1.0, 0.0], viewer)
    right /= np.linalg.norm(right)
    up, center, side = np.cross(viewer, right), box.mean(axis=0), float(box[1, 0] - box[0, 0])
    columns, rows = (_middles(float(np.abs(axis).sum()) * RAYS) * (side / RAYS) for axis in (right, up))
    front = (center + side * viewer + rows[:, None, None] * up + columns[:, None] * right).reshape(-1, 3)
    with np.errstate(divide="ignore", invalid="ignore"):
        low, high = (front - box[0]) / viewer, (front - box[1]) / viewer
    enter, leave = np.fmin(low, high).max(axis=1), np.fmax(low, high).min(axis=1)
    meets = enter < leave
    return front[meets] - enter[meets, None] * viewer, (leave - enter)[meets]


def _middles(extent: float) -> NDArray[np.float64]:
    """Centres of pixels that cover an extent, in pixels from its middle."""
    count = int(np.ceil(extent))
    return np.arange(count, dtype=np.float64) - (count - 1) / 2


class _Views:
    """Views of a leaf in the first `count` directions."""

    def __init__(self, part: Scene, grid: Grid, place: Place, count: int, size: int) -> None:
        directions, cell = directions_of(count), (grid.corner(0, place), grid.cell)
        views = _core.OrthoViews.of_cell(part._core, cell, directions, (size, *_FORMAT))
        frames = [_core.orthoview_axes(direction) for direction in directions]
        self._axes = np.array([axes for axes, _ in frames])
        self._extents = np.array([extents for _, extents in frames]) * grid.cell
        self._center, self._size = grid.box(0, place).mean(axis=0), size
        codes = views.depths()[..., 0]
        metres = (codes - 0.5) * (self._extents[:, 2] / views.steps)[:, None, None]
        # A border of empty pixels, so that each pixel has eight neighbours.
        self._depths = np.pad(np.where(codes > 0, metres, np.inf), ((0, 0), (1, 1), (1, 1)), constant_values=np.inf)
        self.toward = self._axes[:, 2]

    def show(self, number: int, points: NDArray[np.float64]) -> NDArray[np.bool_]:
        """Whether a view shows points (N, 3), in their pixel or one of the eight around it."""
        (right, up, toward), (width, height, depth) = self._axes[number], self._extents[number]
        offset, size = points - self._center, self._size
        column = np.clip(np.floor((offset @ right / width + 0.5) * size), 0, size - 1).astype(np.int64)
        row = np.clip(np.floor((0.5 - offset @ up / height) * size), 0, size - 1).astype(np.int64)
        behind = depth / 2 - offset @ toward
        corner, depths = row * (size + 2) + column, self._depths[number].reshape(-1)
        neighbours = (corner + down * (size + 2) + right_by for down in range(3) for right_by in range(3))
        error = np.min([np.abs(depths[pixel] - behind) for pixel in neighbours], axis=0, initial=np.inf)
        return np.asarray(error <= _MAX_DEPTH_DIFFERENCE_PX * max(width, height) / size)
