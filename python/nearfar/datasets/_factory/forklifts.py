"""Forklifts, which can be posed, and pallets on the floor."""

from __future__ import annotations

import numpy as np

from nearfar.datasets._factory import parts, storage
from nearfar.datasets._random import RandomStream, xyz
from nearfar.datasets._shapes import Soup, bars, boxes, join, lathe, tube
from nearfar.datasets._stage import Stage, placements

# Positions along x and z, and turns: fractions of a full turn from a front towards +z.
_PARKED = ((-13.0, -1.1, 0.25), (24.0, 1.2, 0.75), (0.8, -26.0, 0.0), (-40.9, 33.0, 0.5), (31.0, 39.2, 0.25),
           (-24.0, 20.8, 0.75), (40.8, -12.0, 0.5), (-9.0, -40.7, 0.25))  # fmt: skip


def build(stage: Stage, seed: int, detail: int) -> list[str]:
    """Add forklifts, every second one with a load; return their names."""
    names = []
    for number, (x, z, quarter) in enumerate(_PARKED):
        soup = forklift(detail)
        if number % 2 == 0:
            soup = join([soup, storage.pallet(RandomStream(seed, 95, number), detail).translate([0.0, 0.26, 1.72])])
        names.append(f"forklift_{number}")
        stage.many(soup, placements(x, 0.0, z, quarter), names[-1:], moves=True)
    return names


def forklift(detail: int) -> Soup:
    """A forklift on y = 0 with its forks towards +z, 2.2 m high."""
    yellow, dark = "safety_yellow", "metal_dark"
    soups = [
        parts.casing([-0.52, 0.22, -1.15], [0.52, 0.95, -0.45], 0.1, dark, detail),
        parts.casing([-0.54, 0.2, -0.6], [0.54, 0.78, 0.75], 0.06, yellow, detail),
        parts.casing([-0.5, 0.6, -0.85], [0.5, 1.02, -0.3], 0.08, yellow, detail),
        parts.casing([-0.26, 0.98, -0.72], [0.26, 1.12, -0.22], 0.05, dark, detail),
        parts.casing([-0.24, 1.08, -0.8], [0.24, 1.6, -0.66], 0.05, dark, detail),
        boxes([-0.45, 0.76, 0.5], [0.45, 1.1, 0.72], yellow),
    ]
    for x in (-0.48, 0.48):
        soups.append(tube([(x, 0.75, 0.65), (x, 1.5, 0.5), (x, 2.12, 0.25)], 0.035, parts.THIN[detail], dark))
        soups.append(tube([(x, 0.9, -0.8), (x, 1.5, -0.78), (x, 2.12, -0.7)], 0.035, parts.THIN[detail], dark))
    soups.append(bars([[-0.53, 2.1, -0.75], [0.45, 2.1, -0.75]], [0.08, 0.06, 1.05], dark))
    roof = np.linspace(-0.74, 0.22, (2, 4, 7, 9)[detail])
    soups += [bars(xyz(-0.5, 2.115, roof), [1.0, 0.03, 0.05], dark), *_mast(detail)]
    wheel = _wheel(detail)
    for x, quarter in ((-0.45, 0.5), (0.45, 0.0)):
        soups.append(wheel.rotated(quarter).translate([x, 0.3, 0.5]))
        soups.append(wheel.rotated(quarter).scaled([0.9, 0.85, 0.85]).translate([x, 0.255, -0.75]))
    if detail >= 1:
        soups.append(parts.rod((0.0, 1.05, 0.55), (0.0, 1.32, 0.36), 0.025, dark, detail))
        soups.append(parts.handwheel(0.17, dark, detail).pitched(-0.1).translate([0.0, 1.34, 0.34]))
    if detail >= 2:
        lamp = lathe([(0.03, 0.0), (0.07, 0.06), (0.07, 0.09)], parts.ROUND[detail], "daylight").laid_z()
        soups.append(lamp.copies([[-0.4, 1.6, 0.48], [0.4, 1.6, 0.48]]))
        soups.append(parts.drum(0.06, 2.15, 2.27, "robot_orange", detail, 0.02).translate([0.0, 0.0, -0.3]))
        soups.append(parts.grille(0.6, 0.3, detail).pitched(0.5).translate([0.0, 0.6, -1.15]))
    return join(soups)


def _mast(detail: int) -> list[Soup]:
    """The mast with its chains, the carriage and the forks."""
    dark, steel = "metal_dark", "metal"
    soups = [bars([[-0.4, 0.1, 0.82], [0.31, 0.1, 0.82]], [0.09, 2.05, 0.14], dark)]
    soups.append(bars([[-0.3, 0.3, 0.86], [0.23, 0.3, 0.86]], [0.07, 1.75, 0.1], steel))
    braces = [[-0.36, 2.0, 0.84], [-0.33, 1.1, 0.845], [-0.36, 0.2, 0.84]]
    soups.append(bars(braces, [[0.72, 0.1, 0.1], [0.66, 0.08, 0.09], [0.72, 0.12, 0.1]], dark))
    soups.append(parts.rod((0.0, 0.25, 0.9), (0.0, 1.9, 0.9), 0.045, "metal_light", detail))
    soups.append(bars([[-0.48, 0.24, 0.97], [-0.48, 0.62, 0.97]], [0.96, 0.1, 0.05], dark))
    # The upright and the level part of each fork.
    soups.append(bars([[-0.32, 0.18, 1.02], [0.2, 0.18, 1.02]], [0.12, 0.55, 0.05], steel))
    soups.append(bars([[-0.315, 0.2, 1.06], [0.205, 0.2, 1.06]], [0.11, 0.05, 1.1], steel))
    if detail >= 2:
        links = 20 if detail == 2 else 40
        heights = np.linspace(0.4, 1.9, links)
        soups += [bars(xyz(x, heights, 0.918), [0.03, 1.2 / links, 0.02], dark) for x in (-0.15, 0.12)]
    return soups


def _wheel(detail: int) -> Soup:
    """A solid tyre with its rim, its axle along x and its outside towards +x."""
    radius = 0.3
    soups = [
        parts.drum(radius, -0.1, 0.12, "tyre", detail, 0.04),
        parts.drum(0.55 * radius, 0.05, 0.135, "paint_white", detail, 0.02),
    ]
    if detail >= 2:
        soups.append(parts.bolt_circle(6, 0.35 * radius, 0.014, 0.15, "metal_dark"))
    return join(soups).laid_x()
