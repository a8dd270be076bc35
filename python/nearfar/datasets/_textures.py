"""Textures drawn by arithmetic: wood, checks, paintings; sRGB, row 0 on top."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nearfar.datasets._draw import Draw, Floats, turn

Image = NDArray[np.uint8]


def grid(height: int, width: int) -> tuple[Floats, Floats]:
    """Pixel centres, 0..1 to the right and down."""
    y, x = np.meshgrid((np.arange(height) + 0.5) / height, (np.arange(width) + 0.5) / width, indexing="ij")
    return x, y


def image(rgb: Floats) -> Image:
    opaque = np.full((*rgb.shape[:2], 4), 255.0)
    opaque[..., :3] = np.clip(rgb, 0.0, 255.0)
    return np.floor(opaque + 0.5).astype(np.uint8)


def planks(seed: int, rows: int = 8, size: int = 512) -> Image:
    """Floor boards along the picture's width; the texture repeats in both directions."""
    x, y = grid(size, size)
    row = np.floor(y * rows).astype(np.int64)
    draw = Draw(seed, 60)
    start, light, phase = draw.uniform(rows), draw.uniform(2 * rows, 0.86, 1.08), draw.uniform(2 * rows)
    along = (x + start[row]) % 1.0
    board = 2 * row + (along > 0.5)
    inside = (y * rows) % 1.0
    # A whole number of waves along the width makes the texture repeat.
    wave = turn(3.0 * x + phase[board])[1] + 0.5 * turn(7.0 * x + 2.0 * phase[board])[1]
    grain = turn(inside * 2.3 + 0.1 * wave + phase[board])[1]
    fine = turn(inside * 23.0 + 0.5 * wave + 3.0 * phase[board])[1]
    tone = light[board] * (1.0 + 0.045 * grain + 0.02 * fine)
    ends = np.minimum(along % 0.5, 0.5 - along % 0.5)
    gap = (np.minimum(inside, 1.0 - inside) < 0.03) | (ends < 0.0025)
    tone = np.where(gap, 0.5 * tone, tone)
    return image(tone[..., None] * np.array([178.0, 132.0, 88.0]))


def checks(colors: tuple[tuple[float, float, float], ...], size: int = 256, count: int = 8) -> Image:
    """A woven check of two plain colours and the colour of their crossing."""
    x, y = grid(size, size)
    a, b = np.floor(x * count).astype(np.int64) % 2, np.floor(y * count).astype(np.int64) % 2
    weave = 1.0 + 0.05 * turn(x * size / 4.0)[1] * turn(y * size / 4.0)[1]
    return image(np.array(colors)[a + b] * weave[..., None])


def painting(seed: int, number: int, size: int = 192) -> Image:
    """A painted landscape in bands: sky, hills, a sun."""
    draw = Draw(seed, 61, number)
    x, y = grid(size, size)
    low, high = draw.uniform(3, 90.0, 180.0), draw.uniform(3, 190.0, 250.0)
    rgb = low + (high - low) * (1.0 - y)[..., None]
    sun = draw.uniform(2, 0.25, 0.75)
    disc = (x - sun[0]) * (x - sun[0]) + (y - 0.6 * sun[1]) * (y - 0.6 * sun[1]) < 0.008
    rgb = np.where(disc[..., None], [246.0, 214.0, 140.0], rgb)
    for band in range(4):
        color, phase = draw.uniform(3, 40.0, 150.0) * [0.9, 1.0, 0.8], draw.number()
        ridge = 0.45 + 0.13 * band + 0.06 * turn(x * (1.0 + 0.7 * band) + phase)[1]
        rgb = np.where((y > ridge)[..., None], color, rgb)
    return image(rgb)
