"""Conversion of a scene to plain arrays and back, for other processes and for content hashes."""

from __future__ import annotations

from typing import Any

import numpy as np

from nearfar import _core
from nearfar._scene.material_list import surface_arguments


def parts_of(core: _core.Scene) -> dict[str, Any]:
    """Return all drawn content of a scene as arrays, numbers and containers of them; shared meshes appear once."""
    parts = _core.scene_parts(core)
    first, shared = np.unique(core.mesh_ids(), return_index=True, return_inverse=True)[1:]
    # In order of first use, because mesh identities are addresses, whose order varies between runs.
    order = np.argsort(first)
    meshes = parts.pop("meshes")
    listed = [_core.mesh_parts(meshes[number]) for number in first[order]]
    return parts | {"meshes": listed, "mesh_of": np.argsort(order)[shared]}


def core_of_parts(parts: dict[str, Any]) -> _core.Scene:
    """Rebuild the scene from the result of `parts_of`; its pictures are the same, byte for byte."""
    meshes = [mesh_of(mesh) for mesh in parts["meshes"]]
    return _core.Scene(parts | {"meshes": [meshes[number] for number in parts["mesh_of"]]})


def mesh_of(parts: dict[str, Any]) -> _core.Mesh:
    """Rebuild a mesh from the result of `_core.mesh_parts`."""
    attributes = dict(parts)
    return _core.Mesh(attributes.pop("positions"), attributes.pop("faces"), **attributes)


def empty_core(
    origin: tuple[float, float, float] = (0.0, 0.0, 0.0), surfaces: dict[str, Any] | None = None
) -> _core.Scene:
    """Create a scene without meshes; `surfaces` are its materials and textures, none by default."""
    return _core.Scene(
        {
            "origin": origin,
            "meshes": [],
            "placements": np.zeros((0, 3, 4)),
            "objects": np.zeros(0, np.int32),
            "standing_count": 0,
            **(surface_arguments([], []) if surfaces is None else surfaces),
        }
    )
