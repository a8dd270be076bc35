"""The user study's first task: count the spheres on both sides of r₂."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check
from nearfar._scene.scene import Scene
from nearfar.datasets._random import RandomStream, turn
from nearfar.datasets._shapes import sphere, triangles
from nearfar.datasets._stage import Stage
from nearfar.datasets._study.layout import CENTER, MAX_SEED, R1, R2, Point, Task, ground

_RADIUS = 1.0
# Rows of spheres from the lowest to the highest: least and greatest distance from the axis, and height, metres. The
# heights differ so much that no user sees a sphere of one row in front of a sphere of another.
_INSIDE, _ACROSS, _BEYOND = (38.0, 46.0, 1.5), (R2 - 0.2, R2 + 0.2, 5.0), (53.0, 60.0, 9.0)
# Angle of view of a row, and the greatest shift of a sphere in it, as fractions of a full turn. Neighbours in a row
# are farther apart than their diameter (0.007) and the parallax of users 8 m away from the centre (0.01) together.
_ROW_ANGLE, _MAX_SHIFT = 80.0 / 360.0, 2.0 / 360.0


@dataclass(frozen=True)
class CountTask(Task):
    """Geometry and answer of `count_task`: the user states the number of spheres."""

    spheres: tuple[str, ...]
    """Names of the spheres."""
    answer: int
    """Number of the spheres, 11 to 13."""
    radius: float
    """Radius of a sphere, metres."""
    across: tuple[str, ...]
    """Names of the one or two spheres that r₂ cuts; a conventional picture shows their halves separately."""


def count_task(seed: int = 0) -> tuple[Scene, CountTask]:
    """Make the scene of the first task: 11 to 13 spheres inside, across and beyond r₂, which the user counts.

    The ground is at y = 0 and the centre above the origin. The spheres have a radius of 1 m and float in three rows of
    different height, towards −z: those 38 m to 46 m away lowest, one or two across r₂ above them, and those 53 m to
    60 m away highest. Users up to 8 m beside the centre see all of them, none behind another. Returns the scene, whose
    objects are "ground", "sphere_0" and so on, and the `CountTask` with radii and answer. ValueError for a seed out of
    range; TypeError for values that are not whole numbers. Source: Popescu, Lee, Choi, Fahmy (2022), user study.

    Parameters
    ----------
    seed
        0 to 2⁶³ − 1; it decides the number of spheres and their places.
    """
    random = RandomStream(check.integer("seed", seed, 0, MAX_SEED), 92)
    answer, cut_count = 11 + int(random.integers(1, 3)[0]), 1 + int(random.integers(1, 2)[0])
    inside_count = (answer - cut_count) // 2
    counts = (inside_count, cut_count, answer - cut_count - inside_count)
    rows = [_row(random, *row, count) for row, count in zip((_INSIDE, _ACROSS, _BEYOND), counts, strict=True)]
    stage = Stage()
    stage.once(ground(), "ground")
    names = tuple(f"sphere_{number}" for number in range(answer))
    ball = triangles(_RADIUS * sphere(3), "sign_red")
    for name, position in zip(names, np.concatenate(rows), strict=True):
        stage.once(ball.translate(position), name)
    target: Point = (0.0, _ACROSS[2], -R2)
    cut_names = names[inside_count : inside_count + cut_count]
    return stage.build(), CountTask(CENTER, target, R1, R2, names, answer, _RADIUS, cut_names)


def _row(random: RandomStream, nearest: float, farthest: float, height: float, count: int) -> NDArray[np.float64]:
    """Positions (count, 3) of a row's spheres, evenly spread and then shifted at random."""
    angles = _ROW_ANGLE * ((np.arange(count) + 0.5) / count - 0.5) + random.uniform(count, -_MAX_SHIFT, _MAX_SHIFT)
    distances = random.uniform(count, nearest, farthest)
    cosine, sine = turn(angles)
    return np.stack([distances * sine, np.full(count, height), -distances * cosine], axis=1)
