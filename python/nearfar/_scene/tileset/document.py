"""Reads documents of tilesets, tileset.json and the tilesets that it refers to, as trees of tiles."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from typing import Any
from urllib.parse import urlsplit

import numpy as np

from nearfar._base import check, glb
from nearfar._base.errors import UnusableError
from nearfar._scene.budget import Budget
from nearfar._scene.reasons import LONGEST, sentence
from nearfar._scene.tileset import implicit, metadata, subtree, values, volumes
from nearfar._scene.tileset.files import Files
from nearfar._scene.tileset.frames import Floats
from nearfar._scene.tileset.implicit import Implicit
from nearfar._scene.tileset.tile import IDENTITY, Source, StatedTile, Tile

VERSIONS = ("0.0", "1.0", "1.1")
"""Supported versions of 3D Tiles."""

_KNOWN = {
    implicit.EXTENSION,
    "3DTILES_content_gltf",
    "3DTILES_multiple_contents",
    "3DTILES_metadata",
}
"""Supported extensions that tilesets may require."""

_GZIP = b"\x1f\x8b"


class NamedError(UnusableError):
    """Error: a document is unusable; the message names it unless it is the top one."""


class Documents:
    """Reads the documents of a tileset, each once.

    Parameters
    ----------
    files
        Reads the tileset's files.
    """

    def __init__(self, files: Files) -> None:
        self._files = files
        self._parsed: dict[str, dict[str, Any]] = {}
        self._subtrees: dict[tuple[str, str, int, int], subtree.Subtree | None] = {}
        self.missing: dict[str, None] = {}
        """Names of missing tilesets and subtrees; the tiles below them are left out."""

    def root(self) -> Tile:
        """Root tile of the top document; NamedError if it is unusable."""
        with self._errors_named(self._files.top):
            return self._root_of(Source(self._files.top, "Y"), IDENTITY, replaces=False)

    def _root_of(self, source: Source, transform: Floats, *, replaces: bool) -> StatedTile:
        document = self._document(source.name)
        asset = values.entries("asset", document.get("asset"))
        if str(asset.get("version")) not in VERSIONS:
            stated = check.shortened(asset.get("version"))
            raise UnusableError(f"it is 3D Tiles {stated}, and only 1.0 and 1.1 are read")
        for name in values.items("extensionsRequired", document.get("extensionsRequired", [])):
            if name not in _KNOWN:
                raise UnusableError(f"it needs the extension {check.shortened(name)}, which is not read")
        up = values.choice("asset.gltfUpAxis", asset.get("gltfUpAxis", "Y"), ("X", "Y", "Z"))
        source = Source(source.name, up, source.above)
        return self._tile("root", source, document.get("root"), transform, replaces)

    def _document(self, name: str) -> dict[str, Any]:
        if name not in self._parsed:
            self._parsed[name] = glb.json_object(self.read(name))
        return self._parsed[name]

    def read(self, name: str) -> bytes:
        """Bytes of a document or a subtree, unpacked if it is gzip."""
        budget = Budget()
        data = self._files.read(name, budget)
        return budget.unpacked(data) if data.startswith(_GZIP) else data

    def _tile(self, place: str, source: Source, described: Any, above: Floats, replaces: bool) -> StatedTile:
        described = values.entries(place, described)
        if described.get("refine") is not None:
            replaces = values.choice(f"{place}.refine", described["refine"], ("ADD", "REPLACE")) == "REPLACE"
        stated = implicit.described_by(described)
        contents = tuple(_contents(place, described))
        tilesets = tuple(uri for uri in contents if stated is None and _is_tileset(uri))
        children = values.items(f"{place}.children", described.get("children", []))
        tile = StatedTile(
            place,
            source,
            volumes.read(f"{place}.boundingVolume", described.get("boundingVolume")),
            values.number(f"{place}.geometricError", described.get("geometricError", 0.0)),
            replaces,
            _transform(f"{place}.transform", described.get("transform"), above),
            tuple(uri for uri in contents if uri not in tilesets),
            partial(self._children, children, tilesets) if children or tilesets else None,
            refers=bool(tilesets),
        )
        if stated is None:
            return tile
        # The content URIs are templates for all tiles below; this tile itself only states the tiling.
        boxes = metadata.box_properties(self._document(source.name))
        tiling = implicit.read(tile, stated, self._subtree, boxes)
        root = partial(self._implicit_root, tiling)
        return StatedTile(place, source, tile.volume, tile.error, replaces, tile.transform, (), root, refers=True)

    def _implicit_root(self, tiling: Implicit, tile: StatedTile) -> list[Tile]:
        with self._errors_named(tile.source.name):
            return tiling.root()

    def _children(self, children: list[Any], tilesets: tuple[str, ...], tile: StatedTile) -> list[Tile]:
        with self._errors_named(tile.source.name):
            found: list[Tile] = [
                self._tile(f"{tile.place}.children[{n}]", tile.source, child, tile.transform, tile.replaces)
                for n, child in enumerate(children)
            ]
            for uri in tilesets:
                found += self._external(uri, tile)
            return found

    def _external(self, uri: str, tile: StatedTile) -> list[Tile]:
        """Root tile of an external tileset; empty if its file is missing."""
        source = tile.source
        name = self._files.resolve(source.name, uri)
        above = (*source.above, source.name)
        if name in above:
            through = " and ".join(map(self._files.display_name, above[above.index(name) :]))
            raise UnusableError(f"{tile.place}: it refers to itself, through {through}")
        with self._errors_named(name):
            try:
                return [self._root_of(Source(name, "Y", above), tile.transform, replaces=tile.replaces)]
            except FileNotFoundError:
                self.missing[name] = None
                return []

    def _subtree(self, tiling: Implicit, uri: str) -> subtree.Subtree | None:
        """Subtree of an implicit tiling; None if its file is missing."""
        key = (tiling.source.name, uri, tiling.axes, tiling.subtree_levels)
        if key not in self._subtrees:
            self._subtrees[key] = self._read_subtree(tiling, uri)
        return self._subtrees[key]

    def _read_subtree(self, tiling: Implicit, uri: str) -> subtree.Subtree | None:
        name = self._files.resolve(tiling.source.name, uri)
        try:
            data = self.read(name)
        except FileNotFoundError:
            self.missing[name] = None
            return None
        with self._errors_named(name):
            return subtree.read(data, tiling.axes, tiling.subtree_levels, partial(self._beside, name), tiling.boxes)

    def _beside(self, name: str, uri: str) -> bytes:
        return self.read(self._files.resolve(name, uri))

    @contextmanager
    def _errors_named(self, name: str) -> Iterator[None]:
        """Convert any exception caused by a damaged document to an error that names it."""
        try:
            yield
        except (NamedError, OSError):
            raise
        except Exception as error:
            reason = check.one_line(sentence(error), LONGEST)
            where = "" if name == self._files.top else f"{self._files.display_name(name)}: "
            raise NamedError(f"{where}{reason}") from error


def _contents(place: str, described: dict[str, Any]) -> Iterator[str]:
    """URIs of a tile's content."""
    listed = values.items(f"{place}.contents", described.get("contents", []))
    extensions = described.get("extensions", {})
    if isinstance(extensions, dict) and "3DTILES_multiple_contents" in extensions:
        several = extensions["3DTILES_multiple_contents"]
        several = several.get("contents", several.get("content")) if isinstance(several, dict) else several
        listed = listed + values.items(f"{place}.contents", several)
    if described.get("content") is not None:
        listed = [described["content"], *listed]
    for content in listed:
        entry = values.entries(f"{place}.content", content)
        # Tilesets before 1.0 use url.
        yield values.text(f"{place}.content.uri", entry.get("uri", entry.get("url")))


def _is_tileset(uri: str) -> bool:
    return urlsplit(uri).path.lower().endswith(".json")


def _transform(place: str, stated: Any, above: Floats) -> Floats:
    """Compose the tile→tileset transform (4, 4): the parent's times the tile's own, column-major in documents."""
    if stated is None:
        return above
    matrix = values.numbers(place, stated, 16).reshape(4, 4).T
    if not np.array_equal(matrix[3], (0, 0, 0, 1)):
        raise UnusableError(f"{place}: expected an affine transform, got the last row {matrix[3].tolist()}")
    placed: Floats = above @ matrix
    return placed
