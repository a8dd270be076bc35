"""Process tanks with ladders, gauges, manholes and pipes: prototypes on y = 0 with their fronts towards +z."""

from __future__ import annotations

import numpy as np

from nearfar.datasets._factory import parts
from nearfar.datasets._factory.pipes import valve
from nearfar.datasets._palette import materials
from nearfar.datasets._random import turn, xyz
from nearfar.datasets._shapes import Soup, boxes, join, lathe, tube

_PAINTS = materials("metal_light", "paint_snow", "machine_green", "metal_light")
_RADIUS, _SIDES = 1.5, (8, 14, 24, 40)
"""Radius of the vessels, metres, and their number of sides by detail."""


def tank(variant: int, detail: int) -> Soup:
    """An upright tank with domed ends on four legs, 1.5 m in radius and 5 to 6 m high."""
    paint, steel = _PAINTS[variant % len(_PAINTS)], "steel_blue"
    low, high = 1.2, 4.6 + 0.4 * (variant % 3)
    leg = parts.drum(0.11, 0.02, low + 0.5, steel, detail)
    foot = boxes([-0.2, -0.02, -0.2], [0.2, 0.04, 0.2], steel)
    legs = join([leg, foot]).copies([[x, 0.0, z] for x in (-1.0, 1.0) for z in (-1.0, 1.0)])
    soups = [_vessel(low, high, paint, detail), legs]
    if detail >= 1:
        heights = np.linspace(low + 0.1, high - 0.1, (2, 2, 3, 5)[detail])
        soups.append(_hoop(paint, detail).copies(xyz(0.0, heights, 0.0)))
    soups += _top(high, detail)
    if detail >= 1:
        soups += [*_outlet(low, detail), *_gauges(low, high, detail)]
        soups.append(_manhole(detail).translate([0.0, low + 0.9, 0.0]))
        soups.append(_ladder(high, detail).rotated(0.25))
    return join(soups)


def _vessel(low: float, high: float, paint: int, detail: int) -> Soup:
    """The vessel: a cylinder between two flat domes."""
    steps = (2, 2, 4, 7)[detail]
    cosine, sine = turn(0.25 * np.arange(steps + 1) / steps)
    dome = np.stack([_RADIUS * cosine, 0.42 * _RADIUS * sine], -1)
    profile = np.concatenate([dome[::-1] * [1.0, -1.0] + [0.0, low], np.add(dome, (0.0, high))])
    return lathe(profile, _SIDES[detail], paint, bottom=False, top=False)


def _hoop(paint: int, detail: int) -> Soup:
    """A flat hoop around the vessel, with as many sides, so that it is as far from the wall everywhere."""
    inner, outer = _RADIUS - 0.02, _RADIUS + 0.025
    profile = [(inner, -0.03), (outer, -0.025), (outer, 0.025), (inner, 0.03), (inner, -0.03)]
    return lathe(profile, _SIDES[detail], paint, bottom=False, top=False)


def _outlet(low: float, detail: int) -> list[Soup]:
    """The drain: a pipe from the bottom, with a valve, to a pump on the floor."""
    line = [[0.0, low - 0.5, 0.0], [0.0, 0.32, 0.0], [0.0, 0.32, 1.5]]
    soups = [
        parts.piping(line, 0.08, 0.18, "metal_light", detail),
        valve(0.08, detail).laid_z().translate([0.0, 0.32, 0.75]),
        parts.drum(0.26, 1.45, 1.7, "machine_blue", detail, 0.05).laid_z().translate([0.0, 0.34, 0.0]),
        parts.drum(0.17, 1.68, 2.2, "machine_blue", detail, 0.04).laid_z().translate([0.0, 0.34, 0.0]),
        boxes([-0.25, -0.01, 1.4], [0.25, 0.12, 2.25], "metal_dark"),
    ]
    if detail >= 2:
        count = 10 if detail == 2 else 20
        fin = boxes([0.16, 1.75, -0.006], [0.195, 2.15, 0.006], "machine_blue")
        soups += [fin.rotated(k / count).laid_z().translate([0.0, 0.34, 0.0]) for k in range(count)]
    return soups


def _top(high: float, detail: int) -> list[Soup]:
    """On the dome: a stirrer's motor, an inlet from the rack of pipes behind, a vent."""
    grey, steel, top = "steel_grey", "metal_light", high + 0.55
    inlet = [[0.8, high + 0.3, 0.0], [0.8, 6.9, 0.0], [0.8, 6.9, -3.2], [0.8, 5.7, -3.2]]
    vent = [[-0.7, high + 0.3, 0.3], [-0.7, high + 1.1, 0.3], [-0.7, high + 1.1, 0.7]]
    return [
        parts.drum(0.3, high + 0.5, top + 0.2, grey, detail, 0.03),
        parts.drum(0.2, top + 0.19, top + 0.8, "machine_blue", detail, 0.04),
        parts.flange(0.2, grey, detail).translate([0.0, top + 0.2, 0.0]),
        parts.piping(inlet, 0.09, 0.22, steel, detail),
        parts.flange(0.09, steel, detail).translate([0.8, high + 0.6, 0.0]),
        parts.flange(0.09, steel, detail).laid_z().translate([0.8, 6.9, -1.6]),
        parts.piping(vent, 0.05, 0.12, steel, detail),
    ]


def _manhole(detail: int) -> Soup:
    """A bolted cover on the front, with its handle."""
    soups = [
        parts.drum(0.36, _RADIUS - 0.1, _RADIUS + 0.12, "steel_grey", detail, 0.02).laid_z(),
        parts.drum(0.42, _RADIUS + 0.12, _RADIUS + 0.17, "steel_grey", detail, 0.015).laid_z(),
    ]
    if detail >= 2:
        bolts = parts.bolt_circle(12 if detail == 2 else 20, 0.385, 0.018, 0.05, "metal_dark").laid_z()
        soups.append(bolts.translate([0.0, 0.0, _RADIUS + 0.15]))
        grip = [[x, 0.0, _RADIUS + out] for x, out in ((-0.12, 0.16), (-0.12, 0.26), (0.12, 0.26), (0.12, 0.16))]
        soups.append(parts.piping(grip, 0.014, 0.04, "metal_light", detail, thin=True))
    return join(soups)


def _gauges(low: float, high: float, detail: int) -> list[Soup]:
    """A sight glass along the front left, and two dials with a plate."""
    x, z, bottom, top = -0.75, 1.42, low + 0.4, high - 0.3
    soups = [parts.rod((x, bottom, z), (x, top, z), 0.03, "glass_pale", detail)]
    soups += [parts.rod((x, y, 1.2), (x, y, z + 0.03), 0.035, "metal_dark", detail) for y in (bottom, top)]
    for x in (0.62, 0.92):
        soups.append(parts.rod((x, 2.2, 1.0), (x, 2.2, 1.5), 0.02, "metal_dark", detail))
        soups.append(parts.gauge(0.13, detail).translate([x, 2.2, 1.49]))
    ends = [-0.3, high - 0.9, _RADIUS - 0.06], [0.3, high - 0.5, _RADIUS + 0.012]
    return [*soups, boxes(*ends, "sign_navy")]


def _ladder(high: float, detail: int) -> Soup:
    """A ladder with a cage on the side, from the floor to above the dome."""
    yellow, z, top = "safety_yellow", _RADIUS + 0.18, high + 1.1
    soups = [parts.rod((x, 0.0, z), (x, top, z), 0.025, yellow, detail) for x in (-0.24, 0.24)]
    for y in np.arange(0.3, high + 0.2, (0.6, 0.6, 0.3, 0.3)[detail]).tolist():
        soups.append(parts.rod((-0.24, y, z), (0.24, y, z), 0.015, yellow, min(detail, 2)))
    for y in (1.6, high - 0.2):
        soups.append(boxes(xyz([-0.26, 0.22], y, _RADIUS - 0.08), xyz([-0.22, 0.26], y + 0.05, z), yellow))
    if detail >= 2:
        cosine, sine = turn(np.linspace(0.0, 0.5, 9))
        hoop = xyz(0.36 * cosine, 0.0, z + 0.62 * sine)
        for y in np.arange(2.4, top, 0.7).tolist():
            soups.append(tube(np.add(hoop, (0.0, y, 0.0)), 0.016, parts.THIN[2], yellow))
        soups += [parts.rod((x, 2.3, bar_z), (x, top, bar_z), 0.012, yellow, 2) for x, _, bar_z in hoop[2:7:2]]
    return join(soups)
