"""Skins of glTF meshes: vertices and normals as the joints' rest pose places them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base.errors import UnusableError
from nearfar._base.glb import entry
from nearfar._scene.budget import Budget
from nearfar._scene.gltf import nodes
from nearfar._scene.gltf.buffers import Buffers

_VERTEX_BYTES = 2 * 12 * 8
"""Bytes per vertex of the weighted sum of matrices and of one summand."""

_INFLUENCES, _MATRIX = 4, 16
"""Joints in each row of JOINTS_n, and numbers of a matrix."""

Floats = NDArray[np.float64]


class Skins:
    """Matrices of a document's skins; `budget` counts the arrays."""

    def __init__(self, header: dict[str, Any], buffers: Buffers, budget: Budget) -> None:
        self._header, self._buffers, self._budget = header, buffers, budget
        self._joints: dict[int, Floats] = {}
        self._world: Floats | None = None
        self._held_bytes = 0

    def vertex_matrices(
        self, skin: int, attributes: Mapping[str, int], rows_of: Callable[[str, int, int], NDArray[Any]]
    ) -> Floats:
        """Transforms (V, 3, 4) from a mesh to the scene: weighted means of the joints' matrices (glTF 2.0, 3.7.3).

        `rows_of` returns the rows of an attribute by name, accessor and width, with weights as fractions. Weights count
        relative to their sum; vertices without weights follow their first joint, as in three.js and Blender.
        """
        joints = self._matrices(skin)
        weight_sets = [name for name in attributes if name.startswith("WEIGHTS_")]
        joint_sets = [name.replace("WEIGHTS", "JOINTS") for name in weight_sets]
        indices = np.concatenate([rows_of(name, attributes[name], _INFLUENCES) for name in joint_sets], axis=1)
        weights = np.concatenate([rows_of(name, attributes[name], _INFLUENCES) for name in weight_sets], axis=1)
        size = len(indices) * _VERTEX_BYTES + weights.size * 8
        # The arrays are freed after each mesh, so only those of the largest mesh count.
        self._budget.count_arrays(max(0, size - self._held_bytes))
        self._held_bytes = max(self._held_bytes, size)
        weights = weights.astype(np.float64)
        total = weights.sum(axis=1)
        weights[total == 0] = np.eye(1, weights.shape[1])
        weights /= np.where(total == 0, 1, total)[:, None]
        is_used = weights != 0
        if indices.dtype.kind != "u" or (is_used.any() and int(indices[is_used].max()) >= len(joints)):
            raise UnusableError(f"a vertex refers to none of the {len(joints)} joints of its skin {skin}")
        indices = np.where(is_used, indices, 0)
        matrices = np.zeros((len(indices), 3, 4))
        for joint, weight in zip(indices.T, weights.T, strict=True):
            matrices += joints[joint] * weight[:, None, None]
        return matrices

    def _matrices(self, skin: int) -> Floats:
        """Matrices (J, 3, 4) of a skin's joints: the rest pose after the inverse bind matrix."""
        if skin not in self._joints:
            skin_entry = entry(self._header, "skins", skin)
            for joint in skin_entry["joints"]:
                entry(self._header, "nodes", joint)
            if self._world is None:
                self._world = nodes.rest_transforms(self._header)
            matrices = self._world[skin_entry["joints"]]
            if "inverseBindMatrices" in skin_entry:
                rows = self._buffers.raw(skin_entry["inverseBindMatrices"]).astype(np.float64)
                if len(rows) < len(matrices) or rows.shape[1] != _MATRIX:
                    got = f"{len(rows)} inverse bind matrices of {rows.shape[1]} numbers"
                    raise UnusableError(f"its skin {skin} has {len(matrices)} joints, but {got}")
                matrices = matrices @ rows[: len(matrices)].reshape(-1, 4, 4).transpose(0, 2, 1)
            self._joints[skin] = matrices[:, :3]
        return self._joints[skin]


def transform_vertices(matrices: Floats, vertices: NDArray[Any]) -> Floats:
    """Transform vertices (V, 3), each by its matrix (V, 3, 4)."""
    return np.asarray(np.einsum("nij,nj->ni", matrices[:, :, :3], vertices) + matrices[:, :, 3])


def transform_normals(matrices: Floats, normals: NDArray[Any]) -> Floats:
    """Transform normals (V, 3) by the inverse transposes of the matrices (V, 3, 4), up to a positive factor."""
    first, second, third = np.moveaxis(matrices[:, :, :3], 2, 0)
    cofactors = np.stack([np.cross(second, third), np.cross(third, first), np.cross(first, second)], axis=2)
    side = np.where(np.einsum("ni,ni->n", first, cofactors[:, :, 0]) < 0, -1.0, 1.0)
    return np.asarray(np.einsum("nij,nj->ni", cofactors, normals) * side[:, None])
