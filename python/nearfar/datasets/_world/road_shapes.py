"""Shapes of roads, with rails and piers over water, and of a town's streets, with pavements and a square."""

from __future__ import annotations

import functools

import numpy as np

from nearfar.datasets._random import Floats, xyz
from nearfar.datasets._shapes import Indexed, Soup, boxes, join, quads, weld
from nearfar.datasets._world.roads import HALF, Road
from nearfar.datasets._world.sites import Town
from nearfar.datasets._world.streets import MAIN, PAVEMENT, PITCH, SQUARE, SQUARE_RADIUS, Layout, layout, street_pieces

_UNIT = 1.0 / 256.0
"""Quantum of coordinates of roads and streets, metres, exact in float32 up to 65 km from its origin."""
_SKIRT, _RAIL, _PIER, _DEPTH = 0.9, 0.9, 0.6, 9.0
"""Heights of a road's sides and of its rails, half the width of a pier, and depth of its foot under water, metres."""
_TOP, _KERB, _FOOT = 0.06, 0.18, -0.5
"""Heights of carriageways, of pavements and of the part below ground, metres above the ground."""
_GAP = MAIN + PAVEMENT
"""Half the side of a crossing, metres."""


@functools.lru_cache(maxsize=256)
def road_shape(road: Road, lift: float) -> tuple[Indexed, float, float]:
    """Shape of a road raised by `lift` metres, relative to a place in whole metres; also x and z of the place."""
    x0, z0 = (float(np.floor(road.line[0, k])) for k in (0, 2))
    right_x, right_z = road.sides()
    x, y, z = road.line[:, 0] - x0, road.line[:, 1] + lift, road.line[:, 2] - z0

    def edge(across: float, up: float) -> Floats:
        return xyz(x + across * right_x, y + up, z + across * right_z)

    def band(left: Floats, right: Floats, step: int = 1) -> Floats:
        a, b = slice(0, len(x) - 1, step), slice(1, None, step)
        return np.stack([left[b], left[a], right[a], right[b]], 1)

    left, right = edge(-HALF, 0.0), edge(HALF, 0.0)
    low_left, low_right = edge(-HALF, -_SKIRT), edge(HALF, -_SKIRT)
    soups = [
        quads(band(left, right), "asphalt"),
        quads(np.concatenate([band(low_left, left), band(right, low_right)]), "gravel"),
        quads(band(edge(-0.08, 0.02), edge(0.08, 0.02), 2), "paint_white"),
    ]
    wet = road.bridge[:-1] | road.bridge[1:]
    if wet.any():
        soups.append(quads(band(low_right, low_left)[wet], "concrete"))
        for side in (-HALF, HALF):
            inner, outer = edge(side - 0.12, _RAIL), edge(side + 0.12, _RAIL)
            faces = [band(edge(side - 0.12, 0.0), inner), band(inner, outer), band(outer, edge(side + 0.12, 0.0))]
            soups.append(quads(np.concatenate([face[wet] for face in faces]), "concrete"))
        piers = np.flatnonzero(wet)[::3]
        low = xyz(x[piers] - _PIER, -_DEPTH, z[piers] - _PIER)
        high = xyz(x[piers] + _PIER, y[piers] - _SKIRT, z[piers] + _PIER)
        soups.append(boxes(low, high, "concrete", without="+y"))
    soup = join(soups)
    return _weld_rounded(soup, soup.corners), x0, z0


def _weld_rounded(soup: Soup, corners: Floats) -> Indexed:
    """Weld a soup's triangles after its corners are replaced by `corners`, rounded to multiples of `_UNIT`."""
    return weld(soup.mapped(np.floor(corners / _UNIT + 0.5) * _UNIT))


@functools.lru_cache(maxsize=64)
def street_shape(seed: int, town: Town) -> Indexed:
    """Shape of the streets of a town, relative to its centre and the height 0."""
    plan = layout(seed, town)
    soups = [_pavement(a * PITCH[0], b * PITCH[1], _GAP, _GAP, _TOP, "asphalt") for a, b in plan.nodes.tolist()]
    for axis, start, end, line, half in street_pieces(plan.along, plan.across):
        soups += _street(start + _GAP, end - _GAP, line, half, axis)
    soups += [arm for gate in plan.gates for arm in _arm(plan, gate)]
    if town.radius > SQUARE_RADIUS:
        soups.append(_pavement(*SQUARE, 0.1, "paving_warm"))
    soup = join(soups)
    u, y, v = np.moveaxis(soup.corners, -1, 0)
    cosine, sine = town.axis(0).tolist()
    return _weld_rounded(soup, xyz(u * cosine - v * sine, y + town.height, u * sine + v * cosine))


def _slab(p0: float, p1: float, q0: float, q1: float, top: float, kind: str, axis: int) -> Soup:
    """A slab from p0 to p1 along an axis (0 for u, 1 for v) and from q0 to q1 across it."""
    low, high = ([p0, _FOOT, q0], [p1, top, q1]) if axis == 0 else ([q0, _FOOT, p0], [q1, top, p1])
    return boxes(low, high, kind, without="-y")


def _pavement(u: float, v: float, half_u: float, half_v: float, top: float, kind: str) -> Soup:
    """A slab around a middle, with half its sides."""
    return _slab(u - half_u, u + half_u, v - half_v, v + half_v, top, kind, 0)


def _street(start: float, end: float, line: float, half: float, axis: int) -> list[Soup]:
    """A street between two crossings, with a pavement on each side; main streets have a dashed line."""
    slabs = [_slab(start, end, line - half, line + half, _TOP, "asphalt", axis)]
    for side in (line - half - PAVEMENT, line + half):
        slabs.append(_slab(start, end, side, side + PAVEMENT, _KERB, "paving", axis))
    for dash in np.arange(start + 3.0, end - 4.0, 6.0).tolist() if half == MAIN else ():
        slabs.append(_slab(dash, dash + 2.5, line - 0.07, line + 0.07, _TOP + 0.01, "paint_white", axis))
    return slabs


def _arm(plan: Layout, quarter: int) -> list[Soup]:
    """A main street from its last crossing to the gate where a road begins."""
    axis, sign = quarter % 2, 1 if quarter < 2 else -1
    nodes, last = plan.nodes.tolist(), 0
    while ([sign * (last + 1), 0] if axis == 0 else [0, sign * (last + 1)]) in nodes:
        last += 1
    start, end = sorted((sign * (last * PITCH[axis] + _GAP), sign * plan.town.radius))
    return [_slab(start, end, -MAIN, MAIN, _TOP, "asphalt", axis)] if end - start > 1.0 else []
