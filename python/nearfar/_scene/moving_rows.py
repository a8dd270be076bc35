"""Moving instances of a scene as JSON rows, for formats that store their geometry in a GLB."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import check, glb
from nearfar._scene.glb import placement_of
from nearfar._scene.names import Names
from nearfar._scene.scene import Scene


def moving_rows(scene: Scene) -> list[dict[str, Any]]:
    """Return the object of each moving instance, with its load transform and load placement unless they are defaults.

    Instances without triangles are left out, as in GLB files.
    """
    rows: list[dict[str, Any]] = []
    owners, placements = scene._core.moving_objects().tolist(), scene._core.moving_placements()
    columns = owners, scene._load_placements, placements, _moving_meshes(scene)
    for owner, load_placement, placement, mesh in zip(*columns, strict=True):
        if not mesh.face_count:
            continue
        name = scene.object_names[owner]
        transform = scene.transform(name)
        row: dict[str, Any] = {"object": name}
        if not np.array_equal(transform, np.eye(4)):
            row["transform"] = transform.tolist()
        if not np.array_equal(load_placement, placement):
            row["rest"] = load_placement.tolist()
        rows.append(row)
    return rows


def frames_of(
    rows: Sequence[dict[str, Any]], names: Names, placements: NDArray[np.float64], file: str
) -> tuple[NDArray[np.float64] | None, NDArray[np.float64]]:
    """Load transforms of objects by number, and the load placements of a file's moving instances."""
    if len(rows) != len(placements):
        raise ValueError(f"moving: expected {len(placements)} instances as in {file}, got {len(rows)}")
    load_placements = [row.get("rest", placement) for row, placement in zip(rows, placements, strict=True)]
    load_array = np.array(load_placements, np.float64).reshape(-1, 3, 4)
    numbers = [names.number("moving", row["object"]) for row in rows]
    frames = np.tile(np.eye(4), (max(numbers, default=-1) + 1, 1, 1))
    for number, row in zip(numbers, rows, strict=True):
        transform = np.array(row.get("transform", frames[number]), np.float64)
        if transform.shape != (4, 4):
            raise ValueError(f"moving: expected transforms of 4 × 4 numbers, got shape {transform.shape}")
        frames[number] = transform
    if not (np.isfinite(frames).all() and np.isfinite(load_array).all()):
        raise ValueError("moving: expected finite matrices")
    return (frames if (frames != np.eye(4)).any() else None), load_array


def rows_of(scene: Scene, data: bytes) -> list[dict[str, Any]]:
    """Return the rows of `moving_rows` for the nodes of a GLB, which lacks objects that lost all faces by rounding.

    Nodes are in the order of the instances. Instances with equal name and placement are interchangeable.
    """
    placements = scene._core.moving_placements()
    is_filled = [mesh.face_count > 0 for mesh in _moving_meshes(scene)]
    pairs = iter(zip(moving_rows(scene), placements[is_filled], strict=True))
    rows = []
    for node in nodes_of(data)[1]:
        row, placement = next(pairs)
        while row["object"] != node["name"] or not np.array_equal(placement, placement_of(node)):
            row, placement = next(pairs)
        rows.append(row)
    return rows


def nodes_of(data: bytes) -> tuple[tuple[float, float, float], list[dict[str, Any]]]:
    """Origin of a GLB, and its nodes: the children of the first node."""
    root, *nodes = glb.header(data)[0]["nodes"]
    return check.vector("translation", root.get("translation", (0.0, 0.0, 0.0))), nodes


def _moving_meshes(scene: Scene) -> Sequence[_core.Mesh]:
    parts = _core.scene_parts(scene._core)
    meshes: list[_core.Mesh] = parts["meshes"]
    return meshes[parts["standing_count"] :]
