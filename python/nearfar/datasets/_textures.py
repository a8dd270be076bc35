"""Textures drawn by arithmetic: wood, checks, paintings, and a factory's floor and signs; sRGB, row 0 on top."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nearfar.datasets._random import Floats, RandomStream, turn

Image = NDArray[np.uint8]


def grid(height: int, width: int) -> tuple[Floats, Floats]:
    """Pixel centres, 0..1 to the right and down."""
    y, x = np.meshgrid((np.arange(height) + 0.5) / height, (np.arange(width) + 0.5) / width, indexing="ij")
    return x, y


def image(rgb: Floats) -> Image:
    """Round colours (…, 3) from 0 … 255 to opaque RGBA; greys (…, 1) as well."""
    opaque = np.full((*rgb.shape[:-1], 4), 255, np.uint8)
    opaque[..., :3] = np.floor(np.clip(rgb, 0.0, 255.0) + 0.5)
    return opaque


def planks(seed: int, rows: int = 8, size: int = 512) -> Image:
    """Floor boards along the picture's width; the texture repeats in both directions."""
    x, y = grid(size, size)
    row = np.floor(y * rows).astype(np.int64)
    random = RandomStream(seed, 60)
    start, light, phase = random.uniform(rows), random.uniform(2 * rows, 0.86, 1.08), random.uniform(2 * rows)
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
    random = RandomStream(seed, 61, number)
    x, y = grid(size, size)
    low, high = random.uniform(3, 90.0, 180.0), random.uniform(3, 190.0, 250.0)
    rgb = low + (high - low) * (1.0 - y)[..., None]
    sun = random.uniform(2, 0.25, 0.75)
    disc = (x - sun[0]) * (x - sun[0]) + (y - 0.6 * sun[1]) * (y - 0.6 * sun[1]) < 0.008
    rgb = np.where(disc[..., None], [246.0, 214.0, 140.0], rgb)
    for band in range(4):
        color, phase = random.uniform(3, 40.0, 150.0) * [0.9, 1.0, 0.8], random.number()
        ridge = 0.45 + 0.13 * band + 0.06 * turn(x * (1.0 + 0.7 * band) + phase)[1]
        rgb = np.where((y > ridge)[..., None], color, rgb)
    return image(rgb)


def _wear(seed: int, number: int, size: int) -> Floats:
    """Brightness (size, size) around 1 of a worn surface, which repeats in both directions: stains and grain."""
    x, y = grid(size, size)
    random = RandomStream(seed, 90, number)
    tone = np.ones((size, size))
    # Whole numbers of waves along both sides make the texture repeat.
    for across, up, strength in ((1, 2, 0.03), (3, -1, 0.03), (4, 5, 0.02), (-7, 6, 0.015), (11, 3, 0.01)):
        bent = across * x + up * y + 0.15 * turn(2.0 * y + random.number())[1] + random.number()
        tone = tone + strength * turn(bent)[1]
    return tone * (1.0 + random.uniform(size * size, -0.035, 0.035).reshape(size, size))


def concrete(seed: int, size: int = 512) -> Image:
    """Ground concrete in slabs: the picture shows four by four."""
    x, y = grid(size, size)
    tone = _wear(seed, 0, size)
    edge = np.minimum(np.minimum(4.0 * x % 1.0, 1.0 - 4.0 * x % 1.0), np.minimum(4.0 * y % 1.0, 1.0 - 4.0 * y % 1.0))
    tone = np.where(edge < 0.008, 0.72 * tone, tone)
    return image(tone[..., None] * np.array([172.0, 170.0, 164.0]))


def lane(seed: int, size: int = 512) -> Image:
    """The painted floor of a lane, with tracks of tyres along both directions."""
    x, y = grid(size, size)
    tone = _wear(seed, 1, size)
    track = np.maximum(turn(4.0 * x)[0], turn(4.0 * y)[0])
    tone = tone * (1.0 - 0.05 * np.clip(track - 0.7, 0.0, 1.0))
    return image(tone[..., None] * np.array([128.0, 146.0, 148.0]))


def lane_line(seed: int, size: int = 256) -> Image:
    """Yellow paint, scuffed."""
    tone = _wear(seed, 2, size)
    is_scuffed = RandomStream(seed, 91).uniform(size * size).reshape(size, size) < 0.06
    rgb = tone[..., None] * np.array([236.0, 190.0, 52.0])
    return image(np.where(is_scuffed[..., None], [170.0, 165.0, 140.0], rgb))


def stripes(size: int = 128) -> Image:
    """Yellow and black stripes at 45 degrees."""
    x, y = grid(size, size)
    return image(np.where(((x + y) % 0.5 < 0.25)[..., None], [44.0, 44.0, 46.0], [240.0, 194.0, 48.0]))


def notices(seed: int, size: int = 256) -> Image:
    """A notice board: sheets of paper with lines of text."""
    x, y = grid(size, size)
    random = RandomStream(seed, 92)
    rgb = np.broadcast_to([62.0, 84.0, 110.0], (size, size, 3))
    for k in range(8):
        left, top = 0.04 + 0.24 * (k % 4), 0.06 + 0.47 * (k // 4) + random.number(0.0, 0.04)
        u, v = (x - left) / 0.2, (y - top) / 0.38
        inside = (u > 0.0) & (u < 1.0) & (v > 0.0) & (v < 1.0)
        text = inside & (u > 0.12) & (u < 0.88) & (v > 0.15) & ((v * 14.0) % 1.0 < 0.4)
        paper = random.uniform(3, 215.0, 245.0)
        rgb = np.where(text[..., None], [96.0, 98.0, 104.0], np.where(inside[..., None], paper, rgb))
    return image(rgb)
