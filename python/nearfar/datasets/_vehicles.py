"""Cars, vans and buses: prototypes with fronts towards +z and wheels on y = 0."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from nearfar.datasets._palette import Material
from nearfar.datasets._random import Floats
from nearfar.datasets._shapes import Soup, boxes, join, lathe, loft

PAINTS = ("car_white", "car_silver", "car_black", "car_red", "car_blue", "car_green", "car_yellow", "car_beige")


@dataclass(frozen=True)
class Body:
    """Side view of a vehicle: stations along its length with their heights, metres from its middle."""

    half_width: float
    stations: tuple[tuple[float, float], ...]
    """(z, height of the body's shoulder), from the tail to the nose."""
    cabin: tuple[tuple[float, float], ...]
    """Lower and upper edge of the windows: rear foot, rear roof, front roof, front foot, as (z, height)."""
    wheels: tuple[float, ...]
    wheel_radius: float = 0.32
    clearance: float = 0.22


SALOON = Body(
    0.88,
    ((-2.2, 0.72), (-2.1, 0.92), (-1.4, 0.98), (0.9, 0.95), (1.9, 0.84), (2.15, 0.7), (2.25, 0.55)),
    ((-1.75, 0.95), (-1.0, 1.42), (0.25, 1.44), (1.05, 0.93)),
    (-1.32, 1.36),
)
HATCH = Body(
    0.85,
    ((-1.9, 0.7), (-1.86, 0.98), (-1.2, 1.0), (0.8, 0.97), (1.7, 0.86), (1.9, 0.7), (1.98, 0.52)),
    ((-1.8, 0.97), (-1.45, 1.46), (0.15, 1.5), (0.95, 0.95)),
    (-1.2, 1.22),
)
ESTATE = Body(
    0.92,
    ((-2.25, 0.8), (-2.2, 1.08), (-1.4, 1.1), (0.85, 1.06), (1.85, 0.98), (2.12, 0.8), (2.2, 0.6)),
    ((-2.12, 1.06), (-1.85, 1.66), (0.2, 1.7), (1.0, 1.04)),
    (-1.35, 1.35),
    wheel_radius=0.36,
    clearance=0.28,
)
VAN = Body(
    0.98,
    ((-2.6, 1.0), (-2.58, 1.14), (-1.4, 1.16), (1.2, 1.14), (2.2, 1.1), (2.5, 0.95), (2.58, 0.6)),
    ((-2.56, 1.12), (-2.5, 2.15), (1.2, 2.2), (2.15, 1.08)),
    (-1.55, 1.65),
    wheel_radius=0.36,
)
BODIES = (SALOON, HATCH, ESTATE, HATCH, SALOON, VAN)


def car(body: Body, paint: Material, detail: int) -> Soup:
    """A vehicle of one colour; at detail 0 two boxes without wheels."""
    if detail == 0:
        tail, nose, half = body.stations[0][0], body.stations[-1][0], body.half_width
        (z0, _), (_, top), _, (z3, _) = body.cabin
        low, high = [[-half, 0.2, tail], [0.1 - half, 0.9, z0]], [[half, 0.95, nose], [half - 0.1, top, 0.7 * z3]]
        return boxes(low, high, [paint, "glass_dark"])
    parts = [_shell(body, paint), _glass_house(body, paint, opaque=body is VAN)]
    right = _wheel(body, 8 if detail <= 1 else 12 if detail == 2 else 32)
    left, x, y = right.rotated(0.5), body.half_width - 0.12, body.wheel_radius
    parts += [wheel for z in body.wheels for wheel in (left.translate([-x, y, z]), right.translate([x, y, z]))]
    if detail >= 2:
        parts += _trimmings(body)
    return join(parts)


def _section(half: float, low: float, high: float, z: float) -> Floats:
    """A cross-section with rounded edges, counter-clockwise as seen from the nose."""
    r = 0.09
    return np.array(
        [
            [half - r, low, z], [half, low + r, z], [half + 0.015, 0.5 * (low + high), z],
            [half - 0.5 * r, high - 0.5 * r, z],
            [half - 2.0 * r, high, z], [-half + 2.0 * r, high, z], [-half + 0.5 * r, high - 0.5 * r, z],
            [-half - 0.015, 0.5 * (low + high), z], [-half, low + r, z], [-half + r, low, z],
        ]
    )  # fmt: skip


def _shell(body: Body, paint: Material) -> Soup:
    first, last = body.stations[0][0], body.stations[-1][0]
    sections = []
    for z, high in body.stations:
        # 0 in the middle, 1 at both ends, towards which the plan narrows slightly.
        end = abs(2.0 * (z - first) / (last - first) - 1.0)
        low = body.clearance + (0.1 if end > 0.97 else 0.0)
        sections.append(_section(body.half_width * (1.0 - 0.12 * end * end * end * end), low, high, z))
    return loft(sections, paint)


def _glass_house(body: Body, paint: Material, *, opaque: bool) -> Soup:
    """Windows all around under a painted roof; a van has glass at the front only."""
    (z0, y0), (z1, y1), (z2, y2), (z3, y3) = body.cabin
    half, top = body.half_width - 0.07, body.half_width - 0.2
    foot = np.array([[half, y3 - 0.05, z3], [half, y0 - 0.05, z0], [-half, y0 - 0.05, z0], [-half, y3 - 0.05, z3]])
    roof = np.array([[top, y2, z2], [top, y1, z1], [-top, y1, z1], [-top, y2, z2]])
    raised_roof = roof * [0.94, 1.0, 1.0]
    raised_roof[:, 1] += 0.045
    parts = [loft([foot, roof, raised_roof], ["glass_dark", paint])]
    if opaque:
        parts.append(boxes([-half - 0.01, y0 - 0.06, z0 - 0.012], [half + 0.01, y1 - 0.12, z2 - 0.35], paint))
    return join([*parts, *_pillars(foot, roof, paint)])


def _pillars(foot: Floats, roof: Floats, paint: Material) -> list[Soup]:
    """Posts at the four corners and between the doors, slightly outside the glass."""
    right = np.array([[0.012, 0.0, 0.04], [0.012, 0.0, -0.04], [-0.03, 0.0, -0.04], [-0.03, 0.0, 0.04]])
    lows, highs = ([*ends, 0.5 * (ends[0] + ends[1]), 0.5 * (ends[2] + ends[3])] for ends in (foot, roof))
    parts = []
    for low, high in zip(lows, highs, strict=True):
        section = right if low[0] > 0 else right[::-1] * [-1.0, 1.0, 1.0]
        parts.append(loft(np.stack([low + section, high + section + [0.0, 0.01, 0.0]]), paint))
    return parts


def _wheel(body: Body, sides: int) -> Soup:
    """A tyre with its rim, its axle along x and its outside towards +x."""
    r = body.wheel_radius
    tyre = lathe([(r, -0.1), (r, 0.08), (0.9 * r, 0.11)], sides, "tyre")
    rim = lathe([(0.6 * r, 0.05), (0.58 * r, 0.118), (0.2 * r, 0.135)], sides, "metal_light", bottom=False)
    return join([tyre, rim]).laid_x()


def _trimmings(body: Body) -> list[Soup]:
    """Lights, bumpers, plates, mirrors, wheel wells."""
    (tail, high), *_, (front, shoulder), (nose, _) = body.stations
    half = body.half_width
    head = shoulder - 0.12
    well = lathe([(body.wheel_radius + 0.05, 0.0), (body.wheel_radius + 0.05, 0.16)], 14, "metal_dark").laid_x()
    parts = [boxes([-0.55 * half, 0.32, nose - 0.2], [0.55 * half, 0.47, nose + 0.02], "metal_dark")]
    parts.append(boxes([-0.26, 0.5, tail - 0.02], [0.26, 0.6, tail + 0.1], "paint_white"))
    for side in (-1.0, 1.0):
        x0, x1 = sorted((side * 0.5 * half, side * 0.82 * half))
        parts.append(boxes([x0, head - 0.13, front - 0.2], [x1, head, front + 0.045], "paint_white"))
        parts.append(boxes([x0, high - 0.16, tail - 0.025], [x1, high - 0.02, tail + 0.1], "tail_light"))
        m0, m1 = sorted((side * (half - 0.05), side * (half + 0.17)))
        z, mirror = body.cabin[3][0], body.cabin[3][1] + 0.02
        parts.append(boxes([m0, mirror, z - 0.42], [m1, mirror + 0.14, z - 0.3], "metal_dark"))
        side_well = well.rotated(0.0 if side > 0 else 0.5)
        parts += [side_well.translate([side * (half - 0.14), body.wheel_radius + 0.02, z]) for z in body.wheels]
    return parts
