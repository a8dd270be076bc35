"""The user study's second task: name the rectangle that a tape leads to."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check
from nearfar._scene.scene import Scene
from nearfar.datasets._random import turn
from nearfar.datasets._shapes import Soup, boxes, quads
from nearfar.datasets._stage import Stage
from nearfar.datasets._study.layout import CENTER, COLORS, R1, R2, Point, Task, draw_answer, ground, in_row, point


@dataclass(frozen=True)
class _Layout:
    """Distances and sizes, metres."""

    row: float
    """Distance of the rectangles from the centre's axis."""
    spacing: float
    wide: float
    tape_to: float
    """Distance of the tape's far end from the centre's axis."""


# A picture of a straight tape on the ground is straight between the radii as well, but bends at r₁ and at r₂: if
# the user stands u metres beside the centre, the continuation of a piece that ends at r₂ misses its rectangle by
# u (row − r₂)/(r₂ − r₁). So the rectangles stand just beyond r₂. A picture from the centre shows them shifted by u:
# users who moved between spacing − wide/2 = 3.8 m and spacing + wide/2 = 8.2 m take a neighbour for the right one.
_ENDS_NEAR = _Layout(row=52.0, spacing=6.0, wide=4.4, tape_to=44.0)
# The spacing, between the rectangles' middles, is less than the 5 m that users walk away from the centre.
_ENDS_FAR = _Layout(row=90.0, spacing=4.0, wide=2.4, tape_to=70.0)
_TALL, _THICK = 4.0, 0.1
_TAPE_FROM, _TAPE_WIDE, _TAPE_HIGH, _STEP = 6.0, 0.6, 0.1, 0.5


@dataclass(frozen=True)
class TapeTask(Task):
    """Geometry and answer of `tape_task`: the user names the rectangle that the tape leads to."""

    rectangles: tuple[str, ...]
    """Names of the objects to choose from, from −x to +x."""
    answer: str
    """Name of the correct object."""
    start: Point
    """Middle of the tape's near end."""
    end: Point
    """Middle of the tape's far end. The line from start to end meets the middle of the correct rectangle, at the tape's
    height above the ground."""


def tape_task(seed: int = 0, rectangles: int = 3, *, ends: str = "near") -> tuple[Scene, TapeTask]:
    """Make the scene of the second task: a tape leads from near the centre towards one of several far rectangles.

    The ground is at y = 0 and the centre above the origin. The rectangles stand upright on a circle about the centre,
    towards −z, and face it. The tape, 0.6 m wide and 0.1 m above the ground, starts 6 m from the centre and runs
    straight. Returns the scene, whose objects are "ground", "tape", and "rectangle_0" and so on, and the `TapeTask`
    with radii and answer. ValueError for numbers out of range and unknown `ends`; TypeError for values that are not
    whole numbers. Source: Popescu, Lee, Choi, Fahmy (2022), user study.

    Parameters
    ----------
    seed
        0 to 2⁶³ − 1; it decides the start of the tape and the rectangle that it leads to.
    rectangles
        Number of rectangles to choose from, 2 to 15; the published study had three.
    ends
        "near": the tape ends 44 m from the centre, inside r₂, and the rectangles stand 52 m away, as in the published
        study. The conventional method shows the whole tape as the user sees it, and the rectangles as the centre does.
        "far": the tape ends at 70 m and the rectangles stand 90 m away, so that the conventional method tears the tape.
    """
    random, count, answer = draw_answer("rectangles", seed, rectangles, 90)
    layout = _ENDS_NEAR if check.choice("ends", ends, ("near", "far")) == "near" else _ENDS_FAR
    stage = Stage()
    stage.once(ground(), "ground")
    # Fractions of a full turn; negative because positive turns (about +y) lead to the left.
    turns = -in_row(count, layout.spacing) / (2.0 * np.pi * layout.row)
    names = []
    half = np.array([0.5 * layout.wide, 0.5 * _TALL, 0.5 * _THICK])
    middle = np.array([0.0, 0.5 * _TALL, -layout.row])
    for number, fraction in enumerate(turns.tolist()):
        names.append(f"rectangle_{number}")
        stage.once(boxes(middle - half, middle + half, COLORS[number]).rotated(fraction), names[-1])
    cosine, sine = turn(turns[answer])
    start = np.array([random.number(-2.0, 2.0), _TAPE_HIGH, -_TAPE_FROM])
    goal = np.array([-layout.row * sine, _TAPE_HIGH, -layout.row * cosine])
    end = start + _share(start, goal, layout.tape_to) * (goal - start)
    stage.once(_tape(start, end), "tape")
    target = (0.0, 0.5 * _TALL, -layout.row)
    return stage.build(), TapeTask(CENTER, target, R1, R2, tuple(names), names[answer], point(start), point(end))


def _share(start: NDArray[np.float64], goal: NDArray[np.float64], radius: float) -> float:
    """Where a line crosses a circle about the axis, as a share of the way from `start` inside to `goal` outside."""
    (x, z), (along_x, along_z) = start[[0, 2]], (goal - start)[[0, 2]]
    a, b = along_x * along_x + along_z * along_z, x * along_x + z * along_z
    return float((np.sqrt(b * b + a * (radius * radius - x * x - z * z)) - b) / a)


def _tape(start: NDArray[np.float64], end: NDArray[np.float64]) -> Soup:
    """A horizontal strip from start to end, in pieces of half a metre."""
    along = end - start
    length = float(np.sqrt((along * along).sum()))
    side = 0.5 * _TAPE_WIDE / length * np.array([-along[2], 0.0, along[0]])
    middle = start + np.linspace(0.0, 1.0, int(np.ceil(length / _STEP)) + 1)[:, None] * along
    left, right = middle - side, middle + side
    return quads(np.stack([left[:-1], right[:-1], right[1:], left[1:]], axis=1), "sign_mustard")
