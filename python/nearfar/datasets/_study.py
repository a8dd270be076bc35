"""The two tasks of a user study: name the rectangle that a tape leads to, and the box that a ball lands on.

Popescu, Lee, Choi, Fahmy (2022) gave both tasks to users who saw near and far part joined by different methods. The
events of the scenes follow the paper; sizes and distances are nearfar's, for the paper's radii of 30 m and 50 m.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check
from nearfar._scene.scene import Scene
from nearfar.datasets._draw import Draw
from nearfar.datasets._palette import material, materials
from nearfar.datasets._shapes import Soup, boxes, quads, sphere, triangles
from nearfar.datasets._stage import Stage, placements

Point = tuple[float, float, float]

_CENTER: Point = (0.0, 1.7, 0.0)
_R1, _R2 = 30.0, 50.0
_MOST = 15
_COLORS = materials(
    "sign_red", "sign_teal", "sign_navy", "flower", "car_white", "sign_green", "car_black", "leaf_light",
    "fabric_rust", "glass_sky", "paint_mint", "brick_red", "paint_cream", "car_blue", "wood_dark",
)  # fmt: skip

# Distance of the row of rectangles, their spacing, width and height, metres. The gaps are wider than the rectangles;
# the spacing is less than the 5 m that users walk away from the centre, so that a picture from the centre would show
# another rectangle or a gap.
_ROW, _SPACING, _WIDE, _TALL = 90.0, 4.0, 2.4, 4.0
_TAPE_FROM, _TAPE_TO, _TAPE_WIDE, _TAPE_HIGH = 6.0, 70.0, 0.6, 0.1
_STEP = 0.5

_BOXES, _BOX, _BOX_HIGH, _BALL = 80.0, 2.5, 2.0, 0.5
_BALL_FROM, _GRAVITY = 8.0, 9.81
# Distance and height of the crossbar, metres: near edge and bottom, far edge and top.
_BAR = ((60.0, 4.0), (60.3, 4.4))


@dataclass(frozen=True)
class _Task:
    """The layout of both tasks: a place between the radii, and a row of objects beyond them."""

    center: Point
    """The centre O, an eye's height above the ground, world metres; all points below are world metres too."""
    target: Point
    """The middle of the row of objects to choose from, which users look at."""
    r1: float
    """Radius that bounds the near zone, metres."""
    r2: float
    """Radius that bounds the intermediate zone, metres. The tape or the ball starts near and ends far."""


@dataclass(frozen=True)
class TapeTask(_Task):
    """Geometry and answer of `tape_task`: the user names the rectangle that the tape leads to."""

    rectangles: tuple[str, ...]
    """Names of the objects to choose from, from −x to +x."""
    answer: str
    """Name of the correct object."""
    start: Point
    """The middle of the tape's near end."""
    end: Point
    """The middle of the tape's far end. The line from start to end meets the middle of the correct rectangle's bottom
    edge."""


@dataclass(frozen=True)
class SphereTask(_Task):
    """Geometry, motion and answer of `sphere_task`: the user names the box that the ball lands on."""

    boxes: tuple[str, ...]
    """Names of the objects to choose from, from −x to +x."""
    answer: str
    """Name of the correct object."""
    radius: float
    """Radius of the ball, metres."""
    start: Point
    """Centre of the ball at time 0, world metres."""
    velocity: Point
    """Velocity of the ball at time 0, metres per second."""
    duration: float
    """Time from the start to the landing, seconds."""

    def position(self, t: float) -> NDArray[np.float64]:
        """Return the centre of the ball after `t` seconds, (3,); it rests before the start and after the landing."""
        time = min(max(check.number("t", t), 0.0), self.duration)
        fall = np.array([0.0, 0.5 * _GRAVITY * time * time, 0.0])
        return np.asarray(np.array(self.start) + time * np.array(self.velocity) - fall)

    def pose(self, t: float) -> NDArray[np.float64]:
        """Return the ball's object→world matrix (4, 4) after `t` seconds, as in ``render(at={"ball": task.pose(t)})``.

        ValueError and TypeError for a `t` that is not a finite number.
        """
        matrix = np.eye(4)
        matrix[:3, 3] = self.position(t)
        return matrix


def tape_task(seed: int = 0, rectangles: int = 7) -> tuple[Scene, TapeTask]:
    """Make the scene of the first task: a tape leads from near the centre towards one of several far rectangles.

    The ground is at y = 0 and the centre above the origin. The rectangles stand in a row 90 m ahead, towards −z. The
    tape, 0.6 m wide and 0.1 m above the ground, starts 6 m from the centre, runs straight through both radii, and ends
    20 m before the row. The same arguments give the same bytes on every run and every platform.

    Parameters
    ----------
    seed
        0 to 2⁶³ − 1; it decides the start of the tape and the rectangle that it leads to.
    rectangles
        Number of rectangles or boxes to choose from, 2 to 15.

    Returns
    -------
    tuple
        The scene, whose objects are "ground", "tape", and "rectangle_0" and so on, and the `TapeTask` with radii and
        answer.

    Raises
    ------
    ValueError, TypeError
        For numbers out of range, and for values that are not whole numbers.

    References
    ----------
    Popescu, Lee, Choi, Fahmy (2022), user study.
    """
    draw, places, chosen = _row("rectangles", seed, rectangles, 90, _SPACING)
    stage = Stage()
    stage.once(_ground(), "ground")
    names = _stand(stage, "rectangle", places, (_WIDE, _TALL, 0.1), _ROW)
    start = np.array([draw.number(-2.0, 2.0), _TAPE_HIGH, -_TAPE_FROM])
    # The tape covers the way except for its last part, which users have to extrapolate.
    share = (_TAPE_TO - _TAPE_FROM) / (_ROW - _TAPE_FROM)
    end = start + share * (np.array([places[chosen], _TAPE_HIGH, -_ROW]) - start)
    stage.once(_tape(start, end), "tape")
    target = (0.0, 0.5 * _TALL, -_ROW)
    return stage.build(), TapeTask(_CENTER, target, _R1, _R2, names, names[chosen], _point(start), _point(end))


def sphere_task(seed: int = 0, boxes: int = 7) -> tuple[Scene, SphereTask]:
    """Make the scene of the second task: a ball is thrown from near the centre and lands on one of several far boxes.

    The ground is at y = 0 and the centre above the origin. The boxes stand in a row 80 m ahead, towards −z. The ball
    flies over a crossbar 60 m ahead and is then seen behind it. The same arguments give the same bytes on every run
    and every platform.

    Parameters
    ----------
    seed
        0 to 2⁶³ − 1; it decides the start of the ball, the height of its flight and the box that it lands on.
    boxes
        Number of rectangles or boxes to choose from, 2 to 15.

    Returns
    -------
    tuple
        The scene, whose objects are "ground", "crossbar", "box_0" and so on, and the dynamic "ball"; and the
        `SphereTask` with radii, answer, and the ball's pose by time.

    Raises
    ------
    ValueError, TypeError
        For numbers out of range, and for values that are not whole numbers.

    References
    ----------
    Popescu, Lee, Choi, Fahmy (2022), user study.
    """
    draw, places, chosen = _row("boxes", seed, boxes, 91, 2.0 * _BOX)
    stage = Stage()
    stage.once(_ground(), "ground")
    names = _stand(stage, "box", places, (_BOX, _BOX_HIGH, _BOX), _BOXES)
    stage.once(_crossbar(1.5 * _BOX + float(places[-1])), "crossbar")
    start = np.array([draw.number(-4.0, 4.0), 1.2, -_BALL_FROM])
    end = np.array([places[chosen], _BOX_HIGH + _BALL, -_BOXES])
    duration = draw.number(2.1, 2.4)
    velocity = (end - start) / duration + [0.0, 0.5 * _GRAVITY * duration, 0.0]
    target = (0.0, _BOX_HIGH, -_BOXES)
    thrown = (_BALL, _point(start), _point(velocity), duration)
    task = SphereTask(_CENTER, target, _R1, _R2, names, names[chosen], *thrown)
    ball = triangles(_BALL * sphere(3), material("car_red"))
    stage.many(ball, placements(*task.start), ["ball"], moves=True)
    return stage.build(dynamic=["ball"]), task


def _row(name: str, seed: int, count: int, stream: int, spacing: float) -> tuple[Draw, NDArray[np.float64], int]:
    """Random stream, x positions of the objects (count,) about the middle, and the index of the answer."""
    seed = check.integer("seed", seed, 0, 2**63 - 1)
    count = check.integer(name, count, 2, _MOST)
    draw = Draw(seed, stream)
    places = np.asarray(spacing * (np.arange(count) - 0.5 * (count - 1)), np.float64)
    return draw, places, int(draw.integers(1, count)[0])


def _stand(
    stage: Stage, name: str, places: NDArray[np.float64], size: tuple[float, float, float], away: float
) -> tuple[str, ...]:
    """Add boxes of one size in a row, each an object with a colour of its own; returns their names."""
    half, names = 0.5 * np.array(size), []
    for number, x in enumerate(places):
        middle = np.array([x, half[1], -away])
        names.append(f"{name}_{number}")
        stage.once(boxes(middle - half, middle + half, _COLORS[number]), names[-1])
    return tuple(names)


def _ground(extent: float = 400.0) -> Soup:
    corners = [[-extent, 0.0, extent], [extent, 0.0, extent], [extent, 0.0, -extent], [-extent, 0.0, -extent]]
    return quads([corners], material("lawn"))


def _tape(start: NDArray[np.float64], end: NDArray[np.float64]) -> Soup:
    """A horizontal strip from start to end, in pieces of half a metre."""
    away = end - start
    length = float(np.sqrt((away * away).sum()))
    side = 0.5 * _TAPE_WIDE / length * np.array([-away[2], 0.0, away[0]])
    middle = start + np.linspace(0.0, 1.0, int(np.ceil(length / _STEP)) + 1)[:, None] * away
    left, right = middle - side, middle + side
    return quads(np.stack([left[:-1], right[:-1], right[1:], left[1:]], axis=1), material("sign_mustard"))


def _crossbar(half: float) -> Soup:
    """A bar across the view, with a post at each end."""
    (near, low), (far, high) = _BAR
    lows = [[-half, low, -far], [-half, 0.0, -far], [half - 0.3, 0.0, -far]]
    highs = [[half, high, -near], [0.3 - half, low, -near], [half, low, -near]]
    return boxes(lows, highs, material("metal_dark"))


def _point(values: NDArray[np.float64]) -> Point:
    return float(values[0]), float(values[1]), float(values[2])
