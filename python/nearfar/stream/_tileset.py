"""Near part of a bundle as a 3D Tiles 1.1 tileset for other programs' viewers, with a tile for each ring's GLB.

Tilesets are z-up; viewers rotate the y-up content of glTF by (x, y, z) → (x, −z, y) (3D Tiles 1.1, "glTF
transforms"), so boxes are rotated here and content is not.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import formats, glb
from nearfar._base.version import __version__
from nearfar._scene.budget import Budget
from nearfar._scene.gltf import nodes
from nearfar._scene.gltf.buffers import Buffers

VERSION = "1.1"
"""Version of 3D Tiles."""

GRID = 2.0**-10
"""Step in metres. Boxes are enlarged to its multiples by at least one step, so that flat boxes get a volume and the
bytes do not depend on the rounding of sums."""

_TO_Z_UP = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])


def encode(
    center: Sequence[float],
    rings: Sequence[Mapping[str, Any]],
    dynamic: Mapping[str, Any] | None,
    content: Mapping[str, bytes],
) -> bytes:
    """Encode `tileset.json`, given the manifest entries of rings and of dynamic objects, and the files by name.

    Entries with geometry become tiles, dynamic objects in the pose in which they were loaded. The box of a tileset
    without geometry lies at the centre (world position, metres).
    """
    entries = [(entry, {"ring": number, "radius": entry["radius"]}) for number, entry in enumerate(rings)]
    entries += [] if dynamic is None else [(dynamic, {"dynamic": True})]
    tiles = [(entry["geometry"], facts) for entry, facts in entries if entry["geometry"] is not None]
    boxes = [box_of(content[name]) for name, _ in tiles]
    root_box = _union(boxes) if boxes else np.array([center, center])
    # The root itself shows nothing, so its error is the extent of all tiles.
    error = float(np.ceil(np.linalg.norm(root_box[1] - root_box[0])))
    root: dict[str, Any] = {"boundingVolume": _volume(root_box), "geometricError": error, "refine": "ADD"}
    if tiles:
        root["children"] = [
            {"boundingVolume": _volume(box), "geometricError": 0.0, "content": {"uri": name}, "extras": facts}
            for (name, facts), box in zip(tiles, boxes, strict=True)
        ]
    asset = {"version": VERSION, "extras": {"generator": f"nearfar {__version__}"}}
    return formats.to_json({"asset": asset, "geometricError": error, "root": root}, compact=True).encode()


def box_of(data: bytes) -> NDArray[np.float64]:
    """Return the box (2, 3) in glTF's axes, metres, around all placed meshes of a GLB, which has at least one."""
    document, end = glb.header(data)
    budget = Budget(len(data) << 20)  # our own file
    buffers = Buffers(document, glb.binary(data, end), None, budget)
    meshes = {number: [str(number)] for number in range(len(document["meshes"]))}
    placed = nodes.place_nodes(document, meshes, nodes.instance_transforms(document, buffers, budget))
    local = np.array([_mesh_box(document, mesh) for mesh in document["meshes"]])[[int(name) for name in placed.shapes]]
    linear, offset = placed.transforms[:, :3, :3], placed.transforms[:, :3, 3]
    middle = np.einsum("nij,nj->ni", linear, local.mean(axis=1)) + offset
    half_size = np.einsum("nij,nj->ni", np.abs(linear), np.ptp(local, axis=1) / 2)
    return np.array([(middle - half_size).min(axis=0), (middle + half_size).max(axis=0)])


def _mesh_box(document: dict[str, Any], mesh: dict[str, Any]) -> NDArray[np.float64]:
    accessors = [document["accessors"][primitive["attributes"]["POSITION"]] for primitive in mesh["primitives"]]
    return _union([np.array([accessor["min"], accessor["max"]], np.float64) for accessor in accessors])


def _union(boxes: Sequence[NDArray[np.float64]]) -> NDArray[np.float64]:
    return np.array([np.min(boxes, axis=0)[0], np.max(boxes, axis=0)[1]])


def _volume(box: NDArray[np.float64]) -> dict[str, list[float]]:
    """Return a z-up bounding volume: the centre, then the half-axes."""
    corners = np.stack([np.floor(box[0] / GRID) - 1, np.ceil(box[1] / GRID) + 1]) * GRID @ _TO_Z_UP.T
    half_size = np.ptp(corners, axis=0) / 2
    return {"box": [*corners.mean(axis=0).tolist(), *np.diag(half_size).ravel().tolist()]}
