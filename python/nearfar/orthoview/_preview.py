"""Pictures of a cell's views beside each other."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from nearfar.orthoview._view import OrthoView

NOTHING = (28, 30, 48)
"""sRGB where nothing is seen: dark blue, which few worlds have."""

GAP = 4
"""Pixels between two views."""


def sheet(views: Sequence[OrthoView | None], size: int) -> NDArray[np.uint8]:
    """Views in rows; as many in a row as rows, or one more."""
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
