"""Grids of all levels of detail, nested so that the error of each is bounded by construction.

A vertex that a finer grid adds lies on the middle of an edge of the coarser one, moved up or down by at most `STEPS` of
its level. Both grids split their squares along the same diagonal, so that the finer surface subdivides the coarser one,
and the vertical distance between two levels is at most the sum of the steps between them.
"""

from __future__ import annotations

import functools

import numpy as np

from nearfar.datasets._random import Floats
from nearfar.datasets._world.noise import assemble_blocks
from nearfar.datasets._world.relief import natural

SPACING = 3.90625
"""Spacing of the finest grid, metres: 1/64 of 250 m, and exact in float32."""
SHARED, TOP = 6, 12
"""Coarsest level with towns and roads (250 m), and coarsest level of all (16 km)."""
STEPS = tuple(2.0**level for level in range(TOP))
"""Greatest displacement of the vertices that level k adds to level k + 1, metres."""
BUILT = 40.0
"""Greatest displacement of the ground by towns and roads, metres."""
UNIT = 1.0 / 64.0
"""Quantum of heights, metres."""
_BLOCK = 16
"""Number of vertices along each side of a cached block."""


def error(level: int) -> float:
    """Greatest vertical distance in metres between the surfaces of a level and of level 0."""
    built = BUILT + 0.5 * UNIT if level > SHARED else 0.0
    return sum(step + 0.5 * UNIT for step in STEPS[:level]) + built


def spacing(level: int) -> float:
    """Spacing of a level's grid, metres."""
    return SPACING * 2.0**level


def round_heights(heights: Floats) -> Floats:
    """Round heights to multiples of `UNIT`."""
    return np.floor(heights / UNIT + 0.5) * UNIT


def refine(coarse: Floats, target: Floats, level: int) -> Floats:
    """Refine heights (R, C) to (2R − 1, 2C − 1) of the next finer level, as close to `target` as `STEPS` allows."""
    middle = np.empty((2 * coarse.shape[0] - 1, 2 * coarse.shape[1] - 1))
    middle[::2, ::2] = coarse
    middle[1::2, ::2] = 0.5 * (coarse[:-1] + coarse[1:])
    middle[::2, 1::2] = 0.5 * (coarse[:, :-1] + coarse[:, 1:])
    middle[1::2, 1::2] = 0.5 * (coarse[:-1, :-1] + coarse[1:, 1:])
    fine = round_heights(middle + np.clip(target - middle, -STEPS[level], STEPS[level]))
    fine[::2, ::2] = coarse
    return fine


def natural_heights(seed: int, level: int, i0: int, i1: int, j0: int, j1: int) -> Floats:
    """Heights without towns and roads, at vertices j0 … j1 (rows) and i0 … i1 (columns) of a level from `SHARED` up."""
    z, x = np.meshgrid(spacing(level) * np.arange(j0, j1 + 1), spacing(level) * np.arange(i0, i1 + 1), indexing="ij")
    target = natural(seed, x.reshape(-1), z.reshape(-1)).reshape(x.shape)
    if level == TOP:
        return round_heights(target)
    a, b, c, d = i0 >> 1, (i1 + 1) >> 1, j0 >> 1, (j1 + 1) >> 1
    wide = np.zeros((2 * (d - c) + 1, 2 * (b - a) + 1))
    rows, columns = slice(j0 - 2 * c, j1 - 2 * c + 1), slice(i0 - 2 * a, i1 - 2 * a + 1)
    wide[rows, columns] = target
    return refine(natural_heights(seed, level + 1, a, b, c, d), wide, level)[rows, columns]


def shared_heights(seed: int, i0: int, i1: int, j0: int, j1: int) -> Floats:
    """`natural_heights` for the level `SHARED`, from cached blocks."""
    return assemble_blocks(functools.partial(_cached_block, seed), _BLOCK, (j0, j1), (i0, i1))


@functools.lru_cache(maxsize=512)
def _cached_block(seed: int, j: int, i: int) -> Floats:
    return natural_heights(seed, SHARED, i * _BLOCK, (i + 1) * _BLOCK - 1, j * _BLOCK, (j + 1) * _BLOCK - 1)
