"""The `OrthoView` class: a view of a cell; and a contact sheet of a cell's views."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class OrthoView:
    """A cell seen in parallel projection."""

    color: NDArray[np.uint8]
    """Unshaded colours, sRGB (size, size, 3)."""
    depth: NDArray[np.float32]
    """Metres behind the front of the cell's extent along the view (size, size); infinite for empty pixels."""
    normal: NDArray[np.float32]
    """Unit normals towards the viewer, world axes (size, size, 3); NaN for empty pixels."""
    surfel: NDArray[np.bool_]
    """Whether each pixel is a surfel, a piece of a plane (size, size); the others are balls."""
    right: NDArray[np.float64]
    """Unit vector towards the right of the picture."""
    up: NDArray[np.float64]
    """Unit vector towards the top of the picture."""
    toward: NDArray[np.float64]
    """Unit vector towards the viewer."""
    extents: NDArray[np.float64]
    """Width and height of the picture and range of depths, metres."""
    center: NDArray[np.float64]
    """World position of the cell's centre, metres."""

    def points(self) -> NDArray[np.float64]:
        """World positions (size, size, 3) of the surfaces, metres; NaN for empty pixels."""
        steps = (np.arange(len(self.depth)) + 0.5) / len(self.depth) - 0.5
        columns, rows = np.meshgrid(steps, steps)
        behind = np.where(np.isfinite(self.depth), self.depth, np.nan).astype(np.float64)
        width, height, depth = self.extents
        return np.asarray(
            self.center
            + (columns * width)[..., None] * self.right
            - (rows * height)[..., None] * self.up
            + (depth / 2 - behind)[..., None] * self.toward
        )


NOTHING = (28, 30, 48)
"""sRGB of empty pixels: dark blue, which few worlds have."""

GAP = 4
"""Pixels between two views."""


def sheet(views: Sequence[OrthoView | None], size: int) -> NDArray[np.uint8]:
    """Arrange views in a square grid, or with one more column than rows."""
    columns = math.isqrt(len(views) - 1) + 1
    rows, pitch = -(-len(views) // columns), size + GAP
    picture = np.full((rows * pitch - GAP, columns * pitch - GAP, 3), 255, np.uint8)
    for number, view in enumerate(views):
        row, column = (pitch * n for n in divmod(number, columns))
        cell = picture[row : row + size, column : column + size]
        cell[:] = NOTHING
        if view is not None:
            is_shown = np.isfinite(view.depth)
            cell[is_shown] = view.color[is_shown]
    return picture
