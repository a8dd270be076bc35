"""The gangway along a wall: gratings on posts, railings, stairs at both ends, and a cabin on a platform."""

from __future__ import annotations

import numpy as np

from nearfar.datasets._factory import parts
from nearfar.datasets._random import xyz
from nearfar.datasets._shapes import Soup, bars, boxes, join, loft
from nearfar.datasets._stage import Stage, placements

_DECK = 4.0
"""Height of the gangway's floor, metres."""
_Z, _MIDDLE = (-58.9, -57.1), 0.5 * (-58.9 + -57.1)
"""The z of both edges of the gangway, and of the line between them, metres."""
_X, _SPAN = (-50.0, 50.0), 2.0
"""The x of the gangway's ends, and the length of its pieces, metres."""
_CABIN = (36.0, 44.0)
"""The x of both ends of the platform with the cabin, in front of the gangway."""


def build(stage: Stage, detail: int) -> None:
    """Add gangway, stairs, railings and cabin."""
    x = np.arange(*_X, _SPAN)
    stage.many(deck(detail), placements(x, 0.0, _Z[0]), "gangway")
    stage.many(_post(detail), placements(np.arange(_X[0], _X[1] + 1.0, 5.0), 0.0, _MIDDLE), "gangway_post")
    open_side = x[(x < _CABIN[0]) | (x >= _CABIN[1])]
    rails = np.concatenate([placements(x, _DECK, _Z[0]), placements(open_side, _DECK, _Z[1])])
    stage.many(railing(_SPAN, detail), rails, "railing")
    stage.many(stairs(detail), placements(_X[::-1], 0.0, _MIDDLE, [0.0, 0.5]), "stairs")
    stage.many(cabin(detail), placements(_CABIN[0], 0.0, _Z[1]), ["mezzanine"])


def railing(length: float, detail: int) -> Soup:
    """A railing along x from the origin, 1.1 m high, with a post at its start and a toe board."""
    yellow = "safety_yellow"
    return join([
        parts.rod((0.0, -0.1, 0.0), (0.0, 1.1, 0.0), 0.024, yellow, detail),
        parts.rod((0.5 * length, -0.1, 0.0), (0.5 * length, 1.1, 0.0), 0.02, yellow, detail),
        parts.rod((0.0, 1.1, 0.0), (length, 1.1, 0.0), 0.026, yellow, detail),
        parts.rod((0.0, 0.58, 0.0), (length, 0.58, 0.0), 0.018, yellow, detail),
        boxes([0.0, 0.0, -0.012], [length, 0.12, -0.004], yellow),
    ])  # fmt: skip


def _grating(length: float, deep: float, detail: int) -> Soup:
    """A floor from the origin along x and z: a plate, or bars from detail 2 on, its upper side at y = 0."""
    if detail <= 1:
        return boxes([0.0, -0.04, 0.0], [length, 0.0, deep], "metal")
    step = 0.2 if detail == 2 else 0.1
    z = np.arange(0.5 * step, deep, 0.5 * step) - 0.5 * step + 0.01
    x = np.arange(0.5 * step, length, step)
    along_x = bars(xyz(0.0, -0.04, z), [length, 0.039, 0.012], "metal")
    return join([along_x, bars(xyz(x, -0.035, 0.005), [0.012, 0.035, deep - 0.01], "metal")])


def deck(detail: int) -> Soup:
    """A piece of the gangway along x, with the beams on both edges."""
    wide, steel = _Z[1] - _Z[0], "steel_blue"
    beams = [parts.i_beam([0.0, _DECK - 0.26, z], _SPAN, 0.22, 0.12, steel) for z in (-0.06, wide - 0.06)]
    return join([_grating(_SPAN, wide, detail).translate([0.0, _DECK, 0.0]), *beams])


def _post(detail: int) -> Soup:
    """Two posts with a beam across, under the gangway."""
    steel, half = "steel_blue", 0.5 * (_Z[1] - _Z[0])
    soups = [bars([[-0.09, 0.0, -half - 0.08], [-0.09, 0.0, half - 0.1]], [0.18, _DECK - 0.44, 0.18], steel)]
    soups.append(boxes([-0.07, _DECK - 0.45, -half - 0.1], [0.07, _DECK - 0.255, half + 0.1], steel))
    soups.append(boxes([-0.16, -0.02, -half - 0.15], [0.16, 0.02, -half + 0.17], steel))
    soups.append(boxes([-0.16, -0.02, half - 0.17], [0.16, 0.02, half + 0.15], steel))
    if detail >= 2:
        soups += [parts.rod((0.0, 2.2, z), (0.0, _DECK - 0.4, 0.0), 0.04, steel, detail) for z in (-half, half)]
    return join(soups)


def stairs(detail: int) -> Soup:
    """Stairs that go down along +x from the deck at the origin, with railings on both sides."""
    steel, yellow, count = "steel_blue", "safety_yellow", 20
    rise, run, half = _DECK / count, 0.27, 0.6
    soups = []
    for k in range(count - 1):
        x, y = run * k, _DECK - rise * (k + 1)
        soups.append(_grating(run + 0.02, 2.0 * half, min(detail, 2)).translate([x, y, -half]))
        low, high = [x + run - 0.02, y - 0.034, -half + 0.005], [x + run + 0.035, y + 0.004, half - 0.005]
        soups.append(boxes(low, high, yellow))
    foot_x = run * count
    for z in (-half - 0.02, half + 0.02):
        ends = ((0.0, _DECK - 0.32, _DECK - 0.02), (foot_x, -0.02, 0.2))
        stringer = [[[x, y0, z + 0.02], [x, y0, z - 0.02], [x, y1, z - 0.02], [x, y1, z + 0.02]] for x, y0, y1 in ends]
        soups.append(loft(stringer, steel))
        for height, thick in ((1.05, 0.026), (0.55, 0.018)):
            soups.append(parts.rod((0.0, _DECK + height, z), (foot_x, height, z), thick, yellow, detail))
        for fraction in (0.02, 0.25, 0.5, 0.75, 0.98):
            x, y = fraction * foot_x, _DECK * (1.0 - fraction)
            soups.append(parts.rod((x, y - 0.05, z), (x, y + 1.05, z), 0.022, yellow, detail))
    return join(soups)


def cabin(detail: int) -> Soup:
    """A platform from the origin along x and z at the gangway's height, with a glazed cabin and a railing in front."""
    wide, deep = _CABIN[1] - _CABIN[0], 3.6
    soups = [
        boxes([0.0, _DECK - 0.12, 0.0], [wide, _DECK - 0.001, deep], "metal"),
        bars([[0.0, _DECK - 0.4, 0.5], [0.0, _DECK - 0.4, deep - 0.3]], [wide, 0.29, 0.14], "steel_blue"),
    ]
    legs = [[x, 0.0, z] for x in (0.2, wide - 0.4) for z in (0.48, deep - 0.32)]
    soups.append(bars(legs, [0.2, _DECK - 0.39, 0.18], "steel_blue"))
    x0, x1, z1, head = 1.2, wide - 0.8, deep - 1.1, _DECK + 2.5
    soups.append(boxes([x0, _DECK - 0.002, 0.35], [x1, _DECK + 0.9, z1], "panel_white"))
    soups.append(boxes([x0 + 0.06, _DECK + 0.88, 0.41], [x1 - 0.06, head, z1 - 0.06], "glass_steel"))
    soups.append(boxes([x0 - 0.15, head - 0.2, 0.2], [x1 + 0.15, head + 0.15, z1 + 0.15], "steel_grey"))
    posts = np.linspace(x0, x1 - 0.1, (3, 5, 7, 9)[detail])
    soups += [bars(xyz(posts, _DECK + 0.85, z), [0.1, 1.5, 0.1], "panel_white") for z in (0.34, z1 - 0.09)]
    soups.append(boxes([x0 - 0.03, _DECK + 0.02, 0.7], [x0 + 0.02, _DECK + 2.1, 1.6], "door_blue"))
    soups.append(railing(wide, detail).translate([0.0, _DECK, deep - 0.05]))
    soups += [railing(deep - 0.1, detail).rotated(-0.25).translate([x, _DECK, 0.0]) for x in (0.05, wide - 0.05)]
    if detail >= 1:
        low, high = [4.0, head + 0.14, 0.8], [5.6, head + 0.8, 1.8]
        soups.append(parts.casing(low, high, 0.05, "metal_light", detail))
        soups.append(parts.grille(1.3, 0.4, detail).translate([4.8, head + 0.46, 1.8]))
    return join(soups)
