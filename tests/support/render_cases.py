"""Surfaces and projections for tests of pictures."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

import nearfar as nf
from nearfar._camera.camera import Projection
from nearfar._scene.builder import SceneBuilder
from tests.support.render_oracle import Surface

WIDE = nf.Fov(-1.2, 0.8, -0.5, 0.9)


PROJECTIONS: list[Projection] = [WIDE, nf.Orthographic(-4.0, 3.0, -2.0, 2.5), *(nf.CubeFace(face) for face in range(6))]


QUAD = np.array([[0, 1, 2], [0, 2, 3]])


def noise(*shape: int, seed: int = 0) -> np.ndarray:
    """Pseudo-random bytes: a hash of their index."""
    index = np.arange(int(np.prod(shape)), dtype=np.uint64) + np.uint64(seed << 32)
    mixed = (index * np.uint64(0x9E3779B97F4A7C15)) ^ (index >> np.uint64(7))
    return (mixed * np.uint64(0xBF58476D1CE4E5B9) >> np.uint64(56)).astype(np.uint8).reshape(shape)


def quad(center: ArrayLike, right: ArrayLike, up: ArrayLike) -> np.ndarray:
    c, r, u = (np.array(v, float) for v in (center, right, up))
    return np.array([c - r - u, c + r - u, c + r + u, c - r + u])


def build(surfaces: list[Surface]) -> nf.Scene:
    builder = SceneBuilder()
    for number, surface in enumerate(surfaces):
        material = builder.material(
            surface.base_color,
            surface.texture,
            surface.cutoff,
            emission=surface.emission,
            emission_texture=surface.emission_texture,
            unlit=surface.unlit,
        )
        mesh = builder.mesh(
            surface.vertices.astype(np.float32),
            surface.faces,
            material=material,
            uvs=surface.uvs,
            colors=surface.colors,
        )
        builder.instance(mesh, name=f"surface {number}")
    return builder.build()


def room() -> list[Surface]:
    """A box around the origin with objects: plain, textured, with vertex colours, cut out, unlit, and with emission."""
    corners = np.array([[x, y, z] for x in (-8, 8) for y in (-3, 5) for z in (-7, 9)], np.float32).astype(float)
    sides = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    box = np.array([[s[0], s[a], s[a + 1]] for s in sides for a in (1, 2)])
    uvs = np.array([[-1.0, -0.5], [1.5, -0.5], [1.5, 2.0], [-1.0, 2.0]])
    return [
        Surface(corners, box, (0.9, 0.6, 0.3, 1.0)),
        Surface(quad((3, 0, -4), (1.5, 0, 0.5), (0, 1.5, 0.3)), QUAD, (1, 1, 1, 1), None, uvs, noise(13, 7, 4)),
        Surface(quad((-3.017, -1.009, -4), (1, 0, 1), (0, 1, 0)), QUAD, colors=noise(4, 4, seed=1)),
        Surface(quad((0.013, 0.007, -3), (1, 0, 0), (0, 1, 0)), QUAD, (1, 0.5, 1, 1), 0.5, uvs, noise(8, 8, 4, seed=2)),
        Surface(quad((0, -2, 0), (7, 0, 0), (0, 0, 6)), QUAD, (1, 1, 1, 1), None, 4 * uvs, noise(64, 32, 4, seed=3)),
        *glowing(),
    ]


def glowing() -> list[Surface]:
    """Squares that are unlit, and that emit light: with textures of two sizes, without one, and with holes."""
    white = (1.0, 1.0, 1.0, 1.0)
    uvs = np.array([[0.1, -0.3], [1.6, -0.2], [1.5, 1.2], [0.0, 1.1]])
    wide, holes = noise(16, 24, 4, seed=4), noise(8, 8, 4, seed=5)
    return [
        Surface(quad((-2.03, 2.51, -4.1), (1, 0.2, 0), (0, 1, 0.1)), QUAD, white, None, uvs, wide, unlit=True),
        Surface(
            *(quad((2.02, 2.53, -4.3), (1, 0, 0.3), (0, 1, 0)), QUAD, (0.5, 0.6, 0.7, 1), None, uvs, wide),
            emission=(2.0, 0.5, 1.0), emission_texture=noise(5, 9, 4, seed=6),
        ),
        Surface(quad((1.4, 0.7, 4.1), (1, 0, 0), (0, 1, 0)), QUAD, colors=noise(4, 4, seed=7), emission=(0.1, 0, 0.3)),
        Surface(
            *(quad((-1.43, 0.6, 4.2), (1, 0, 0), (0, 1, 0.2)), QUAD, (1, 1, 1, 1), 0.4, uvs, holes),
            emission=(0.0, 0.7, 0.2), emission_texture=holes,
        ),
    ]  # fmt: skip
