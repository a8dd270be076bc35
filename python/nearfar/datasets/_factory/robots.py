"""Robot arms and the roller conveyors that they serve: prototypes with their fronts towards +z."""

from __future__ import annotations

import numpy as np

from nearfar.datasets._factory import parts
from nearfar.datasets._random import Floats, turn, xyz
from nearfar.datasets._shapes import Soup, bars, boxes, join, lathe

# Pitches of the lower arm, the upper arm and the hand, as fractions of a full turn from upright towards +z.
_POSES = ((0.03, 0.28, 0.44), (-0.05, 0.2, 0.5), (0.08, 0.33, 0.5), (-0.02, 0.14, 0.36))
DECK = 0.85
"""Height of a conveyor's rollers, metres."""


def robot(variant: int, detail: int) -> Soup:
    """An arm with six joints on a plinth, 1.6 m behind the middle of its conveyor."""
    lower, upper, hand = _POSES[variant % len(_POSES)]
    soups = [
        parts.casing([-0.55, 0.0, -0.55], [0.55, 0.3, 0.55], 0.04, "machine_grey", detail),
        parts.drum(0.42, 0.28, 0.5, "metal_dark", detail, 0.04),
        parts.drum(0.36, 0.49, 0.86, "robot_orange", detail, 0.06),
        parts.casing([-0.34, 0.6, -0.42], [0.34, 1.05, 0.2], 0.08, "robot_orange", detail),
        _joint(0.24, 0.42, detail).translate([0.0, 1.0, 0.0]),
    ]
    shoulder = np.array([0.0, 1.0, 0.0])
    elbow = shoulder + _arm_end(lower, 1.15)
    wrist = elbow + _arm_end(upper, 1.25)
    soups += [
        _arm(1.15, 0.2, detail).pitched(lower).translate(shoulder),
        _joint(0.19, 0.34, detail).translate(elbow),
        _arm(1.25, 0.14, detail).pitched(upper).translate(elbow),
        _joint(0.12, 0.22, detail).translate(wrist),
        _gripper(detail).pitched(hand).translate(wrist),
    ]
    if detail >= 2:
        motor = parts.drum(0.13, 0.3, 0.62, "metal_dark", detail, 0.03).laid_x()
        soups += [motor.translate([0.0, 1.0, 0.0]), motor.scaled(0.75).translate(elbow)]
        soups.append(parts.bolt_circle(8 if detail == 2 else 12, 0.39, 0.016, 0.02, "metal").translate([0.0, 0.5, 0.0]))
    return join(soups)


def _joint(radius: float, half: float, detail: int) -> Soup:
    """A joint about the x axis with covers on both ends."""
    soups = [parts.drum(radius, -half, half, "robot_orange", detail, 0.03)]
    if detail >= 1:
        for end in (-half, half):
            soups.append(parts.drum(0.72 * radius, end - 0.02, end + 0.02, "metal_dark", detail, 0.008))
    if detail >= 2:
        soups.append(parts.bolt_circle(6 if detail == 2 else 8, 0.85 * radius, 0.012, half + 0.012, "metal"))
    return join(soups).laid_x()


def _arm_end(pitch: float, length: float) -> Floats:
    """The end of an arm of a length that starts at the origin, pitched from upright towards +z."""
    cosine, sine = turn(pitch)
    return np.array([0.0, length * float(cosine), length * float(sine)])


def _arm(length: float, thick: float, detail: int) -> Soup:
    """An arm along y from the origin, with its hose behind."""
    orange, back = "robot_orange", -1.2 * thick
    soups = [parts.casing([-thick, 0.0, -0.9 * thick], [thick, length, 0.9 * thick], 0.5 * thick, orange, detail)]
    if detail >= 1:
        soups.append(parts.rod((0.0, 0.1, back), (0.0, length - 0.1, back), 0.028, "rubber", detail))
    if detail >= 2:
        clip = parts.torus(0.034, 0.012, "metal_dark", 2)
        soups.append(clip.copies([[0.0, fraction * length, back] for fraction in (0.25, 0.5, 0.75)]))
        low, high = [-0.5 * thick, 0.3 * length, 0.88 * thick], [0.5 * thick, 0.7 * length, 0.93 * thick]
        soups.append(boxes(low, high, "paint_white"))
    return join(soups)


def _gripper(detail: int) -> Soup:
    """The hand along +y: a flange and suction cups on a frame."""
    soups = [
        parts.drum(0.08, 0.0, 0.24, "robot_orange", detail, 0.02),
        parts.drum(0.1, 0.23, 0.28, "metal_dark", detail, 0.01),
        bars([[-0.28, 0.27, -0.02], [-0.24, 0.272, -0.22], [0.2, 0.272, -0.22]],
             [[0.56, 0.05, 0.04], [0.04, 0.046, 0.44], [0.04, 0.046, 0.44]], "metal_light"),
    ]  # fmt: skip
    if detail == 0:
        return join(soups)
    cup = lathe([(0.02, 0.3), (0.02, 0.36), (0.06, 0.4), (0.055, 0.405)], parts.ROUND[detail], "metal_dark")
    soups.append(cup.copies([[x, 0.0, z] for x in (-0.22, 0.22) for z in (-0.18, 0.18)]))
    return join(soups)


def fence(detail: int) -> Soup:
    """Two metres of a mesh fence along x, with a post at its start."""
    soups = [boxes([-0.03, 0.0, -0.03], [0.03, 2.05, 0.03], "safety_yellow")]
    soups.append(bars([[0.02, 0.15, -0.015], [0.02, 1.93, -0.015]], [1.96, 0.03, 0.03], "metal_dark"))
    step = (1.0, 0.4, 0.2, 0.125)[detail]
    soups.append(bars(xyz(np.arange(step, 1.99, step), 0.16, -0.004), [0.008, 1.78, 0.008], "metal_dark"))
    soups.append(bars(xyz(0.02, np.arange(0.15 + step, 1.92, step), 0.002), [1.96, 0.008, 0.007], "metal_dark"))
    return join(soups)


def conveyor(detail: int) -> Soup:
    """Two metres of a roller conveyor along x, from the origin."""
    blue, steel = "rack_blue", "metal_light"
    rails = bars([[0.0, DECK - 0.16, -0.48], [0.0, DECK - 0.16, 0.44]], [2.0, 0.2, 0.04], blue)
    soups = [rails, bars([[x, 0.0, z] for x in (0.3, 1.62) for z in (-0.47, 0.39)], [0.08, DECK - 0.1, 0.08], blue)]
    if detail >= 1:
        soups.append(bars([[0.32, 0.25, -0.4], [1.64, 0.25, -0.4]], [0.04, 0.05, 0.8], blue))
    if detail <= 1:
        soups.append(boxes([0.0, DECK - 0.08, -0.45], [2.0, DECK, 0.45], "rubber"))
    else:
        step = 0.2 if detail == 2 else 0.125
        roller = parts.drum(0.045, -0.445, 0.445, steel, 1 if detail == 2 else 2).laid_z()
        soups.append(roller.copies(xyz(np.arange(0.5 * step, 2.0, step), DECK - 0.045, 0.0)))
        soups.append(boxes([0.0, DECK + 0.12, 0.46], [2.0, DECK + 0.16, 0.49], "safety_yellow"))
        soups.append(bars(xyz([0.4, 1.56], DECK + 0.02, 0.462), [0.04, 0.11, 0.025], blue))
        motor = parts.drum(0.1, 0.8, 1.2, "machine_blue", detail, 0.02).laid_x()
        soups.append(motor.translate([0.0, DECK - 0.32, 0.2]))
        foot = parts.drum(0.07, -0.01, 0.02, "metal_dark", detail)
        soups.append(foot.copies([[x, 0.0, z] for x in (0.34, 1.66) for z in (-0.43, 0.43)]))
    return join(soups)


def carton(variant: int, detail: int) -> Soup:
    """A carton with tape, on y = 0: one of four sizes."""
    wide, high, deep = ((0.6, 0.4, 0.5), (0.45, 0.35, 0.4), (0.7, 0.5, 0.6), (0.5, 0.6, 0.5))[variant % 4]
    brown = "cardboard" if variant % 2 == 0 else "cardboard_pale"
    x, z = 0.5 * wide, 0.5 * deep
    soups = [boxes([-x, 0.0, -z], [x, high, z], brown)]
    if detail >= 1:
        low = [[-x - 0.001, 0.7 * high, -0.03], [-x + 0.04, 0.08 * high, z - 0.01]]
        top = [[x + 0.001, high + 0.002, 0.03], [-x + 0.2, 0.4 * high, z + 0.002]]
        soups.append(boxes(low, top, ["paper", "paint_white"]))
    return join(soups)
