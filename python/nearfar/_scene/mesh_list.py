"""Meshes of a scene under construction: first meshes stored in a file's bytes, then meshes made of arrays."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import check

_MAX_VERTICES = 2**32 - 2**16
"""Greatest number of vertices of a merged mesh, whose indices have 32 bits."""

_NO_STORED_MESHES = _core.StoredMeshes([], np.zeros((0, 7), np.int64), np.zeros((0, 7), np.int64))


@dataclass(frozen=True)
class _ArrayMesh:
    core: _core.Mesh
    base: NDArray[np.float64]
    """Whole metres (3,) subtracted from the vertices."""
    has_objects: bool


class MeshList:
    """Numbers meshes and creates the kernels' meshes, one by one or merged."""

    def __init__(self) -> None:
        self._stored_meshes, self._stored_count = _NO_STORED_MESHES, 0
        self._array_meshes: list[_ArrayMesh] = []
        """The first one has the handle `_stored_count`."""

    def __len__(self) -> int:
        return self._stored_count + len(self._array_meshes)

    def store(self, meshes: _core.StoredMeshes) -> None:
        """Add meshes of a file, before any other mesh; their handles count from 0."""
        assert not len(self)
        self._stored_meshes, self._stored_count = meshes, len(meshes.face_counts())

    def add(self, core: _core.Mesh, base: NDArray[np.float64], *, has_objects: bool) -> int:
        """Add a mesh relative to its base (3,) in metres, and return its handle."""
        self._array_meshes.append(_ArrayMesh(core, base, has_objects))
        return len(self) - 1

    def has_objects(self, handle: int) -> bool:
        """Whether a mesh has an object number for each face."""
        if not len(self):
            raise ValueError("mesh: expected a handle of this builder, which has no mesh yet")
        number = check.integer("mesh", handle, 0, len(self) - 1)
        return number >= self._stored_count and self._array_meshes[number - self._stored_count].has_objects

    def bases(self) -> NDArray[np.float64]:
        """Bases (M, 3)."""
        array_bases = np.array([mesh.base for mesh in self._array_meshes], np.float64).reshape(-1, 3)
        return np.concatenate([np.zeros((self._stored_count, 3)), array_bases])

    def vertex_counts(self) -> NDArray[np.int64]:
        """Numbers of vertices (M,)."""
        array_counts = np.array([mesh.core.vertex_count for mesh in self._array_meshes], np.int64)
        return np.concatenate([self._stored_meshes.vertex_counts(), array_counts])

    def face_counts(self) -> NDArray[np.int64]:
        """Numbers of faces (M,)."""
        array_counts = np.array([mesh.core.face_count for mesh in self._array_meshes], np.int64)
        return np.concatenate([self._stored_meshes.face_counts(), array_counts])

    def boxes(self) -> NDArray[np.float64]:
        """Boxes (M, 2, 3) relative to the bases, which may include unused vertices; inverted without faces."""
        return self._append_array_boxes(self._stored_meshes.bounds())

    def face_boxes(self) -> NDArray[np.float64]:
        """Exact boxes of the faces (M, 2, 3) relative to the bases, slower than `boxes`; inverted without faces."""
        return self._append_array_boxes(self._stored_meshes.face_bounds())

    def _append_array_boxes(self, stored_boxes: NDArray[np.float64]) -> NDArray[np.float64]:
        array_boxes = np.array([mesh.core.bounds() for mesh in self._array_meshes], np.float64).reshape(-1, 2, 3)
        return np.concatenate([stored_boxes, array_boxes])

    def meshes_by_handle(self, handles: NDArray[np.int64]) -> dict[int, _core.Mesh]:
        """Kernels' meshes by handle; handles may repeat."""
        unique_handles = np.unique(handles)
        stored, others = np.split(unique_handles, [np.searchsorted(unique_handles, self._stored_count)])
        meshes = dict(zip(stored.tolist(), self._stored_meshes.meshes(stored), strict=True))
        return meshes | {handle: self._array_meshes[handle - self._stored_count].core for handle in others.tolist()}

    def merge(
        self, handles: NDArray[np.int64], placements: NDArray[np.float64], objects: NDArray[np.int32]
    ) -> list[_core.Mesh]:
        """Merge K meshes with `placements` (K, 3, 4) into one of stored meshes and one of others.

        Each is divided where indices of 32 bits do not suffice.
        """
        is_stored = handles < self._stored_count
        merged = []
        for all_rows in (np.flatnonzero(is_stored), np.flatnonzero(~is_stored)):
            for rows in self._groups(all_rows, handles):
                if is_stored[rows[0]]:
                    merged.append(self._stored_meshes.merge(handles[rows], placements[rows], objects[rows]))
                else:
                    meshes = [self._array_meshes[handle - self._stored_count].core for handle in handles[rows].tolist()]
                    merged.append(_core.Mesh.merged(meshes, placements[rows], objects[rows]))
        return merged

    def _groups(self, rows: NDArray[np.int64], handles: NDArray[np.int64]) -> list[NDArray[np.int64]]:
        if not len(rows):
            return []
        group = np.cumsum(self.vertex_counts()[handles[rows]]) // _MAX_VERTICES
        return np.split(rows, np.flatnonzero(np.diff(group)) + 1)
