"""Parts of façades: rectangles of wall with openings, in a plane with u to the right, v up and n outwards."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar.datasets._palette import Material, numbers_of
from nearfar.datasets._random import Floats, xyz
from nearfar.datasets._shapes import Soup, boxes, join, quads

Rectangles = Floats  # (K, 4): least u, greatest u, least v, greatest v


@dataclass(frozen=True)
class Window:
    """Shape of the openings of a storey."""

    width: float
    """Width of the opening as a share of the bay's width."""
    sill: float
    """Height of the opening's lower edge above the floor, metres."""
    head: float
    """Upper end of the opening as a share of the storey's height."""
    reveal: float
    """Depth of the pane behind the wall, metres."""
    bars: str = "+"
    """Bars in front of the pane: "+" a post and a rail, "|" a post, "" none."""


def rectangles(u: ArrayLike, v: ArrayLike) -> Rectangles:
    """Return all cells of a grid, row by row from below."""
    us, vs = np.asarray(u, np.float64), np.asarray(v, np.float64)[:, None]
    return np.stack(np.broadcast_arrays(us[:-1], us[1:], vs[:-1], vs[1:]), -1).reshape(-1, 4)


def plain(cells: Rectangles, materials: ArrayLike) -> Soup:
    """Make cells without an opening."""
    return quads(_corners(cells, 0.0), materials)


def _corners(cells: Rectangles, n: ArrayLike) -> Floats:
    """Corners (K, 4, 3) of rectangles at depth n, counter-clockwise."""
    return xyz(cells[:, [0, 1, 1, 0]], cells[:, [2, 2, 3, 3]], np.reshape(n, (-1, 1)))


def openings(
    cells: Rectangles, holes: Rectangles, reveal: ArrayLike, wall: Material, lining: Material, panes: ArrayLike, *,
    recessed: bool = True,
) -> Soup:  # fmt: skip
    """Make cells with a hole each: the wall around it, its reveal, and a pane at its back.

    Without `recessed` the pane is flush with the wall: two triangles for the pane, eight around it.
    """
    depth = np.broadcast_to(np.asarray(reveal, np.float64), len(cells)) * (1.0 if recessed else 0.0)
    outer, inner, back = _corners(cells, 0.0), _corners(holes, 0.0), _corners(holes, -depth)
    soups = [_band(outer, inner, wall), quads(back, panes)]
    if recessed:
        soups.append(_band(inner, back, lining))
    return join(soups)


def wall_with_holes(
    cells: Rectangles, holes: Rectangles, thickness: float, inside: Material, lining: Material, outside: Material
) -> Soup:
    """A wall with a hole through each cell; its face at n = 0 has the material `inside`."""
    front, hole = _corners(cells, 0.0), _corners(holes, 0.0)
    shift = np.array([0.0, 0.0, thickness])
    back = _band(front - shift, hole - shift, outside)
    soups = [_band(front, hole, inside), _band(hole, hole - shift, lining)]
    return join([*soups, back.mapped(back.corners[:, ::-1])])


def _band(outer: Floats, inner: Floats, materials: ArrayLike) -> Soup:
    """Make the four quadrilaterals between two rectangles."""
    after = [1, 2, 3, 0]
    corners = np.stack([outer, outer[:, after], inner[:, after], inner], 2)
    return quads(corners.reshape(-1, 4, 3), np.repeat(numbers_of(materials, len(outer)), 4))


def holes_in(cells: Rectangles, window: Window) -> Rectangles:
    """The openings that a window style cuts into cells."""
    middle, half = 0.5 * (cells[:, 0] + cells[:, 1]), 0.5 * window.width * (cells[:, 1] - cells[:, 0])
    height = cells[:, 3] - cells[:, 2]
    return np.stack([middle - half, middle + half, cells[:, 2] + window.sill, cells[:, 2] + window.head * height], 1)


def bars(
    holes: Rectangles, reveal: float, kind: str, material: Material, *, frame: bool = False, hidden: str = "-z"
) -> Soup:
    """Glazing bars in front of the panes; their ends lie inside the wall. `hidden` names sides never visible."""
    if not kind and not frame:
        return join([])
    u0, u1, v0, v1 = holes.T
    middle, rail_height = 0.5 * (u0 + u1), v0 + 0.68 * (v1 - v0)
    slim, back, front = 0.03, np.full_like(u0, -reveal - 0.02), np.full_like(u0, 0.05 - reveal)
    uprights, rails = [middle] if kind else [], [rail_height] if kind == "+" else []
    if frame:
        # Half of each bar of the frame lies inside the lining.
        uprights += [u0, u1]
        rails += [v0, v1]
    parts = [
        _boxes(u - slim, u + slim, v0 - 0.04, v1 + 0.04, back, front, material, f"{hidden} -y +y") for u in uprights
    ]
    # Rails are slightly thinner than posts, so that no two faces share a plane where bars cross.
    back, front = back + 0.008, front - 0.008
    parts += [_boxes(u0 - 0.04, u1 + 0.04, v - slim, v + slim, back, front, material, f"{hidden} -x +x") for v in rails]
    return join(parts)


def _boxes(
    u0: ArrayLike, u1: ArrayLike, v0: ArrayLike, v1: ArrayLike, n0: ArrayLike, n1: ArrayLike,
    materials: ArrayLike, without: str = "",
) -> Soup:  # fmt: skip
    return boxes(xyz(u0, v0, n0), xyz(u1, v1, n1), materials, without=without)


def sills(holes: Rectangles, material: int) -> Soup:
    """Slabs under the openings, their backs inside the wall."""
    u0, u1, v0, _ = holes.T
    return _boxes(u0 - 0.1, u1 + 0.1, v0 - 0.1, v0 + 0.02, -0.06, 0.14, material, "-z")


def lintels(holes: Rectangles, material: int) -> Soup:
    """Slabs over the openings."""
    u0, u1, _, v1 = holes.T
    return _boxes(u0 - 0.14, u1 + 0.14, v1 - 0.015, v1 + 0.2, -0.06, 0.06, material, "-z")


def shutters(holes: Rectangles, material: int) -> Soup:
    """Open shutters on both sides of the openings."""
    a0, a1, b0, b1 = holes.T
    wide = 0.46 * (a1 - a0)
    left = _boxes(a0 - wide, a0 - 0.02, b0, b1, -0.03, 0.05, material, "-z")
    return join([left, _boxes(a1 + 0.02, a1 + wide, b0, b1, -0.03, 0.05, material, "-z")])


def courses(u0: float, u1: float, v: Floats, material: int, *, high: float) -> Soup:
    """Horizontal bands along the façade at heights `v`."""
    return _boxes(u0, u1, v - 0.5 * high, v + 0.5 * high, -0.05, 0.07, material, "-z")


def pilasters(u: Floats, v0: float, v1: float, material: int, *, wide: float, out: float) -> Soup:
    """Vertical bands along the façade."""
    return _boxes(u - 0.5 * wide, u + 0.5 * wide, v0, v1, -0.05, out, material, "-z -y")


def balconies(cells: Rectangles, slab: int, rail: Material, *, detail: int, solid: bool, out: float = 1.15) -> Soup:
    """Balconies in front of cells: slabs with a parapet or a railing."""
    u0, u1, v0 = cells[:, 0] + 0.12, cells[:, 1] - 0.12, cells[:, 2]
    parts = [_boxes(u0, u1, v0 - 0.16, v0 + 0.02, -0.05, out, slab, "-z")]
    if solid:
        top = v0 + 0.95
        parts.append(_boxes(u0 + 0.01, u1 - 0.01, v0 - 0.1, top, out - 0.12, out + 0.03, rail))
        for a, b in ((u0 - 0.02, u0 + 0.08), (u1 - 0.08, u1 + 0.02)):
            parts.append(_boxes(a, b, v0 - 0.1, top - 0.01, -0.05, out - 0.06, rail, "-z"))
        return join(parts)
    parts.append(_boxes(u0, u1, v0 + 0.96, v0 + 1.01, out - 0.07, out - 0.01, rail))
    for a, b in ((u0 + 0.01, u0 + 0.06), (u1 - 0.06, u1 - 0.01)):
        parts.append(_boxes(a, b, v0 + 0.955, v0 + 1.005, -0.05, out - 0.03, rail, "-z"))
    step = 0.13 if detail >= 3 else 0.42
    n = np.linspace(0.05, out - 0.12, max(2, round(out / step)))
    for left, right, v in np.stack([u0, u1, v0], 1):
        u = np.linspace(left + 0.03, right - 0.03, max(2, round((right - left) / step)))
        parts.append(_boxes(u - 0.012, u + 0.012, v, v + 0.97, out - 0.055, out - 0.03, rail, "-y +y"))
        for end in (left + 0.022, right - 0.048):
            parts.append(_boxes(end, end + 0.026, v, v + 0.97, n - 0.012, n + 0.012, rail, "-y +y"))
    return join(parts)


def awning(cell: NDArray[np.float64], material: int, *, out: float = 1.3) -> Soup:
    """A sloping awning over one shop window."""
    u0, u1, v1 = cell[0] + 0.1, cell[1] - 0.1, cell[3] - 0.35
    profile = np.array([[v1 - 0.06, -0.05], [v1 - 0.6, out], [v1 - 0.54, out], [v1, -0.05]])
    ends = xyz([[u0], [u1]], *profile.T)
    sides = np.stack([ends[0], np.roll(ends[0], -1, 0), np.roll(ends[1], -1, 0), ends[1]], 1)
    return quads(np.concatenate([sides[:, ::-1], ends[:1], ends[1:, ::-1]]), material)
