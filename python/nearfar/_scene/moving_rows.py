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
    """Object of each moving instance, and its load transform and load placement where they are not the defaults.

    Instances without triangles are left out, because GLB files omit them, too.
    """
    rows: list[dict[str, Any]] = []
    owners, placements = scene._core.moving_objects().tolist(), scene._core.moving_placements()
    for owner, rest, placement, mesh in zip(owners, scene._rest, placements, _moving_meshes(scene), strict=True):
        if not mesh.face_count:
            continue
        name = scene.object_names[owner]
        transform = scene.transform(name)
        row: dict[str, Any] = {"object": name}
        if not np.array_equal(transform, np.eye(4)):
            row["transform"] = transform.tolist()
        if not np.array_equal(rest, placement):
            row["rest"] = rest.tolist()
        rows.append(row)
    return rows


def frames_of(
    rows: Sequence[dict[str, Any]], names: Names, placements: NDArray[np.float64], file: str
) -> tuple[NDArray[np.float64] | None, NDArray[np.float64]]:
    """Load transforms of objects by number, and the load placements of a file's moving instances."""
    if len(rows) != len(placements):
        raise ValueError(f"moving: expected {len(placements)} instances as in {file}, got {len(rows)}")
    listed = [row.get("rest", placement) for row, placement in zip(rows, placements, strict=True)]
    rest = np.array(listed, np.float64).reshape(-1, 3, 4)
    numbers = [names.number("moving", row["object"]) for row in rows]
    frames = np.tile(np.eye(4), (max(numbers, default=-1) + 1, 1, 1))
    for number, row in zip(numbers, rows, strict=True):
        transform = np.array(row.get("transform", frames[number]), np.float64)
        if transform.shape != (4, 4):
            raise ValueError(f"moving: expected transforms of 4 × 4 numbers, got shape {transform.shape}")
        frames[number] = transform
    if not (np.isfinite(frames).all() and np.isfinite(rest).all()):
        raise ValueError("moving: expected finite matrices")
    return (frames if (frames != np.eye(4)).any() else None), rest


def rows_of(scene: Scene, data: bytes) -> list[dict[str, Any]]:
    """Describe the nodes of a GLB of a scene's dynamic objects: those that keep faces after rounding of positions.

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
