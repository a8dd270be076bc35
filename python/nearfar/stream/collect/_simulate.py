"""Groups of simulated users in their seats, on a virtual clock, with network delays instead of a server."""

from __future__ import annotations

import heapq
import math
from collections import defaultdict
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from itertools import count

from nearfar._base import check
from nearfar._camera.camera import Quaternion, orientation_of, viewing_direction
from nearfar.stream.collect._messages import LEVELS, Message, Vector, read, write
from nearfar.stream.collect._person import Chance, Person, Pointing, Target
from nearfar.stream.collect._settings import Settings
from nearfar.stream.collect._spheres import Ray
from nearfar.stream.collect._task import Task

RATE = 72.0
"""Poses per second."""

Leg = tuple[float, float]
"""Mean and standard deviation of the one-way delay between a user and the server, seconds."""

LEG = (0.0145, 0.007)
"""Default delay: the paper's round trip of 58 ± 14 ms consists of four such legs."""

MIN_LEG = 0.001
"""Least one-way delay, seconds."""

HAND_DROP = 0.3
"""Vertical distance from the eyes down to the hand, metres."""


@dataclass(frozen=True)
class Collected:
    """A sphere that a group has collected."""

    level: str
    """Level: easy, intermediate or hard."""
    seconds: float
    """Seconds from appearance to collection."""
    misses: int
    """Number of times that a user lost the selection."""


@dataclass(frozen=True)
class Outcome:
    """Result of a group's trial."""

    group: int
    """Number of the group."""
    trial: int
    """Number of the trial, from 1."""
    spheres: tuple[Collected, ...]
    """Collected spheres, in the order of collection."""


def outcomes(task: Task) -> list[Outcome]:
    """Return the results of the task's last known run."""
    if task.trial is None:
        return []
    stage, spheres = task.trial.stage, defaultdict[int, list[Collected]](list)
    for message in task.collected:
        if message.stage.run == stage.run:
            spheres[message.stage.trial].append(Collected(LEVELS[message.level], message.seconds, message.misses))
    return [Outcome(task.group, trial, tuple(spheres[trial])) for trial in range(1, stage.trial + 1)]


@dataclass(frozen=True)
class Stance:
    """Positions of a user's eyes and hand, and their common direction."""

    eyes: Vector
    hand: Vector
    rotation: Quaternion
    length: float
    """Length of the pointer: distance to the sphere, metres."""

    @property
    def ray(self) -> Ray:
        """Pointing ray: origin and direction."""
        return self.hand, viewing_direction(self.rotation)


def stance_of(pointing: Pointing, task: Task, now: float) -> Stance | None:
    """Return a simulated user's stance at a time, given its state of the task; None without a seat."""
    eyes = task.seat
    if eyes is None or task.trial is None:
        return None
    hand = (eyes[0], eyes[1] - HAND_DROP, eyes[2])
    center, target, length = task.place(now), None, 1.0
    if center is not None and task.sphere is not None:
        x, y, z = (center[axis] - hand[axis] for axis in range(3))
        length = math.hypot(x, y, z)
        angles = (math.atan2(-x, -z), math.atan2(y, math.hypot(x, z)))
        target = Target(task.sphere.number, angles, 2.0 * math.atan2(task.trial.radius, length))
    return Stance(eyes, hand, orientation_of(*pointing.step(now, target)), length)


class _Network:
    """Messages in flight, in the order of arrival."""

    def __init__(self, leg: Leg, seed: int) -> None:
        self._leg, self._chance, self._numbers = leg, Chance(seed, 2**32), count()
        self._waiting: list[tuple[float, int, Callable[[float], None]]] = []
        self._last: dict[tuple[int, int], float] = {}

    def send(self, now: float, sender: int, receiver: int, arrive: Callable[[float], None]) -> None:
        """Send a message through the server; messages between two users keep their order."""
        mean, deviation = self._leg
        legs = (max(mean + deviation * self._chance.normal(), min(MIN_LEG, mean)) for _ in range(2))
        time = max(now + sum(legs), self._last.get((sender, receiver), 0.0))
        self._last[sender, receiver] = time
        heapq.heappush(self._waiting, (time, next(self._numbers), arrive))

    def deliver(self, now: float) -> None:
        """Deliver all messages that have arrived by now."""
        while self._waiting and self._waiting[0][0] <= now:
            time, _, arrive = heapq.heappop(self._waiting)
            arrive(time)


def simulate(
    settings: Settings | None = None,
    *,
    person: Person | None = None,
    groups: int = 2,
    seed: int = 0,
    leg: Leg = LEG,
) -> list[Outcome]:
    """Let simulated users collect spheres, faster than in real time and with reproducible results.

    Returns the results of the trials in order, group by group.

    Parameters
    ----------
    settings
        Settings of the task; by default the published ones.
    person
        Parameters of the users; by default those of the literature.
    groups
        Number of simultaneous groups with `settings.users` users each, 1 to 64.
    seed
        Seed of the randomness of users and delays; spheres and seats use the seed of the settings.
    leg
        Mean and standard deviation of the one-way delay between a user and the server, 0 to 10 s.
    """
    rules = Settings() if settings is None else check.instance("settings", settings, Settings)
    people = Person() if person is None else check.instance("person", person, Person)
    number, seeded = check.integer("groups", groups, 1, 64), check.integer("seed", seed, 0, 2**32 - 1)
    if not isinstance(leg, tuple | list) or len(leg) != 2:
        raise TypeError(f"leg: expected a mean and a standard deviation, got {check.type_and_value(leg)}")
    mean, deviation = (check.in_range("leg", value, 0.0, 10.0) for value in leg)
    simulate_one = partial(_simulate_group, rules, people, seeded, (mean, deviation))
    return [outcome for group in range(1, number + 1) for outcome in simulate_one(group)]


def _simulate_group(settings: Settings, person: Person, seed: int, leg: Leg, group: int) -> list[Outcome]:
    """Simulate a group's trials; groups are independent, because they exchange only scores, which affect nothing."""
    numbers = range(1 + (group - 1) * settings.users, 1 + group * settings.users)
    tasks = [Task(number, group) for number in numbers]
    pointings = [Pointing(person, seed, number) for number in numbers]
    network, conductor, rays = _Network(leg, seed * 64 + group), tasks[0], dict[int, Ray]()
    for task in tasks:
        for number in numbers:
            task.add_user(number)

    def hear(task: Task, data: bytes, now: float) -> None:
        message = read(data)
        assert message is not None
        task.hear(message, now, sender=conductor.user, group=group)

    def see(user: int, ray: Ray, _: float) -> None:
        rays[user] = ray

    def say(messages: list[Message], now: float) -> None:
        for data in map(write, messages):
            for task in tasks[1:]:
                network.send(now, conductor.user, task.user, partial(hear, task, data))

    say(conductor.start(settings, 0.0), 0.0)
    steps = count(1)
    while not conductor.is_over:
        now = next(steps) / RATE
        network.deliver(now)
        for task, pointing in zip(tasks, pointings, strict=True):
            stance = stance_of(pointing, task, now)
            if stance is None:
                continue
            arrive = partial(see, task.user, stance.ray)
            if task is conductor:
                arrive(now)
            else:
                network.send(now, task.user, conductor.user, arrive)
        say(conductor.conduct(now, rays), now)
    return outcomes(conductor)
