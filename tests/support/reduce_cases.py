"""The street for tests of near–far reduction: ground, a wall across both radii, a near box, a far tower."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from nearfar._scene.builder import SceneBuilder

CENTER = np.array([3.0, 1.7, -2.0])


R1, R2 = 30.0, 50.0


FOV = nf.Fov.symmetric(90, 16 / 9)


SIZE = (160, 90)


ALL = ("color", "range", "object_id", "face_id", "position", "normal")


Array = NDArray[np.float64]


def box(low: tuple[float, float, float], high: tuple[float, float, float]) -> tuple[Array, NDArray[np.uint32]]:
    """Vertices and faces of a box, counter-clockwise from outside."""
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    faces = [[f for a, b, c, d in quads for f in ((a, b, c), (a, c, d))]]
    return np.array(low) + corners * np.subtract(high, low), np.array(faces[0], np.uint32)


def street(*, dynamic: bool = False, ground: bool = True) -> nf.Scene:
    """Return ground of two triangles, a wall across both radii, a near box, a far tower, and maybe a car."""
    build = SceneBuilder()
    extent = 2000.0
    if ground:
        plane = [[-extent, 0, -extent], [-extent, 0, extent], [extent, 0, extent], [extent, 0, -extent]]
        grey = build.material((0.3, 0.3, 0.3, 1))
        build.instance(build.mesh(plane, [[0, 1, 2], [0, 2, 3]], material=grey), name="ground")
    for name, low, high, color in [
        ("wall", (5, 0, -25), (120, 15, -20), (0.7, 0.4, 0.3, 1)),
        ("near", (10, 0, 12), (13, 4, 15), (0.2, 0.6, 0.3, 1)),
        ("tower", (100, 0, 60), (120, 70, 80), (0.3, 0.4, 0.8, 1)),
        ("car", (-1, -0.75, -2), (1, 0.75, 2), (0.9, 0.1, 0.1, 1)),
    ]:
        if name != "car" or dynamic:
            build.instance(build.mesh(*box(low, high), material=build.material(color)), name=name)
    return build.build(dynamic=["car"] if dynamic else [])


def place(x: float = 0.0, y: float = 0.0, z: float = 0.0) -> Array:
    matrix = np.eye(4)
    matrix[:3, 3] = x, y, z
    return matrix


def camera(user: Array, toward: tuple[float, float, float], size: tuple[int, int] = SIZE) -> nf.Camera:
    return nf.Camera.look_at(user, user + np.array(toward), fov=FOV, size=size)


def rho(position: NDArray[Any]) -> Array:
    away = position.astype(np.float64) - CENTER
    return np.asarray(np.hypot(away[..., 0], away[..., 2]))
