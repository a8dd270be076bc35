"""The user study's third task: name the box that a ball lands on."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check
from nearfar._scene.scene import Scene
from nearfar.datasets._shapes import Soup, boxes, sphere, triangles
from nearfar.datasets._stage import Stage, placements
from nearfar.datasets._study.layout import CENTER, COLORS, R1, R2, Point, Task, draw_answer, ground, in_row, point

_ROW, _SPACING, _BOX, _BOX_HIGH, _BALL = 80.0, 5.0, 2.5, 2.0, 0.5
_BALL_FROM, _GRAVITY = 8.0, 9.81
# Distance and height of the crossbar, metres: near edge and bottom, far edge and top.
_BAR = ((60.0, 4.0), (60.3, 4.4))


@dataclass(frozen=True)
class SphereTask(Task):
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
    gravity: float
    """Downward acceleration of the ball, m/s²; 0 for a straight flight."""

    def position(self, t: float) -> NDArray[np.float64]:
        """Return the centre of the ball after `t` seconds, (3,); it rests before the start and after the landing."""
        time = min(max(check.number("t", t), 0.0), self.duration)
        fall = np.array([0.0, 0.5 * self.gravity * time * time, 0.0])
        return np.asarray(np.array(self.start) + time * np.array(self.velocity) - fall)

    def pose(self, t: float) -> NDArray[np.float64]:
        """Return the ball's object→world matrix (4, 4) after `t` seconds, as in ``render(at={"ball": task.pose(t)})``.

        ValueError and TypeError for a `t` that is not a finite number.
        """
        matrix = np.eye(4)
        matrix[:3, 3] = self.position(t)
        return matrix


def sphere_task(seed: int = 0, boxes: int = 7, *, straight: bool = True) -> tuple[Scene, SphereTask]:
    """Make the scene of the third task: a ball flies from near the centre onto one of several far boxes.

    The ground is at y = 0 and the centre above the origin. The boxes stand in a row 80 m ahead, 5 m apart, towards −z.
    Returns the scene, whose objects are "ground", "box_0" and so on, "crossbar" unless the flight is straight, and the
    dynamic "ball"; and the `SphereTask` with radii, answer, and the ball's pose by time. ValueError for numbers out of
    range; TypeError for values of another type. Source: Popescu, Lee, Choi, Fahmy (2022), user study.

    Parameters
    ----------
    seed
        0 to 2⁶³ − 1; it decides the start of the ball, the time of its flight and the box that it lands on.
    boxes
        Number of boxes to choose from, 2 to 15; the published study had seven.
    straight
        True: the ball flies straight and evenly, as in the published study. False: it is thrown over a crossbar 60 m
        ahead and then seen behind it, which shows whether far geometry hides it.
    """
    random, count, answer = draw_answer("boxes", seed, boxes, 91)
    is_straight, places = check.flag("straight", straight), in_row(count, _SPACING)
    stage = Stage()
    stage.once(ground(), "ground")
    names = tuple(f"box_{number}" for number in range(count))
    for name, x, color in zip(names, places.tolist(), COLORS, strict=False):
        stage.once(_box(x, color), name)
    if not is_straight:
        stage.once(_crossbar(1.5 * _BOX + float(places[-1])), "crossbar")
    # A straight flight descends, so that the ball touches the top of its box and not the edge.
    height, gravity = (random.number(3.5, 5.0), 0.0) if is_straight else (1.2, _GRAVITY)
    start = np.array([random.number(-4.0, 4.0), height, -_BALL_FROM])
    end = np.array([places[answer], _BOX_HIGH + _BALL, -_ROW])
    duration = random.number(2.1, 2.4)
    velocity = (end - start) / duration + [0.0, 0.5 * gravity * duration, 0.0]
    target = (0.0, _BOX_HIGH, -_ROW)
    thrown = (_BALL, point(start), point(velocity), duration, gravity)
    task = SphereTask(CENTER, target, R1, R2, names, names[answer], *thrown)
    stage.many(triangles(_BALL * sphere(3), "car_red"), placements(*task.start), ["ball"], moves=True)
    return stage.build(dynamic=["ball"]), task


def _box(x: float, color: int) -> Soup:
    """A box on the ground."""
    half = 0.5 * _BOX
    return boxes([x - half, 0.0, -_ROW - half], [x + half, _BOX_HIGH, half - _ROW], color)


def _crossbar(half: float) -> Soup:
    """A bar across the view, with a post at each end."""
    (near, low), (far, high) = _BAR
    lows = [[-half, low, -far], [-half, 0.0, -far], [half - 0.3, 0.0, -far]]
    highs = [[half, high, -near], [0.3 - half, low, -near], [half, low, -near]]
    return boxes(lows, highs, "metal_dark")
