"""A scene whose largest mesh is divided into tiles, so that making a region costs as much as its surroundings."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._scene.scene import Scene

MIN_FACES = 1_000_000
"""Least number of faces of a divided mesh; smaller meshes are searched in milliseconds."""

TILE_FACES = 10_000
"""Mean number of faces per tile if they are spread evenly over the mesh's extent."""

MIN_SIDE = 128.0
"""Least side of a tile, metres: about the diameter of most rings."""

MAX_TILES_PER_SIDE = 250
"""Greatest number of tiles per side, so that tile numbers fit 16 bits, which numpy sorts by radix."""

UNDIVIDED = np.iinfo(np.uint16).max
"""Tile number of faces that are not divided."""

REACH_MARGIN = 1.001
"""Safety factor on a reach, for boxes that are rounded to float32."""

Arrays = dict[str, Any]
"""Mesh arrays as `_core.mesh_parts` returns them."""


@dataclass(frozen=True, eq=False)
class Tiles:
    """A scene whose largest mesh is replaced by square tiles of whole objects.

    Kernels first test the bounding boxes of instances, and then every face of instances that they cannot cull. A city
    in one mesh is a single instance, so nothing is culled. Here each tile beyond the rings about a centre counts as one
    object, so that kernels skip its faces.
    """

    scene: Scene
    """The scene: the same triangles in another order, and the same objects."""
    parts: dict[str, Any]
    """Arguments of the scene's core; the first instances are the tiles."""
    boxes: NDArray[np.float64]
    """World bounding boxes of the tiles (T, 2, 3); empty if nothing was divided."""
    objects: NDArray[np.int32]
    """Number of one object of each tile, (T,)."""

    @classmethod
    def divide(cls, scene: Scene) -> Tiles:
        """Divide the largest static mesh with per-face objects, if it has at least `MIN_FACES`.

        Objects with parts in other meshes and faces without an object are not divided. Scenes with levels stay as they
        are, because their objects have separate meshes.
        """
        parts = {} if scene.leveled is not None else _core.scene_parts(scene._core)
        row = _largest_row(parts)
        if row is None:
            return cls(scene, {}, np.zeros((0, 2, 3)), np.zeros(0, np.int32))
        meshes = parts["meshes"]
        others = [number for number in range(len(meshes)) if number != row]
        is_divisible = np.ones(len(scene.object_names) + 1, bool)
        # The last entry, index −1, is for faces without an object.
        is_divisible[-1] = False
        for number in others:
            is_divisible[objects_of(parts, number)] = False
        tiles, undivided = _divide_mesh(_core.mesh_parts(meshes[row]), is_divisible)
        pieces = [mesh for mesh, _ in tiles] + undivided
        parts |= {
            "meshes": pieces + [meshes[number] for number in others],
            "placements": np.concatenate([np.tile(np.eye(4)[:3], (len(pieces), 1, 1)), parts["placements"][others]]),
            "objects": np.concatenate([np.full(len(pieces), -1, np.int32), parts["objects"][others]]),
            "standing_count": parts["standing_count"] + len(pieces) - 1,
        }
        boxes = np.array([mesh.bounds() for mesh, _ in tiles]).reshape(-1, 2, 3) + parts["origin"]
        divided = scene._derived(_core.Scene(parts), scene._load_placements)
        return cls(divided, parts, boxes, np.array([number for _, number in tiles], np.int32))

    def scene_about(self, center: tuple[float, float, float], reach: float) -> Scene:
        """Return the scene for rings within a reach in metres about a centre: each tile beyond it counts as one object.

        Scenes with textures, which would be copied for each region, are returned unchanged.
        """
        if not len(self.boxes) or self.parts["textures"]:
            return self.scene
        offsets = np.maximum(np.maximum(self.boxes[:, 0] - center, center - self.boxes[:, 1]), 0.0)
        far_tiles = np.flatnonzero(np.hypot(offsets[:, 0], offsets[:, 2]) > REACH_MARGIN * reach)
        objects = self.parts["objects"].copy()
        objects[far_tiles] = self.objects[far_tiles]
        return self.scene._derived(_core.Scene(self.parts | {"objects": objects}), self.scene._load_placements)


def _largest_row(parts: dict[str, Any]) -> int | None:
    """Return the row of the instance to divide: untransformed, with per-face objects; None if there is none."""
    meshes, static = parts.get("meshes", []), range(parts.get("standing_count", 0))
    rows = [row for row in static if parts["objects"][row] < 0 and meshes[row].face_count >= MIN_FACES]
    rows = [row for row in rows if np.array_equal(parts["placements"][row], np.eye(4)[:3])]
    return max(rows, key=lambda row: meshes[row].face_count, default=None)


def objects_of(parts: dict[str, Any], row: int) -> NDArray[np.int32]:
    """Return the objects of an instance, −1 for faces without one."""
    instance_object = parts["objects"][row : row + 1]
    is_one = instance_object[0] >= 0
    return np.asarray(instance_object if is_one else _core.mesh_parts(parts["meshes"][row])["objects"])


def _divide_mesh(
    arrays: Arrays, is_divisible: NDArray[np.bool_]
) -> tuple[list[tuple[_core.Mesh, int]], list[_core.Mesh]]:
    """Divide a mesh; return tiles, each with the number of one of its objects, and the mesh of the undivided faces."""
    faces, objects = arrays["faces"], arrays["objects"]
    # An object's position is the first vertex of its last face.
    positions = np.full((len(is_divisible), 2), np.nan, np.float32)
    positions[objects] = arrays["positions"][faces[:, 0]][:, [0, 2]]
    is_tiled = is_divisible & np.isfinite(positions[:, 0])
    tile_of = np.full(len(is_divisible), UNDIVIDED, np.uint16)
    tile_of[is_tiled] = tiles_of(positions[is_tiled], len(faces), mean_faces=TILE_FACES, min_side=MIN_SIDE)
    tile = tile_of[objects]
    order = np.argsort(tile, kind="stable")
    numbers = np.zeros(len(arrays["positions"]), np.uint32)
    tiles, undivided = [], []
    for tile_faces in np.split(order, np.flatnonzero(np.diff(tile[order])) + 1):
        mesh = _extract_faces(arrays, tile_faces, numbers)
        if tile[tile_faces[0]] == UNDIVIDED:
            undivided.append(mesh)
        else:
            tiles.append((mesh, int(objects[tile_faces[0]])))
    return tiles, undivided


def tiles_of(positions: NDArray[np.float32], faces: int, *, mean_faces: int, min_side: float) -> NDArray[np.int64]:
    """Return the tile number of each horizontal position (N, 2) in metres, row-major.

    Tiles are squares with sides of at least `min_side` metres, so large that a tile has `mean_faces` of the `faces` or
    more on average.
    """
    if not len(positions):
        return np.zeros(0, np.int64)
    low, size = positions.min(axis=0), np.ptp(positions, axis=0).astype(np.float64)
    side = max(min_side, math.sqrt(size.prod() * mean_faces / faces), size.max() / MAX_TILES_PER_SIDE)
    column, row = ((positions - low) / side).astype(np.int64).T
    return np.asarray(row * (MAX_TILES_PER_SIDE + 1) + column)


def _extract_faces(arrays: Arrays, part_faces: NDArray[np.int64], numbers: NDArray[np.uint32]) -> _core.Mesh:
    """Extract a mesh of some faces and their vertices; `numbers` is scratch space for all vertices."""
    corners = arrays["faces"][part_faces].ravel()
    order = np.arange(len(corners), dtype=np.uint32)
    numbers[corners] = order
    used = corners[numbers[corners] == order]
    numbers[used] = order[: len(used)]
    optional = {name: arrays[name] for name in ("uvs", "colors", "normals")}
    return _core.Mesh(
        arrays["positions"][used],
        numbers[corners].reshape(-1, 3),
        **{name: None if values is None else values[used] for name, values in optional.items()},
        objects=arrays["objects"][part_faces],
        materials=arrays["materials"][part_faces],
    )
