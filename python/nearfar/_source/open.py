"""Opens files and folders as sources, by what they are."""

from __future__ import annotations

import os
from typing import SupportsIndex

from nearfar._base import check
from nearfar._base.errors import SceneError
from nearfar._scene.scene import Scene
from nearfar._source.protocol import SceneSource
from nearfar._source.tile_index import DOCUMENT
from nearfar._source.tiles import TileFolder

_CACHE = 1 << 30
"""Bytes of tiles that are kept by default."""


def open_source(
    path: str | os.PathLike[str],
    *,
    up: str = "y",
    on_invalid: str = "raise",
    scale: float | None = None,
    max_bytes: int | None = None,
    cache_bytes: SupportsIndex = _CACHE,
) -> SceneSource:
    """Open a world, from which `query` takes scenes box by box.

    Parameters
    ----------
    path
        A folder of tiles that `nearfar.write_tiles` wrote, or a file that `Scene.load` reads: it is read whole, and the
        scene answers through its search trees.
    up, on_invalid, scale, max_bytes
        As in `Scene.load`. Folders of tiles are upright and in metres already.
    cache_bytes
        Memory of tiles that are kept for later queries.

    Returns
    -------
    SceneSource
        With `bounds` and `query`.

    Raises
    ------
    SceneError
        A file or folder that cannot be used.
    FormatError
        An index of tiles that is damaged, too new, or of a folder that is not finished.
    ValueError, TypeError
        Arguments out of their domains.
    OSError
        A file that cannot be opened.
    """
    target = check.path("path", path)
    most = check.integer("cache_bytes", cache_bytes, 0, 2**62)
    folder = target.parent if target.name == DOCUMENT else target
    if not folder.is_dir():
        return Scene.load(target, up=up, on_invalid=on_invalid, scale=scale, max_bytes=max_bytes)
    if not (folder / DOCUMENT).is_file():
        raise SceneError(f"{os.fspath(path)}: expected a file, or a folder of tiles with {DOCUMENT}")
    for name, value, default in (("up", up, "y"), ("scale", scale, None), ("max_bytes", max_bytes, None)):
        if value != default:
            raise ValueError(f"{name}: expected none with a folder of tiles, got {check.shortened(value)}")
    return TileFolder(folder, most)
