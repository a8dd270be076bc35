"""The scene of a query under construction: tiles, shapes used once, and shapes placed many times."""

from __future__ import annotations

from collections.abc import Hashable, Sequence

import numpy as np
from numpy.typing import NDArray

from nearfar._scene.builder import SceneBuilder
from nearfar._scene.scene import Scene
from nearfar.datasets import _palette
from nearfar.datasets._random import Floats, xyz
from nearfar.datasets._shapes import Indexed
from nearfar.datasets._stage import placements
from nearfar.datasets._world import lattice
from nearfar.datasets._world.tiles import COUNT, TEXTURE, Tile, grain


class Parts:
    """Parts found by a query in a box, from least to greatest corner (3,), of a world of half side `half`."""

    def __init__(self, low: Floats, high: Floats, half: float) -> None:
        self.low, self.high, self.half = low, high, half
        self._builder = SceneBuilder()
        self._materials = np.array([self._builder.material(color) for color in _palette.linear_colors()], np.int32)
        self._ground = self._builder.material((1.0, 1.0, 1.0, 1.0), texture=grain())
        self._water = self._builder.material((1.0, 1.0, 1.0, 1.0))
        self._shapes: dict[Hashable, int] = {}

    def near(self, feet: Floats, reach: Floats | float) -> NDArray[np.bool_]:
        """Whether spheres around feet (N, 3) touch the box, and lie entirely in the world."""
        outside = np.maximum(self.low - feet, 0.0) + np.maximum(feet - self.high, 0.0)
        touches = (outside * outside).sum(1) <= np.square(reach)
        return np.asarray(touches & (np.abs(feet[:, [0, 2]]).max(1) < self.half - np.asarray(reach)))

    def many(self, key: Hashable, shape: Indexed, transforms: Floats, names: Sequence[str]) -> None:
        """Place a shape by transforms (K, 4, 4); shapes with the same key share a mesh."""
        if len(names):
            if key not in self._shapes:
                self._shapes[key] = self._builder.mesh(
                    shape.positions, shape.faces, material=self._materials[shape.materials], colors=shape.colors
                )
            self._builder.place_many(self._shapes[key], transforms, names)

    def once(self, shape: Indexed, x: float, z: float, name: str) -> None:
        """Add the part of a shape, relative to a place, that touches the box; the shape is used nowhere else."""
        corners = shape.positions[shape.faces].astype(np.float64) + np.array([x, 0.0, z])
        touches = (corners.min(1) <= self.high).all(1) & (corners.max(1) >= self.low).all(1)
        touches &= (np.abs(corners[:, :, [0, 2]]) <= self.half).all((1, 2))
        faces, materials = shape.faces[touches], self._materials[shape.materials[touches]]
        if len(faces):
            vertices, numbers = np.unique(faces, return_inverse=True)
            numbers = numbers.reshape(faces.shape).astype(np.uint32)
            self._place(self._builder.mesh(shape.positions[vertices], numbers, material=materials), (x, z), name)

    def tile(self, tile: Tile) -> None:
        """Add the part of a tile's ground and water that touches the box."""
        line = lattice.spacing(tile.level) * np.arange(COUNT + 1.0)
        x, z = (self._overlaps(start + line, axis) for start, axis in zip(tile.corner, (0, 2), strict=True))
        inside = x & z[:, None]
        squares = [tile.height[a : COUNT + a, b : COUNT + b] for a in (0, 1) for b in (0, 1)]
        low, high = np.min(squares, axis=0), np.max(squares, axis=0)
        cells: NDArray[np.bool_] = inside & (low <= self.high[1]) & (high >= self.low[1])
        if cells.any():
            vertices, faces, points = _compact(cells, line, tile.height)
            mesh = self._builder.mesh(
                points,
                faces,
                material=self._ground,
                uvs=points[:, [0, 2]] / np.float32(TEXTURE),
                colors=tile.color.reshape(-1, 4)[vertices],
                normals=tile.normal.reshape(-1, 3)[vertices].astype(np.float32),
            )
            self._place(mesh, tile.corner, f"land_{tile.name}")
        if tile.water is not None and self.low[1] <= 0.0 <= self.high[1]:
            self._pool(tile, tile.water, inside, low < 0.0)

    def _pool(self, tile: Tile, colors: NDArray[np.uint8], inside: NDArray[np.bool_], wet: NDArray[np.bool_]) -> None:
        # The surface is flat, so fine grids are replaced by squares up to four cells wide.
        wide = max(1, 4 >> tile.level)
        count = COUNT // wide
        squares = [np.asarray(flags.reshape(count, wide, count, wide).any((1, 3))) for flags in (wet, inside)]
        cells = squares[0] & squares[1]
        if cells.any():
            line = wide * lattice.spacing(tile.level) * np.arange(count + 1.0)
            vertices, faces, points = _compact(cells, line, np.zeros((count + 1, count + 1)))
            colors = colors[::wide, ::wide].reshape(-1, 4)[vertices]
            mesh = self._builder.mesh(points, faces, material=self._water, colors=colors)
            self._place(mesh, tile.corner, f"water_{tile.name}")

    def _place(self, mesh: int, corner: tuple[float, float], name: str) -> None:
        """Add an instance of a mesh whose origin is at x and z."""
        self._builder.instance(mesh, placements(corner[0], 0.0, corner[1])[0], name=name)

    def _overlaps(self, line: Floats, axis: int) -> NDArray[np.bool_]:
        """Whether intervals between neighbours on a line along an axis touch the box and lie in the world."""
        start, end = line[:-1], line[1:]
        touches = (start <= self.high[axis]) & (end >= self.low[axis])
        return np.asarray(touches & (start >= -self.half) & (end <= self.half))

    def scene(self) -> Scene:
        return self._builder.build()


def _compact(
    cells: NDArray[np.bool_], line: Floats, height: Floats
) -> tuple[NDArray[np.int64], NDArray[np.uint32], NDArray[np.float32]]:
    """Mesh of some cells (n, n) of a grid with lines at `line` along x and z and heights (n + 1, n + 1).

    Returns the numbers (V,) of the vertices that the cells use, two faces for each cell, split along the same diagonal,
    and the vertices' positions (V, 3).
    """
    n = len(cells)
    j, i = np.nonzero(cells)
    corners = (j * (n + 1) + i)[:, None] + np.array([0, n + 2, 1, 0, n + 1, n + 2])
    used = np.zeros((n + 1) * (n + 1), bool)
    used[corners] = True
    vertices, numbers = np.flatnonzero(used), np.cumsum(used) - 1
    points = xyz(line[vertices % (n + 1)], height.reshape(-1)[vertices], line[vertices // (n + 1)])
    return vertices, numbers[corners].reshape(-1, 3).astype(np.uint32), points.astype(np.float32)
