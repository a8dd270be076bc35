"""Results of a group's trials."""

from __future__ import annotations

from dataclasses import dataclass

from nearfar.stream.collect._messages import LEVELS, Collected as Message
from nearfar.stream.collect._task import Task


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
    run, last = task.trial.stage.run, task.trial.stage.trial

    def collected_in(trial: int) -> tuple[Collected, ...]:
        heard = (message for message in task.collected if (message.stage.run, message.stage.trial) == (run, trial))
        return tuple(map(_collected, heard))

    return [Outcome(task.group, trial, collected_in(trial)) for trial in range(1, last + 1)]


def _collected(message: Message) -> Collected:
    return Collected(LEVELS[message.level], message.seconds, message.misses)
