"""Grain of the ground: a tileable grey texture that multiplies the ground's colours."""

from __future__ import annotations

import functools

import numpy as np
from numpy.typing import NDArray

from nearfar.datasets._draw import Floats
from nearfar.datasets._world.noise import hashed

_SIZE = 256


@functools.cache
def grain() -> NDArray[np.uint8]:
    """Make the texture (256, 256, 4), sRGB: blades and clods in the light and in the shade."""
    total = np.zeros((_SIZE, _SIZE))
    for octave, (cells, high) in enumerate(((8, 8.0), (32, 11.0), (96, 14.0), (256, 15.0))):
        total = total + high * (_periodic(octave, cells) - 0.5)
    image = np.full((_SIZE, _SIZE, 4), 255, np.uint8)
    image[..., :3] = np.floor(np.clip(236.0 + total, 0.0, 255.0) + 0.5)[..., None]
    return image


def _periodic(channel: int, cells: int) -> Floats:
    """Tileable value noise (size, size) in 0 … 1."""
    at = (np.arange(_SIZE) + 0.5) * (cells / _SIZE) - 0.5
    low = np.floor(at)
    share = at - low
    share = share * share * (3.0 - 2.0 * share)
    first, second = low.astype(np.int64) % cells, (low.astype(np.int64) + 1) % cells
    j, i = np.meshgrid(np.arange(cells), np.arange(cells), indexing="ij")
    value = hashed(0, 90 + channel, i, j)
    rows = value[first] + share[:, None] * (value[second] - value[first])
    both: Floats = rows[:, first] + share * (rows[:, second] - rows[:, first])
    return both
