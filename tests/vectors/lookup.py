"""Vectors of lookups in a cube map in exact arithmetic: nearest, bilinear, least and greatest texel."""

from __future__ import annotations

import itertools
from fractions import Fraction
from typing import Any

from tests.vectors.cubemap import directions, faces, place, scattered, texel, texels
from tests.vectors.exact import STEP_64, Vector, document, rounded

MAP_SIZE = 4
MAP = [float(37 * n % 96) for n in range(6 * MAP_SIZE**2)]
"""Values of a map whose texels all differ."""


def cases() -> list[dict[str, Any]]:
    """Values of a map: within faces, and midway between texels across edges and corners, where symmetry gives them."""
    inside = [d for d in scattered(160, 1000) if _is_bilinear(d)][:24]
    values = [_filtered(d) for d in inside]
    last = Fraction(MAP_SIZE - 1, MAP_SIZE)
    edges, corners = [], []
    for pair, signs in itertools.product(((0, 1), (0, 2), (1, 2)), itertools.product((1, -1), repeat=2)):
        # The middle of a row: the outermost texels of both faces have the same height along the edge.
        for height in (Fraction(1, MAP_SIZE), Fraction(-3, MAP_SIZE)):
            ends = []
            for lengths in ((Fraction(1), last), (last, Fraction(1))):
                point = [height] * 3
                for axis, sign, size in zip(pair, signs, lengths, strict=True):
                    point[axis] = sign * size
                ends.append(point)
            edges.append(ends)
    for octant in itertools.product((1, -1), repeat=3):
        corners.append([[s * (Fraction(1) if n == k else last) for n, s in enumerate(octant)] for k in range(3)])
    return [
        {
            "region": "between four texels of a face",
            "size": MAP_SIZE,
            "map": MAP,
            # Products of values up to 95 with weights that lost a few roundings of coordinates from 0 to 4.
            "tolerance": {"float64": 95 * 64 * STEP_64, "wgsl": 0.0},
            "directions": [list(d) for d in inside],
            **{name: [rounded(value[name]) for value in values] for name in ("nearest", "linear", "min", "max")},
        },
        _seam("midway between two texels across an edge", edges),
        _seam("midway between three texels at a corner", corners, wgsl=True),
    ]


def _position(x: Fraction) -> tuple[int, Fraction]:
    """The texel whose centre lies at or before a position, and the fraction of the way to the next centre."""
    at = (x + 1) / 2 * MAP_SIZE - Fraction(1, 2)
    return int(at), at - int(at)


def _is_bilinear(d: Vector) -> bool:
    """Whether a direction lies between four centres of one face, with a margin for float32."""
    _, u, v = place(d)
    clear = Fraction(1, 1000)
    limit = 1 - Fraction(1, MAP_SIZE) - clear
    return max(abs(u), abs(v)) < limit and all(clear < _position(x)[1] < 1 - clear for x in (u, v))


def _filtered(d: Vector) -> dict[str, Fraction]:
    face, u, v = place(d)
    (column, s), (row, t) = _position(u), _position(v)
    taps = [MAP[(face * MAP_SIZE + row + j) * MAP_SIZE + column + i] for j in (0, 1) for i in (0, 1)]
    weights = [(1 - s) * (1 - t), s * (1 - t), (1 - s) * t, s * t]
    linear = sum((w * Fraction(x) for w, x in zip(weights, taps, strict=True)), Fraction(0))
    nearest = Fraction(MAP[texel(d, MAP_SIZE)])
    return {"nearest": nearest, "linear": linear, "min": Fraction(min(taps)), "max": Fraction(max(taps))}


def _seam(region: str, groups: list[list[list[Fraction]]], *, wgsl: bool = False) -> dict[str, Any]:
    """Directions midway between texels' centres on the cube: the mean of these is their value."""
    middles = [[rounded(sum(x, Fraction(0))) for x in zip(*points, strict=True)] for points in groups]
    values = [[Fraction(MAP[texel(p, MAP_SIZE)]) for p in points] for points in groups]
    return {
        "region": region,
        "size": MAP_SIZE,
        "map": MAP,
        "tolerance": {"float64": 95 * 64 * STEP_64} | ({"wgsl": 0.0} if wgsl else {}),
        "directions": middles,
        "nearest": [rounded(Fraction(MAP[texel(d, MAP_SIZE)])) for d in middles],
        "linear": [rounded(sum(v, Fraction(0)) / len(v)) for v in values],
        "min": [rounded(min(v)) for v in values],
        "max": [rounded(max(v)) for v in values],
    }


def files() -> dict[str, str]:
    """Texts of the files by name."""
    text = document(
        holds="Faces, places u (right) and v (down) on them, texels and directions of cube maps, and look-ups. Faces "
        "are +x -x +y -y +z -z; texels are numbered (face S + row) S + column. `texels` of a direction are by S. "
        "Look-ups are in `map`: nearest, bilinear, and the least and greatest of the texels that bilinear mixes.",
        units="directions of any length, right-handed, y up; u and v from -1 to 1; texels from 0.",
        source='Vulkan 1.3, table "Cube map face selection"; edges belong to the axis that is first in the alphabet, '
        "borders between texels to the farther texel.",
        tolerance={
            "float64": "Faces, texels, nearest, min and max exactly. u and v one rounding of a quotient up to 1; "
            "centres of texels a rounding of a quotient up to 2, none where S is a power of two; linear 64 roundings "
            "of the map's greatest value, 95.",
            "wgsl": "Texels, nearest, min and max exactly. Absent where rounding to float32 decides the texel.",
        },
        faces=faces(),
        directions=directions(),
        texels=texels(),
        lookups=cases(),
    )
    return {"cubemap.json": text}
