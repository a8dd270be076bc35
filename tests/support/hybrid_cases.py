"""A rig with asymmetric eyes, its head in a street, and scenes that its plane passes through."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from nearfar.hmd import Eye
from nearfar.stereo import HybridRig
from tests.support.reduce_cases import place, street

Image = NDArray[np.float64]

HEAD = (3.0, 1.7, -2.0)


def towards(eye: Any, target: Any) -> tuple[float, float, float, float]:
    """Orientation of a head that looks at a target."""
    return nf.Camera.look_at(eye, target, fov=nf.Fov.symmetric(90), size=(1, 1)).orientation


AHEAD = towards(HEAD, (9.0, 1.5, -9.0))
SHALLOW = 12.0
"""A mono plane that passes through the street's near box, wall and ground, metres."""


def rig(
    mono_plane: float | tuple[float, float] = SHALLOW, size: tuple[int, int] = (96, 80), cant: float = 0.0
) -> HybridRig:
    """Asymmetric eyes, optionally rotated outwards by an angle in degrees."""
    half = math.radians(cant) / 2.0

    def eye(fov: nf.Fov, x: float, side: float) -> Eye:
        return Eye(fov, (x, 0.01, -0.02), (0.0, side * math.sin(half), 0.0, math.cos(half)))

    left, right = eye(nf.Fov(-1.2, 0.9, -1.0, 1.1), -0.031, 1.0), eye(nf.Fov(-0.9, 1.2, -1.0, 1.1), 0.033, -1.0)
    return HybridRig(left=left, right=right, mono_plane=mono_plane, size=size)


def cut(rig: HybridRig, begin: float, end: float) -> nf.Clip:
    """The part of space between two depths ahead of the eyes."""
    _, _, center = rig.cameras(HEAD, AHEAD)
    ahead = rotate(AHEAD, (0.0, 0.0, -1.0))
    eyes = np.array(center.position) + rig.center_offset * ahead
    planes = [(*ahead, -ahead @ eyes - begin)]
    return nf.Clip(planes=[*planes, (*-ahead, ahead @ eyes + end)] if math.isfinite(end) else planes)


def rotate(orientation: tuple[float, ...], v: tuple[float, float, float]) -> NDArray[np.float64]:
    x, y, z, w = orientation
    u = np.array((x, y, z))
    return np.asarray(v + 2.0 * np.cross(u, np.cross(u, v) + w * np.array(v)))


def places(rig: HybridRig, side: str) -> Image:
    """Positions (H, W, 2) in the third camera's picture of the centres of an eye's pixels."""
    width, height = rig.size
    x, y = np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5)
    at = np.stack([x, y, np.ones_like(x)], -1) @ np.linalg.inv(rig.homography(side)).T
    return np.asarray(at[..., :2] / at[..., 2:])


def scene() -> nf.Scene:
    return street(dynamic=True).at({"car": place(7.0, 0.75, -8.0)})


def textured() -> nf.Scene:
    """Return a room whose far wall has a fine pattern, with a post in front of the plane and one beyond it."""
    import trimesh
    from PIL import Image as Pictures

    codes = np.random.default_rng(5).integers(0, 255, (64, 64, 3), np.uint8)
    wall = trimesh.creation.box((60.0, 30.0, 1.0))
    uv = np.asarray(wall.vertices)[:, :2] / 6.0
    wall.visual = trimesh.visual.TextureVisuals(uv=uv, image=Pictures.fromarray(codes))
    wall.apply_translation((8.0, 5.0, -32.0))
    posts = trimesh.util.concatenate(
        [
            trimesh.creation.box((0.4, 6.0, 0.4)).apply_translation(at)
            for at in ((5.0, 1.0, -6.0), (8.0, 1.0, -20.0), (14.0, 1.0, -14.0))
        ]
    )
    world = trimesh.Scene()
    world.add_geometry(wall, node_name="wall")
    world.add_geometry(posts, node_name="posts")
    return nf.Scene.from_trimesh(world)
