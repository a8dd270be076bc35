"""Transfers attributes of a base to a coarser surface with other vertices."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar.lod._simplify.normals import unit
from nearfar.lod._simplify.surface import Surface, charts_of

TOLERANCE = {"uvs": 1 / 2048, "colors": 2.0, "normals": 0.02}
"""Differences up to which corners at one place share a vertex: half a texel of 1024, two 8-bit steps, a degree."""


class Carrier:
    """Finds the nearest place on the base for each corner of a level, and interpolates the attributes there.

    Triangles of a level descend from faces of the base. Each corner's search starts from that face and never crosses a
    seam: so it stays on its own side of a seam, even if both sides belong to one chart.
    """

    def __init__(self, surface: Surface) -> None:
        self._surface = surface
        self._charts = {}
        for key in surface.attributes:
            rows, faces = charts_of(surface, key)
            self._charts[key] = np.ascontiguousarray(surface.positions[rows]), faces

    def carried(self, positions: NDArray[np.float32], faces: NDArray[np.uint32], source: NDArray[np.int64]) -> Surface:
        """Return a surface with attributes.

        Parameters
        ----------
        positions, faces
            Positions and faces of the level, (V, 3) and (F, 3).
        source
            Faces of the base that the level's faces descend from (F,).
        """
        base = self._surface
        materials = np.ascontiguousarray(base.materials[source])
        positions, corners = np.ascontiguousarray(positions), faces.ravel()
        if not base.attributes or not len(faces):
            return Surface(positions, faces, materials, {key: value[:0] for key, value in base.attributes.items()})
        values = {key: self._values(key, positions[faces], source) for key in base.attributes}
        scaled = np.concatenate([rows / TOLERANCE[key] for key, rows in values.items()], axis=1)
        shared = together(corners, scaled)
        used, renumbered = np.unique(shared, return_inverse=True)
        return Surface(
            np.ascontiguousarray(positions[corners[used]]),
            np.ascontiguousarray(renumbered.reshape(-1, 3), np.uint32),
            materials,
            {key: _stored(key, rows[used], base.attributes[key].dtype) for key, rows in values.items()},
        )

    def _values(self, key: str, corners: NDArray[np.float32], source: NDArray[np.int64]) -> NDArray[np.float64]:
        """Return the attribute of each corner (3 F, …)."""
        places, faces = self._charts[key]
        begin = np.ascontiguousarray(source, np.uint32)
        face, weights = _core.carry(places, faces, np.ascontiguousarray(corners), begin)
        rows = self._surface.attributes[key][self._surface.faces[face]].astype(np.float64)
        u, v = weights.T[:, :, None]
        values: NDArray[np.float64] = rows[:, 0] + u * (rows[:, 1] - rows[:, 0]) + v * (rows[:, 2] - rows[:, 0])
        return values


def _stored(key: str, rows: NDArray[np.float64], dtype: np.dtype[Any]) -> NDArray[Any]:
    if key == "normals":
        rows = unit(rows)
    elif key == "colors":
        rows = np.rint(rows)
    return np.ascontiguousarray(rows, dtype)


def together(corners: NDArray[np.uint32], values: NDArray[np.float64]) -> NDArray[np.int64]:
    """For each corner the first one at its vertex whose values differ by at most 1."""
    first = np.full(len(corners), -1)
    remaining = np.arange(len(corners))
    while len(remaining):
        _, leader, group = np.unique(corners[remaining], return_index=True, return_inverse=True)
        leaders = remaining[leader][group]
        # NaN differs from everything, even from itself.
        alike = (np.abs(values[remaining] - values[leaders]) <= 1).all(axis=1) | (leaders == remaining)
        first[remaining[alike]] = leaders[alike]
        remaining = remaining[~alike]
    return first
