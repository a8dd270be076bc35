"""A scene as plain arrays and back: what travels to other processes, and what hashes of content are made of."""

from __future__ import annotations

from typing import Any

import numpy as np

from nearfar import _core


def parts_of(core: _core.Scene) -> dict[str, Any]:
    """All that is drawn of a scene, in arrays, numbers and containers of them; shared meshes stand once."""
    parts = _core.scene_parts(core)
    first, shared = np.unique(core.mesh_ids(), return_index=True, return_inverse=True)[1:]
    # By their first use: identities are addresses, whose order is chance.
    order = np.argsort(first)
    meshes = parts.pop("meshes")
    listed = [_core.mesh_parts(meshes[number]) for number in first[order]]
    return parts | {"meshes": listed, "mesh_of": np.argsort(order)[shared]}


def core_of_parts(parts: dict[str, Any]) -> _core.Scene:
    """The scene that `parts_of` took apart: it is drawn the same, byte for byte."""
    given = dict(parts)
    meshes = [_core.Mesh(mesh["positions"], mesh["faces"], **_attributes(mesh)) for mesh in given.pop("meshes")]
    return _core.Scene(meshes=[meshes[number] for number in given.pop("mesh_of")], **given)


def _attributes(mesh: dict[str, Any]) -> dict[str, Any]:
    return {name: values for name, values in mesh.items() if name not in ("positions", "faces")}
