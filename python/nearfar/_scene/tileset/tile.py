"""Tiles, and the documents that they come from."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from nearfar._scene.tileset.frames import Floats
from nearfar._scene.tileset.volumes import Region, Volume


@dataclass(frozen=True)
class Source:
    """A tileset's document."""

    name: str
    """Path or URL."""
    up: str
    """Axis of its tiles' glTF that points up: X, Y or Z."""
    above: tuple[str, ...] = ()
    """Names of the documents that it is referred to through, the first one's first."""


class Tile(ABC):
    """A tile of a tileset; its children are made when they are asked for.

    Parameters
    ----------
    source
        The document.
    error
        Metres by which its content leaves the world, where its children are not shown.
    replaces
        Whether its children take the place of its content; otherwise they are added to it.
    transform
        Tile→tileset (4, 4), float64.
    has_content
        Whether it has something to show.
    is_leaf
        Whether no tiles are below it as far as the document says.
    refers
        Whether it only says where other tiles are described, so that its children are always shown.
    """

    __slots__ = (
        "_children",
        "error",
        "has_content",
        "is_leaf",
        "parent",
        "refers",
        "replaces",
        "source",
        "transform",
    )

    def __init__(
        self,
        source: Source,
        error: float,
        replaces: bool,
        transform: Floats,
        *,
        has_content: bool,
        is_leaf: bool,
        refers: bool = False,
    ) -> None:
        self.source, self.error, self.replaces, self.transform = source, error, replaces, transform
        self.has_content, self.is_leaf, self.refers = has_content, is_leaf, refers
        self.parent: Tile | None = None
        self._children: list[Tile] | None = None

    @property
    @abstractmethod
    def volume(self) -> Volume:
        """Volume around its content and that of the tiles below it, in its frame; regions lie on the Earth."""

    @property
    @abstractmethod
    def contents(self) -> tuple[str, ...]:
        """References to its content's files, as the document states them."""

    @abstractmethod
    def expand(self) -> list[Tile]:
        """Make its children."""

    @property
    def children(self) -> list[Tile]:
        """Tiles that show the same with more detail, or what there is beside its content."""
        if self._children is None:
            children = [] if self.is_leaf else self.expand()
            for child in children:
                child.parent = self
            self._children = children
        return self._children

    def bounds(self, to_scene: Floats) -> Floats:
        """Box (2, 3) in the scene's frame around it; `to_scene` (4, 4) takes from the tileset's frame there."""
        volume = self.volume
        # Regions lie on the Earth whatever the transform is (3D Tiles 1.1, "Tile transforms").
        return volume.bounds(to_scene if isinstance(volume, Region) else to_scene @ self.transform)

    @property
    def middle(self) -> Floats:
        """Middle (3,) of its volume in the tileset's frame."""
        volume = self.volume
        if isinstance(volume, Region):
            return volume.middle
        middle: Floats = self.transform[:3, :3] @ volume.middle + self.transform[:3, 3]
        return middle


class StatedTile(Tile):
    """A tile that a document describes.

    Parameters
    ----------
    place
        Its entry in the document, for messages.
    volume, contents
        What the properties of these names return.
    expand
        Makes its children; None for a leaf.
    source, error, replaces, transform, refers
        As for all tiles.
    """

    __slots__ = ("_contents", "_expand", "_volume", "place")

    def __init__(
        self,
        place: str,
        source: Source,
        volume: Volume,
        error: float,
        replaces: bool,
        transform: Floats,
        contents: tuple[str, ...],
        expand: Callable[[StatedTile], list[Tile]] | None = None,
        *,
        refers: bool = False,
    ) -> None:
        has_content, is_leaf = bool(contents), expand is None
        super().__init__(source, error, replaces, transform, has_content=has_content, is_leaf=is_leaf, refers=refers)
        self.place, self._volume, self._contents, self._expand = place, volume, contents, expand

    @property
    def volume(self) -> Volume:
        """The stated volume."""
        return self._volume

    @property
    def contents(self) -> tuple[str, ...]:
        """The stated references."""
        return self._contents

    def expand(self) -> list[Tile]:
        """Make the stated children."""
        return [] if self._expand is None else self._expand(self)


IDENTITY = np.eye(4)
"""The transform of tiles that state none."""
