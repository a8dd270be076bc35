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
    """Material and attributes shared by groups of stored faces."""

    materials: Sequence[BaseColor]
    """One material; empty means the plain one."""
    has_normals: bool
    has_uvs: bool
    has_colors: bool

    @property
    def is_textured(self) -> bool:
        """Whether the texture coordinates are used."""
        return self.has_uvs and any(material.is_textured for material in self.materials)

    @property
    def drawn_material(self) -> BaseColor:
        """Material that the faces are drawn with."""
        (material,) = self.materials or (UNCOLORED if self.has_colors else PLAIN,)
        return material if self.is_textured else material.without_textures()


@dataclass(frozen=True)
class Stored:
    """Meshes in the bytes of a source; their faces form groups of equal surface."""

    core: _core.StoredMeshes
    """The meshes; their material numbers are indices into `surfaces`."""
    names: Sequence[str]
    """Names of the meshes' shapes."""
    mesh: NDArray[np.int64]
    """Mesh of each group of faces (G,), ascending."""
    surface: NDArray[np.int64]
    """Surface of each group of faces (G,)."""
    surfaces: Sequence[Surface]

    def with_materials(self, materials: Sequence[Sequence[BaseColor]]) -> Stored:
        """Copy with other materials for the surfaces."""
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
