"""Instances of a glTF node placed by arrays: EXT_mesh_gpu_instancing."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base.errors import UnusableError
from nearfar._base.glb import entry
from nearfar._scene.budget import Budget
from nearfar._scene.gltf.buffers import Buffers
from nearfar._scene.gltf.nodes import composed

INSTANCING = "EXT_mesh_gpu_instancing"

_DEFAULTS = {"TRANSLATION": (0.0, 0.0, 0.0), "ROTATION": (0.0, 0.0, 0.0, 1.0), "SCALE": (1.0, 1.0, 1.0)}
"""Defaults of the transform's parts that a file omits."""

_BYTES = 512
"""Bytes of memory per instance: some copies of its transform, its name and its place in the scene."""


def transforms(header: dict[str, Any], buffers: Buffers, budget: Budget) -> dict[int, NDArray[np.float64]]:
    """Transforms instance→node (N, 4, 4), by the index of each node with instances."""
    return {
        number: _of_node(header, number, node["extensions"][INSTANCING]["attributes"], buffers, budget)
        for number, node in enumerate(header.get("nodes", []))
        if "mesh" in node and INSTANCING in node.get("extensions", {})
    }


def _of_node(
    header: dict[str, Any], number: int, attributes: dict[str, Any], buffers: Buffers, budget: Budget
) -> NDArray[np.float64]:
    counts = {name: int(entry(header, "accessors", accessor)["count"]) for name, accessor in attributes.items()}
    if len(set(counts.values())) != 1:
        stated = ", ".join(f"{count} of {name}" for name, count in counts.items()) or "none"
        raise UnusableError(f"expected as many rows of each attribute of the instances of node {number}, got {stated}")
    (count,) = set(counts.values())
    # Many nodes may use the same arrays. A mesh of several primitives is placed once for each of them.
    primitives = entry(header, "meshes", header["nodes"][number]["mesh"])["primitives"]
    budget.hold(max(0, count) * len(primitives) * _BYTES)
    parts = [_rows(name, count, attributes, buffers) for name in _DEFAULTS]
    return composed(*parts)


def _rows(name: str, count: int, attributes: dict[str, Any], buffers: Buffers) -> NDArray[np.float64]:
    """Rows (N, K) of one part of the transforms."""
    default = np.array(_DEFAULTS[name])
    if name not in attributes:
        return np.tile(default, (count, 1))
    rows = buffers.fractions(attributes[name], buffers.raw(attributes[name])).astype(np.float64)
    if rows.shape[1] != len(default):
        raise UnusableError(f"expected {len(default)} numbers in each row of {name}, got {rows.shape[1]}")
    return rows
