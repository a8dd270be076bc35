"""A simulated user in its seat: what it sees of the task, and its pointing ray."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TypeAlias

from nearfar.stream.collect._messages import Vector
from nearfar.stream.collect._person import Person, Pointing, Target
from nearfar.stream.collect._spheres import Ray
from nearfar.stream.collect._task import Task

Rotation: TypeAlias = tuple[float, float, float, float]
"""A unit quaternion (x, y, z, w)."""

BELOW = 0.3
"""Vertical distance from the eyes down to the hand, metres."""


@dataclass(frozen=True)
class Stance:
    """Positions of a user's eyes and hand, and their common direction."""

    eyes: Vector
    hand: Vector
    rotation: Rotation
    length: float
    """Length of the pointer: distance to the sphere, metres."""

    @property
    def ray(self) -> Ray:
        """Pointing ray: origin and direction."""
        return self.hand, rotated(self.rotation)


class Player:
    """Eyes and hand of a user, driven by the task's state."""

    def __init__(self, person: Person, seed: int, user: int) -> None:
        self._pointing = Pointing(person, seed, user)

    def stance(self, task: Task, now: float) -> Stance | None:
        """Return the user's stance at a time; None without a seat."""
        eyes = task.seat
        if eyes is None or task.trial is None:
            return None
        hand = (eyes[0], eyes[1] - BELOW, eyes[2])
        center, target, length = task.place(now), None, 1.0
        if center is not None and task.sphere is not None:
            away = (center[0] - hand[0], center[1] - hand[1], center[2] - hand[2])
            length = math.hypot(*away)
            angles = (math.atan2(-away[0], -away[2]), math.atan2(away[1], math.hypot(away[0], away[2])))
            target = Target(task.sphere.number, angles, 2.0 * math.atan2(task.trial.radius, length))
        return Stance(eyes, hand, rotation_of(*self._pointing.step(now, target)), length)


def rotation_of(yaw: float, pitch: float) -> Rotation:
    """Return the rotation that turns −z to a yaw and a pitch."""
    sy, cy = math.sin(yaw / 2), math.cos(yaw / 2)
    sp, cp = math.sin(pitch / 2), math.cos(pitch / 2)
    return cy * sp, sy * cp, -sy * sp, cy * cp


def rotated(rotation: Rotation) -> Vector:
    """Return −z rotated by a quaternion."""
    x, y, z, w = rotation
    return -2.0 * (x * z + w * y), 2.0 * (w * x - y * z), 2.0 * (x * x + y * y) - 1.0
