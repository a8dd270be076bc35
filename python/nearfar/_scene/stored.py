"""Meshes of a source that the core reads from the source's bytes, without an array for each."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._scene.looks import Look
from nearfar._scene.materials import PLAIN, UNCOLORED, BaseColor


@dataclass(frozen=True)
class Surface:
    """Material and attributes that groups of stored faces share."""

    materials: Sequence[BaseColor]
    """One, or none for the plain one."""
    has_normals: bool
    has_uvs: bool
    has_colors: bool

    @property
    def is_textured(self) -> bool:
        """Whether the texture coordinates are used."""
        return self.has_uvs and any(material.is_textured for material in self.materials)

    @property
    def drawn(self) -> BaseColor:
        """The material that faces are drawn with."""
        (material,) = self.materials or (UNCOLORED if self.has_colors else PLAIN,)
        return material if self.is_textured else material.without_textures()


@dataclass(frozen=True)
class Stored:
    """Meshes in the bytes of a source, each of faces of some surfaces."""

    core: _core.StoredMeshes
    """The meshes; numbers of materials are those of `surfaces`."""
    names: Sequence[str]
    """Names of the meshes' shapes."""
    mesh: NDArray[np.int64]
    """For each of the faces' groups (G,) its mesh, ascending."""
    surface: NDArray[np.int64]
    """For each of the faces' groups (G,) its surface."""
    surfaces: Sequence[Surface]

    def with_materials(self, materials: Sequence[Sequence[BaseColor]]) -> Stored:
        """The same with other materials of the surfaces."""
        surfaces = [replace(one, materials=chosen) for one, chosen in zip(self.surfaces, materials, strict=True)]
        return replace(self, surfaces=surfaces)

    def looks(self, placed: NDArray[np.bool_]) -> list[Look]:
        """Attributes and materials of the placed meshes, for reports; `placed` (M,) marks them."""
        mine = placed[self.mesh]
        numbers = np.bincount(self.surface[mine], minlength=len(self.surfaces)).tolist()
        see_through = [0] * len(self.surfaces)
        if any(surface.has_colors for surface in self.surfaces):
            rows = self.surface[mine & self.core.see_through()]
            see_through = np.bincount(rows, minlength=len(self.surfaces)).tolist()
        return [
            Look(number, one.materials, one.has_normals, one.has_uvs, one.has_colors, clear)
            for one, number, clear in zip(self.surfaces, numbers, see_through, strict=True)
            if number
        ]
