"""Pallet racks and their loads: pallets with cartons, barrels, sacks and crates."""

from __future__ import annotations

import numpy as np

from nearfar.datasets._factory import parts
from nearfar.datasets._factory.plan import grid
from nearfar.datasets._palette import materials
from nearfar.datasets._random import RandomStream, xyz
from nearfar.datasets._shapes import Soup, bars, boxes, join, lathe, textured

WIDE = 2.8
"""Width of a bay of a rack, metres."""
_LEVELS = (0.0, 1.55, 3.1, 4.65)
_DEEP = 1.1


def rack(seed: int, variant: int, detail: int) -> Soup:
    """A bay of a pallet rack along x from the origin, with its left upright and two pallets on each of four levels."""
    random, orange = RandomStream(seed, 94, variant), "rack_orange"
    soups = [_upright(detail)]
    for level in _LEVELS[1:]:
        if detail == 0:
            soups.append(boxes([0.05, level - 0.13, -0.5 * _DEEP], [WIDE - 0.045, level, 0.5 * _DEEP], orange))
            continue
        for z in (-0.5 * _DEEP, 0.5 * _DEEP - 0.05):
            soups.append(boxes([0.05, level - 0.13, z], [WIDE - 0.05, level, z + 0.05], orange))
        if detail >= 2:
            end_x, end_z = grid([0.045, WIDE - 0.065], [-0.5 * _DEEP - 0.006, 0.5 * _DEEP - 0.056], indexing="ij")
            soups.append(bars(xyz(end_x, level - 0.16, end_z), [0.02, 0.2, 0.062], orange))
    for level in _LEVELS:
        for x in (0.74, 2.06):
            if random.chance(0.12):
                continue
            shift = random.number(-0.03, 0.03)
            load = pallet(random, detail) if detail else _bulk(random)
            soups.append(load.translate([x + shift, level + 0.003, 0.0]))
    return join(soups)


def _bulk(random: RandomStream) -> Soup:
    """A loaded pallet as one box."""
    kinds = materials("cardboard", "cardboard_pale", "barrel_blue", "paper", "steel_grey")
    return boxes([-0.58, 0.0, -0.43], [0.58, random.number(0.8, 1.2), 0.43], random.pick(kinds), without="-y")


def rack_end(detail: int) -> Soup:
    """The upright that ends a row of bays, with guards at its foot."""
    guards = boxes(xyz(-0.02, 0.0, [-0.62, 0.56]), xyz(0.1, 0.4, [-0.56, 0.62]), "safety_yellow")
    return join([_upright(detail), guards])


def _upright(detail: int) -> Soup:
    """A frame of two posts with lacing between them."""
    blue, high = "rack_blue", 6.1
    soups = [bars(xyz(-0.045, -0.01, [-0.5 * _DEEP + 0.002, 0.5 * _DEEP - 0.082]), [0.09, high, 0.08], blue)]
    if detail == 0:
        return soups[0]
    step = (2.0, 2.0, 1.0, 1.0)[detail]
    z = 0.5 * _DEEP - 0.06
    for k, low in enumerate(np.arange(0.2, high - step, step).tolist()):
        ends = ((0.0, low, -z), (0.0, low + step, z)) if k % 2 == 0 else ((0.0, low, z), (0.0, low + step, -z))
        soups.append(parts.rod(*ends, 0.018, blue, min(detail, 1)))
    if detail >= 2:
        soups.append(bars(xyz(-0.08, 0.0, [-0.5 * _DEEP - 0.02, 0.5 * _DEEP - 0.1]), [0.16, 0.012, 0.12], "metal_dark"))
    return join(soups)


def pallet(random: RandomStream, detail: int) -> Soup:
    """A wooden pallet, 1.2 m by 0.9 m on y = 0, with a drawn load up to 1.3 m high."""
    if detail == 0:
        return _bulk(random)
    load = (_cartons, _barrels, _sacks, _crate, _cartons)[int(random.integers(1, 5)[0])](random, detail)
    return join([_boards(detail), load.translate([0.0, 0.145, 0.0])])


def _boards(detail: int) -> Soup:
    wood = "wood_pale"
    runners = [[-0.595, 0.0, z] for z in (-0.44, -0.05, 0.34)]
    if detail <= 1:
        return join([boxes([-0.6, 0.122, -0.45], [0.6, 0.144, 0.45], wood), bars(runners, [1.19, 0.122, 0.1], wood)])
    top = parts.slats([-0.6, 0.122, -0.45], [1.2, 0.022, 0.13], [0.0, 0.0, 0.1925], 5, wood)
    if detail == 2:
        return join([top, bars(runners, [1.19, 0.122, 0.1], wood)])
    block_x = (-0.59, -0.07, 0.45)
    blocks = bars([[x, 0.018, z + 0.002] for x in block_x for _, _, z in runners], [0.14, 0.088, 0.096], wood)
    stringers = bars([[x - 0.002, 0.104, -0.445] for x in block_x], [0.144, 0.02, 0.89], wood)
    return join([top, bars(runners, [1.19, 0.02, 0.1], wood), blocks, stringers])


def _cartons(random: RandomStream, detail: int) -> Soup:
    """Cartons in layers, sometimes with the last ones missing."""
    nx, ny, nz = random.pick(((2, 2, 2), (3, 3, 2), (2, 3, 1), (3, 2, 2)))
    wide, high, deep = 1.16 / nx, random.number(0.85, 1.15) / ny, 0.86 / nz
    brown = random.pick(("cardboard", "cardboard_pale", "cardboard"))
    gap, cells = 0.006, [(i, j, k) for j in range(ny) for k in range(nz) for i in range(nx)]
    missing = int(random.integers(1, nx)[0])
    soups = []
    for i, j, k in cells[: len(cells) - missing]:
        low = np.array([-0.58 + i * wide + gap, j * high, -0.43 + k * deep + gap])
        size = np.array([wide - 2.0 * gap, high - 0.5 * gap, deep - 2.0 * gap])
        soups.append(bars(low, size, brown))
        if detail >= 3:
            middle = low[2] + 0.5 * size[2]
            tape_low = [low[0] - 0.001, low[1] + 0.6 * high, middle - 0.025]
            tape_high = [low[0] + size[0] + 0.001, low[1] + size[1] + 0.001, middle + 0.025]
            soups.append(boxes(tape_low, tape_high, "paper"))
    return join(soups)


def barrel(kind: int, detail: int) -> Soup:
    """A steel drum with rolled hoops, 0.88 m high, on y = 0."""
    if detail <= 1:
        return lathe([(0.285, 0.0), (0.285, 0.88)], parts.ROUND[detail], kind)
    profile: list[tuple[float, float]] = [(0.28, 0.0), (0.29, 0.02)]
    if detail >= 3:
        for hoop in (0.3, 0.58):
            profile += [(0.285, hoop - 0.03), (0.3, hoop), (0.285, hoop + 0.03)]
    profile += [(0.285, 0.85), (0.292, 0.87), (0.28, 0.885), (0.27, 0.865)]
    return lathe(profile, parts.ROUND[detail], kind)


def _barrels(random: RandomStream, detail: int) -> Soup:
    kind = random.pick(materials("barrel_blue", "barrel_blue", "sign_green", "safety_red", "metal_light"))
    offsets = [[-0.3, 0.0, -0.22], [0.3, 0.0, -0.22], [-0.3, 0.0, 0.22], [0.3, 0.0, 0.22]]
    # Four drums do not fit a pallet's depth side by side, so these are slimmer.
    return barrel(kind, detail).scaled([0.74, 1.0, 0.74]).copies(offsets)


def _sacks(random: RandomStream, detail: int) -> Soup:
    """Sacks in layers of alternating direction."""
    cloth = random.pick(("paper", "fabric_sand", "paint_white"))
    soups = []
    for layer in range(int(3 + random.integers(1, 4)[0])):
        step, size = ((0.38, 0.0), [0.375, 0.16, 0.86]) if layer % 2 == 0 else ((0.0, 0.287), [1.14, 0.16, 0.283])
        for k in range(3):
            low = [-0.57 + step[0] * k, 0.15 * layer - 0.005, -0.43 + step[1] * k]
            soups.append(parts.casing(low, np.add(low, size), 0.065, cloth, 2 if detail == 3 else 1))
    return join(soups)


def _crate(random: RandomStream, detail: int) -> Soup:
    """A mesh crate with parts in it."""
    steel, kind = "steel_grey", random.pick(materials("machine_blue", "metal", "rack_orange", "machine_green"))
    heights = np.linspace(0.08, 0.86, (2, 2, 5, 6)[detail])
    soups = [
        bars([[x, 0.0, z] for x in (-0.58, 0.54) for z in (-0.42, 0.38)], [0.04, 0.9, 0.04], steel),
        boxes([-0.57, 0.01, -0.41], [0.57, 0.05, 0.41], steel),
        *(bars(xyz(-0.56, heights, z), [1.12, 0.012, 0.012], steel) for z in (-0.41, 0.39)),
        *(bars(xyz(x, heights, -0.4), [0.012, 0.012, 0.8], steel) for x in (-0.57, 0.55)),
    ]
    for k in range(6):
        x, z = -0.38 + 0.38 * (k % 3), -0.2 + 0.4 * (k // 3)
        soups.append(parts.drum(0.16, 0.04, random.number(0.45, 0.8), kind, detail - 1, 0.03).translate([x, 0.0, z]))
    return join(soups)


def notice_board(picture: int) -> Soup:
    """A notice board on legs against a column at −z, 1.6 m wide."""
    frame = boxes([[-0.84, 0.96, -0.02], [-0.6, 0.0, 0.0], [0.54, 0.0, 0.0]],
                  [[0.84, 2.04, 0.03], [-0.54, 1.0, 0.02], [0.6, 1.0, 0.02]], "metal_light")  # fmt: skip
    sheet = textured([[[-0.8, 1.0, 0.034], [0.8, 1.0, 0.034], [0.8, 2.0, 0.034], [-0.8, 2.0, 0.034]]], picture)
    return join([frame, sheet])
