"""The `Tileset` class: frame, bounds, and the content of the tiles that show it."""

from __future__ import annotations

import errno
import os
from typing import Any
from urllib.parse import urlsplit

import numpy as np

from nearfar._base.errors import SceneError, UnusableError
from nearfar._scene.budget import Budget
from nearfar._scene.content import Content, Nodes
from nearfar._scene.names import distinct
from nearfar._scene.report import count
from nearfar._scene.tileset import frames, select
from nearfar._scene.tileset.document import Documents
from nearfar._scene.tileset.files import Files, Local, open_files
from nearfar._scene.tileset.frames import Floats, Frame
from nearfar._scene.tileset.reading import Kept, Reading
from nearfar._scene.tileset.tile import IDENTITY, Source, StatedTile, Tile
from nearfar._scene.tileset.volumes import Box, Region

KINDS = ("b3dm", "i3dm", "cmpt")
"""Suffixes of single tiles."""

_MAX_NAMED = 3
"""Maximum number of files named in a note."""


class Tileset:
    """A tileset at a path or a URL; make one with `open`.

    Its tiles and their contents are read on demand; thread-safe.
    """

    def __init__(
        self, label: str, files: Files, root: Tile, documents: Documents | None, frame: Frame, kept: Kept
    ) -> None:
        self.label = label
        """The path or URL, for messages."""
        self.frame = frame
        """Transform from the tileset's frame to the scene's."""
        self.root = root
        """Root tile."""
        self._files, self._documents, self._kept = files, documents, kept

    @classmethod
    def open(
        cls,
        path: str | os.PathLike[str],
        *,
        origin: Any = None,
        cache_bytes: float = np.inf,
        budget: Budget | None = None,
    ) -> Tileset:
        """Open a tileset's document, or a single b3dm, i3dm or cmpt.

        Parameters
        ----------
        path
            A path, or a URL that fsspec knows.
        origin
            Longitude and latitude in degrees and height in metres of the scene's (0, 0, 0), for a tileset on the Earth;
            by default the centre of its volume.
        cache_bytes
            Size of the cache of contents, bytes.
        budget
            Limit of the bytes that a single tile may unpack to.

        Raises
        ------
        SceneError
            A file that is not a tileset, or one of an unsupported version; an `origin` for a tileset that does not lie
            on the Earth, or none for one that covers the whole Earth.
        ValueError, TypeError
            An invalid `origin`.
        OSError
            A file that cannot be opened.
        """
        place = frames.checked_origin(origin)
        files, kept = open_files(path), Kept(cache_bytes)
        label = os.fspath(path) if isinstance(files, Local) else str(path).partition("?")[0]
        try:
            if suffix(path) in KINDS:
                return _of_tile(label, files, place, kept, Budget() if budget is None else budget)
            documents = Documents(files)
            root = documents.root()
            frame = _frame(root, place)
        except UnusableError as error:
            raise SceneError(f"{label}: {error}") from error
        return cls(label, files, root, documents, frame, kept)

    @property
    def bounds(self) -> Floats:
        """Bounding box (2, 3) in the scene's frame, metres."""
        return self.root.bounds(self.frame.to_scene)

    def read(
        self,
        *,
        error: float = 0.0,
        triangles: int | None = None,
        box: Floats | None = None,
        budget: Budget | None = None,
    ) -> Content:
        """Read the content of the tiles that show the tileset, placed in the scene's frame.

        A tile that cannot be read is left out, and a note names it; where tiles replace others, the coarser one stays.

        Parameters
        ----------
        error
            Greatest geometric error in metres; 0 shows all detail.
        triangles
            Greatest number of triangles instead of an error: tiles with the greatest errors are refined first.
        box
            Box (2, 3) of the scene whose tiles are read as a whole; None for everything.
        budget
            Limit of the bytes that the files may unpack to.

        Raises
        ------
        SceneError
            A tileset that leads outside its folder or to itself, is too large, or whose tiles unpack to too much; fewer
            `triangles` than the coarsest tiles have.
        OSError
            A URL that does not respond.
        """
        reading = Reading(self._files, self._kept, Budget() if budget is None else budget)
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
        shown = sum(size is not None for size in reading.sizes(selection.tiles))
        content.nodes = Nodes(distinct(content.nodes.objects), content.nodes.transforms, content.nodes.shapes)
        content.notes[:0] = self._notes(shown, selection.error, reading.failures, properties)
        return content

    def _by_error(self, reading: Reading, error: float, touches: select.Touches) -> select.Selection:
        """Select tiles by geometric error. Where one cannot be read, the coarser tile that it replaces is shown."""
        unrefined: set[Tile] = set()
        while True:
            selection = select.by_error(self.root, error, touches, unrefined)
            sizes = reading.sizes(selection.tiles)
            failed = [tile for tile, size in zip(selection.tiles, sizes, strict=True) if size is None]
            keepers = {above for tile in failed if (above := select.keeper(tile)) is not None} - unrefined
            if not keepers:
                return selection
            unrefined |= keepers

    def _notes(self, shown: int, error: float, failures: dict[str, str], properties: int) -> list[str]:
        notes = [self.frame.note] if self.frame.note else []
        if self._documents is not None:
            coarse = f" with a geometric error of up to {error:g} m" if error else ""
            notes.append(f"{count(shown, 'tile')} of 3D Tiles read{coarse}")
            failures = failures | {self._files.display_name(name): "is missing" for name in self._documents.missing}
        if failures:
            named = ", ".join(f"{name} {reason}" for name, reason in list(failures.items())[:_MAX_NAMED])
            more = f", and {len(failures) - _MAX_NAMED:,} more" if len(failures) > _MAX_NAMED else ""
            notes.append(f"{count(len(failures), 'file')} of tiles left out: {named}{more}")
        if properties:
            notes.append(f"{count(properties, 'file')} of tiles with properties of features, which are ignored")
        return notes


def suffix(path: str | os.PathLike[str]) -> str:
    """Suffix of a path or URL in lower case, ignoring .gz."""
    text = os.fspath(path).lower()
    text = (urlsplit(text).path if "://" in text else text).removesuffix(".gz")
    return os.path.splitext(text)[1].lstrip(".")


def _frame(root: Tile, origin: tuple[float, float, float] | None) -> Frame:
    """The scene's frame: at the origin, else at the centre of a tileset on the Earth, else the tileset's own."""
    box = root.bounds(IDENTITY)
    is_earth = bool((box[0] < -frames.RADIUS).all() and (box[1] > frames.RADIUS).all())
    found = None if is_earth else frames.local_frame_at(root.middle)
    if origin is not None:
        if found is None and not is_earth and not isinstance(root.volume, Region):
            raise UnusableError("it does not lie on the Earth, where an origin has a meaning")
        return frames.local(origin)
    if is_earth:
        raise UnusableError("it covers the whole Earth: state the place of the scene by origin")
    return frames.PLAIN if found is None else found


def _of_tile(
    label: str, files: Files, origin: tuple[float, float, float] | None, kept: Kept, budget: Budget
) -> Tileset:
    """Make a tileset of a single tile."""
    tile = _alone(files, Box(np.zeros(3), np.zeros((3, 3))))
    reading = Reading(files, kept, budget)
    if reading.sizes([tile]) == [None]:
        reason = next(iter(reading.failures.values()))
        if reason == "is missing":
            raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), label)
        raise UnusableError(reason.removeprefix("cannot be used: "))
    box = _bounds(reading.place_contents([tile], IDENTITY, label)[0])
    if np.isfinite(box).all():
        tile = _alone(files, Box(box.mean(axis=0), np.diag(np.ptp(box, axis=0) / 2)))
    return Tileset(label, files, tile, None, _frame(tile, origin), kept)


def _alone(files: Files, volume: Box) -> Tile:
    """Tile for the top file."""
    return StatedTile("tile", Source(files.top, "Y"), volume, 0.0, False, IDENTITY, ("",))


def _bounds(content: Content) -> Floats:
    """Bounding box (2, 3) of placed shapes; not finite if there are none."""
    nodes = content.nodes
    boxes = {
        name: np.array([shape.vertices.min(axis=0), shape.vertices.max(axis=0)], np.float64)
        for name, shape in content.shapes.items()
        if len(shape.vertices)
    }
    low, high = np.full(3, np.inf), np.full(3, -np.inf)
    for name, matrix in zip(nodes.shapes, nodes.transforms, strict=True):
        if name in boxes:
            placed = Box(boxes[name].mean(axis=0), np.diag(np.ptp(boxes[name], axis=0) / 2)).bounds(matrix)
            low, high = np.minimum(low, placed[0]), np.maximum(high, placed[1])
    return np.array([low, high])
