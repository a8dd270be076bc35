"""The state of the task as a user has heard it, and what its conductor says next. It knows neither room nor clock."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Collection, Mapping
from dataclasses import replace

from nearfar.stream.collect import _spheres as spheres
from nearfar.stream.collect._allowance import Allowance
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

LEAST_JUDGED = 1.0 / 80.0
"""Least seconds between two judgements, less than those between two poses: each pose may ask for one."""

ENTERING = 5.0
"""Seconds after an entry in which anybody is believed: the user does not know yet who conducts."""

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
        self._judged_at = -math.inf
        self._allowance = Allowance()
        # Who conducted before the last user joined: its last words may come after that.
        self._former: int | None = None
        # Until when anybody is believed; None until the first moment after the entry.
        self._entered_until: float | None = None

    @property
    def conductor(self) -> int:
        """The user who makes and judges spheres: the lowest number of those who play and are there, or of all."""
        return min(self._seated() or self.present)

    @property
    def needed(self) -> int:
        """Users who must aim at once: as many as the trial asks, or all who play and are there."""
        if self.trial is None:
            return 0
        return min(self.trial.users, max(len(self._seated()), 2))

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
        before = self.conductor
        self._is_to_tell |= self.trial is not None and before == self.user
        self.present.add(user)
        if self.conductor != before:
            self._former = before

    def left(self, user: int) -> None:
        """A user of the group is gone."""
        self.present -= {user} - {self.user}
        if user == self._former:
            self._former = None

    def alone(self) -> None:
        """The connection is gone; who is there is told anew, and the task goes on from what was heard."""
        self.present = {self.user}
        self.forget_scores((self.group,))
        self._former = self._entered_until = None

    def forget_scores(self, there: Collection[int]) -> None:
        """Forget the scores of all groups but those in which users are there."""
        self.scores = {group: score for group, score in self.scores.items() if group in there}

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
        return self._said(self._begun(first, first.stage), now)

    def conduct(self, now: float, rays: Rays) -> list[Message]:
        """Messages of the user as conductor, which it has heard itself then; none from all others."""
        self._enter(now)
        said = self._told(now) if self._is_to_tell else []
        self._is_to_tell = False
        is_due = now - self._judged_at >= LEAST_JUDGED
        self._judged_at = now if is_due else self._judged_at
        while self.user == self.conductor:
            message = self._decide(now, rays if is_due else None)
            # A change that waits is judged anew when it may be said.
            if message is None or (isinstance(message, Aims) and not self._allowance.take(len(message.users), now)):
                break
            heard = self._said(message, now)
            if not heard:
                # A message that changes nothing would be decided on again and again.
                break
            said += heard
        return said

    def hear(self, message: Message, now: float, *, sender: int | None = None, group: int | None = None) -> bool:
        """Follow what a user of a group said, by default the user itself; whether it changed anything.

        Messages of an earlier run, trial or sphere do nothing, nor do those about a trial from whoever does not
        conduct it.
        """
        if isinstance(message, Score):
            self.scores[self.group if group is None else group] = message
            return True
        self._enter(now)
        if group not in (None, self.group) or not self._believes(self.user if sender is None else sender, now):
            return False
        if isinstance(message, Trial):
            if self.trial is not None and _is_earlier(message, self.trial):
                return False
            self._hear_trial(message, now)
            return True
        if self.trial is None or self.trial.is_over or message.stage != self.trial.stage:
            return False
        return self._hear_play(message, now)

    def _enter(self, now: float) -> None:
        if self._entered_until is None:
            self._entered_until = now + ENTERING

    def _believes(self, sender: int, now: float) -> bool:
        if sender == self.user or self._entered_until is None or now < self._entered_until:
            return True
        # Where nobody who plays is there, anybody may begin. Two who begin at once follow the lower number.
        return not self._seated() or sender <= self.conductor or sender == self._former

    def _hear_trial(self, trial: Trial, now: float) -> None:
        is_other = self.trial is None or trial.stage != self.trial.stage or trial.is_over
        # Who returns in a pause may know a sphere that was collected meanwhile.
        is_collected = self.sphere is not None and self.sphere.number < _count_of(trial)
        if is_other or is_collected:
            self.sphere, self._next_at = None, now if trial.elapsed == 0.0 else now + max(trial.pause, LEAST_PAUSE)
            self._rest()
        self.trial, self.began = trial, now - trial.elapsed

    def _hear_play(self, message: Sphere | Aims | Collected, now: float) -> bool:
        known = -1 if self.sphere is None else self.sphere.number
        is_next = message.number == self._count() and message.number < MOST_COUNTED
        if isinstance(message, Sphere):
            # `collected` must be able to follow it.
            if message.number == known or not is_next:
                return False
            self.sphere, self.appeared = message, now - message.age
            self._rest()
        elif isinstance(message, Aims):
            if message.number != known:
                return False
            self.aims, self.misses = message.users, message.misses
            self.held_since = None if message.held is None else now - message.held
        elif is_next:
            self._hear_collected(message, now)
        else:
            return False
        return True

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
        return 0 if self.trial is None else _count_of(self.trial)

    def _seated(self) -> set[int]:
        """Users who play and are there."""
        return self.present & {seat.user for seat in self.trial.seats} if self.trial else set()

    def _said(self, message: Message, now: float) -> list[Message]:
        """A message, heard by the user itself, and the score that follows from it; nothing if it changes nothing."""
        if not self.hear(message, now):
            return []
        if self.trial is None or not isinstance(message, Trial | Collected):
            return [message]
        misses = min(sum(tally.misses for tally in self.trial.tallies), MOST_COUNTED)
        score = Score(self.trial.stage, self.trial.is_over, min(self._count(), MOST_COUNTED), misses)
        self.hear(score, now)
        return [message, score]

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

    def _decide(self, now: float, rays: Rays | None) -> Message | None:
        """The next message that the state asks for; None if there is none now. Nobody is judged without rays."""
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
        return None if rays is None else self._judge(trial, self.sphere, now, rays)

    def _judge(self, trial: Trial, sphere: Sphere, now: float, rays: Rays) -> Message | None:
        center = spheres.place(sphere, trial, now - self.appeared)
        found = {user for user in self._seated() if user in rays and spheres.is_aimed(rays[user], center, trial.radius)}
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
            held = 0.0 if self.held_since is None else min(now - self.held_since, LONGEST)
        misses = min(self.misses + (event == "lost"), MOST_COUNTED)
        return Aims(self.trial.stage, self.sphere.number, event, user, misses, held, users)


def _count_of(trial: Trial) -> int:
    return sum(tally.spheres for tally in trial.tallies)


def _is_earlier(one: Trial, other: Trial) -> bool:
    """Whether a message of a trial tells less than another one."""
    # Numbers of runs count in a circle, so that no number is the last one.
    ahead = (one.stage.run - other.stage.run) % 2**16
    if ahead:
        return ahead >= 2**15
    return _age(one) < _age(other)


def _age(trial: Trial) -> tuple[int, bool, int]:
    """Numbers that grow from a message of a run to the next one."""
    return trial.stage.trial, trial.is_over, _count_of(trial)
