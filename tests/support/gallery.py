"""A long hall with similar but distinct places, and a bundle with a region at each of them."""

from __future__ import annotations

from pathlib import Path

import numpy as np

import nearfar as nf
from tests.support import normal_cases

STEP = 3.0
"""Metres between places, and between the centres of regions."""
EYE = 1.6
RADII = (2.5, 6.0)


def center(place: int) -> tuple[float, float, float]:
    return (STEP * place, EYE, 0.0)


def gallery(places: int) -> nf.Scene:
    """A hall with, at each place, a distinct picture, two copies of a distinct mesh, and a copy of a shared mesh.

    Meshes are large enough to be files.
    """
    draw = np.random.default_rng(0)
    builder = nf.SceneBuilder()
    vertices, faces = normal_cases.ball(3)
    shared = builder.mesh(vertices, faces, normals=vertices, material=builder.material(base_color=(0.7, 0.3, 0.1, 1)))
    gray = builder.material(base_color=(0.5, 0.5, 0.55, 1))
    uvs = np.array([[0, 0], [1, 0], [1, 1], [0, 1]])
    corners = np.column_stack([uvs * (2, 1.5), np.zeros(4)])
    for place in range(places):
        x, _, _ = center(place)
        image = np.full((32, 32, 4), 255, np.uint8)
        image[..., :3] = draw.integers(0, 256, (32, 32, 3))
        picture = builder.mesh(corners, [[0, 1, 2], [0, 2, 3]], material=builder.material(texture=image), uvs=uvs)
        builder.instance(picture, _translation(x - 1, 0.8, -2.2), name=f"picture {place}")
        stone = builder.mesh(vertices * draw.uniform(0.2, 0.35, vertices.shape), faces, material=gray)
        builder.instance(stone, _translation(x - 0.8, 0.4, 1.4), name=f"stone {place}")
        builder.instance(stone, _translation(x + 0.9, 0.4, 1.6), name=f"other stone {place}")
        builder.instance(shared, _translation(x, 0.5, 2.8), name=f"ball {place}")
        tile = builder.mesh([[-1.5, 0, -3], [-1.5, 0, 3], [1.5, 0, 3], [1.5, 0, -3]], [[0, 1, 2], [0, 2, 3]])
        builder.instance(tile, _translation(x, 0, 0), name=f"floor {place}")
    builder.instance(shared, _translation(1.0, 2.5, -1.0), name="moving ball")
    return builder.build(dynamic=["moving ball"])


def export(places: int, folder: Path) -> nf.stream.Bundle:
    """The hall with a region at each place."""
    centers = [center(place) for place in range(places)]
    return nf.stream.export(gallery(places), folder, center=centers, radii=RADII, face_size=64, samples=1)


def _translation(x: float, y: float, z: float) -> np.ndarray:
    place = np.eye(4)
    place[:3, 3] = x, y, z
    return place
