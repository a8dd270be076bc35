"""Implicit tiling of 3D Tiles 1.1, and of the earlier extension: quadtrees and octrees with availability bits."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import product
from operator import add
from typing import Any

import numpy as np

from nearfar._base.errors import UnusableError
from nearfar._scene.entries import choice, integer, typed
from nearfar._scene.tileset.subtree import MAX_LEVELS, BoxProperty, Subtree, tiles_above
from nearfar._scene.tileset.tile import StatedTile, Tile, missing_tile
from nearfar._scene.tileset.volumes import Box, Region, Sphere, Volume

_MAX_TREE_LEVELS = 64
"""Maximum depth of a tree: at this depth the cells of a tiling of the Earth are far smaller than atoms."""

EXTENSION = "3DTILES_implicit_tiling"

Cell = tuple[int, ...]

OpenSubtree = Callable[["Implicit", str], Subtree | None]
"""Reads a subtree by its tiling and its URI; None if its file is missing."""


@dataclass(frozen=True)
class Implicit:
    tile: StatedTile
    """Tile that declares the tiling; its contents are URI templates like `subtrees`."""
    volume: Box | Region
    """Volume of that tile."""
    axes: int
    """2 for a quadtree, 3 for an octree."""
    subtree_levels: int
    levels: int
    """Number of levels of the whole tree."""
    subtrees: str
    """URI template with {level}, {x}, {y} and {z}."""
    open_subtree: OpenSubtree
    boxes: dict[str, BoxProperty]
    """Metadata properties, by class name, with tiles' boxes, which override parts of `volume`."""

    def root(self) -> list[Tile]:
        """Tile of level 0, if it is available."""
        return self.subtree_root(0, (0,) * self.axes)

    def subtree_root(self, level: int, cell: Cell) -> list[Tile]:
        """Top tile of a subtree, if it is available; a tile for the subtree's file if that is missing."""
        uri = fill_template(self.subtrees, level, cell)
        subtree = self.open_subtree(self, uri)
        if subtree is None:
            return [missing_tile(self.tile, self.volume.part(level, cell), self.tile.error * 0.5**level, uri)]
        return [ImplicitTile(self, subtree, level, cell, 0, 0)] if subtree.tiles.bit(0) else []


class ImplicitTile(Tile):
    """A tile of an implicit tiling: its level and cell in the tree, and its depth and Morton number in a subtree."""

    __slots__ = ("_bit", "_cell", "_depth", "_level", "_number", "_subtree", "_tiling")

    def __init__(self, tiling: Implicit, subtree: Subtree, level: int, cell: Cell, depth: int, number: int) -> None:
        self._tiling, self._subtree = tiling, subtree
        self._level, self._cell, self._depth, self._number = level, cell, depth, number
        self._bit = bit = tiles_above(depth, tiling.axes) + number
        top = tiling.tile
        super().__init__(
            top.source,
            top.error * 0.5**level,
            top.replaces,
            top.transform,
            has_content=any(bits.bit(bit) for bits in subtree.contents[: len(top.contents)]),
            is_leaf=level + 1 >= tiling.levels,
        )

    @property
    def volume(self) -> Volume:
        """Box in the tile's metadata, else the tile's part of the tiling's volume."""
        subtree = self._subtree
        if subtree.boxes is not None:
            middle, *axes = subtree.boxes[subtree.tiles.rank(self._bit)]
            return Box(middle, np.array(axes))
        return self._tiling.volume.part(self._level, self._cell)

    @property
    def contents(self) -> tuple[str, ...]:
        """URIs of the available contents."""
        templates = zip(self._tiling.tile.contents, self._subtree.contents, strict=False)
        return tuple(
            fill_template(template, self._level, self._cell) for template, bits in templates if bits.bit(self._bit)
        )

    def expand(self) -> list[Tile]:
        """Create the available children."""
        tiling, subtree, depth = self._tiling, self._subtree, self._depth + 1
        children: list[Tile] = []
        first = tiles_above(depth, tiling.axes)
        first_child = [2 * coordinate for coordinate in self._cell]
        for corner, step in enumerate(_CHILD_OFFSETS[tiling.axes]):
            number = (self._number << tiling.axes) + corner
            is_inside = depth < tiling.subtree_levels
            if not (subtree.tiles.bit(first + number) if is_inside else subtree.children.bit(number)):
                continue
            cell = tuple(map(add, first_child, step))
            if is_inside:
                children.append(ImplicitTile(tiling, subtree, self._level + 1, cell, depth, number))
            else:
                children += tiling.subtree_root(self._level + 1, cell)
        return children


_CHILD_OFFSETS = {axes: [corner[::-1] for corner in product((0, 1), repeat=axes)] for axes in (2, 3)}
"""Offsets of a parent's children; the first axis changes fastest, as in Morton numbers."""


def tiling_entry_of(tile: dict[str, Any]) -> dict[str, Any] | None:
    """Return the entry of a tile that states an implicit tiling, of 1.1 or of the extension; None without."""
    extensions = tile.get("extensions")
    entry = tile.get("implicitTiling")
    if entry is None and isinstance(extensions, dict):
        entry = extensions.get(EXTENSION)
    return None if entry is None else typed(entry, dict, "implicitTiling")


def read(
    tile: StatedTile,
    entry: dict[str, Any],
    open_subtree: OpenSubtree,
    boxes: dict[str, BoxProperty],
) -> Implicit:
    """Read the tiling of a tile, whose content URIs are templates."""
    json_path = f"{tile.json_path}.implicitTiling"
    scheme = choice(entry.get("subdivisionScheme"), ("QUADTREE", "OCTREE"), f"{json_path}.subdivisionScheme")
    volume = tile.volume
    if isinstance(volume, Sphere):
        raise UnusableError(f"{json_path}: expected a box or a region, which can be divided, got a sphere")
    if "maximumLevel" in entry and "availableLevels" not in entry:  # drafts of the extension
        levels = integer(entry["maximumLevel"], 0, _MAX_TREE_LEVELS - 1, f"{json_path}.maximumLevel") + 1
    else:
        levels = integer(entry.get("availableLevels"), 1, _MAX_TREE_LEVELS, f"{json_path}.availableLevels")
    axes = 2 if scheme == "QUADTREE" else 3
    subtree_levels = integer(entry.get("subtreeLevels"), 1, MAX_LEVELS[axes], f"{json_path}.subtreeLevels")
    template = typed(entry.get("subtrees"), dict, f"{json_path}.subtrees").get("uri")
    return Implicit(
        tile=tile,
        volume=volume,
        axes=axes,
        subtree_levels=subtree_levels,
        levels=levels,
        subtrees=typed(template, str, f"{json_path}.subtrees.uri"),
        open_subtree=open_subtree,
        boxes=boxes,
    )


def fill_template(template: str, level: int, cell: Cell) -> str:
    """Fill in a URI template."""
    uri = template.replace("{level}", str(level))
    for name, number in zip("xyz", cell, strict=False):
        uri = uri.replace(f"{{{name}}}", str(number))
    return uri
