"""The scene of a query under construction: tiles, shapes used once, and shapes placed many times."""

from __future__ import annotations

from collections.abc import Hashable, Sequence

import numpy as np
from numpy.typing import NDArray

from nearfar._scene.builder import SceneBuilder
from nearfar._scene.scene import Scene
from nearfar.datasets import _palette
from nearfar.datasets._draw import Floats
from nearfar.datasets._shapes import Indexed
from nearfar.datasets._world import lattice, tiles
from nearfar.datasets._world.tiles import COUNT, Tile


class Parts:
    """Parts found by a query in a box, from least to greatest corner (3,), of a world of half side `half`."""

    def __init__(self, low: Floats, high: Floats, half: float) -> None:
        self.low, self.high, self.half = low, high, half
        self._builder = SceneBuilder()
        self._numbers = np.array([self._builder.material(color) for color in _palette.linear_colors()], np.int32)
        self._ground = self._builder.material((1.0, 1.0, 1.0, 1.0), texture=tiles.grain())
        self._water = self._builder.material((1.0, 1.0, 1.0, 1.0))
        self._shapes: dict[Hashable, int] = {}

    def near(self, feet: Floats, reach: Floats | float) -> NDArray[np.bool_]:
        """Whether spheres around feet (N, 3) touch the box, and lie entirely in the world."""
        away = np.maximum(self.low - feet, 0.0) + np.maximum(feet - self.high, 0.0)
        touches = (away * away).sum(1) <= np.square(reach)
        room = self.half - np.asarray(reach)
        result: NDArray[np.bool_] = touches & (np.abs(feet[:, 0]) < room) & (np.abs(feet[:, 2]) < room)
        return result

    def many(self, key: Hashable, shape: Indexed, transforms: Floats, names: Sequence[str]) -> None:
        """Place a shape by transforms (K, 4, 4); shapes with the same key share a mesh."""
        if len(names):
            if key not in self._shapes:
                self._shapes[key] = self._builder.mesh(
                    shape.positions, shape.faces, material=self._numbers[shape.materials], colors=shape.colors
                )
            self._builder.place_many(self._shapes[key], transforms, names)

    def once(self, shape: Indexed, x: float, z: float, name: str) -> None:
        """Add the part of a shape that touches the box; the shape is used once, relative to a place."""
        corners = shape.positions[shape.faces].astype(np.float64) + np.array([x, 0.0, z])
        least, greatest = corners.min(1), corners.max(1)
        found = (least <= self.high).all(1) & (greatest >= self.low).all(1)
        found &= (np.abs(corners[:, :, [0, 2]]) <= self.half).all((1, 2))
        faces = shape.faces[found]
        if len(faces):
            vertices, numbers = np.unique(faces, return_inverse=True)
            mesh = self._builder.mesh(
                shape.positions[vertices],
                numbers.reshape(faces.shape).astype(np.uint32),
                material=self._numbers[shape.materials[found]],
            )
            self._builder.instance(mesh, _translation(x, z), name=name)

    def tile(self, of: Tile) -> None:
        """Add the part of a tile's ground and water that touches the box."""
        spacing, (x, z) = lattice.spacing(of.level), of.corner
        line = spacing * np.arange(COUNT + 1.0)
        inside = _overlaps(x + line, self.low[0], self.high[0], self.half)
        inside = inside & _overlaps(z + line, self.low[2], self.high[2], self.half)[:, None]
        gz, gx = np.meshgrid(line, line, indexing="ij")
        squares = [of.height[a : COUNT + a, b : COUNT + b] for a in (0, 1) for b in (0, 1)]
        low, high = (np.asarray(of_all.reduce(squares)) for of_all in (np.minimum, np.maximum))
        cells: NDArray[np.bool_] = inside & (low <= self.high[1]) & (high >= self.low[1])
        if cells.any():
            vertices, faces = _compact(cells)
            points = np.stack([gx, of.height, gz], -1).reshape(-1, 3)[vertices].astype(np.float32)
            mesh = self._builder.mesh(
                points,
                faces,
                material=self._ground,
                uvs=points[:, [0, 2]] / np.float32(tiles.TEXTURE),
                colors=of.color.reshape(-1, 4)[vertices],
                normals=of.normal.reshape(-1, 3)[vertices].astype(np.float32),
            )
            self._builder.instance(mesh, _translation(x, z), name=f"land_{of.name}")
        if of.water is not None and self.low[1] <= 0.0 <= self.high[1]:
            self._pool(of, inside, low < 0.0)

    def _pool(self, of: Tile, inside: NDArray[np.bool_], wet: NDArray[np.bool_]) -> None:
        # The surface is flat, so fine grids are replaced by squares of four cells.
        wide = max(1, 4 >> of.level)
        count = COUNT // wide
        cells = wet.reshape(count, wide, count, wide).any((1, 3))
        cells = np.asarray(cells & inside.reshape(count, wide, count, wide).any((1, 3)))
        if cells.any() and of.water is not None:
            line = wide * lattice.spacing(of.level) * np.arange(count + 1.0)
            gz, gx = np.meshgrid(line, line, indexing="ij")
            vertices, faces = _compact(cells)
            points = np.stack([gx, np.zeros_like(gx), gz], -1).reshape(-1, 3)[vertices].astype(np.float32)
            colors = of.water[::wide, ::wide].reshape(-1, 4)[vertices]
            mesh = self._builder.mesh(points, faces, material=self._water, colors=colors)
            self._builder.instance(mesh, _translation(*of.corner), name=f"water_{of.name}")

    def scene(self) -> Scene:
        """Build the scene."""
        return self._builder.build()


def _translation(x: float, z: float) -> Floats:
    matrix = np.eye(4)
    matrix[0, 3], matrix[2, 3] = x, z
    return matrix


def _overlaps(line: Floats, low: float, high: float, half: float) -> NDArray[np.bool_]:
    """Whether intervals between neighbours on a line touch [low, high] and lie in the world."""
    return (line[:-1] <= high) & (line[1:] >= low) & (line[:-1] >= -half) & (line[1:] <= half)


def _compact(cells: NDArray[np.bool_]) -> tuple[NDArray[np.int64], NDArray[np.uint32]]:
    """Vertices used by some cells (n, n) of a grid, and two faces for each cell, split along the same diagonal."""
    n = len(cells)
    j, i = np.nonzero(cells)
    corners = (j * (n + 1) + i)[:, None] + np.array([0, n + 2, 1, 0, n + 1, n + 2])
    used = np.zeros((n + 1) * (n + 1), bool)
    used[corners] = True
    vertices = np.flatnonzero(used)
    numbers = np.zeros(len(used), np.uint32)
    numbers[vertices] = np.arange(len(vertices), dtype=np.uint32)
    return vertices, numbers[corners].reshape(-1, 3)
