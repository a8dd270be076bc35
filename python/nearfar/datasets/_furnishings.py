"""Furniture of rooms: prototypes that stand on y = 0 around the y axis, with fronts towards +z."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from nearfar.datasets._palette import Material, materials
from nearfar.datasets._random import RandomStream, turn, xyz
from nearfar.datasets._shapes import Soup, bars, boxes, join, lathe, loft, quads, sphere, textured, triangles, tube

_SPINES = materials(
    "sign_red", "sign_teal", "sign_mustard", "sign_navy", "sign_green", "paper", "brick_brown", "door_red",
    "fabric_sand", "panel_slate", "stone_pink", "trim_dark",
)  # fmt: skip


def cushion(low: ArrayLike, high: ArrayLike, radius: float, paint: Material, detail: int) -> Soup:
    """A box with rounded edges."""
    a, b = np.asarray(low, float), np.asarray(high, float)
    steps = (1, 2, 4, 10)[detail]
    middle, half = 0.5 * (a + b), 0.5 * (b - a)
    # A quarter circle from the rim of the flat bottom to the side, and its mirror image on top.
    cosine, sine = turn(0.25 * np.arange(steps + 1) / steps)
    insets = np.concatenate([radius * (1.0 - sine), radius * (1.0 - sine[::-1])])
    heights = np.concatenate([-half[1] + radius * (1.0 - cosine), (half[1] - radius * (1.0 - cosine))[::-1]])
    sections = np.empty((len(insets), 4 * (steps + 1), 3))
    for k, (cx, cz) in enumerate(((1, -1), (-1, -1), (-1, 1), (1, 1))):
        # Quarter circles from +x over −z, the order of sections in `loft`.
        c, s = (cosine, sine) if k % 2 == 0 else (sine, cosine)
        columns = slice(k * (steps + 1), (k + 1) * (steps + 1))
        reach = radius - insets[:, None]
        sections[:, columns, 0] = middle[0] + cx * (half[0] - radius + reach * c)
        sections[:, columns, 2] = middle[2] + cz * (half[2] - radius + reach * s)
    sections[..., 1] = middle[1] + heights[:, None]
    return loft(sections, paint)


def sofa(detail: int) -> Soup:
    """A sofa with three seats, 2.2 m wide."""
    cloth, legs = "fabric_teal", "wood_dark"
    parts = [cushion([-1.0, 0.14, -0.42], [1.0, 0.36, 0.42], 0.04, cloth, detail)]
    for x in (-0.98, -0.32, 0.34):
        parts.append(cushion([x, 0.345, -0.25], [x + 0.64, 0.5, 0.45], 0.06, cloth, detail))
        parts.append(cushion([x, 0.46, -0.36], [x + 0.64, 0.88, -0.16], 0.08, cloth, detail))
    parts.append(cushion([-1.1, 0.12, -0.48], [1.1, 0.8, -0.3], 0.07, cloth, detail))
    parts += [cushion([x, 0.12, -0.44], [x + 0.16, 0.64, 0.46], 0.06, cloth, detail) for x in (-1.12, 0.96)]
    pillow = cushion([-0.2, 0.0, -0.07], [0.2, 0.36, 0.07], 0.065, "fabric_rust", detail)
    feet = np.array([[x, 0.0, z] for x in (-0.98, 0.92) for z in (-0.38, 0.32)])
    return join([*parts, pillow.translate([0.7, 0.5, 0.0]), bars(feet, [0.06, 0.16, 0.06], legs)])


def table(detail: int) -> Soup:
    """A dining table, 1.8 m by 0.9 m."""
    legs = np.array([[x, 0.0, z] for x in (-0.84, 0.76) for z in (-0.39, 0.31)])
    rails_low = [[-0.8, 0.62, -0.36], [-0.8, 0.62, 0.33], [-0.81, 0.625, -0.34], [0.78, 0.625, -0.34]]
    rails_high = [[0.8, 0.725, -0.33], [0.8, 0.725, 0.36], [-0.78, 0.7225, 0.34], [0.81, 0.7225, 0.34]]
    top = cushion([-0.9, 0.72, -0.45], [0.9, 0.76, 0.45], 0.015, "wood", detail)
    return join([top, bars(legs, [0.08, 0.73, 0.08], "wood"), boxes(rails_low, rails_high, "wood")])


def chair(detail: int) -> Soup:
    """A chair with a slatted back, its front towards +z."""
    wood, cloth = "wood_dark", "fabric_sand"
    sides = (4, 6, 10, 24)[detail]
    parts = [cushion([-0.22, 0.42, -0.21], [0.22, 0.47, 0.22], 0.02, cloth, detail)]
    for x in (-0.19, 0.19):
        parts.append(tube([(x, 0.0, 0.2), (x, 0.25, 0.19), (x, 0.44, 0.18)], [0.016, 0.02, 0.022], sides, wood))
        parts.append(tube([(x, 0.0, -0.24), (x, 0.45, -0.19), (x, 0.92, -0.26)], [0.016, 0.022, 0.016], sides, wood))
    rails = [[-0.19, 0.87, -0.27], [-0.19, 0.58, -0.235], [-0.19, 0.34, -0.215], [-0.19, 0.34, 0.175]]
    sizes = [[0.38, 0.07, 0.025], [0.38, 0.03, 0.025], [0.38, 0.04, 0.02], [0.38, 0.04, 0.02]]
    parts.append(bars(rails, sizes, wood))
    for x in np.linspace(-0.12, 0.12, 4):
        parts.append(tube([(x, 0.59, -0.222), (x, 0.74, -0.242), (x, 0.9, -0.256)], 0.008, max(4, sides // 2), wood))
    return join(parts)


def shelf(seed: int, detail: int) -> Soup:
    """A bookcase, 1.8 m wide and 2 m high, full of books."""
    wood, random = "wood_pale", RandomStream(seed, 70)
    boards = np.array([[-0.88, y, -0.15] for y in (0.06, 0.44, 0.82, 1.2, 1.58)])
    parts = [
        bars(boards, [1.76, 0.025, 0.3], wood),
        boxes([[-0.9, 0.0, -0.16], [0.875, 0.0, -0.16]], [[-0.875, 2.0, 0.16], [0.9, 2.0, 0.16]], wood),
        boxes([[-0.92, 1.98, -0.17], [-0.88, 0.02, -0.158]], [[0.92, 2.02, 0.17], [0.88, 2.0, -0.148]], wood),
    ]
    for board in boards[:, 1] + 0.026:
        x = -0.86
        while x < 0.8:
            thick, high, deep = random.number(0.018, 0.05), random.number(0.2, 0.31), random.number(0.15, 0.22)
            if random.chance(0.06):
                x += random.number(0.05, 0.2)
                continue
            parts.append(_book(x, float(board), thick, high, deep, random.pick(_SPINES), detail))
            x += thick + 0.003
    return join(parts)


def _book(x: float, y: float, thick: float, high: float, deep: float, cover: int, detail: int) -> Soup:
    """A book standing upright, its spine towards +z."""
    front = 0.1
    if detail <= 1:
        return boxes([x, y, front - deep], [x + thick, y + high, front], cover)
    skin = 0.003
    # Covers and pages have different heights, so that no two faces share a plane.
    parts = [
        boxes([[x, y, front - deep], [x + thick - skin, y, front - deep]],
              [[x + skin, y + high, front], [x + thick, y + high, front]], cover),
        boxes([x + 0.5 * skin, y + 0.003, front - deep + 0.005],
              [x + thick - 0.5 * skin, y + high - 0.005, front - 0.002], "paper"),
    ]  # fmt: skip
    steps = 4 if detail == 2 else 16
    cosine, sine = turn(0.5 * np.arange(steps + 1) / steps)
    # From −x over +z to +x.
    spine_x, spine_z = x + 0.5 * thick * (1.0 - cosine), front - 0.0015 + 0.35 * thick * sine
    return join([*parts, loft(xyz(spine_x, [[y + 0.001], [y + high - 0.001]], spine_z), cover)])


def floor_lamp(detail: int) -> Soup:
    """A standing lamp with a cloth shade."""
    sides = (8, 16, 32, 128)[detail]
    foot = [(0.16, 0.0), (0.16, 0.015), (0.03, 0.03), (0.012, 0.04), (0.012, 1.45)]
    cloth = [(0.24, 1.3), (0.17, 1.62), (0.166, 1.62), (0.236, 1.3), (0.24, 1.3)]
    shade = lathe(cloth, sides, "shade", bottom=False, top=False)
    bulb = triangles(sphere(detail), "paint_white").scaled(0.04).translate([0.0, 1.45, 0.0])
    return join([lathe(foot, sides, "iron"), shade, bulb])


def pendant(detail: int) -> Soup:
    """A lamp on a cord from the ceiling at y = 0."""
    sides = (8, 16, 32, 128)[detail]
    bell = [(0.2, -0.95), (0.17, -0.86), (0.06, -0.78), (0.055, -0.79), (0.165, -0.87), (0.19, -0.95), (0.2, -0.95)]
    cord = tube([(0, -0.8, 0), (0, -0.4, 0), (0, 0.02, 0)], 0.006, max(4, sides // 4), "trim_dark")
    bulb = triangles(sphere(detail), "paint_white").scaled(0.05).translate([0.0, -0.9, 0.0])
    return join([lathe(bell, sides, "sign_mustard", bottom=False, top=False), cord, bulb])


def plant(seed: int, detail: int) -> Soup:
    """A pot with long leaves that bend outwards."""
    random, sides = RandomStream(seed, 71), (8, 14, 28, 96)[detail]
    pot = [(0.13, 0.0), (0.18, 0.32), (0.19, 0.32), (0.19, 0.36), (0.165, 0.36), (0.15, 0.3)]
    parts = [
        lathe(pot, sides, "terracotta", top=False),
        lathe([(0.158, 0.2), (0.158, 0.31), (0.02, 0.33)], sides, "soil", bottom=False),
    ]
    leaves, steps = (8, 16, 34, 90)[detail], (3, 4, 8, 24)[detail]
    for turns, reach, rise, wide in zip(
        np.arange(leaves) * 0.381966 + random.uniform(leaves, 0.0, 0.06), random.uniform(leaves, 0.2, 0.55),
        random.uniform(leaves, 0.5, 1.0), random.uniform(leaves, 0.03, 0.055), strict=True,
    ):  # fmt: skip
        t = np.arange(steps + 1.0) / steps
        out, up = 0.03 + reach * t * t, 0.3 + rise * (1.55 * t - 0.7 * t * t)
        half = wide * 4.0 * (t * (1.0 - t) + 0.02) * np.where(t == 1.0, 0.2, 1.0)
        left, right = xyz(out, up, -half), xyz(out, up, half)
        strip = np.stack([left[:-1], right[:-1], right[1:], left[1:]], 1)
        leaf = "leaf_deep" if rise < 0.75 else "leaf"
        parts.append(quads(strip, leaf).rotated(float(turns)))
    return join(parts)


def curtain(width: float, height: float, detail: int) -> Soup:
    """A curtain in folds, hanging from y = height."""
    columns = (6, 16, 48, 240)[detail]
    x = np.linspace(-0.5 * width, 0.5 * width, columns + 1)
    # An eighth of a wave for each column, if there are enough columns.
    waves = (0.25, 0.125, 0.125, 0.025)[detail] * np.arange(columns + 1.0)
    fold = 0.035 * turn(waves)[1]
    outline = np.concatenate([np.stack([x, fold + 0.004], -1), np.stack([x, fold - 0.004], -1)[::-1]])
    levels = np.linspace(0.03, height, (2, 2, 5, 31)[detail])
    swing = 1.0 + 0.25 * (1.0 - levels / height)
    sections = xyz(outline[:, 0], levels[:, None], outline[:, 1] * swing[:, None])
    sides = loft(sections, "fabric_sand", bottom=False, top=False)
    caps = []
    for row, up in ((0, False), (-1, True)):
        front, back = sections[row, : columns + 1], sections[row, columns + 1 :][::-1]
        strip = np.stack([front[:-1], front[1:], back[1:], back[:-1]], 1)
        caps.append(quads(strip if up else strip[:, ::-1], "fabric_sand"))
    return join([sides, *caps])


def crockery(seed: int, detail: int) -> Soup:
    """Plates and cups for four, a bowl of fruit and a vase, on a table top at y = 0."""
    sides, random = (8, 14, 28, 128)[detail], RandomStream(seed, 72)
    plate = [(0.06, 0.0), (0.07, 0.002), (0.125, 0.016), (0.127, 0.02), (0.07, 0.009), (0.01, 0.008)]
    cup = [(0.025, 0.0), (0.036, 0.03), (0.04, 0.08), (0.037, 0.08), (0.033, 0.03), (0.005, 0.008)]
    parts = []
    for x, z in ((-0.4, 0.26), (0.4, 0.26), (-0.4, -0.26), (0.4, -0.26)):
        parts.append(lathe(plate, sides, "paint_snow").translate([x, 0.0, z]))
        parts.append(lathe(cup, sides, "sign_teal").translate([x + 0.17, 0.0, 0.55 * z]))
    bowl = [(0.06, 0.0), (0.15, 0.06), (0.17, 0.1), (0.163, 0.1), (0.143, 0.062), (0.02, 0.02)]
    parts.append(lathe(bowl, sides, "terracotta"))
    for k, name in enumerate(("sign_mustard", "car_red", "leaf_light", "sign_mustard", "leaf_autumn")):
        cosine, sine = turn(0.2 * k + random.number(0.0, 0.05))
        fruit = triangles(sphere(1 + detail if detail else 0), name).scaled([0.042, 0.039, 0.042])
        parts.append(fruit.translate([0.075 * float(cosine), 0.085, 0.075 * float(sine)]))
    vase = [(0.05, 0.0), (0.07, 0.08), (0.03, 0.2), (0.04, 0.24), (0.034, 0.24), (0.024, 0.2), (0.01, 0.05)]
    parts.append(lathe(vase, sides, "paint_sky").translate([0.0, 0.0, -0.32]))
    return join(parts)


def picture(width: float, height: float, canvas: int) -> Soup:
    """A framed picture, its back at z = 0."""
    x, y = 0.5 * width, 0.5 * height
    low = [[-x - 0.03, -y - 0.03, 0.0], [-x - 0.03, y, 0.0], [-x - 0.028, -y - 0.01, 0.0], [x, -y - 0.01, 0.0]]
    high = [[x + 0.03, -y, 0.03], [x + 0.03, y + 0.03, 0.03], [-x, y + 0.01, 0.028], [x + 0.028, y + 0.01, 0.028]]
    view = textured([[[-x, -y, 0.012], [x, -y, 0.012], [x, y, 0.012], [-x, y, 0.012]]], canvas)
    return join([boxes(low, high, "wood_dark"), view])
