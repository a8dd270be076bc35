"""Roofs and the structures on them: parapets and cornices, pitched roofs, plant, tanks and masts."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from nearfar.datasets._random import Floats, RandomStream, xyz
from nearfar.datasets._shapes import Soup, bars, boxes, join, lathe, loft, quads, tube

# Closed profiles (outwards, upwards) around the top of the walls, counter-clockwise, metres.
_PROFILES = {
    "slim": ((-0.25, -0.3), (0.08, -0.3), (0.08, 0.75), (-0.25, 0.75)),
    "plain": ((-0.3, -0.45), (0.14, -0.45), (0.14, -0.1), (0.06, -0.1), (0.06, 0.85), (-0.3, 0.85)),
    "moulded": (
        (-0.35, -0.6), (0.1, -0.6), (0.1, -0.42), (0.24, -0.34), (0.24, -0.2), (0.46, -0.08), (0.5, 0.1),
        (0.06, 0.16), (0.06, 0.8), (-0.35, 0.8),
    ),
}  # fmt: skip


def rectangle(width: float, depth: float, height: float) -> Floats:
    """Corners (4, 3) of a horizontal rectangle, as `loft` takes them."""
    x, z = 0.5 * width, 0.5 * depth
    return xyz([x, x, -x, -x], height, [z, -z, -z, z])


def surround(width: float, depth: float, height: float, profile: ArrayLike, material: int, party: str = "") -> Soup:
    """A closed profile swept around a rectangle, mitred at the corners; on `party` sides it hardly protrudes."""
    outline = np.asarray(profile, np.float64)
    # A twentieth of the overhang remains: enough to keep the profile's points distinct, too little to reach neighbours.
    right, left = (0.05 if side in party else 1.0 for side in ("+x", "-x"))
    loops = np.stack([rectangle(width, depth, height + up) for _, up in outline])
    out, inward = np.maximum(outline[:, :1], 0.0), np.minimum(outline[:, :1], 0.0)
    loops[:, :2, 0] += out * right + inward
    loops[:, 2:, 0] -= out * left + inward
    loops[:, [0, 3], 2] += out + inward
    loops[:, [1, 2], 2] -= out + inward
    above, after = np.roll(loops, -1, axis=0), np.roll(loops, -1, axis=1)
    return quads(np.stack([loops, after, np.roll(above, -1, axis=1), above], 2).reshape(-1, 4, 3), material)


def parapet(width: float, depth: float, height: float, cornice: str, material: int, party: str = "") -> Soup:
    """A cornice with its parapet; the upper edge of the walls ends inside it."""
    return surround(width, depth, height, _PROFILES[cornice], material, party)


def gabled(width: float, depth: float, height: float, pitch: float, material: int, eaves: int, wall: int) -> Soup:
    """A roof with its ridge along x between two gables, which are 2 cm in front of the walls below."""
    z, x = 0.5 * depth + 0.45, 0.5 * width + 0.02
    low, high = height - 0.12, height + 0.06
    outline = np.array([[high + z * pitch, 0.0], [high, z], [low, z], [low, -z], [high, -z]])
    solid = loft(xyz([[-x], [x]], *outline.T), wall)
    materials = solid.materials.copy()
    materials[:10] = np.repeat([material, eaves, eaves, eaves, material], 2)
    return Soup(solid.corners, materials)


def deck(width: float, depth: float, height: float, material: int) -> Soup:
    """A flat roof between the parapets, with its edge inside them."""
    return quads(rectangle(width - 0.2, depth - 0.2, height), material)


def hipped(width: float, depth: float, height: float, pitch: float, material: int, eaves: int) -> Soup:
    """A hipped roof with eaves around it."""
    wide, deep = width + 0.9, depth + 0.9
    rise, ridge = 0.5 * min(wide, deep) * pitch, abs(wide - deep)
    along = (ridge, 0.0) if wide >= deep else (0.0, ridge)
    eave = [rectangle(wide, deep, height + up) for up in (-0.12, 0.06)]
    return loft([*eave, rectangle(*along, height + 0.06 + rise)], [eaves, material], top=False)


def chimney(x: float, z: float, low: float, high: float) -> Soup:
    """A brick chimney with pots."""
    parts = [
        boxes([x - 0.4, low, z - 0.3], [x + 0.4, high, z + 0.3], "brick_brown", without="-y"),
        boxes([x - 0.48, high - 0.2, z - 0.38], [x + 0.48, high - 0.06, z + 0.38], "trim_stone"),
    ]
    for shift in (-0.18, 0.18):
        pot = lathe([(0.12, high - 0.05), (0.09, high + 0.4)], 8, "terracotta", bottom=False)
        parts.append(pot.translate([x + shift, 0.0, z]))
    return join(parts)


def air_handler(random: RandomStream, detail: int) -> Soup:
    """An air handler: a box with fans on rails."""
    wide, deep, high = random.number(1.6, 3.0), random.number(1.2, 1.8), random.number(1.0, 1.6)
    metal = "metal_light" if random.chance(0.6) else "metal"
    parts = [boxes([-wide / 2, 0.15, -deep / 2], [wide / 2, 0.15 + high, deep / 2], metal)]
    if detail >= 2:
        low = [[-wide / 2 - 0.1, -0.1, side * deep * 0.35 - 0.06] for side in (-1, 1)]
        parts.append(bars(low, [wide + 0.2, 0.27, 0.12], "metal_dark", without="-y"))
        for shift in (-0.25, 0.25):
            fan = lathe([(0.42, high + 0.1), (0.42, high + 0.3)], 14, "metal_dark", bottom=False)
            parts.append(fan.translate([shift * wide, 0.0, 0.0]))
    return join(parts)


def stair_head(random: RandomStream, wall: int) -> Soup:
    """The structure over the staircase, with its door."""
    wide, deep, high = random.number(2.6, 3.6), random.number(3.2, 4.6), random.number(2.5, 3.0)
    x, z = wide / 2, deep / 2
    return join([
        boxes([-x, -0.1, -z], [x, high, z], wall, without="-y"),
        boxes([-x - 0.15, high - 0.08, -z - 0.15], [x + 0.15, high + 0.12, z + 0.15], "concrete_dark"),
        boxes([-0.5, -0.1, z - 0.1], [0.5, 2.1, z + 0.04], "metal_dark", without="-y -z"),
    ])  # fmt: skip


def water_tank(detail: int) -> Soup:
    """A wooden tank with a conical roof, on a steel frame."""
    sides = 20 if detail >= 2 else 8
    parts = [
        lathe([(1.35, 2.4), (1.35, 5.2)], sides, "wood"),
        lathe([(1.5, 5.15), (1.5, 5.25), (0.0, 6.3)], sides, "roof_felt", top=False),
        boxes([-1.25, 2.2, -1.25], [1.25, 2.42, 1.25], "iron"),
    ]
    legs = np.array([[x, 0.0, z] for x in (-1.1, 1.1) for z in (-1.1, 1.1)])
    parts.append(boxes(legs - [0.08, 0.1, 0.08], np.add(legs, [0.08, 2.3, 0.08]), "iron", without="-y +y"))
    if detail >= 2:
        parts += [lathe([(1.385, h), (1.385, h + 0.06)], sides, "iron") for h in (2.7, 3.5, 4.3, 5.0)]
    return join(parts)


def mast(high: float) -> Soup:
    """An antenna with cross arms."""
    parts = [tube([(0, -0.1, 0), (0, high * 0.6, 0), (0, high, 0)], [0.07, 0.05, 0.015], 6, "metal_dark")]
    for fraction in (0.55, 0.68, 0.8):
        half, y = 0.7 * (1.2 - fraction), fraction * high
        parts.append(boxes([-half, y, -0.02], [half, y + 0.04, 0.02], "metal_dark"))
    return join(parts)


def furnish(width: float, depth: float, wall: int, random: RandomStream, *, tower: bool, detail: int) -> Soup:
    """Equipment for a flat roof of this size, each piece in its own cell of a grid."""
    columns, rows = max(1, int(width // 7.0)), max(1, int(depth // 6.5))
    cells = [(i, j) for j in range(rows) for i in range(columns)]
    order = np.argsort(random.uniform(len(cells)), kind="stable")
    parts = []
    pieces = ["stairs", "plant", "tank" if random.chance(0.35) and not tower else "plant", "plant", "mast", "plant"]
    for kind, number in zip(pieces[: max(2, len(cells) - 1)], order, strict=False):
        i, j = cells[int(number)]
        x = ((i + 0.5) / columns - 0.5) * (width - 1.6) + random.number(-0.5, 0.5)
        z = ((j + 0.5) / rows - 0.5) * (depth - 1.6) + random.number(-0.5, 0.5)
        if kind == "stairs":
            piece = stair_head(random, wall)
        elif kind == "tank":
            piece = water_tank(detail)
        elif kind == "mast":
            piece = mast(random.number(9.0, 16.0) if tower else random.number(3.0, 6.0))
        else:
            piece = air_handler(random, detail)
        quarter = 0.25 * int(random.integers(1, 4)[0]) if kind != "stairs" else 0.0
        parts.append(piece.rotated(quarter).translate([x, 0.0, z]))
    return join(parts)
