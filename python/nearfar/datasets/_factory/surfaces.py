"""Textures of the floor and of signs; sRGB, row 0 on top."""

from __future__ import annotations

import numpy as np

from nearfar.datasets._draw import Draw, Floats, turn
from nearfar.datasets._textures import Image, grid, image


def _worn(seed: int, number: int, size: int) -> Floats:
    """Brightness (size, size) around 1 of a worn surface, which repeats in both directions: stains and grain."""
    x, y = grid(size, size)
    draw = Draw(seed, 90, number)
    tone = np.ones((size, size))
    # Whole numbers of waves along both sides make the texture repeat.
    for across, up, strength in ((1, 2, 0.03), (3, -1, 0.03), (4, 5, 0.02), (-7, 6, 0.015), (11, 3, 0.01)):
        bent = across * x + up * y + 0.15 * turn(2.0 * y + draw.number())[1] + draw.number()
        tone = tone + strength * turn(bent)[1]
    return tone * (1.0 + draw.uniform(size * size, -0.035, 0.035).reshape(size, size))


def concrete(seed: int, size: int = 512) -> Image:
    """Ground concrete in slabs: the picture shows four by four."""
    x, y = grid(size, size)
    tone = _worn(seed, 0, size)
    edge = np.minimum(np.minimum(4.0 * x % 1.0, 1.0 - 4.0 * x % 1.0), np.minimum(4.0 * y % 1.0, 1.0 - 4.0 * y % 1.0))
    tone = np.where(edge < 0.008, 0.72 * tone, tone)
    return image(tone[..., None] * np.array([172.0, 170.0, 164.0]))


def lane(seed: int, size: int = 512) -> Image:
    """The painted floor of a lane, with tracks of tyres along both directions."""
    x, y = grid(size, size)
    tone = _worn(seed, 1, size)
    track = np.maximum(turn(4.0 * x)[0], turn(4.0 * y)[0])
    tone = tone * (1.0 - 0.05 * np.clip(track - 0.7, 0.0, 1.0))
    return image(tone[..., None] * np.array([128.0, 146.0, 148.0]))


def line(seed: int, size: int = 256) -> Image:
    """Yellow paint, scuffed."""
    tone = _worn(seed, 2, size)
    scuffed = Draw(seed, 91).uniform(size * size).reshape(size, size) < 0.06
    rgb = np.where(scuffed[..., None], [170.0, 165.0, 140.0], tone[..., None] * np.array([236.0, 190.0, 52.0]))
    return image(rgb)


def stripes(size: int = 128) -> Image:
    """Yellow and black stripes at 45 degrees."""
    x, y = grid(size, size)
    dark = (x + y) % 0.5 < 0.25
    return image(np.where(dark[..., None], [44.0, 44.0, 46.0], [240.0, 194.0, 48.0]))


def board(seed: int, size: int = 256) -> Image:
    """A notice board: sheets of paper with lines of text."""
    x, y = grid(size, size)
    draw = Draw(seed, 92)
    rgb = np.broadcast_to([62.0, 84.0, 110.0], (size, size, 3))
    for k in range(8):
        left, top = 0.04 + 0.24 * (k % 4), 0.06 + 0.47 * (k // 4) + draw.number(0.0, 0.04)
        u, v = (x - left) / 0.2, (y - top) / 0.38
        inside = (u > 0.0) & (u < 1.0) & (v > 0.0) & (v < 1.0)
        text = inside & (u > 0.12) & (u < 0.88) & (v > 0.15) & ((v * 14.0) % 1.0 < 0.4)
        paper = draw.uniform(3, 215.0, 245.0)
        rgb = np.where(text[..., None], [96.0, 98.0, 104.0], np.where(inside[..., None], paper, rgb))
    return image(rgb)
