"""A file of footprints with heights as a source: features whose boxes touch a query's box are extruded."""

from __future__ import annotations

from pathlib import Path
from typing import SupportsFloat

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import background, check
from nearfar._scene.city.footprints import Footprints
from nearfar._scene.city.read import open_footprints
from nearfar._scene.options import LoadOptions
from nearfar._scene.scene import Scene
from nearfar._source.frame import scene_of

SUFFIXES = ("geojson", "parquet", "geoparquet")
"""Suffixes of files that contain footprints only."""


class FootprintFile:
    """World of building outlines, which stay in memory; their triangles do not."""

    def __init__(self, footprints: Footprints) -> None:
        self._footprints = footprints

    @classmethod
    def open(cls, path: Path, options: LoadOptions) -> FootprintFile:
        """Read the outlines of a file."""
        return cls(background.run(lambda: open_footprints(path, options)))

    @property
    def bounds(self) -> NDArray[np.float64]:
        """World box (2, 3) of all features; infinite and inverted without any."""
        return self._footprints.bounds

    def query(self, aabb: ArrayLike, detail: SupportsFloat = 0.0) -> Scene:
        """Return a scene of the triangles that touch a box, whole; see `nearfar.SceneSource`.

        The features whose boxes touch are extruded, for any `detail`.
        """
        box = check.box("aabb", aabb)
        check.at_least_zero("detail", detail)
        return background.run(lambda: self._query(box))

    def touches(self, aabb: ArrayLike) -> bool:
        """Return False if no feature's box touches a box; see `nearfar.SceneSource`."""
        return len(self._footprints.rows_touching(check.box("aabb", aabb))) > 0

    def _query(self, box: NDArray[np.float64]) -> Scene:
        rows = self._footprints.rows_touching(box)
        return scene_of(self._footprints.content(rows), box, self.bounds, LoadOptions())

    def __repr__(self) -> str:
        return f"<nearfar source: {self._footprints.count:,} footprints in {self._footprints.label}>"
