"""A store opened for viewing; a newer generation takes over its unchanged views and leaves."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import islice

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import formats
from nearfar._base.errors import FormatError
from nearfar.orthoview import _store
from nearfar.orthoview._chunks import Chunks, Generation
from nearfar.orthoview._cut import GEOMETRY, Cutter, Part
from nearfar.orthoview._files import Files
from nearfar.orthoview._geometry_store import names
from nearfar.orthoview._grid import Grid, Place
from nearfar.orthoview._layout import CHANNELS, Layout, ViewKey
from nearfar.orthoview._near import Near
from nearfar.orthoview._viewer import Viewer
from nearfar.orthoview._views import Views


@dataclass(frozen=True)
class Opened:
    """A complete store at one of its generations."""

    files: Files
    layout: Layout
    generation: int
    cache_bytes: int
    chunks: Chunks
    viewer: Viewer

    @classmethod
    def from_files(cls, files: Files, layout: Layout, generation: int, cache_bytes: int) -> Opened:
        """Open the documents of a generation."""
        chunks, read_cells = _store.open_generation(files, layout, generation)
        views, near = Views(files.address, chunks, layout, cache_bytes), Near(files.address, chunks, layout.grid)
        return cls(files, layout, generation, cache_bytes, chunks, Viewer(Cutter(layout, read_cells), views, near))

    @property
    def grid(self) -> Grid:
        """Grid of the tree's cells."""
        return self.layout.grid

    @property
    def units(self) -> NDArray[np.float64]:
        """Unit vectors (D, 3) of the tree's directions."""
        return np.array([_core.orthoview_axes(direction)[0][2] for direction in self.layout.directions])

    def sizes(self, parts: Sequence[Part]) -> list[int]:
        """Bytes of views, and of leaves' geometry without textures."""
        views = [part for part in parts if part[2] != GEOMETRY]
        lengths, count = iter(self.chunks.lengths(self.layout.view_keys(views))), len(self.layout.channels)
        return [
            self._geometry_size(place) if direction == GEOMETRY else sum(islice(lengths, count))
            for _, place, direction in parts
        ]

    def _geometry_size(self, place: Place) -> int:
        return sum(len(self.chunks.geometry(name) or b"") for name in names(self.grid, place))

    def newer(self) -> Opened | None:
        """Open the newest generation, with the unchanged views and leaves of this one; None if this is the newest."""
        attributes = _store.read(self.files)
        with formats.guarded(f"{self.files.address}/{_store.DOCUMENT}"):
            newest = int(attributes["generation"])
            is_same_layout = Layout.from_described(attributes["layout"]) == self.layout
        if newest <= self.generation:
            return None
        if not is_same_layout:
            raise FormatError(f"{self.files.address}: another tree was built in this place, open it anew")
        opened = Opened.from_files(self.files, self.layout, newest, self.cache_bytes)
        overlays = _store.generations(self.files, newest)[: newest - self.generation]
        opened.viewer.views.take_over(self.viewer.views, _changed_views(self.layout, overlays))
        opened.viewer.near.take_over(self.viewer.near, _changed_leaves(self.grid, overlays))
        return opened


def _changed_views(layout: Layout, overlays: list[Generation]) -> Callable[[ViewKey], bool]:
    """Return whether generations may have changed a view: one of them has a shard with its place."""

    def is_changed(key: ViewKey) -> bool:
        level, place, direction = key
        path = layout.shard_path((level, place, layout.array(level, direction, CHANNELS[0])))
        return any(overlay.has_shard is not None and overlay.has_shard(path) for overlay in overlays)

    return is_changed


def _changed_leaves(grid: Grid, overlays: list[Generation]) -> Callable[[Place], bool]:
    """Return whether one of the generations has another file of a leaf."""

    def is_changed(place: Place) -> bool:
        checks = [overlay.has_geometry for overlay in overlays]
        return any(has_file is not None and any(map(has_file, names(grid, place))) for has_file in checks)

    return is_changed
