"""Meshes of a source that the core reads from the source's bytes, without an array for each."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._scene.materials import BaseColor
from nearfar._scene.report import Look, Surface


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
        surfaces = [replace(old, materials=new) for old, new in zip(self.surfaces, materials, strict=True)]
        return replace(self, surfaces=surfaces)

    def looks(self, placed: NDArray[np.bool_]) -> list[Look]:
        """Attributes and materials of the placed meshes, for reports; `placed` (M,) marks them."""
        is_placed = placed[self.mesh]
        numbers = np.bincount(self.surface[is_placed], minlength=len(self.surfaces)).tolist()
        see_through = [0] * len(self.surfaces)
        if any(surface.has_colors for surface in self.surfaces):
            rows = self.surface[is_placed & self.core.see_through()]
            see_through = np.bincount(rows, minlength=len(self.surfaces)).tolist()
        return [Look(*row) for row in zip(self.surfaces, numbers, see_through, strict=True) if row[1]]
