"""Converts cells of a tree to Gaussians: all views of a cell in one frame, each surface once."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import formats
from nearfar.orthoview import _codec, _store
from nearfar.orthoview._chunks import Chunks
from nearfar.orthoview._files import Files
from nearfar.orthoview._gaussians import NO_GAUSSIANS, Gaussians, concatenate, gaussians_of
from nearfar.orthoview._grid import Place
from nearfar.orthoview._layout import BEHIND, CHANNELS, Layout
from nearfar.orthoview._thinned import Picture, seen_better

Sun = tuple[float, float, float] | None

Chunk = tuple[int, dict[str, bytes]]
"""Direction number of a view, and its chunks by channel."""

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
    """Reads cells of a complete tree.

    Parameters
    ----------
    files, layout, newest
        The store, and the number of its newest generation.
    box
        World box (2, 3) that must contain the Gaussians' centres.
    sun
        Unit vector towards the sun; None for colours without light.
    """

    def __init__(self, files: Files, layout: Layout, newest: int, box: NDArray[np.float64], sun: Sun) -> None:
        self.layout, self._place, self._box, self._sun = layout, files.place, box, sun
        listed = _store.Listed(files, layout)
        self._chunks = Chunks(files, layout, _store.recorded_generations(files, layout, newest, listed))
        read = _store.cells_of(files, layout, newest, listed)
        self._masks: Callable[[int, Place], list[NDArray[np.uint32]]] = lru_cache(_SUBTREES)(
            lambda tier, place: read(tier, place).masks
        )

    def bounds(self) -> NDArray[np.float64]:
        """World box (2, 3) of all centres, metres."""
        whole = self.layout.grid.box(self.layout.grid.levels - 1, (0, 0, 0))
        return np.array([np.maximum(whole[0], self._box[0]), np.minimum(whole[1], self._box[1])])

    def direction_mask(self, level: int, place: Place) -> int:
        """Mask of the directions from which a cell shows something, a bit for each; 0 for a cell outside the box."""
        if not self.layout.grid.touches(level, place, self._box):
            return 0
        shard, within = self.layout.shard_of(level, place)
        tier, own = divmod(level, self.layout.subtree)
        return int(self._masks(tier, shard)[own][within])

    def below(self, finest: int) -> Iterator[tuple[int, Place]]:
        """Cells that show something, from the root down to level `finest`, each after its descendants."""
        yield from self._below(self.layout.grid.levels - 1, (0, 0, 0), finest)

    def cells_of_level(self, level: int) -> Iterator[tuple[int, Place]]:
        """Cells of a level that show something."""
        return (cell for cell in self.below(level) if cell[0] == level)

    def _below(self, level: int, place: Place, finest: int) -> Iterator[tuple[int, Place]]:
        if not self.direction_mask(level, place):
            return
        if level > finest:
            for _, child in self.layout.grid.children(level, place):
                yield from self._below(level - 1, child, finest)
        yield level, place

    def chunks(self, level: int, place: Place) -> list[Chunk]:
        """Read the chunks of all views of a cell, of both layers; not thread-safe."""
        mask = self.direction_mask(level, place)
        numbers = [number for number in range(len(self.layout.directions)) if mask >> number & 1]
        pairs = [(number, layer) for layer in ("", BEHIND)[: self.layout.layers] for number in numbers]
        keys = [
            (level, place, self.layout.array(level, number, layer + channel))
            for number, layer in pairs
            for channel in CHANNELS
        ]
        with formats.guarded(self._place, "orthoviews"):
            contents = iter(self._chunks.read(keys))
            found = [(number, {name: chunk for name in CHANNELS if (chunk := next(contents))}) for number, _ in pairs]
        return [(number, chunks) for number, chunks in found if chunks]  # few views have a second layer

    def to_gaussians(self, level: int, place: Place, chunks: list[Chunk]) -> Cell:
        """Convert a cell's chunks to Gaussians."""
        pictures = self._pictures(level, chunks)
        center = self.layout.grid.box(level, place).mean(axis=0)
        low, high = ((corner - center).astype(np.float32) for corner in self._box)
        parts, pixels = [NO_GAUSSIANS], 0
        for number, picture in enumerate(pictures):
            shown = picture.surfaces()
            inside = ((low <= shown.middle) & (shown.middle <= high)).all(axis=1)
            pixels += int(inside.sum())
            inside[inside] = ~seen_better(pictures, number, np.flatnonzero(inside))
            parts.append(gaussians_of(shown.select(inside), picture.axes, picture.pitch, self._sun))
        return Cell(level, place, center, concatenate(parts), pixels)

    def read(self, level: int, place: Place) -> Cell:
        """Read a cell."""
        return self.to_gaussians(level, place, self.chunks(level, place))

    def _pictures(self, level: int, chunks: list[Chunk]) -> list[Picture]:
        """Decode the views of a cell."""
        side, pictures = self.layout.grid.side(level), []
        with formats.guarded(self._place, "orthoviews"):
            for number, own in chunks:
                named = {(number, channel): chunk for channel, chunk in own.items()}
                views, bits = _codec.decoded(named, self.layout, (number,))
                axes, extents = _core.orthoview_axes(self.layout.directions[number])
                pictures.append(
                    Picture.from_views(views, bits, np.array(axes), side * np.array(extents), self.layout.steps)
                )
        return pictures
