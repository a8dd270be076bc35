"""The ground: one sheet from the carriageways to the hills at the horizon, and the markings on the streets."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nearfar.datasets._layout import KERB, PAVEMENT, YARD, Grid
from nearfar.datasets._palette import material, materials
from nearfar.datasets._random import Floats, RandomStream, step, turn, xyz
from nearfar.datasets._shapes import Soup, boxes, join, lathe, quads, sheet

# Classes of the strips between two break lines of an axis.
_OUT, _ROAD, _EDGE, _WALK, _ROW, _COURT = range(6)
_RIM = 3.0
"""Width of the pavement around the city, metres."""
FLAT = 260.0
"""Distance from the city within which the land is level, metres."""


def _breaks(grid: Grid, axis: int, detail: int) -> tuple[Floats, NDArray[np.int64], NDArray[np.int64]]:
    """Break lines of an axis in metres, and class and number (street or block) of each strip between them."""
    middles = grid.x if axis == 0 else grid.z
    lines: list[float] = []
    classes: list[tuple[int, int]] = []
    edge, yards = (0.22, axis == 1) if detail >= 1 else (0.0, False)

    def strip(end: float, kind: int, number: int) -> None:
        if end > lines[-1]:
            lines.append(end)
            classes.append((kind, number))

    # Distances in metres of break lines from the city's rim, increasingly wide.
    growth = np.arange(1, (5, 14, 34, 40)[detail] + 1) / (5, 14, 34, 40)[detail]
    outer = np.round(9000.0 * growth * growth * growth + 200.0 * growth, 1).tolist()
    start = float(middles[0] - grid.half(0) - _RIM)
    lines.append(start - outer[-1])
    for distance in (*outer[-2::-1], 0.0):
        strip(start - distance, _OUT, -1)
    for k in range(grid.blocks + 1):
        road0, road1 = float(middles[k] - grid.half(k)), float(middles[k] + grid.half(k))
        if k == 0:
            strip(road0 - edge, _WALK, -1)
        strip(road0, _EDGE, -1)
        strip(road1, _ROAD, k)
        strip(road1 + edge, _EDGE, -1)
        if k == grid.blocks:
            strip(road1 + _RIM, _WALK, -1)
            break
        low, high = road1 + PAVEMENT, float(middles[k + 1] - grid.half(k + 1)) - PAVEMENT
        strip(low, _WALK, k)
        if yards:
            strip(0.5 * (low + high - YARD), _ROW, k)
            strip(0.5 * (low + high + YARD), _COURT, k)
        strip(high, _ROW, k)
        strip(high + PAVEMENT - edge, _WALK, k)
    end = lines[-1]
    for distance in outer:
        strip(end + distance, _OUT, -1)
    kinds = np.array(classes)
    return np.array(lines), kinds[:, 0], kinds[:, 1]


def hill(grid: Grid, x: Floats, z: Floats, seed: int) -> Floats:
    """Height of the land in metres: level around the city, hills beyond."""
    dx, dz = (
        np.maximum(np.abs(values - 0.5 * (lines[0] + lines[-1])) - 0.5 * (lines[-1] - lines[0]), 0.0)
        for values, lines in ((x, grid.x), (z, grid.z))
    )
    phase = RandomStream(seed, 20).uniform(6)
    waves = np.zeros_like(x)
    for k, (a, b) in enumerate(((1.0, 0.6), (-0.7, 1.1), (1.7, -1.3))):
        waves += turn((a * x + b * z) / (3700.0 - 700.0 * k) + phase[k])[1]
    return step(FLAT, FLAT + 5000.0, np.sqrt(dx * dx + dz * dz)) * (210.0 + 85.0 * waves)


def ground(grid: Grid, seed: int, detail: int) -> Soup:
    """Build the sheet with its kerbs; neighbouring cells share their edges."""
    xs, x_class, x_number = _breaks(grid, 0, detail)
    zs, z_class, z_number = _breaks(grid, 1, detail)
    kinds, is_raised = _kinds(grid, x_class, x_number, z_class, z_number, _fields(xs, zs, seed), seed)
    level = np.where(is_raised, KERB, 0.0)
    gx, gz = np.meshgrid(xs, zs)
    tops = sheet(xyz(gx, hill(grid, gx, gz, seed), gz))
    tops[..., 1] += level[..., None]
    soups = [quads(tops.reshape(-1, 4, 3), kinds.reshape(-1))]
    # A kerb lies between two cells of different height and faces the lower one.
    east = _walls(tops[:, :-1, [2, 1]], tops[:, 1:, [3, 0]], level[:, :-1], level[:, 1:])
    south = _walls(tops[:-1, :, [1, 0]], tops[1:, :, [2, 3]], level[:-1], level[1:])
    return join([*soups, east, south])


def _walls(first: Floats, second: Floats, low: Floats, high: Floats) -> Soup:
    """Vertical faces between the same edge of two cells."""
    differs = low != high
    a, b = first[differs], second[differs]
    return quads(np.stack([a[:, 0], a[:, 1], b[:, 1], b[:, 0]], 1), "kerb")


_FIELDS = materials("meadow", "lawn", "meadow_dry", "meadow", "field", "hill")


def _fields(xs: Floats, zs: Floats, seed: int) -> NDArray[np.int64]:
    """Material of each cell (z, x) of farmland: fields of about 200 m, independent of the break lines."""
    column = np.floor(0.5 * (xs[1:] + xs[:-1]) / 210.0).astype(np.int64)
    row = np.floor(0.5 * (zs[1:] + zs[:-1]) / 160.0).astype(np.int64)
    table = RandomStream(seed, 21).integers(128 * 128, len(_FIELDS)).reshape(128, 128)
    return table[row[:, None] % 128, column[None, :] % 128]


def _kinds(
    grid: Grid, x_class: NDArray[np.int64], x_number: NDArray[np.int64], z_class: NDArray[np.int64],
    z_number: NDArray[np.int64], fields: NDArray[np.int64], seed: int,
) -> tuple[NDArray[np.int32], NDArray[np.bool_]]:  # fmt: skip
    """Material of every cell (z, x), and whether it is raised."""
    cx, cz = np.meshgrid(x_class, z_class)
    nx, nz = np.meshgrid(x_number, z_number)
    inside_x, inside_z = cx != _OUT, cz != _OUT
    road = ((cx == _ROAD) & (inside_z | (nx == grid.avenue))) | ((cz == _ROAD) & (inside_x | (nz == grid.avenue)))
    town = inside_x & inside_z
    raised = town & ~road
    kinds = np.array(_FIELDS, np.int32)[fields]
    # The first strips around the city are lawn, like parts of it.
    (x0, *_, x1), (z0, *_, z1) = (np.flatnonzero(strips != _OUT) for strips in (x_class, z_class))
    kinds[max(0, z0 - 3) : z1 + 4, max(0, x0 - 3) : x1 + 4] = material("lawn")
    interior = raised & np.isin(cx, (_ROW, _COURT)) & np.isin(cz, (_ROW, _COURT))
    blocks = [_surface(grid.use(i, j, seed), seed, i, j) for i, j in grid.numbers()]
    kinds[raised] = material("paving")
    is_court = (cz[interior] == _COURT).astype(np.int64)
    kinds[interior] = np.array(blocks)[nz[interior] * grid.blocks + nx[interior], is_court]
    kinds[raised & ((cx == _EDGE) | (cz == _EDGE))] = material("kerb")
    kinds[road] = material("asphalt")
    return kinds, raised


def _surface(use: str, seed: int, i: int, j: int) -> tuple[int, int]:
    """Ground under a block's rows and in its courtyard."""
    if use == "park":
        return material("lawn"), material("lawn")
    if use == "towers":
        plaza = material("plaza" if RandomStream(seed, 22, i, j).chance(0.5) else "paving_warm")
        return plaza, plaza
    return material("yard"), material("lawn" if RandomStream(seed, 22, i, j).chance(0.6) else "yard")


# Lower and upper height of paint relative to the asphalt, metres; slabs reach below the surface.
_PAINT = (-0.03, 0.006)


def _stripes(low: Floats, high: Floats) -> Soup:
    """Make slabs of paint between corners (K, 2) in x and z."""
    bottom, top = xyz(low[:, 0], _PAINT[0], low[:, 1]), xyz(high[:, 0], _PAINT[1], high[:, 1])
    return boxes(bottom, top, "paint_white", without="-y")


def zebra(half: float) -> Soup:
    """A crossing over a street along z, whose junction ends at z = 0, with the stop line of the lane that enters."""
    count = int((2.0 * half - 0.8) // 1.0)
    low = np.stack([np.arange(count) - 0.5 * count + 0.25, np.full(count, 1.0)], -1)
    high = np.concatenate([np.add(low, [0.5, 3.2]), [[-0.2, 5.6]]])
    return _stripes(np.concatenate([low, [[-half + 0.4, 5.2]]]), high)


def lane_lines(length: float, half: float) -> Soup:
    """Lane lines of a street along z, from z = 0 to its length, between two junctions."""
    first, last = 6.2, length - 6.2
    dashes = np.arange(first, last - 3.0, 6.0)
    center = np.array([[-0.07, first]]) if half < 7.0 else np.array([[-0.22, first], [0.1, first]])
    low, high = [center], [np.add(center, [0.12, last - first])]
    for x in () if half < 7.0 else (-3.1, 3.1):
        start = np.stack([np.full(len(dashes), x - 0.06), dashes], -1)
        low.append(start)
        high.append(np.add(start, [0.12, 3.0]))
    bays = np.arange(12.0, length - 11.9, 6.0)
    for side in (-1.0, 1.0):
        edge = side * (half - 2.3)
        start = np.stack([np.full(len(bays), min(edge, edge + side * 2.2)), bays - 0.05], -1)
        low.append(start)
        high.append(np.add(start, [2.2, 0.1]))
    return _stripes(np.concatenate(low), np.concatenate(high))


def paths(x0: float, x1: float, z0: float, z1: float) -> Soup:
    """Gravel paths of a park and a round place in the middle, all slightly above the lawn."""
    x, z, wide = 0.5 * (x0 + x1), 0.5 * (z0 + z1), 1.4
    low = [[x0, z - wide], [x - wide, z0], [x - wide, z + wide], [x + wide, z - wide], [x - wide, z - wide]]
    high = [[x - wide, z + wide], [x + wide, z - wide], [x + wide, z1], [x1, z + wide], [x + wide, z + wide]]
    corners = np.array([[[a, KERB + 0.03, d], [c, KERB + 0.03, d], [c, KERB + 0.03, b], [a, KERB + 0.03, b]]
                        for (a, b), (c, d) in zip(low, high, strict=True)])  # fmt: skip
    place = lathe([(7.5, KERB - 0.1), (7.5, KERB + 0.05)], 40, "gravel", bottom=False)
    return join([quads(corners, "gravel"), place.translate([x, 0.0, z])])
