"""Simulated users on a virtual clock: the same task and messages, with network delays in place of a server."""

from __future__ import annotations

import heapq
from collections.abc import Callable
from itertools import count

from nearfar._base import check
from nearfar.stream.collect._messages import Message, read, write
from nearfar.stream.collect._outcomes import Outcome, outcomes
from nearfar.stream.collect._person import Chance, Person
from nearfar.stream.collect._player import Player
from nearfar.stream.collect._settings import Settings
from nearfar.stream.collect._spheres import Ray
from nearfar.stream.collect._task import Task

RATE = 72.0
"""Poses per second."""

LEG = (0.0145, 0.007)
"""Mean and standard deviation of the one-way delay between a user and the server, seconds: the paper's round trip
of 58 ± 14 ms consists of four such legs."""

MIN_LEG = 0.001
"""Least one-way delay, seconds."""


class _Network:
    """Messages in flight, in the order of arrival."""

    def __init__(self, leg: tuple[float, float], seed: int) -> None:
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


class _User:
    """A user with its own state of the task."""

    def __init__(self, number: int, group: int, person: Person, seed: int) -> None:
        self.task, self.player = Task(number, group), Player(person, seed, number)
        self.rays: dict[int, Ray] = {}

    def hear(self, data: bytes, sender: int, group: int) -> Callable[[float], None]:
        """Return the handler for a message's arrival."""

        def arrive(now: float) -> None:
            message = read(data)
            if message is not None:
                self.task.hear(message, now, sender=sender, group=group)

        return arrive

    def see(self, user: int, ray: Ray) -> Callable[[float], None]:
        """Return the handler for a pose's arrival."""

        def arrive(now: float) -> None:
            del now
            self.rays[user] = ray

        return arrive


def simulate(
    settings: Settings | None = None,
    *,
    person: Person | None = None,
    groups: int = 2,
    seed: int = 0,
    leg: tuple[float, float] = LEG,
) -> list[Outcome]:
    """Let simulated users collect spheres, faster than in real time and with reproducible results.

    Parameters
    ----------
    settings
        Settings of the task; by default the published ones.
    person
        Parameters of the users; by default those of the literature.
    groups
        Number of simultaneous groups with `settings.users` users each.
    seed
        Seed of the randomness of users and delays; spheres and seats use the seed of the settings.
    leg
        Mean and standard deviation of the one-way delay between a user and the server, seconds.

    Returns
    -------
    list[Outcome]
        Results of the trials in order, group by group.

    Raises
    ------
    ValueError, TypeError
        For a number of groups outside 1 to 64, times below 0 or above 10 s, and arguments of another type.
    """
    chosen = Settings() if settings is None else check.instance("settings", settings, Settings)
    people = Person() if person is None else check.instance("person", person, Person)
    number, seeded = check.integer("groups", groups, 1, 64), check.integer("seed", seed, 0, 2**32 - 1)
    if not isinstance(leg, tuple | list) or len(leg) != 2:
        raise TypeError(f"leg: expected a mean and a standard deviation, got {check.type_and_value(leg)}")
    mean, deviation = (check.in_range("leg", value, 0.0, 10.0) for value in leg)
    found = []
    for group in range(1, number + 1):
        found += _group(chosen, people, group, seeded, (mean, deviation))
    return found


def _group(settings: Settings, person: Person, group: int, seed: int, leg: tuple[float, float]) -> list[Outcome]:
    """Simulate a group's trials; groups are independent, because they exchange only scores, which affect nothing."""
    first = 1 + (group - 1) * settings.users
    users = [_User(first + n, group, person, seed) for n in range(settings.users)]
    network = _Network(leg, seed * 64 + group)
    conductor = users[0]
    for user in users:
        for other in users:
            user.task.add_user(other.task.user)

    def say(messages: list[Message], now: float) -> None:
        for message in messages:
            data = write(message)
            sender = conductor.task.user
            for user in users[1:]:
                network.send(now, sender, user.task.user, user.hear(data, sender, group))

    say(conductor.task.start(settings, 0.0), 0.0)
    steps = 0
    while not conductor.task.is_over:
        steps += 1
        now = steps / RATE
        network.deliver(now)
        for user in users:
            stance = user.player.stance(user.task, now)
            if stance is None:
                continue
            arrive = conductor.see(user.task.user, stance.ray)
            if user is conductor:
                arrive(now)
            else:
                network.send(now, user.task.user, conductor.task.user, arrive)
        say(conductor.task.conduct(now, conductor.rays), now)
    return outcomes(conductor.task)
