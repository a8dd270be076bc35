"""Asteroids' shapes: lumpy bodies with craters, each at several levels of detail with a measured error."""

from __future__ import annotations

import functools
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar.datasets._random import Floats, RandomStream, cross, dot, length, turn, unit
from nearfar.datasets._textures import image

COARSEST = 2
"""Least number of squares along each edge of the cube that a shape's grid is made from."""
_CRATERS = 110
_MARGIN = 1.1
"""Factor of the greatest error found at the samples."""


@dataclass(frozen=True)
class Rock:
    """A shape in the unit ball around the origin; its surface touches the sphere."""

    positions: NDArray[np.float32]
    normals: NDArray[np.float32]
    colors: NDArray[np.uint8]
    faces: NDArray[np.uint32]


def squares(polygons: int) -> int:
    """Return the squares along a cube's edge for about `polygons` triangles: a body has 12 n²."""
    return max(COARSEST, int(np.floor(np.sqrt(polygons / 12.0) + 0.5)))


def levels(n: int) -> list[int]:
    """Squares along the edge at each level of a shape, from the finest."""
    return [n, *(levels(n // 2) if n // 2 >= COARSEST else [])]


@functools.lru_cache(maxsize=256)
def rock(seed: int, number: int, n: int, level: int) -> Rock:
    """Make a level of a shape whose finest level has `n` squares along the cube's edge."""
    points, lift = _points(seed, number, n, level)
    directions, faces, _ = grid(levels(n)[level])
    a, b, c = (points[faces[:, k]] for k in range(3))
    face_normals, normals = cross(b - a, c - a), np.zeros_like(points)
    for corner in range(3):
        for axis in range(3):
            normals[:, axis] += np.bincount(faces[:, corner], face_normals[:, axis], len(points))
    colors = _colors(seed, number, directions, lift)
    return Rock(points.astype(np.float32), unit(normals).astype(np.float32), colors, faces.astype(np.uint32))


@functools.lru_cache(maxsize=256)
def error(seed: int, number: int, n: int, level: int) -> float:
    """Greatest distance of a level from the finest one, as a share of the body's radius.

    The centre sees both surfaces completely, so their distance is at most the greatest difference along a ray from the
    centre. It is measured at the corners and the centres of the finest level's triangles, and a tenth is added.
    """
    if level == 0:
        return 0.0
    fine, _ = _points(seed, number, n, 0)
    samples = np.concatenate([fine, fine[grid(n)[1]].sum(1) / 3.0])
    distances = length(samples)
    coarse = radii(_points(seed, number, n, level)[0], levels(n)[level], samples / distances[:, None])
    return _MARGIN * float(np.abs(coarse - distances).max())


@functools.lru_cache(maxsize=32)
def _points(seed: int, number: int, n: int, level: int) -> tuple[Floats, Floats]:
    """Corners (V, 3) of a level, and their heights above the sphere before the shape is scaled to the unit ball."""
    directions = grid(levels(n)[level])[0]
    lift = relief(seed, number, directions)
    # The margin keeps the rounded float32 corners in the ball.
    size = 1.0 + (float(lift.max()) if level == 0 else _greatest_height(seed, number, n)) + 1.0e-6
    return directions * ((1.0 + lift) / size)[:, None], lift


@functools.lru_cache(maxsize=256)
def _greatest_height(seed: int, number: int, n: int) -> float:
    return float(_points(seed, number, n, 0)[1].max())


@functools.lru_cache(maxsize=8)
def grid(n: int) -> tuple[Floats, NDArray[np.int64], NDArray[np.int64]]:
    """Directions (6n² + 2, 3) of a cube's grid seen from its centre, faces (12n², 3), and the keys of the corners.

    Faces are counter-clockwise seen from outside; keys (6n² + 2,) ascend.
    """
    corners = []
    for axis in range(3):
        for end in (0, n):
            p, q = np.meshgrid(np.arange(n), np.arange(n), indexing="ij")
            for p_step, q_step in ((0, 0), (1, 0), (1, 1), (0, 1)) if end else ((0, 0), (0, 1), (1, 1), (1, 0)):
                # Coordinates along the axis and the two next ones, in the order x, y, z.
                corners.append(np.roll(np.stack([np.full_like(p, end), p + p_step, q + q_step], -1), axis, -1))
    places = np.stack(corners).reshape(6, 4, n * n, 3).transpose(0, 2, 1, 3)
    keys, inverse = np.unique(_key(n, places), return_inverse=True)
    lattice = np.stack([keys // ((n + 1) * (n + 1)), keys // (n + 1) % (n + 1), keys % (n + 1)], -1)
    return unit(lines(n)[lattice]), inverse.reshape(-1, 4)[:, [[0, 1, 2], [0, 2, 3]]].reshape(-1, 3), keys


def _key(n: int, places: NDArray[np.int64]) -> NDArray[np.int64]:
    """Numbers of lattice points (…, 3) of a cube, 0 … n along each axis."""
    return (places[..., 0] * (n + 1) + places[..., 1]) * (n + 1) + places[..., 2]


def lines(n: int) -> Floats:
    """Grid lines on a cube's face, −1 … 1, denser towards its edges, which are farther from the centre."""
    even = 2.0 * np.arange(n + 1) / n - 1.0
    return even * (0.78 + 0.22 * even * even)


def relief(seed: int, number: int, directions: Floats) -> Floats:
    """Height of a shape's surface above the unit sphere in directions (N, 3)."""
    random = RandomStream(seed, 90, number)
    height = np.zeros(len(directions))
    # Broad lumps and flats: a few waves across the body.
    for _ in range(7):
        along = dot(directions, random.uniform(3, -1.0, 1.0))
        height = height + 0.085 * turn(along * random.number(0.2, 0.6) + random.number())[1]
    for octave, (scale, high) in enumerate(((2.3, 0.14), (5.1, 0.06), (11.0, 0.028), (23.0, 0.013), (47.0, 0.006))):
        height = height + high * _noise(seed, 64 * number + octave, directions * scale)
    return np.maximum(height + _craters(random, directions), -0.7)


def _craters(random: RandomStream, directions: Floats) -> Floats:
    """Bowls with raised rims; the number of craters falls with the square of their size."""
    depth = np.zeros(len(directions))
    for k in range(_CRATERS):
        height = random.number(-1.0, 1.0)
        cosine, sine = turn(random.number())
        flat = np.sqrt(1.0 - height * height)
        wide = min(0.62, 0.075 / np.sqrt(max(random.number(), 0.012)))
        offset = directions - np.array([flat * float(cosine), height, flat * float(sine)])
        near = np.flatnonzero((offset * offset).sum(1) < (1.6 * wide) ** 2)
        radius = length(offset[near]) / wide
        bowl = np.where(radius < 1.0, 0.5 * (radius * radius - 1.0), 0.0)
        rim = np.clip(1.0 - np.abs(radius - 1.0) / 0.6, 0.0, 1.0)
        depth[near] += wide * (0.55 if k % 3 else 0.8) * (bowl + 0.14 * rim * rim * (3.0 - 2.0 * rim))
    return depth


def _noise(seed: int, channel: int, points: Floats) -> Floats:
    """3D value noise, −1 … 1."""
    low = np.floor(points)
    weights = points - low
    weights = weights * weights * (3.0 - 2.0 * weights)
    cell = low.astype(np.int64) + 512
    corners = []
    for corner in range(8):
        step = [corner >> 2 & 1, corner >> 1 & 1, corner & 1]
        words = ((cell[:, 0] + step[0]) << 40) | ((cell[:, 1] + step[1]) << 20) | (cell[:, 2] + step[2])
        corners.append(_core.uniform(seed, 0x5000 + channel, words.astype(np.uint64)))
    for axis in (2, 1, 0):
        corners = [a + weights[:, axis] * (b - a) for a, b in zip(corners[::2], corners[1::2], strict=True)]
    return 2.0 * corners[0] - 1.0


def _colors(seed: int, number: int, directions: Floats, lift: Floats) -> NDArray[np.uint8]:
    """Colours (N, 4) in sRGB: grey to brown, with dark plains and pale heights."""
    random = RandomStream(seed, 91, number)
    base = np.array([146.0, 138.0, 128.0]) + random.number(-22.0, 16.0)
    base = base + random.number() * np.array([10.0, 0.0, -14.0])
    tone = 1.0 + 0.5 * np.clip(lift, -0.35, 0.35) + 0.1 * _noise(seed, 64 * number + 40, directions * 9.0)
    return image(base * tone[:, None])


def radii(points: Floats, count: int, directions: Floats) -> Floats:
    """Distance from the centre to the triangles of a level with corners `points` in directions (N, 3)."""
    axis, row = np.argmax(np.abs(directions), axis=1), np.arange(len(directions))
    end = directions[row, axis]
    p, q = (directions[row, (axis + k) % 3] / np.abs(end) for k in (1, 2))
    edge, keys = lines(count), grid(count)[2]
    i, j = (np.clip(np.searchsorted(edge, c, side="right") - 1, 0, count - 1) for c in (p, q))
    # Squares are split from the first to the last corner; the split stays straight in central projection.
    s, t = (p - edge[i]) / (edge[i + 1] - edge[i]), (q - edge[j]) / (edge[j + 1] - edge[j])
    right = (s >= t).astype(np.int64)
    corners = []
    for a, b in ((i, j), (i + 1, j + 1), (i + right, j + 1 - right)):
        places = np.empty((len(directions), 3), np.int64)
        places[row, axis], places[row, (axis + 1) % 3], places[row, (axis + 2) % 3] = np.where(end > 0, count, 0), a, b
        corners.append(points[np.searchsorted(keys, _key(count, places))])
    normal = cross(corners[1] - corners[0], corners[2] - corners[0])
    return dot(normal, corners[0]) / dot(normal, directions)
