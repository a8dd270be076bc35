"""Implicit tiling of 3D Tiles 1.1 and of its earlier extension: quadtrees and octrees with availability bits."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import product
from operator import add
from typing import Any

import numpy as np

from nearfar._base.errors import UnusableError
from nearfar._scene.tileset import values
from nearfar._scene.tileset.frames import Floats
from nearfar._scene.tileset.metadata import BoxProperty
from nearfar._scene.tileset.subtree import MAX_LEVELS, Subtree, tiles_above
from nearfar._scene.tileset.tile import Source, StatedTile, Tile
from nearfar._scene.tileset.volumes import Box, Region, Sphere, Volume

_MAX_LEVELS = 64
"""Maximum depth of a tree: the Earth's cells are then far smaller than atoms."""

EXTENSION = "3DTILES_implicit_tiling"

Cell = tuple[int, ...]


@dataclass(frozen=True)
class Implicit:
    """One implicit tiling.

    Parameters
    ----------
    place, source
        The tile that states it, and its document.
    volume, error, replaces, transform
        Values of that tile.
    axes
        2 for a quadtree, 3 for an octree.
    subtree_levels, levels
        Number of levels of a subtree, and of the whole tree.
    subtrees, contents
        URI templates with {level}, {x}, {y} and {z}.
    open_subtree
        Reads a subtree; None if its file is missing.
    boxes
        Metadata properties with tiles' boxes, which override the subdivided volume, by class name.
    """

    place: str
    source: Source
    volume: Box | Region
    error: float
    replaces: bool
    transform: Floats
    axes: int
    subtree_levels: int
    levels: int
    subtrees: str
    contents: tuple[str, ...]
    open_subtree: Callable[[Implicit, str], Subtree | None]
    boxes: dict[str, BoxProperty]

    def root(self) -> list[Tile]:
        """Tile of level 0, if it is available."""
        return self.first_of_subtree(0, (0,) * self.axes)

    def first_of_subtree(self, level: int, cell: Cell) -> list[Tile]:
        """Top tile of a subtree, if it is available."""
        subtree = self.open_subtree(self, filled(self.subtrees, level, cell))
        is_there = subtree is not None and subtree.tiles.bit(0)
        return [ImplicitTile(self, subtree, level, cell, 0, 0)] if subtree is not None and is_there else []


class ImplicitTile(Tile):
    """A tile of an implicit tiling: its level and cell in the tree, and its depth and Morton number in a subtree."""

    __slots__ = ("_bit", "_cell", "_depth", "_level", "_number", "_subtree", "_tiling")

    def __init__(self, tiling: Implicit, subtree: Subtree, level: int, cell: Cell, depth: int, number: int) -> None:
        self._tiling, self._subtree = tiling, subtree
        self._level, self._cell, self._depth, self._number = level, cell, depth, number
        self._bit = bit = tiles_above(depth, tiling.axes) + number
        super().__init__(
            tiling.source,
            tiling.error * 0.5**level,
            tiling.replaces,
            tiling.transform,
            has_content=any(bits.bit(bit) for bits in subtree.contents[: len(tiling.contents)]),
            is_leaf=level + 1 >= tiling.levels,
        )

    @property
    def volume(self) -> Volume:
        """Box stated by its metadata, else its part of the tiling's volume."""
        subtree = self._subtree
        if subtree.boxes is not None:
            middle, *axes = subtree.boxes[subtree.tiles.rank(self._bit)]
            return Box(middle, np.array(axes))
        return self._tiling.volume.part(self._level, self._cell)

    @property
    def contents(self) -> tuple[str, ...]:
        """URIs of the available contents."""
        there = zip(self._tiling.contents, self._subtree.contents, strict=False)
        return tuple(filled(template, self._level, self._cell) for template, bits in there if bits.bit(self._bit))

    def expand(self) -> list[Tile]:
        """Make the available children."""
        tiling, subtree, depth = self._tiling, self._subtree, self._depth + 1
        children: list[Tile] = []
        first = tiles_above(depth, tiling.axes)
        twice = [2 * place for place in self._cell]
        for corner, step in enumerate(_CORNERS[tiling.axes]):
            number = (self._number << tiling.axes) + corner
            is_inside = depth < tiling.subtree_levels
            if not (subtree.tiles.bit(first + number) if is_inside else subtree.children.bit(number)):
                continue
            below = tuple(map(add, twice, step))
            if is_inside:
                children.append(ImplicitTile(tiling, subtree, self._level + 1, below, depth, number))
            else:
                children += tiling.first_of_subtree(self._level + 1, below)
        return children


_CORNERS = {axes: [corner[::-1] for corner in product((0, 1), repeat=axes)] for axes in (2, 3)}
"""Offsets of a parent's children; the first axis changes fastest, as in Morton numbers."""


def described_by(described: dict[str, Any]) -> dict[str, Any] | None:
    """Implicit tiling entry of a tile, of 1.1 or of the extension; None without one."""
    extensions = described.get("extensions")
    found = described.get("implicitTiling")
    if found is None and isinstance(extensions, dict):
        found = extensions.get(EXTENSION)
    return None if found is None else values.entries("implicitTiling", found)


def read(
    tile: StatedTile,
    stated: dict[str, Any],
    open_subtree: Callable[[Implicit, str], Subtree | None],
    boxes: dict[str, BoxProperty],
) -> Implicit:
    """Read the tiling of a tile, whose content URIs are templates."""
    place = f"{tile.place}.implicitTiling"
    scheme = values.choice(f"{place}.subdivisionScheme", stated.get("subdivisionScheme"), ("QUADTREE", "OCTREE"))
    volume = tile.volume
    if isinstance(volume, Sphere):
        raise UnusableError(f"{place}: expected a box or a region, which can be divided, got a sphere")
    if "maximumLevel" in stated and "availableLevels" not in stated:  # drafts of the extension
        levels = values.whole(f"{place}.maximumLevel", stated["maximumLevel"], 0, _MAX_LEVELS - 1) + 1
    else:
        levels = values.whole(f"{place}.availableLevels", stated.get("availableLevels"), 1, _MAX_LEVELS)
    axes = 2 if scheme == "QUADTREE" else 3
    most = MAX_LEVELS[axes]
    subtree_levels = values.whole(f"{place}.subtreeLevels", stated.get("subtreeLevels"), 1, most)
    template = values.entries(f"{place}.subtrees", stated.get("subtrees")).get("uri")
    return Implicit(
        place=tile.place,
        source=tile.source,
        volume=volume,
        error=tile.error,
        replaces=tile.replaces,
        transform=tile.transform,
        axes=axes,
        subtree_levels=subtree_levels,
        levels=levels,
        subtrees=values.text(f"{place}.subtrees.uri", template),
        contents=tile.contents,
        open_subtree=open_subtree,
        boxes=boxes,
    )


def filled(template: str, level: int, cell: Cell) -> str:
    """Fill in a URI template."""
    filled = template.replace("{level}", str(level))
    for name, number in zip("xyz", cell, strict=False):
        filled = filled.replace(f"{{{name}}}", str(number))
    return filled
