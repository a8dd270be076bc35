"""Positions and motion of spheres, aiming tests, and seats of users."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TypeAlias

import numpy as np

from nearfar._base import random
from nearfar.stream.collect._messages import Seat, Sphere, Stage, Trial, Vector

Ray: TypeAlias = tuple[Vector, Vector]
"""A ray's origin and its direction, a unit vector."""

TURNS = (0, 2, 1)
"""Sequence of levels: easy, hard, intermediate."""

APART, TRIES = 0.7, 32
"""Least distance between seats in metres, and the number of attempts to place them so."""

_DRAWS, _SEATS = 8, 1 << 32
"""Random numbers reserved per sphere, and index of the first one for seats."""


def sphere(trial: Trial, stage: Stage, group: int, number: int) -> Sphere:
    """Return a trial's sphere by number."""
    draws = _draws(trial.seed, group, stage, _DRAWS * number, 5)
    least, greatest = trial.box
    x, y, z = (low + share * (high - low) for low, high, share in zip(least, greatest, draws[:3], strict=True))
    level = TURNS[number % len(TURNS)]
    # Uniform directions have uniformly distributed heights (Archimedes).
    up, turn = 2.0 * draws[3] - 1.0, 2.0 * math.pi * draws[4]
    across, speed = math.sqrt(1.0 - up * up), trial.speeds[level]
    velocity = (speed * across * math.cos(turn), speed * up, speed * across * math.sin(turn))
    return Sphere(stage, number, level, 0.0, (x, y, z), velocity)


def seats(trial: Trial, stage: Stage, group: int, users: Sequence[int]) -> tuple[Seat, ...]:
    """Place the seats of users at random."""
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
    """Return the position of a sphere's centre some seconds after it appeared."""
    (ax, ay, az), (bx, by, bz) = trial.box
    (x, y, z), (u, v, w) = sphere.position, sphere.velocity
    return folded(x + age * u, ax, bx), folded(y + age * v, ay, by), folded(z + age * w, az, bz)


def folded(at: float, low: float, high: float) -> float:
    """Reflect a coordinate at both ends of a range."""
    length = high - low
    if length <= 0.0:
        return low
    turned = math.fmod(at - low, 2.0 * length)
    turned = turned + 2.0 * length if turned < 0.0 else turned
    return low + (turned if turned <= length else 2.0 * length - turned)


def is_aimed(ray: Ray, center: Vector, radius: float) -> bool:
    """Return whether a ray of any length hits a sphere."""
    (px, py, pz), (dx, dy, dz) = ray
    x, y, z = center[0] - px, center[1] - py, center[2] - pz
    along, square = x * dx + y * dy + z * dz, x * x + y * y + z * z
    inside = radius * radius
    return square <= inside or (along > 0.0 and square - along * along <= inside)


def _draws(seed: int, group: int, stage: Stage, first: int, count: int) -> list[float]:
    cell = (group << 24) | (stage.run << 8) | stage.trial
    values: list[float] = random.uniform(seed, cell, np.arange(first, first + count, dtype=np.uint64)).tolist()
    return values
