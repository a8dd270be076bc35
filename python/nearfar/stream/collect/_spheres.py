"""Positions and motion of spheres, aiming tests, and seats of users."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import combinations

import numpy as np

from nearfar._base import random
from nearfar.stream.collect._messages import Seat, Sphere, Stage, Trial, Vector

Ray = tuple[Vector, Vector]
"""A ray's origin and its direction, a unit vector."""

LEVEL_SEQUENCE = (0, 2, 1)
"""Sequence of levels: easy, hard, intermediate."""

MIN_SEAT_DISTANCE, MAX_TRIES = 0.7, 32
"""Least distance between seats in metres, and the number of attempts to place them so."""

_DRAWS, _SEATS = 8, 1 << 32
"""Random numbers reserved per sphere, and index of the first one for seats."""


def sphere(trial: Trial, stage: Stage, group: int, number: int) -> Sphere:
    """Return a trial's sphere by number."""
    draws = _draws(trial.seed, group, stage, _DRAWS * number, 5)
    least, greatest = trial.box
    x, y, z = (low + fraction * (high - low) for low, high, fraction in zip(least, greatest, draws[:3], strict=True))
    level = LEVEL_SEQUENCE[number % len(LEVEL_SEQUENCE)]
    # Uniform directions have uniformly distributed heights (Archimedes).
    up, turn = 2.0 * draws[3] - 1.0, 2.0 * math.pi * draws[4]
    horizontal, speed = math.sqrt(1.0 - up * up), trial.speeds[level]
    velocity = (speed * horizontal * math.cos(turn), speed * up, speed * horizontal * math.sin(turn))
    return Sphere(stage, number, level, 0.0, (x, y, z), velocity)


def seats(trial: Trial, stage: Stage, group: int, users: Sequence[int]) -> tuple[Seat, ...]:
    """Place the seats of users at random."""
    least, greatest = trial.area
    sides = (greatest[0] - least[0], greatest[2] - least[2])
    places: list[Vector] = []
    for attempt in range(MAX_TRIES):
        draws = _draws(trial.seed, group, stage, _SEATS + 2 * len(users) * attempt, 2 * len(users))
        pairs = zip(draws[::2], draws[1::2], strict=True)
        places = [(least[0] + u * sides[0], least[1], least[2] + v * sides[1]) for u, v in pairs]
        if all(math.dist(a, b) >= MIN_SEAT_DISTANCE for a, b in combinations(places, 2)):
            break
    return tuple(map(Seat, users, places))


def place(sphere: Sphere, trial: Trial, age: float) -> Vector:
    """Return the position of a sphere's centre some seconds after it appeared."""
    (ax, ay, az), (bx, by, bz) = trial.box
    (x, y, z), (u, v, w) = sphere.position, sphere.velocity
    return reflect_into(x + age * u, ax, bx), reflect_into(y + age * v, ay, by), reflect_into(z + age * w, az, bz)


def reflect_into(value: float, low: float, high: float) -> float:
    """Reflect a coordinate at both ends of a range."""
    length = high - low
    if length <= 0.0:
        return low
    phase = math.fmod(value - low, 2.0 * length)
    phase = phase + 2.0 * length if phase < 0.0 else phase
    return low + (phase if phase <= length else 2.0 * length - phase)


def is_aimed(ray: Ray, center: Vector, radius: float) -> bool:
    """Return whether a ray of any length hits a sphere."""
    (px, py, pz), (dx, dy, dz) = ray
    x, y, z = center[0] - px, center[1] - py, center[2] - pz
    depth, square = x * dx + y * dy + z * dz, x * x + y * y + z * z
    return square <= radius * radius or (depth > 0.0 and square - depth * depth <= radius * radius)


def _draws(seed: int, group: int, stage: Stage, first: int, count: int) -> list[float]:
    cell = (group << 24) | (stage.run << 8) | stage.trial
    values: list[float] = random.uniform(seed, cell, np.arange(first, first + count, dtype=np.uint64)).tolist()
    return values
