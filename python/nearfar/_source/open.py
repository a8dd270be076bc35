"""Opens files and folders as sources, depending on their kind."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any, SupportsIndex

from numpy.typing import ArrayLike

from nearfar._base import check
from nearfar._base.errors import SceneError, UnusableError
from nearfar._scene.content import BLEND
from nearfar._scene.scene import Scene
from nearfar._scene.tileset.read import is_tileset
from nearfar._scene.tileset.tileset import KINDS, Tileset, suffix
from nearfar._source.footprints import SUFFIXES as FOOTPRINTS, FootprintFile
from nearfar._source.protocol import SceneSource
from nearfar._source.tile_index import DOCUMENT
from nearfar._source.tiles import TileFolder
from nearfar._source.tileset import TilesetSource

TILESET = "tileset.json"
"""Name that the first document of a tileset usually has."""

_CACHE = 1 << 30
"""Default size of the cache of tiles, bytes."""


def open_source(
    path: str | os.PathLike[str],
    *,
    up: str = "y",
    on_invalid: str = "raise",
    scale: float | None = None,
    max_bytes: int | None = None,
    blend: str = "opaque",
    origin: ArrayLike | None = None,
    lod: str | float | None = None,
    height: str | None = None,
    cache_bytes: SupportsIndex = _CACHE,
) -> SceneSource:
    """Open a world, whose `query` returns scenes box by box.

    Parameters
    ----------
    path
        A folder of tiles written by `nearfar.write_tiles`; a tileset of 3D Tiles, by its document, its folder or a URL;
        footprints (.geojson, .parquet, .geoparquet), whose outlines stay in memory and whose triangles are made for
        each query; or a file that `Scene.load` reads: it is read completely, and the scene answers with its search
        trees.
    up, on_invalid, scale, max_bytes, blend
        As in `Scene.load`. Folders of tiles, tilesets and footprints are upright and in metres already; folders of
        tiles keep the materials with which they were written, and footprints have none.
    origin
        Longitude and latitude in degrees and height in metres of (0, 0, 0), for a tileset on the Earth and for
        footprints in degrees; by default the middle of the data.
    lod
        Maximum level of detail of CityJSON, as in `Scene.load`.
    height
        The property of footprints that states their height, as in `Scene.load`.
    cache_bytes
        Memory for tiles cached for later queries.

    Returns
    -------
    SceneSource
        A source with `bounds` and `query`.

    Raises
    ------
    SceneError
        A file or folder that cannot be used.
    FormatError
        An index of tiles that is damaged, too new, or of a folder that is not finished.
    ValueError, TypeError
        Arguments out of range.
    OSError
        A file that cannot be opened.
    """
    check.choice("on_invalid", on_invalid, ("raise", "drop"))
    check.choice("blend", blend, BLEND)
    most = check.integer("cache_bytes", cache_bytes, 0, 2**62)
    upright: dict[str, tuple[object, object]] = {
        "up": (up, "y"),
        "scale": (scale, None),
        "max_bytes": (max_bytes, None),
        "lod": (lod, None),
    }
    tileset = _tileset(path)
    if tileset is not None:
        _refuse("a tileset", upright | {"height": (height, None)})
        return TilesetSource(Tileset.open(tileset, origin=origin, cache_bytes=most), on_invalid, blend)
    target = check.path("path", path)
    folder = target.parent if target.name == DOCUMENT else target
    if not folder.is_dir() and suffix(target) in FOOTPRINTS:
        del upright["max_bytes"]
        _refuse("footprints", upright | {"blend": (blend, "opaque")})
        return FootprintFile.open(target, origin=origin, height=height, max_bytes=max_bytes, on_invalid=on_invalid)
    if not folder.is_dir():
        how: dict[str, Any] = {"scale": scale, "max_bytes": max_bytes, "origin": origin, "lod": lod, "height": height}
        return Scene.load(target, up=up, on_invalid=on_invalid, blend=blend, **how)
    if not (folder / DOCUMENT).is_file():
        raise SceneError(f"{os.fspath(path)}: expected a file, or a folder of tiles with {DOCUMENT} or {TILESET}")
    given = {"origin": (origin, None), "height": (height, None), "blend": (blend, "opaque")}
    _refuse("a folder of tiles", upright | given)
    return TileFolder(folder, most)


def _refuse(kind: str, given: dict[str, tuple[object, object]]) -> None:
    """Raise ValueError for arguments that are not at their defaults."""
    for name, (value, default) in given.items():
        if value is not default and value != default:
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
