"""Parts of machines, pipes and steelwork; round ones stand about the y axis unless they are laid down."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from nearfar.datasets._furnishings import cushion
from nearfar.datasets._palette import Material
from nearfar.datasets._random import cross, turn, xyz
from nearfar.datasets._shapes import Soup, bars, boxes, circles, join, lathe, loft, ring, tube

ROUND = (5, 8, 10, 12)
"""Sides of round parts, by detail."""
THIN = (3, 4, 5, 6)
"""Sides of rods and hoses, by detail."""


def rod(start: ArrayLike, end: ArrayLike, radius: float, paint: Material, detail: int) -> Soup:
    """A straight bar between two points."""
    return tube(np.array([start, end], np.float64), radius, THIN[detail], paint)


def casing(low: ArrayLike, high: ArrayLike, radius: float, paint: Material, detail: int) -> Soup:
    """A housing: a box, with rounded edges from detail 2 on."""
    return boxes(low, high, paint) if detail <= 1 else cushion(low, high, radius, paint, detail - 2)


def drum(radius: float, low: float, high: float, paint: Material, detail: int, rim: float = 0.0) -> Soup:
    """A cylinder, with its rims rounded from detail 2 on."""
    profile: ArrayLike = [(radius, low), (radius, high)]
    if rim > 0.0 and detail >= 2:
        steps = 1 if detail == 2 else 2
        cosine, sine = turn(0.25 * np.arange(steps + 1) / steps)
        lower = np.stack([radius - rim + rim * sine, low + rim - rim * cosine], -1)
        upper = np.stack([radius - rim + rim * cosine, high - rim + rim * sine], -1)
        profile = np.concatenate([lower, upper])
    return lathe(profile, ROUND[detail], paint)


def torus(radius: float, thick: float, paint: Material, detail: int) -> Soup:
    """A round ring."""
    across = (3, 3, 5, 8)[detail]
    cosine, sine = turn(np.append(np.arange(across), 0) / across)
    return lathe(np.stack([radius + thick * cosine, thick * sine], -1), ROUND[detail], paint, bottom=False, top=False)


def handwheel(radius: float, paint: Material, detail: int) -> Soup:
    """A wheel with two spokes across and a hub; a disc at detail 0."""
    if detail == 0:
        return drum(radius, -0.1 * radius, 0.1 * radius, paint, detail)
    return join([
        torus(radius, 0.11 * radius, paint, detail),
        drum(0.2 * radius, -0.3 * radius, 0.2 * radius, "metal", min(detail, 2)),
        rod((-radius, 0, 0), (radius, 0, 0), 0.07 * radius, paint, detail),
        rod((0, 0.01 * radius, -radius), (0, 0.01 * radius, radius), 0.07 * radius, paint, detail),
    ])  # fmt: skip


def bolt_circle(count: int, radius: float, size: float, high: float, paint: Material) -> Soup:
    """Hexagonal bolts in a circle, from −high to +high."""
    bolt = lathe([(size, -high), (size, high)], 6, paint)
    x, z = ring(count, radius, 0.5).T
    return bolt.copies(xyz(x, 0.0, z))


def flange(radius: float, paint: Material, detail: int) -> Soup:
    """The bolted joint of a pipe, half of it on each side of y = 0; none at detail 0."""
    wide, thick = 1.45 * radius + 0.035, 0.015 + 0.07 * radius
    if detail <= 1:
        return drum(wide, -thick, thick, paint, detail) if detail else join([])
    discs = [drum(wide, low, high, paint, detail) for low, high in ((-thick, -0.003), (0.003, thick))]
    size = 0.009 + 0.03 * radius
    return join([*discs, bolt_circle(6, wide - 1.5 * size, size, thick + size, "metal_dark")])


def gauge(radius: float, detail: int) -> Soup:
    """A round dial that looks towards +z, its back at z = 0."""
    parts = [drum(radius, 0.0, 0.5 * radius, "metal_dark", detail, 0.08 * radius).laid_z()]
    if detail >= 1:
        parts.append(drum(0.84 * radius, 0.3 * radius, 0.54 * radius, "paint_white", detail).laid_z())
    if detail >= 2:
        low, size = np.array([[-0.03, -0.15, 0.5], [0.06, 0.8, 0.08]]) * radius
        parts.append(bars(low, size, "safety_red"))
    return join(parts)


def piping(points: ArrayLike, radius: float, bend: float, paint: Material, detail: int, *, thin: bool = False) -> Soup:
    """A pipe along axis-parallel segments between points (P, 3), with bends of radius `bend` in metres between them."""
    line = np.asarray(points, np.float64)
    directions = np.sign(line[1:] - line[:-1])
    steps = (1, 2, 3, 6)[detail]
    c, s = (values[:, None] for values in turn(0.25 * np.arange(steps + 1.0) / steps))
    # The section's frame turns with the pipe and never about it, so that no bend is twisted.
    side = np.roll(directions[0], 1)
    middles, tangents, sides = [line[:1]], [directions[:1]], [side[None]]
    for corner, before, after in zip(line[1:-1], directions[:-1], directions[1:], strict=True):
        axis = cross(before[None], after[None])[0]
        middles.append(corner + bend * (after - before) - bend * after * c + bend * before * s)
        tangents.append(before * c + after * s)
        sides.append((side * axis).sum() * axis + (side * after).sum() * (after * c - before * s))
        side = sides[-1][-1]
    u = np.concatenate([*sides, side[None]])
    w = cross(np.concatenate([*tangents, directions[-1:]]), u)
    count = (THIN if thin else ROUND)[detail]
    return loft(circles(np.concatenate([*middles, line[-1:]]), u, w, radius, count), paint)


def i_beam(low: ArrayLike, length: float, high: float, wide: float, paint: Material) -> Soup:
    """A rolled section along x from its least corner: two flanges and the web between them."""
    thick = 0.06 * high + 0.008
    offsets = [[0.0, 0.0, 0.0], [0.0, high - thick, 0.0], [0.0, 0.5 * thick, 0.5 * wide - 0.4 * thick]]
    sizes = [[length, thick, wide], [length, thick, wide], [length, high - thick, 0.8 * thick]]
    return bars(np.add(low, offsets), sizes, paint)


def slats(low: ArrayLike, size: ArrayLike, step: ArrayLike, count: int, paint: Material) -> Soup:
    """Equal boxes in a row: from a least corner, of a size, at steps (3,)."""
    return bars(np.asarray(low, float) + np.arange(count)[:, None] * np.asarray(step, float), size, paint)


def grille(width: float, height: float, detail: int) -> Soup:
    """A ventilation grille that looks towards +z, centred on the origin, its back at z = 0."""
    x, y, dark = 0.5 * width, 0.5 * height, "metal_dark"
    plate = boxes([-x, -y, -0.01], [x, y, 0.008], dark)
    if detail < 2:
        return plate
    count = max(3, round(height / (0.1 if detail == 2 else 0.08)))
    step = (height - 0.03) / count
    low, size = [0.02 - x, 0.02 - y, 0.0], [width - 0.04, 0.5 * step, 0.02]
    return join([plate, slats(low, size, [0.0, step, 0.0], count, "metal")])


def panel(detail: int) -> Soup:
    """A control panel that looks towards +z, 0.6 m by 0.5 m, centred on the origin, its back at z = −0.12."""
    parts = [casing([-0.3, -0.25, -0.12], [0.3, 0.25, 0.0], 0.025, "machine_grey", detail)]
    parts.append(boxes([-0.25, -0.06, -0.01], [0.1, 0.2, 0.006], "glass_blue"))
    if detail >= 1:
        parts.append(drum(0.035, -0.02, 0.045, "safety_red", detail, 0.01).laid_z().translate([0.2, 0.15, 0.0]))
    if detail >= 2:
        keys = np.array([[-0.24 + 0.05 * i, -0.2 + 0.045 * j, -0.01] for i in range(5) for j in range(3)])
        parts.append(bars(keys, [0.036, 0.032, 0.022], "metal_dark"))
        knobs = [[0.16, -0.19, 0.0], [0.24, -0.19, 0.0], [0.24, -0.1, 0.0]]
        parts.append(drum(0.022, -0.01, 0.03, "metal_light", detail, 0.006).laid_z().copies(knobs))
    return join(parts)


def signal_tower(low: float, detail: int) -> Soup:
    """A pole with red, yellow and green lights, from a height; none at detail 0."""
    if detail == 0:
        return join([])
    parts = [rod((0, low, 0), (0, low + 0.3, 0), 0.015, "metal", detail)]
    for k, name in enumerate(("pipe_green", "safety_yellow", "safety_red")):
        parts.append(drum(0.045, low + 0.3 + 0.1 * k, low + 0.395 + 0.1 * k, name, detail, 0.008))
    return join(parts)
