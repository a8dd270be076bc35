"""A textured globe, and a count of open edges, for tests of simplification."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from nearfar._scene.builder import SceneBuilder

Array = NDArray[Any]


def globe(rings: int = 40, *, texture: Array | None = None, radius: float = 1.0) -> nf.Scene:
    """A sphere whose texture coordinates have a seam and are torn at the poles."""
    u, v = np.meshgrid(np.linspace(0, 1, 2 * rings + 1), np.linspace(0, 1, rings + 1))
    around, down = 2 * np.pi * np.where(u == 1, 0, u), np.pi * v
    points = np.stack([np.sin(down) * np.cos(around), np.cos(down), -np.sin(down) * np.sin(around)], axis=2)
    points[0], points[-1] = (0, 1, 0), (0, -1, 0)
    row, column = np.meshgrid(np.arange(rings), np.arange(2 * rings), indexing="ij")
    a = (row * (2 * rings + 1) + column).ravel()
    b, c, d = a + 2 * rings + 1, a + 1, a + 2 * rings + 2
    upper, lower = np.column_stack([a, b, d]), np.column_stack([a, d, c])
    builder = SceneBuilder()
    picture = np.zeros((8, 8, 4), np.uint8) if texture is None else texture
    material = builder.material((1, 1, 1, 1), picture)
    uvs = np.stack([u, 1 - v], axis=2).reshape(-1, 2)
    # The poles' faces would be degenerate otherwise.
    faces = np.concatenate([upper, lower[row.ravel() > 0]])
    faces = faces[~((faces >= rings * (2 * rings + 1)).sum(axis=1) == 2)]
    mesh = builder.mesh(points.reshape(-1, 3) * radius, faces, uvs=uvs, material=material)
    builder.instance(mesh, name="globe")
    return builder.build()


def open_edges(scene: nf.Scene) -> int:
    """Edges with an odd number of faces, vertices merged by position."""
    corners = scene.triangles().reshape(-1, 3)
    _, number = np.unique(corners, axis=0, return_inverse=True)
    faces = number.reshape(-1, 3)
    edges = np.sort(np.stack([faces, np.roll(faces, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)
    edges = edges[edges[:, 0] != edges[:, 1]]
    return int((np.unique(edges, axis=0, return_counts=True)[1] % 2).sum())
