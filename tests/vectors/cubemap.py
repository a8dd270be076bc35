"""Vectors of cube map orientation and lookup in exact arithmetic.

A face's right, down and outward axes are those of the table of faces; u = d·right/|d·out| and v = d·down/|d·out|. A
direction lies on the face of its longest component; where two are equally long, on that of the axis which comes first
in the alphabet. Texel (row, column) covers u from 2 column/S − 1 and v from 2 row/S − 1 on; the last one of a row or
column keeps its far edge too. Texels are numbered (face S + row) S + column.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import Any

from tests.vectors.exact import STEP_64, Vector, rounded, single

FACES = ("+x", "-x", "+y", "-y", "+z", "-z")

AXES = (
    ((1, 0, 0), (0, 0, -1), (0, -1, 0)),
    ((-1, 0, 0), (0, 0, 1), (0, -1, 0)),
    ((0, 1, 0), (1, 0, 0), (0, 0, 1)),
    ((0, -1, 0), (1, 0, 0), (0, 0, -1)),
    ((0, 0, 1), (1, 0, 0), (0, -1, 0)),
    ((0, 0, -1), (-1, 0, 0), (0, -1, 0)),
)
"""Out, right and down of each face: Vulkan 1.3 specification, table "Cube map face selection"."""

SIZES = (1, 3, 4, 8)
"""Numbers of texels across the faces of the tested maps."""


def dot(d: Vector, axis: Vector) -> Fraction:
    """Scalar product with an axis."""
    return sum((Fraction(x) * y for x, y in zip(d, axis, strict=True)), Fraction(0))


def place(d: Vector) -> tuple[int, Fraction, Fraction]:
    """Face, u and v of a direction."""
    longest = max(abs(x) for x in d)
    axis = next(n for n in range(3) if abs(d[n]) == longest)
    face = 2 * axis + (d[axis] < 0)
    out, right, down = AXES[face]
    return face, dot(d, right) / dot(d, out), dot(d, down) / dot(d, out)


def direction(face: int, u: Fraction, v: Fraction) -> list[Fraction]:
    """The direction of a place on a face, whose longest component is ±1."""
    return [o + u * r + v * d for o, r, d in zip(*AXES[face], strict=True)]


def index(position: Fraction, size: int) -> int:
    """Row or column of a position from −1 to 1."""
    return min(int((position + 1) / 2 * size), size - 1)


def texel(d: Vector, size: int) -> int:
    """Number of the texel that a direction passes through."""
    face, u, v = place(d)
    return (face * size + index(v, size)) * size + index(u, size)


def center_of(number: int, size: int) -> list[Fraction]:
    """Direction of a texel's centre."""
    row, column = divmod(number, size)
    face, row = divmod(row, size)
    return direction(face, Fraction(2 * column + 1, size) - 1, Fraction(2 * row + 1, size) - 1)


def _is_clear(d: Vector, size: int) -> bool:
    """Whether a direction is far enough from borders of texels and faces for float32 to find the same texel."""
    _, u, v = place(d)
    near_border = any(abs(x * size - round(x * size)) < Fraction(1, 10**5) for x in ((u + 1) / 2, (v + 1) / 2))
    return not near_border and max(abs(u), abs(v)) < 1 - Fraction(1, 10**5)


def faces() -> list[dict[str, Any]]:
    """Positions on faces and their directions: exact in float64, because components are ±1, ±u and ±v."""
    found = []
    places = [
        (0.0, 0.0),
        (0.25, -0.75),
        (-0.375, 0.5),
        (1.0, 0.125),
        (-0.0625, -1.0),
        (0.1, -0.7),
        (1.0, 1.0),
        (-1.0, 1.0),
    ]
    for face, name in enumerate(FACES):
        out = [rounded(direction(face, Fraction(u), Fraction(v))) for u, v in places]
        u, v = (list(column) for column in zip(*places, strict=True))
        case = {
            "region": f"face {name}",
            "face": face,
            "tolerance": {"float64": 0.0},
            "u": u,
            "v": v,
            "directions": out,
        }
        found.append(case)
    return found


def _case(
    region: str, directions: Sequence[Vector], *, wgsl: bool = True, sizes: tuple[int, ...] = SIZES
) -> dict[str, Any]:
    assert all(single(x) == x for d in directions for x in d), region
    placed = [place(d) for d in directions]
    tolerance = {"float64": STEP_64}
    return {
        "region": region,
        "tolerance": tolerance | ({"wgsl": 0.0} if wgsl else {}),
        "directions": [list(d) for d in directions],
        "face": [face for face, _, _ in placed],
        "u": [rounded(u) for _, u, _ in placed],
        "v": [rounded(v) for _, _, v in placed],
        "texels": {str(size): [texel(d, size) for d in directions] for size in sizes},
    }


def scattered(count: int, first: int = 0) -> Iterator[Vector]:
    """Float32 directions of all octants and lengths from 1e-6 to 1e6, on no border of texels."""
    n = first
    while count:
        shares = [(n + 0.5) * step % 1.0 for step in (0.8191725134, 0.6710436067, 0.5497004779, 0.7548776662)]
        size = 2.0 ** int(40 * shares[3] - 20)
        d = tuple(single((2 * x - 1) * size) for x in shares[:3])
        n += 1
        if all(_is_clear(d, size) for size in SIZES):
            count -= 1
            yield d


def directions() -> list[dict[str, Any]]:
    """Directions and their positions, by the rule that decides face or texel."""
    signs = list(itertools.product((1.0, -1.0), repeat=2))
    edges = {
        "x and y": [(s, t, z) for s, t in signs for z in (0.3125, -0.6875)],
        "x and z": [(s, y, t) for s, t in signs for y in (0.3125, -0.6875)],
        "y and z": [(x, s, t) for s, t in signs for x in (0.3125, -0.6875)],
    }
    axes = [tuple(sign * (n == axis) for n in range(3)) for axis in range(3) for sign in (2.5, -2.5)]
    tiny, huge = 2.0**-120, 2.0**127
    return [
        _case("any direction, of any length", list(scattered(48))),
        # With an odd number of texels the middle of a face is no border.
        _case("along the axes: on a border where the number of texels is even", axes),
        *(_case(f"edge of the faces of {pair}: the first axis", found) for pair, found in edges.items()),
        _case("edges and diagonals at a border of texels", [(x, y, z) for x, y, z in _grid() if 0 in (x, y, z)]),
        _case("corners: the first axis", [(3 * x, 3 * y, 3 * z) for x, y, z in _grid() if 0 not in (x, y, z)]),
        _case(
            "borders between texels: the farther one",
            [
                (1.0, 0.5, -0.25),
                (-1.0, -0.5, 0.75),
                (0.5, 1.0, -0.5),
                (0.25, -1.0, 0.5),
                (-0.5, 0.75, 1.0),
                (0.5, -0.25, -1.0),
            ],
            wgsl=False,
            sizes=(4, 8),
        ),
        _case("zeros of both signs", [(1.0, -0.0, 0.0), (-0.0, -2.0, -0.0), (0.0, -0.0, -0.5)]),
        _case(
            "the ends of float32",
            [(tiny, -tiny / 4, tiny / 2), (huge / 4, huge / 2, -huge), (huge, tiny, -tiny), (tiny, -huge, huge / 4)],
            wgsl=False,
            sizes=(1, 3),
        ),
    ]


def _grid() -> list[Vector]:
    """The 20 directions to edges' middles and corners."""
    return [d for d in itertools.product((1.0, 0.0, -1.0), repeat=3) if sum(map(abs, d)) >= 2]


def texels() -> list[dict[str, Any]]:
    """Texels and the directions of their centres: all of small faces, some of larger ones."""
    found = []
    for size, numbers in (
        (1, range(6)),
        (2, range(24)),
        (3, range(0, 54, 5)),
        (5, range(3, 150, 13)),
        (256, _spread(256)),
    ):
        chosen = list(numbers)
        out = [rounded(center_of(number, size)) for number in chosen]
        # A quotient of up to 2 is rounded, and 1 subtracted from it.
        tolerance = {"float64": 0.0 if size & (size - 1) == 0 else 2 * STEP_64}
        found.append(
            {
                "region": f"{size} texels across",
                "size": size,
                "tolerance": tolerance,
                "texels": chosen,
                "directions": out,
            }
        )
    return found


def _spread(size: int) -> list[int]:
    """The first, a middle and the last texel of each face."""
    return [face * size * size + n for face in range(6) for n in (0, size * size // 3, size * size - 1)]
