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
    """What of a scene lies nearest to N points."""

    distance: NDArray[np.float64]
    """(N,) metres; +inf where nothing counts."""
    triangle_index: NDArray[np.int64]
    """(N,) triangle, as `Scene.triangles` numbers them; −1 where nothing counts."""
    barycentric: NDArray[np.float64]
    """(N, 2) weights of the triangle's second and third corner; NaN where nothing counts."""

    def __len__(self) -> int:
        """Return the number of points."""
        return len(self.distance)


def nearest_points(scene: Scene, points: ArrayLike, *, facing: ArrayLike | None = None) -> Nearest:
    """Find the point of a scene's surface that is nearest to each point.

    Neighbouring points are found faster where they follow each other.

    Parameters
    ----------
    scene
        Its search tree is built by the first call and kept. What a cut-out material's alpha leaves open counts as
        surface.
    points
        (N, 3) world positions, metres.
    facing
        (N, 3) directions: only triangles whose outside is within 90° of a point's direction count. None counts all.

    Returns
    -------
    Nearest
        Distances are those to the triangles as `Scene.triangles` gives them, in float64. Where several triangles are
        as near, the lowest number among those with the same float64 distance is reported. The same bytes for any number
        of threads.

    Raises
    ------
    ValueError
        For other shapes, and coordinates that are not finite.
    TypeError
        For values that are not numbers.

    References
    ----------
    Roussopoulos, Kelley, Vincent (1995): Nearest neighbor queries, for the search. Ericson (2005).
    """
    core = core_of(scene)
    places = check.array("points", points)
    directions = None if facing is None else check.array("facing", facing, dtype=np.float32, finite=True)
    if directions is not None and directions.shape != places.shape:
        raise ValueError(f"facing: expected shape {places.shape} as points has, got {directions.shape}")
    with progress.bar("looking for nearest points") as report:
        return Nearest(*_core.nearest_points(core, places, facing=directions, report=report))
