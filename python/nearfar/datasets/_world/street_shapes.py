"""Shapes of a town's streets: carriageways with lines, pavements, crossings, and the square with the church."""

from __future__ import annotations

import functools

import numpy as np

from nearfar.datasets._palette import material
from nearfar.datasets._shapes import Indexed, Soup, boxes, join, weld
from nearfar.datasets._world.road_shapes import UNIT
from nearfar.datasets._world.sites import Town
from nearfar.datasets._world.streets import MAIN, PAVEMENT, PITCH, SIDE, SQUARE, SQUARED, Layout, layout

_TOP, _KERB, _FOOT = 0.06, 0.18, -0.5
"""Heights of carriageways, of pavements and of the part below ground, metres above the ground."""
_GAP = MAIN + PAVEMENT
"""Half the side of a crossing, metres."""


@functools.lru_cache(maxsize=64)
def shape(seed: int, town: Town) -> Indexed:
    """The streets of a town, relative to its centre and the height 0."""
    plan = layout(seed, town)
    soups = [_crossing(a, b) for a, b in plan.nodes.tolist()]
    for axis, pieces in enumerate((plan.along, plan.across)):
        for a, b, main in pieces.tolist():
            first, line = (a, b * PITCH[1]) if axis == 0 else (b, a * PITCH[0])
            start, end = first * PITCH[axis] + _GAP, (first + 1) * PITCH[axis] - _GAP
            soups += _street(start, end, line, MAIN if main else SIDE, axis)
    soups += [arm for gate in plan.gates for arm in _arm(plan, gate)]
    if town.radius > SQUARED:
        middle_u, middle_v, wide, deep = SQUARE
        ends = (middle_u - wide, middle_u + wide, middle_v - deep, middle_v + deep)
        soups.append(_slab(*ends, 0.1, "paving_warm", 0))
    soup = join(soups)
    u, v = soup.corners[..., 0], soup.corners[..., 2]
    cosine, sine = town.axis(0).tolist()
    corners = np.stack([u * cosine - v * sine, soup.corners[..., 1] + town.height, u * sine + v * cosine], -1)
    return weld(soup.mapped(np.floor(corners / UNIT + 0.5) * UNIT))


def _slab(p0: float, p1: float, q0: float, q1: float, top: float, kind: str, axis: int) -> Soup:
    """A slab from p0 to p1 along an axis (0 for u, 1 for v) and from q0 to q1 across it."""
    low, high = ([p0, _FOOT, q0], [p1, top, q1]) if axis == 0 else ([q0, _FOOT, p0], [q1, top, p1])
    return boxes(low, high, material(kind), without="-y")


def _crossing(a: int, b: int) -> Soup:
    u, v = a * PITCH[0], b * PITCH[1]
    return _slab(u - _GAP, u + _GAP, v - _GAP, v + _GAP, _TOP, "asphalt", 0)


def _street(start: float, end: float, line: float, half: float, axis: int) -> list[Soup]:
    """A street between two crossings, with a pavement on each side; main streets have a dashed line."""
    slabs = [_slab(start, end, line - half, line + half, _TOP, "asphalt", axis)]
    for side in (line - half - PAVEMENT, line + half):
        slabs.append(_slab(start, end, side, side + PAVEMENT, _KERB, "paving", axis))
    if half == MAIN:
        for at in np.arange(start + 3.0, end - 4.0, 6.0).tolist():
            slabs.append(_slab(at, at + 2.5, line - 0.07, line + 0.07, _TOP + 0.01, "paint_white", axis))
    return slabs


def _arm(plan: Layout, quarter: int) -> list[Soup]:
    """A main street from its last crossing to the gate where a road begins."""
    axis, sign = quarter % 2, 1 if quarter < 2 else -1
    nodes = {(a, b) for a, b in plan.nodes.tolist()}
    last = 0
    while ((sign * (last + 1), 0) if axis == 0 else (0, sign * (last + 1))) in nodes:
        last += 1
    start, end = sorted((sign * (last * PITCH[axis] + _GAP), sign * plan.town.radius))
    return [_slab(start, end, -MAIN, MAIN, _TOP, "asphalt", axis)] if end - start > 1.0 else []
