"""Climate and vegetation: density of forest, fields, and the colours of the ground."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar.datasets._random import Floats, step
from nearfar.datasets._world import streets
from nearfar.datasets._world.noise import noise, uniform_hash
from nearfar.datasets._world.sites import Town

FARMED = 1100.0
"""Distance from a town's edge within which the land is farmed, metres."""


@dataclass(frozen=True)
class Cover:
    """Cover of the ground at positions; all shares are 0 … 1."""

    forest: Floats
    """Share of the ground under trees."""
    conifers: Floats
    """Share of conifers among the trees."""
    field: NDArray[np.int64]
    """Crop number of the field, −1 for land that is not farmed."""
    hedge: NDArray[np.bool_]
    """Whether the position lies on a field's border."""
    dry: Floats
    cold: Floats
    town: Floats
    """Share of built-up land."""


def cover(seed: int, towns: list[Town], x: Floats, z: Floats, height: Floats, slope: Floats) -> Cover:
    """Find the cover of the ground at positions with heights in metres and slopes (metres per metre)."""
    dry = 0.5 + 0.5 * noise(seed, 60, x, z, 26_000.0) + 0.25 * noise(seed, 61, x, z, 5_000.0)
    cold = height / 1500.0 + 0.12 * noise(seed, 62, x, z, 3_100.0)
    patches = noise(seed, 63, x, z, 1_150.0) + 0.55 * noise(seed, 64, x, z, 310.0) + 0.2 * noise(seed, 65, x, z, 90.0)
    wooded = step(-0.12, 0.12, patches + 0.55 * np.minimum(slope, 0.6) + 0.22 - 0.35 * step(0.6, 1.1, dry))
    field, hedge, town = np.full(x.shape, -1), np.zeros(x.shape, bool), np.zeros_like(x)
    # Each place is farmed from its nearest town only; fields end where another town is nearer.
    nearest = np.full(x.shape, 1.0e9)
    for place in towns:
        distance = place.distance_to(x, z) - place.radius
        crop, border = _fields(seed, place, x, z)
        is_nearest = distance < nearest
        nearest = np.minimum(nearest, distance)
        in_reach = distance < FARMED * (0.7 + 0.5 * patches)
        farmed = in_reach & (crop > 0) & (slope < 0.3) & (height > 2.5) & (cold < 0.42)
        field = np.where(is_nearest, np.where(farmed, crop, -1), field)
        hedge = np.where(is_nearest, farmed & border, hedge)
        town = np.maximum(town, streets.layout(seed, place).built(x, z))
    # Woods grow on land that is not farmed, up to the tree line, off the shore and not on cliffs.
    forest = np.where(field >= 0, 0.0, wooded)
    forest = forest * (1.0 - step(0.6, 0.74, cold)) * step(1.6, 3.0, height) * (1.0 - step(0.75, 1.05, slope))
    forest = np.where(town > 0.0, 0.0, forest)
    conifers = step(0.05, 0.5, cold + 0.55 * noise(seed, 66, x, z, 800.0) + 0.1)
    return Cover(forest, conifers, field, hedge & (town <= 0.0), dry, cold, town)


def _fields(seed: int, place: Town, x: Floats, z: Floats) -> tuple[NDArray[np.int64], NDArray[np.bool_]]:
    """Crop of each position's field around a town, 0 for a wood or meadow, and whether it is on a border."""
    u, v = place.local(x, z)
    u = u + 22.0 * noise(seed, 67, x, z, 420.0)
    v = v + 22.0 * noise(seed, 68, x, z, 420.0)
    strip = np.floor(u / 230.0)
    i = strip.astype(np.int64)
    wide = 90.0 + 110.0 * uniform_hash(seed, 69, i, np.full_like(i, place.i * 4096 + place.j))
    row = np.floor(v / wide)
    key = uniform_hash(seed, 70, i * 65536 + row.astype(np.int64), np.full_like(i, place.i * 4096 + place.j))
    edge = np.minimum(u - 230.0 * strip, 230.0 * (strip + 1.0) - u)
    edge = np.minimum(edge, np.minimum(v - wide * row, wide * (row + 1.0) - v))
    return (key * 9.0).astype(np.int64), edge < 3.4


# Colours of the ground in sRGB, 0 … 255.
_MEADOW, _LUSH, _STEPPE = (112, 140, 70), (90, 126, 58), (160, 152, 96)
_WOOD, _NEEDLES = (74, 88, 46), (80, 80, 52)
_ROCK, _SCREE, _SNOW = (124, 118, 110), (150, 142, 128), (240, 243, 248)
_SAND, _MUD, _VERGE, _GARDEN = (206, 190, 148), (112, 108, 84), (132, 134, 92), (104, 136, 70)
_CROPS = np.array(
    [(116, 138, 72), (196, 176, 96), (150, 162, 70), (206, 190, 112), (104, 132, 60), (142, 112, 78), (184, 168, 84),
     (122, 148, 64), (168, 150, 92)], float,
)  # fmt: skip


def colors(seed: int, cover: Cover, x: Floats, z: Floats, height: Floats, slope: Floats, road: Floats) -> Floats:
    """Colours (…, 3) of the ground in sRGB, 0 … 255; `road` is the distance from a road in metres."""
    tone = noise(seed, 71, x, z, 160.0) + 0.5 * noise(seed, 72, x, z, 31.0)
    rgb = np.broadcast_to(np.array(_MEADOW, float), (*x.shape, 3))
    rgb = _mix(rgb, _LUSH, step(-0.4, 0.5, tone - cover.dry + 0.4))
    rgb = _mix(rgb, _STEPPE, step(0.55, 1.05, cover.dry + 0.25 * tone))
    rgb = np.where((cover.field > 0)[..., None], _CROPS[np.maximum(cover.field, 0)], rgb)
    rgb = _mix(rgb, _LUSH, 0.7 * cover.hedge)
    rgb = _mix(rgb, _WOOD, 0.85 * cover.forest)
    rgb = _mix(rgb, _NEEDLES, 0.5 * cover.forest * cover.conifers)
    rgb = _mix(rgb, _STEPPE, 0.6 * step(0.5, 0.75, cover.cold) * (1.0 - cover.forest))
    rgb = _mix(rgb, _SCREE, step(0.6, 0.85, cover.cold + 0.1 * tone) * step(0.2, 0.5, slope))
    rgb = _mix(rgb, _ROCK, step(0.62, 0.95, slope + 0.1 * tone))
    rgb = _mix(rgb, _SNOW, step(0.72, 0.86, cover.cold + 0.05 * tone - 0.12 * np.maximum(slope - 0.5, 0.0)))
    rgb = _mix(rgb, _GARDEN, 0.8 * cover.town)
    rgb = _mix(rgb, _VERGE, 0.9 * (1.0 - step(6.0, 11.0, road)))
    rgb = _mix(rgb, _SAND, (1.0 - step(0.9, 2.6, height + 0.5 * tone)) * (1.0 - step(0.35, 0.7, slope)))
    rgb = _mix(rgb, _MUD, 1.0 - step(-3.0, -0.2, height))
    return rgb * (1.0 + 0.07 * tone)[..., None]


_SHALLOW, _SHELF, _DEEP = (96, 142, 146), (52, 104, 128), (26, 62, 94)


def water_colors(seed: int, x: Floats, z: Floats, depth: Floats) -> Floats:
    """Colours (…, 3) of the water's surface in sRGB, 0 … 255, by its depth in metres."""
    rgb = _mix(np.broadcast_to(np.array(_SHALLOW, float), (*x.shape, 3)), _SHELF, step(0.0, 5.0, depth))
    rgb = _mix(rgb, _DEEP, step(3.0, 60.0, depth))
    return rgb * (1.0 + 0.04 * noise(seed, 73, x, z, 220.0))[..., None]


def _mix(rgb: Floats, color: tuple[int, int, int], weight: NDArray[Any]) -> Floats:
    return rgb + weight[..., None] * (np.array(color, float) - rgb)
