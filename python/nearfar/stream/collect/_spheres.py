"""Where spheres appear, how they move, who aims at them, and where users have their seats."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TypeAlias

import numpy as np

from nearfar._base import random
from nearfar.stream.collect._messages import Seat, Sphere, Stage, Trial, Vector

Ray: TypeAlias = tuple[Vector, Vector]
"""A ray's begin and its direction, a unit vector."""

TURNS = (0, 2, 1)
"""Levels in turn: easy, hard, intermediate."""

APART, TRIES = 0.7, 32
"""Metres that seats are apart, unless so many draws have not found such places."""

_DRAWS, _SEATS = 8, 1 << 32
"""Draws of a sphere, and number of the first draw of seats."""


def sphere(trial: Trial, stage: Stage, group: int, number: int) -> Sphere:
    """The sphere of a number of a trial."""
    draws = _draws(trial.seed, group, stage, _DRAWS * number, 5)
    least, greatest = trial.box
    x, y, z = (low + share * (high - low) for low, high, share in zip(least, greatest, draws[:3], strict=True))
    level = TURNS[number % len(TURNS)]
    # Directions that are uniform on the sphere have uniform heights (Archimedes).
    up, turn = 2.0 * draws[3] - 1.0, 2.0 * math.pi * draws[4]
    across, speed = math.sqrt(1.0 - up * up), trial.speeds[level]
    velocity = (speed * across * math.cos(turn), speed * up, speed * across * math.sin(turn))
    return Sphere(stage, number, level, 0.0, (x, y, z), velocity)


def seats(trial: Trial, stage: Stage, group: int, users: Sequence[int]) -> tuple[Seat, ...]:
    """Seats of users at random."""
    least, greatest = trial.area
    found: list[Vector] = []
    for attempt in range(TRIES):
        draws = iter(_draws(trial.seed, group, stage, _SEATS + 2 * len(users) * attempt, 2 * len(users)))
        found = [
            (least[0] + next(draws) * (greatest[0] - least[0]), least[1],
             least[2] + next(draws) * (greatest[2] - least[2]))
            for _ in users
        ]  # fmt: skip
        if all(math.dist(one, other) >= APART for n, one in enumerate(found) for other in found[:n]):
            break
    return tuple(Seat(user, position) for user, position in zip(users, found, strict=True))


def place(sphere: Sphere, trial: Trial, age: float) -> Vector:
    """Where the middle of a sphere is some seconds after it appeared."""
    (ax, ay, az), (bx, by, bz) = trial.box
    (x, y, z), (u, v, w) = sphere.position, sphere.velocity
    return folded(x + age * u, ax, bx), folded(y + age * v, ay, by), folded(z + age * w, az, bz)


def folded(at: float, low: float, high: float) -> float:
    """A coordinate that turns back at both ends of a range."""
    length = high - low
    if length <= 0.0:
        return low
    turned = math.fmod(at - low, 2.0 * length)
    turned = turned + 2.0 * length if turned < 0.0 else turned
    return low + (turned if turned <= length else 2.0 * length - turned)


def is_aimed(ray: Ray, center: Vector, radius: float) -> bool:
    """Whether a ray of any length meets a sphere."""
    (px, py, pz), (dx, dy, dz) = ray
    x, y, z = center[0] - px, center[1] - py, center[2] - pz
    along, square = x * dx + y * dy + z * dz, x * x + y * y + z * z
    inside = radius * radius
    return square <= inside or (along > 0.0 and square - along * along <= inside)


def _draws(seed: int, group: int, stage: Stage, first: int, count: int) -> list[float]:
    cell = (group << 24) | (stage.run << 8) | stage.trial
    values: list[float] = random.uniform(seed, cell, np.arange(first, first + count, dtype=np.uint64)).tolist()
    return values
