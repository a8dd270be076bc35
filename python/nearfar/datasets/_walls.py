"""One façade of a building tier: storeys of windows over a ground floor of shops, doors or more windows."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nearfar.datasets import _facade as facade
from nearfar.datasets._facade import Rectangles, Window
from nearfar.datasets._palette import material, materials
from nearfar.datasets._random import Floats, RandomStream
from nearfar.datasets._shapes import Soup, boxes, join
from nearfar.datasets._styles import Style

_GLASS = materials(
    "glass_dark", "glass_dark", "glass_blue", "glass_dark", "curtain", "glass_blue", "glass_green", "glass_dark",
    "glass_blue", "glass_dark", "curtain", "glass_blue", "glass_dark", "lamp_lit",
)  # fmt: skip
_SHINY = materials("glass_sky", "glass_sky", "glass_pale", "glass_sky", "glass_steel", "glass_sky", "glass_steel")
_SHOPS = materials("shop_glass", "shop_glass", "shop_warm", "glass_dark")
_DOORS = materials("door_green", "door_red", "door_blue", "door_wood", "trim_dark")
_SIGNS = materials("sign_red", "sign_teal", "sign_mustard", "sign_navy", "sign_green", "trim_dark")
_AWNINGS = materials("sign_red", "awning_cream", "sign_green", "sign_navy", "awning_cream")
_SHUTTERS = materials("shutter_green", "shutter_blue", "door_wood")

_SHOP = Window(0.84, 0.35, 0.8, 0.3, "|")
_DOOR = Window(0.0, 0.05, 0.0, 0.4, "")


@dataclass(frozen=True)
class Paint:
    """Numbers of the materials chosen for one building."""

    wall: int
    trim: int
    frame: int
    base: int
    shutter: int
    shiny: bool

    @classmethod
    def pick(cls, style: Style, random: RandomStream) -> Paint:
        """Choose the colours of a style."""
        wall, trim, frame = (material(random.pick(names)) for names in (style.walls, style.trims, style.frames))
        base = trim if random.chance(0.45) else wall
        return cls(wall, trim, frame, base, random.pick(_SHUTTERS), "glass" in "".join(style.walls) or style.bay < 2.0)


@dataclass(frozen=True)
class Plan:
    """Layout of one façade."""

    width: float
    rows: Floats
    """Heights of the storeys' edges in metres, from below the ground to the top of the strip under the roof."""
    face: str
    """"street", "yard" or "party" (against a neighbour)."""
    shops: bool
    on_ground: bool


def walls(
    size: tuple[float, float], rows: Floats, faces: tuple[Sequence[str], bool, bool], style: Style, paint: Paint,
    random: RandomStream, detail: int,
) -> list[Soup]:  # fmt: skip
    """Build the four façades of a block, from the front counter-clockwise; at detail 0 one box.

    `size` is the block's width and depth. `faces` has `Plan.face` of each façade, then `Plan.shops` and
    `Plan.on_ground`, which are the same for all four.
    """
    kinds, shops, on_ground = faces
    if detail == 0:
        x, z = 0.5 * size[0], 0.5 * size[1]
        return [boxes([-x, rows[0], -z], [x, rows[-1], z], paint.wall, without="-y +y")]
    sides = []
    for quarter, kind in enumerate(kinds):
        width, depth = size if quarter % 2 == 0 else size[::-1]
        side = _wall(Plan(width, rows, kind, shops, on_ground), style, paint, random, detail)
        sides.append(side.translate([0.0, 0.0, 0.5 * depth]).rotated(0.25 * quarter))
    return sides


def _wall(plan: Plan, style: Style, paint: Paint, random: RandomStream, detail: int) -> Soup:
    """Build the façade in its own plane, u from −width/2 to width/2."""
    half, rows = 0.5 * plan.width, plan.rows
    if plan.face == "party":
        return facade.plain(facade.rectangles([-half, half], rows), paint.wall)
    count = max(1, round((plan.width - 2.0 * style.pier) / style.bay))
    inner = np.linspace(-half + style.pier, half - style.pier, count + 1)
    blank_parts = ([-half, inner[0]], rows), ([inner[-1], half], rows), (inner, rows[-2:])
    soups = [facade.plain(np.concatenate([facade.rectangles(u, v) for u, v in blank_parts]), paint.wall)]
    upper = facade.rectangles(inner, rows[1 if plan.on_ground else 0 : -1])
    soups += _upper_storeys(upper, count, plan, style, paint, random, detail)
    if plan.on_ground:
        # Floors are at v = 0; the wall below is hidden in the ground.
        soups += _ground_storey(facade.rectangles(inner, rows[:2]), plan, style, paint, random, detail)
    if detail >= 2:
        soups += _bands(inner, plan, style, paint)
    return join(soups)


def _upper_storeys(
    cells: Rectangles, count: int, plan: Plan, style: Style, paint: Paint, random: RandomStream, detail: int
) -> list[Soup]:
    if not len(cells):
        return []
    holes, window = facade.holes_in(cells, style.window), style.window
    is_street, has_balcony = plan.face == "street", np.zeros(len(cells), bool)
    if style.balcony and is_street:
        storey, column = np.divmod(np.arange(len(cells)), count)
        has_balcony = _balcony_cells(column, storey, count, len(cells) // count, random)
        holes[has_balcony, 2] = cells[has_balcony, 2] + 0.1
    panes = _panes(paint, random, len(cells))
    soups = [facade.openings(cells, holes, window.reveal, paint.wall, paint.wall, panes, recessed=detail >= 2)]
    if detail < 2:
        return soups
    if not paint.shiny and is_street:
        soups.append(facade.bars(holes, window.reveal, window.bars, paint.frame, frame=detail >= 3))
    if style.sill and (is_street or detail >= 3):
        soups.append(facade.sills(holes[~has_balcony], paint.trim))
    if style.lintel and (is_street or detail >= 3):
        soups.append(facade.lintels(holes, paint.trim))
    if style.shutters and is_street:
        soups.append(facade.shutters(holes, paint.shutter))
    if has_balcony.any():
        solid = style.balcony == "solid"
        rail = paint.trim if solid else "iron"
        soups.append(facade.balconies(cells[has_balcony], paint.trim, rail, detail=detail, solid=solid))
    return soups


def _panes(paint: Paint, random: RandomStream, count: int) -> NDArray[np.int32]:
    """Random materials of windows."""
    glass = np.array(_SHINY if paint.shiny else _GLASS, np.int32)
    return glass[random.integers(count, len(glass))]


def _balcony_cells(
    column: NDArray[np.int64], storey: NDArray[np.int64], count: int, storeys: int, random: RandomStream
) -> NDArray[np.bool_]:
    """Choose cells for balconies: in two columns of windows, symmetric about the middle, or on one storey."""
    mirrored = np.minimum(column, count - 1 - column)
    if random.chance(0.3):
        return np.asarray(storey == (0 if random.chance(0.6) else max(0, storeys - 2)))
    chosen_column = int(random.integers(1, max(1, (count + 1) // 2))[0])
    return np.asarray((mirrored == chosen_column) & (storey < storeys - (1 if storeys > 3 else 0)))


def _ground_storey(
    cells: Rectangles, plan: Plan, style: Style, paint: Paint, random: RandomStream, detail: int
) -> list[Soup]:
    count = len(cells)
    door = np.arange(count) == int(random.integers(1, count)[0])
    shop = ~door & (plan.shops and plan.face == "street")
    holes = facade.holes_in(cells, style.window)
    # Sills and heads are measured from the floor, not from the wall's hidden foot.
    height = cells[:, 3]
    holes[:, 2], holes[:, 3] = style.window.sill + 0.25, style.window.head * height - 0.15
    middle = 0.5 * (cells[:, 0] + cells[:, 1])
    span = cells[:, 1] - cells[:, 0]
    half = np.minimum(0.42 * span, np.where(shop, 0.5 * _SHOP.width * span, 0.62))
    is_wide = shop | door
    holes[is_wide, 0], holes[is_wide, 1] = (middle - half)[is_wide], (middle + half)[is_wide]
    holes[shop, 2], holes[shop, 3] = _SHOP.sill, _SHOP.head * height[shop]
    holes[door, 2], holes[door, 3] = _DOOR.sill, np.minimum(2.55, 0.8 * height[door])
    reveal = np.where(door, _DOOR.reveal, np.where(shop, _SHOP.reveal, style.window.reveal))
    panes = _panes(paint, random, count)
    panes[shop] = np.array(_SHOPS, np.int32)[random.integers(count, len(_SHOPS))][shop]
    panes[door] = random.pick(_DOORS)
    outside = paint.base if plan.face == "street" else paint.wall
    soups = [facade.openings(cells, holes, reveal, outside, paint.trim, panes, recessed=detail >= 2)]
    if detail < 2:
        return soups
    if shop.any():
        soups.append(facade.bars(holes[shop], _SHOP.reveal, _SHOP.bars, paint.frame))
        soups += _shop_signs(cells[shop], random)
    windows = holes[~is_wide]
    if len(windows) and not paint.shiny and plan.face == "street":
        soups.append(facade.bars(windows, style.window.reveal, style.window.bars, paint.frame))
        soups.append(facade.sills(windows, paint.trim))
    soups.append(_doorstep(holes[door][0], paint, random))
    return soups


def _shop_signs(cells: Rectangles, random: RandomStream) -> list[Soup]:
    """Fascia boards, some with an awning below."""
    soups = []
    kinds = random.integers(len(cells), 3)
    sign, cloth = random.pick(_SIGNS), random.pick(_AWNINGS)
    for cell, kind in zip(cells, kinds, strict=True):
        u0, u1, v1 = cell[0] + 0.06, cell[1] - 0.06, cell[3]
        soups.append(boxes([u0, 0.82 * v1, -0.05], [u1, 0.82 * v1 + 0.5, 0.12], sign, without="-z"))
        if kind == 0:
            soups.append(facade.awning(np.array([cell[0], cell[1], cell[2], 0.88 * v1]), cloth))
    return soups


def _doorstep(hole: NDArray[np.float64], paint: Paint, random: RandomStream) -> Soup:
    """A doorstep, a frame around the door, and a roof over it."""
    u0, u1, top = float(hole[0]), float(hole[1]), float(hole[3])
    parts = [
        boxes([u0 - 0.2, -0.1, -0.05], [u1 + 0.2, 0.06, 0.35], paint.trim, without="-z -y"),
        boxes([u0 - 0.16, -0.1, -0.05], [u0 + 0.02, top + 0.02, 0.08], paint.trim, without="-z -y"),
        boxes([u1 - 0.02, -0.1, -0.05], [u1 + 0.16, top + 0.02, 0.08], paint.trim, without="-z -y"),
        boxes([u0 - 0.2, top - 0.02, -0.05], [u1 + 0.2, top + 0.2, 0.14], paint.trim, without="-z"),
    ]
    if random.chance(0.4):
        parts.append(boxes([u0 - 0.5, top + 0.26, -0.05], [u1 + 0.5, top + 0.36, 1.1], "trim_dark", without="-z"))
    return join(parts)


def _bands(inner: Floats, plan: Plan, style: Style, paint: Paint) -> list[Soup]:
    rows, half = plan.rows, 0.5 * plan.width
    every = style.course_every
    # A style without bands still gets one at the top of the ground floor.
    heights = rows[1:-2:every] if every else rows[1:2] if plan.on_ground else rows[:0]
    soups = [facade.courses(0.02 - half, half - 0.02, heights, paint.trim, high=0.16 if every == 1 else 0.26)]
    if style.pilasters:
        wide, out = (0.09, 0.14) if paint.shiny else (0.4, 0.1)
        foot = rows[1] if plan.on_ground else rows[0]
        soups.append(facade.pilasters(inner, foot, rows[-1], paint.trim, wide=wide, out=out))
    return soups
