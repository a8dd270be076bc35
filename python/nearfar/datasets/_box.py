"""Boxes as sources are asked for them."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check


def box(name: str, value: ArrayLike) -> NDArray[np.float64]:
    """Return a box (2, 3), least and greatest corner; sides may be infinite. ValueError, TypeError otherwise."""
    corners = check.array(name, value, columns=None, dtype=np.float64)
    if corners.shape != (2, 3):
        raise ValueError(f"{name}: expected shape (2, 3), a least and a greatest corner, got {corners.shape}")
    if not (corners[0] <= corners[1]).all():
        raise ValueError(f"{name}: expected a least corner that is nowhere above the greatest, got {corners.tolist()}")
    return corners
