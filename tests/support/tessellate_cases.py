"""Shapes that tests of tessellation split, their users, and a check for cracks."""

from __future__ import annotations

from collections import Counter
from typing import Any

import numpy as np
import trimesh
from numpy.typing import NDArray

import nearfar as nf

Array = NDArray[np.float64]
CENTER = np.array([3.0, 1.7, -2.0])
VIEW = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(90, 16 / 9), size=(1920, 1080))
PIXEL = 1.0 / 960 / (1 + 1 + (9 / 16) ** 2)
"""Tangent units that a pixel covers, times cos² of the corner's angle off the axis: the finest pixel in radians."""


def ground(extent: float = 4000.0) -> trimesh.Trimesh:
    corners = np.array([[-1, 0, -1], [-1, 0, 1], [1, 0, 1], [1, 0, -1]]) * extent
    return trimesh.Trimesh(corners, [[0, 1, 2], [0, 2, 3]], process=False)


def users(reach: float, count: int, seed: int) -> Array:
    """Eyes in a ball about the centre, most of them at its border, where errors are greatest."""
    random = np.random.default_rng(seed)
    aim = random.normal(size=(count, 3)) * [1, 0.3, 1]
    aim /= np.linalg.norm(aim, axis=1, keepdims=True)
    return np.asarray(CENTER + aim * reach * random.uniform(0.5, 1, (count, 1)) ** 0.1)


def open_edges(triangles: NDArray[Any]) -> int:
    """Number of edges, by the bits of their ends, that do not separate two triangles."""
    ends = [tuple(sorted(map(tuple, (t[i].tolist(), t[i - 1].tolist())))) for t in triangles for i in range(3)]
    return sum(count != 2 for count in Counter(ends).values())
