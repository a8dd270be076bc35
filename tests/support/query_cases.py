"""Scenes to be queried, and a brute-force search for triangles that touch a box."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

import nearfar as nf
from nearfar import _core

INF = float("inf")
BOXES: tuple[tuple[tuple[float, ...], tuple[float, ...]], ...] = (
    ((-2, -2, -2), (2, 2, 2)),
    ((0, -INF, 0), (3, INF, 3)),
    ((0.1, 0.1, -6), (0.1, 0.1, 6)),
    ((-INF, 0, -INF), (INF, 0, INF)),
    ((4, -1, -6), (4.5, 9, 6)),
    ((-30, -30, -30), (5, 30, 30)),
)
"""Boxes about a point in the middle of a scene: with various sides, and without extent."""


def touching(scene: nf.Scene, aabb: ArrayLike) -> NDArray[np.bool_]:
    """Whether each triangle touches a closed box, by all thirteen axes that can separate them, in float64."""
    least, greatest = np.asarray(aabb, np.float64) - scene.origin
    corners = scene.triangles().astype(np.float64)
    low, high = corners.min(axis=1), corners.max(axis=1)
    touches: NDArray[np.bool_] = ((low <= greatest) & (high >= least)).all(axis=1)
    # Only the part of an infinite box around the triangle matters.
    least, greatest = np.maximum(least, low - 1), np.minimum(greatest, high + 1)
    corners = corners - ((least + greatest) / 2)[:, None]
    half = (greatest - least) / 2
    edges = np.roll(corners, -1, axis=1) - corners
    axes = [np.cross(edges[:, 0], edges[:, 1])]
    axes += [np.cross(np.eye(3)[axis], edges[:, edge]) for axis in range(3) for edge in range(3)]
    for axis in axes:
        along = np.einsum("tij,tj->ti", corners, axis)
        reach = (np.abs(axis) * half).sum(axis=1)
        touches &= (along.min(axis=1) <= reach) & (along.max(axis=1) >= -reach)
    return touches


def contents(scene: nf.Scene) -> dict[str, NDArray[Any]]:
    """Corners, attributes at the corners, objects and materials of all triangles, by index."""
    parts = _core.mesh_parts(scene._core.merged())
    faces = parts.pop("faces")
    found = {"corners": scene.triangles()}
    for name, values in parts.items():
        if values is not None:
            found[name] = values if name in ("objects", "materials") else values[faces]
    return found


def soup(center: ArrayLike = (0.0, 0.0, 0.0), *, seed: int = 1) -> nf.Scene:
    """Triangles of all sizes about a point: merged meshes with all attributes, instances, moving ones, and copies."""
    random, builder = np.random.default_rng(seed), nf.SceneBuilder()
    red = builder.material((1.0, 0.0, 0.0, 1.0), random.integers(0, 256, (4, 4, 4), np.uint8))
    blue = builder.material((0.0, 0.0, 1.0, 1.0))

    def add(count: int, extent: float) -> int:
        middles = random.uniform(-extent, extent, (count, 1, 3))
        sizes = 10 ** random.uniform(-2, 0.7, (count, 1, 1))
        positions = (middles + random.normal(size=(count, 3, 3)) * sizes).reshape(-1, 3).astype(np.float32)
        # Some vertices belong to several faces, some to none, and some faces are duplicated.
        faces = random.permutation(np.r_[np.arange(3 * count).reshape(-1, 3), random.integers(0, 3 * count, (9, 3))])
        faces = np.concatenate([faces[5:], faces[10:20]])
        return builder.mesh(
            positions,
            faces,
            uvs=random.random((3 * count, 2)),
            colors=random.integers(0, 256, (3 * count, 4), np.uint8),
            normals=random.normal(size=(3 * count, 3)),
            material=random.choice([red, blue], len(faces)),
        )

    def place(turn: float, offset: ArrayLike) -> NDArray[np.float64]:
        matrix = np.eye(4)
        matrix[:3, :3] = [[np.cos(turn), 0, np.sin(turn)], [0, 1, 0], [-np.sin(turn), 0, np.cos(turn)]]
        matrix[:3, 3] = np.asarray(center) + offset
        return matrix

    for number in range(3):
        builder.instance(add(300, 8), place(0, (0, 0, 0)), name=f"merged {number}")
    tree = add(40, 1)
    spots = random.uniform(-8, 8, (60, 3))
    builder.place_many(tree, np.array([place(spot[0], spot) for spot in spots]), "tree")
    for number in range(4):
        builder.instance(add(20, 1), place(1, random.uniform(-6, 6, 3)), name=f"car {number}")
    return builder.build(dynamic=["car 0", "car 2", "car 3", "tree_5"])
