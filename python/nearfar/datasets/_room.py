"""The room: a furnished interior with windows onto a garden."""

from __future__ import annotations

import itertools

import numpy as np

from nearfar._base import check
from nearfar._scene.scene import Scene
from nearfar.datasets import (
    _facade as facade,
    _furnishings as furnishings,
    _textures as textures,
    _vegetation as vegetation,
)
from nearfar.datasets._buildings import Kind, building
from nearfar.datasets._facade import Rectangles
from nearfar.datasets._random import RandomStream, xyz
from nearfar.datasets._shapes import Soup, boxes, join, quads, sheet, textured
from nearfar.datasets._stage import Stage, placements

# Half the inner width along x and z, the inner height, and the thickness of the walls, metres.
_X, _Z, _HIGH, _WALL = 3.2, 2.6, 2.7, 0.3
_FOOT, _TOP = -0.08, _HIGH + 0.04
_CHAIRS = ((-0.45, -0.95, 0.0), (0.45, -0.95, 0.0), (-0.45, 0.95, 0.5), (0.5, 1.05, 0.55))
_TABLE = (1.15, -0.75)


def room(seed: int = 0, detail: int = 2) -> Scene:
    """Make a furnished room, 6.4 m by 5.2 m, with two windows towards −z, onto a garden with houses behind it.

    The floor is at y = 0 and the origin in the middle of the room: see `room_view`. The floor, the rug and the pictures
    have textures. Objects are called "walls", "floor", "table", "sofa", "shelf", "lamp", "plant" and so on; "chair_0"
    to "chair_3" are dynamic. ValueError for numbers out of range.

    Parameters
    ----------
    seed
        0 to 2⁶³ − 1; it decides the books, the plant, the pictures and the garden.
    detail
        0: some thousand triangles. 1: ten thousand and more. 2: about eighty thousand. 3: several hundred
        thousand, round edges and folds included.
    """
    seed = check.integer("seed", seed, 0, 2**63 - 1)
    detail = check.integer("detail", detail, 0, 3)
    stage = Stage()
    stage.once(_shell(), "walls")
    stage.once(_frames(), "windows")
    stage.once(_door(), "door")
    _floor(stage, seed)
    _furnish(stage, seed, detail)
    _garden(stage, seed, detail)
    chairs = [f"chair_{k}" for k in range(len(_CHAIRS))]
    x, z, turns = np.array(_CHAIRS).T
    stage.many(furnishings.chair(detail), placements(_TABLE[0] + x, 0.0, _TABLE[1] + z, turns), chairs, moves=True)
    return stage.build(dynamic=chairs)


def room_view() -> tuple[tuple[float, float, float], tuple[float, float, float]]:
    """A view for pictures of `room`: eye and target, world metres."""
    return (-1.9, 1.55, 2.25), (0.75, 1.05, -1.6)


_WINDOWS, _DOOR = np.array([[-2.5, -0.7, 0.85, 2.3], [0.7, 2.5, 0.85, 2.3]]), np.array([[0.6, 1.5, -0.03, 2.1]])
_LONG_WALL, _SHORT_WALL = np.array([[-_X, _X, _FOOT, _TOP]]), np.array([[-_Z, _Z, _FOOT, _TOP]])
_WALLS: tuple[tuple[Rectangles, Rectangles], ...] = (
    (np.array([[-_X, 0.0, _FOOT, _TOP], [0.0, _X, _FOOT, _TOP]]), _WINDOWS),
    (_SHORT_WALL, _WINDOWS[:0]), (_LONG_WALL, _WINDOWS[:0]), (_SHORT_WALL, _DOOR),
)  # fmt: skip
"""Cells of the four walls, in the order −z, −x, +z, +x, and a hole for each cell, or none."""


def _shell() -> Soup:
    """Walls with their holes, ceiling, roof and foundation."""
    parts = []
    for quarter, (cells, holes) in enumerate(_WALLS):
        inside = "wall_accent" if quarter == 1 else "wall_paint"
        if len(holes):
            side = facade.wall_with_holes(cells, holes, _WALL, inside, "trim_white", "paint_snow")
        else:
            back = facade.plain(cells, "paint_snow").translate([0.0, 0.0, -_WALL])
            side = join([facade.plain(cells, inside), back.mapped(back.corners[:, ::-1])])
        parts.append(side.translate([0.0, 0.0, -_Z if quarter % 2 == 0 else -_X]).rotated(0.25 * quarter))
    for sx, sz in itertools.product((-1.0, 1.0), repeat=2):
        (x0, x1), (z0, z1) = sorted((sx * _X, sx * (_X + _WALL))), sorted((sz * _Z, sz * (_Z + _WALL)))
        hidden = ("-x" if sx > 0 else "+x") + (" -z" if sz > 0 else " +z")
        parts.append(boxes([x0, _FOOT, z0], [x1, _TOP, z1], "paint_snow", without=hidden))
    x, z = _X + 0.05, _Z + 0.05
    parts.append(quads([[[-x, _HIGH, -z], [x, _HIGH, -z], [x, _HIGH, z], [-x, _HIGH, z]]], "ceiling"))
    for low, high, out, name in ((_HIGH + 0.02, 3.05, 0.55, "roof_slate"), (-0.6, -0.06, 0.06, "concrete")):
        x, z = _X + _WALL + out, _Z + _WALL + out
        parts.append(boxes([-x, low, -z], [x, high, z], name))
    return join(parts)


def _frames() -> Soup:
    """Glazing bars, window boards, curtain rails."""
    parts = []
    for hole in _WINDOWS:
        bars = facade.bars(hole[None], 0.16, "+", "trim_white", frame=True, hidden="")
        u0, u1, v0, _ = hole
        board = boxes([u0 - 0.08, v0 - 0.035, -0.1], [u1 + 0.08, v0 + 0.012, 0.16], "trim_white")
        rail = boxes([u0 - 0.3, 2.42, 0.09], [u1 + 0.3, 2.445, 0.115], "iron")
        parts.append(join([bars, board, rail]).translate([0.0, 0.0, -_Z]))
    return join(parts)


def _door() -> Soup:
    """The door with its frame and handle, and the skirting along all walls."""
    u0, u1, _, v1 = _DOOR[0]
    wood, white, metal = "wood_pale", "trim_white", "metal_light"
    jambs = xyz([u0 - 0.07, u1 - 0.01], -0.02, -0.02), xyz([u0 + 0.01, u1 + 0.07], v1 + 0.02, 0.025)
    parts = [
        boxes([u0 - 0.01, 0.005, -0.11], [u1 + 0.01, v1 + 0.01, -0.06], wood),
        boxes(*jambs, white),
        boxes([u0 - 0.075, v1 - 0.01, -0.02], [u1 + 0.075, v1 + 0.07, 0.03], white),
        boxes([u0 + 0.06, 1.02, -0.07], [u0 + 0.085, 1.045, -0.005], metal),
        boxes([u0 + 0.058, 1.018, -0.012], [u0 + 0.19, 1.047, 0.004], metal),
        boxes(xyz([-_Z, u1 + 0.069], -0.02, -0.02), xyz([u0 - 0.069, _Z], 0.09, 0.014), white),
    ]
    soups = [join(parts).translate([0.0, 0.0, -_X]).rotated(0.75)]
    for quarter, half, distance in ((0, _X, _Z), (1, _Z, _X), (2, _X, _Z)):
        strip = boxes([-half, -0.02, -0.02], [half, 0.088, 0.012], white)
        soups.append(strip.translate([0.0, 0.0, -distance]).rotated(0.25 * quarter))
    return join(soups)


def _floor(stage: Stage, seed: int) -> None:
    white = (1.0, 1.0, 1.0, 1.0)
    boards = stage.material(white, textures.planks(seed))
    x, z = _X + 0.1, _Z + 0.1
    corners = np.array([[-x, 0.0, z], [x, 0.0, z], [x, 0.0, -z], [-x, 0.0, -z]])
    # The texture shows eight boards, 1.2 m by 1.2 m.
    stage.once(textured([corners], boards, corners[:, [0, 2]] * [1.0, -1.0] / 1.2), "floor")
    cloth = stage.material(white, textures.checks(((214.0, 202.0, 178.0), (176.0, 108.0, 78.0), (92.0, 74.0, 70.0))))
    rug = boxes([-2.75, 0.0, -0.6], [-0.75, 0.012, 1.1], "fabric_rust", without="-y +y")
    top = textured([[[-2.75, 0.012, 1.1], [-0.75, 0.012, 1.1], [-0.75, 0.012, -0.6], [-2.75, 0.012, -0.6]]], cloth)
    stage.once(join([rug, top]), "rug")
    for number, (width, height, u, v) in enumerate(((0.95, 0.65, -0.75, 1.55), (0.5, 0.65, 0.25, 1.55))):
        canvas = stage.material(white, textures.painting(seed, number))
        picture = furnishings.picture(width, height, canvas).translate([u, v, -0.004 - _X])
        stage.once(picture.rotated(0.25), f"picture_{number}")


def _furnish(stage: Stage, seed: int, detail: int) -> None:
    x, z = _TABLE
    for name, soup, transform in (
        ("table", furnishings.table(detail), placements(x, 0.0, z)),
        ("crockery", furnishings.crockery(seed, detail), placements(x, 0.76, z)),
        ("sofa", furnishings.sofa(detail), placements(-2.55, 0.0, 0.25, 0.25)),
        ("shelf", furnishings.shelf(seed, detail), placements(_X - 0.19, 0.0, -0.75, 0.75)),
        ("lamp", furnishings.floor_lamp(detail), placements(-2.75, 0.0, -1.5)),
        ("pendant", furnishings.pendant(detail), placements(x, _HIGH, z)),
        ("plant", furnishings.plant(seed, detail), placements(2.75, 0.0, -2.15)),
    ):
        stage.many(soup, transform, [name])
    curtains = placements([-2.72, -0.48, 0.48, 2.72], 0.0, 0.1 - _Z)
    stage.many(furnishings.curtain(0.46, 2.43, detail), curtains, "curtain")


def _garden(stage: Stage, seed: int, detail: int) -> None:
    """A lawn around the house with trees, a hedge and neighbours."""
    random = RandomStream(seed, 80)
    lines = np.linspace(-400.0, 400.0, 33)
    gx, gz = np.meshgrid(lines, lines)
    stage.once(quads(sheet(xyz(gx, -0.35, gz)), "lawn"), "lawn")
    x, z = random.uniform(14, -28.0, 28.0), random.uniform(14, -34.0, -10.0)
    for variant in range(2):
        trees = np.arange(variant, 14, 2)
        transforms = placements(x[trees], -0.35, z[trees], random.uniform(7), random.uniform(7, 0.6, 1.1))
        stage.many(vegetation.broadleaf(seed, 3 * variant, detail), transforms, [f"tree_{k}" for k in trees])
    x = np.arange(-12.0, 12.1, 0.9)
    stage.many(vegetation.shrub(seed, 0, detail), placements(x, -0.35, -8.0, random.uniform(len(x)), 1.2), "hedge")
    for number in range(5):
        soup = building(Kind(150 + 10 * number, 130, 0, 3, number), seed, detail)
        transform = placements(-44.0 + 22.0 * number, -0.35, -48.0 + 2.0 * random.number(), 0.0)
        stage.many(soup, transform, [f"house_{number}"])
