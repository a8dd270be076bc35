"""Tiles, and the documents that state them."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from nearfar._scene.frames import Floats
from nearfar._scene.tileset.volumes import Region, Volume


@dataclass(frozen=True)
class Source:
    """A tileset's document."""

    name: str
    """Path or URL."""
    up: str
    """Up axis of its tiles' glTF: X, Y or Z."""
    referrers: tuple[str, ...] = ()
    """Names of the documents that refer to it, outermost first."""


@dataclass(slots=True, eq=False, repr=False)
class Tile(ABC):
    """A tile of a tileset; its children are made on demand."""

    source: Source
    """Document that states it."""
    error: float
    """Geometric error, metres: how far its content deviates from the world if its children are not shown."""
    replaces: bool
    """Whether its children replace its content; otherwise they are added to it."""
    transform: Floats
    """Tile→tileset (4, 4), float64."""
    has_content: bool
    is_leaf: bool
    """Whether the document states no tiles below it."""
    is_reference: bool = False
    """Whether the tile only refers to tiles described elsewhere, so that its children are always shown."""
    parent: Tile | None = None
    _children: list[Tile] | None = None

    @property
    @abstractmethod
    def volume(self) -> Volume:
        """Bounding volume of its content and all tiles below it, in its frame; regions are in the Earth's frame."""

    @property
    @abstractmethod
    def contents(self) -> tuple[str, ...]:
        """URIs of its content's files, as in the document."""

    @abstractmethod
    def expand(self) -> list[Tile]:
        """Make the tile's children."""

    @property
    def children(self) -> list[Tile]:
        """Child tiles: they replace the content in more detail, or add to it."""
        if self._children is None:
            self._children = [] if self.is_leaf else self.expand()
            for child in self._children:
                child.parent = self
        return self._children

    def bounds(self, to_scene: Floats) -> Floats:
        """Bounding box (2, 3) in the scene's frame; `to_scene` (4, 4) is the transform tileset→scene."""
        volume = self.volume
        # Regions lie on the Earth whatever the transform (3D Tiles 1.1, "Tile transforms").
        return volume.bounds(to_scene if isinstance(volume, Region) else to_scene @ self.transform)

    @property
    def middle(self) -> Floats:
        """Centre (3,) of its volume in the tileset's frame."""
        volume = self.volume
        if isinstance(volume, Region):
            return volume.middle
        return np.asarray(self.transform[:3, :3] @ volume.middle + self.transform[:3, 3])


class StatedTile(Tile):
    """A tile that a document states explicitly; `json_path` is its place for messages.

    `expand` makes its children; it is None for a leaf.
    """

    __slots__ = ("_contents", "_expand", "_volume", "json_path")

    def __init__(
        self,
        json_path: str,
        source: Source,
        volume: Volume,
        error: float,
        replaces: bool,
        transform: Floats,
        contents: tuple[str, ...],
        expand: Callable[[StatedTile], list[Tile]] | None = None,
        *,
        is_reference: bool = False,
    ) -> None:
        super().__init__(source, error, replaces, transform, bool(contents), expand is None, is_reference)
        self.json_path, self._volume, self._contents, self._expand = json_path, volume, contents, expand

    @property
    def volume(self) -> Volume:
        return self._volume

    @property
    def contents(self) -> tuple[str, ...]:
        return self._contents

    def expand(self) -> list[Tile]:
        return [] if self._expand is None else self._expand(self)


def missing_tile(referrer: StatedTile, volume: Volume, error: float, uri: str) -> StatedTile:
    """Make a tile that stands for the tiles of a missing file; its content is that file.

    It is treated as any tile with missing content: left out, or replaced by a coarser tile.
    """
    path, source = referrer.json_path, referrer.source
    return StatedTile(path, source, volume, error, referrer.replaces, referrer.transform, (uri,))


IDENTITY = np.eye(4)
"""Transform of tiles that state none."""
