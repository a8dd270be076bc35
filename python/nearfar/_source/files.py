"""Files as sources: tilesets (3D Tiles), and footprints of buildings; contents are converted for each query."""

from __future__ import annotations

from pathlib import Path
from typing import SupportsFloat

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import background, check
from nearfar._scene.arrays import origin_for
from nearfar._scene.city.footprints import Footprints
from nearfar._scene.city.read import open_footprints
from nearfar._scene.content import Content, assemble
from nearfar._scene.names import Names
from nearfar._scene.options import LoadOptions
from nearfar._scene.scene import Scene
from nearfar._scene.serialize import empty_core
from nearfar._scene.tileset.tileset import Tileset


class TilesetSource:
    """World of a tileset; the contents used last are cached."""

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
        return _scene_of(self._tileset.read(error=error, box=box), box, self.bounds, self._options)

    def __repr__(self) -> str:
        return f"<nearfar source: tileset {self._tileset.label}>"


class FootprintFile:
    """World of building outlines, which stay in memory; their triangles do not."""

    def __init__(self, path: Path, options: LoadOptions) -> None:
        self._footprints: Footprints = background.run(lambda: open_footprints(path, options))

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
        return _scene_of(self._footprints.content(rows), box, self.bounds, LoadOptions())

    def __repr__(self) -> str:
        return f"<nearfar source: {self._footprints.count:,} footprints in {self._footprints.label}>"


def _scene_of(content: Content, box: NDArray[np.float64], bounds: NDArray[np.float64], options: LoadOptions) -> Scene:
    """Return the triangles of a content that touch a box, in the frame of reference of a world with these bounds."""
    origin = origin_for(bounds)
    if content.stored is None and not any(len(shape.faces) for shape in content.shapes.values()):
        x, y, z = origin.tolist()
        return Scene(empty_core((x, y, z)), Names(()), notes=tuple(content.notes))
    scene = Scene(**assemble(content, options, origin=origin))
    # Search trees would not pay: this scene is queried only once.
    return scene._query(box, builds=False)
