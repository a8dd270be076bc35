"""Meshes and their placements: chooses which are merged, chooses the origin, and creates the kernels' scene."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._scene.arrays import ORIGIN_LIMIT, origin_for
from nearfar._scene.names import Names

OWN_OBJECTS = -1
"""Object number of an instance whose mesh has an object number for each face."""

_ROW_BYTES = 12
"""Bytes of a vertex position, and of a face."""

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
    """Numbers meshes, and creates meshes for kernels, one by one or merged."""

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

    def boxes(self, *, exact: bool) -> NDArray[np.float64]:
        """Boxes (M, 2, 3) relative to the bases; inverted without faces.

        They are boxes of the faces if `exact`, which is slower; otherwise they may include unused vertices.
        """
        stored_boxes = self._stored_meshes.face_bounds() if exact else self._stored_meshes.bounds()
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
        """Merge K meshes, placed by `placements` (K, 3, 4): all stored ones into a mesh, all others into a mesh.

        A result with too many vertices for 32-bit indices is split.
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


@dataclass(frozen=True)
class Placements:
    """For each of K instances: mesh (K,), transform mesh→world including the mesh's base (K, 4, 4), object (K,)."""

    mesh: NDArray[np.int64]
    transform: NDArray[np.float64]
    object: NDArray[np.int32]

    @classmethod
    def from_columns(
        cls,
        parts: Sequence[tuple[NDArray[np.int64], NDArray[np.float64], NDArray[np.int32]]],
        bases: NDArray[np.float64],
    ) -> Placements:
        """Concatenate columns; transforms get the meshes' bases (M, 3) applied."""
        if not parts:
            return cls(np.zeros(0, np.int64), np.zeros((0, 4, 4)), np.zeros(0, np.int32))
        mesh, transform, numbers = (np.concatenate(column) for column in zip(*parts, strict=True))
        if bases.any():
            transform[:, :3, 3] += np.einsum("kij,kj->ki", transform[:, :3, :3], bases[mesh])
        return cls(mesh, transform, numbers)

    def merges(self, moves: NDArray[np.bool_], names: Names) -> NDArray[np.bool_]:
        """Mask of the instances to merge: static meshes placed once, and those with a singular transform."""
        once = np.bincount(self.mesh, minlength=1)[self.mesh] == 1
        scale = np.abs(self.transform[:, :3, :3]).sum(axis=(1, 2)) ** 3
        # A determinant below 1e-30 of the size cubed is rounding error: float64 has 16 digits on each of three axes.
        flat = np.abs(np.linalg.det(self.transform[:, :3, :3])) <= 1e-30 * scale
        if (flat & moves).any():
            name = names.as_tuple[self.object[np.argmax(flat & moves)]]
            raise ValueError(f"dynamic: expected objects with invertible transforms, got a flat one for {name!r}")
        return np.asarray((once & ~moves) | flat)

    def origin(self, meshes: MeshList) -> NDArray[np.float64]:
        """World position (3,) of the scene's origin."""
        filled = meshes.face_counts()[self.mesh] > 0
        if not filled.any():
            return np.zeros(3)
        # Unused vertices must not move the origin; they are excluded only if it would not be 0.
        if np.abs(self._bounds(filled, meshes.boxes(exact=False))).max() < ORIGIN_LIMIT:
            return np.zeros(3)
        bounds = self._bounds(filled, meshes.boxes(exact=True))
        if (reach := np.abs(bounds).max()) > check.FARTHEST:
            raise ValueError(f"vertices: expected coordinates within ±{check.FARTHEST:g} m, got {reach:g} m")
        return origin_for(bounds)

    def _bounds(self, is_used: NDArray[np.bool_], boxes: NDArray[np.float64]) -> NDArray[np.float64]:
        """Box (2, 3) of the chosen instances of meshes with boxes (M, 2, 3)."""
        # Interval arithmetic; the result is exact if the transform maps axes to axes.
        products = self.transform[is_used, None, :3, :3] * boxes[self.mesh[is_used]][:, :, None, :]
        offsets = self.transform[is_used, :3, 3]
        least = products.min(axis=1).sum(axis=-1) + offsets
        greatest = products.max(axis=1).sum(axis=-1) + offsets
        return np.stack([least.min(axis=0), greatest.max(axis=0)])

    def copied_bytes(self, merged: NDArray[np.bool_], meshes: MeshList) -> int:
        """Bytes of merged copies of meshes, not counting the first copy of each."""
        copies = np.maximum(np.bincount(self.mesh[merged], minlength=len(meshes)) - 1, 0)
        # Python integers, because the counts of malformed files can overflow 64 bits.
        sizes = (meshes.vertex_counts() + meshes.face_counts()).tolist()
        return sum(_ROW_BYTES * size * count for size, count in zip(sizes, copies.tolist(), strict=True) if count)


def core_scene(
    instances: Placements,
    merges: NDArray[np.bool_],
    origin: NDArray[np.float64],
    meshes: MeshList,
    materials: dict[str, Any],
) -> _core.Scene:
    """Create the scene relative to an origin, merged meshes first."""
    placements = instances.transform[:, :3].copy()
    placements[:, :, 3] -= origin
    rows = np.flatnonzero(merges)
    if len(rows) == 1 and np.array_equal(placements[rows[0]], np.eye(4)[:3]):
        rows = rows[:0]  # a single mesh at the identity is used without a copy
        merges = np.zeros_like(merges)
    merged = meshes.merge(instances.mesh[rows], placements[rows], instances.object[rows])
    others = np.flatnonzero(~merges)
    identities = np.broadcast_to(np.eye(4)[:3], (len(merged), 3, 4))
    x, y, z = origin.tolist()
    return _core.Scene(
        {
            "origin": (x, y, z),
            "meshes": merged + _instanced(instances, others, meshes),
            "placements": np.concatenate([identities, placements[others]]),
            "objects": np.concatenate([np.full(len(merged), OWN_OBJECTS, np.int32), instances.object[others]]),
            "standing_count": len(merged) + len(others),
            **materials,
        }
    )


def _instanced(instances: Placements, rows: NDArray[np.int64], meshes: MeshList) -> list[_core.Mesh]:
    """Meshes of instances; mirrored instances get meshes with reversed faces, so that outer sides stay outside."""
    handles = instances.mesh[rows]
    mirrored = np.linalg.det(instances.transform[rows, :3, :3]) < 0
    cores = meshes.meshes_by_handle(handles)
    twins = {handle: cores[handle].flip_faces() for handle in set(handles[mirrored].tolist())}
    pairs = zip(handles.tolist(), mirrored.tolist(), strict=True)
    return [twins[handle] if is_mirrored else cores[handle] for handle, is_mirrored in pairs]
