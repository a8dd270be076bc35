"""Converts contents of files to scenes of a source, all in one frame of reference."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nearfar._scene.arrays import origin_for
from nearfar._scene.content import Content, assemble
from nearfar._scene.names import Names
from nearfar._scene.options import LoadOptions
from nearfar._scene.scene import Scene
from nearfar._scene.serialize import empty_core


def scene_of(content: Content, box: NDArray[np.float64], bounds: NDArray[np.float64], options: LoadOptions) -> Scene:
    """Return the triangles of a content that touch a box, in the frame of reference of a world with these bounds."""
    origin = origin_for(bounds)
    if content.stored is None and not any(len(shape.faces) for shape in content.shapes.values()):
        x, y, z = origin.tolist()
        return Scene(empty_core((x, y, z)), Names(()), notes=tuple(content.notes))
    parts = assemble(content, options, origin=origin)
    # Search trees would not pay: this scene is queried only once.
    return Scene._from_assembled(parts)._query(box, builds=False)
