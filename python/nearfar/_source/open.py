"""Opens files and folders of several kinds as sources, whose contents are converted for each query."""

from __future__ import annotations

import os
from pathlib import Path
from typing import SupportsFloat, SupportsIndex, Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import background, check
from nearfar._base.errors import SceneError, UnusableError
from nearfar._base.settings import gather
from nearfar._scene.arrays import origin_for
from nearfar._scene.city.footprints import Footprints
from nearfar._scene.city.read import open_footprints
from nearfar._scene.content import Content, assemble
from nearfar._scene.names import Names
from nearfar._scene.options import LoadKeywords, LoadOptions
from nearfar._scene.scene import Scene
from nearfar._scene.serialize import empty_core
from nearfar._scene.tileset.tileset import KINDS, Tileset, is_tileset, suffix
from nearfar._source.protocol import SceneSource
from nearfar._source.tile_index import DOCUMENT
from nearfar._source.tiles import TileFolder

TILESET = "tileset.json"
"""Name that the first document of a tileset usually has."""

_CACHE = 1 << 30
"""Default size of the cache of tiles, bytes."""

_FOOTPRINTS = ("geojson", "parquet", "geoparquet")
"""Suffixes of files that contain footprints only."""


def open_source(
    path: str | os.PathLike[str],
    options: LoadOptions | None = None,
    *,
    cache_bytes: SupportsIndex = _CACHE,
    **keywords: Unpack[LoadKeywords],
) -> SceneSource:
    """Open a world, a source with `bounds` and a `query` that returns scenes box by box.

    SceneError for a file or folder that cannot be used; FormatError for an index of tiles that is damaged, too new, or
    incomplete; ValueError and TypeError for arguments out of range; OSError for a file that cannot be opened.

    Parameters
    ----------
    path
        One of: a folder of tiles written by `nearfar.write_tiles`; the document, folder or URL of a 3D Tiles tileset; a
        file of footprints (.geojson, .parquet, .geoparquet), whose outlines stay in memory and whose triangles are made
        for each query; a file that `Scene.load` reads, which is loaded as a whole and queried by its search trees.
    options
        Axis, unit, limits and place, as `LoadOptions`. Folders of tiles, tilesets and footprints are upright and in
        metres already. Folders of tiles have the materials with which they were written, and footprints have none.
        `error` and `triangles` do not apply, because each query has a `detail`.
    cache_bytes
        Memory for tiles cached for later queries.
    keywords
        Fields of `options`, which they replace: `up`, `scale`, `on_invalid`, `max_bytes`, `blend`, `origin`, `lod`,
        `height`.
    """
    options = gather(LoadOptions, options, keywords, "options")
    max_bytes = check.integer("cache_bytes", cache_bytes, 0, 2**62)
    upright = ("up", "scale", "lod", "error", "triangles")
    tileset = _tileset(path)
    if tileset is not None:
        _refuse("a tileset", options, *upright, "max_bytes", "height")
        return TilesetSource(Tileset.open(tileset, origin=options.origin, cache_bytes=max_bytes), options)
    target = check.path("path", path)
    folder = target.parent if target.name == DOCUMENT else target
    if not folder.is_dir() and suffix(target) in _FOOTPRINTS:
        _refuse("footprints", options, *upright, "blend")
        return FootprintFile(target, options)
    if not folder.is_dir():
        return Scene.load(target, options)
    if not (folder / DOCUMENT).is_file():
        raise SceneError(f"{os.fspath(path)}: expected a file, or a folder of tiles with {DOCUMENT} or {TILESET}")
    _refuse("a folder of tiles", options, *upright, "max_bytes", "origin", "height", "blend")
    return TileFolder(folder, max_bytes)


def _refuse(kind: str, options: LoadOptions, *names: str) -> None:
    """Raise ValueError for options that are not at their defaults."""
    for name in names:
        value = getattr(options, name)
        if value != getattr(LoadOptions, name):
            raise ValueError(f"{name}: expected none with {kind}, got {check.shortened(value)}")


def _tileset(path: str | os.PathLike[str]) -> str | Path | None:
    """Return the document of a tileset, or the file of a tile, that a path or URL names; None for anything else."""
    if isinstance(path, str) and "://" in path:
        return path
    target = check.path("path", path)
    if target.is_dir():
        return target / TILESET if (target / TILESET).is_file() and not (target / DOCUMENT).is_file() else None
    if suffix(target) in KINDS:
        return target
    if suffix(target) != "json" or target.name == DOCUMENT:
        return None
    try:
        return target if is_tileset(target.read_bytes()) else None
    except UnusableError:
        return None


class TilesetSource:
    """World of a tileset; the most recently used contents are cached."""

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

    def touches(self, aabb: ArrayLike) -> bool:
        """Return False if no drawn tile's volume touches a box; see `nearfar.SceneSource`."""
        return self._tileset.touches(check.box("aabb", aabb))

    def __repr__(self) -> str:
        return f"<nearfar source: tileset {self._tileset.label}>"


class FootprintFile:
    """World of building outlines, which stay in memory; their triangles do not."""

    def __init__(self, path: Path, options: LoadOptions) -> None:
        self._footprints: Footprints = background.run(lambda: open_footprints(path, options))

    @property
    def bounds(self) -> NDArray[np.float64]:
        """World box (2, 3) of all features; from +∞ to −∞ without features."""
        return self._footprints.bounds

    def query(self, aabb: ArrayLike, detail: SupportsFloat = 0.0) -> Scene:
        """Return a scene of the triangles that touch a box, whole; see `nearfar.SceneSource`.

        The features whose boxes touch the box are extruded, whatever the `detail`.
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
    # This scene is queried only once, so it builds no search trees.
    return scene._query(box, builds=False)
