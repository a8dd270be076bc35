"""A scene whose mesh of very many objects is divided by place, so that a region costs what lies near its centre."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._scene.scene import Scene

LEAST_FACES = 1_000_000
"""Faces from which a mesh is divided; smaller ones are looked through in milliseconds."""

TILE_FACES = 10_000
"""Faces of a tile, if they were spread evenly over the mesh's area."""

LEAST_SIDE = 128.0
"""Least side of a tile, metres: what most rings reach on both sides of their centre."""

MOST_ACROSS = 250
"""Most tiles side by side, so that numbers of 16 bits tell all tiles apart: those are sorted without comparisons."""

REST = np.iinfo(np.uint16).max
"""Number of the tile of faces that stay together wherever they are."""

MARGIN = 1.001
"""Factor of a reach, for boxes that are rounded to float32."""

Arrays = dict[str, Any]
"""A mesh as `_core.mesh_parts` returns it."""


@dataclass(frozen=True, eq=False)
class Tiles:
    """A scene in which square tiles of whole objects have taken the place of its largest mesh.

    Kernels look at the boxes of instances first, and then at every face of those that they cannot rule out. A city
    that comes as one mesh is a single instance. About a centre each far tile counts as one object, so that kernels
    need not look at its faces: all of them lie beyond the rings.
    """

    scene: Scene
    """The scene: the same triangles in another order, and the same objects."""
    parts: dict[str, Any]
    """Arguments of its core; the first instances are the tiles."""
    boxes: NDArray[np.float64]
    """World boxes of the tiles (T, 2, 3); none if nothing was divided."""
    objects: NDArray[np.int32]
    """One of the objects of each tile (T,)."""

    @classmethod
    def of(cls, scene: Scene) -> Tiles:
        """Divide the largest static mesh that gives objects to its faces, if it has at least `LEAST_FACES`.

        Its objects that other meshes have parts of, and its faces without an object, stay together. Scenes with levels
        stay as they are: their objects have meshes of their own.
        """
        parts = {} if scene.leveled is not None else _core.scene_parts(scene._core)
        row = _largest(parts)
        if row is None:
            return cls(scene, {}, np.zeros((0, 2, 3)), np.zeros(0, np.int32))
        meshes = parts["meshes"]
        arrays = _core.mesh_parts(meshes[row])
        others = [number for number in range(len(meshes)) if number != row]
        is_own = np.ones(len(scene.object_names) + 1, bool)
        # The last entry, number −1, is that of faces without an object.
        is_own[-1] = False
        for number in others:
            is_own[_objects_of(parts, number)] = False
        tiles, rest = _divided(arrays, is_own)
        made = [mesh for mesh, _ in tiles] + rest
        parts |= {
            "meshes": made + [meshes[number] for number in others],
            "placements": np.concatenate([np.tile(np.eye(4)[:3], (len(made), 1, 1)), parts["placements"][others]]),
            "objects": np.concatenate([np.full(len(made), -1, np.int32), parts["objects"][others]]),
            "standing_count": parts["standing_count"] + len(made) - 1,
        }
        boxes = np.array([mesh.bounds() for mesh, _ in tiles]).reshape(-1, 2, 3) + parts["origin"]
        whole = scene._derived(_core.Scene(**parts), scene._rest)
        return cls(whole, parts, boxes, np.array([number for _, number in tiles], np.int32))

    def about(self, center: tuple[float, float, float], reach: float) -> Scene:
        """The scene for rings of a reach in metres about a centre: tiles beyond it count as one object each.

        With textures, which would be copied for each region, it is the scene itself.
        """
        if not len(self.boxes) or self.parts["textures"]:
            return self.scene
        apart = np.maximum(np.maximum(self.boxes[:, 0] - center, center - self.boxes[:, 1]), 0.0)
        far = np.flatnonzero(np.hypot(apart[:, 0], apart[:, 2]) > MARGIN * reach)
        objects = self.parts["objects"].copy()
        objects[far] = self.objects[far]
        return self.scene._derived(_core.Scene(**{**self.parts, "objects": objects}), self.scene._rest)


def _largest(parts: dict[str, Any]) -> int | None:
    """Row of the instance to divide; its mesh stands in its place, as merged ones do."""
    rows = range(parts.get("standing_count", 0))
    chosen = [row for row in rows if parts["objects"][row] < 0 and parts["meshes"][row].face_count >= LEAST_FACES]
    chosen = [row for row in chosen if np.array_equal(parts["placements"][row], np.eye(4)[:3])]
    return max(chosen, key=lambda row: parts["meshes"][row].face_count, default=None)


def _objects_of(parts: dict[str, Any], row: int) -> NDArray[np.int32]:
    """Objects of an instance, −1 for faces without one."""
    own = parts["objects"][row : row + 1]
    found: NDArray[np.int32] = own if own[0] >= 0 else _core.mesh_parts(parts["meshes"][row])["objects"]
    return found


def _divided(arrays: Arrays, is_own: NDArray[np.bool_]) -> tuple[list[tuple[_core.Mesh, int]], list[_core.Mesh]]:
    """Tiles of the objects that may be divided, each with the number of one object, and the mesh of the others."""
    faces, objects = arrays["faces"], arrays["objects"]
    # An object lies where a corner of its last face does.
    place = np.full((len(is_own), 2), np.nan, np.float32)
    place[objects] = arrays["positions"][faces[:, 0]][:, [0, 2]]
    is_here = is_own & np.isfinite(place[:, 0])
    tile_of = np.full(len(is_own), REST, np.uint16)
    tile_of[is_here] = _tiles_of(place[is_here], len(faces))
    tile = tile_of[objects]
    order = np.argsort(tile, kind="stable")
    sizes = np.bincount(tile, minlength=REST + 1)
    numbers = np.zeros(len(arrays["positions"]), np.uint32)
    tiles, rest, start = [], [], 0
    for number in np.flatnonzero(sizes):
        chosen = order[start : start + sizes[number]]
        start += sizes[number]
        mesh = _part(arrays, chosen, numbers)
        if number == REST:
            rest.append(mesh)
        else:
            tiles.append((mesh, int(objects[chosen[0]])))
    return tiles, rest


def _tiles_of(place: NDArray[np.float32], faces: int) -> NDArray[np.int64]:
    """Number of the tile of each place, row by row."""
    if not len(place):
        return np.zeros(0, np.int64)
    low, size = place.min(axis=0), np.ptp(place, axis=0).astype(np.float64)
    side = max(LEAST_SIDE, math.sqrt(size.prod() * TILE_FACES / faces), size.max() / MOST_ACROSS)
    column, row = ((place - low) / side).astype(np.int64).T
    numbers: NDArray[np.int64] = row * (MOST_ACROSS + 1) + column
    return numbers


def _part(arrays: Arrays, chosen: NDArray[np.int64], numbers: NDArray[np.uint32]) -> _core.Mesh:
    """The mesh of some faces and their vertices; `numbers` has room for a number of each vertex of the whole."""
    corners = arrays["faces"][chosen].ravel()
    places = np.arange(len(corners), dtype=np.uint32)
    numbers[corners] = places
    used = corners[numbers[corners] == places]
    numbers[used] = places[: len(used)]
    taken = {name: arrays[name] for name in ("uvs", "colors", "normals")}
    return _core.Mesh(
        arrays["positions"][used],
        numbers[corners].reshape(-1, 3),
        **{name: None if values is None else values[used] for name, values in taken.items()},
        objects=arrays["objects"][chosen],
        materials=arrays["materials"][chosen],
    )
