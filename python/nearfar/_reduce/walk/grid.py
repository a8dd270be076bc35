"""Hexagonal grids of centres: cells that a path visits or an area intersects, and the path's heights in each cell."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Cells = NDArray[np.int64]

CANDIDATES = 8
"""Number of the longest path pieces whose directions are tried for the rows of a grid."""

_SAMPLE_SPACING = 0.5
"""Spacing of samples along a path, in cell spacings: a visited cell contains a sample or adjoins one that does."""

_BLOCK = 1 << 17
"""Number of samples processed at once."""

_CELL_AND_NEIGHBOURS = np.array([[0, 0], [1, 0], [0, 1], [-1, 1], [-1, 0], [0, -1], [1, -1]])
"""Offsets of a cell and its six neighbours."""

_CELL_MARGIN = 1e-9
"""Relative enlargement of cells, so that rounding hides no visited cell."""


@dataclass(frozen=True)
class Grid:
    """Centres (x, z) of a hexagonal grid, metres."""

    origin: tuple[float, float]
    """Position of one centre."""
    turn: float
    """Direction of the rows, along which neighbours are `spacing` apart: angle in radians from the x axis towards z."""
    spacing: float
    """Distance of neighbours; every point is within spacing / √3 of a centre."""

    @property
    def _normals(self) -> Floats:
        """Unit vectors (3, 2) to three of the six neighbours; the other three are opposite."""
        angles = self.turn + np.arange(3) * (math.pi / 3.0)
        return np.column_stack([np.cos(angles), np.sin(angles)])

    def centers(self, cells: Cells) -> Floats:
        """Centres (K, 2) of cells (K, 2)."""
        first, second, _ = self._normals
        return np.asarray(self.origin + self.spacing * (cells[:, :1] * first + cells[:, 1:] * second))

    def nearest(self, points: Floats) -> Cells:
        """Cells (N, 2) whose centres are nearest to points (N, 2)."""
        first, second, _ = self._normals
        # The three coordinates add up to 0, so the one with the largest rounding error is computed from the others.
        basis = np.linalg.inv(np.column_stack([first, second]) * self.spacing)
        exact = (points - self.origin) @ basis.T
        exact = np.column_stack([exact, -exact.sum(axis=1)])
        rounded = np.rint(exact)
        column = np.abs(rounded - exact).argmax(axis=1)
        rows = np.arange(len(points))
        rounded[rows, column] -= rounded.sum(axis=1)
        return np.asarray(rounded[:, :2], np.int64)

    def clip_segments(self, cells: Cells, starts: Floats, ends: Floats) -> tuple[Floats, Floats]:
        """Clip segments (N, 2) to their cells (N, 2), the hexagons of points nearest to a centre.

        Returns the parameters where each clipped segment starts and ends; it is empty if start > end.
        """
        centers, half_width = self.centers(cells), self.spacing * (0.5 + _CELL_MARGIN)
        begin, end = np.zeros(len(cells)), np.ones(len(cells))
        for normal in self._normals:
            distances, step = (starts - centers) @ normal, (ends - starts) @ normal
            with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
                low, high = (-half_width - distances) / step, (half_width - distances) / step
            is_within = np.abs(distances) <= half_width
            is_parallel = step == 0.0
            enter = np.where(is_parallel, np.where(is_within, 0.0, 2.0), np.minimum(low, high))
            leave = np.where(is_parallel, 1.0, np.maximum(low, high))
            begin, end = np.maximum(begin, enter), np.minimum(end, leave)
        return begin, end

    def cells_of_path(self, path: Floats) -> tuple[Cells, Floats]:
        """Return the cells (K, 2) that the straight pieces of a path visit, in order of first visit, and spans (K, 3).

        `path` is (N, 3) as x, height, z. The span of a cell is (least height, greatest height, first visit) of the path
        in it; the first visit is the number of the piece plus the parameter along it.
        """
        starts, ends = (path[:-1], path[1:]) if len(path) > 1 else (path, path)
        visits: list[tuple[Cells, Floats]] = []
        for pieces, parameters in _samples(starts, ends, _SAMPLE_SPACING * self.spacing):
            samples = (starts[pieces] + parameters[:, None] * (ends[pieces] - starts[pieces]))[:, [0, 2]]
            cells = (self.nearest(samples)[:, None] + _CELL_AND_NEIGHBOURS).reshape(-1, 2)
            piece = np.repeat(pieces, len(_CELL_AND_NEIGHBOURS))
            begin, end = self.clip_segments(cells, starts[piece][:, [0, 2]], ends[piece][:, [0, 2]])
            is_inside = begin <= end
            piece, begin, end = piece[is_inside], begin[is_inside], end[is_inside]
            low, high = starts[piece, 1], ends[piece, 1]
            heights = np.sort(np.column_stack([low + begin * (high - low), low + end * (high - low)]), axis=1)
            visits.append(_merge(cells[is_inside], np.column_stack([heights, piece + begin])))
        cells, spans = _merge(*(np.concatenate(parts) for parts in zip(*visits, strict=True)))
        order = np.argsort(spans[:, 2], kind="stable")
        return cells[order], spans[order]

    def cells_of_area(self, corners: Floats) -> Cells:
        """Cells (K, 2) that intersect a polygon with corners (N, 2), N ≥ 3."""
        closed = np.insert(np.concatenate([corners, corners[:1]]), 1, 0.0, axis=1)
        border, _ = self.cells_of_path(closed)
        # Rows and columns of the grid are slanted, so all four corners of the bounds are needed.
        low, high = corners.min(axis=0), corners.max(axis=0)
        ends = self.nearest(np.array([[x, z] for x in (low[0], high[0]) for z in (low[1], high[1])]))
        rows, columns = (np.arange(a - 1, b + 2) for a, b in zip(ends.min(axis=0), ends.max(axis=0), strict=True))
        cells = np.stack(np.meshgrid(rows, columns, indexing="ij"), axis=-1).reshape(-1, 2)
        return np.unique(np.concatenate([border, cells[_in_polygon(self.centers(cells), corners)]]), axis=0)


def grids(outline: Floats, spacing: float) -> list[Grid]:
    """Candidate grids (x, z) for an outline (N, 2) of straight pieces.

    The rows of each grid run along a long piece, with a centre on it. Such a grid needs the fewest cells for a straight
    walk. A user who looks ahead sees almost no jump where the next centre takes over, because the centre then moves in
    the direction of view (docs/walk.md).
    """
    starts, ends = (outline[:-1], outline[1:]) if len(outline) > 1 else (outline, outline)
    lengths = np.hypot(*(ends - starts).T)
    middles = 0.5 * (starts + ends)
    numbers = np.argsort(-lengths, kind="stable")[:CANDIDATES]
    axes = [(middles[k], ends[k] - starts[k]) for k in numbers]
    axes.append(_main_axis(starts, ends, lengths))
    return [
        Grid((float(origin[0]), float(origin[1])), math.atan2(direction[1], direction[0]), spacing)
        for origin, direction in axes
    ]


def _main_axis(starts: Floats, ends: Floats, lengths: Floats) -> tuple[Floats, Floats]:
    """Centroid and principal axis of straight pieces."""
    weights = lengths / lengths.sum() if lengths.any() else np.full(len(lengths), 1.0 / len(lengths))
    middles, steps = 0.5 * (starts + ends), ends - starts
    centroid = weights @ middles
    offsets = middles - centroid
    spread = (offsets * weights[:, None]).T @ offsets + (steps * weights[:, None]).T @ steps / 12.0
    axis = np.linalg.eigh(spread)[1][:, 1]
    return centroid, axis


def _samples(starts: Floats, ends: Floats, step: float) -> list[tuple[NDArray[np.int64], Floats]]:
    """Return samples at most `step` apart, in blocks: piece number and parameter along the piece."""
    counts = np.ceil(np.hypot(*(ends - starts)[:, [0, 2]].T) / step).astype(np.int64) + 1
    # A piece may have more samples than a block, and a block may have several pieces.
    total, first_numbers = int(counts.sum()), np.concatenate([[0], np.cumsum(counts)])
    blocks = []
    for low in range(0, total, _BLOCK):
        number = np.arange(low, min(low + _BLOCK, total))
        piece = np.searchsorted(first_numbers, number, side="right") - 1
        parameters = (number - first_numbers[piece]) / np.maximum(counts[piece] - 1, 1)
        blocks.append((piece, parameters))
    return blocks


def _merge(cells: Cells, spans: Floats) -> tuple[Cells, Floats]:
    """Merge duplicate cells: minimum of the least heights, maximum of the greatest, minimum of the first visits."""
    unique, rows = np.unique(cells, axis=0, return_inverse=True)
    joined = np.tile([np.inf, -np.inf, np.inf], (len(unique), 1))
    for column, ufunc in enumerate((np.minimum, np.maximum, np.minimum)):
        ufunc.at(joined[:, column], rows.ravel(), spans[:, column])
    return unique, joined


def _in_polygon(points: Floats, corners: Floats) -> NDArray[np.bool_]:
    """Whether points (M, 2) lie within a polygon (N, 2), by the parity of ray crossings."""
    inside = np.zeros(len(points), bool)
    x, z = points.T
    for (x0, z0), (x1, z1) in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        if z0 != z1:
            crosses = (z0 > z) != (z1 > z)
            # Without a crossing the quotient may be any number; it is not used.
            with np.errstate(over="ignore", invalid="ignore"):
                inside ^= crosses & (x < x0 + (z - z0) / (z1 - z0) * (x1 - x0))
    return inside
