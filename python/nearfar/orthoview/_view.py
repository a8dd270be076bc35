"""A view of a cell, as trees return it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class OrthoView:
    """A cell seen along parallel rays."""

    color: NDArray[np.uint8]
    """sRGB without light (size, size, 3)."""
    depth: NDArray[np.float32]
    """Metres behind the front of the cell's extent along the view (size, size); infinite where nothing is."""
    normal: NDArray[np.float32]
    """Unit normals towards the viewer, world axes (size, size, 3); NaN where nothing is."""
    surfel: NDArray[np.bool_]
    """Whether a pixel is a piece of a plane (size, size); others are balls."""
    right: NDArray[np.float64]
    """Unit vector along a row."""
    up: NDArray[np.float64]
    """Unit vector against a column."""
    toward: NDArray[np.float64]
    """Unit vector towards the viewer."""
    extents: NDArray[np.float64]
    """Extents of the picture to the right and upwards, and of depths, metres."""
    center: NDArray[np.float64]
    """World position of the cell's centre, metres."""

    def points(self) -> NDArray[np.float64]:
        """World positions (size, size, 3) of the surfaces, metres; NaN where nothing is."""
        place = (np.arange(len(self.depth)) + 0.5) / len(self.depth) - 0.5
        across, down = np.meshgrid(place, place)
        behind = np.where(np.isfinite(self.depth), self.depth, np.nan).astype(np.float64)
        width, height, depth = self.extents
        points: NDArray[np.float64] = (
            self.center
            + (across * width)[..., None] * self.right
            - (down * height)[..., None] * self.up
            + (depth / 2 - behind)[..., None] * self.toward
        )
        return points
