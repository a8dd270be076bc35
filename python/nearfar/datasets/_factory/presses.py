"""Presses, work places and compressors: prototypes on y = 0 with their fronts towards +z."""

from __future__ import annotations

import numpy as np

from nearfar.datasets._factory import parts
from nearfar.datasets._factory.machines import PAINTS
from nearfar.datasets._palette import materials
from nearfar.datasets._random import RandomStream
from nearfar.datasets._shapes import Soup, bars, boxes, join, lathe


def press(variant: int, detail: int) -> Soup:
    """A hydraulic press with four columns, 4.7 m high."""
    paint, steel = PAINTS[(variant + 2) % len(PAINTS)], "metal_light"
    ram = 2.2 + 0.3 * (variant % 3)
    soups = [
        parts.casing([-1.45, 0.0, -1.1], [1.45, 0.95, 1.1], 0.1, paint, detail),
        parts.casing([-1.5, 3.4, -1.15], [1.5, 4.4, 1.15], 0.12, paint, detail),
        parts.casing([-1.2, ram, -0.8], [1.2, ram + 0.5, 0.8], 0.06, "steel_blue", detail),
        boxes([-0.9, 0.93, -0.7], [0.9, 1.15, 0.7], "metal_dark"),
        boxes([-0.8, 1.14, -0.6], [0.8, 1.22, 0.6], "metal"),
        boxes([-0.85, ram - 0.2, -0.65], [0.85, ram + 0.01, 0.65], "metal_dark"),
        parts.drum(0.32, ram + 0.45, 3.45, steel, detail, 0.03),
        parts.drum(0.42, 4.35, 4.75, "steel_grey", detail, 0.05),
    ]
    pillar = parts.drum(0.15, 0.9, 3.45, steel, detail)
    nut = lathe([(0.26, 4.38), (0.26, 4.52), (0.17, 4.54), (0.17, 4.64)], 6, "metal_dark")
    corners = [[x, 0.0, z] for x in (-1.15, 1.15) for z in (-0.85, 0.85)]
    soups += [
        pillar.copies(corners),
        nut.copies(corners),
        parts.panel(detail).translate([1.9, 1.3, 1.3]),
        boxes([1.82, 0.02, 1.19], [1.98, 1.1, 1.28], "metal_dark"),
        parts.casing([-2.4, 0.02, -0.9], [-1.6, 1.9, 0.7], 0.05, "machine_grey", detail),
    ]
    if detail >= 1:
        post = boxes([-0.06, 0.0, -0.06], [0.06, 2.2, 0.06], "safety_yellow")
        soups.append(post.copies([[-1.5, 0.0, 1.6], [1.35, 0.0, 1.6]]))
    if detail >= 2:
        soups += _press_trimmings(ram, detail)
    return join(soups)


def _press_trimmings(ram: float, detail: int) -> list[Soup]:
    """Hydraulic lines, flanges, gauges, a ladder, a grille and bolts."""
    soups = []
    for k in range(4):
        x, z = -1.75 - 0.14 * k, -0.5 + 0.12 * k
        line = [[x, 1.85, z], [x, 4.7 + 0.1 * k, z], [-0.2 + 0.13 * k, 4.7 + 0.1 * k, z], [-0.2 + 0.13 * k, 4.3, z]]
        soups.append(parts.piping(line, 0.03, 0.12, "metal_light", detail))
        soups.append(parts.flange(0.03, "metal_light", detail).copies([[x, 2.4, z], [x, 3.9, z]]))
    rungs = np.arange(1.1, 4.4, 0.3).tolist()
    rail = [[-1.3, 4.35, -1.0], [-1.3, 5.3, -1.0], [1.3, 5.3, -1.0], [1.3, 4.35, -1.0]]
    bolt = lathe([(0.03, -0.03), (0.03, 0.04)], 6, "metal_dark").laid_z()
    motor = parts.drum(0.2, -0.35, 0.35, "machine_blue", detail, 0.04).laid_x()
    return [
        *soups,
        parts.flange(0.32, "steel_grey", detail).copies([[0.0, 3.3, 0.0], [0.0, ram + 0.56, 0.0]]),
        parts.gauge(0.1, detail).copies([[-2.2, 1.55, 0.69], [-1.95, 1.55, 0.69]]),
        parts.grille(0.6, 0.7, detail).translate([-2.0, 0.7, 0.69]),
        parts.grille(1.6, 0.5, detail).translate([0.0, 0.45, 1.1]),
        *(parts.rod((1.53, 0.9, z), (1.53, 4.9, z), 0.022, "safety_yellow", detail) for z in (-0.25, 0.25)),
        *(parts.rod((1.53, height, -0.25), (1.53, height, 0.25), 0.014, "safety_yellow", detail) for height in rungs),
        parts.piping(rail, 0.022, 0.1, "safety_yellow", detail, thin=True),
        bolt.copies([[x, y, 1.15] for x in np.linspace(-1.2, 1.2, 9).tolist() for y in (3.65, 4.15)]),
        motor.translate([-2.0, 2.1, -0.1]),
    ]


def bench(seed: int, variant: int, detail: int) -> Soup:
    """A work place: bench with a vice and drawers, a board with tools, a drill, a stool, a cabinet."""
    random = RandomStream(seed, 93, variant)
    soups = [
        parts.casing([-1.5, 0.86, -0.4], [1.1, 0.94, 0.4], 0.02, "wood_pale", detail),
        boxes([[-1.4, 0.0, -0.32], [0.3, 0.12, -0.34]], [[-1.3, 0.87, 0.32], [1.0, 0.87, 0.36]], "machine_grey"),
        boxes([-1.35, 0.2, -0.3], [0.32, 0.24, 0.3], "machine_grey"),
        boxes([-1.45, 0.93, -0.42], [1.05, 2.0, -0.37], "panel_slate"),
        parts.casing([1.4, 0.02, -0.5], [2.4, 1.95, 0.1], 0.03, "machine_blue", detail),
        parts.drum(0.19, 0.5, 0.58, "rubber", detail, 0.03).translate([-0.6, 0.0, 0.85]),
        parts.rod((-0.6, 0.02, 0.85), (-0.6, 0.52, 0.85), 0.03, "metal_dark", detail),
        parts.drum(0.22, 0.0, 0.04, "metal_dark", detail, 0.01).translate([-0.6, 0.0, 0.85]),
        parts.casing([-1.3, 0.93, 0.1], [-1.05, 1.12, 0.42], 0.03, "sign_teal", detail),
        _drill(detail).translate([0.7, 0.93, 0.0]),
    ]
    if detail >= 1:
        soups.append(bars([[0.34, 0.16 + 0.175 * k, 0.35] for k in range(4)], [0.62, 0.16, 0.035], "machine_blue"))
        colors = materials("sign_red", "sign_navy", "safety_yellow", "metal_light", "wood")
        for x in np.linspace(-1.35, 0.95, 8 if detail == 1 else 20).tolist():
            high = random.number(0.12, 0.3)
            top = random.pick((1.45, 1.85))
            soups.append(bars([x, top - high, -0.38], [0.03, high, 0.03], random.pick(colors)))
    if detail >= 2:
        handle = boxes([-0.1, 0.0, 0.0], [0.1, 0.02, 0.025], "metal_light")
        soups.append(handle.copies([[0.65, 0.25 + 0.175 * k, 0.38] for k in range(4)]))
        for x in (1.46, 1.92):
            soups.append(boxes([x, 0.1, 0.09], [x + 0.43, 1.88, 0.112], "machine_blue"))
            soups.append(parts.grille(0.3, 0.16, detail).translate([x + 0.215, 1.7, 0.112]))
        for k in range(6):
            x, size = random.number(-0.9, 0.3), random.number(0.04, 0.09)
            body = parts.drum(size, 0.93, 0.95 + 2.5 * size, random.pick(colors), detail, 0.01)
            soups.append(body.translate([x, 0.0, -0.3 + 0.1 * k]))
        soups.append(parts.drum(0.03, 0.0, 0.3, "metal_light", detail, 0.01).laid_z().translate([-1.17, 1.03, 0.4]))
        lamp = [[-0.5, 1.98, -0.4], [-0.5, 2.2, -0.4], [-0.5, 2.2, 0.1]]
        soups.append(parts.piping(lamp, 0.02, 0.1, "metal_dark", detail, thin=True))
        soups.append(boxes([-1.1, 2.14, 0.02], [0.1, 2.19, 0.16], "daylight"))
    return join(soups)


def _drill(detail: int) -> Soup:
    """A bench drill."""
    soups = [
        parts.casing([-0.18, 0.0, -0.25], [0.18, 0.06, 0.25], 0.02, "machine_green", detail),
        parts.rod((0.0, 0.05, -0.15), (0.0, 0.95, -0.15), 0.035, "metal_light", detail),
        parts.casing([-0.11, 0.62, -0.28], [0.11, 0.92, 0.24], 0.04, "machine_green", detail),
        parts.drum(0.03, 0.38, 0.64, "metal_light", detail, 0.01).translate([0.0, 0.0, 0.12]),
        boxes([-0.14, 0.28, -0.12], [0.14, 0.31, 0.24], "steel_grey"),
    ]
    if detail >= 1:
        soups.append(parts.handwheel(0.1, "metal_dark", detail).laid_x().translate([0.15, 0.74, 0.1]))
    return join(soups)


def compressor(variant: int, detail: int) -> Soup:
    """A compressor: a lying vessel with a motor and a finned block on top, beside a pump and a filter."""
    paint, dark = PAINTS[variant % 2], "metal_dark"
    end = np.array([(0.02, 1.62), (0.3, 1.56), (0.5, 1.42), (0.55, 1.2)])
    vessel = lathe(np.concatenate([end * [1.0, -1.0], end[::-1]]), parts.ROUND[detail], paint)
    soups = [
        vessel.laid_x().translate([0.0, 0.85, 0.0]),
        bars([[-1.1, 0.0, -0.4], [0.95, 0.0, -0.4]], [0.15, 0.45, 0.8], dark),
        parts.casing([-1.2, 1.36, -0.35], [1.2, 1.46, 0.35], 0.02, "steel_grey", detail),
        parts.drum(0.26, -1.0, -0.2, "machine_blue", detail, 0.05).laid_x().translate([0.0, 1.74, 0.0]),
        parts.casing([0.15, 1.44, -0.3], [1.0, 1.9, 0.3], 0.04, "steel_grey", detail),
        parts.gauge(0.12, detail).translate([0.0, 1.2, 0.42]),
        parts.handwheel(0.2, "safety_red", detail).laid_x().translate([1.72, 0.85, 0.0]),
    ]
    for x in (0.35, 0.8):
        soups.append(parts.drum(0.17, 1.85, 2.3, paint, detail, 0.04).translate([x, 0.0, 0.0]))
        fins = (0, 3, 7, 12)[detail]
        fin = parts.drum(0.21, 0.0, 0.016, paint, detail)
        soups.append(fin.copies([[x, 1.9 + 0.36 * k / max(fins, 1), 0.0] for k in range(fins)]))
    if detail >= 1:
        line = [[-0.9, 1.3, 0.0], [-0.9, 2.6, 0.0], [-0.9, 2.6, -1.2], [-0.9, -0.02, -1.2]]
        soups.append(parts.piping(line, 0.07, 0.2, "machine_blue", detail))
        soups += [parts.flange(0.07, dark, detail).translate([-0.9, height, -1.2]) for height in (0.3, 1.9)]
        soups.append(parts.casing([1.9, 0.0, -0.5], [2.6, 1.5, 0.4], 0.05, "machine_grey", detail))
    if detail >= 2:
        soups.append(parts.grille(0.5, 0.6, detail).translate([2.25, 0.9, 0.4]))
        soups.append(parts.bolt_circle(16, 0.5, 0.018, 0.03, dark).laid_x().translate([1.3, 0.85, 0.0]))
        soups.append(parts.torus(0.2, 0.03, "rubber", detail).laid_x().translate([-0.05, 1.74, 0.0]))
    return join(soups)
