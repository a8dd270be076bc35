"""The base of a simplification: all parts of a scene as one surface, and its charts."""

from __future__ import annotations

import os
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import background, check
from nearfar._scene.names import Names
from nearfar._scene.scene import Scene
from nearfar.lod._simplify.normals import smooth_normals

if TYPE_CHECKING:
    import trimesh

Array = NDArray[Any]
Normals = Literal["keep", "smooth", "flat"]

ATTRIBUTES = ("uvs", "colors", "normals")
"""Attributes of vertices."""

_NUMBERED_BY_INSTANCE = -1
"""Object number of a mesh whose faces belong to the object of the mesh's instance."""


@dataclass(frozen=True, eq=False)
class Surface:
    """Triangles with the attributes of their vertices."""

    positions: NDArray[np.float32]
    """(V, 3) relative to the scene's origin."""
    faces: NDArray[np.uint32]
    """(F, 3)."""
    materials: NDArray[np.int32]
    """Index of each face's material (F,) among the scene's materials."""
    attributes: dict[str, Array] = field(default_factory=dict)
    """Attributes (V, 2) uvs, (V, 4) colors, (V, 3) normals, as far as present."""

    def with_vertices(self, vertices: Array, faces: Array, materials: Array) -> Surface:
        """Return a surface with a subset of the vertices, by index, and with other faces (F, 3) or (3 F,)."""
        return Surface(
            np.ascontiguousarray(self.positions[vertices]),
            np.ascontiguousarray(faces.reshape(-1, 3), np.uint32),
            np.ascontiguousarray(materials),
            {key: np.ascontiguousarray(values[vertices]) for key, values in self.attributes.items()},
        )


class Base:
    """One object: its surface, and the scene with the materials and textures of its levels."""

    def __init__(
        self, mesh: Scene | trimesh.Trimesh | trimesh.Scene | str | os.PathLike[str], name: str | None = None
    ) -> None:
        scene = _scene_of(mesh)
        if name is not None:
            check.instance("name", name, str, "a string")
        if not scene.triangle_count:
            raise ValueError("mesh: expected triangles, got none")
        only = _only_object(scene)
        self.name = name or _name_of(mesh, scene, only)
        self.frame = np.eye(4) if only is None else scene._pose(only)
        """Matrix (4, 4) from the object's own frame to the scene's."""
        self._notes_and_undrawn: dict[str, Any] = {"notes": scene.report.notes, "undrawn": scene._undrawn}
        self._core = scene._core
        parts = _core.mesh_parts(self._core.merged())
        attributes = {key: parts[key] for key in ATTRIBUTES if parts.get(key) is not None}
        self.surface = Surface(parts["positions"], parts["faces"], parts["materials"], attributes)

    def with_normals(self, kind: Normals) -> None:
        """Keep existing normals ("keep"), compute smooth ones ("smooth") or remove them ("flat")."""
        surface = self.surface
        if kind == "smooth":
            faces, normals = smooth_normals(surface.positions, surface.faces, self.places)
            rows, vertex = np.unique(faces, return_inverse=True)
            origin = np.empty(len(normals), np.int64)
            origin[faces.ravel()] = surface.faces.ravel()
            smooth = surface.with_vertices(origin[rows], vertex, surface.materials)
            attributes = smooth.attributes | {"normals": np.ascontiguousarray(normals[rows])}
            self.surface = replace(smooth, attributes=attributes)
            del self.places
        elif kind == "flat":
            other_attributes = {key: value for key, value in surface.attributes.items() if key != "normals"}
            self.surface = replace(surface, attributes=other_attributes)

    @cached_property
    def places(self) -> NDArray[np.uint32]:
        """For each vertex (V,) the index of the first vertex at the same place."""
        return first_alike(self.surface.positions)

    @cached_property
    def scene(self) -> Scene:
        """The unsimplified object, as level 0."""
        return self.scene_of(self.surface)

    def scene_of(self, surface: Surface) -> Scene:
        """Make a scene with the object's name and another surface; materials and textures are shared."""
        mesh = _core.Mesh(
            surface.positions,
            surface.faces,
            objects=_NUMBERED_BY_INSTANCE,
            materials=surface.materials,
            **surface.attributes,
        )
        return Scene(self._core.of_mesh(mesh), Names([self.name]), **self._notes_and_undrawn)


def _scene_of(mesh: Scene | trimesh.Trimesh | trimesh.Scene | str | os.PathLike[str]) -> Scene:
    if isinstance(mesh, Scene):
        return mesh
    if isinstance(mesh, str | os.PathLike):
        return Scene.load(check.path("mesh", mesh))
    trimesh = background.module("trimesh")
    if isinstance(mesh, trimesh.Trimesh | trimesh.Scene):
        return Scene.from_trimesh(mesh)
    raise TypeError(f"mesh: expected a Scene, a mesh or scene of trimesh, or a path, got {type(mesh).__name__}")


def _only_object(scene: Scene) -> int | None:
    """Return the number of the object that owns all triangles; None if there is no such object."""
    parts = _core.scene_parts(scene._core)
    owners: set[int] = set()
    for mesh, number in zip(parts["meshes"], parts["objects"].tolist(), strict=True):
        if mesh.face_count:
            owners |= {number} if number >= 0 else set(np.unique(_core.mesh_parts(mesh)["objects"]).tolist())
    return owners.pop() if len(owners) == 1 and min(owners) >= 0 else None


def _name_of(mesh: object, scene: Scene, only: int | None) -> str:
    if isinstance(mesh, str | os.PathLike):
        return Path(mesh).stem
    return "object" if only is None else scene.object_names[only]


def first_alike(*columns: Array) -> NDArray[np.uint32]:
    """Return for each row the index of the first row with equal numbers; −0 equals 0."""
    rows = [np.ascontiguousarray(column + column.dtype.type(0)) for column in columns]
    flat = [row.view(np.uint8).reshape(len(row), -1) for row in rows]
    return _core.first_alike(np.ascontiguousarray(np.concatenate(flat, axis=1)))


def box_of(points: NDArray[np.float64]) -> tuple[NDArray[np.float64], float]:
    """Return least corner and longest side of the points' bounding box; the side is 1 for no points or one place."""
    if not len(points):
        return np.zeros(3), 1.0
    low, high = points.min(axis=0), points.max(axis=0)
    return low, float((high - low).max()) or 1.0


def charts_of(surface: Surface, *attributes: str) -> tuple[NDArray[np.int64], NDArray[np.uint32]]:
    """Number vertices by place, attributes and material; faces that share numbers are in one chart.

    Only `attributes` are compared. Returns for each number (N,), used or not, the index of a vertex of the surface, and
    the faces (F, 3) with these numbers.
    """
    first = first_alike(surface.positions, *(surface.attributes[key] for key in attributes))
    faces = np.ascontiguousarray(first[surface.faces])
    if (surface.materials == surface.materials[0]).all():
        return np.arange(len(surface.positions)), faces
    # A vertex may have faces of two materials, so corners of faces are numbered instead.
    corners = np.repeat(surface.materials, 3).view(np.uint32)
    number = first_alike(np.column_stack([faces.ravel(), corners])).reshape(-1, 3)
    return surface.faces.ravel().astype(np.int64), number
