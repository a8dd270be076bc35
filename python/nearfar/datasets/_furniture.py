"""Street furniture: prototypes that stand on y = 0 and face +z (the carriageway)."""

from __future__ import annotations

import numpy as np

from nearfar.datasets._shapes import Soup, bars, boxes, join, lathe, tube


def lamp_post(detail: int) -> Soup:
    """A post 7 m high with an arm over the street."""
    sides = 6 if detail <= 1 else 9
    path = [(0, 0.7, 0), (0, 6.2, 0), (0, 6.75, 0.15), (0, 6.98, 0.6), (0, 7.02, 1.6)]
    return join([
        lathe([(0.14, -0.1), (0.14, 0.7), (0.1, 0.8), (0.08, 0.82)], sides, "metal_dark", top=False),
        tube(path, [0.07, 0.055, 0.05, 0.045, 0.04], sides, "metal_dark"),
        boxes([-0.13, 6.93, 1.45], [0.13, 7.08, 2.2], "metal_dark"),
        boxes([-0.1, 6.9, 1.55], [0.1, 6.94, 2.15], "paint_white"),
    ])  # fmt: skip


def bench(detail: int) -> Soup:
    """A slatted bench with back, on three iron supports."""
    if detail <= 1:
        return boxes([[-0.9, 0.4, -0.25], [-0.9, 0.46, -0.3]], [[0.9, 0.46, 0.25], [0.9, 0.85, -0.25]], "wood")
    seat = np.array([[-0.9, 0.42, z] for z in (-0.2, -0.08, 0.04, 0.16)])
    back = np.array([[-0.9, y, -0.31 - 0.12 * (y - 0.5)] for y in (0.52, 0.65, 0.78)])
    parts = [bars(seat, [1.8, 0.035, 0.09], "wood"), bars(back, [1.8, 0.09, 0.03], "wood")]
    for x in (-0.75, 0.0, 0.75):
        low = [[x - 0.025, -0.05, -0.27], [x - 0.025, -0.05, 0.17], [x - 0.025, 0.38, -0.26], [x - 0.025, 0.4, -0.29]]
        high = [[x + 0.025, 0.42, -0.21], [x + 0.025, 0.42, 0.23], [x + 0.025, 0.425, 0.22], [x + 0.025, 0.86, -0.25]]
        parts.append(boxes(low, high, "iron"))
    return join(parts)


def bollard(detail: int) -> Soup:
    """A cast-iron bollard."""
    profile = [(0.1, -0.1), (0.1, 0.08), (0.07, 0.12), (0.065, 0.72), (0.09, 0.76), (0.085, 0.84), (0.04, 0.9)]
    return lathe(profile, 6 if detail <= 1 else 8 if detail == 2 else 16, "iron", bottom=False)


def litter_bin(detail: int) -> Soup:
    """A round bin with a lid."""
    sides = 8 if detail <= 1 else 16
    body = lathe([(0.22, -0.05), (0.26, 0.8), (0.2, 0.8), (0.19, 0.7)], sides, "door_green", bottom=False)
    lid = lathe([(0.29, 0.98), (0.29, 1.02), (0.1, 1.12)], sides, "iron")
    legs = boxes([[-0.25, 0.6, -0.02], [0.21, 0.6, -0.02]], [[-0.21, 1.0, 0.02], [0.25, 1.0, 0.02]], "iron")
    return join([body, lid, legs])


def traffic_light(detail: int) -> Soup:
    """A signal post with lamps towards +z."""
    sides = 6 if detail <= 1 else 12
    parts = [tube([(0, -0.1, 0), (0, 1.7, 0), (0, 3.28, 0)], [0.07, 0.06, 0.055], sides, "metal_dark")]
    parts.append(boxes([-0.16, 2.35, 0.02], [0.16, 3.3, 0.24], "metal_dark"))
    for height, name in ((3.12, "tail_light"), (2.83, "sign_mustard"), (2.54, "sign_green")):
        lamp = lathe([(0.09, 0.23), (0.09, 0.26), (0.05, 0.275)], sides, name, bottom=False)
        # The y axis becomes z and x stays. Swapping y and z with one changed sign keeps the outside outside.
        parts.append(lamp.mapped(lamp.corners[..., [0, 2, 1]] * [1.0, -1.0, 1.0]).translate([0.0, height, 0.0]))
    return join(parts)


def shelter(detail: int) -> Soup:
    """A bus stop: a roof with glass at the back and on one side, a bench and a sign."""
    iron, glass = "metal_dark", "glass_sky"
    posts = np.array([[x, -0.1, z] for x in (-1.9, 0.0, 1.86) for z in (-0.6, 0.56)])
    return join([
        boxes([-2.1, 2.45, -0.8], [2.1, 2.57, 1.0], iron),
        bars(posts, [0.05, 2.6, 0.05], iron, without="-y +y"),
        boxes([-1.82, 0.25, -0.585], [1.83, 2.3, -0.565], glass),
        boxes([-1.885, 0.25, -0.5], [-1.865, 2.3, 0.5], glass),
        boxes([-1.5, 0.42, -0.45], [0.9, 0.48, -0.1], "wood"),
        boxes([[-1.3, -0.05, -0.35], [0.6, -0.05, -0.35]], [[-1.24, 0.43, -0.2], [0.66, 0.43, -0.2]], iron),
        tube([(2.6, -0.1, 0.6), (2.6, 1.6, 0.6), (2.6, 3.0, 0.6)], 0.035, 6 if detail <= 1 else 10, iron),
        boxes([2.3, 2.5, 0.57], [2.9, 3.05, 0.63], "sign_navy"),
    ])  # fmt: skip


def fountain(detail: int) -> Soup:
    """A round basin with a bowl on a pillar."""
    sides = 16 if detail <= 1 else 36 if detail == 2 else 96
    rim = [(4.0, -0.2), (4.0, 0.5), (4.15, 0.5), (4.15, 0.62), (3.6, 0.62), (3.6, 0.3)]
    pillar = [(0.5, 0.2), (0.5, 0.6), (0.25, 0.8), (0.22, 1.5), (1.3, 1.95), (1.35, 2.05), (1.2, 2.0), (0.3, 1.85)]
    return join([
        lathe(rim, sides, "trim_stone", bottom=False, top=False),
        lathe([(3.7, 0.42), (0.2, 0.43)], sides, "water", bottom=False),
        lathe(pillar, sides, "trim_stone", bottom=False),
        lathe([(0.14, 1.8), (0.1, 2.6), (0.22, 2.75), (0.04, 2.95)], sides, "trim_stone", bottom=False),
    ])  # fmt: skip
