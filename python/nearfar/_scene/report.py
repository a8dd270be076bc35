"""What a scene holds, and what of its source was dropped or is not drawn."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from nearfar import _core


@dataclass(frozen=True)
class Report:
    """Contents of a scene; `str` makes it readable."""

    triangles: int
    """Triangles of all instances."""
    meshes: int
    """Distinct meshes; everything that is used once counts as one merged mesh."""
    instances: int
    """Placed meshes, standing and dynamic."""
    objects: int
    """Names that faces or instances can belong to."""
    dynamic: int
    """Instances that `Scene.at` can pose."""
    materials: int
    """Distinct base colours."""
    textures: int
    """Distinct images."""
    degenerate_faces: int
    """Faces of the meshes without an area: kept, never seen."""
    dropped_faces: int
    """Faces left out because of non-finite or missing vertices (``on_invalid="drop"``)."""
    notes: tuple[str, ...] = ()
    """What of the source is ignored or drawn otherwise, a sentence each."""

    @classmethod
    def of(cls, core: _core.Scene, objects: int, dynamic: int, dropped: int, notes: tuple[str, ...]) -> Report:
        """Count a scene's parts."""
        return cls(
            triangles=core.triangle_count,
            meshes=len(np.unique(core.mesh_ids())),
            instances=core.instance_count,
            objects=objects,
            dynamic=dynamic,
            materials=core.material_count,
            textures=core.texture_count,
            degenerate_faces=core.degenerate_count(),
            dropped_faces=dropped,
            notes=notes,
        )

    def __str__(self) -> str:
        counts = [
            f"{count(self.triangles, 'triangle')} in {count(self.instances, 'instance')}"
            f" of {count(self.meshes, 'mesh', 'meshes')}",
            f"{count(self.objects, 'object')}, {count(self.dynamic, 'dynamic instance')}",
            f"{count(self.materials, 'material')}, {count(self.textures, 'texture')}",
        ]
        if self.degenerate_faces:
            counts.append(f"{count(self.degenerate_faces, 'face')} without an area")
        if self.dropped_faces:
            counts.append(f"{count(self.dropped_faces, 'unusable face')} dropped")
        return "\n".join([*counts, *self.notes])


def count(number: int, noun: str, plural: str = "") -> str:
    """Put a number before its noun, in the plural where it takes one."""
    return f"{number:,} {noun if number == 1 else plural or noun + 's'}"
