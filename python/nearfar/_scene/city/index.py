"""Spatial index of boxes: a tree of two levels over boxes sorted along a Z curve."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

_BLOCK = 256
"""Number of consecutive boxes in a block."""

_BITS = 10
"""Bits per axis of the curve's cells."""


class BoxIndex:
    """Index of world boxes (N, 2, 3), least and greatest corners; inverted boxes touch nothing."""

    def __init__(self, boxes: NDArray[np.float64]) -> None:
        rows = np.flatnonzero((boxes[:, 0] <= boxes[:, 1]).all(axis=1))
        middle = boxes[rows][:, :, ::2].mean(axis=1)
        low = middle.min(axis=0, initial=np.inf)
        width = np.maximum(middle.max(axis=0, initial=-np.inf) - low, 1e-300)
        cells = ((middle - low) / width * ((1 << _BITS) - 1)).astype(np.int64)
        self._rows = rows[np.argsort(_interleaved(cells), kind="stable")]
        self._boxes = boxes[self._rows]
        blocks = [self._boxes[start : start + _BLOCK] for start in range(0, len(rows), _BLOCK)]
        self._blocks = np.array([(block[:, 0].min(0), block[:, 1].max(0)) for block in blocks]).reshape(-1, 2, 3)

    def touching(self, box: NDArray[np.float64]) -> NDArray[np.int64]:
        """Numbers of the boxes that touch a box (2, 3), borders included, ascending."""
        blocks = np.flatnonzero(_touch(self._blocks, box))
        places = (blocks[:, None] * _BLOCK + np.arange(_BLOCK)).ravel()
        places = places[places < len(self._rows)]
        return np.sort(self._rows[places[_touch(self._boxes[places], box)]])


def _touch(boxes: NDArray[np.float64], box: NDArray[np.float64]) -> NDArray[np.bool_]:
    touches: NDArray[np.bool_] = ((boxes[:, 0] <= box[1]) & (boxes[:, 1] >= box[0])).all(axis=1)
    return touches


def _interleaved(cells: NDArray[np.int64]) -> NDArray[np.int64]:
    """Morton codes of cells (N, 2)."""
    code = np.zeros(len(cells), np.int64)
    for bit in range(_BITS):
        for axis in (0, 1):
            code |= (cells[:, axis] >> bit & 1) << (2 * bit + axis)
    return code
