"""Square cells of the ground plane, each triangle in exactly one of them: that of its centroid."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nearfar._scene.scene import Scene

MAX_CELLS = 1 << 20
"""Maximum number of cells of a grid."""

_MARGIN = 1e-12
"""Margin by which a box is wider than its cell, as a share of the greatest coordinate. A centroid lies in its triangle,
but rounding in float64 may move it across a side, by less than a hundredth of this."""


@dataclass(frozen=True)
class Grid:
    """Cells at multiples of their width; the outer ones extend beyond all sides."""

    cell: float
    """Width of a cell, metres."""
    first: tuple[int, int]
    """Multiple of the width at which the first cell begins, along x and z."""
    counts: tuple[int, int]
    """Number of cells along x and z."""

    @classmethod
    def from_bounds(cls, bounds: NDArray[np.float64], cell: float) -> Grid:
        """Return the grid over a world box; ValueError if it would have too many cells."""
        if not np.isfinite(bounds[:, (0, 2)]).all():
            return cls(cell, (0, 0), (0, 0))
        with np.errstate(over="ignore", invalid="ignore"):  # a width near 0 gives infinitely many cells
            first, last = np.floor(bounds[:, (0, 2)] / cell)
            counts = last - first + 1
            total = counts.prod()
        if not total <= MAX_CELLS:
            got = f"{cell:g} m, {total:.3g} cells"
            raise ValueError(f"cell: expected a width with at most {MAX_CELLS:,} cells, got {got}")
        x, z = first.astype(np.int64).tolist()
        columns, rows = counts.astype(np.int64).tolist()
        return cls(cell, (x, z), (columns, rows))

    def __len__(self) -> int:
        """Return the number of cells."""
        return self.counts[0] * self.counts[1]

    def name(self, number: int) -> str:
        """Name of a cell by its multiples of the width, so that grids of the same width have common names."""
        row, column = divmod(number, self.counts[0])
        return f"{self.first[0] + column}_{self.first[1] + row}"

    def box(self, number: int) -> NDArray[np.float64]:
        """World box (2, 3) that all triangles with centroids in a cell touch; unbounded in height."""
        row, column = divmod(number, self.counts[0])
        box = np.array([[-np.inf] * 3, [np.inf] * 3])
        for axis, index, first, count in zip((0, 2), (column, row), self.first, self.counts, strict=True):
            low, high = (first + index) * self.cell, (first + index + 1) * self.cell
            margin = _MARGIN * max(abs(low), abs(high))
            if index > 0:
                box[0, axis] = low - margin
            if index < count - 1:
                box[1, axis] = high + margin
        return box

    def of_triangles(self, scene: Scene) -> NDArray[np.int64]:
        """Number of the cell (T,) of each triangle's centroid, or of the nearest one."""
        centroids = scene.triangles().mean(axis=1, dtype=np.float64) + scene.origin
        indices = np.floor(centroids[:, (0, 2)] / self.cell).astype(np.int64) - self.first
        column, row = np.clip(indices, 0, np.array(self.counts) - 1).T
        return np.asarray(column + row * self.counts[0])
