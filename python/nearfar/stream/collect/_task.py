"""State of the task as one user knows it, and the conductor's messages. It uses neither a room nor a clock."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Collection, Mapping
from dataclasses import replace

from nearfar.stream.collect import _spheres as spheres
from nearfar.stream.collect._messages import (
    MAX_SECONDS,
    MAX_USERS,
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

MAX_COUNT = 2**16 - 1
"""Greatest number of spheres and of misses that messages can hold."""

MIN_PAUSE = 0.05
"""Least seconds from a sphere's collection to the next sphere; bounds the conductor's message rate for any settings."""

MIN_JUDGEMENT_INTERVAL = 1.0 / 80.0
"""Least seconds between two judgements; shorter than between two poses, so that every pose can be judged."""

AIMS_RATE, AIMS_BURST = 16_384.0, 8192.0
"""Rate limit of `Aims` messages in bytes per second, half of the room's limit, and burst size in bytes."""

AIMS_BYTES, USER_BYTES = 64, 2
"""Bytes that an `Aims` message is charged without users (at least the room's minimum charge), and per user."""

ENTRY_SECONDS = 5.0
"""Seconds after entering in which every sender is accepted, because the conductor is not known yet."""

NO_TALLIES = (Tally(), Tally(), Tally())

Rays = Mapping[int, Ray]
"""Last pointers of users by number; users without a pointer are missing."""


class Task:
    """A group's task as one user of the group knows it; `user` and `group` are numbers.

    Times are seconds on the caller's clock; a message's time is its arrival time.
    """

    def __init__(self, user: int, group: int) -> None:
        self.user, self.group = user, group
        self.present = {user}
        """Users of the group who are connected."""
        self.trial: Trial | None = None
        self.sphere: Sphere | None = None
        self.aims: tuple[int, ...] = ()
        """Users who aim at the sphere, in ascending order."""
        self.misses = 0
        """Misses of the sphere."""
        self.scores: dict[int, Score] = {}
        """Last scores by group."""
        self.start_time = self.appeared = 0.0
        self.held_since: float | None = None
        """Time at which the last required user began to aim; None while some do not."""
        self.collected: deque[Collected] = deque(maxlen=MAX_COUNT)
        """Last collected spheres, in order."""
        self._next_sphere_time = 0.0
        self._must_send_state = False
        self._judgement_time = -math.inf
        # Token bucket of `Aims` messages: a room disconnects a user who sends too many bytes.
        self._aims_budget, self._aims_time = AIMS_BURST, 0.0
        # Conductor before the last user joined; its last messages may arrive after that user has joined.
        self._former_conductor: int | None = None
        # Time until which every sender is accepted; None until the first call after entering.
        self._entered_until: float | None = None

    @property
    def conductor(self) -> int:
        """The user who creates and judges spheres: the lowest number of the seated users present, or of all present."""
        return min(self._seated_users() or self.present)

    @property
    def needed(self) -> int:
        """Number of users who must aim at once: all present seated users, at least 2, at most the trial's number."""
        if self.trial is None:
            return 0
        return min(self.trial.users, max(len(self._seated_users()), 2))

    @property
    def is_over(self) -> bool:
        """Whether the last trial has ended."""
        return self.trial is not None and self.trial.is_over and self.trial.stage.trial == self.trial.trials

    @property
    def seat(self) -> Vector | None:
        """Position of the user's eyes in its seat; None without a seat."""
        seats = self.trial.seats if self.trial else ()
        return next((seat.position for seat in seats if seat.user == self.user), None)

    def place(self, now: float) -> Vector | None:
        """Return the position of the sphere's centre; None without a sphere."""
        if self.trial is None or self.sphere is None:
            return None
        return spheres.place(self.sphere, self.trial, now - self.appeared)

    def add_user(self, user: int) -> None:
        """Record that a user of the group has joined; the conductor then sends them the state."""
        before = self.conductor
        self._must_send_state |= self.trial is not None and before == self.user
        self.present.add(user)
        if self.conductor != before:
            self._former_conductor = before

    def remove_user(self, user: int) -> None:
        """Record that a user of the group has left."""
        self.present -= {user} - {self.user}
        if user == self._former_conductor:
            self._former_conductor = None

    def forget_users(self) -> None:
        """Handle a broken connection: forget the users, who are announced again later; the task's state stays."""
        self.present = {self.user}
        self.forget_scores((self.group,))
        self._former_conductor = self._entered_until = None

    def forget_scores(self, groups: Collection[int]) -> None:
        """Discard the scores of all groups except those listed."""
        self.scores = {group: score for group, score in self.scores.items() if group in groups}

    def start(self, settings: Settings, now: float) -> list[Message]:
        """Begin the first trial of a run for all users who are present; returns the conductor's messages."""
        run = (self.trial.stage.run + 1) % 2**16 if self.trial else 1
        x, y, z = settings.center
        width, depth = settings.seats
        area = ((x - width / 2, y, z - depth / 2), (x + width / 2, y, z + depth / 2))
        middle = (x, y + settings.rise, z - settings.distance)
        a, b, c = ((value - size / 2, value + size / 2) for value, size in zip(middle, settings.box, strict=True))
        first = Trial(
            Stage(run, 1), settings.trials, False, settings.users, settings.seed, 0.0, settings.duration,
            settings.hold, settings.pause, settings.rest, settings.radius, settings.speeds,
            ((a[0], b[0], c[0]), (a[1], b[1], c[1])), area, NO_TALLIES, (),
        )  # fmt: skip
        return self._apply_own(self._create_trial(first, first.stage), now)

    def conduct(self, now: float, rays: Rays) -> list[Message]:
        """Return the user's messages as conductor, already applied to its own state; none if it does not conduct."""
        self._enter(now)
        messages = self._state_messages(now) if self._must_send_state else []
        self._must_send_state = False
        is_due = now - self._judgement_time >= MIN_JUDGEMENT_INTERVAL
        self._judgement_time = now if is_due else self._judgement_time
        while self.user == self.conductor:
            message = self._decide(now, rays if is_due else None)
            # If a message exceeds the rate limit, the change is judged again later.
            if message is None or (isinstance(message, Aims) and not self._may_send(message, now)):
                break
            applied = self._apply_own(message, now)
            if not applied:
                # A message without effect would be chosen again and again.
                break
            messages += applied
        return messages

    def _may_send(self, aims: Aims, now: float) -> bool:
        """Consume the bytes of a message from the budget; False if too few are left."""
        self._aims_budget = min(self._aims_budget + AIMS_RATE * max(now - self._aims_time, 0.0), AIMS_BURST)
        self._aims_time = now
        size = AIMS_BYTES + USER_BYTES * len(aims.users)
        if size > self._aims_budget:
            return False
        self._aims_budget -= size
        return True

    def hear(self, message: Message, now: float, *, sender: int | None = None, group: int | None = None) -> bool:
        """Apply a message of a user, by default of this user; returns whether it had an effect.

        Messages about an earlier run, trial or sphere are ignored, and messages about a trial from users other than its
        conductor.
        """
        if isinstance(message, Score):
            self.scores[self.group if group is None else group] = message
            return True
        self._enter(now)
        if group not in (None, self.group) or not self._accepts(self.user if sender is None else sender, now):
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
            self._entered_until = now + ENTRY_SECONDS

    def _accepts(self, sender: int, now: float) -> bool:
        if sender == self.user or self._entered_until is None or now < self._entered_until:
            return True
        # Without seated users anybody may begin. If two begin at the same time, the lower number wins.
        return not self._seated_users() or sender <= self.conductor or sender == self._former_conductor

    def _hear_trial(self, trial: Trial, now: float) -> None:
        is_other = self.trial is None or trial.stage != self.trial.stage or trial.is_over
        # A user who returns during a pause may know a sphere that was collected meanwhile.
        is_collected = self.sphere is not None and self.sphere.number < _sphere_count(trial)
        if is_other or is_collected:
            self.sphere = None
            self._next_sphere_time = now if trial.elapsed == 0.0 else now + max(trial.pause, MIN_PAUSE)
            self._clear_aims()
        self.trial, self.start_time = trial, now - trial.elapsed

    def _hear_play(self, message: Sphere | Aims | Collected, now: float) -> bool:
        number = -1 if self.sphere is None else self.sphere.number
        is_next = message.number == self._count() and message.number < MAX_COUNT
        if isinstance(message, Sphere):
            # The count must leave room for the sphere's collection.
            if message.number == number or not is_next:
                return False
            self.sphere, self.appeared = message, now - message.age
            self._clear_aims()
        elif isinstance(message, Aims):
            if message.number != number:
                return False
            self.aims, self.misses = message.users, message.misses
            self.held_since = None if message.held is None else now - message.held
        elif is_next:
            self._hear_collected(message, now)
        else:
            return False
        return True

    def _hear_collected(self, collected: Collected, now: float) -> None:
        assert self.trial is not None
        tallies = list(self.trial.tallies)
        tally = tallies[collected.level]
        misses = min(tally.misses + collected.misses, MAX_COUNT)
        tallies[collected.level] = Tally(tally.spheres + 1, misses, min(tally.seconds + collected.seconds, MAX_SECONDS))
        self.trial = replace(self.trial, tallies=(tallies[0], tallies[1], tallies[2]))
        self.collected.append(collected)
        self.sphere, self._next_sphere_time = None, now + max(self.trial.pause, MIN_PAUSE)
        self._clear_aims()

    def _clear_aims(self) -> None:
        self.aims, self.misses, self.held_since = (), 0, None

    def _count(self) -> int:
        """Return the number of collected spheres of the trial, which is the number of the next sphere."""
        return 0 if self.trial is None else _sphere_count(self.trial)

    def _seated_users(self) -> set[int]:
        """Return the seated users who are present."""
        return self.present & {seat.user for seat in self.trial.seats} if self.trial else set()

    def _apply_own(self, message: Message, now: float) -> list[Message]:
        """Apply a message of this user; return it with the resulting score, or nothing if it has no effect."""
        if not self.hear(message, now):
            return []
        if self.trial is None or not isinstance(message, Trial | Collected):
            return [message]
        misses = min(sum(tally.misses for tally in self.trial.tallies), MAX_COUNT)
        score = Score(self.trial.stage, self.trial.is_over, min(self._count(), MAX_COUNT), misses)
        self.hear(score, now)
        return [message, score]

    def _state_messages(self, now: float) -> list[Message]:
        """Return the messages that a new user needs."""
        if self.trial is None:
            return []
        messages: list[Message] = [replace(self.trial, elapsed=min(now - self.start_time, MAX_SECONDS))]
        if self.sphere is not None:
            messages.append(replace(self.sphere, age=min(now - self.appeared, MAX_SECONDS)))
            messages.append(self._aims_message("told", 0, self.aims, now))
        return messages

    def _create_trial(self, trial: Trial, stage: Stage) -> Trial:
        seats = spheres.seats(trial, stage, self.group, sorted(self.present)[:MAX_USERS])
        return replace(trial, stage=stage, is_over=False, elapsed=0.0, tallies=NO_TALLIES, seats=seats)

    def _decide(self, now: float, rays: Rays | None) -> Message | None:
        """Return the next message that the state requires, or None. Without rays no aim is judged."""
        trial = self.trial
        if trial is None:
            return None
        elapsed = now - self.start_time
        if trial.is_over:
            is_next = trial.stage.trial < trial.trials and elapsed >= trial.duration + trial.rest
            return self._create_trial(trial, Stage(trial.stage.run, trial.stage.trial + 1)) if is_next else None
        if elapsed >= trial.duration:
            return replace(trial, is_over=True, elapsed=min(elapsed, MAX_SECONDS))
        if self.sphere is None:
            is_due = now >= self._next_sphere_time and self._count() < MAX_COUNT
            return spheres.sphere(trial, trial.stage, self.group, self._count()) if is_due else None
        return None if rays is None else self._judge(trial, self.sphere, now, rays)

    def _judge(self, trial: Trial, sphere: Sphere, now: float, rays: Rays) -> Message | None:
        center = spheres.place(sphere, trial, now - self.appeared)
        seated = self._seated_users() & rays.keys()
        aiming = {user for user in seated if spheres.is_aimed(rays[user], center, trial.radius)}
        for event, changed in (("lost", set(self.aims) - aiming), ("selected", aiming - set(self.aims))):
            for user in sorted(changed):
                users = set(self.aims) ^ {user}
                # A user who leaves does not count as a miss.
                return self._aims_message(event if user in self.present else "told", user, tuple(sorted(users)), now)
        if (len(self.aims) >= self.needed) != (self.held_since is not None):
            return self._aims_message("told", 0, self.aims, now)
        if self.held_since is not None and now - self.held_since >= trial.hold:
            seconds = min(now - self.appeared, MAX_SECONDS)
            return Collected(trial.stage, sphere.number, sphere.level, self.misses, seconds)
        return None

    def _aims_message(self, event: str, user: int, users: tuple[int, ...], now: float) -> Aims:
        assert self.trial is not None
        assert self.sphere is not None
        aim_seconds = None
        if len(users) >= self.needed:
            aim_seconds = 0.0 if self.held_since is None else min(now - self.held_since, MAX_SECONDS)
        misses = min(self.misses + (event == "lost"), MAX_COUNT)
        return Aims(self.trial.stage, self.sphere.number, event, user, misses, aim_seconds, users)


def _sphere_count(trial: Trial) -> int:
    return sum(tally.spheres for tally in trial.tallies)


def _is_earlier(message: Trial, known_trial: Trial) -> bool:
    """Return whether a message about a trial is older than the known state."""
    # Run numbers are cyclic.
    ahead = (message.stage.run - known_trial.stage.run) % 2**16
    return ahead >= 2**15 if ahead else _progress_key(message) < _progress_key(known_trial)


def _progress_key(trial: Trial) -> tuple[int, bool, int]:
    """Return a key that grows with each message of a run."""
    return trial.stage.trial, trial.is_over, _sphere_count(trial)
