"""Gradient noise as a function of seed and position, by additions, multiplications and square roots only."""

from __future__ import annotations

import functools

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar.datasets._draw import Floats, turn

# K. Perlin, An image synthesizer (1985), and Improving noise (2002): gradients on a lattice, joined by a quintic.
_GRADIENTS = np.stack(turn((np.arange(64.0) + 0.5) / 64.0))
_SCALE = 1.4142135623730951
"""Largest value of unscaled noise is 1/√2."""


_BLOCK = 32


def hashed(seed: int, channel: int, i: NDArray[np.int64], j: NDArray[np.int64], draw: int = 0) -> Floats:
    """Numbers in [0, 1) for integer places (i, j) in ±2³¹, in their shape; `draw` numbers several of one place."""
    words = (i.astype(np.uint64) << np.uint64(32)) | (j.astype(np.uint64) & np.uint64(0xFFFFFFFF))
    return _core.uniform(seed, channel * 64 + draw, words.reshape(-1)).reshape(i.shape)


def noise(seed: int, channel: int, x: Floats, z: Floats, length: float) -> Floats:
    """Gradient noise of −1 to 1, mostly within ±0.7, with a feature size of `length` metres."""
    u, v, gx, gz = _corners(seed, channel, x, z, length)
    a = gx[0] * u + gz[0] * v
    b = gx[1] * (u - 1.0) + gz[1] * v
    c = gx[2] * u + gz[2] * (v - 1.0)
    d = gx[3] * (u - 1.0) + gz[3] * (v - 1.0)
    s, t = _fade(u), _fade(v)
    low = a + s * (b - a)
    return _SCALE * (low + t * (c + s * (d - c) - low))


def sloped(seed: int, channel: int, x: Floats, z: Floats, length: float) -> tuple[Floats, Floats, Floats]:
    """`noise` and its derivatives with respect to x / length and z / length."""
    u, v, gx, gz = _corners(seed, channel, x, z, length)
    a = gx[0] * u + gz[0] * v
    b = gx[1] * (u - 1.0) + gz[1] * v
    c = gx[2] * u + gz[2] * (v - 1.0)
    d = gx[3] * (u - 1.0) + gz[3] * (v - 1.0)
    s, t = _fade(u), _fade(v)
    ds, dt = 30.0 * u * u * (u - 1.0) * (u - 1.0), 30.0 * v * v * (v - 1.0) * (v - 1.0)
    low, high = a + s * (b - a), c + s * (d - c)
    mixed = (gx[0] + s * (gx[1] - gx[0]), gx[2] + s * (gx[3] - gx[2]))
    across = mixed[0] + t * (mixed[1] - mixed[0]) + ds * (b - a + t * (d - c - b + a))
    mixed = (gz[0] + s * (gz[1] - gz[0]), gz[2] + s * (gz[3] - gz[2]))
    along = mixed[0] + t * (mixed[1] - mixed[0]) + dt * (high - low)
    return _SCALE * (low + t * (high - low)), _SCALE * across, _SCALE * along


def _fade(t: Floats) -> Floats:
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0)


def _corners(
    seed: int, channel: int, x: Floats, z: Floats, length: float
) -> tuple[Floats, Floats, list[Floats], list[Floats]]:
    """Position within the lattice's cell, and the gradients of its four corners."""
    u, v = x / length, z / length
    fi, fj = np.floor(u), np.floor(v)
    i, j = fi.astype(np.int64), fj.astype(np.int64)
    offsets = ((0, 0), (1, 0), (0, 1), (1, 1))
    i0, j0 = (int(i.min()), int(j.min())) if i.size else (0, 0)
    rows, columns = (int(i.max()) - i0 + 2, int(j.max()) - j0 + 2) if i.size else (2, 2)
    if rows * columns <= 4 * i.size + 64:
        table = _lattice(seed, channel, i0, j0, rows, columns).reshape(-1)
        first = (i - i0) * columns + (j - j0)
        kinds = [table[first + (a * columns + b)] for a, b in offsets]
    else:
        kinds = [_gradient_indices(seed, channel, i + a, j + b) for a, b in offsets]
    return u - fi, v - fj, [_GRADIENTS[0][k] for k in kinds], [_GRADIENTS[1][k] for k in kinds]


def _gradient_indices(seed: int, channel: int, i: NDArray[np.int64], j: NDArray[np.int64]) -> NDArray[np.uint8]:
    """Indices of the gradients at lattice points."""
    return (64.0 * hashed(seed, channel, i, j)).astype(np.uint8)


def _lattice(seed: int, channel: int, i0: int, j0: int, rows: int, columns: int) -> NDArray[np.uint8]:
    """`_drawn` for a rectangle of lattice points, from cached blocks: neighbouring tiles share them."""
    table = np.empty((rows, columns), np.uint8)
    for bi in range(i0 // _BLOCK, (i0 + rows - 1) // _BLOCK + 1):
        for bj in range(j0 // _BLOCK, (j0 + columns - 1) // _BLOCK + 1):
            a, b = max(i0, bi * _BLOCK), min(i0 + rows, (bi + 1) * _BLOCK)
            c, d = max(j0, bj * _BLOCK), min(j0 + columns, (bj + 1) * _BLOCK)
            part = _block(seed, channel, bi, bj)[a - bi * _BLOCK : b - bi * _BLOCK, c - bj * _BLOCK : d - bj * _BLOCK]
            table[a - i0 : b - i0, c - j0 : d - j0] = part
    return table


@functools.lru_cache(maxsize=16_384)
def _block(seed: int, channel: int, bi: int, bj: int) -> NDArray[np.uint8]:
    line = np.arange(_BLOCK)
    i, j = np.meshgrid(bi * _BLOCK + line, bj * _BLOCK + line, indexing="ij")
    return _gradient_indices(seed, channel, i, j)


def step(low: float, high: float, value: Floats) -> Floats:
    """A smooth step: 0 up to `low`, 1 from `high` on, a cubic in between."""
    share = np.clip((value - low) / (high - low), 0.0, 1.0)
    return share * share * (3.0 - 2.0 * share)
