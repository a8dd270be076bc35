"""The second layer of orthoviews by the definition: every triangle is tested with every ray, in float64."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.support import orthoview_oracle as oracle
from tests.support.orthoview_oracle import Axes, Picture, Triple

Floats = NDArray[np.float64]


def crossings(triangles: Floats, starts: Floats, along: Floats) -> Floats:
    """Distances (rays, triangles) at which rays from `starts` cross triangles; infinite where they do not.

    Möller, Trumbore: Fast, minimum storage ray/triangle intersection, 1997.
    """
    corner, one, other = triangles[:, 0], triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]
    across = np.cross(along, other)
    # The triple products of the article, each as a product of the offset from the corner and a vector of the triangle.
    vectors = np.stack([across, np.cross(one, along), np.cross(one, other)])
    with np.errstate(divide="ignore", invalid="ignore"):
        products = vectors @ starts.T - (vectors * corner).sum(axis=2)[..., None]
        u, v, distance = products / (one * across).sum(axis=1)[:, None]
    found: Floats = np.where((u >= 0) & (v >= 0) & (u + v <= 1), distance, np.inf).T
    return found


def lines_of(direction: Triple, directions: list[Triple]) -> list[Floats]:
    """Unit vectors half-way between a direction and those at most 90° from it, except directions themselves."""
    units = [np.array(other, float) / np.linalg.norm(other) for other in directions]
    own = np.array(direction, float) / np.linalg.norm(direction)
    halves = [own + other for other in units if -1e-9 < own @ other < 1 - 1e-9]
    lines = [half / np.linalg.norm(half) for half in halves]
    return [line for line in lines if all(other @ line < 1 - 1e-9 for other in units)]


class Leaf:
    """A cell's surfaces in pixels of twice a view's resolution.

    Parameters
    ----------
    triangles
        World positions (T, 3, 3).
    colors
        Linear RGB of each.
    corner, side
        The cell.
    size, steps
        Parameters of the views.
    """

    def __init__(self, triangles: Floats, colors: Floats, corner: Any, side: float, size: int, steps: int) -> None:
        self.triangles, self.colors, self.corner, self.side = triangles, colors, np.asarray(corner), side
        self.size, self.steps = size, steps
        normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
        self.normals = normals / np.linalg.norm(normals, axis=1, keepdims=True)

    def second_layer(self, direction: Triple, directions: list[Triple]) -> Picture:
        """The second layer's view from a direction."""
        axes, double = Axes.from_direction(direction), 2 * self.size
        extents = axes.extents * self.side
        pixel, step = max(extents[:2]) / double, extents[2] / self.steps
        starts = oracle.pixel_points(self.corner, self.side, direction, double).reshape(-1, 3)
        enter, leave = np.moveaxis(oracle.cell_interval(starts, -axes.toward, self.corner, self.side), -1, 0)
        found = crossings(self.triangles, starts, -axes.toward)
        found = np.where((found >= enter[:, None]) & (found <= leave[:, None]), found, np.inf)
        first = found.min(axis=1)
        is_second = (self.normals @ axes.toward > 0) & (found > first[:, None] + oracle.REACH_PIXELS * pixel)
        second = np.where(is_second, found, np.inf)
        face, depth = second.argmin(axis=1), second.min(axis=1)
        at = np.flatnonzero(np.isfinite(depth))
        points = starts[at] - depth[at, None] * axes.toward
        is_seen = [self.sees(points, face[at], line) for line in lines_of(direction, directions)]
        depth[at[~np.any(is_seen, axis=0)]] = np.inf
        shape = (double, double)
        there = np.isfinite(depth)[:, None]
        color, normal = np.where(there, self.colors[face], 0), np.where(there, self.normals[face], 0)
        picture = Picture((depth / step).reshape(shape), color.reshape(*shape, 3), normal.reshape(*shape, 3))
        return oracle.reduced(picture, oracle.REACH_PIXELS * pixel / step)

    def sees(self, points: Floats, faces: NDArray[np.int64], line: Floats) -> NDArray[np.bool_]:
        """Whether points of faces are visible from where lines from them leave the cell."""
        ends = oracle.cell_interval(points, line, self.corner, self.side)[:, 1]
        distances = crossings(self.triangles, points, line)
        is_hidden = ((distances > 1e-9) & (distances <= ends[:, None])).any(axis=1)
        return np.asarray((self.normals[faces] @ line > 0) & ~is_hidden)


def composed(
    children: list[tuple[Triple, list[Picture]]], direction: Triple, size: int, steps: int
) -> tuple[Picture, Picture]:
    """Both layers of a parent's view from those of its children, in the order in which they are drawn.

    Depths are steps: of the children in the children's, of the parent in its own, which are twice as long.
    """
    axes, double = Axes.from_direction(direction), 2 * size
    extents = axes.extents
    reach = oracle.REACH_PIXELS * (2 * max(extents[:2]) / double) / (extents[2] / steps)
    front = oracle.pixel_points((0, 0, 0), 2.0, direction, double)[0, 0]
    shown: dict[tuple[int, int], list[tuple[float, Floats, Floats]]] = {}
    for octant, layers in children:
        # The position of each pixel from its point in space.
        offset = oracle.pixel_points(octant, 1.0, direction, size) - front
        columns = np.rint(offset @ axes.right / (2 * extents[0] / double)).astype(int)
        rows = np.rint(-(offset @ axes.up) / (2 * extents[1] / double)).astype(int)
        before = np.rint(-(offset @ axes.toward) / (extents[2] / steps))
        for layer in layers:
            for at in np.argwhere(np.isfinite(layer.depth)):
                place = (*at,)
                texel = (layer.depth[place] + before[place], layer.color[place], layer.normal[place])
                shown.setdefault((rows[place], columns[place]), []).append(texel)
    both = [
        Picture(np.full((double, double), np.inf), np.zeros((double, double, 3)), np.zeros((double, double, 3)))
        for _ in range(2)
    ]
    for place, texels in shown.items():
        # `min` returns the first of equal values.
        first = min(texels, key=lambda texel: texel[0])
        others = [texel for texel in texels if texel[0] > first[0] + reach]
        chosen = [first] + ([min(others, key=lambda texel: texel[0])] if others else [])
        for picture, texel in zip(both, chosen, strict=False):
            picture.depth[place], picture.color[place], picture.normal[place] = texel
    one, other = (oracle.reduced(picture, reach) for picture in both)
    one.depth, other.depth = np.floor(one.depth / 2), np.floor(other.depth / 2)
    return one, other


def unseen(firsts: list[NDArray[Any]], seconds: list[NDArray[Any]], directions: list[Triple], steps: int) -> Floats:
    """For each direction the share of the second layer that no view of the first shows, from codes of depths."""
    shares, size = np.zeros(len(directions)), len(firsts[0])
    for number, direction in enumerate(directions):
        axes = Axes.from_direction(direction)
        starts = oracle.pixel_points((0, 0, 0), 1.0, direction, size)
        count = 0
        for at in np.argwhere(seconds[number] > 0):
            place = (*at,)
            point = starts[place] - (seconds[number][place] - 0.5) * axes.extents[2] / steps * axes.toward
            count += not any(
                _shows(first, point, other, steps) for first, other in zip(firsts, directions, strict=True)
            )
        shares[number] = count / max((firsts[number] > 0).sum(), 1)
    return shares


def _shows(codes: NDArray[Any], point: Floats, direction: Triple, steps: int) -> bool:
    """Whether a view shows a point in one of nine pixels."""
    axes, size = Axes.from_direction(direction), len(codes)
    offset = point - oracle.pixel_points((0, 0, 0), 1.0, direction, size)[0, 0]
    column = int(np.floor(offset @ axes.right / axes.extents[0] * size + 0.5))
    row = int(np.floor(-(offset @ axes.up) / axes.extents[1] * size + 0.5))
    depth = -(offset @ axes.toward)
    near = codes[max(row - 1, 0) : row + 2, max(column - 1, 0) : column + 2].astype(float)
    depths = (near - 0.5) * axes.extents[2] / steps
    reach = oracle.REACH_PIXELS * max(axes.extents[:2]) / (2 * size)
    return bool(((near > 0) & (np.abs(depths - depth) <= reach)).any())
