"""A simulated user in its seat: what it sees of the task, and its pointing ray."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TypeAlias

from nearfar.stream.collect._messages import Vector
from nearfar.stream.collect._person import Pointing, Target
from nearfar.stream.collect._spheres import Ray
from nearfar.stream.collect._task import Task

Rotation: TypeAlias = tuple[float, float, float, float]
"""A unit quaternion (x, y, z, w)."""

HAND_DROP = 0.3
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
    return Stance(eyes, hand, rotation_of(*pointing.step(now, target)), length)


def rotation_of(yaw: float, pitch: float) -> Rotation:
    """Return the rotation that turns −z to a yaw and a pitch."""
    sy, cy = math.sin(yaw / 2), math.cos(yaw / 2)
    sp, cp = math.sin(pitch / 2), math.cos(pitch / 2)
    return cy * sp, sy * cp, -sy * sp, cy * cp


def rotated(rotation: Rotation) -> Vector:
    """Return −z rotated by a quaternion."""
    x, y, z, w = rotation
    return -2.0 * (x * z + w * y), 2.0 * (w * x - y * z), 2.0 * (x * x + y * y) - 1.0
