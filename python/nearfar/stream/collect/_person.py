"""A model of a user who points at spheres: reaction, aimed movement, tracking with delay, tremor, lapses.

It knows angles alone: yaw and pitch of a target from the hand, in radians. docs/collect.md has the sources.
"""

from __future__ import annotations

import math
from collections import deque
from dataclasses import dataclass, fields
from typing import TypeAlias

import numpy as np

from nearfar._base import check, random

Angles: TypeAlias = tuple[float, float]
"""Yaw, positive to the left, and pitch, positive up."""

SCATTER = 4.133
"""Widths of a target in a standard deviation of where movements end: 96 % of them end within it."""

SINK = math.radians(12.0)
"""Speed at which the hand sinks in a lapse, radians a second."""

GAZE = 0.1
"""Seconds over which the speed of a target is seen."""

REMEMBERED = 256
"""Moments of the past that are kept."""


@dataclass(frozen=True)
class Person:
    """Numbers of a simulated user; each user's own differ from them by `spread`.

    Raises
    ------
    ValueError, TypeError
        For numbers below 0 or too great; the message names the field.
    """

    reaction: float = 0.231
    """Seconds from a sphere's appearance to the begin of the movement: Woods et al. (2015)."""
    reaction_spread: float = 0.05
    """Standard deviation of the same from sphere to sphere, seconds."""
    intercept: float = 0.1
    """Seconds a of Fitts' law MT = a + b log₂(A / W + 1), with the angles A to the target and W of its width."""
    slope: float = 0.3
    """Seconds b of the same."""
    delay: float = 0.2
    """Seconds from what is seen to the hand's answer: McRuer and Jex (1967)."""
    gain: float = 3.0
    """Radians a second by which an error of one radian is corrected: their crossover frequency."""
    pursuit: float = 0.9
    """Share of a target's seen speed that the hand takes over."""
    tremor: float = 0.2
    """Standard deviation of the hand's unsteadiness about each axis, degrees."""
    tremor_time: float = 0.1
    """Seconds after which tremor has forgotten itself, by e."""
    lapses: float = 0.02
    """Lapses of attention a second, in which the hand sinks."""
    lapse: float = 0.4
    """Seconds of a lapse."""
    search: float = 0.0
    """Seconds to find a sphere, after the reaction: a free number, 0 where nothing is calibrated."""
    spread: float = 0.15
    """Standard deviation of the logarithm of each of a user's own numbers."""

    def __post_init__(self) -> None:
        for field in fields(self):
            most = 1.0 if field.name in ("pursuit", "spread") else 100.0
            value = check.within(field.name, getattr(self, field.name), 0.0, most)
            object.__setattr__(self, field.name, value)


class Chance:
    """Random numbers of one user, one after the other."""

    def __init__(self, seed: int, user: int) -> None:
        self._seed, self._user, self._next = seed, user, 0
        self._drawn: list[float] = []

    def uniform(self) -> float:
        """A number in [0, 1)."""
        if not self._drawn:
            index = np.arange(self._next, self._next + 4096, dtype=np.uint64)
            self._next += len(index)
            self._drawn = random.uniform(self._seed, self._user, index).tolist()[::-1]
        return self._drawn.pop()

    def normal(self) -> float:
        """A normal number by Box and Muller's formula."""
        return math.sqrt(-2.0 * math.log(1.0 - self.uniform())) * math.cos(2.0 * math.pi * self.uniform())


@dataclass(frozen=True)
class Target:
    """A target as the user sees it at a moment."""

    number: int
    angles: Angles
    width: float
    """Angle of its diameter, radians."""


@dataclass(frozen=True)
class _Reach:
    """An aimed movement."""

    begin: float
    seconds: float
    start: Angles
    end: Angles


class Pointing:
    """Where a simulated user points, step by step. Times are seconds on any clock.

    Parameters
    ----------
    person
        The numbers of all users.
    seed, user
        Seed, and the number of the user, whose own numbers follow from both.
    """

    def __init__(self, person: Person, seed: int, user: int) -> None:
        self._chance = Chance(seed, user)
        own = {
            name: getattr(person, name) * math.exp(person.spread * self._chance.normal())
            for name in ("reaction", "intercept", "slope", "delay", "gain", "tremor", "search")
        }
        self._own = Person(**{**{field.name: getattr(person, field.name) for field in fields(person)}, **own})
        self._aim: Angles = (0.0, 0.0)
        self._tremor: Angles = (0.0, 0.0)
        self._past: deque[tuple[float, Target, Angles]] = deque(maxlen=REMEMBERED)
        self._number: int | None = None
        self._starts: float | None = None
        self._reach: _Reach | None = None
        self._lapse_ends = -math.inf
        self._last: float | None = None

    def step(self, now: float, target: Target | None) -> Angles:
        """Where the user points at a time, when it sees a target or none."""
        passed = 0.0 if self._last is None else min(max(now - self._last, 0.0), 0.1)
        self._last = now
        self._shake(passed)
        if target is None:
            self._number = None
            self._past.clear()
        else:
            self._notice(now, target)
            self._past.append((now, target, self._aim))
            self._move(now, passed, target)
            self._past[-1] = (now, target, self._aim)
        return self._aim[0] + self._tremor[0], self._aim[1] + self._tremor[1]

    def _notice(self, now: float, target: Target) -> None:
        if target.number == self._number:
            return
        own = self._own
        self._number, self._reach = target.number, None
        self._past.clear()
        after = max(own.reaction + own.reaction_spread * self._chance.normal(), 0.5 * own.reaction)
        self._starts = now + after + own.search

    def _move(self, now: float, passed: float, target: Target) -> None:
        if self._starts is not None:
            if now >= self._starts:
                self._starts, self._reach = None, self._planned(now, target.width)
        elif self._reach is not None:
            self._follow(self._reach, now)
        elif not self._lapses(now, passed):
            self._track(now, passed)

    def _planned(self, now: float, width: float) -> _Reach:
        """A movement to where the target will be if it goes on as it was seen."""
        own = self._own
        (yaw, pitch), (turns, rises), _ = self._seen(now)
        size = max(width, 1e-6)
        away = math.hypot(_turn(yaw - self._aim[0]), pitch - self._aim[1])
        seconds = own.intercept + own.slope * math.log2(away / size + 1.0)
        ahead = own.pursuit * (own.delay + seconds)
        end = (
            self._aim[0] + _turn(yaw - self._aim[0]) + ahead * turns + size / SCATTER * self._chance.normal(),
            pitch + ahead * rises + size / SCATTER * self._chance.normal(),
        )
        return _Reach(now, seconds, self._aim, end)

    def _follow(self, reach: _Reach, now: float) -> None:
        """Flash and Hogan's (1985) movement of minimum jerk."""
        share = min((now - reach.begin) / reach.seconds, 1.0) if reach.seconds > 0.0 else 1.0
        done = share**3 * (10.0 - 15.0 * share + 6.0 * share * share)
        (a, b), (c, d) = reach.start, reach.end
        self._aim = (a + done * (c - a), b + done * (d - b))
        if share == 1.0:
            self._reach = None

    def _track(self, now: float, passed: float) -> None:
        """The crossover model of McRuer and Jex (1967), with the target's speed as a second input."""
        (yaw, pitch), (turns, rises), aim = self._seen(now)
        own = self._own
        left = own.gain * _turn(yaw - aim[0]) + own.pursuit * turns
        up = own.gain * (pitch - aim[1]) + own.pursuit * rises
        self._aim = (self._aim[0] + passed * left, self._aim[1] + passed * up)

    def _lapses(self, now: float, passed: float) -> bool:
        """Whether attention is elsewhere, in which case the hand sinks."""
        if now >= self._lapse_ends and self._chance.uniform() < self._own.lapses * passed:
            self._lapse_ends = now + self._own.lapse
        if now >= self._lapse_ends:
            return False
        self._aim = (self._aim[0], self._aim[1] - SINK * passed)
        return True

    def _seen(self, now: float) -> tuple[Angles, Angles, Angles]:
        """Target, its speed, and the aim, as the user sees them now: those of some time ago."""
        # The first moment that is young enough; time since the appearance may be shorter than the delay.
        number = len(self._past) - 1
        while number > 0 and self._past[number][0] > now - self._own.delay:
            number -= 1
        time, target, aim = self._past[number]
        before = number
        while before > 0 and self._past[before][0] > time - GAZE:
            before -= 1
        passed = time - self._past[before][0]
        if passed <= 0.0:
            return target.angles, (0.0, 0.0), aim
        was = self._past[before][1].angles
        speed = (_turn(target.angles[0] - was[0]) / passed, (target.angles[1] - was[1]) / passed)
        return target.angles, speed, aim

    def _shake(self, passed: float) -> None:
        """Tremor as an Ornstein–Uhlenbeck process about both axes."""
        own = self._own
        keeps = math.exp(-passed / own.tremor_time) if own.tremor_time > 0.0 else 0.0
        size = math.radians(own.tremor) * math.sqrt(1.0 - keeps * keeps)
        yaw, pitch = self._tremor
        self._tremor = (keeps * yaw + size * self._chance.normal(), keeps * pitch + size * self._chance.normal())


def _turn(angle: float) -> float:
    """The same angle within half a turn."""
    return math.remainder(angle, 2.0 * math.pi)
