"""Reads a tileset or a single tile: its frame, its bounds, and the content of the tiles selected to show it."""

from __future__ import annotations

import errno
import os
from dataclasses import replace
from typing import Any
from urllib.parse import urlsplit

import numpy as np

from nearfar._base import glb
from nearfar._base.errors import SceneError, UnusableError
from nearfar._scene import frames
from nearfar._scene.budget import Budget
from nearfar._scene.city.read import KINDS as CITY_KINDS
from nearfar._scene.content import Content
from nearfar._scene.frames import Floats, Frame
from nearfar._scene.names import distinct
from nearfar._scene.options import LoadOptions
from nearfar._scene.report import Unread, count, listing
from nearfar._scene.tileset import select
from nearfar._scene.tileset.document import Documents
from nearfar._scene.tileset.files import Files, Local, open_files
from nearfar._scene.tileset.reading import ContentCache, Reading
from nearfar._scene.tileset.tile import IDENTITY, Source, StatedTile, Tile
from nearfar._scene.tileset.volumes import Box, Region

KINDS = ("b3dm", "i3dm", "cmpt")
"""Suffixes of single tiles."""


class Tileset:
    """A tileset at a path or a URL; make one with `open`.

    Its tiles and their contents are read on demand; thread-safe.
    """

    def __init__(
        self, label: str, files: Files, root: Tile, documents: Documents | None, frame: Frame, cache: ContentCache
    ) -> None:
        self.label = label
        """The path or URL, for messages."""
        self.frame = frame
        """Transform from the tileset's frame to the scene's."""
        self.root = root
        self._files, self._documents, self._cache = files, documents, cache

    @classmethod
    def open(
        cls,
        path: str | os.PathLike[str],
        *,
        origin: Any = None,
        cache_bytes: float = np.inf,
        budget: Budget | None = None,
    ) -> Tileset:
        """Open a tileset's document, or a single b3dm, i3dm or cmpt, at a path or a URL that fsspec knows.

        `origin` is the longitude and latitude in degrees and the height in metres of the scene's (0, 0, 0), for a
        tileset on the Earth; by default the centre of its volume. `cache_bytes` is the size of the cache of contents,
        `budget` the limit of the bytes that a single tile may unpack to.

        SceneError for a file that is not a tileset or has an unsupported version, for an `origin` of a tileset off the
        Earth, and for no `origin` of one that covers the whole Earth; ValueError or TypeError for an invalid `origin`;
        OSError for a file that cannot be opened.
        """
        origin = frames.checked_origin(origin)
        files, cache = open_files(path), ContentCache(cache_bytes)
        label = os.fspath(path) if isinstance(files, Local) else str(path).partition("?")[0]
        try:
            if suffix(path) in KINDS:
                return _open_tile(label, files, origin, cache, Budget() if budget is None else budget)
            documents = Documents(files)
            root = documents.root()
            frame = _frame(root, origin)
        except UnusableError as error:
            raise SceneError(f"{label}: {error}") from error
        return cls(label, files, root, documents, frame, cache)

    @property
    def bounds(self) -> Floats:
        """Bounding box (2, 3) in the scene's frame, metres."""
        return self.root.bounds(self.frame.to_scene)

    def touches(self, box: Floats) -> bool:
        """Return False if no tile that shows the tileset in full detail touches a box (2, 3) in the scene's frame.

        Documents are read, but no contents. True if a part cannot be read; `read` reports why.
        """
        touches = select.box_test(box, self.frame.to_scene)
        try:
            return select.touches_full_detail(self.root, touches)
        except (UnusableError, OSError):
            return True

    def read(
        self,
        *,
        error: float = 0.0,
        triangles: int | None = None,
        box: Floats | None = None,
        budget: Budget | None = None,
    ) -> Content:
        """Read the content of the tiles that show the tileset, placed in the scene's frame.

        A tile that cannot be read is left out, and a note names it. If it would replace a coarser tile, the coarser one
        is shown. `error` is the greatest geometric error in metres; 0 shows all detail. `triangles`, if given, limits
        the number of triangles instead: tiles with the greatest errors are refined first. Only tiles that touch the
        `box` (2, 3) in the scene's frame are read, each as a whole. `budget` limits the bytes that the files may unpack
        to.

        SceneError for a tileset that refers to files outside its folder or to itself, or that is too large, for tiles
        that unpack to more bytes than the budget, and for fewer `triangles` than the coarsest tiles have; OSError for a
        URL that does not respond.
        """
        reading = Reading(self._files, self._cache, Budget() if budget is None else budget)
        touches = select.box_test(box, self.frame.to_scene)
        try:
            if triangles is None:
                selection = self._by_error(reading, error, touches)
            else:
                selection = select.by_triangles(self.root, triangles, touches, reading.sizes)
        except UnusableError as reason:
            raise SceneError(f"{self.label}: {reason}") from reason
        if triangles is not None and selection.triangles > triangles:
            raise SceneError(
                f"{self.label}: its coarsest tiles have {selection.triangles:,} triangles, more than {triangles:,}"
            )
        content, properties = reading.place_contents(selection.tiles, self.frame.to_scene, self.label)
        tile_count = sum(size is not None for size in reading.sizes(selection.tiles))
        content.nodes = replace(content.nodes, objects=distinct(content.nodes.objects))
        content.notes[:0] = self._notes(reading.failures, properties)
        if self._documents is not None:
            coarse = f", with a geometric error of up to {selection.error:g} m" if selection.error else ""
            content.used.insert(0, f"{count(tile_count, 'tile')} of 3D Tiles{coarse}")
        return content

    def _by_error(self, reading: Reading, error: float, touches: select.Touches) -> select.Selection:
        """Select tiles by geometric error. Where one cannot be read, the coarser tile that it replaces is shown."""
        unrefined: set[Tile] = set()
        while True:
            selection = select.by_error(self.root, error, touches, unrefined)
            sizes = reading.sizes(selection.tiles)
            failed = [tile for tile, size in zip(selection.tiles, sizes, strict=True) if size is None]
            coarser = {tile for tile in map(select.substitute, failed) if tile is not None} - unrefined
            if not coarser:
                return selection
            unrefined |= coarser

    def _notes(self, failures: dict[str, str], properties: int) -> list[str]:
        notes = [self.frame.note] if self.frame.note else []
        if failures:
            reasons = listing([f"{name} {reason}" for name, reason in failures.items()])
            notes.append(Unread(f"{count(len(failures), 'file')} of tiles left out: {reasons}"))
        if properties:
            notes.append(f"{count(properties, 'file')} of tiles with properties of features, which are ignored")
        return notes


def suffix(path: str | os.PathLike[str]) -> str:
    """Suffix of a path or URL in lower case, ignoring .gz."""
    text = os.fspath(path).lower()
    text = (urlsplit(text).path if "://" in text else text).removesuffix(".gz")
    return os.path.splitext(text)[1].lstrip(".")


def _frame(root: Tile, origin: tuple[float, float, float] | None) -> Frame:
    """Choose the scene's frame: at `origin`, at the centre of a tileset on the Earth, or the tileset's own."""
    box = root.bounds(IDENTITY)
    is_earth = bool((box[0] < -frames.RADIUS).all() and (box[1] > frames.RADIUS).all())
    local_frame = None if is_earth else frames.local_frame_at(root.middle)
    if origin is not None:
        if local_frame is None and not is_earth and not isinstance(root.volume, Region):
            raise UnusableError("it is not on the Earth, so origin does not apply to it")
        return frames.local(origin)
    if is_earth:
        raise UnusableError("it covers the whole Earth: state the place of the scene by origin")
    return frames.PLAIN if local_frame is None else local_frame


def _open_tile(
    label: str, files: Files, origin: tuple[float, float, float] | None, cache: ContentCache, budget: Budget
) -> Tileset:
    """Open a single tile as a tileset with the bounds of the tile's content."""
    tile = _top_tile(files, Box(np.zeros(3), np.zeros((3, 3))))
    reading = Reading(files, cache, budget)
    if reading.sizes([tile]) == [None]:
        reason = next(iter(reading.failures.values()))
        if reason == "is missing":
            raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), label)
        raise UnusableError(reason.removeprefix("cannot be used: "))
    box = _bounds(reading.place_contents([tile], IDENTITY, label)[0])
    if np.isfinite(box).all():
        tile = _top_tile(files, Box.of_extremes(box))
    return Tileset(label, files, tile, None, _frame(tile, origin), cache)


def _top_tile(files: Files, volume: Box) -> Tile:
    """Tile whose content is the file that was opened."""
    return StatedTile("tile", Source(files.top, "Y"), volume, 0.0, False, IDENTITY, ("",))


def _bounds(content: Content) -> Floats:
    """Bounding box (2, 3) of placed shapes; not finite if there are none."""
    nodes = content.nodes
    boxes = {
        name: Box.of_extremes(np.array([shape.vertices.min(axis=0), shape.vertices.max(axis=0)], np.float64))
        for name, shape in content.shapes.items()
        if len(shape.vertices)
    }
    pairs = zip(nodes.shapes, nodes.transforms, strict=True)
    placed = np.array([boxes[name].bounds(matrix) for name, matrix in pairs if name in boxes]).reshape(-1, 2, 3)
    return np.array([placed[:, 0].min(axis=0, initial=np.inf), placed[:, 1].max(axis=0, initial=-np.inf)])


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
