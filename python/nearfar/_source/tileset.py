"""A tileset (3D Tiles) as a source: reads the tiles that cover a box with a maximum geometric error."""

from __future__ import annotations

from typing import SupportsFloat

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check
from nearfar._scene.options import LoadOptions
from nearfar._scene.scene import Scene
from nearfar._scene.tileset.tileset import Tileset
from nearfar._source.frame import scene_of


class TilesetSource:
    """World of a tileset, whose contents are cached as long as there is room."""

    def __init__(self, tileset: Tileset, options: LoadOptions) -> None:
        self._tileset, self._options = tileset, options

    @property
    def bounds(self) -> NDArray[np.float64]:
        """World box (2, 3) of the tileset's volume."""
        return self._tileset.bounds

    def query(self, aabb: ArrayLike, detail: SupportsFloat = 0.0) -> Scene:
        """Return a scene of the triangles that touch a box, whole; see `nearfar.SceneSource`.

        The tiles have a geometric error of at most `detail`; 0 selects the finest.
        """
        box, error = check.box("aabb", aabb), check.at_least_zero("detail", detail)
        content = self._tileset.read(error=error, box=box)
        return scene_of(content, box, self.bounds, self._options)

    def __repr__(self) -> str:
        return f"<nearfar source: tileset {self._tileset.label}>"
