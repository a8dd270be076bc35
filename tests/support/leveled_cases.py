"""Hand-made models with levels for tests: balls with decreasing numbers of triangles and given curves."""

from __future__ import annotations

import hashlib
from typing import Any

import numpy as np
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from nearfar._scene.builder import SceneBuilder

SIZE = (160, 120)
RED, GREY = (0.8, 0.1, 0.1, 1.0), (0.8, 0.8, 0.8, 1.0)


def ball(
    subdivisions: int,
    stretch: tuple[float, float, float] = (1.0, 1.0, 1.0),
    color: tuple[float, float, float, float] = GREY,
    texture: NDArray[np.uint8] | None = None,
) -> nf.Scene:
    """A sphere of 20 · 4ⁿ triangles about the origin."""
    mesh = trimesh.creation.icosphere(subdivisions)
    vertices = np.asarray(mesh.vertices * stretch, np.float32)
    builder = SceneBuilder()
    builder.material((0.0, 1.0, 0.0, 1.0))  # An unused material, so that numbers differ from scene to scene.
    material = builder.material(color, texture)
    uvs = None if texture is None else vertices[:, :2] * np.float32(0.9)
    builder.instance(builder.mesh(vertices, np.asarray(mesh.faces, np.uint32), material=material, uvs=uvs), name="ball")
    return builder.build()


def curves(count: int) -> nf.lod.Curve4PL:
    """SSIM curves that fall with size, earlier for coarser levels: 1 for tiny objects, 0.6 for the largest."""
    full = np.ones(count)
    middles = 0.2 / np.arange(1, count + 1)
    return nf.lod.Curve4PL(
        full, 1.5 * full, middles, 0.6 * full, 0 * full, np.full(count, "fitted"), np.full(count, "")
    )


def model_from(scenes: list[nf.Scene], name: str = "ball") -> nf.lod.LodModel:
    """A model of scenes, the finest first."""
    ratios = [scene.triangle_count / scenes[0].triangle_count for scene in scenes]
    levels = nf.lod.Levels(
        [
            nf.lod.Level(scene=scene, ratio=ratio, error=0.01 * number, mean_error=0.001 * number, note="ü" * number)
            for number, (scene, ratio) in enumerate(zip(scenes, ratios, strict=True))
        ],
        name=name,
    )
    return nf.lod.LodModel(
        triangles=np.array([level.triangle_count for level in levels]),
        curves=curves(len(levels) - 1),
        center=levels.center,
        radius=levels.radius,
        sigma=(1e-4, 0.3),
        errors=np.array([level.error for level in levels]),
        name=name,
        levels=levels,
        measured={"views": 144},
    )


def model_of(
    subdivisions: tuple[int, ...],
    *,
    name: str = "ball",
    stretch: tuple[float, float, float] = (1.0, 1.0, 1.0),
    color: tuple[float, float, float, float] = GREY,
    texture: NDArray[np.uint8] | None = None,
) -> nf.lod.LodModel:
    """A model of balls, the finest first."""
    return model_from([ball(n, stretch, color, texture) for n in subdivisions], name)


def checkers() -> NDArray[np.uint8]:
    """A checkerboard texture."""
    squares = (np.indices((16, 16)).sum(axis=0) // 2 % 2 * 200 + 30).astype(np.uint8)
    return np.dstack([squares, squares // 2, 255 - squares, np.full_like(squares, 255)])


def frames(count: int, *, seed: int, mirrored: bool = False) -> NDArray[np.float64]:
    """Placements in front of the camera of `view`, rotated and scaled differently along the axes."""
    rng = np.random.default_rng(seed)
    matrices = np.tile(np.eye(4), (count, 1, 1))
    for number, matrix in enumerate(matrices):
        scales = rng.uniform(0.3, 1.2, 3) * (-1 if mirrored and number % 2 else 1)
        turn = trimesh.transformations.random_rotation_matrix(rng.random(3))[:3, :3]
        matrix[:3, :3] = turn @ np.diag(scales)
        matrix[:3, 3] = rng.uniform((-4, -3, -12), (4, 3, -6))
    return matrices


def view(eye: tuple[float, float, float] = (0.0, 0.0, 0.0)) -> nf.Camera:
    """A camera that looks along −z."""
    return nf.Camera(eye, fov=nf.Fov.symmetric(75, SIZE[0] / SIZE[1]), size=SIZE)


def bytes_of(frame: nf.Frame) -> str:
    """Hash of all images except triangle numbers, which depend on the order of instances."""
    digest = hashlib.sha256()
    for name in frame.channels:
        if name != "face_id":
            digest.update(frame.require(name).tobytes())
    return digest.hexdigest()


def same_triangles(one: nf.Scene, other: nf.Scene) -> bool:
    """Whether scenes have the same triangles in any order, with the same orientation."""

    def rows(scene: nf.Scene) -> NDArray[np.float32]:
        corners = scene.triangles() + np.float32(0)  # Avoids −0.
        first = np.array([np.lexsort(triangle.T[::-1])[0] for triangle in corners])
        turned = corners[np.arange(len(corners))[:, None], (first[:, None] + np.arange(3)) % 3].reshape(-1, 9)
        return turned[np.lexsort(turned.T[::-1])]

    return bool(np.array_equal(rows(one), rows(other)))


def mesh_of(builder: SceneBuilder, scene: nf.Scene, material: int) -> int:
    """A mesh with the triangles of a scene, in one material."""
    vertices, faces = np.unique(scene.triangles().reshape(-1, 3), axis=0, return_inverse=True)
    return builder.mesh(vertices, faces.reshape(-1, 3).astype(np.uint32), material=material)


def leveled(scene: nf.Scene) -> Any:
    """The objects with levels of a scene."""
    assert scene.leveled is not None
    return scene.leveled
