"""The closed shell of the hall: floor with lanes, walls with high windows and gates, saw-tooth roof with glazing."""

from __future__ import annotations

import itertools

import numpy as np
from numpy.typing import NDArray

from nearfar.datasets import _facade as facade
from nearfar.datasets._draw import Floats
from nearfar.datasets._factory import parts, plan, surfaces
from nearfar.datasets._palette import material
from nearfar.datasets._shapes import Soup, bars, boxes, join, loft, quads, sheet, textured, triangles
from nearfar.datasets._stage import Stage, placements

_LINE = 0.12
"""Width of the painted lines beside lanes, metres."""
_FOOT = -0.1
"""Lower end of the walls, below the floor, which reaches beyond them."""
_SILL, _HEAD = 6.8, 10.0
"""Lower and upper end of the row of windows."""


def build(stage: Stage, seed: int, detail: int) -> None:
    """Add floor, walls, windows, roof and gates."""
    _floor(stage, seed)
    for quarter, name in enumerate(("wall_north", "wall_west", "wall_south", "wall_east")):
        half, away = (plan.X, plan.Z) if quarter % 2 == 0 else (plan.Z, plan.X)
        stage.once(_wall(half, detail).translate([0.0, 0.0, -away]).rotated(0.25 * quarter), name)
        stage.once(_glazing(half, detail).translate([0.0, 0.0, -away]).rotated(0.25 * quarter), f"windows_{quarter}")
    stage.once(join([_slopes(), _gables()]), "roof")
    stage.once(_roof_windows(detail), "skylights")
    stage.once(_rafters(detail), "rafters")
    _gates(stage, detail)


def _in_lanes(at: Floats, lanes: tuple[tuple[float, float], ...], more: float) -> NDArray[np.bool_]:
    """Flags of positions inside lanes that are widened on both sides."""
    inside = np.zeros(at.shape, bool)
    for middle, half in lanes:
        inside |= np.abs(at - middle) < half + more
    return inside


def _floor(stage: Stage, seed: int) -> None:
    """One sheet in concrete, lanes and their yellow lines."""
    white = (1.0, 1.0, 1.0, 1.0)
    kinds = [stage.material(white, make(seed)) for make in (surfaces.concrete, surfaces.line, surfaces.lane)]
    x = plan.breaks(plan.X + 0.5, plan.LANES_X, _LINE)
    z = plan.breaks(plan.Z + 0.5, plan.LANES_Z, _LINE)
    gx, gz = np.meshgrid(x, z)
    cells = sheet(np.stack([gx, np.zeros_like(gx), gz], -1)).reshape(-1, 4, 3)
    middle = 0.5 * (cells[:, 0] + cells[:, 2])
    lane = _in_lanes(middle[:, 0], plan.LANES_X, 0.0) | _in_lanes(middle[:, 2], plan.LANES_Z, 0.0)
    wide = _in_lanes(middle[:, 0], plan.LANES_X, _LINE) | _in_lanes(middle[:, 2], plan.LANES_Z, _LINE)
    chosen = np.array(kinds, np.int32)[np.where(lane, 2, np.where(wide, 1, 0))]
    # The texture of concrete shows 10 m by 10 m.
    stage.once(textured(cells, chosen, cells[..., [0, 2]] * [0.1, -0.1]), "floor")


def _cells(half: float) -> Floats:
    return np.linspace(-half, half, round(2.0 * half / plan.BAY) + 1)


def _wall(half: float, detail: int) -> Soup:
    """A wall in the plane z = 0 that looks towards +z: plinth, cladding with ribs, posts."""
    u = _cells(half)
    low = facade.plain(facade.rectangles(u, [_FOOT, 1.2]), material("concrete"))
    mid = facade.plain(facade.rectangles(u, [1.2, _SILL]), material("panel_white"))
    top = facade.plain(facade.rectangles(u, [_HEAD, plan.EAVES]), material("panel_white"))
    soups = [low, mid, top]
    # Gates stand at the ends of lanes; the posts there begin above them.
    feet = [5.7 if abs(at) in (0.0, 20.0, 40.0) else -0.02 for at in u[1:-1].tolist()]
    low_post = np.stack([u[1:-1] - 0.15, feet, np.full(len(feet), -0.05)], -1)
    high_post = np.stack([u[1:-1] + 0.15, np.full(len(feet), plan.EAVES - 0.1), np.full(len(feet), 0.27)], -1)
    soups.append(boxes(low_post, high_post, material("steel_blue")))
    ledge = boxes([-half, 1.14, -0.05], [half, 1.26, 0.09], material("steel_grey"))
    soups.append(ledge)
    if detail >= 1:
        step = (1.0, 1.0, 0.5, 0.25)[detail]
        at = np.arange(-half + step, half - 0.5 * step, step)
        for low_end, high_end in ((1.25, _SILL - 0.1), (_HEAD + 0.1, plan.EAVES - 0.02)):
            ends = np.stack([at - 0.06 * step, np.full_like(at, low_end), np.full_like(at, -0.02)], -1)
            rib = [0.12 * step + 0.03, high_end - low_end, 0.06]
            soups.append(bars(ends, rib, material("paint_snow"), without="-z -y +y"))
    return join(soups)


def _glazing(half: float, detail: int) -> Soup:
    """The row of windows, with bars from detail 1 on."""
    cells = facade.rectangles(_cells(half), [_SILL, _HEAD])
    holes = cells + np.array([0.5, -0.5, 0.15, -0.15])
    steel = material("metal_dark")
    soups = [facade.openings(cells, holes, 0.15, material("panel_white"), material("trim_white"), material("daylight"))]
    if detail >= 1:
        soups.append(facade.bars(holes, 0.15, "", steel, frame=True))
        soups.append(boxes([-half, 8.36, -0.17], [half, 8.44, -0.11], steel, without="-x +x -z"))
        shares = np.linspace(0.0, 1.0, (1, 3, 5, 7)[detail])[1:-1]
        for share in shares.tolist():
            u = holes[:, 0] + share * (holes[:, 1] - holes[:, 0])
            low = np.stack([u - 0.03, holes[:, 2] - 0.02, np.full_like(u, -0.17)], -1)
            soups.append(bars(low, [0.06, _HEAD - _SILL - 0.26, 0.07], steel, without="-z"))
    return join(soups)


def _slopes() -> Soup:
    """The slopes of the saw-tooth roof, seen from below."""
    x, z = _cells(plan.X), _cells(plan.Z)
    corners = []
    for x0, x1 in itertools.pairwise(x):
        corners += [[[x0, plan.RIDGE, z0], [x1, plan.EAVES, z0], [x1, plan.EAVES, z1], [x0, plan.RIDGE, z1]]
                    for z0, z1 in itertools.pairwise(z)]  # fmt: skip
    return quads(corners, material("daylight"))


def _roof_windows(detail: int) -> Soup:
    """The upright glazing of the saw teeth, which looks towards +x inside, with its bars."""
    x, z = _cells(plan.X)[:-1], _cells(plan.Z)
    panes = [
        [[at, plan.EAVES, z1], [at, plan.EAVES, z0], [at, plan.RIDGE, z0], [at, plan.RIDGE, z1]]
        for at in x.tolist()
        for z0, z1 in itertools.pairwise(z)
    ]
    step = (20.0, 10.0, 2.0, 2.0)[detail]
    posts = [[at - 0.02, plan.EAVES + 0.02, z0] for at in x.tolist() for z0 in np.arange(-60.04, 60.0, step).tolist()]
    steel = material("steel_grey")
    rails = [[at - 0.02, height, -plan.Z] for at in x.tolist() for height in (12.0, 12.96, 13.8)]
    return join(
        [
            quads(panes, material("daylight")),
            bars(posts, [0.08, plan.RIDGE - plan.EAVES - 0.1, 0.08], steel),
            bars(rails, [0.12, 0.09, 2.0 * plan.Z], steel),
        ]
    )


def _gables() -> Soup:
    """The triangles of wall between the eaves and the saw teeth, on both long sides."""
    x = _cells(plan.X)
    corners = []
    for x0, x1 in itertools.pairwise(x):
        low, far, top = [x0, plan.EAVES, -plan.Z], [x1, plan.EAVES, -plan.Z], [x0, plan.RIDGE, -plan.Z]
        corners.append([low, far, top])
        corners.append([[at[0], at[1], plan.Z] for at in (low, top, far)])
    return triangles(corners, material("panel_white"))


def _rafters(detail: int) -> Soup:
    """Bars under the slopes, and the gutters between the saw teeth."""
    x = _cells(plan.X)
    gutters = bars([[at - 0.2, 11.6, -plan.Z - 0.05] for at in x[1:-1].tolist()], [0.4, 0.36, 2.0 * plan.Z + 0.1],
                   material("steel_grey"))  # fmt: skip
    soups = [gutters]
    step = (10.0, 5.0, 5.0, 2.5)[detail]
    drop = (plan.RIDGE - plan.EAVES) / plan.BAY
    high, low = 0.2, plan.BAY - 0.25
    section = np.array([[high, plan.RIDGE - drop * high], [low, plan.RIDGE - drop * low]])
    for at in np.arange(-plan.Z + step, plan.Z - 0.1, step).tolist():
        ends = [
            [[a, b - 0.02, at - 0.05], [a, b - 0.02, at + 0.05], [a, b - 0.24, at + 0.05], [a, b - 0.24, at - 0.05]]
            for a, b in section.tolist()
        ]
        soups.append(parts.copies(loft(ends, material("steel_blue")), [[a, 0.0, 0.0] for a in x[:-1].tolist()]))
    return join(soups)


def _gates(stage: Stage, detail: int) -> None:
    """Roller gates at the ends of lanes, and small doors beside some of them."""
    stripes = stage.material((1.0, 1.0, 1.0, 1.0), surfaces.stripes())
    ends = [(-plan.X, z, 0.25) for z in (-40.0, 0.0, 40.0)] + [(plan.X, z, 0.75) for z in (-20.0, 0.0, 40.0)]
    ends += [(-40.0, plan.Z, 0.5), (0.0, plan.Z, 0.5), (40.0, plan.Z, 0.5)]
    x, z, turns = np.array(ends).T
    stage.many(_gate(stripes, detail), placements(x, 0.0, z, turns), "gate")
    doors = [(-plan.X, 6.5, 0.25), (plan.X, -6.5, 0.75), (-33.0, plan.Z, 0.5), (8.0, plan.Z, 0.5), (6.5, -plan.Z, 0.0)]
    x, z, turns = np.array(doors).T
    stage.many(_door(detail), placements(x, 0.0, z, turns), "door")


def _gate(stripes: int, detail: int) -> Soup:
    """A roller gate 4.6 m wide and 5 m high, in front of the wall z = 0."""
    count = (8, 12, 25, 50)[detail]
    step = 5.0 / count
    leaf = parts.slats([-2.3, 0.02, -0.03], [4.6, 0.92 * step, 0.15], [0.0, step, 0.0], count, material("steel_grey"))
    back = boxes([-2.28, 0.01, -0.02], [2.28, 5.03, 0.1], material("metal"))
    posts = bars([[-2.55, -0.02, -0.05], [2.25, -0.02, -0.05]], [0.3, 5.1, 0.4], material("metal_dark"))
    hood = parts.casing([-2.7, 5.0, -0.05], [2.7, 5.6, 0.55], 0.08, material("steel_grey"), detail)
    guards = []
    for at in (-2.4, 2.4):
        x0, x1, z = at - 0.16, at + 0.16, 0.36
        face = [[[x0, 0.0, z], [x1, 0.0, z], [x1, 1.6, z], [x0, 1.6, z]]]
        guards.append(textured(face, stripes, [[0.0, 0.0], [0.5, 0.0], [0.5, 2.5], [0.0, 2.5]]))
    return join([leaf, back, posts, hood, *guards])


def _door(detail: int) -> Soup:
    """A small door with its frame and a green sign above."""
    leaf = boxes([-0.55, 0.02, -0.03], [0.55, 2.1, 0.05], material("door_blue"))
    lows = [[-0.65, -0.02, -0.04], [0.55, -0.02, -0.04], [-0.55, 2.1, -0.04]]
    sizes = [[0.1, 2.22, 0.12], [0.1, 2.22, 0.12], [1.1, 0.1, 0.11]]
    sign = boxes([-0.3, 2.4, -0.03], [0.3, 2.62, 0.08], material("sign_green"))
    handle = parts.rod((0.42, 1.05, 0.09), (0.25, 1.05, 0.09), 0.014, material("metal_light"), detail)
    return join([leaf, bars(lows, sizes, material("metal_dark")), sign, handle])
