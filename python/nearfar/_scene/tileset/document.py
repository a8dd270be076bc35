"""Reads a tileset's documents, tileset.json and the tilesets that it refers to, as a tree of tiles."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from typing import Any
from urllib.parse import urlsplit

import numpy as np

from nearfar._base import check, glb
from nearfar._base.errors import UnusableError
from nearfar._scene.budget import Budget
from nearfar._scene.entries import at_least_zero, choice, coordinates, typed
from nearfar._scene.frames import Floats
from nearfar._scene.reasons import reason_of
from nearfar._scene.tileset import implicit, subtree, volumes
from nearfar._scene.tileset.files import Files
from nearfar._scene.tileset.implicit import Implicit
from nearfar._scene.tileset.tile import IDENTITY, Source, StatedTile, Tile, missing_tile

VERSIONS = ("0.0", "1.0", "1.1")
"""Supported versions of 3D Tiles."""

_SUPPORTED_EXTENSIONS = {implicit.EXTENSION, "3DTILES_content_gltf", "3DTILES_multiple_contents", "3DTILES_metadata"}
"""Supported extensions that tilesets may require."""


class NamedError(UnusableError):
    """Error: a document is unusable; the message names the document unless it is the top one."""


class Documents:
    """Reads the documents of a tileset, each once."""

    def __init__(self, files: Files) -> None:
        self._files = files
        self._parsed: dict[str, dict[str, Any]] = {}
        self._subtrees: dict[tuple[str, str, int, int], subtree.Subtree | None] = {}

    def root(self) -> Tile:
        """Root tile of the top document; NamedError if it is unusable."""
        with self._name_errors(self._files.top):
            return self._root_of(Source(self._files.top, "Y"), IDENTITY, replaces=False)

    def _root_of(self, source: Source, transform: Floats, *, replaces: bool) -> StatedTile:
        document = self._document(source.name)
        asset = typed(document.get("asset"), dict, "asset")
        if str(asset.get("version")) not in VERSIONS:
            stated = check.shortened(asset.get("version"))
            raise UnusableError(f"it is 3D Tiles {stated}, and only 1.0 and 1.1 are read")
        for name in typed(document.get("extensionsRequired", []), list, "extensionsRequired"):
            if name not in _SUPPORTED_EXTENSIONS:
                raise UnusableError(f"it needs the extension {check.shortened(name)}, which is not read")
        up = choice(asset.get("gltfUpAxis", "Y"), ("X", "Y", "Z"), "asset.gltfUpAxis")
        return self._tile("root", replace(source, up=up), document.get("root"), transform, replaces)

    def _document(self, name: str) -> dict[str, Any]:
        if name not in self._parsed:
            self._parsed[name] = glb.json_object(self.read(name))
        return self._parsed[name]

    def read(self, name: str) -> bytes:
        """Bytes of a document or a subtree, unpacked if it is gzip."""
        budget = Budget()
        return budget.unpacked_if_gzip(self._files.read(name, budget))

    def _tile(self, json_path: str, source: Source, entry: Any, parent_transform: Floats, replaces: bool) -> StatedTile:
        entry = typed(entry, dict, json_path)
        if entry.get("refine") is not None:
            replaces = choice(entry["refine"], ("ADD", "REPLACE"), f"{json_path}.refine") == "REPLACE"
        tiling_entry = implicit.tiling_entry_of(entry)
        contents = tuple(_contents(json_path, entry))
        tilesets = tuple(
            uri for uri in contents if tiling_entry is None and urlsplit(uri).path.lower().endswith(".json")
        )
        children = typed(entry.get("children", []), list, f"{json_path}.children")
        tile = StatedTile(
            json_path,
            source,
            volumes.read(f"{json_path}.boundingVolume", entry.get("boundingVolume")),
            at_least_zero(entry.get("geometricError", 0.0), f"{json_path}.geometricError"),
            replaces,
            _transform(f"{json_path}.transform", entry.get("transform"), parent_transform),
            tuple(uri for uri in contents if uri not in tilesets),
            partial(self._children, children, tilesets) if children or tilesets else None,
            is_reference=bool(tilesets),
        )
        if tiling_entry is None:
            return tile
        # The content URIs are templates for all tiles below; this tile itself only states the tiling.
        boxes = subtree.box_properties(self._document(source.name))
        tiling = implicit.read(tile, tiling_entry, self._subtree, boxes)
        root = partial(self._implicit_root, tiling)
        volume, error, transform = tile.volume, tile.error, tile.transform
        return StatedTile(json_path, source, volume, error, replaces, transform, (), root, is_reference=True)

    def _implicit_root(self, tiling: Implicit, tile: StatedTile) -> list[Tile]:
        with self._name_errors(tile.source.name):
            return tiling.root()

    def _children(self, children: list[Any], tilesets: tuple[str, ...], tile: StatedTile) -> list[Tile]:
        with self._name_errors(tile.source.name):
            stated = [
                self._tile(f"{tile.json_path}.children[{n}]", tile.source, child, tile.transform, tile.replaces)
                for n, child in enumerate(children)
            ]
            return [*stated, *(root for uri in tilesets for root in self._external(uri, tile))]

    def _external(self, uri: str, tile: StatedTile) -> list[Tile]:
        """Return the root of an external tileset, or a tile whose content is its file if that is missing."""
        source = tile.source
        name = self._files.resolve(source.name, uri)
        ancestors = (*source.referrers, source.name)
        if name in ancestors:
            cycle = " and ".join(map(self._files.display_name, ancestors[ancestors.index(name) :]))
            raise UnusableError(f"{tile.json_path}: it refers to itself, through {cycle}")
        with self._name_errors(name):
            try:
                return [self._root_of(Source(name, "Y", ancestors), tile.transform, replaces=tile.replaces)]
            except FileNotFoundError:
                return [missing_tile(tile, tile.volume, tile.error, uri)]

    def _subtree(self, tiling: Implicit, uri: str) -> subtree.Subtree | None:
        """Subtree of an implicit tiling; None if its file is missing."""
        key = (tiling.tile.source.name, uri, tiling.axes, tiling.subtree_levels)
        if key in self._subtrees:
            return self._subtrees[key]
        name = self._files.resolve(tiling.tile.source.name, uri)

        def read_relative(uri: str) -> bytes:
            return self.read(self._files.resolve(name, uri))

        try:
            data = self.read(name)
        except FileNotFoundError:
            self._subtrees[key] = None
        else:
            with self._name_errors(name):
                size = (tiling.axes, tiling.subtree_levels)
                self._subtrees[key] = subtree.read(data, *size, read_relative, tiling.boxes)
        return self._subtrees[key]

    @contextmanager
    def _name_errors(self, name: str) -> Iterator[None]:
        """Convert any exception caused by a damaged document to a NamedError."""
        try:
            yield
        except (NamedError, OSError, MemoryError):
            raise
        except Exception as error:
            prefix = "" if name == self._files.top else f"{self._files.display_name(name)}: "
            raise NamedError(f"{prefix}{reason_of(error)}") from error


def _contents(json_path: str, tile: dict[str, Any]) -> Iterator[str]:
    """URIs of a tile's content."""
    contents = typed(tile.get("contents", []), list, f"{json_path}.contents")
    extensions = tile.get("extensions", {})
    if isinstance(extensions, dict) and "3DTILES_multiple_contents" in extensions:
        more_contents = extensions["3DTILES_multiple_contents"]
        if isinstance(more_contents, dict):
            more_contents = more_contents.get("contents", more_contents.get("content"))
        contents = contents + typed(more_contents, list, f"{json_path}.contents")
    if tile.get("content") is not None:
        contents = [tile["content"], *contents]
    for content in contents:
        entry = typed(content, dict, f"{json_path}.content")
        # Tilesets before 1.0 use url.
        yield typed(entry.get("uri", entry.get("url")), str, f"{json_path}.content.uri")


def _transform(json_path: str, numbers: Any, parent_transform: Floats) -> Floats:
    """Compose the tile→tileset transform (4, 4): the parent's times the tile's own; documents are column-major."""
    if numbers is None:
        return parent_transform
    matrix = coordinates(numbers, 16, json_path).reshape(4, 4).T
    if not np.array_equal(matrix[3], (0, 0, 0, 1)):
        raise UnusableError(f"{json_path}: expected an affine transform, got the last row {matrix[3].tolist()}")
    return np.asarray(parent_transform @ matrix)
