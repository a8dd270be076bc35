"""Dynamic objects of a bundle: encoded as rings are, and posed with the transforms that they were loaded with."""

from __future__ import annotations

from typing import Any

import numpy as np

from nearfar import _core
from nearfar._base import check, formats
from nearfar._scene.glb import placement_of
from nearfar._scene.moving_rows import frames_of, nodes_of
from nearfar._scene.names import Names
from nearfar._scene.scene import Scene
from nearfar.stream._decode import Read, ring_scene


def moving_scene(entry: dict[str, Any], read: Read, location: str) -> Scene:
    """Read the dynamic objects; FormatError that names the file if it is damaged or does not fit its manifest entry.

    Meshes come from the glTF reader; placements are taken from the document itself, so that they stay bit-exact.
    """
    name = entry["geometry"]
    loaded = ring_scene(name, entry["parts"], read, location, moves=True)
    with formats.guarded(location):
        origin, nodes = nodes_of(read(name))
        rows = check.items("instances", entry["instances"], dict, "descriptions of instances")
        if not len(rows) == len(nodes) == len(loaded._names):
            raise ValueError(f"expected {len(rows)} dynamic objects, got {len(nodes)}")
        placements = np.array([placement_of(node) for node in nodes])
        if not np.isfinite(placements).all():
            raise ValueError("expected finite matrices")
        names = Names(tuple(dict.fromkeys(str(row["object"]) for row in rows)))
        frames, at_load = frames_of(rows, names, placements, location)
        parts = {
            **_core.scene_parts(loaded._core),
            "origin": origin,
            "meshes": _merged_meshes(loaded._core),
            "placements": placements,
            "objects": np.array([names.number("object", row["object"]) for row in rows], np.int32),
        }
        core = _core.Scene(parts)
        if not np.abs(core.bounds()).max() <= check.FARTHEST:
            raise ValueError(f"expected positions up to {check.FARTHEST:g} m")
        return Scene(core, names, frames=frames, load_placements=at_load, notes=loaded._notes, undrawn=loaded._undrawn)


def _merged_meshes(core: _core.Scene) -> list[_core.Mesh]:
    """Return one mesh per object, merged from the reader's meshes, one per material; objects share meshes as before."""
    owner, meshes = core.moving_objects(), _core.scene_parts(core)["meshes"]
    order = np.argsort(owner, kind="stable")
    objects = np.split(order, np.flatnonzero(np.diff(owner[order])) + 1)
    keys = [tuple(core.mesh_ids()[rows].tolist()) for rows in objects]
    merged = dict[tuple[int, ...], _core.Mesh]()
    for key, rows in zip(keys, objects, strict=True):
        if key not in merged:
            parts, placements = [meshes[row] for row in rows], np.tile(np.eye(4)[:3], (len(rows), 1, 1))
            is_one = len(rows) == 1
            merged[key] = parts[0] if is_one else _core.Mesh.merged(parts, placements, np.zeros(len(rows), np.int32))
    return [merged[key] for key in keys]
