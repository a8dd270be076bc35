"""Casts rays into a scene and finds the nearest triangle along each, and whether it is hit from behind."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check, progress
from nearfar._scene.scene import Scene, core_of


@dataclass(frozen=True, eq=False)
class Hits:
    """Nearest hits of N rays in a scene."""

    t_hit: NDArray[np.float32]
    """(N,) distance from the ray's origin, metres; +inf for a miss."""
    triangle_index: NDArray[np.int64]
    """(N,) triangle, numbered as in `Scene.triangles`; −1 for a miss."""
    object_id: NDArray[np.int32]
    """(N,) object, an index into `Scene.object_names`; −1 for a miss."""
    barycentric: NDArray[np.float32]
    """(N, 2) weights of the triangle's second and third corner; NaN for a miss."""
    _origins: NDArray[np.float32 | np.float64] = field(repr=False)
    _directions: NDArray[np.float32 | np.float64] = field(repr=False)

    def __len__(self) -> int:
        """Return the number of rays."""
        return len(self.t_hit)

    @property
    def hit(self) -> NDArray[np.bool_]:
        """(N,) whether anything was hit."""
        return self.triangle_index >= 0

    @property
    def position(self) -> NDArray[np.float64]:
        """(N, 3) world positions of the hits, metres; NaN for a miss. Computed at each access."""
        directions = self._directions.astype(np.float64)
        # Division by the largest component keeps the squares of very long or short directions in float64's range.
        with np.errstate(invalid="ignore"):
            directions /= np.abs(directions).max(axis=1, keepdims=True)
            directions /= np.linalg.norm(directions, axis=1, keepdims=True)
            t = np.where(self.hit, self.t_hit, np.float32(np.nan)).astype(np.float64)
            return np.asarray(self._origins + t[:, None] * directions, np.float64)


def surface_heights(scene: Scene, points: NDArray[np.float64], *, from_above: bool) -> NDArray[np.float64]:
    """Return the heights (M,) of the first surface at points (M, 2) as x, z, from above or below; NaN for none."""
    low, high = scene.bounds[:, 1]
    start, sign = (high + 1.0, -1.0) if from_above else (low - 1.0, 1.0)
    down = np.tile([0.0, sign, 0.0], (len(points), 1))
    distances = cast_rays(scene, np.insert(points, 1, start, axis=1), down).t_hit.astype(np.float64)
    return np.where(np.isfinite(distances), start + sign * np.where(np.isfinite(distances), distances, 0.0), np.nan)


def cast_rays(scene: Scene, origins: ArrayLike, directions: ArrayLike, *, t_max: float = np.inf) -> Hits:
    """Find the nearest triangle along each ray.

    No ray passes between triangles of one mesh at an edge or vertex that they share. Both sides of a triangle are hit.
    If several triangles are hit at the same distance, the lowest triangle number is reported. Rays pass where a cut-out
    material's alpha leaves a hole. Rays that follow each other in the array and have similar directions are traced
    together, which is faster: order them so that neighbours are close, such as pixels row by row or tile by tile.

    The bytes are the same for any number of threads and on any processor. ValueError for wrong shapes, coordinates that
    are not finite, and directions of length 0, whose number and first index the message states; TypeError for values
    that are not numbers. Sources: Woop, Benthin, Wald (2013), Watertight ray/triangle intersection, JCGT 2(1); Meister,
    Bittner (2018), Parallel locally-ordered clustering for bounding volume hierarchy construction.

    Parameters
    ----------
    scene
        The scene. The first call builds its search tree, which later calls reuse.
    origins
        (N, 3), or (3,) for all rays: world positions, metres. `scene.origin` is subtracted in float64; the difference
        is rounded to float32.
    directions
        (N, 3) of any length above 0; hit distances are in metres whatever the length.
    t_max
        Greatest distance of a hit, metres; farther ones are ignored.
    """
    core = core_of(scene)
    ray_directions = check.array("directions", directions)
    ray_origins = check.plain("origins", origins)
    has_one_origin = ray_origins.shape == (3,)
    ray_origins = check.array("origins", ray_origins[None] if has_one_origin else ray_origins)
    if len(ray_origins) != len(ray_directions) and not has_one_origin:
        expected = f"shape (3,) or {ray_directions.shape} as directions has"
        raise ValueError(f"origins: expected {expected}, got {ray_origins.shape}")
    limit = check.number("t_max", t_max, finite=False)
    if not limit > 0.0:
        raise ValueError(f"t_max: expected a number above 0, got {limit}")
    with progress.bar("casting rays") as report:
        t_hit, triangle_index, object_id, barycentric = _core.cast_rays(
            core, ray_origins, ray_directions, limit, report
        )
    return Hits(t_hit, triangle_index, object_id, barycentric, ray_origins, ray_directions)


def is_hit_from_behind(
    scene: Scene, triangles: NDArray[np.int64], directions: NDArray[np.float64]
) -> NDArray[np.bool_]:
    """Return whether rays with directions (N, 3) hit the backs of triangles, given by number (…, N), −1 for a miss."""
    is_hit = triangles >= 0
    hit_triangles = np.unique(triangles[is_hit])
    if not len(hit_triangles):
        return np.zeros(triangles.shape, bool)
    mask = np.zeros(scene.triangle_count, bool)
    mask[hit_triangles] = True
    corners = scene._core.subset_of_triangles(mask).triangles().astype(np.float64)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    hit_normals = normals[np.searchsorted(hit_triangles, np.where(is_hit, triangles, hit_triangles[0]))]
    return np.asarray(((hit_normals * directions).sum(axis=-1) > 0.0) & is_hit)
