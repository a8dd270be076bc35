"""Converts cells of a tree to Gaussians: all views of a cell in one frame, without duplicate surfaces."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import formats
from nearfar.orthoview import _codec, _store
from nearfar.orthoview._files import Files
from nearfar.orthoview._gaussians import NO_GAUSSIANS, Gaussians, concatenate, gaussians_of
from nearfar.orthoview._grid import Place
from nearfar.orthoview._layout import Layout
from nearfar.orthoview._presence import UNBUILT
from nearfar.orthoview._thinned import Picture, is_duplicate

Sun = tuple[float, float, float] | None

_SUBTREES = 64
"""Number of subtrees whose records are cached."""


@dataclass(frozen=True, eq=False)
class Cell:
    """A cell's Gaussians."""

    level: int
    place: Place
    center: NDArray[np.float64]
    """World position (3,) that the Gaussians are relative to, metres."""
    gaussians: Gaussians
    pixels: int
    """Number of its views' non-empty pixels within the box."""


class Cells:
    """Reads cells of a tree at generation `newest`, and converts them to Gaussians.

    Gaussians whose centres are outside the world `box` (2, 3) are left out. `sun` is a unit vector towards the sun;
    None for unshaded colours.
    """

    def __init__(self, files: Files, layout: Layout, newest: int, box: NDArray[np.float64], sun: Sun) -> None:
        self.layout, self._address, self._box, self.sun = layout, files.address, box, sun
        self._chunks, read_cells = _store.open_generation(files, layout, newest)
        self._cells = lru_cache(_SUBTREES)(read_cells)

    def bounds(self) -> NDArray[np.float64]:
        """World box (2, 3) of all centres, metres."""
        root = self.layout.grid.box(self.layout.grid.levels - 1, (0, 0, 0))
        return np.array([np.maximum(root[0], self._box[0]), np.minimum(root[1], self._box[1])])

    def direction_mask(self, level: int, place: Place) -> int:
        """Mask with a bit for each direction from which a cell shows something; 0 for a cell outside the box.

        `UNBUILT` or `PARTIAL` for cells that an unfinished build has not composed.
        """
        if not self.layout.grid.touches(level, place, self._box):
            return 0
        shard, place_in_shard = self.layout.shard_of(level, place)
        tier, level_of_subtree = divmod(level, self.layout.subtree)
        return int(self._cells(tier, shard).masks[level_of_subtree][place_in_shard])

    def cells_down_to(
        self, finest: int, level: int | None = None, place: Place = (0, 0, 0)
    ) -> Iterator[tuple[int, Place]]:
        """Non-empty cells, from one cell (default: the root) down to level `finest`, each after its descendants."""
        level = self.layout.grid.levels - 1 if level is None else level
        if self.direction_mask(level, place) in (0, UNBUILT):
            return
        if level > finest:
            for _, child in self.layout.grid.children(level, place):
                yield from self.cells_down_to(finest, level - 1, child)
        yield level, place

    def cells_of_level(self, level: int) -> Iterator[tuple[int, Place]]:
        """Cells of a level that show something."""
        return (cell for cell in self.cells_down_to(level) if cell[0] == level)

    def chunks(self, level: int, place: Place) -> _codec.Encoded:
        """Read the chunks of all views of a cell, of both layers; not thread-safe."""
        mask = self.direction_mask(level, place)
        numbers = [number for number in range(len(self.layout.directions)) if mask >> number & 1]
        with formats.guarded(self._address, "orthoviews"):
            return self._chunks.read_views(level, place, numbers)

    def to_gaussians(self, level: int, place: Place, chunks: _codec.Encoded) -> Cell:
        """Convert a cell's chunks to Gaussians."""
        pictures = self._pictures(level, chunks)
        center = self.layout.grid.box(level, place).mean(axis=0)
        low, high = ((corner - center).astype(np.float32) for corner in self._box)
        parts, pixels = [NO_GAUSSIANS], 0
        for number, picture in enumerate(pictures):
            surfaces = picture.surfaces()
            is_inside = ((low <= surfaces.middle) & (surfaces.middle <= high)).all(axis=1)
            pixels += int(is_inside.sum())
            is_inside[is_inside] = ~is_duplicate(pictures, number, np.flatnonzero(is_inside))
            parts.append(gaussians_of(surfaces.select(is_inside), picture.axes, picture.pitch, self.sun))
        return Cell(level, place, center, concatenate(parts), pixels)

    def read(self, level: int, place: Place) -> Cell:
        return self.to_gaussians(level, place, self.chunks(level, place))

    def _pictures(self, level: int, chunks: _codec.Encoded) -> list[Picture]:
        """Decode the views of a cell, first layers before second ones."""
        side, steps, pictures = self.layout.grid.side(level), self.layout.steps, []
        with formats.guarded(self._address, "orthoviews"):
            layers_by_view = {number: _codec.decode(chunks, self.layout, (number,)) for number in chunks}
            for layer in range(self.layout.layers):
                for number, layers in layers_by_view.items():
                    axes, extents = _core.orthoview_axes(self.layout.directions[number])
                    for views, bits in layers[layer : layer + 1]:
                        picture = Picture.from_views(views, bits, np.array(axes), side * np.array(extents), steps)
                        pictures.append(picture)
        return pictures
