"""Scenes, poses and settings at which the page's pictures are compared with those of nearfar."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

import nearfar as nf
from tests.support import data
from tests.support.reduce_cases import box

HELMET = "objects/gltf/FlightHelmet/FlightHelmet.gltf"
TOKYO = "city/tokyo23/tokyo_core_lod1.glb"


@dataclass(frozen=True)
class PageScene:
    """A scene with the centre and radii of its bundle, and its viewpoints."""

    make: Callable[[], nf.Scene]
    center: tuple[float, float, float]
    radii: tuple[float, ...]
    poses: tuple[tuple[tuple[float, float, float], float, float], ...]
    """Metres from the centre, yaw and pitch in radians."""
    shown: tuple[tuple[int, float, float], ...]
    """Rings, radii and strengths."""


def helmet_room() -> nf.Scene:
    """A helmet on a box in a room, whose floor, ceiling and walls have two triangles each.

    The floor has a texture that repeats. Wall 3 has the same image, clamped, mirrored and unfiltered.
    """
    import trimesh

    builder = nf.SceneBuilder()
    loaded: Any = trimesh.load(data(HELMET))
    for name, shape in loaded.geometry.items():
        texture = shape.visual.material.baseColorTexture.resize((512, 512))
        material = builder.material(texture=np.asarray(texture.convert("RGBA")))
        uvs = np.array(shape.visual.uv)
        uvs[:, 1] = 1 - uvs[:, 1]
        mesh = builder.mesh(shape.vertices, shape.faces, uvs=uvs, normals=shape.vertex_normals, material=material)
        place = np.diag([1.5, 1.5, 1.5, 1.0])
        place[:3, 3] = 0.9, 0.8, -1.4
        builder.instance(mesh, place, name=name)
    tiles = (np.indices((64, 64)).sum(0) // 8 % 2 * 90 + 120).astype(np.uint8)
    wood = np.stack([tiles, tiles * 0.8, tiles * 0.6, np.full((64, 64), 255)], -1).astype(np.uint8)
    floor = builder.material(texture=wood)
    clamped = builder.material(texture=wood.copy())
    wall = builder.material(base_color=(0.7, 0.68, 0.6, 1))
    square = np.array([[0, 0], [1, 0], [1, 1], [0, 1]])
    faces = [[0, 1, 2], [0, 2, 3]]

    def quad(corner: Any, u: Any, v: Any, material: Any, name: str, uvs: Any = None) -> None:
        corners = np.array(corner, float) + square[:, :1] * np.array(u) + square[:, 1:] * np.array(v)
        builder.instance(builder.mesh(corners, faces, material=material, uvs=uvs), name=name)

    quad((-3, 0, 2.5), (6, 0, 0), (0, 0, -5), floor, "floor", square * (4.0, 3.0))
    quad((-3, 2.7, -2.5), (6, 0, 0), (0, 0, 5), wall, "ceiling")
    quad((-3, 0, -2.5), (6, 0, 0), (0, 2.7, 0), wall, "wall 0")
    quad((3, 0, 2.5), (-6, 0, 0), (0, 2.7, 0), wall, "wall 1")
    quad((-3, 0, 2.5), (0, 0, -5), (0, 2.7, 0), wall, "wall 2")
    quad((3, 0, -2.5), (0, 0, 5), (0, 2.7, 0), clamped, "wall 3", square * (3.0, 2.0) - 1.0)
    quad((0.5, 0.8, -1.0), (0.8, 0, 0), (0, 0, -0.8), wall, "box top")
    quad((0.5, 0, -1.0), (0.8, 0, 0), (0, 0.8, 0), wall, "box front")
    quad((0.5, 0, -1.8), (0, 0, 0.8), (0, 0.8, 0), wall, "box side")
    scene = builder.build()
    parts = nf._core.scene_parts(scene._core)
    parts["texture_samplers"][parts["material_textures"][clamped]] = 33071, 33648, 9728
    return scene._derived(nf._core.Scene(parts), scene._load_placements)


def lamps() -> nf.Scene:
    """A floor, and boxes within and between radii: unlit with a texture, bright with one, with and without normals."""
    builder = nf.SceneBuilder()
    rows, columns = np.indices((64, 64))
    stripes = np.stack([2 * rows, 3 * columns + 60, 255 - 2 * rows, np.full((64, 64), 255)], -1).astype(np.uint8)
    dots = np.where(np.hypot(rows % 16 - 8, columns % 16 - 8)[..., None] < 6, 255, 20).astype(np.uint8)
    windows = np.concatenate([np.tile(dots, (1, 1, 3)), np.full((64, 64, 1), 255, np.uint8)], -1)
    floor = builder.material(base_color=(0.5, 0.55, 0.6, 1))
    kinds = [
        builder.material(texture=stripes, unlit=True),
        builder.material((0.3, 0.3, 0.35, 1), stripes, emission=(1.6, 0.7, 0.2), emission_texture=windows),
        builder.material((0.2, 0.2, 0.2, 1), emission=(0.1, 0.5, 0.2)),
        builder.material((0.1, 0.1, 0.1, 1), emission=(0.4, 0.6, 1.0), emission_texture=windows),
    ]
    corners, faces = box((-12, -0.2, -12), (12, 0, 12))
    builder.instance(builder.mesh(corners, faces, material=floor), name="floor")
    for number in range(12):
        angle, away = 2.1 * number, 1.2 + 0.3 * number
        corners, faces = box((-0.3, 0, -0.3), (0.3, 2.4, 0.3))
        uvs = corners[:, [0, 1]] + corners[:, [2, 2]] * 0.7
        normals = corners * (1, 0, 1) if number % 3 == 0 else None
        mesh = builder.mesh(corners, faces, material=kinds[number % 4], uvs=uvs, normals=normals)
        matrix = np.eye(4)
        matrix[:3, 3] = away * np.sin(angle), 0.0, away * np.cos(angle)
        builder.instance(mesh, matrix, name=f"lamp {number}")
    return builder.build()


PAGE_SCENES = {
    "city": PageScene(
        lambda: nf.datasets.city(blocks=3, detail=1),
        (3.0, 1.7, -2.0),
        (10.0, 22.0, 63.0),
        (((0.8, 0.1, -0.4), 0.3, -0.1), ((-0.5, 0.0, 0.9), 2.0, -0.1), ((0.0, 0.0, 0.0), 4.4, -0.1)),
        ((1, 10.0, 0.6), (2, 15.0, 1.0), (3, 63.0, 1.0)),
    ),
    "tokyo": PageScene(
        lambda: nf.Scene.load(data(TOKYO)),
        (115.0, 1.7, 192.15),
        (30.0, 50.0, 90.0),
        (((0.8, 0.1, -0.4), 0.3, 0.1), ((-0.5, 0.0, 0.9), 2.0, 0.1), ((2.0, 0.0, 1.0), 4.4, 0.1)),
        ((1, 30.0, 0.6), (2, 40.0, 1.0), (3, 90.0, 1.0)),
    ),
    "lamps": PageScene(
        lamps,
        (0.0, 1.6, 0.0),
        (1.5, 2.5, 4.0),
        (((0.2, 0.05, -0.3), -0.5, -0.25), ((-0.3, 0.0, 0.2), 2.0, -0.2), ((0.1, -0.1, 0.4), 4.4, -0.2)),
        ((1, 1.5, 0.6), (2, 2.0, 1.0), (3, 4.0, 1.0)),
    ),
    "helmet": PageScene(
        helmet_room,
        (0.0, 1.6, 0.0),
        (1.5, 2.5, 4.0),
        (((0.2, 0.05, -0.3), -0.5, -0.25), ((-0.3, 0.0, 0.2), 2.0, -0.3), ((0.1, -0.1, 0.4), 4.4, -0.2)),
        ((1, 1.5, 0.6), (2, 2.0, 1.0), (3, 4.0, 1.0)),
    ),
}
