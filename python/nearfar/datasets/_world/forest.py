"""Trees, bushes and rocks: their places on a fine jittered grid, and their shared shapes."""

from __future__ import annotations

import functools
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nearfar.datasets import _vegetation as vegetation
from nearfar.datasets._random import Floats
from nearfar.datasets._shapes import Indexed, weld
from nearfar.datasets._world import lattice, streets, tiles
from nearfar.datasets._world.noise import uniform_hash
from nearfar.datasets._world.sites import near

_ROWS = 40
"""Places along each side of a finest tile: one per 6.25 m."""
SPRUCE, OAK, BUSH, ROCK = 0, 1, 2, 3
NAMES = ("spruce", "oak", "bush", "rock")
_VARIANTS = np.array([4, 5, 2, 3])
"""For each kind: number of its shapes."""
_CLEAR = 3.2
"""Least distance of a trunk from roads, streets and houses, metres."""


@dataclass(frozen=True)
class Plants:
    """Plants of a tile: positions (N,) in metres, kind and variant, size as a factor, turn as a share of a circle."""

    number: NDArray[np.int64]
    x: Floats
    z: Floats
    kind: NDArray[np.int64]
    variant: NDArray[np.int64]
    size: Floats
    turn: Floats
    reach: Floats
    """Greatest distance of a plant's parts from its foot, metres."""


@functools.lru_cache(maxsize=256)
def plants(seed: int, i: int, j: int) -> Plants:
    """Find the plants rooted in tile (i, j) of level 0; they are the same for all levels of detail."""
    side = tiles.COUNT * lattice.SPACING
    lines = np.meshgrid(np.arange(i * _ROWS, (i + 1) * _ROWS), np.arange(j * _ROWS, (j + 1) * _ROWS))
    column, row = (line.reshape(-1).astype(np.int64) for line in lines)
    draws = [uniform_hash(seed, 80, column, row, k) for k in range(7)]
    # Positions are multiples of 1/64 m, which float32 represents exactly.
    x = np.floor(64.0 * side / _ROWS * (column + 0.06 + 0.88 * draws[0])) / 64.0
    z = np.floor(64.0 * side / _ROWS * (row + 0.06 + 0.88 * draws[1])) / 64.0
    ground = tiles.ground(seed, 0, i, j)
    a = np.floor((x - i * side) / lattice.SPACING + 0.5).astype(np.int64) + 1
    b = np.floor((z - j * side) / lattice.SPACING + 0.5).astype(np.int64) + 1
    forest, cover = ground.cover.forest[b, a], ground.cover
    slope, height = ground.slope[b, a], ground.height[b, a]
    open_ = (cover.field[b, a] < 0) & (cover.town[b, a] <= 0.0) & (height > 1.5)
    chance = np.maximum(0.86 * forest, np.where(cover.hedge[b, a], 0.42, 0.0))
    chance = np.maximum(chance, np.where(open_ & (cover.cold[b, a] < 0.66) & (slope < 0.9), 0.012, 0.0))
    chance = np.maximum(chance, 0.16 * cover.town[b, a])
    is_tree = draws[2] < chance
    is_bush = ~is_tree & (draws[2] > 0.93) & (forest > 0.02) & (height > 2.0)
    is_rock = (
        ~is_tree & (draws[2] > 0.985 - 0.06 * (slope > 0.55)) & open_ & ((slope > 0.35) | (cover.cold[b, a] > 0.6))
    )
    conifer = draws[3] < np.where(forest > 0.0, cover.conifers[b, a], 0.1)
    kind = np.where(is_tree, np.where(conifer, SPRUCE, OAK), np.where(is_bush, BUSH, ROCK))
    low, spread = np.array(SIZES).T
    size = low[kind] + spread[kind] * draws[4]
    size = np.where(is_tree, size * (1.0 - 0.45 * np.clip(cover.cold[b, a], 0.0, 0.8)), size)
    variant = np.minimum((draws[5] * _VARIANTS[kind]).astype(np.int64), _VARIANTS[kind] - 1)
    keep = (is_tree | is_bush | is_rock) & (ground.road[b, a] > 3.5 + _CLEAR + 2.8)
    box = (i * side, (i + 1) * side, j * side, (j + 1) * side)
    rows = np.flatnonzero(keep)
    for town in near(seed, box, 10.0):
        rows = rows[streets.layout(seed, town).free(x[rows], z[rows], _CLEAR)]
    kind, size = kind[rows], size[rows]
    return Plants(rows, x[rows], z[rows], kind, variant[rows], size, draws[6][rows], np.array(REACHES)[kind] * size)


_MAKERS = (vegetation.conifer, vegetation.broadleaf, vegetation.shrub, vegetation.rock)
COARSER = ((1.4, 1.6), (1.9, 1.9), (1.2, 1.2), (0.25, 0.25))
"""For each kind, at size 1: greatest distances, metres, of the shapes at detail 1 and at 0 from that at detail 2."""
REACHES = (15.6, 10.2, 2.3, 1.3)
"""For each kind, at size 1: greatest distance of its parts from its foot, metres."""
SIZES = ((0.7, 0.75), (0.8, 0.75), (0.8, 0.9), (0.4, 1.6))
"""For each kind: least size as a factor, and the range above it."""


@functools.lru_cache(maxsize=128)
def shape(seed: int, kind: int, variant: int, detail: int) -> Indexed:
    """The shape of a kind's variant at detail 0 … 2, its foot slightly below y = 0."""
    return weld(_MAKERS[kind](seed, variant, detail))
