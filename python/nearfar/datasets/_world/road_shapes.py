"""Shapes of roads: a strip with its sides, a dashed line, and rails and piers over water."""

from __future__ import annotations

import functools

import numpy as np

from nearfar.datasets._draw import Floats
from nearfar.datasets._palette import material
from nearfar.datasets._shapes import Indexed, boxes, join, quads, weld
from nearfar.datasets._world.roads import HALF, Road

UNIT = 1.0 / 256.0
"""Quantum of coordinates of roads and streets, metres, exact in float32 up to 65 km from its origin."""
_SKIRT, _RAIL, _PIER, _DEPTH = 0.9, 0.9, 0.6, 9.0


@functools.lru_cache(maxsize=256)
def shape(road: Road, lift: float) -> tuple[Indexed, float, float]:
    """Shape of a road raised by `lift` metres, relative to a place in whole metres; also x and z of the place."""
    x0, z0 = (float(np.floor(road.line[0, k])) for k in (0, 2))
    right_x, right_z = road.sides()
    x, y, z = road.line[:, 0] - x0, road.line[:, 1] + lift, road.line[:, 2] - z0

    def edge(across: float, up: float) -> Floats:
        return np.stack([x + across * right_x, y + up, z + across * right_z], -1)

    def band(left: Floats, right: Floats, every: int = 1) -> Floats:
        a, b = slice(0, len(x) - 1, every), slice(1, None, every)
        return np.stack([left[b], left[a], right[a], right[b]], 1)

    left, right = edge(-HALF, 0.0), edge(HALF, 0.0)
    low_left, low_right = edge(-HALF, -_SKIRT), edge(HALF, -_SKIRT)
    gravel, concrete = material("gravel"), material("concrete")
    soups = [
        quads(band(left, right), material("asphalt")),
        quads(np.concatenate([band(low_left, left), band(right, low_right)]), gravel),
        quads(band(edge(-0.08, 0.02), edge(0.08, 0.02), 2), material("paint_white")),
    ]
    wet = road.bridge[:-1] | road.bridge[1:]
    if wet.any():
        soups.append(quads(band(low_right, low_left)[wet], concrete))
        for side in (-HALF, HALF):
            inner, outer = edge(side - 0.12, _RAIL), edge(side + 0.12, _RAIL)
            faces = [band(edge(side - 0.12, 0.0), inner), band(inner, outer), band(outer, edge(side + 0.12, 0.0))]
            soups.append(quads(np.concatenate([face[wet] for face in faces]), concrete))
        piers = np.flatnonzero(wet)[::3]
        low = np.stack([x[piers] - _PIER, np.full(len(piers), -_DEPTH), z[piers] - _PIER], -1)
        high = np.stack([x[piers] + _PIER, y[piers] - _SKIRT, z[piers] + _PIER], -1)
        soups.append(boxes(low, high, concrete, without="+y"))
    soup = join(soups)
    return weld(soup.mapped(np.floor(soup.corners / UNIT + 0.5) * UNIT)), x0, z0
