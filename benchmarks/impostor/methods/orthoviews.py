"""Orthoviews of the far part: depth images of an octree's cells, drawn as splats."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.impostor.methods import maps, place as places
from benchmarks.impostor.methods.place import Place, fill, fine

SIZE = 128
"""Pixels across a view."""

EXTENT = 16
"""Sides of the leaves in the longest side of the box around what is stored."""


@dataclass(frozen=True, eq=False)
class Orthoviews:
    """Tree of orthoviews without geometry, drawn with one error."""

    tree: nf.orthoview.OrthoTree
    error_px: float
    triangles: int
    """Number of splats of the views around the centre."""
    bytes: int
    setting: str

    def picture(self, place: Place, user: nf.Camera) -> tuple[nf.Frame, NDArray[np.bool_]]:
        """Draw near and far part; see `Method`."""
        frame = self.tree.render(
            fine(user), error_px=self.error_px, geometry=False, samples=1, channels=("color", "range")
        )
        points = places.points_of(frame)
        far = places.Far(frame.require("color"), frame.require("range"), points)
        return place.compose(user, far, moved=True)


def orthoviews(place: Place, budget: int, folder: Path) -> Orthoviews:
    """Build a tree of the far triangles that probes see, and draw it with the least error whose views keep a budget.

    The tree ends at the distance within which the centre sees 95 % of the far part, by texels of a cube map, because
    leaves are of one size. The bytes are those of the views that all users need, in all directions around them.
    """
    part = place.visible
    rays = maps.corner_directions(64).reshape(-1, 3)
    ranges = nf.cast_rays(place.far, place.center, rays).t_hit
    limit = float(np.percentile(ranges[np.isfinite(ranges)], 95.0))
    low, high = (
        np.maximum(part.bounds[0], np.subtract(place.center, limit)),
        np.minimum(part.bounds[1], np.add(place.center, limit)),
    )
    cell = float((high - low).max() / EXTENT)
    settings: dict[str, Any] = {"size": SIZE, "directions": 9, "color": "webp", "quality": 80}
    tree = nf.orthoview.build(part, folder, cell=cell, aabb=[low, high], geometry=False, **settings)
    cameras = [user for users in place.users.values() for user in users]

    def make(inverse: float) -> Orthoviews:
        error = 1.0 / inverse
        with tree.fly(error_px=error, geometry=False, prefetch=False, margin_deg=None) as flight:
            for camera in cameras:
                flight.look(camera)
                flight.wait()
            count = flight.bytes_read
        frame = tree.render(cameras[0], error_px=error, geometry=False)
        text = f"leaves of {cell:.3g} m, {SIZE}² pixels a view, error_px = {error:.3g}"
        return Orthoviews(tree, error, frame.stats["splats"], count, text)

    return fill(make, lambda made: made.bytes, budget, 1e-3, 1.0)  # type: ignore[no-any-return]
