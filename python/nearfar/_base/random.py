"""Random numbers as a pure function of (seed, cell, index), equal in Rust and Python and on every platform.

NumPy's generators are not used: their streams depend on the order of draws and may change between versions.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check

_WORD = 2**64 - 1


def uniform(seed: int, cell: int, index: ArrayLike) -> NDArray[np.float64]:
    """Draw a float64 in [0, 1) for each index, integers of any shape.

    `seed` is the number of the scene or experiment, and `cell` the number of the random quantity, both 0 to 2⁶⁴ − 1.
    Different quantities of a seed are independent.
    """
    indices = check.array("index", index, columns=None, dtype=np.uint64)
    seed, cell = check.integer("seed", seed, 0, _WORD), check.integer("cell", cell, 0, _WORD)
    return _core.uniform(seed, cell, indices.reshape(-1)).reshape(indices.shape)


def integers(seed: int, cell: int, index: ArrayLike, low: int, high: int) -> NDArray[np.int64]:
    """Draw a whole number in [low, high) for each index; see `uniform` for `seed`, `cell` and `index`.

    high − low is at most 2³², so that the relative bias of the multiplication stays below 2⁻²¹.
    """
    low = check.integer("low", low, -(2**62), 2**62)
    high = check.integer("high", high, low + 1, low + 2**32)
    return low + np.floor(uniform(seed, cell, index) * (high - low)).astype(np.int64)
