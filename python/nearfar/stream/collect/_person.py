"""Model of a user who points at spheres: reaction, aimed movement, tracking with delay, tremor, lapses.

All positions are angles in radians: yaw and pitch of a target seen from the hand. docs/collect.md lists the sources.
"""

from __future__ import annotations

import math
from collections import deque
from dataclasses import dataclass, fields, replace

import numpy as np

from nearfar._base import check, random

Angles = tuple[float, float]
"""Yaw, positive to the left, and pitch, positive up."""

SCATTER = 4.133
"""Ratio of a target's width to the standard deviation of movement end points: 96 % of them end within the target."""

SINK_SPEED = math.radians(12.0)
"""Speed of the hand during a lapse, radians per second."""

GAZE_SECONDS = 0.1
"""Seconds over which the user estimates a target's speed."""

MAX_MOMENTS = 256
"""Number of stored past moments."""


@dataclass(frozen=True)
class Person:
    """Parameters of simulated users; each user's own parameters vary by `spread`."""

    reaction: float = 0.231
    """Seconds from a sphere's appearance to the start of the movement: Woods et al. (2015)."""
    reaction_spread: float = 0.05
    """Standard deviation of the reaction time between spheres, seconds."""
    intercept: float = 0.1
    """Intercept a of Fitts' law MT = a + b log₂(A / W + 1) in seconds; A is the angle to the target, W its width."""
    slope: float = 0.3
    """Slope b of Fitts' law, seconds."""
    delay: float = 0.2
    """Seconds from a stimulus to the hand's response: McRuer and Jex (1967)."""
    gain: float = 3.0
    """Correction speed in radians per second for an error of one radian: the crossover frequency of McRuer and Jex."""
    pursuit: float = 0.9
    """Share of a target's perceived speed that the hand follows."""
    tremor: float = 0.2
    """Standard deviation of tremor about each axis, degrees."""
    tremor_time: float = 0.1
    """Correlation time of tremor, seconds: its autocorrelation falls by the factor e."""
    lapses: float = 0.02
    """Lapses of attention per second; the hand sinks during a lapse."""
    lapse: float = 0.4
    """Duration of a lapse, seconds."""
    search: float = 0.0
    """Seconds to find a sphere, after the reaction: a free parameter, 0 without calibration."""
    spread: float = 0.15
    """Standard deviation of the logarithm of each of a user's individual parameters."""

    def __post_init__(self) -> None:
        for field in fields(self):
            greatest = 1.0 if field.name in ("pursuit", "spread") else 100.0
            value = check.in_range(field.name, getattr(self, field.name), 0.0, greatest)
            object.__setattr__(self, field.name, value)


class Chance:
    """Random number generator of one user."""

    def __init__(self, seed: int, user: int) -> None:
        self._seed, self._user, self._next = seed, user, 0
        self._drawn: list[float] = []

    def uniform(self) -> float:
        """Draw a number in [0, 1)."""
        if not self._drawn:
            index = np.arange(self._next, self._next + 4096, dtype=np.uint64)
            self._next += len(index)
            self._drawn = random.uniform(self._seed, self._user, index).tolist()[::-1]
        return self._drawn.pop()

    def normal(self) -> float:
        """Draw a standard normal number by the Box–Muller transform."""
        return math.sqrt(-2.0 * math.log(1.0 - self.uniform())) * math.cos(2.0 * math.pi * self.uniform())


@dataclass(frozen=True)
class Target:
    """A target as the user sees it at one moment."""

    number: int
    angles: Angles
    width: float
    """Angular diameter, radians."""


@dataclass(frozen=True)
class _Reach:
    """A planned aimed movement."""

    begin: float
    seconds: float
    start: Angles
    end: Angles


class Pointing:
    """Pointing direction of a simulated user, step by step. Times are seconds on any clock.

    `person` has the parameters of all users; `seed` and the user's number `user` determine the individual deviations.
    """

    def __init__(self, person: Person, seed: int, user: int) -> None:
        self._chance = Chance(seed, user)
        individual = {
            name: getattr(person, name) * math.exp(person.spread * self._chance.normal())
            for name in ("reaction", "intercept", "slope", "delay", "gain", "tremor", "search")
        }
        self._person = replace(person, **individual)
        self._aim: Angles = (0.0, 0.0)
        self._tremor: Angles = (0.0, 0.0)
        self._past: deque[tuple[float, Target, Angles]] = deque(maxlen=MAX_MOMENTS)
        self._number: int | None = None
        self._start_time: float | None = None
        self._reach: _Reach | None = None
        self._lapse_end = -math.inf
        self._last_time: float | None = None

    def step(self, now: float, target: Target | None) -> Angles:
        """Return the pointing direction at a time, with or without a visible target."""
        elapsed = 0.0 if self._last_time is None else min(max(now - self._last_time, 0.0), 0.1)
        self._last_time = now
        self._update_tremor(elapsed)
        if target is None:
            self._number = None
            self._past.clear()
        else:
            self._start_reaction(now, target)
            self._past.append((now, target, self._aim))
            self._move(now, elapsed, target)
            self._past[-1] = (now, target, self._aim)
        return self._aim[0] + self._tremor[0], self._aim[1] + self._tremor[1]

    def _start_reaction(self, now: float, target: Target) -> None:
        if target.number == self._number:
            return
        person = self._person
        self._number, self._reach = target.number, None
        self._past.clear()
        delay = max(person.reaction + person.reaction_spread * self._chance.normal(), 0.5 * person.reaction)
        self._start_time = now + delay + person.search

    def _move(self, now: float, elapsed: float, target: Target) -> None:
        if self._start_time is not None:
            if now >= self._start_time:
                self._start_time, self._reach = None, self._plan(now, target.width)
        elif self._reach is not None:
            self._follow(self._reach, now)
        elif not self._lapses(now, elapsed):
            self._track(now, elapsed)

    def _plan(self, now: float, width: float) -> _Reach:
        """Plan a movement to the target's predicted position, extrapolated from its perceived motion."""
        person = self._person
        (yaw, pitch), (yaw_rate, pitch_rate), _ = self._perceive(now)
        size = max(width, 1e-6)
        distance = math.hypot(_turn(yaw - self._aim[0]), pitch - self._aim[1])
        seconds = person.intercept + person.slope * math.log2(distance / size + 1.0)
        lead_seconds = person.pursuit * (person.delay + seconds)
        end = (
            self._aim[0] + _turn(yaw - self._aim[0]) + lead_seconds * yaw_rate + size / SCATTER * self._chance.normal(),
            pitch + lead_seconds * pitch_rate + size / SCATTER * self._chance.normal(),
        )
        return _Reach(now, seconds, self._aim, end)

    def _follow(self, reach: _Reach, now: float) -> None:
        """Follow a minimum-jerk movement (Flash and Hogan, 1985)."""
        fraction = min((now - reach.begin) / reach.seconds, 1.0) if reach.seconds > 0.0 else 1.0
        progress = fraction**3 * (10.0 - 15.0 * fraction + 6.0 * fraction * fraction)
        (a, b), (c, d) = reach.start, reach.end
        self._aim = (a + progress * (c - a), b + progress * (d - b))
        if fraction == 1.0:
            self._reach = None

    def _track(self, now: float, elapsed: float) -> None:
        """Track by the crossover model of McRuer and Jex (1967), with the target's speed as a second input."""
        (yaw, pitch), (yaw_rate, pitch_rate), aim = self._perceive(now)
        person = self._person
        yaw_speed = person.gain * _turn(yaw - aim[0]) + person.pursuit * yaw_rate
        pitch_speed = person.gain * (pitch - aim[1]) + person.pursuit * pitch_rate
        self._aim = (self._aim[0] + elapsed * yaw_speed, self._aim[1] + elapsed * pitch_speed)

    def _lapses(self, now: float, elapsed: float) -> bool:
        """Return whether attention has lapsed, and let the hand sink if so."""
        if now >= self._lapse_end and self._chance.uniform() < self._person.lapses * elapsed:
            self._lapse_end = now + self._person.lapse
        if now >= self._lapse_end:
            return False
        self._aim = (self._aim[0], self._aim[1] - SINK_SPEED * elapsed)
        return True

    def _perceive(self, now: float) -> tuple[Angles, Angles, Angles]:
        """Return target, target speed and aim as perceived now, that is, with the user's delay."""
        # Newest moment older than the delay, or the first moment if the target appeared later than that.
        number = len(self._past) - 1
        while number > 0 and self._past[number][0] > now - self._person.delay:
            number -= 1
        time, target, aim = self._past[number]
        before = number
        while before > 0 and self._past[before][0] > time - GAZE_SECONDS:
            before -= 1
        interval = time - self._past[before][0]
        if interval <= 0.0:
            return target.angles, (0.0, 0.0), aim
        earlier = self._past[before][1].angles
        speed = (_turn(target.angles[0] - earlier[0]) / interval, (target.angles[1] - earlier[1]) / interval)
        return target.angles, speed, aim

    def _update_tremor(self, elapsed: float) -> None:
        """Update tremor, an Ornstein–Uhlenbeck process about both axes."""
        person = self._person
        decay = math.exp(-elapsed / person.tremor_time) if person.tremor_time > 0.0 else 0.0
        size = math.radians(person.tremor) * math.sqrt(1.0 - decay * decay)
        yaw, pitch = self._tremor
        self._tremor = (decay * yaw + size * self._chance.normal(), decay * pitch + size * self._chance.normal())


def _turn(angle: float) -> float:
    """Wrap an angle to [−π, π]."""
    return math.remainder(angle, 2.0 * math.pi)
