"""The plan of the city: streets, blocks and building plots, seen from above."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from nearfar.datasets._buildings import Kind
from nearfar.datasets._random import Floats, RandomStream

PITCH = (84.0, 64.0)
"""Distances between the middle lines of neighbouring streets along x and z, metres."""
STREET, AVENUE = 6.0, 8.0
"""Half the width of a carriageway of a street and of an avenue, metres."""
PAVEMENT = 4.0
KERB = 0.15
"""Height of pavements above the carriageway, metres."""
YARD = 10.0
"""Depth of the courtyard between the rows of a block, metres."""


@dataclass(frozen=True)
class Plot:
    """A building's place: the middle of its footprint, and the quarter turns that make its front face the street."""

    name: str
    block: int
    kind: Kind
    x: float
    z: float
    quarter: int


@dataclass(frozen=True)
class Grid:
    """Streets along both axes; the avenues cross at the origin."""

    blocks: int
    x: Floats
    """x of the middle lines of the streets that run along z, metres."""
    z: Floats
    """z of the middle lines of the streets that run along x, metres."""
    avenue: int
    """Index of the avenue, in both directions."""

    @classmethod
    def generate(cls, blocks: int) -> Grid:
        """Make the grid for `blocks` × `blocks` blocks."""
        avenue = blocks // 2
        steps = np.arange(blocks + 1.0) - avenue
        widened = np.sign(steps) * (AVENUE - STREET)
        return cls(blocks, steps * PITCH[0] + widened, steps * PITCH[1] + widened, avenue)

    def numbers(self) -> Iterator[tuple[int, int]]:
        """Column i and row j of each block, in the order of their numbers j · `blocks` + i."""
        return ((i, j) for j in range(self.blocks) for i in range(self.blocks))

    def half(self, street: int) -> float:
        """Half the width of a street's carriageway, metres."""
        return AVENUE if street == self.avenue else STREET

    def block(self, i: int, j: int) -> tuple[float, float, float, float]:
        """Kerb lines of a block: least and greatest x, least and greatest z, metres."""
        return (
            float(self.x[i] + self.half(i)), float(self.x[i + 1] - self.half(i + 1)),
            float(self.z[j] + self.half(j)), float(self.z[j + 1] - self.half(j + 1)),
        )  # fmt: skip

    def use(self, i: int, j: int, seed: int) -> str:
        """Return the use of a block: "park", "towers" or "rows"."""
        a, b = i - self.avenue, j - self.avenue
        if (a, b) == (-1, -1) or (self.blocks > 8 and (a, b) in ((3, 2), (-4, 3), (2, -6))):
            return "park"
        distance = self.downtown(i, j)
        is_downtown = distance < 1.0 or (distance < 1.6 and RandomStream(seed, 10, i, j).chance(0.2))
        return "towers" if is_downtown else "rows"

    def downtown(self, i: int, j: int) -> float:
        """Distance of a block from the middle of down-town, in units of down-town's radius."""
        radius = max(0.8, 0.15 * self.blocks)
        a = (i - self.avenue - 0.4) / radius
        b = (j - self.avenue + 0.5 + 0.34 * self.blocks) / radius
        return float(np.sqrt(a * a + 0.7 * b * b))


# Widths of the plots in a row, metres; each adds up to a block's 64 m.
_ROWS = ((16, 16, 16, 16), (20, 24, 20), (24, 16, 24), (16, 24, 24), (24, 24, 16), (20, 20, 24), (24, 20, 20))
_TOWERS = ((24, 24), (26, 20), (28, 26), (22, 30))
_VARIANTS = (3, 2, 2)


def plots(grid: Grid, seed: int) -> list[Plot]:
    """List all buildings of the city, block by block."""
    buildings: list[Plot] = []
    for i, j in grid.numbers():
        use, random = grid.use(i, j, seed), RandomStream(seed, 11, i, j)
        if use != "park":
            buildings += (_rows if use == "rows" else _towers)(grid, i, j, random)
    return buildings


def _rows(grid: Grid, i: int, j: int, random: RandomStream) -> list[Plot]:
    x0, x1, z0, z1 = grid.block(i, j)
    block = j * grid.blocks + i
    buildings: list[Plot] = []
    for quarter, front, backwards in ((0, z1 - PAVEMENT, -1.0), (2, z0 + PAVEMENT, 1.0)):
        widths = random.pick(_ROWS)
        # Local +x of a row that faces −z is −x of the world, so its plots are listed from the other end.
        start, step = (x0 + PAVEMENT, 1.0) if quarter == 0 else (x1 - PAVEMENT, -1.0)
        for number, width in enumerate(widths):
            place = 2 if number == 0 else 1 if number == len(widths) - 1 else 0
            # Buildings are lower away from down-town.
            form = int(np.clip(np.floor(2.3 - 0.55 * grid.downtown(i, j) + random.number(-0.75, 0.75)), 0, 2))
            is_gap = random.chance(0.04) and place == 0
            if not is_gap:
                depth = 150 + 10 * ((width // 4 + form) % 3)
                variant = int(random.integers(1, _VARIANTS[place])[0])
                # A gap of a decimetre between neighbours, so that their walls never share a plane.
                kind = Kind(width * 10 - 1, depth, form, place, variant)
                x, z = start + step * 0.5 * width, front + backwards * 0.05 * depth
                buildings.append(Plot(f"building_{block}_{len(buildings)}", block, kind, x, z, quarter))
            start += step * width
    return buildings


def _towers(grid: Grid, i: int, j: int, random: RandomStream) -> list[Plot]:
    x0, x1, z0, z1 = grid.block(i, j)
    middle, block = 0.5 * (z0 + z1), j * grid.blocks + i
    buildings = []
    for number in range(2):
        width, depth = random.pick(_TOWERS)
        variant = int(random.integers(1, 3)[0])
        x = x0 + PAVEMENT + (x1 - x0 - 2.0 * PAVEMENT) * (0.25 + 0.5 * number)
        z = middle + random.number(-1.0, 1.0) * 0.45 * (z1 - z0 - 2.0 * PAVEMENT - depth)
        kind = Kind(width * 10, depth * 10, 3, 3, variant)
        quarter = 2 * int(random.integers(1, 2)[0])
        buildings.append(Plot(f"building_{block}_{number}", block, kind, float(x), float(z), quarter))
    return buildings
