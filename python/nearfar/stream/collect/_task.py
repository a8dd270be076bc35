"""The state of the task as a user has heard it, and what its conductor says next. It knows neither room nor clock."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Mapping
from dataclasses import replace

from nearfar.stream.collect import _spheres as spheres
from nearfar.stream.collect._messages import (
    LONGEST,
    MOST_USERS,
    Aims,
    Collected,
    Message,
    Score,
    Sphere,
    Stage,
    Tally,
    Trial,
    Vector,
)
from nearfar.stream.collect._settings import Settings
from nearfar.stream.collect._spheres import Ray

MOST_COUNTED = 2**16 - 1
"""Greatest number of spheres and misses that messages can hold."""

LEAST_PAUSE = 0.05
"""Least seconds from a collected sphere to the next one, so that no rules let a conductor speak without end."""

Rays = Mapping[int, Ray]
"""The last pointers of users by their numbers; users who point nowhere are missing."""


class Task:
    """A group's task. Times are seconds on the clock of whoever calls; a message counts as said when it is heard.

    Parameters
    ----------
    user, group
        The own numbers.
    """

    def __init__(self, user: int, group: int) -> None:
        self.user, self.group = user, group
        self.present = {user}
        """Users of the group who are there."""
        self.trial: Trial | None = None
        self.sphere: Sphere | None = None
        self.aims: tuple[int, ...] = ()
        """Users who aim at the sphere, in ascending order."""
        self.misses = 0
        """Misses of the sphere."""
        self.scores: dict[int, Score] = {}
        """The last scores by group."""
        self.began = self.appeared = 0.0
        self.held_since: float | None = None
        """When the last of all users who are needed began to aim; None while not all do."""
        self.collected: deque[Collected] = deque(maxlen=MOST_COUNTED)
        """The last spheres that were collected, in order."""
        self._next_at = 0.0
        self._is_to_tell = False

    @property
    def conductor(self) -> int:
        """The user who makes and judges spheres: the lowest number of those who play and are there, or of all."""
        playing = self.present & {seat.user for seat in self.trial.seats} if self.trial else set()
        return min(playing or self.present)

    @property
    def needed(self) -> int:
        """Users who must aim at once: as many as the trial asks, or all who play and are there."""
        if self.trial is None:
            return 0
        there = len(self.present & {seat.user for seat in self.trial.seats})
        return min(self.trial.users, max(there, 2))

    @property
    def is_over(self) -> bool:
        """Whether the last trial has ended."""
        return self.trial is not None and self.trial.is_over and self.trial.stage.trial == self.trial.trials

    @property
    def seat(self) -> Vector | None:
        """Where the user's eyes belong."""
        found = [seat.position for seat in self.trial.seats if seat.user == self.user] if self.trial else []
        return found[0] if found else None

    def place(self, now: float) -> Vector | None:
        """Where the middle of the sphere is; None without one."""
        if self.trial is None or self.sphere is None:
            return None
        return spheres.place(self.sphere, self.trial, now - self.appeared)

    def joined(self, user: int) -> None:
        """A user of the group is there, who may have heard nothing."""
        self._is_to_tell |= self.trial is not None and self.conductor == self.user
        self.present.add(user)

    def left(self, user: int) -> None:
        """A user of the group is gone."""
        self.present -= {user} - {self.user}

    def alone(self) -> None:
        """The connection is gone; who is there is told anew, and the task goes on from what was heard."""
        self.present = {self.user}

    def start(self, settings: Settings, now: float) -> list[Message]:
        """Begin the first trial of a run for all who are there; what the conductor says then."""
        run = (self.trial.stage.run + 1) % 2**16 if self.trial else 1
        x, y, z = settings.center
        wide, deep = settings.seats
        area = ((x - wide / 2, y, z - deep / 2), (x + wide / 2, y, z + deep / 2))
        middle = (x, y + settings.rise, z - settings.distance)
        a, b, c = ((at - size / 2, at + size / 2) for at, size in zip(middle, settings.box, strict=True))
        empty = Tally()
        first = Trial(
            Stage(run, 1), settings.trials, False, settings.users, settings.seed, 0.0, settings.duration,
            settings.hold, settings.pause, settings.rest, settings.radius, settings.speeds,
            ((a[0], b[0], c[0]), (a[1], b[1], c[1])), area, (empty, empty, empty), (),
        )  # fmt: skip
        return list(self._said(self._begun(first, first.stage), now))

    def conduct(self, now: float, rays: Rays) -> list[Message]:
        """What the user says as conductor, which it has heard itself then; nothing from all others."""
        said = self._told(now) if self._is_to_tell else []
        self._is_to_tell = False
        while self.user == self.conductor and (message := self._decide(now, rays)) is not None:
            said += self._said(message, now)
        return said

    def hear(self, message: Message, now: float, *, group: int | None = None) -> None:
        """Follow what somebody said; messages of an earlier run, trial or sphere do nothing."""
        if isinstance(message, Score):
            self.scores[self.group if group is None else group] = message
        elif group not in (None, self.group):
            return
        elif isinstance(message, Trial):
            if self.trial is None or _age(message) >= _age(self.trial):
                self._hear_trial(message, now)
        elif self.trial is not None and not self.trial.is_over and message.stage == self.trial.stage:
            self._hear_play(message, now)

    def _hear_trial(self, trial: Trial, now: float) -> None:
        if self.trial is None or trial.stage != self.trial.stage or trial.is_over:
            self.sphere, self._next_at = None, now if trial.elapsed == 0.0 else now + max(trial.pause, LEAST_PAUSE)
            self._rest()
        self.trial, self.began = trial, now - trial.elapsed

    def _hear_play(self, message: Sphere | Aims | Collected, now: float) -> None:
        known = -1 if self.sphere is None else self.sphere.number
        if isinstance(message, Sphere):
            if message.number > known and message.number >= self._count():
                self.sphere, self.appeared = message, now - message.age
                self._rest()
        elif isinstance(message, Aims):
            if message.number == known:
                self.aims, self.misses = message.users, message.misses
                self.held_since = None if message.held is None else now - message.held
        elif self._count() <= message.number < MOST_COUNTED:
            self._hear_collected(message, now)

    def _hear_collected(self, found: Collected, now: float) -> None:
        assert self.trial is not None
        tallies = list(self.trial.tallies)
        old = tallies[found.level]
        misses, seconds = min(old.misses + found.misses, MOST_COUNTED), min(old.seconds + found.seconds, LONGEST)
        tallies[found.level] = Tally(old.spheres + 1, misses, seconds)
        self.trial = replace(self.trial, tallies=(tallies[0], tallies[1], tallies[2]))
        self.collected.append(found)
        self.sphere, self._next_at = None, now + max(self.trial.pause, LEAST_PAUSE)
        self._rest()

    def _rest(self) -> None:
        self.aims, self.misses, self.held_since = (), 0, None

    def _count(self) -> int:
        """Spheres that were collected in the trial, which is the number of the next one."""
        return 0 if self.trial is None else sum(tally.spheres for tally in self.trial.tallies)

    def _said(self, message: Message, now: float) -> Iterator[Message]:
        """A message, heard by the user itself, and the score that follows from it."""
        self.hear(message, now)
        yield message
        if self.trial is not None and isinstance(message, Trial | Collected):
            misses = min(sum(tally.misses for tally in self.trial.tallies), MOST_COUNTED)
            score = Score(self.trial.stage, self.trial.is_over, self._count(), misses)
            self.hear(score, now)
            yield score

    def _told(self, now: float) -> list[Message]:
        """All that somebody must hear who has just come."""
        if self.trial is None:
            return []
        told: list[Message] = [replace(self.trial, elapsed=min(now - self.began, LONGEST))]
        if self.sphere is not None:
            told += [
                replace(self.sphere, age=min(now - self.appeared, LONGEST)),
                self._aiming("told", 0, self.aims, now),
            ]
        return told

    def _begun(self, trial: Trial, stage: Stage) -> Trial:
        users = sorted(self.present)[:MOST_USERS]
        empty = Tally()
        return replace(
            trial, stage=stage, is_over=False, elapsed=0.0, tallies=(empty, empty, empty),
            seats=spheres.seats(trial, stage, self.group, users),
        )  # fmt: skip

    def _decide(self, now: float, rays: Rays) -> Message | None:
        """The next message that the state asks for; None if there is none now."""
        trial = self.trial
        if trial is None:
            return None
        elapsed = now - self.began
        if trial.is_over:
            is_next = trial.stage.trial < trial.trials and elapsed >= trial.duration + trial.rest
            return self._begun(trial, Stage(trial.stage.run, trial.stage.trial + 1)) if is_next else None
        if elapsed >= trial.duration:
            return replace(trial, is_over=True, elapsed=min(elapsed, LONGEST))
        if self.sphere is None:
            is_due = now >= self._next_at and self._count() < MOST_COUNTED
            return spheres.sphere(trial, trial.stage, self.group, self._count()) if is_due else None
        return self._judge(trial, self.sphere, now, rays)

    def _judge(self, trial: Trial, sphere: Sphere, now: float, rays: Rays) -> Message | None:
        center = spheres.place(sphere, trial, now - self.appeared)
        seated = self.present & {seat.user for seat in trial.seats}
        found = {user for user in seated if user in rays and spheres.is_aimed(rays[user], center, trial.radius)}
        for event, changed in (("lost", set(self.aims) - found), ("selected", found - set(self.aims))):
            for user in sorted(changed):
                users = set(self.aims) ^ {user}
                # Who is gone has lost nothing.
                return self._aiming(event if user in self.present else "told", user, tuple(sorted(users)), now)
        if (len(self.aims) >= self.needed) != (self.held_since is not None):
            return self._aiming("told", 0, self.aims, now)
        if self.held_since is not None and now - self.held_since >= trial.hold:
            return Collected(trial.stage, sphere.number, sphere.level, self.misses, min(now - self.appeared, LONGEST))
        return None

    def _aiming(self, event: str, user: int, users: tuple[int, ...], now: float) -> Aims:
        assert self.trial is not None
        assert self.sphere is not None
        held = None
        if len(users) >= self.needed:
            held = 0.0 if self.held_since is None else now - self.held_since
        misses = min(self.misses + (event == "lost"), MOST_COUNTED)
        return Aims(self.trial.stage, self.sphere.number, event, user, misses, held, users)


def _age(trial: Trial) -> tuple[int, int, bool, int]:
    """What grows from a message of a trial to the next one."""
    return trial.stage.run, trial.stage.trial, trial.is_over, sum(tally.spheres for tally in trial.tallies)
