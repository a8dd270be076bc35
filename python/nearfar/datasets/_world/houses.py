"""Houses and a church: shapes placed many times by towns."""

from __future__ import annotations

import dataclasses
import functools

import numpy as np

from nearfar.datasets import _roofs as roofs
from nearfar.datasets._buildings import Kind
from nearfar.datasets._palette import material, materials
from nearfar.datasets._random import RandomStream
from nearfar.datasets._shapes import Indexed, Soup, bars, boxes, join, loft, weld
from nearfar.datasets._styles import BRICK, STONE, STUCCO
from nearfar.datasets._walls import Paint, walls

COTTAGE, CHURCH = 0, 9
"""`Kind.form` of a house and of a church."""
_FOOT = 0.5
_TILES = materials("roof_tile", "roof_tile_dark", "roof_tile", "roof_slate", "roof_tile_dark")
_PALE = ("paint_snow", "paint_cream", "stone_pale", "paint_snow", "paint_ochre", "paint_rose")
_STYLES = (
    dataclasses.replace(STUCCO, walls=_PALE, storey=2.75, balcony="", course_every=0, bay=2.6),
    dataclasses.replace(BRICK, storey=2.75, bay=2.7, walls=("brick_red", "brick_orange", "brick_brown")),
    dataclasses.replace(STUCCO, walls=_PALE, storey=2.75, balcony="", course_every=0, shutters=False, bay=2.6),
    dataclasses.replace(STONE, storey=2.8, balcony="", course_every=0, bay=2.8),
)


@functools.lru_cache(maxsize=512)
def shape(seed: int, kind: Kind, detail: int) -> Indexed:
    """The shape of a kind at detail 0 … 2, on the ground y = 0 around the y axis, its front towards +z."""
    return weld(cottage(seed, kind, detail) if kind.form == COTTAGE else church(detail))


def cottage(seed: int, kind: Kind, detail: int) -> Soup:
    """A house of one or two storeys under a tiled roof with its ridge along the street, or across it."""
    random = RandomStream(seed, 220, kind.width, kind.depth, kind.variant)
    style = random.pick(_STYLES)
    paint = Paint.pick(style, random)
    storeys = (1 if random.chance(0.35) else 2) + int(kind.width >= 140)
    width, depth = 0.1 * kind.width, 0.1 * kind.depth
    is_across = depth > width
    # Drawn before the walls, whose number of draws depends on the detail.
    tiles, pitch, gabled = random.pick(_TILES), random.number(0.75, 1.05), random.chance(0.75)
    rows = np.concatenate([[-_FOOT], 3.1 + style.storey * np.arange(storeys), [3.45 + style.storey * (storeys - 1)]])
    faces = ("street", "yard", "street", "yard"), False, True
    parts = walls((width, depth), rows, faces, style, paint, random, detail)
    wide, narrow = (depth, width) if is_across else (width, depth)
    top = float(rows[-1])
    if gabled:
        roof = roofs.gabled(wide, narrow, top, pitch, tiles, paint.trim, paint.wall)
    else:
        roof = roofs.hipped(wide, narrow, top, 0.8 * pitch, tiles, paint.trim)
    if detail >= 1:
        ridge = 0.5 * (narrow + 0.9) * pitch
        roof = join([roof, roofs.chimney(0.22 * wide, -0.12 * narrow, top, top + 0.95 * ridge + 0.7)])
    return join([*parts, roof.rotated(0.25) if is_across else roof])


def church(detail: int) -> Soup:
    """A church with a tower at its front, 36 m high."""
    stone, trim, slate, glass = (material(n) for n in ("stone_pale", "trim_stone", "roof_slate", "glass_dark"))
    parts = [
        boxes([-5.5, -_FOOT, -15.0], [5.5, 8.5, 9.0], stone, without="-y +y"),
        roofs.gabled(24.0, 11.0, 8.5, 1.15, slate, trim, stone).rotated(0.25).translate([0.0, 0.0, -3.0]),
        boxes([-3.1, -_FOOT, 7.0], [3.1, 21.0, 13.2], stone, without="-y +y"),
        boxes([-3.4, 20.6, 6.7], [3.4, 21.3, 13.5], trim),
    ]
    spire = [roofs.rectangle(2.0 * half, 2.0 * half, y) for half, y in ((3.2, 21.3), (1.9, 25.5), (0.0, 35.5))]
    parts.append(loft(spire, slate, bottom=False, top=False).translate([0.0, 0.0, 10.1]))
    if detail >= 1:
        panes = [[x - 0.06, 2.2, z] for x in (-5.5, 5.5) for z in np.arange(-13.0, 6.0, 4.2).tolist()]
        parts += [
            bars(panes, [0.12, 4.6, 1.3], glass),
            boxes([-1.0, -0.1, 13.1], [1.0, 3.0, 13.28], "door_wood", without="-y"),
            bars([[-0.7, 8.0, 13.1], [-0.7, 15.5, 13.1]], [1.4, 2.6, 0.17], glass),
            bars([[x - 0.06, 15.5, 9.4] for x in (-3.1, 3.1)], [0.12, 2.6, 1.4], glass),
        ]
    return join(parts)
