"""Steelwork: columns, girders, trusses, a bridge crane with its rails, and the lamps that hang from the trusses."""

from __future__ import annotations

import numpy as np

from nearfar.datasets._factory import parts, plan
from nearfar.datasets._palette import materials
from nearfar.datasets._random import xyz
from nearfar.datasets._shapes import Soup, bars, boxes, join, lathe
from nearfar.datasets._stage import Stage, placements

_GIRDER, _CHORD, _TOP = 9.75, 10.35, 11.4
"""Heights of the girders' lower side and of the trusses' lower and upper chords, metres."""
_RAIL = 7.6
"""Height of the lower side of the crane's rails."""


def build(stage: Stage, detail: int) -> None:
    """Add all steelwork and the lamps."""
    x, z = plan.grid(plan.COLUMNS_X, plan.COLUMNS_Z)
    stage.many(column(detail), placements(x, 0.0, z), "column")
    x, z = plan.grid(plan.COLUMNS_X, np.arange(-55.0, 56.0, 10.0))
    stage.many(girder(detail), placements(x, 0.0, z), "girder")
    lines = np.arange(-50.0, 51.0, 10.0)
    x, z = plan.grid(np.arange(-60.0, 61.0, 20.0), lines)
    stage.many(truss(10, detail), placements(x, 0.0, z), "truss")
    count = len(x)
    x, z = plan.grid([-75.0, 75.0], lines)
    stage.many(truss(5, detail), placements(x, 0.0, z), [f"truss_{count + k}" for k in range(len(x))])
    _crane(stage, detail)
    x, z = plan.grid(np.arange(-75.0, 76.0, 10.0), lines)
    stage.many(lamp(detail), placements(x, 0.0, z), "lamp")


def column(detail: int) -> Soup:
    """A column with its base, a guard against forklifts, and the seat of the girder."""
    steel = "steel_blue"
    lows = [[-0.2, 0.28, -0.2], [-0.2, 0.28, 0.176], [-0.012, 0.28, -0.18]]
    sizes = [[0.4, _GIRDER - 0.29, 0.024], [0.4, _GIRDER - 0.29, 0.024], [0.024, _GIRDER - 0.29, 0.36]]
    soups = [
        bars(lows, sizes, steel),
        boxes([-0.42, -0.05, -0.42], [0.42, 0.25, 0.42], "concrete_dark"),
        boxes([-0.32, 0.24, -0.32], [0.32, 0.29, 0.32], steel),
        boxes([-0.26, _GIRDER - 0.04, -0.3], [0.26, _GIRDER + 0.005, 0.3], steel),
    ]
    if detail >= 1:
        y, stripes = 0.26 + 0.2 * np.arange(5), np.resize(materials("safety_yellow", "trim_dark"), 5)
        soups.append(boxes(xyz(-0.235, y + 0.04, -0.235), xyz(0.235, y + 0.24, 0.235), stripes))
    if detail >= 2:
        heights = np.arange(1.8, _GIRDER - 0.5, 1.6)
        soups += [bars(xyz(x, heights, -0.177), [0.176, 0.016, 0.354], steel) for x in (-0.19, 0.014)]
        bolt = lathe([(0.022, 0.2), (0.022, 0.33)], 6, "metal")
        # Bolts, a sign, and a tray for cables.
        soups += [
            bolt.copies([[x, 0.0, z] for x in (-0.27, 0.27) for z in (-0.27, 0.0, 0.27)]),
            boxes([-0.14, 2.0, 0.19], [0.14, 2.28, 0.206], "paint_white"),
            boxes([-0.1, 2.05, 0.2], [0.1, 2.23, 0.209], "sign_navy"),
            bars([[-0.1, 2.6, -0.26], [0.02, 2.6, -0.26]], [0.06, _GIRDER - 2.8, 0.07], "metal_light"),
        ]
    if detail >= 3:
        soups.append(bars([[-0.19, y, z] for y in (3.34, 6.54) for z in (-0.215, 0.197)], [0.38, 0.32, 0.018], steel))
    return join(soups)


def girder(detail: int) -> Soup:
    """Ten metres of a girder along z, on which trusses rest."""
    soup = parts.i_beam([-4.99, _GIRDER, -0.15], 9.98, 0.58, 0.3, "steel_blue").rotated(0.25)
    if detail < 2:
        return soup
    x, z = plan.grid([-0.14, 0.008], np.linspace(-4.6, 4.6, 6 if detail == 2 else 14))
    return join([soup, bars(xyz(x, _GIRDER + 0.03, z), [0.132, 0.52, 0.016], "steel_blue")])


def truss(panels: int, detail: int) -> Soup:
    """A truss along x with panels of 2 m, on y = 10.35."""
    steel, half = "steel_grey", float(panels)
    lows = [[-half + 0.01, _CHORD, -0.1], [-half + 0.01, _TOP, -0.11]]
    soups = [bars(lows, [[2.0 * half - 0.02, 0.16, 0.2], [2.0 * half - 0.02, 0.18, 0.22]], steel)]
    step = 5.0 if detail == 0 else 2.0
    for x in np.arange(-half, half - 0.5 * step, step).tolist():
        foot, top, next_foot = (x + 0.1, _CHORD + 0.1), (x + 0.5 * step, _TOP + 0.08), (x + step - 0.1, _CHORD + 0.1)
        for start, end in ((foot, top), (top, next_foot)):
            soups.append(parts.rod((*start, 0.0), (*end, 0.0), 0.055, steel, detail))
        if detail >= 2:
            low = [[x + 0.5 * step - 0.22, _TOP - 0.14, -0.012], [x + step - 0.3, _CHORD + 0.13, -0.014]]
            soups.append(bars(low, [[0.44, 0.2, 0.024], [0.3, 0.16, 0.028]], steel))
    return join(soups)


def _crane(stage: Stage, detail: int) -> None:
    """A bridge crane over the middle lane: rails on brackets, the bridge with its trolley and hook."""
    x, z = plan.grid(np.arange(-60.0, 61.0, 20.0), [-9.2, 9.2])
    beam = parts.i_beam([-9.99, _RAIL, -0.15], 19.98, 0.6, 0.3, "steel_grey")
    rail = boxes([-9.99, _RAIL + 0.59, -0.04], [9.99, _RAIL + 0.68, 0.04], "metal_dark")
    stage.many(join([beam, rail]), placements(x, 0.0, z), "crane_rail")
    lows = [[-0.14, _RAIL - 0.35, -0.25], [-0.05, _RAIL - 0.75, 0.1]]
    highs = [[0.14, _RAIL + 0.004, 0.65], [0.05, _RAIL - 0.34, 0.64]]
    x, z = plan.grid(plan.COLUMNS_X, [9.2, -9.2])
    stage.many(boxes(lows, highs, "steel_blue"), placements(x, 0.0, z, 0.5 * (z < 0.0)), "crane_bracket")
    stage.many(bridge(detail), placements([-22.0, 34.0], 0.0, 0.0, [0.0, 0.5]), "crane")


def bridge(detail: int) -> Soup:
    """Two box girders across the lane, a trolley, a hook on ropes."""
    yellow, dark = "safety_yellow", "metal_dark"
    low = _RAIL + 0.72
    soups = []
    for x in (-0.85, 0.85):
        soups.append(parts.casing([x - 0.22, low, -9.0], [x + 0.22, low + 0.9, 9.0], 0.04, yellow, detail))
    for z in (-9.2, 9.2):
        soups.append(parts.casing([-1.8, low - 0.03, z - 0.25], [1.8, low + 0.42, z + 0.25], 0.05, yellow, detail))
        wheel = parts.drum(0.16, -0.06, 0.06, dark, detail, 0.02).laid_z()
        soups.append(wheel.copies([[x, low + 0.12, z] for x in (-1.82, 1.82)]))
    winch = parts.drum(0.3, -0.7, 0.7, "machine_blue", detail, 0.05).laid_x()
    hook = parts.torus(0.16, 0.045, dark, detail).laid_x()
    return join([
        *soups,
        parts.casing([-1.2, low + 0.92, 1.0], [1.2, low + 1.2, 3.2], 0.05, "steel_grey", detail),
        winch.translate([0.0, low + 1.35, 2.1]),
        *(parts.rod((x, low + 1.35, 2.1), (x, 5.9, 2.1), 0.02, dark, detail) for x in (-0.16, 0.16)),
        parts.casing([-0.26, 5.35, 1.98], [0.26, 5.92, 2.22], 0.05, yellow, detail),
        hook.translate([0.0, 5.15, 2.1]),
    ])  # fmt: skip


def lamp(detail: int) -> Soup:
    """A lamp with a bell, which hangs from a truss."""
    if detail == 0:
        return lathe([(0.33, 9.36), (0.14, 9.64), (0.02, _CHORD)], parts.ROUND[detail], "metal_light")
    bell = np.array([(0.33, 9.36), (0.3, 9.5), (0.14, 9.64), (0.13, 9.63), (0.285, 9.49), (0.315, 9.36), (0.33, 9.36)])
    soups = [
        lathe(bell, parts.ROUND[detail], "metal_light", bottom=False, top=False),
        parts.drum(0.13, 9.62, 9.9, "metal", detail, 0.02),
        parts.rod((0, 9.88, 0), (0, _CHORD + 0.02, 0), 0.015, "metal", detail),
        lathe([(0.06, 9.4), (0.22, 9.45), (0.26, 9.53)], parts.ROUND[detail], "daylight"),
    ]
    if detail >= 2:
        count, fin = 6 if detail == 2 else 8, boxes([0.12, 9.66, -0.006], [0.165, 9.86, 0.006], "metal")
        soups += [fin.rotated(k / count) for k in range(count)]
    return join(soups)
