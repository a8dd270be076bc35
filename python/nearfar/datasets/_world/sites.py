"""Sites of towns: at most one in each square of 3 km, where the land is level and dry."""

from __future__ import annotations

import functools
import itertools
from dataclasses import dataclass

import numpy as np

from nearfar.datasets._random import Floats, RandomStream, step, turn
from nearfar.datasets._world.relief import natural

CELL = 3072.0
"""Side of the squares, metres; the square (0, 0) is centred at the world's centre and always has a town."""
_TRIES = 10
EDGE, SLOPE = 30.0, 190.0
"""The ground is level up to `EDGE` metres beyond a town, and natural again after `SLOPE` more metres."""


@dataclass(frozen=True)
class Town:
    """A town: a disc of level ground with a grid of streets."""

    i: int
    j: int
    x: float
    z: float
    radius: float
    height: float
    """Height of its ground, metres."""
    heading: float
    """Direction of its first main street, fraction of a full turn from +x towards +z."""

    @property
    def name(self) -> str:
        return f"{self.i}_{self.j}"

    def axis(self, quarter: int) -> Floats:
        """Unit vector (x, z) of a main street's arm, 0 to 3."""
        cosine, sine = turn(self.heading + 0.25 * quarter)
        return np.array([float(cosine), float(sine)])

    def local(self, x: Floats, z: Floats) -> tuple[Floats, Floats]:
        """Positions along and across the first main street, metres from the centre."""
        a = self.axis(0)
        return (x - self.x) * a[0] + (z - self.z) * a[1], (z - self.z) * a[0] - (x - self.x) * a[1]

    def world(self, u: Floats, v: Floats) -> tuple[Floats, Floats]:
        """World x and z of positions along and across the first main street."""
        a = self.axis(0)
        return self.x + u * a[0] - v * a[1], self.z + u * a[1] + v * a[0]

    def distance_to(self, x: Floats, z: Floats) -> Floats:
        """Distances from the centre, metres."""
        return np.sqrt((x - self.x) * (x - self.x) + (z - self.z) * (z - self.z))


@functools.lru_cache(maxsize=8192)
def town(seed: int, i: int, j: int) -> Town | None:
    """Find the town of a square; None if no place is suitable."""
    random = RandomStream(seed, 200, i, j)
    home = i == 0 and j == 0
    if not home and random.chance(0.15):
        return None
    heading, growth = random.number(), random.number()
    reach = 120.0 if home else 0.3 * CELL
    x, z = i * CELL + random.uniform(_TRIES, -reach, reach), j * CELL + random.uniform(_TRIES, -reach, reach)
    lines = np.linspace(-1.0, 1.0, 9)
    a, b = (line.reshape(-1) for line in np.meshgrid(lines, lines))
    inside = a * a + b * b <= 1.05
    a, b = a[inside], b[inside]
    radius = 520.0 if home else 170.0 + 330.0 * growth * growth
    for factor in (1.0, 0.62) if radius > 260.0 else (1.0,):
        size = radius * factor
        px, pz = x[:, None] + size * 1.1 * a, z[:, None] + size * 1.1 * b
        heights = natural(seed, px.reshape(-1), pz.reshape(-1)).reshape(_TRIES, -1)
        low, high = heights.min(1), heights.max(1)
        middle = np.sort(heights, axis=1)[:, heights.shape[1] // 2]
        spread = high - low + 60.0 * np.maximum(3.0 - low, 0.0) + 0.05 * middle
        best = int(np.argmin(spread))
        fit = low[best] > 2.5 and high[best] - low[best] < 46.0 and middle[best] < 520.0
        if fit or (home and factor < 1.0):
            level = np.floor(max(float(middle[best]), 4.0) * 64.0) / 64.0
            return Town(i, j, float(np.floor(x[best])), float(np.floor(z[best])), size, float(level), heading)
    return None


def near(seed: int, box: tuple[float, float, float, float], reach: float) -> list[Town]:
    """Towns whose discs come within `reach` metres of a box (x0, x1, z0, z1)."""
    x0, x1, z0, z1 = box
    far = reach + 520.0 - 0.2 * CELL
    i0, i1 = (int(np.floor(v / CELL + 0.5)) for v in (x0 - far, x1 + far))
    j0, j1 = (int(np.floor(v / CELL + 0.5)) for v in (z0 - far, z1 + far))
    towns = []
    for j, i in itertools.product(range(j0, j1 + 1), range(i0, i1 + 1)):
        if (place := town(seed, i, j)) is not None:
            dx, dz = max(x0 - place.x, place.x - x1, 0.0), max(z0 - place.z, place.z - z1, 0.0)
            if dx * dx + dz * dz <= (reach + place.radius) ** 2:
                towns.append(place)
    return towns


def level_ground(towns: list[Town], x: Floats, z: Floats, heights: Floats) -> Floats:
    """Heights of the natural ground, levelled in and around towns; rivers stay."""
    for place in towns:
        edge = place.radius + EDGE
        weight = (1.0 - step(edge, edge + SLOPE, place.distance_to(x, z))) * step(0.2, 2.0, heights)
        heights = heights + weight * (place.height - heights)
    return heights
