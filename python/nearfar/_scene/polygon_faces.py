"""Triangulates polygons given by vertex indices, as in PLY and OFF files."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._scene.report import count

_NONE = np.iinfo(np.uint32).max
"""Vertex number out of range."""


@dataclass(frozen=True)
class Triangles:
    """Triangles of polygons."""

    corners: NDArray[Any]
    """Corners (T, 3), as indices into the concatenated corners of all polygons."""
    ends: NDArray[np.int64] | None
    """Offsets (P + 1,) of the polygons' triangles; None if all polygons are triangles."""
    notes: list[str]
    """Notes on polygons that are ignored or drawn differently."""

    def per_triangle(self, values: NDArray[Any]) -> NDArray[Any]:
        """Convert values (P, …) of polygons to values (T, …) of their triangles."""
        return values if self.ends is None else values.repeat(np.diff(self.ends), axis=0)


def triangulate(vertices: NDArray[Any], indices: NDArray[Any], offsets: NDArray[np.int64]) -> Triangles:
    """Triangulate polygons, which may be concave: polygon p has the vertices ``indices[offsets[p] : offsets[p + 1]]``.

    Vertices are (V, 3). Polygons with indices out of range become fans. Vertices on straight sides become corners of
    triangles, so that no T-junctions open cracks between neighbouring faces.
    """
    sizes = np.diff(offsets)
    if (sizes == 3).all():
        return Triangles(np.arange(len(indices)).reshape(-1, 3), None, [])
    if indices.dtype.itemsize > 4:
        indices = np.where((indices >= 0) & (indices < len(vertices)), indices, _NONE)
    # Negative numbers wrap around to numbers out of range.
    corners = indices.astype(np.uint32)
    faces, ends, fans = _core.triangulate_faces(np.ascontiguousarray(vertices, np.float64), corners, offsets)
    return Triangles(faces, ends, polygon_notes(int((sizes < 3).sum()), *fans))


def polygon_notes(small: int, large: int, crossing: int) -> list[str]:
    """Notes on polygons, given their numbers: with fewer than three corners, too large for ear clipping, crossing."""
    counts = {
        "with fewer than three corners ignored": small,
        "with more than 8,192 corners drawn as a fan from the first corner, which may leave the outline": large,
        "with an outline that crosses itself drawn as a fan from the first corner": crossing,
    }
    return [f"{count(number, 'face')} {note}" for note, number in counts.items() if number]
