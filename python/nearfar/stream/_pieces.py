"""A scene whose large objects are divided into pieces, so that rings contain only their near parts."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._scene.names import Names, distinct
from nearfar._scene.scene import Scene
from nearfar.stream._tiles import objects_of, tiles_of

MIN_FACES = 10_000
"""Least number of faces of a divided object; fewer take 8 ms at 50 Mbit/s."""

MIN_EXTENT = 20.0
"""Least horizontal extent of a divided object, metres: the diameter of the first ring."""

MIN_SIDE = 8.0
"""Least side of a piece, metres: less than the radius of the first ring."""

PIECE_FACES = 16
"""Mean number of faces per piece if they are spread evenly over the object's extent."""


def divide(scene: Scene) -> Scene:
    """Return the scene with its large static objects divided into square pieces, which are objects of their own.

    Only the object numbers of faces change: neighbouring pieces share the positions and normals of their border. A face
    belongs to the piece of its centroid. One piece keeps the object's number and name, the others follow the last
    object. Faces without an object are divided like an object. Meshes with several placements stay whole, and so do
    scenes with levels, whose objects have separate meshes.
    """
    if scene.leveled is not None:
        return scene
    parts, count = _core.scene_parts(scene._core), len(scene.object_names)
    rows = _unshared_rows(scene._core, parts["standing_count"])
    owners = {row: objects_of(parts, row) for row in rows}
    sizes = np.zeros(count + 1, np.int64)
    for row, numbers in owners.items():
        if len(numbers) == 1:
            sizes[int(numbers[0]) + 1] += parts["meshes"][row].face_count
        else:
            objects_of_row, faces = np.unique(numbers, return_counts=True)
            sizes[objects_of_row + 1] += faces
    is_large = sizes >= MIN_FACES
    rows = [row for row in rows if is_large[owners[row] + 1].any()]
    if not rows:
        return scene
    meshes = [_core.mesh_parts(parts["meshes"][row]) for row in rows]
    centroids = np.concatenate(
        [_centroids(mesh, parts["placements"][row]) for row, mesh in zip(rows, meshes, strict=True)]
    )
    objects = np.concatenate(
        [np.broadcast_to(owners[row], len(mesh["faces"])) for row, mesh in zip(rows, meshes, strict=True)]
    )
    names = list[str]()
    large = np.flatnonzero(is_large) - 1
    order = np.argsort(objects, kind="stable")
    starts, ends = (np.searchsorted(objects[order], large, side) for side in ("left", "right"))
    for number, start, end in zip(large.tolist(), starts.tolist(), ends.tolist(), strict=True):
        members = order[start:end]
        if np.ptp(centroids[members], axis=0).max() < MIN_EXTENT:
            continue
        tiles = tiles_of(centroids[members], len(members), mean_faces=PIECE_FACES, min_side=MIN_SIDE)
        _, piece = np.unique(tiles, return_inverse=True)
        objects[members] = np.where(piece == 0, number, count + len(names) + piece - 1)
        title = scene.object_names[number] if number >= 0 else "faces without an object"
        names += [f"{title}, piece {n}" for n in range(2, int(piece.max()) + 2)]
    if not names:
        return scene
    ends = np.cumsum([len(mesh["faces"]) for mesh in meshes])
    for row, mesh, numbers in zip(rows, meshes, np.split(objects, ends[:-1]), strict=True):
        arrays = {name: value for name, value in mesh.items() if name not in ("positions", "faces", "objects")}
        parts["meshes"][row] = _core.Mesh(mesh["positions"], mesh["faces"], objects=numbers, **arrays)
        parts["objects"][row] = -1
    all_names = Names(distinct([*scene.object_names, *names]))
    arguments = scene._arguments | {"load_placements": scene._load_placements}
    return Scene(_core.Scene(parts), all_names, **arguments)


def _unshared_rows(core: _core.Scene, standing_count: int) -> list[int]:
    """Return the rows of the static instances whose meshes no other instance shares."""
    ids = core.mesh_ids()
    _, inverse, uses = np.unique(ids, return_inverse=True, return_counts=True)
    return np.flatnonzero(uses[inverse][:standing_count] == 1).tolist()


def _centroids(mesh: dict[str, NDArray[np.float32]], placement: NDArray[np.float64]) -> NDArray[np.float32]:
    """Return the horizontal position (F, 2) of the centroid of each face."""
    points = mesh["positions"] @ placement[[0, 2], :3].T + placement[[0, 2], 3]
    return np.asarray(points[mesh["faces"]].mean(axis=1), np.float32)
