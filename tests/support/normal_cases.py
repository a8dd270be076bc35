"""Meshes with vertex normals for tests of pictures."""

from __future__ import annotations

from typing import Any

import numpy as np
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from nearfar._scene.builder import SceneBuilder

Array = NDArray[Any]
TURN = trimesh.transformations.rotation_matrix(0.7, (0.3, 1, -0.2))


PLACES = {
    "as it is": np.eye(4),
    "turned": TURN,
    "unequal": TURN @ np.diag([1.4, 0.5, 0.8, 1.0]) @ TURN.T,
    "mirrored": TURN @ np.diag([1.2, 0.7, -0.9, 1.0]),
}


def ball(subdivisions: int = 1) -> tuple[Array, Array]:
    """Vertices of a unit sphere, which are its normals too, and faces."""
    mesh = trimesh.creation.icosphere(subdivisions)
    vertices = np.asarray(mesh.vertices) / np.linalg.norm(mesh.vertices, axis=1, keepdims=True)
    return vertices.astype(np.float32), np.asarray(mesh.faces, np.uint32)


def scene_around(center: Array) -> nf.Scene:
    """Balls near, between the radii and far, over a flat ground."""
    vertices, faces = ball(2)
    builder = SceneBuilder()
    mesh = builder.mesh(vertices, faces, normals=vertices)
    for number, (distance, scale, side) in enumerate([(6, 1, -0.05), (12, 2, 0.28), (19, 3, 0.6), (33, 5, 0.95)]):
        place = np.diag([scale, 1.3 * scale, -scale if number % 2 else scale, 1.0])
        place[:3, 3] = center + np.array([distance, 0.5 * scale, side * distance])
        builder.instance(mesh, place, name=f"ball {number}")
    corners = np.array([[-1, 0, -1], [-1, 0, 1], [1, 0, 1], [1, 0, -1]]) * 90.0 + center * [1, 0, 1]
    builder.instance(builder.mesh(corners, [[0, 1, 2], [0, 2, 3]]), name="ground")
    return builder.build(dynamic=["ball 1"])


def camera(target: Any = (0, 0, 0), distance: float = 4.0, size: int = 61) -> nf.Camera:
    """A square camera that looks at the target from above and aside."""
    eye = np.asarray(target, float) + distance * np.array([0.35, 0.45, 0.82])
    return nf.Camera.look_at(tuple(eye), tuple(target), fov=nf.Fov.symmetric(35), size=(size, size))


def colors(scene: nf.Scene, view: nf.Camera | None = None) -> Array:
    return nf.render(scene, view or camera()).require("color")


def scene_of(
    vertices: Array, faces: Array, normals: Array | None, *places: Array, dynamic: bool = False, **attributes: Any
) -> nf.Scene:
    """Balls of one mesh, by default a single one at the identity."""
    builder = SceneBuilder()
    mesh = builder.mesh(vertices, faces, normals=normals, copy=True, **attributes)
    for number, place in enumerate(places or (np.eye(4),)):
        builder.instance(mesh, place, name=f"ball {number}")
    return builder.build(dynamic=[f"ball {n}" for n in range(len(places))] if dynamic else ())
