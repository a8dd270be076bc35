"""Parameters of a trial of the sphere collection: sizes, times and speeds."""

from __future__ import annotations

from dataclasses import dataclass

from nearfar._base import check
from nearfar.stream.collect._messages import MAX_COORDINATE, MAX_RADIUS, MAX_SECONDS, MAX_SPEED, MAX_TRIALS, MAX_USERS


@dataclass(frozen=True)
class Settings:
    """Settings of CloVR's (2024) Experiment 2. Users, trials, hold, seats and speeds are the paper's, the others ours.

    ValueError for numbers outside the limits in docs/collect.md.
    """

    users: int = 4
    """Number of users who must aim at a sphere at the same time, at most 64."""
    trials: int = 3
    """Number of consecutive trials."""
    duration: float = 180.0
    """Duration of a trial, seconds."""
    hold: float = 2.0
    """Seconds for which all users must aim at a sphere without interruption."""
    pause: float = 1.65
    """Seconds from a sphere's collection to the next sphere."""
    rest: float = 5.0
    """Seconds between two trials."""
    radius: float = 0.3
    """Radius of a sphere, metres."""
    speeds: tuple[float, float, float] = (0.0, 0.5, 1.5)
    """Speeds of easy, intermediate and hard spheres, metres per second."""
    center: tuple[float, float, float] = (0.0, 1.7, 0.0)
    """Centre of the seats at eye height, metres from the scene's origin."""
    seats: tuple[float, float] = (5.0, 2.0)
    """Size of the rectangle of seats along x and z, metres."""
    distance: float = 8.0
    """Distance along −z from the centre of the seats to the centre of the box that holds sphere centres, metres."""
    rise: float = 0.5
    """Height of the box's centre above the centre of the seats, metres."""
    box: tuple[float, float, float] = (8.0, 4.0, 4.0)
    """Size of the box along x, y and z, metres."""
    seed: int = 0
    """Seed of positions and directions; groups and trials with the same seed differ."""

    def __post_init__(self) -> None:
        for name, least, greatest in (("users", 1, MAX_USERS), ("trials", 1, MAX_TRIALS), ("seed", 0, 2**32 - 1)):
            object.__setattr__(self, name, check.integer(name, getattr(self, name), least, greatest))
        for name in ("duration", "radius"):
            check.positive(name, getattr(self, name))
        for name, high in (
            ("duration", MAX_SECONDS), ("hold", MAX_SECONDS), ("pause", MAX_SECONDS), ("rest", MAX_SECONDS),
            ("radius", MAX_RADIUS), ("distance", MAX_COORDINATE), ("rise", MAX_COORDINATE),
        ):  # fmt: skip
            object.__setattr__(self, name, check.in_range(name, getattr(self, name), 0.0, high))
        for name, count, low, high in (
            ("speeds", 3, 0.0, MAX_SPEED), ("center", 3, -MAX_COORDINATE / 4, MAX_COORDINATE / 4),
            ("seats", 2, 0.0, MAX_COORDINATE / 4), ("box", 3, 0.0, MAX_COORDINATE / 4),
        ):  # fmt: skip
            object.__setattr__(self, name, _numbers(name, getattr(self, name), count, low, high))


def _numbers(name: str, value: tuple[float, ...], count: int, low: float, high: float) -> tuple[float, ...]:
    """Check `count` numbers within [low, high]."""
    if not isinstance(value, tuple | list) or len(value) != count:
        raise TypeError(f"{name}: expected {count} numbers, got {check.type_and_value(value)}")
    return tuple(check.in_range(name, number, low, high) for number in value)
