"""Geometry of orthoview trees for tests: leaves of a world, and the content of their files."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from nearfar.orthoview._geometry_store import GeometryStore
from nearfar.orthoview._grid import Grid, Place


def places(grid: Grid) -> Iterator[Place]:
    """All leaves."""
    yield from itertools.product(*map(range, grid.counts))


def parts(world: Any, grid: Grid) -> Iterator[tuple[Place, nf.Scene]]:
    """The leaves that a world touches, with their geometry."""
    for place in places(grid):
        part = world.query(grid.box(0, place))
        if part.triangle_count:
            yield place, part


def stored(world: Any, grid: Grid, folder: Path) -> dict[str, Any]:
    """Write the geometry of all leaves like a build; returns the counts."""
    store = GeometryStore(folder, grid)
    for place, part in parts(world, grid):
        store.write(part, place)
    return store.finish()


def standing(scene: nf.Scene) -> NDArray[np.float64]:
    """Static triangles (T, 3, 3), world, metres."""
    return world_triangles(scene)[: scene._core.standing_triangle_count]


def world_triangles(scene: nf.Scene) -> NDArray[np.float64]:
    """All triangles (T, 3, 3), world, metres."""
    triangles: NDArray[np.float64] = scene.triangles() + scene.origin
    return triangles


def keys(rows: NDArray[np.floating]) -> list[bytes]:
    """The bits of triangles or points, as keys for comparison."""
    return [row.tobytes() for row in rows]
