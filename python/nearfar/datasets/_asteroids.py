"""`nearfar.datasets.asteroids`: an asteroid belt of instanced shapes, as a source that is queried box by box."""

from __future__ import annotations

import functools
from typing import Any, SupportsFloat

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar._scene.builder import SceneBuilder
from nearfar._scene.scene import Scene
from nearfar.datasets import _rocks as rocks
from nearfar.datasets._random import Floats, turn, xyz
from nearfar.datasets._world.noise import uniform_hash

SHAPES = 16
_MAX_COUNT, _MAX_POLYGONS = 1_000_000, 4_000_000
_SPACING = 1_400.0
"""Side of the cubes that hold at most one body each, metres, so that bodies never touch."""
_MIN, _MAX = 45.0, 540.0
"""Radii of bodies, metres."""
_WIDE, _HIGH = 0.25, 0.06
"""Half the width and half the height of the belt, as shares of its radius."""


class Asteroids:
    """A belt of bodies around the y axis, created by `asteroids`: `query` makes a part of it, `scene` the whole belt.

    Positions of all bodies are computed, but no geometry is made before a query.
    """

    def __init__(self, count: int = 29_264, polygons: int = 97_000, seed: int = 0) -> None:
        self._count = check.integer("count", count, 1, _MAX_COUNT)
        self._polygons = check.integer("polygons", polygons, 48, _MAX_POLYGONS)
        self._seed = check.integer("seed", seed, 0, 2**63 - 1)
        self._squares = rocks.squares(self._polygons)
        self._scenes = functools.lru_cache(maxsize=4)(self._build_scene)

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle the arguments, from which all bodies follow."""
        return Asteroids, (self._count, self._polygons, self._seed)

    def __repr__(self) -> str:
        return f"nearfar.datasets.asteroids(count={self._count}, polygons={self._polygons}, seed={self._seed})"

    def __len__(self) -> int:
        return self._count

    @property
    def triangle_count(self) -> int:
        """Number of triangles of all bodies in full detail."""
        return self._count * 12 * self._squares * self._squares

    @functools.cached_property
    def centers(self) -> NDArray[np.float64]:
        """Centres of the bodies (N, 3), metres."""
        return self._places[0]

    @functools.cached_property
    def radii(self) -> NDArray[np.float64]:
        """Radii (N,) of bounding spheres around the centres, metres."""
        fraction = self._random_numbers(20)
        # The number of bodies above a size falls with its square: a first approximation of the asteroid belt.
        steep = 1.0 - fraction * (1.0 - (_MIN / _MAX) * (_MIN / _MAX))
        return np.floor(64.0 * _MIN / np.sqrt(steep)) / 64.0

    @functools.cached_property
    def shapes(self) -> NDArray[np.int64]:
        """Number of each body's shape (N,), 0 to 15."""
        return np.minimum((SHAPES * self._random_numbers(21)).astype(np.int64), SHAPES - 1)

    @functools.cached_property
    def bounds(self) -> NDArray[np.float64]:
        """Least and greatest corner (2, 3), metres: a box that contains all bodies, not the smallest one."""
        reach = self.radii[:, None]
        return np.stack([(self.centers - reach).min(0), (self.centers + reach).max(0)])

    def query(self, aabb: ArrayLike, detail: SupportsFloat = 0.0) -> Scene:
        """Make the part of the belt that touches a box; arguments and errors are those of `nearfar.SceneSource.query`.

        Bodies are never left out; a `detail` of 0 takes the finest level of each shape. The triangles belong to objects
        "asteroid_17" and so on; bodies inside the box stay instances.
        """
        return self.scene(detail).query(check.box("aabb", aabb))

    def scene(self, detail: SupportsFloat = 0.0) -> Scene:
        """Make all bodies as one scene of instances; see `query` for `detail`."""
        return self._scenes(check.at_least_zero("detail", detail))

    def _build_scene(self, detail: float) -> Scene:
        builder, transforms, levels = SceneBuilder(), self._transforms(), self.levels(detail)
        builder.material((1.0, 1.0, 1.0, 1.0))
        for shape, level in sorted(set(zip(self.shapes.tolist(), levels.tolist(), strict=True))):
            bodies = np.flatnonzero((self.shapes == shape) & (levels == level))
            rock = rocks.rock(self._seed, shape, self._squares, level)
            mesh = builder.mesh(rock.positions, rock.faces, colors=rock.colors, normals=rock.normals)
            builder.place_many(mesh, transforms[bodies], [f"asteroid_{k}" for k in bodies.tolist()])
        return builder.build()

    def levels(self, detail: SupportsFloat) -> NDArray[np.int64]:
        """Level of each body's shape (N,): the coarsest whose error is at most `detail` metres."""
        limit, levels = check.at_least_zero("detail", detail), np.zeros(self._count, np.int64)
        used = np.unique(self.shapes).tolist()
        for level in range(1, len(rocks.levels(self._squares)) if limit > 0.0 else 0):
            errors = np.zeros(SHAPES)
            errors[used] = [rocks.error(self._seed, shape, self._squares, level) for shape in used]
            levels[errors[self.shapes] * self.radii <= limit] = level
        return levels

    def _random_numbers(self, channel: int) -> Floats:
        _, i, j, k = self._places
        return uniform_hash(self._seed, 0x6000 + channel, i * 65_536 + k, j)

    @functools.cached_property
    def _places(self) -> tuple[Floats, NDArray[np.int64], NDArray[np.int64], NDArray[np.int64]]:
        """Draw a cube for each body; return the centres, and the columns, rows and layers of the cubes."""
        # Twice as many cubes as bodies: the belt's volume is 2π²·0.25·0.06 times the cube of its radius.
        cubes = max(2.0 * self._count, 64.0) / (2.0 * 9.8696 * _WIDE * _HIGH)
        belt = 1.0
        while belt * belt * belt < cubes:
            belt *= 1.02
        wide, high = int((1.0 + _WIDE) * belt) + 2, int(_HIGH * belt) + 2
        line, layers = np.arange(-wide, wide + 1), np.arange(-high, high + 1)
        i, j, k = (axis.reshape(-1) for axis in np.meshgrid(line, layers, line, indexing="ij"))
        out, up = (np.sqrt(i * i + k * k) - belt) / (_WIDE * belt), j / (_HIGH * belt)
        inside = np.flatnonzero(out * out + up * up <= 1.0)
        i, j, k = i[inside], j[inside], k[inside]
        order = np.argsort(uniform_hash(self._seed, 0x6000, i * 65_536 + k, j), kind="stable")[: self._count]
        i, j, k = i[order], j[order], k[order]
        greatest_shift = 0.5 - _MAX / _SPACING
        draws = [uniform_hash(self._seed, 0x6001 + axis, i * 65_536 + k, j) for axis in range(3)]
        centers = np.stack([c + greatest_shift * (2.0 * d - 1.0) for c, d in zip((i, j, k), draws, strict=True)], -1)
        return np.floor(64.0 * _SPACING * centers) / 64.0, i, j, k

    def _transforms(self) -> Floats:
        """Placements (N, 4, 4) of shapes in the unit ball: scaled, rotated at random, moved."""
        # K. Shoemake, Uniform random rotations (1992).
        fraction, first, second = (self._random_numbers(channel) for channel in (30, 31, 32))
        (c1, s1), (c2, s2) = turn(first), turn(second)
        a, b = np.sqrt(1.0 - fraction), np.sqrt(fraction)
        x, y, z, w = a * s1, a * c1, b * s2, b * c2
        matrices = np.zeros((self._count, 4, 4))
        matrices[:, 0, :3] = xyz(1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w))
        matrices[:, 1, :3] = xyz(2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w))
        matrices[:, 2, :3] = xyz(2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y))
        matrices[:, :3, :3] *= self.radii[:, None, None]
        matrices[:, :3, 3], matrices[:, 3, 3] = self.centers, 1.0
        return matrices


def asteroids(count: int = 29_264, polygons: int = 97_000, seed: int = 0) -> Asteroids:
    """Make an asteroid belt, as a source that is queried box by box.

    The default numbers are those of Chaudhuri, Horn, Hanrahan and Koltun, Image-based exploration of massive online
    environments (2009): 29,264 bodies of about 97,000 polygons, 2.8 thousand million in all. That data set is not
    published; here 16 shapes are placed many times, turned and scaled. Returns a source with `bounds`, `query(aabb,
    detail)`, and `scene(detail)` for all bodies. ValueError for numbers out of range.

    Parameters
    ----------
    count
        Number of bodies, 1 to 1,000,000; the belt grows with it.
    polygons
        Approximate triangles of a body: 48 to 4,000,000, rounded to twelve times a square number (97,200 by default).
    seed
        0 to 2⁶³ − 1.
    """
    return Asteroids(count, polygons, seed)
