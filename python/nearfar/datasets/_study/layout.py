"""Layout shared by the tasks of the user study: centre, radii, ground, and rows of objects to choose from."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check
from nearfar.datasets._palette import materials
from nearfar.datasets._random import RandomStream
from nearfar.datasets._shapes import Soup, quads

Point = tuple[float, float, float]

CENTER: Point = (0.0, 1.7, 0.0)
R1, R2 = 30.0, 50.0
MAX_SEED = 2**63 - 1
MAX = 15
"""Greatest number of objects to choose from."""
COLORS = materials(
    "sign_red", "sign_teal", "sign_navy", "flower", "car_white", "sign_green", "car_black", "leaf_light",
    "fabric_rust", "glass_sky", "paint_mint", "brick_red", "paint_cream", "car_blue", "wood_dark",
)  # fmt: skip
"""Materials of the objects to choose from, in order."""


@dataclass(frozen=True)
class Task:
    """Centre and radii of a task; it has objects on both sides of the radii."""

    center: Point
    """Centre O, at eye height above the ground; all points are in world metres."""
    target: Point
    """Point that users look at, in the middle of the objects."""
    r1: float
    """Radius that bounds the near zone, metres."""
    r2: float
    """Radius that bounds the intermediate zone, metres."""


def draw_answer(name: str, seed: int, count: int, stream: int) -> tuple[RandomStream, int, int]:
    """Return the random stream, the number of objects to choose from, and the index of the answer."""
    seed = check.integer("seed", seed, 0, MAX_SEED)
    count = check.integer(name, count, 2, MAX)
    random = RandomStream(seed, stream)
    return random, count, int(random.integers(1, count)[0])


def in_row(count: int, spacing: float) -> NDArray[np.float64]:
    """Positions (count,) of objects about the middle of their row."""
    return np.asarray(spacing * (np.arange(count) - 0.5 * (count - 1)), np.float64)


def ground(extent: float = 400.0) -> Soup:
    """The ground at y = 0."""
    corners = [[-extent, 0.0, extent], [extent, 0.0, extent], [extent, 0.0, -extent], [-extent, 0.0, -extent]]
    return quads([corners], "lawn")


def point(values: NDArray[np.float64]) -> Point:
    """A point of three numbers."""
    return float(values[0]), float(values[1]), float(values[2])
