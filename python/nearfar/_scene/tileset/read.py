"""Reads a tileset, or a single tile, for a scene."""

from __future__ import annotations

import os

from nearfar._base import glb
from nearfar._base.errors import UnusableError
from nearfar._scene.budget import Budget
from nearfar._scene.city.read import KINDS as CITY_KINDS
from nearfar._scene.content import Content
from nearfar._scene.options import LoadOptions
from nearfar._scene.tileset.tileset import KINDS, Tileset, suffix


def check_options(path: str | os.PathLike[str], options: LoadOptions) -> None:
    """Reject options of tilesets for other files; footprints may have an origin, too."""
    if suffix(path) not in (*KINDS, "json"):
        for name in ("error", "triangles", *(() if suffix(path) in CITY_KINDS else ("origin",))):
            if getattr(options, name) is not None:
                raise ValueError(f"{name}: expected none with {os.fspath(path)}, which is no tileset")


def check_unused(options: LoadOptions) -> None:
    """Reject options of tilesets for JSON that is not a tileset; UnusableError."""
    for name in ("error", "triangles"):
        if getattr(options, name) is not None:
            raise UnusableError(f"it is no tileset: {name} does not apply to it")


def is_tileset(data: bytes) -> bool:
    """Whether a JSON file holds a tileset."""
    document = glb.json_object(data)
    return "root" in document and "asset" in document


def read(path: str | os.PathLike[str], options: LoadOptions, budget: Budget) -> Content:
    """Read a tileset, or a single b3dm, i3dm or cmpt; errors are those of `Tileset.open` and `Tileset.read`."""
    if "://" in os.fspath(path) and suffix(path) not in (*KINDS, "json"):
        raise UnusableError("only 3D Tiles are read from URLs: download this file")
    tileset = Tileset.open(path, origin=options.origin, budget=budget)
    error = 0.0 if options.error is None else options.error
    return tileset.read(error=error, triangles=options.triangles, budget=budget)
