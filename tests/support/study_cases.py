"""The user study's tasks, reduced, and the users who look at them."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

import nearfar as nf
from nearfar.datasets import CountTask, SphereTask, TapeTask

Array = NDArray[np.float64]
Ids = NDArray[np.int32]

USERS = [
    (d * np.cos(k * np.pi / 4), 0.05 * k, d * np.sin(k * np.pi / 4)) for k, d in enumerate([5.0, 8.0, 6.0, 7.0] * 2)
]
"""Positions all around the centre, standing and stretching."""
ASIDE = [user for user in USERS if abs(user[0]) > 3.0]
"""Users who moved sideways; the others see a step along their view instead."""

HOW: list[dict[str, Any]] = [{"method": "vertex"}, {"method": "exact"}, {"method": "exact", "env": False}]
"""Ways to draw a reduced scene."""


def reduce_task(scene: nf.Scene, task: CountTask | TapeTask | SphereTask, face_size: int) -> nf.ReducedScene:
    """Reduce a task's scene with a map of colour and objects."""
    where: dict[str, Any] = {"center": task.center, "r1": task.r1, "r2": task.r2}
    return nf.reduce(scene, **where, face_size=face_size, samples=1, channels=("color", "object_id"))


def pieces(ids: Ids, number: int) -> list[NDArray[np.bool_]]:
    """Masks of the connected pieces of an object, the uppermost first."""
    labels, count = ndimage.label(ids == number, np.ones((3, 3)))
    return [labels == label for label in range(1, count + 1)]
