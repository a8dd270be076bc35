"""Contact sheet of a cell's views."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from nearfar.orthoview._view import OrthoView

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
        part = picture[row : row + size, column : column + size]
        part[:] = NOTHING
        if view is not None:
            shown = np.isfinite(view.depth)
            part[shown] = view.color[shown]
    return picture
