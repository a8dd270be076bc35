"""Dynamic objects of a bundle: encoded as rings are, and posed by the transforms that they were loaded with."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import check, formats, glb as binary
from nearfar._scene.moving_rows import frames_of, moving_rows
from nearfar._scene.names import Names
from nearfar._scene.scene import Scene
from nearfar.stream._decode import Read, assembled


def rows_of(scene: Scene, data: bytes) -> list[dict[str, Any]]:
    """Describe the nodes of a GLB of a scene's dynamic objects: those that keep faces when positions are rounded.

    Nodes stand in the order of the instances. Of instances alike in name and placement it does not matter which one a
    node stands for.
    """
    placements = scene._core.moving_placements()
    is_filled = [mesh.face_count > 0 for mesh in _moving_meshes(scene)]
    pairs = iter(zip(moving_rows(scene), placements[is_filled], strict=True))
    rows = []
    for node in _nodes(data)[1]:
        row, placement = next(pairs)
        while row["object"] != node["name"] or not np.array_equal(placement, _placement(node)):
            row, placement = next(pairs)
        rows.append(row)
    return rows


def moving_scene(described: dict[str, Any], read: Read, place: str) -> Scene:
    """The dynamic objects; FormatError that names the file if it is damaged, or does not fit its description.

    Meshes come from the file's reader; placements are taken from the document itself, so that no bit of them changes.
    """
    name = described["geometry"]
    loaded = assembled(name, described["parts"], read, place, moves=True)
    with formats.guarded(place):
        origin, nodes = _nodes(read(name))
        rows = check.items("instances", described["instances"], dict, "descriptions of instances")
        if not len(rows) == len(nodes) == len(loaded.names if not isinstance(loaded.names, int) else ()):
            raise ValueError(f"expected {len(rows)} dynamic objects, got {len(nodes)}")
        placements = np.array([_placement(node) for node in nodes])
        if not np.isfinite(placements).all():
            raise ValueError("expected finite matrices")
        names = Names(tuple(dict.fromkeys(str(row["object"]) for row in rows)))
        frames, rest = frames_of(rows, names, placements, place)
        parts = {
            **_core.scene_parts(loaded.core),
            "origin": origin,
            "meshes": _whole_meshes(loaded.core),
            "placements": placements,
            "objects": np.array([names.number("object", row["object"]) for row in rows], np.int32),
        }
        core = _core.Scene(**parts)
        if not np.abs(core.bounds()).max() <= check.FARTHEST:
            raise ValueError(f"expected positions up to {check.FARTHEST:g} m")
        return Scene(core, names, frames=frames, rest=rest, notes=loaded.notes, undrawn=loaded.undrawn)


def _whole_meshes(core: _core.Scene) -> list[_core.Mesh]:
    """The mesh of each object: of several materials a reader makes a mesh for each. Objects share it as before."""
    owner, meshes = core.moving_objects(), _core.scene_parts(core)["meshes"]
    order = np.argsort(owner, kind="stable")
    groups = np.split(order, np.flatnonzero(np.diff(owner[order])) + 1)
    ids, made, whole = core.mesh_ids(), dict[tuple[int, ...], _core.Mesh](), []
    for rows in groups:
        key = tuple(ids[rows].tolist())
        if key not in made:
            placed = np.tile(np.eye(4)[:3], (len(rows), 1, 1))
            pieces = [meshes[row] for row in rows]
            made[key] = (
                pieces[0] if len(rows) == 1 else _core.Mesh.merged(pieces, placed, np.zeros(len(rows), np.int32))
            )
        whole.append(made[key])
    return whole


def _moving_meshes(scene: Scene) -> Sequence[_core.Mesh]:
    parts = _core.scene_parts(scene._core)
    meshes: list[_core.Mesh] = parts["meshes"]
    return meshes[parts["standing_count"] :]


def _nodes(data: bytes) -> tuple[tuple[float, float, float], list[dict[str, Any]]]:
    """The origin of a GLB and its nodes, which are the children of the first."""
    root, *nodes = binary.header(data)[0]["nodes"]
    return check.vector("translation", root.get("translation", (0.0, 0.0, 0.0))), nodes


def _placement(node: dict[str, Any]) -> NDArray[np.float64]:
    matrix: NDArray[np.float64] = np.array(node.get("matrix", np.eye(4).ravel()), np.float64).reshape(4, 4)
    return matrix.T[:3]
