"""Random draws, vectors, and sine and cosine without the C library, with the same bits on every platform."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core

Floats = NDArray[np.float64]
_T = TypeVar("_T")
_WORD = (1 << 64) - 1
# Number of values drawn at once, because a call of the generator costs as much as about a thousand values.
_AHEAD = 96


class RandomStream:
    """A stream of random numbers for one object of a scene, named by integers; streams are independent."""

    def __init__(self, seed: int, *name: int) -> None:
        self._seed = seed & _WORD
        cell = 0
        for word in name:
            cell = (cell * 0x9E3779B97F4A7C15 + word + 1) & _WORD
        self._cell = cell
        self._next = self._first = 0
        self._ahead: Floats = np.zeros(0)

    def uniform(self, count: int, low: float = 0.0, high: float = 1.0) -> Floats:
        """Draw `count` float64 numbers in [low, high)."""
        start = self._next - self._first
        if start + count > len(self._ahead):
            index = np.arange(self._next, self._next + max(count, _AHEAD), dtype=np.uint64)
            self._first, start = self._next, 0
            self._ahead = _core.uniform(self._seed, self._cell, index)
        self._next += count
        return low + (high - low) * self._ahead[start : start + count]

    def number(self, low: float = 0.0, high: float = 1.0) -> float:
        """Draw one number in [low, high)."""
        return float(self.uniform(1, low, high)[0])

    def integers(self, count: int, high: int) -> NDArray[np.int64]:
        """Draw `count` integers in [0, high)."""
        return np.minimum((self.uniform(count) * high).astype(np.int64), high - 1)

    def pick(self, options: Sequence[_T]) -> _T:
        return options[int(self.integers(1, len(options))[0])]

    def chance(self, probability: float) -> bool:
        """Draw True with this probability."""
        return self.number() < probability


def turn(fraction: Floats | float) -> tuple[Floats, Floats]:
    """Compute cosine and sine of a fraction of a full turn, by Taylor series on an eighth of it.

    Only additions and multiplications are used, so that the result has the same bits everywhere; the error is below
    1e-13.
    """
    turns = np.asarray(fraction, np.float64)
    quarter = np.floor(4.0 * turns + 0.5)
    angle = (turns - 0.25 * quarter) * 6.283185307179586
    square = angle * angle
    cosine = np.ones_like(square)
    sine = np.ones_like(square)
    for k in range(16, 0, -2):
        cosine = 1.0 - cosine * square / (k * (k - 1.0))
        sine = 1.0 - sine * square / (k * (k + 1.0))
    sine = sine * angle
    sector = quarter.astype(np.int64) % 4
    x = np.choose(sector, [cosine, -sine, -cosine, sine])
    y = np.choose(sector, [sine, cosine, -sine, -cosine])
    return x + 0.0, y + 0.0


def step(low: float, high: float, value: Floats) -> Floats:
    """A smooth step: 0 up to `low`, 1 from `high` on, a cubic in between."""
    fraction = np.clip((value - low) / (high - low), 0.0, 1.0)
    return fraction * fraction * (3.0 - 2.0 * fraction)


def xyz(x: ArrayLike, y: ArrayLike, z: ArrayLike) -> Floats:
    """Make points (K, 3) from coordinates, each (K,) or one number for all."""
    return np.stack(np.broadcast_arrays(x, y, z), -1)


def cross(a: Floats, b: Floats) -> Floats:
    """Cross products of rows, by plain arithmetic."""
    (ax, ay, az), (bx, by, bz) = a.T, b.T
    return xyz(ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx)


def dot(a: Floats, b: Floats) -> Floats:
    """Scalar products along the last axis, by plain arithmetic."""
    return a[..., 0] * b[..., 0] + a[..., 1] * b[..., 1] + a[..., 2] * b[..., 2]


def length(vectors: Floats) -> Floats:
    """Lengths of vectors (…, 3)."""
    return np.sqrt(dot(vectors, vectors))


def unit(vectors: Floats) -> Floats:
    """Vectors (…, 3) scaled to length 1."""
    return vectors / length(vectors)[..., None]
