"""Random numbers as a pure function of (seed, cell, index), equal in Rust and Python and on every platform.

NumPy's generators are not used: their streams depend on the order of draws and may change between versions.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check

_WORD = 2**64 - 1


def uniform(seed: int, cell: int, index: ArrayLike) -> NDArray[np.float64]:
    """Draw a float64 in [0, 1) for each index of a draw, integers of any shape.

    `seed` is the number of the scene or experiment, `cell` that of the random quantity, both 0 to 2⁶⁴ − 1; different
    quantities of a seed are independent.
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


def choice(
    seed: int, cell: int, index: ArrayLike, options: Sequence[Any] | NDArray[Any], *, weights: ArrayLike | None = None
) -> NDArray[Any]:
    """Draw one of `options`, along their first axis, for each index; see `uniform` for `seed`, `cell` and `index`.

    `weights` are the relative probabilities of the options, at least 0; None makes all equal. The result has the shape
    of `index`, followed by the shape of one option.
    """
    choices = check.plain("options", options)
    if choices.ndim == 0 or len(choices) == 0:
        raise ValueError(f"options: expected at least one, got shape {choices.shape}")
    if weights is None:
        return np.asarray(choices[integers(seed, cell, index, 0, len(choices))])
    odds = check.array("weights", weights, columns=None, dtype=np.float64, finite=True)
    if odds.shape != (len(choices),) or odds.min() < 0.0 or odds.sum() <= 0.0:
        raise ValueError(f"weights: expected {len(choices)} numbers of at least 0 and not all 0, got {odds.tolist()}")
    edges = np.cumsum(odds)
    numbers = np.searchsorted(edges, uniform(seed, cell, index) * edges[-1], side="right")
    return np.asarray(choices[np.minimum(numbers, np.flatnonzero(odds)[-1])])
