"""Nearest points of a scene's surface."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check, progress
from nearfar._scene.scene import Scene, core_of


@dataclass(frozen=True, eq=False)
class Nearest:
    """Nearest surface points of N query points, some of which may have no nearest point."""

    distance: NDArray[np.float64]
    """(N,) distance to the nearest surface point, metres; +inf without one."""
    triangle_index: NDArray[np.int64]
    """(N,) triangle of that point, numbered as in `Scene.triangles`; −1 without one."""
    barycentric: NDArray[np.float64]
    """(N, 2) weights of the triangle's second and third corner; NaN without one."""

    def __len__(self) -> int:
        """Return the number of points."""
        return len(self.distance)


def nearest_points(scene: Scene, points: ArrayLike, *, facing: ArrayLike | None = None) -> Nearest:
    """Find the point of a scene's surface that is nearest to each point.

    The search is faster if neighbouring points follow each other in the array. Distances are computed in float64 to the
    triangles of `Scene.triangles`. If several triangles have the same distance, the lowest triangle number is reported.
    The bytes are the same for any number of threads. ValueError for wrong shapes, and coordinates that are not finite;
    TypeError for values that are not numbers. Sources: Roussopoulos, Kelley, Vincent (1995), Nearest neighbor queries,
    for the search; Ericson (2005) for the nearest point of a triangle.

    Parameters
    ----------
    scene
        The scene. The first call builds its search tree, which later calls reuse. Holes in a cut-out material's alpha
        count as surface.
    points
        (N, 3) world positions, metres.
    facing
        (N, 3) directions: only triangles whose outward normal is within 90° of a point's direction are searched; None
        searches all triangles.
    """
    core = core_of(scene)
    positions = check.array("points", points)
    directions = None if facing is None else check.array("facing", facing, dtype=np.float32, finite=True)
    if directions is not None and directions.shape != positions.shape:
        raise ValueError(f"facing: expected shape {positions.shape} as points has, got {directions.shape}")
    with progress.bar("looking for nearest points") as report:
        return Nearest(*_core.nearest_points(core, positions, facing=directions, report=report))
