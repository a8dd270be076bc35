"""Tiles of ground and water: squares of 64 × 64 cells of a level's grid, with heights, normals and colours."""

from __future__ import annotations

import functools
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nearfar.datasets._random import Floats, step, xyz
from nearfar.datasets._textures import image
from nearfar.datasets._world import climate, lattice, roads, sites
from nearfar.datasets._world.climate import Cover
from nearfar.datasets._world.noise import uniform_hash
from nearfar.datasets._world.relief import natural

COUNT = 64
"""Number of cells along a tile's side."""
TEXTURE = 31.25
"""Side of the tileable ground texture, metres."""
_PIXELS = 256
"""Width and height of that texture."""


@dataclass(frozen=True)
class Tile:
    """A tile of a level: vertices (65, 65), rows along z and columns along x."""

    level: int
    i: int
    j: int
    height: Floats
    """Metres."""
    normal: Floats
    """(65, 65, 3) unit vectors."""
    color: NDArray[np.uint8]
    """(65, 65, 4) sRGB."""
    water: NDArray[np.uint8] | None
    """(65, 65, 4) sRGB of the water's surface; None without water."""

    @property
    def name(self) -> str:
        return f"{self.level}_{self.i}_{self.j}"

    @property
    def corner(self) -> tuple[float, float]:
        """World x and z of the first vertex, metres."""
        side = COUNT * lattice.spacing(self.level)
        return self.i * side, self.j * side


@dataclass(frozen=True)
class Ground:
    """The ground at vertices of a grid, with one more row and column on each side than a tile."""

    x: Floats
    z: Floats
    height: Floats
    """Height in metres before it is fitted to the nested levels."""
    slope: Floats
    normal: Floats
    road: Floats
    """Distance from the nearest road, metres."""
    cover: Cover

    @classmethod
    def generate(cls, seed: int, level: int, i: int, j: int) -> Ground:
        """Make the ground of tile (i, j) of a level."""
        spacing, line = lattice.spacing(level), np.arange(-1, COUNT + 2)
        z, x = np.meshgrid(spacing * (j * COUNT + line), spacing * (i * COUNT + line), indexing="ij")
        box = (float(x[0, 0]), float(x[0, -1]), float(z[0, 0]), float(z[-1, 0]))
        height = raw = natural(seed, x.reshape(-1), z.reshape(-1)).reshape(x.shape)
        road = np.full(x.shape, 1000.0)
        towns: list[sites.Town] = []
        if level <= lattice.SHARED:
            towns = sites.near(seed, box, climate.FARMED * 1.3)
            height = sites.level_ground(towns, x, z, height)
            height, road = roads.level_ground(roads.near(seed, box, roads.REACH), x, z, height, spacing)
            height = np.clip(height, raw - lattice.BUILT, raw + lattice.BUILT)
        dx, dz = np.zeros_like(height), np.zeros_like(height)
        dx[:, 1:-1] = (height[:, 2:] - height[:, :-2]) / (2.0 * spacing)
        dz[1:-1] = (height[2:] - height[:-2]) / (2.0 * spacing)
        slope = np.sqrt(dx * dx + dz * dz)
        length = np.sqrt(1.0 + slope * slope)
        normal = xyz(-dx / length, 1.0 / length, -dz / length)
        return cls(x, z, height, slope, normal, road, climate.cover(seed, towns, x, z, height, slope))


@functools.lru_cache(maxsize=48)
def ground(seed: int, level: int, i: int, j: int) -> Ground:
    """`Ground.generate`, cached for the most recently used tiles."""
    return Ground.generate(seed, level, i, j)


@functools.lru_cache(maxsize=48)
def tile(seed: int, level: int, i: int, j: int) -> Tile:
    """Make tile (i, j) of a level."""
    land, inner = ground(seed, level, i, j), np.s_[1:-1, 1:-1]
    if level > lattice.SHARED:
        height = lattice.natural_heights(seed, level, i * COUNT, (i + 1) * COUNT, j * COUNT, (j + 1) * COUNT)
    else:
        height = _fit_heights(seed, level, i, j, land.height[inner])
    rgb = climate.colors(seed, land.cover, land.x, land.z, land.height, land.slope, land.road)[inner]
    wet = height.min() < 0.0
    water = image(climate.water_colors(seed, land.x[inner], land.z[inner], -height)) if wet else None
    return Tile(level, i, j, height, land.normal[inner], image(rgb), water)


def _fit_heights(seed: int, level: int, i: int, j: int, target: Floats) -> Floats:
    """Heights of a tile in the nested grids, as close to `target` as each level allows."""
    count = 2**level
    coarsest = lattice.shared_heights(seed, i * count, (i + 1) * count, j * count, (j + 1) * count)
    stride = COUNT // count
    change = np.clip(target[::stride, ::stride] - coarsest, -lattice.BUILT, lattice.BUILT)
    height = lattice.round_heights(coarsest + change)
    for finer in range(lattice.SHARED - 1, level - 1, -1):
        stride //= 2
        height = lattice.refine(height, target[::stride, ::stride], finer)
    return height


def foot(seed: int, level: int, x: Floats, z: Floats) -> Floats:
    """Heights in metres of a level's surface at positions (N,), all within one tile."""
    spacing = lattice.spacing(level)
    side = COUNT * spacing
    i, j = int(np.floor(x[0] / side)), int(np.floor(z[0] / side))
    height = tile(seed, level, i, j).height
    u, v = (x - i * side) / spacing, (z - j * side) / spacing
    a, b = np.minimum(np.floor(u).astype(np.int64), COUNT - 1), np.minimum(np.floor(v).astype(np.int64), COUNT - 1)
    u, v = u - a, v - b
    first, last = height[b, a], height[b + 1, a + 1]
    # Cells are split along the diagonal from the first to the last corner.
    right, left = height[b, a + 1], height[b + 1, a]
    lower = first + u * (right - first) + v * (last - right)
    upper = first + v * (left - first) + u * (last - left)
    return np.asarray(np.where(u >= v, lower, upper))


@functools.cache
def grain() -> NDArray[np.uint8]:
    """Make a tileable grey texture (256, 256, 4) of blades and clods, sRGB, which multiplies the ground's colours."""
    total = np.zeros((_PIXELS, _PIXELS))
    for octave, (cells, strength) in enumerate(((8, 8.0), (32, 11.0), (96, 14.0), (256, 15.0))):
        total = total + strength * (_tileable_noise(octave, cells) - 0.5)
    return image((236.0 + total)[..., None])


def _tileable_noise(channel: int, cells: int) -> Floats:
    """Tileable value noise (256, 256) in 0 … 1."""
    position = (np.arange(_PIXELS) + 0.5) * (cells / _PIXELS) - 0.5
    low = np.floor(position)
    weight = step(0.0, 1.0, position - low)
    first, second = low.astype(np.int64) % cells, (low.astype(np.int64) + 1) % cells
    j, i = np.meshgrid(np.arange(cells), np.arange(cells), indexing="ij")
    value = uniform_hash(0, 90 + channel, i, j)
    rows = value[first] + weight[:, None] * (value[second] - value[first])
    return np.asarray(rows[:, first] + weight * (rows[:, second] - rows[:, first]))
