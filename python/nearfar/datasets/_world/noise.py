"""Gradient noise as a function of seed and position, by additions, multiplications and square roots only."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar.datasets._random import Floats, turn

Number = TypeVar("Number", bound=np.generic)

# K. Perlin, An image synthesizer (1985), and Improving noise (2002): gradients on a lattice, joined by a quintic.
_GRADIENTS = np.stack(turn((np.arange(64.0) + 0.5) / 64.0))
_SCALE = 1.4142135623730951
"""Factor of the noise, whose greatest unscaled value is 1/√2."""
_BLOCK = 32
"""Number of lattice points along each side of a cached block."""


def uniform_hash(seed: int, channel: int, i: NDArray[np.int64], j: NDArray[np.int64], draw: int = 0) -> Floats:
    """Hash integer places (i, j) within ±2³¹ to numbers in [0, 1); each `draw` gives other numbers."""
    words = (i.astype(np.uint64) << np.uint64(32)) | (j.astype(np.uint64) & np.uint64(0xFFFFFFFF))
    return _core.uniform(seed, channel * 64 + draw, words.reshape(-1)).reshape(i.shape)


def noise(seed: int, channel: int, x: Floats, z: Floats, length: float) -> Floats:
    """Gradient noise of −1 to 1, mostly within ±0.7, with a feature size of `length` metres."""
    u, v, _, _, (a, b, c, d) = _corners(seed, channel, x, z, length)
    s, t = _fade(u), _fade(v)
    low = a + s * (b - a)
    return _SCALE * (low + t * (c + s * (d - c) - low))


def noise_with_slopes(seed: int, channel: int, x: Floats, z: Floats, length: float) -> tuple[Floats, Floats, Floats]:
    """`noise` and its derivatives with respect to x / length and z / length."""
    u, v, gx, gz, (a, b, c, d) = _corners(seed, channel, x, z, length)
    s, t = _fade(u), _fade(v)
    ds, dt = 30.0 * u * u * (u - 1.0) * (u - 1.0), 30.0 * v * v * (v - 1.0) * (v - 1.0)
    low, high = a + s * (b - a), c + s * (d - c)
    # The gradients, interpolated along x at both sides of the cell and then along z.
    (x0, x1), (z0, z1) = ((g[0] + s * (g[1] - g[0]), g[2] + s * (g[3] - g[2])) for g in (gx, gz))
    slope_x = x0 + t * (x1 - x0) + ds * (b - a + t * (d - c - b + a))
    slope_z = z0 + t * (z1 - z0) + dt * (high - low)
    return _SCALE * (low + t * (high - low)), _SCALE * slope_x, _SCALE * slope_z


def _fade(t: Floats) -> Floats:
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0)


def _corners(
    seed: int, channel: int, x: Floats, z: Floats, length: float
) -> tuple[Floats, Floats, list[Floats], list[Floats], list[Floats]]:
    """Position in the lattice's cell; for its four corners: x and z of the gradients, and the gradients' values."""
    u, v = x / length, z / length
    fi, fj = np.floor(u), np.floor(v)
    i, j, u, v = fi.astype(np.int64), fj.astype(np.int64), u - fi, v - fj
    offsets = ((0, 0), (1, 0), (0, 1), (1, 1))
    i0, j0 = (int(i.min()), int(j.min())) if i.size else (0, 0)
    rows, columns = (int(i.max()) - i0 + 2, int(j.max()) - j0 + 2) if i.size else (2, 2)
    if rows * columns <= 4 * i.size + 64:
        # Blocks are cached: neighbouring tiles share them.
        cached = functools.partial(_block, seed, channel)
        table = assemble_blocks(cached, _BLOCK, (i0, i0 + rows - 1), (j0, j0 + columns - 1)).reshape(-1)
        first = (i - i0) * columns + (j - j0)
        indices = [table[first + (a * columns + b)] for a, b in offsets]
    else:
        indices = [_gradient_indices(seed, channel, i + a, j + b) for a, b in offsets]
    gx, gz = ([axis[index] for index in indices] for axis in _GRADIENTS)
    return u, v, gx, gz, [gx[k] * (u - a) + gz[k] * (v - b) for k, (a, b) in enumerate(offsets)]


def _gradient_indices(seed: int, channel: int, i: NDArray[np.int64], j: NDArray[np.int64]) -> NDArray[np.uint8]:
    """Indices of the gradients at lattice points."""
    return (64.0 * uniform_hash(seed, channel, i, j)).astype(np.uint8)


def assemble_blocks(
    block: Callable[[int, int], NDArray[Number]], side: int, rows: tuple[int, int], columns: tuple[int, int]
) -> NDArray[Number]:
    """Assemble a rectangle of an endless table from square blocks; `rows` and `columns` are its first and last ones."""
    (r0, r1), (c0, c1) = ([end // side for end in ends] for ends in (rows, columns))
    table = np.concatenate([np.concatenate([block(r, c) for c in range(c0, c1 + 1)], 1) for r in range(r0, r1 + 1)])
    return table[rows[0] - r0 * side : rows[1] - r0 * side + 1, columns[0] - c0 * side : columns[1] - c0 * side + 1]


@functools.lru_cache(maxsize=16_384)
def _block(seed: int, channel: int, bi: int, bj: int) -> NDArray[np.uint8]:
    line = np.arange(_BLOCK)
    i, j = np.meshgrid(bi * _BLOCK + line, bj * _BLOCK + line, indexing="ij")
    return _gradient_indices(seed, channel, i, j)
