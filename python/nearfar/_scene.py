"""The scene: what files, trimesh and the procedural datasets become, and what every stage reads."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core


class Scene:
    """An immutable scene; see `Scene.from_arrays`."""

    def __init__(self, core: _core.Scene, object_names: tuple[str, ...]) -> None:
        self._core = core
        self._object_names = object_names

    @classmethod
    def from_arrays(cls, vertices: ArrayLike, faces: ArrayLike, face_object: ArrayLike | None = None) -> Scene:
        """Make a scene of one mesh."""
        positions: NDArray[Any] = np.ascontiguousarray(vertices, np.float32)
        indices: NDArray[Any] = np.ascontiguousarray(faces, np.uint32)
        objects = 0 if face_object is None else np.ascontiguousarray(face_object, np.int32)
        count = 1 if face_object is None else int(np.max(objects, initial=-1)) + 1
        mesh = _core.Mesh(positions, indices, objects=objects, materials=0)
        core = _core.Scene(
            origin=(0.0, 0.0, 0.0),
            meshes=[mesh],
            placements=np.eye(4)[None, :3],
            objects=np.full(1, -1, np.int32),
            standing_count=1,
            material_colors=np.array([[0.8, 0.8, 0.8, 1.0]], np.float32),
            material_textures=np.array([-1], np.int32),
            material_cutoffs=np.array([np.nan], np.float32),
            textures=[],
        )
        return cls(core, tuple(f"object_{i}" for i in range(count)))
