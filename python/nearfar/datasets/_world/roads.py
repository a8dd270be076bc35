"""Roads between neighbouring towns: a least-cost path over the land, smoothed, and the ground levelled below it."""

from __future__ import annotations

import functools
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nearfar.datasets._random import Floats, step
from nearfar.datasets._world import sites
from nearfar.datasets._world.relief import natural
from nearfar.datasets._world.sites import Town, town

HALF = 3.5
"""Half the width of a road, metres."""
BED, SHOULDER = 0.3, 10.0
"""The ground lies `BED` metres below a road's surface up to `SHOULDER` metres from its centre line."""
REACH = 46.0
"""Distance from the centre line beyond which the ground is natural, metres."""
CLEARANCE = 3.4
"""Least height of a road above water, metres."""
_STRAIGHT = 120.0
_STATION, _LANE, _LANES = 64.0, 42.0, 7
_PIECE = 8.0
_MAX_WATER, _STEEPEST = 6, 0.24
"""Greatest number of consecutive stations over water, and greatest slope: towns that need more get no road."""


@dataclass(frozen=True, eq=False)
class Road:
    """A road as its centre line (N, 3), world metres, with about 8 m between points."""

    name: str
    line: Floats
    bridge: NDArray[np.bool_]
    """Whether each point is over water (N,)."""
    box: tuple[float, float, float, float]

    def touches(self, x0: float, x1: float, z0: float, z1: float) -> bool:
        """Whether the road's bounds, seen from above, touch a rectangle."""
        a, b, c, d = self.box
        return a <= x1 and b >= x0 and c <= z1 and d >= z0

    def sides(self) -> tuple[Floats, Floats]:
        """Unit vectors across the road at its points: x and z, to the right of its direction."""
        x, z = self.line[:, 0], self.line[:, 2]
        dx, dz = np.empty_like(x), np.empty_like(z)
        for d, v in ((dx, x), (dz, z)):
            d[1:-1], d[0], d[-1] = v[2:] - v[:-2], v[1] - v[0], v[-1] - v[-2]
        length = np.sqrt(dx * dx + dz * dz)
        return -dz / length, dx / length


def near(seed: int, box: tuple[float, float, float, float], reach: float) -> list[Road]:
    """Roads that come within `reach` metres of a box (x0, x1, z0, z1)."""
    x0, x1, z0, z1 = box[0] - reach, box[1] + reach, box[2] - reach, box[3] + reach
    # A road stays within the squares of its two towns and the width of its lanes around them.
    wide = 0.5 * sites.CELL + _LANE * _LANES
    i0, i1 = (int(np.floor(v / sites.CELL + 0.5)) for v in (x0 - wide, x1 + wide))
    j0, j1 = (int(np.floor(v / sites.CELL + 0.5)) for v in (z0 - wide, z1 + wide))
    roads = [road for j in range(j0 - 1, j1 + 1) for i in range(i0 - 1, i1 + 1) for road in _starting(seed, i, j)]
    return [road for road in roads if road.touches(x0, x1, z0, z1)]


@functools.lru_cache(maxsize=4096)
def _starting(seed: int, i: int, j: int) -> tuple[Road, ...]:
    """Roads from the square (i, j) to its next neighbours along x and z, and past a neighbour without a town."""
    start, east, south, diagonal = (town(seed, i + a, j + b) for a, b in ((0, 0), (1, 0), (0, 1), (1, 1)))
    pairs = [(start, east), (start, south)]
    if east is None or south is None:
        pairs.append((start, diagonal))
    if start is None or diagonal is None:
        pairs.append((east, south))
    roads = [_road(seed, a, b) for a, b in pairs if a is not None and b is not None]
    return tuple(road for road in roads if road is not None)


def _gate(start: Town, end: Town) -> tuple[Floats, Floats]:
    """Start of a road at a town: the end (2,) of the main street that points best to the other town; its direction."""
    dx, dz = end.x - start.x, end.z - start.z
    axis = max((start.axis(quarter) for quarter in range(4)), key=lambda a: float(a[0] * dx + a[1] * dz))
    return np.array([start.x, start.z]) + start.radius * axis, axis


def _road(seed: int, a: Town, b: Town) -> Road | None:
    (from_gate, from_axis), (to_gate, to_axis) = _gate(a, b), _gate(b, a)
    middle = _path(seed, from_gate + _STRAIGHT * from_axis, to_gate + _STRAIGHT * to_axis)
    if middle is None:
        return None
    ends = np.array([0.0, 0.5 * _STRAIGHT])
    first = from_gate + ends[:, None] * from_axis
    last = (to_gate + ends[:, None] * to_axis)[::-1]
    x, z = _even(_round_corners(np.concatenate([first, middle, last]))).T
    line, bridge = _profile(seed, x, z, a, b)
    if (np.abs(line[1:, 1] - line[:-1, 1]) > _STEEPEST * _PIECE).any():
        return None
    return Road(f"{a.name}_to_{b.name}", line, bridge, (float(x.min()), float(x.max()), float(z.min()), float(z.max())))


def _path(seed: int, start: Floats, end: Floats) -> Floats | None:
    """Least-cost path (S, 2) by stations along the straight line and lanes beside it; None if it crosses much water."""
    step_x, step_z = float(end[0] - start[0]), float(end[1] - start[1])
    length = float(np.sqrt(step_x * step_x + step_z * step_z))
    count = max(4, int(length / _STATION))
    fraction = np.arange(count + 1) / count
    lanes = _LANE * np.arange(-_LANES, _LANES + 1)
    x = start[0] + fraction[:, None] * step_x - lanes * (step_z / length)
    z = start[1] + fraction[:, None] * step_z + lanes * (step_x / length)
    heights = natural(seed, x.reshape(-1), z.reshape(-1)).reshape(x.shape)
    wet = heights < 1.0
    cost = 40.0 * wet + 1.0e-3 * np.abs(lanes)
    box = (float(x.min()), float(x.max()), float(z.min()), float(z.max()))
    for place in sites.near(seed, box, 60.0):
        cost = cost + 1.0e4 * (place.distance_to(x, z) < place.radius + 50.0)
    cost = cost + 1.0e6 * (np.abs(lanes) > 0.7 * length * np.minimum(fraction, 1.0 - fraction)[:, None] + 1.0)
    slopes = heights / _STATION
    total, origin = cost[0], np.zeros(x.shape, np.int64)
    for row in range(1, count + 1):
        options = []
        for turn in (-1, 0, 1):
            before = np.full(len(lanes), 1.0e9)
            shifted = slice(max(0, -turn), len(lanes) - max(0, turn)), slice(max(0, turn), len(lanes) + min(0, turn))
            climb = slopes[row][shifted[0]] - slopes[row - 1][shifted[1]]
            before[shifted[0]] = total[shifted[1]] + 90.0 * climb * climb + 0.3 * abs(turn)
            options.append(before)
        best = np.argmin(np.stack(options), axis=0)
        origin[row] = np.arange(len(lanes)) + best - 1
        total = np.choose(best, options) + cost[row]
    lane = np.empty(count + 1, np.int64)
    lane[-1] = int(np.argmin(total))
    for row in range(count, 0, -1):
        lane[row - 1] = origin[row, lane[row]]
    rows = np.arange(count + 1)
    run = longest = 0
    for is_wet in wet[rows, lane].tolist():
        run = run + 1 if is_wet else 0
        longest = max(longest, run)
    return None if longest > _MAX_WATER else np.stack([x[rows, lane], z[rows, lane]], -1)


def _round_corners(points: Floats) -> Floats:
    """Smooth a polyline by cutting corners three times at quarters of the edges (Chaikin 1974); the ends stay."""
    for _ in range(3):
        a, b = points[:-1], points[1:]
        cut = np.stack([0.75 * a + 0.25 * b, 0.25 * a + 0.75 * b], 1).reshape(-1, 2)
        points = np.concatenate([points[:1], cut[1:-1], points[-1:]])
    return points


def _even(points: Floats) -> Floats:
    """Resample a polyline at equal distances."""
    steps = points[1:] - points[:-1]
    along = np.concatenate([[0.0], np.cumsum(np.sqrt(steps[:, 0] * steps[:, 0] + steps[:, 1] * steps[:, 1]))])
    count = max(2, round(float(along[-1]) / _PIECE))
    distances = along[-1] * (np.arange(count + 1) / count)
    k = np.clip(np.searchsorted(along, distances, side="right") - 1, 0, len(steps) - 1)
    fraction = (distances - along[k]) / np.maximum(along[k + 1] - along[k], 1.0e-9)
    return np.asarray(points[k] + fraction[:, None] * steps[k])


def _profile(seed: int, x: Floats, z: Floats, a: Town, b: Town) -> tuple[Floats, NDArray[np.bool_]]:
    """Heights along a road (smoothed ground, level at the towns, above water), and whether each point is over water."""
    raw = natural(seed, x, z)
    ground = sites.level_ground([a, b], x, z, raw)
    heights = np.maximum(ground, CLEARANCE)
    for width in (14, 11, 8, 5):
        padded = np.concatenate([np.full(width, heights[0]), heights, np.full(width, heights[-1])])
        total = np.zeros_like(heights)
        for k in range(2 * width + 1):
            total = total + padded[k : k + len(heights)]
        heights = total / (2 * width + 1)
    heights = np.maximum(heights, CLEARANCE)
    distances = _PIECE * np.arange(float(len(x)))
    for place, from_place in ((a, distances), (b, distances[::-1])):
        weight = 1.0 - step(_STRAIGHT + 10.0, _STRAIGHT + 260.0, from_place)
        heights = heights + weight * (place.height - heights)
    heights = np.clip(heights, ground - 22.0, np.maximum(ground, 0.0) + 22.0)
    line = np.floor(np.stack([x, heights, z], -1) * 256.0 + 0.5) / 256.0
    return line, raw < 1.0


def level_ground(roads: list[Road], x: Floats, z: Floats, heights: Floats, spacing: float) -> tuple[Floats, Floats]:
    """Level the ground (R, C) of a grid below roads; also return the distance to the nearest road, at most 1 km."""
    nearest, level = np.full(x.shape, 1000.0), np.zeros_like(heights)
    x0, z0 = float(x[0, 0]), float(z[0, 0])
    for road in roads:
        for first in range(0, len(road.line) - 1, 8):
            part = road.line[first : first + 9]
            (a, _, c), (b, _, d) = part.min(0) - REACH, part.max(0) + REACH
            rows = slice(max(0, int((c - z0) // spacing)), max(0, int((d - z0) // spacing) + 2))
            columns = slice(max(0, int((a - x0) // spacing)), max(0, int((b - x0) // spacing) + 2))
            if nearest[rows, columns].size:
                distance, height = _nearest(part, x[rows, columns], z[rows, columns])
                is_closer = distance < nearest[rows, columns]
                nearest[rows, columns] = np.where(is_closer, distance, nearest[rows, columns])
                level[rows, columns] = np.where(is_closer, height, level[rows, columns])
    weight = (1.0 - step(SHOULDER, REACH, nearest)) * step(-0.2, 1.2, heights)
    return heights + weight * (level - BED - heights), nearest


def _nearest(part: Floats, x: Floats, z: Floats) -> tuple[Floats, Floats]:
    """Horizontal distance to a polyline (N, 3), and its height at the nearest point, for positions of any shape."""
    start, along = part[:-1], part[1:] - part[:-1]
    square = along[:, 0] * along[:, 0] + along[:, 2] * along[:, 2]
    px, pz = x[..., None] - start[:, 0], z[..., None] - start[:, 2]
    fraction = np.clip((px * along[:, 0] + pz * along[:, 2]) / square, 0.0, 1.0)
    dx, dz = px - fraction * along[:, 0], pz - fraction * along[:, 2]
    far = dx * dx + dz * dz
    best = np.argmin(far, axis=-1)[..., None]
    height = start[:, 1][best[..., 0]] + np.take_along_axis(fraction, best, -1)[..., 0] * along[:, 1][best[..., 0]]
    return np.sqrt(np.take_along_axis(far, best, -1)[..., 0]), height
