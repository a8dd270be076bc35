"""Assembles a scene from arrays of one mesh."""

from __future__ import annotations

from collections.abc import Sequence

from numpy.typing import ArrayLike

from nearfar._base import background, check
from nearfar._scene.arrays import object_count_of
from nearfar._scene.assembly import Assembled, Assembly


def one_mesh(
    vertices: ArrayLike, faces: ArrayLike, face_object: ArrayLike | None, names: Sequence[str] | None, *, copy: bool
) -> Assembled:
    """Assemble a scene of one mesh; its faces belong to one object, or to the objects given by `face_object`."""
    assembly = Assembly()

    def assemble() -> Assembled:
        positions = check.array("vertices", vertices)
        if face_object is None:
            assembly.objects(names or ["object_0"])
            mesh = assembly.mesh(positions, faces, copy=copy)
            assembly.instance(mesh, name=names[0] if names else "object_0")
        else:
            assembly.objects(object_count_of("face_object", face_object) if names is None else names)
            assembly.instance(assembly.mesh(positions, faces, face_object=face_object, copy=copy))
        return assembly._assemble()

    # NumPy takes seconds for arrays of gigabytes, in functions that signals cannot interrupt.
    return background.run(assemble)
