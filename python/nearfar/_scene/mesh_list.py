"""Meshes of a scene under construction: first those stored in a file's bytes, then those made of arrays."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import check

_MAX_VERTICES = 2**32 - 2**16
"""Greatest number of vertices of a merged mesh, whose indices have 32 bits."""


@dataclass(frozen=True)
class _Made:
    core: _core.Mesh
    base: NDArray[np.float64]
    """Whole metres (3,) subtracted from the vertices."""
    has_objects: bool


class MeshList:
    """Numbers meshes and creates the kernels' meshes, one by one or merged."""

    def __init__(self) -> None:
        self._stored: _core.StoredMeshes | None = None
        self._first = 0
        """Number of stored meshes, which is the handle of the first other mesh."""
        self._made: list[_Made] = []

    def __len__(self) -> int:
        return self._first + len(self._made)

    def store(self, stored: _core.StoredMeshes) -> None:
        """Add meshes of a file, before any other; their handles are their numbers."""
        assert not len(self)
        self._stored, self._first = stored, len(stored.face_counts())

    def add(self, core: _core.Mesh, base: NDArray[np.float64], *, has_objects: bool) -> int:
        """Add a mesh relative to its base (3,) in metres, and return its handle."""
        self._made.append(_Made(core, base, has_objects))
        return len(self) - 1

    def has_objects(self, handle: int) -> bool:
        """Whether a mesh has an object number for each face."""
        if not len(self):
            raise ValueError("mesh: expected a handle of this builder, which has no mesh yet")
        number = check.integer("mesh", handle, 0, len(self) - 1)
        return number >= self._first and self._made[number - self._first].has_objects

    def bases(self) -> NDArray[np.float64]:
        """Bases (M, 3)."""
        made = np.array([mesh.base for mesh in self._made], np.float64).reshape(-1, 3)
        return np.concatenate([np.zeros((self._first, 3)), made])

    def vertex_counts(self) -> NDArray[np.int64]:
        """Numbers of vertices (M,)."""
        stored = np.zeros(0, np.int64) if self._stored is None else self._stored.vertex_counts()
        return np.concatenate([stored, np.array([mesh.core.vertex_count for mesh in self._made], np.int64)])

    def face_counts(self) -> NDArray[np.int64]:
        """Numbers of faces (M,)."""
        stored = np.zeros(0, np.int64) if self._stored is None else self._stored.face_counts()
        return np.concatenate([stored, np.array([mesh.core.face_count for mesh in self._made], np.int64)])

    def boxes(self) -> NDArray[np.float64]:
        """Boxes (M, 2, 3) relative to the bases, which may include unused vertices; inverted without faces."""
        return self._with_made(np.zeros((0, 2, 3)) if self._stored is None else self._stored.bounds())

    def face_boxes(self) -> NDArray[np.float64]:
        """Exact boxes of the faces (M, 2, 3) relative to the bases, slower than `boxes`; inverted without faces."""
        return self._with_made(np.zeros((0, 2, 3)) if self._stored is None else self._stored.face_bounds())

    def _with_made(self, stored: NDArray[np.float64]) -> NDArray[np.float64]:
        made = np.array([mesh.core.bounds() for mesh in self._made], np.float64).reshape(-1, 2, 3)
        return np.concatenate([stored, made])

    def meshes_by_handle(self, handles: NDArray[np.int64]) -> dict[int, _core.Mesh]:
        """Kernels' meshes by handle; handles may repeat."""
        used = np.unique(handles)
        stored = used[used < self._first]
        meshes = {} if self._stored is None else dict(zip(stored.tolist(), self._stored.meshes(stored), strict=True))
        meshes |= {handle: self._made[handle - self._first].core for handle in used[len(stored) :].tolist()}
        return meshes

    def merge(
        self, handles: NDArray[np.int64], placements: NDArray[np.float64], objects: NDArray[np.int32]
    ) -> list[_core.Mesh]:
        """Merge K meshes with `placements` (K, 3, 4) into one of stored meshes and one of others, or more."""
        is_stored = handles < self._first
        joined = []
        for chosen in (np.flatnonzero(is_stored), np.flatnonzero(~is_stored)):
            for rows in self._groups(chosen, handles):
                if self._stored is not None and is_stored[rows[0]]:
                    joined.append(self._stored.merge(handles[rows], placements[rows], objects[rows]))
                else:
                    meshes = [self._made[handle - self._first].core for handle in handles[rows].tolist()]
                    joined.append(_core.Mesh.merged(meshes, placements[rows], objects[rows]))
        return joined

    def _groups(self, rows: NDArray[np.int64], handles: NDArray[np.int64]) -> list[NDArray[np.int64]]:
        if not len(rows):
            return []
        group = np.cumsum(self.vertex_counts()[handles[rows]]) // _MAX_VERTICES
        return np.split(rows, np.flatnonzero(np.diff(group)) + 1)
