"""Triangle soups, the solids that datasets are built from, and welding of equal vertices."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar.datasets._palette import numbers_of
from nearfar.datasets._random import Floats, cross, turn, unit, xyz

# Corners of a box's sides, as bits (x, y, z) of its eight vertices, counter-clockwise from outside.
_SIDES = {
    "-x": (0, 1, 3, 2), "+x": (4, 6, 7, 5), "-y": (0, 4, 5, 1), "+y": (2, 3, 7, 6), "-z": (0, 2, 6, 4),
    "+z": (1, 5, 7, 3),
}  # fmt: skip


@dataclass(frozen=True)
class Soup:
    """Triangles that do not share corners.

    corners (T, 3, 3) metres; materials (T,) int32; tints (T, 3) float64, the brightness that multiplies the material
    at each corner (default 1); uvs (T, 3, 2) texture coordinates (default 0).
    """

    corners: Floats
    materials: NDArray[np.int32]
    tints: Floats | None = None
    uvs: Floats | None = None

    def __len__(self) -> int:
        return len(self.corners)

    def translate(self, offset: ArrayLike) -> Soup:
        """Return the soup shifted by an offset (3,), metres."""
        return self.mapped(self.corners + np.asarray(offset, np.float64))

    def mapped(self, corners: Floats) -> Soup:
        """Return the same triangles with other corners."""
        return Soup(corners, self.materials, self.tints, self.uvs)

    def scaled(self, factors: ArrayLike) -> Soup:
        """Return the soup stretched along its axes by positive factors."""
        return self.mapped(self.corners * np.asarray(factors, np.float64))

    def rotated(self, fraction: float) -> Soup:
        """Return the soup turned about the vertical axis by a fraction of a full turn; quarter turns are exact."""
        cosine, sine = turn(fraction)
        x, y, z = self.corners[..., 0], self.corners[..., 1], self.corners[..., 2]
        return self.mapped(np.stack([cosine * x + sine * z, y, cosine * z - sine * x], -1))

    def pitched(self, fraction: float) -> Soup:
        """Return the soup turned about the x axis by a fraction of a full turn, from y towards z."""
        cosine, sine = turn(fraction)
        x, y, z = self.corners[..., 0], self.corners[..., 1], self.corners[..., 2]
        return self.mapped(np.stack([x, cosine * y - sine * z, sine * y + cosine * z], -1))

    def laid_x(self) -> Soup:
        """Return a solid about the y axis turned to lie along x; its +z side becomes its top."""
        return self.mapped(self.corners[..., [1, 2, 0]])

    def laid_z(self) -> Soup:
        """Return a solid about the y axis turned to lie along z; its +x side becomes its top."""
        return self.mapped(self.corners[..., [2, 0, 1]])

    def copies(self, offsets: ArrayLike) -> Soup:
        """Repeat the soup at offsets (K, 3), metres."""
        return join(self.translate(offset) for offset in np.asarray(offsets, np.float64).reshape(-1, 3))

    def tinted(self, tints: Floats) -> Soup:
        """Return the soup with a brightness for each corner."""
        return Soup(self.corners, self.materials, np.broadcast_to(tints, self.corners.shape[:2]), self.uvs)


@dataclass(frozen=True)
class Indexed:
    """Triangles with shared vertices, for a mesh."""

    positions: NDArray[np.float32]
    faces: NDArray[np.uint32]
    materials: NDArray[np.int32]
    colors: NDArray[np.uint8] | None
    uvs: NDArray[np.float32] | None


def join(soups: Iterable[Soup]) -> Soup:
    """Concatenate the triangles of several soups, in order."""
    parts = [soup for soup in soups if len(soup)]
    if not parts:
        return Soup(np.zeros((0, 3, 3)), np.zeros(0, np.int32))
    tints = [part.tints if part.tints is not None else np.ones(part.corners.shape[:2]) for part in parts]
    uvs = [part.uvs if part.uvs is not None else np.zeros((len(part), 3, 2)) for part in parts]
    return Soup(
        np.concatenate([part.corners for part in parts]),
        np.concatenate([part.materials for part in parts]),
        np.concatenate(tints) if any(part.tints is not None for part in parts) else None,
        np.concatenate(uvs) if any(part.uvs is not None for part in parts) else None,
    )


def quads(corners: ArrayLike, materials: ArrayLike) -> Soup:
    """Make two triangles per quadrilateral (K, 4, 3), counter-clockwise from outside; `materials` is (K,) or one."""
    points = np.asarray(corners, np.float64).reshape(-1, 4, 3)
    return Soup(halves(points), np.repeat(numbers_of(materials, len(points)), 2))


def halves(values: NDArray[np.float64]) -> Floats:
    """Copy values (K, 4, …) at the corners of quadrilaterals to the corners of their triangles (2 K, 3, …)."""
    return values[:, [[0, 1, 2], [0, 2, 3]]].reshape(-1, 3, *values.shape[2:])


_SQUARE = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])


def textured(corners: ArrayLike, materials: ArrayLike, uvs: ArrayLike = _SQUARE) -> Soup:
    """Make quadrilaterals (K, 4, 3) with texture coordinates (4, 2) or (K, 4, 2), by default the whole texture."""
    soup = quads(corners, materials)
    return Soup(soup.corners, soup.materials, None, halves(np.broadcast_to(uvs, (len(soup) // 2, 4, 2))))


def triangles(corners: ArrayLike, materials: ArrayLike) -> Soup:
    """Make triangles (K, 3, 3), counter-clockwise from outside; `materials` is (K,) or one."""
    points = np.asarray(corners, np.float64).reshape(-1, 3, 3)
    return Soup(points, np.array(numbers_of(materials, len(points))))


def boxes(low: ArrayLike, high: ArrayLike, materials: ArrayLike, *, without: str = "") -> Soup:
    """Make boxes between two corners (K, 3); `without` names sides to leave out, such as "-y +y" for hidden ones."""
    lows, highs = np.broadcast_arrays(np.atleast_2d(np.asarray(low, float)), np.atleast_2d(np.asarray(high, float)))
    ends, bits = np.stack([lows, highs]), np.arange(8)
    vertices = np.stack([ends[(bits >> (2 - axis)) & 1, :, axis] for axis in range(3)], -1)
    sides = [list(side) for name, side in _SIDES.items() if name not in without]
    corners = vertices[sides].transpose(2, 0, 1, 3)
    return quads(corners.reshape(-1, 4, 3), np.repeat(numbers_of(materials, len(lows)), len(sides)))


def bars(low: ArrayLike, size: ArrayLike, materials: ArrayLike, *, without: str = "") -> Soup:
    """Make boxes from least corners (K, 3) and sizes (K, 3) or (3,); `without` as in `boxes`."""
    return boxes(low, np.add(low, size), materials, without=without)


def sheet(points: Floats) -> Floats:
    """Cells (R − 1, C − 1, 4, …) between the points (R, C, …) of a grid, with corners counter-clockwise from above."""
    return np.stack([points[1:, :-1], points[1:, 1:], points[:-1, 1:], points[:-1, :-1]], 2)


def ring(count: int, radius: float = 1.0, phase: float = 0.0) -> Floats:
    """Make points (count, 2) of a circle, from +x towards −z, so that a loft upwards faces outwards."""
    cosine, sine = turn((np.arange(count) + phase) / count)
    return np.stack([cosine, -sine], -1) * radius


def loft(sections: ArrayLike, materials: ArrayLike, *, bottom: bool = True, top: bool = True) -> Soup:
    """Make a solid through closed sections (S, N, 3), in the order of `ring`; a section may shrink to a point.

    `materials` is one material, or one for each of the S−1 bands; the caps take those of the first and the last band.
    """
    rows = np.asarray(sections, np.float64)
    bands = numbers_of(materials, len(rows) - 1)
    after = np.roll(rows, -1, axis=1)
    sides = np.stack([rows[:-1], after[:-1], after[1:], rows[1:]], 2)
    soups = [quads(sides.reshape(-1, 4, 3), np.repeat(bands, rows.shape[1]))]
    # Convex caps are fans around their centre, which avoids slivers on many-sided rings.
    for has_cap, row, order, band in ((bottom, 0, -1, 0), (top, -1, 1, -1)):
        if has_cap:
            edge = rows[row][::order]
            # A plain loop, because NumPy may sum in another order on another processor.
            middle = sum(edge[1:], edge[0]) / len(edge)
            fan = np.stack([np.broadcast_to(middle, edge.shape), edge, np.roll(edge, -1, axis=0)], 1)
            soups.append(triangles(fan, bands[band]))
    return _without_slivers(join(soups))


def _without_slivers(soup: Soup) -> Soup:
    """Drop triangles with coinciding corners (where a section is a point)."""
    a, b, c = soup.corners[:, 0], soup.corners[:, 1], soup.corners[:, 2]
    keep = ~((a == b).all(1) | (b == c).all(1) | (c == a).all(1))
    return soup if keep.all() else Soup(soup.corners[keep], soup.materials[keep])


def lathe(profile: ArrayLike, count: int, materials: ArrayLike, *, phase: float = 0.5, **caps: bool) -> Soup:
    """Make a solid of revolution about the y axis through (radius, height) points, from bottom to top."""
    radii, heights = np.asarray(profile, np.float64).T[..., None]
    x, z = ring(count, phase=phase).T
    return loft(xyz(radii * x, heights, radii * z), materials, **caps)


def tube(path: ArrayLike, radii: ArrayLike, count: int, materials: ArrayLike, **caps: bool) -> Soup:
    """Make a round bar along points (P, 3), one radius in metres each."""
    points = np.asarray(path, np.float64)
    widths = np.broadcast_to(np.asarray(radii, np.float64), len(points))
    along = unit(np.gradient(points, axis=0))
    # One helper direction for the whole bar; otherwise it would twist where the helper changes.
    helper = [0.0, 1.0, 0.0] if np.abs(along[0, 1]) < 0.9 else [1.0, 0.0, 0.0]
    side = unit(cross(np.broadcast_to(helper, along.shape), along))
    return loft(circles(points, side, cross(along, side), widths[:, None, None], count), materials, **caps)


def circles(middles: Floats, u: Floats, w: Floats, radius: Floats | float, count: int) -> Floats:
    """Circles (P, count, 3) around points (P, 3) in the planes of unit vectors `u` and `w`, for `loft`."""
    circle = ring(count)
    return middles[:, None] + radius * (u[:, None] * circle[None, :, :1] - w[:, None] * circle[None, :, 1:])


def sphere(subdivisions: int) -> Floats:
    """Make the corners (T, 3, 3) of a unit sphere of 20 · 4ˢ triangles, s being the number of subdivisions."""
    golden = 1.618033988749895
    base = np.array([[-1, golden, 0], [1, golden, 0], [-1, -golden, 0], [1, -golden, 0]])
    points = np.concatenate([base, base[:, [2, 0, 1]], base[:, [1, 2, 0]]])
    order = "0b5 051 017 07a 0ab 159 5b4 ba2 a76 718 394 342 326 368 389 495 24b 62a 867 981"
    corners = points[[[int(digit, 16) for digit in face] for face in order.split()]]
    corners = unit(corners)
    for _ in range(subdivisions):
        middles = 0.5 * (corners + np.roll(corners, -1, axis=1))
        cut = [np.stack([corners[:, i], middles[:, i], middles[:, i - 1]], 1) for i in range(3)]
        corners = unit(np.concatenate([*cut, middles]))
    return corners


def weld(soup: Soup) -> Indexed:
    """Merge corners with equal position, tint and texture coordinate."""
    columns = [soup.corners.reshape(-1, 3)]
    if soup.tints is not None:
        columns.append(soup.tints.reshape(-1, 1))
    if soup.uvs is not None:
        columns.append(soup.uvs.reshape(-1, 2))
    rows = np.concatenate(columns, 1).astype(np.float32) + np.float32(0)
    # Rows are sorted by a 64-bit hash, which is fast. Equal rows have equal hashes; a collision is detected below.
    words = rows.view(np.uint32).astype(np.uint64)
    key = np.zeros(len(rows), np.uint64)
    for column in words.T:
        key = (key ^ column) * np.uint64(0x9E3779B97F4A7C15)
        key ^= key >> np.uint64(29)
    _, first, inverse = np.unique(key, return_index=True, return_inverse=True)
    if not np.array_equal(rows[first][inverse], rows):
        _, first, inverse = np.unique(rows, axis=0, return_index=True, return_inverse=True)
    # Vertices are ordered by first use, so that neighbours in the mesh are neighbours in memory.
    order = np.argsort(first, kind="stable")
    rank = np.empty(len(order), np.uint32)
    rank[order] = np.arange(len(order), dtype=np.uint32)
    vertices = rows[first[order]]
    colors = uvs = None
    if soup.tints is not None:
        level = np.clip(_encode_srgb(vertices[:, 3].astype(np.float64)) * 255.0 + 0.5, 0, 255).astype(np.uint8)
        colors = np.stack([level, level, level, np.full_like(level, 255)], -1)
    if soup.uvs is not None:
        uvs = np.ascontiguousarray(vertices[:, -2:])
    faces = rank[inverse.reshape(-1)].reshape(-1, 3)
    return Indexed(np.ascontiguousarray(vertices[:, :3]), faces, soup.materials, colors, uvs)


def _encode_srgb(linear: Floats) -> Floats:
    """Approximate sRGB encoding by square roots only, which every platform rounds alike."""
    root = np.sqrt(np.clip(linear, 0.0, 1.0))
    fourth = np.sqrt(root)
    return 0.585122381 * root + 0.783140355 * fourth - 0.368262736 * np.sqrt(fourth)
