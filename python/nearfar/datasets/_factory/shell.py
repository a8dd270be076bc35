"""The closed shell of the hall: floor with lanes, walls with high windows and gates, saw-tooth roof with glazing."""

from __future__ import annotations

import itertools

import numpy as np
from numpy.typing import NDArray

from nearfar.datasets import _facade as facade, _textures as textures
from nearfar.datasets._factory import parts, plan
from nearfar.datasets._random import Floats, xyz
from nearfar.datasets._shapes import Soup, bars, boxes, join, loft, quads, sheet, textured, triangles
from nearfar.datasets._stage import Stage, placements

_LINE = 0.12
"""Width of the painted lines beside lanes, metres."""
_FOOT = -0.1
"""Lower end of the walls: below the floor, because the floor extends beyond the walls."""
_SILL, _HEAD = 6.8, 10.0
"""Lower and upper end of the row of windows."""


def build(stage: Stage, seed: int, detail: int) -> None:
    """Add floor, walls, windows, roof and gates."""
    _floor(stage, seed)
    for quarter, name in enumerate(("wall_north", "wall_west", "wall_south", "wall_east")):
        half, distance = (plan.X, plan.Z) if quarter % 2 == 0 else (plan.Z, plan.X)
        stage.once(_wall(half, detail).translate([0.0, 0.0, -distance]).rotated(0.25 * quarter), name)
        stage.once(
            _glazing(half, detail).translate([0.0, 0.0, -distance]).rotated(0.25 * quarter), f"windows_{quarter}"
        )
    stage.once(join([_slopes(), _gables()]), "roof")
    stage.once(_roof_windows(detail), "skylights")
    stage.once(_rafters(detail), "rafters")
    _gates(stage, detail)


def _in_lanes(middles: Floats, margin: float) -> NDArray[np.bool_]:
    """Whether points (K, 3) of the floor are inside lanes, which are widened by a margin on both sides."""
    inside = np.zeros(len(middles), bool)
    for axis, lanes in ((0, plan.LANES_X), (2, plan.LANES_Z)):
        for middle, half in lanes:
            inside |= np.abs(middles[:, axis] - middle) < half + margin
    return inside


def _floor(stage: Stage, seed: int) -> None:
    """One sheet with three materials: concrete, lane, and lane line."""
    white = (1.0, 1.0, 1.0, 1.0)
    kinds = [stage.material(white, make(seed)) for make in (textures.concrete, textures.lane_line, textures.lane)]
    x = plan.breaks(plan.X + 0.5, plan.LANES_X, _LINE)
    z = plan.breaks(plan.Z + 0.5, plan.LANES_Z, _LINE)
    gx, gz = np.meshgrid(x, z)
    cells = sheet(np.stack([gx, np.zeros_like(gx), gz], -1)).reshape(-1, 4, 3)
    middles = 0.5 * (cells[:, 0] + cells[:, 2])
    materials = np.array(kinds, np.int32)[_in_lanes(middles, _LINE).astype(int) + _in_lanes(middles, 0.0)]
    # The texture of concrete shows 10 m by 10 m.
    stage.once(textured(cells, materials, cells[..., [0, 2]] * [0.1, -0.1]), "floor")


def _bay_edges(half: float) -> Floats:
    """Limits between bays of a wall from −half to half, metres."""
    return np.linspace(-half, half, round(2.0 * half / plan.BAY) + 1)


def _wall(half: float, detail: int) -> Soup:
    """A wall in the plane z = 0 that looks towards +z: plinth, cladding with ribs, posts."""
    u = _bay_edges(half)
    post_u = u[1:-1]
    # Gates stand at the ends of lanes; the posts there begin above them.
    feet = np.where(np.isin(np.abs(post_u), (0.0, 20.0, 40.0)), 5.7, -0.02)
    post_ends = xyz(post_u - 0.15, feet, -0.05), xyz(post_u + 0.15, plan.EAVES - 0.1, 0.27)
    soups = [
        facade.plain(facade.rectangles(u, [_FOOT, 1.2]), "concrete"),
        facade.plain(facade.rectangles(u, [1.2, _SILL]), "panel_white"),
        facade.plain(facade.rectangles(u, [_HEAD, plan.EAVES]), "panel_white"),
        boxes(*post_ends, "steel_blue"),
        boxes([-half, 1.14, -0.05], [half, 1.26, 0.09], "steel_grey"),
    ]
    if detail >= 1:
        step = (1.0, 1.0, 0.5, 0.25)[detail]
        rib_u = np.arange(-half + step, half - 0.5 * step, step) - 0.06 * step
        for low, high in ((1.25, _SILL - 0.1), (_HEAD + 0.1, plan.EAVES - 0.02)):
            size = [0.12 * step + 0.03, high - low, 0.06]
            soups.append(bars(xyz(rib_u, low, -0.02), size, "paint_snow", without="-z -y +y"))
    return join(soups)


def _glazing(half: float, detail: int) -> Soup:
    """The row of windows, with bars from detail 1 on."""
    cells = facade.rectangles(_bay_edges(half), [_SILL, _HEAD])
    holes = cells + np.array([0.5, -0.5, 0.15, -0.15])
    soups = [facade.openings(cells, holes, 0.15, "panel_white", "trim_white", "daylight")]
    if detail >= 1:
        soups.append(facade.bars(holes, 0.15, "", "metal_dark", frame=True))
        soups.append(boxes([-half, 8.36, -0.17], [half, 8.44, -0.11], "metal_dark", without="-x +x -z"))
        for fraction in np.linspace(0.0, 1.0, (1, 3, 5, 7)[detail])[1:-1].tolist():
            u = holes[:, 0] + fraction * (holes[:, 1] - holes[:, 0])
            low = xyz(u - 0.03, holes[:, 2] - 0.02, -0.17)
            soups.append(bars(low, [0.06, _HEAD - _SILL - 0.26, 0.07], "metal_dark", without="-z"))
    return join(soups)


def _slopes() -> Soup:
    """The slopes of the saw-tooth roof, seen from below."""
    corners = [
        [[x0, plan.RIDGE, z0], [x1, plan.EAVES, z0], [x1, plan.EAVES, z1], [x0, plan.RIDGE, z1]]
        for x0, x1 in itertools.pairwise(_bay_edges(plan.X))
        for z0, z1 in itertools.pairwise(_bay_edges(plan.Z))
    ]
    return quads(corners, "daylight")


def _roof_windows(detail: int) -> Soup:
    """The vertical windows of the saw teeth with their bars; the inner side faces +x."""
    xs, steel = _bay_edges(plan.X)[:-1].tolist(), "steel_grey"
    panes = [
        [[x, plan.EAVES, z1], [x, plan.EAVES, z0], [x, plan.RIDGE, z0], [x, plan.RIDGE, z1]]
        for x in xs
        for z0, z1 in itertools.pairwise(_bay_edges(plan.Z))
    ]
    step = (20.0, 10.0, 2.0, 2.0)[detail]
    posts = [[x - 0.02, plan.EAVES + 0.02, z] for x in xs for z in np.arange(-60.04, 60.0, step).tolist()]
    rails = [[x - 0.02, height, -plan.Z] for x in xs for height in (12.0, 12.96, 13.8)]
    frames = bars(posts, [0.08, plan.RIDGE - plan.EAVES - 0.1, 0.08], steel)
    return join([quads(panes, "daylight"), frames, bars(rails, [0.12, 0.09, 2.0 * plan.Z], steel)])


def _gables() -> Soup:
    """The triangles of wall between the eaves and the saw teeth, on both long sides."""
    corners = []
    for x0, x1 in itertools.pairwise(_bay_edges(plan.X)):
        low, far, top = (x0, plan.EAVES), (x1, plan.EAVES), (x0, plan.RIDGE)
        corners.append([(*low, -plan.Z), (*far, -plan.Z), (*top, -plan.Z)])
        corners.append([(*low, plan.Z), (*top, plan.Z), (*far, plan.Z)])
    return triangles(corners, "panel_white")


def _rafters(detail: int) -> Soup:
    """Bars under the slopes, and the gutters between the saw teeth."""
    x, grey = _bay_edges(plan.X), "steel_grey"
    soups = [bars(xyz(x[1:-1] - 0.2, 11.6, -plan.Z - 0.05), [0.4, 0.36, 2.0 * plan.Z + 0.1], grey)]
    step = (10.0, 5.0, 5.0, 2.5)[detail]
    drop = (plan.RIDGE - plan.EAVES) / plan.BAY
    ends = [(end, plan.RIDGE - drop * end) for end in (0.2, plan.BAY - 0.25)]
    corners = ((-0.02, -0.05), (-0.02, 0.05), (-0.24, 0.05), (-0.24, -0.05))
    for z in np.arange(-plan.Z + step, plan.Z - 0.1, step).tolist():
        sections = [[[end, y + dy, z + dz] for dy, dz in corners] for end, y in ends]
        soups.append(loft(sections, "steel_blue").copies(xyz(x[:-1], 0.0, 0.0)))
    return join(soups)


def _gates(stage: Stage, detail: int) -> None:
    """Roller gates at the ends of lanes, and small doors beside some of them."""
    stripes = stage.material((1.0, 1.0, 1.0, 1.0), textures.stripes())
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
    leaf = parts.slats([-2.3, 0.02, -0.03], [4.6, 0.92 * step, 0.15], [0.0, step, 0.0], count, "steel_grey")
    back = boxes([-2.28, 0.01, -0.02], [2.28, 5.03, 0.1], "metal")
    posts = bars([[-2.55, -0.02, -0.05], [2.25, -0.02, -0.05]], [0.3, 5.1, 0.4], "metal_dark")
    hood = parts.casing([-2.7, 5.0, -0.05], [2.7, 5.6, 0.55], 0.08, "steel_grey", detail)
    face = [[[-0.16, 0.0, 0.36], [0.16, 0.0, 0.36], [0.16, 1.6, 0.36], [-0.16, 1.6, 0.36]]]
    guard = textured(face, stripes, [[0.0, 0.0], [0.5, 0.0], [0.5, 2.5], [0.0, 2.5]])
    return join([leaf, back, posts, hood, guard.copies([[-2.4, 0.0, 0.0], [2.4, 0.0, 0.0]])])


def _door(detail: int) -> Soup:
    """A small door with its frame and a green sign above."""
    leaf = boxes([-0.55, 0.02, -0.03], [0.55, 2.1, 0.05], "door_blue")
    lows = [[-0.65, -0.02, -0.04], [0.55, -0.02, -0.04], [-0.55, 2.1, -0.04]]
    sizes = [[0.1, 2.22, 0.12], [0.1, 2.22, 0.12], [1.1, 0.1, 0.11]]
    sign = boxes([-0.3, 2.4, -0.03], [0.3, 2.62, 0.08], "sign_green")
    handle = parts.rod((0.42, 1.05, 0.09), (0.25, 1.05, 0.09), 0.014, "metal_light", detail)
    return join([leaf, bars(lows, sizes, "metal_dark"), sign, handle])
