"""Content of the store of an open tree: cells, their views, and the geometry of leaves."""

from __future__ import annotations

import os
from typing import Any, SupportsIndex

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import check, formats
from nearfar.orthoview import _codec, _store
from nearfar.orthoview._files import files_at
from nearfar.orthoview._geometry_store import names
from nearfar.orthoview._grid import Direction, Place
from nearfar.orthoview._layout import Layout, check_zarr
from nearfar.orthoview._view import OrthoView


class StoredTree:
    """Store of a tree in a folder or behind a URL; for errors see `OrthoTree`."""

    def __init__(self, path: str | os.PathLike[str]) -> None:
        check_zarr()
        self._files = files_at(path)
        self._attributes = _store.read(self._files)
        with formats.guarded(f"{self.path}/{_store.DOCUMENT}"):
            self._layout = Layout.from_described(self._attributes["layout"])
            self._is_complete = bool(self._attributes["complete"])
            self._failed = {_store.place_of(name): str(reason) for name, reason in self._attributes["failed"].items()}
            records = _store.overlays(self._files, self.generation)
        self._chunks = _store.chunks_of(self._files, self._layout, records)

    @property
    def path(self) -> str:
        """The folder or the URL."""
        return self._files.address

    @property
    def generation(self) -> int:
        """Number of updates since the tree was built.

        An open tree shows the generation that was the newest when it was opened.
        """
        return int(self._attributes["generation"])

    @property
    def bounds(self) -> NDArray[np.float64]:
        """World box (2, 3) of all leaves, metres."""
        return self._layout.grid.bounds

    @property
    def cell(self) -> float:
        """Side of the leaves, metres."""
        return self._layout.grid.cell

    @property
    def size(self) -> int:
        """Width and height of a view, pixels."""
        return self._layout.size

    @property
    def levels(self) -> int:
        """Number of levels: 0 has the leaves, the last one cell."""
        return self._layout.grid.levels

    @property
    def directions(self) -> tuple[tuple[int, int, int], ...]:
        """Sides that cells are seen from: −1, 0 or 1 along each axis."""
        return self._layout.directions

    @property
    def layers(self) -> int:
        """Number of layers of surfaces, 1 or 2."""
        return self._layout.layers

    @property
    def is_complete(self) -> bool:
        """Whether the build has ended and no leaf failed."""
        return self._is_complete

    @property
    def failed(self) -> dict[tuple[int, int, int], str]:
        """Errors of the source by leaf: these leaves are empty or lack a part, and so do the cells above them."""
        return dict(self._failed)

    @property
    def held(self) -> dict[str, int]:
        """Number of `cells` and `leaves` that are not empty, of their `chunks`, and of the chunks' `bytes`.

        Only complete subtrees count: 8 × 8 × 8 leaves or cells of levels 3, 6 and so on.
        """
        return dict(self._attributes["held"])

    @property
    def done(self) -> dict[str, int]:
        """Counts of the work of the last build or update.

        Leaves "drawn" and found "empty", cells "composed", chunks "reloaded" from the store, and "sent" by the workers
        of a cluster.
        """
        return dict(self._attributes["done"])

    def cells(self, level: SupportsIndex) -> tuple[int, int, int]:
        """Return the number of a level's cells along each axis."""
        return self._layout.grid.counts_at(check.integer("level", level, 0, self.levels - 1))

    def box(self, level: SupportsIndex, place: tuple[int, int, int]) -> NDArray[np.float64]:
        """Return the world box (2, 3) of a cell, metres."""
        number = check.integer("level", level, 0, self.levels - 1)
        return self._layout.grid.box(number, self._place(number, place))

    def view(
        self, level: SupportsIndex, place: tuple[int, int, int], direction: SupportsIndex, layer: SupportsIndex = 0
    ) -> OrthoView | None:
        """Read a view; None if it shows nothing.

        ValueError for numbers out of range, or a cell that is missing because the build is unfinished or its source
        failed; FormatError for a damaged shard; OSError for a shard that cannot be read.

        Parameters
        ----------
        level, place
            The cell.
        direction
            Number of the direction in `directions`.
        layer
            0 for the nearest surfaces, 1 for the second layer behind them.
        """
        number = check.integer("level", level, 0, self.levels - 1)
        cell_place = self._place(number, place)
        direction_number = check.integer("direction", direction, 0, len(self.directions) - 1)
        layer_number = check.integer("layer", layer, 0, self.layers - 1)
        with formats.guarded(self.path, "orthoviews"):
            chunks = self._chunks.read_views(number, cell_place, (direction_number,))
            layers = _codec.decode(chunks, self._layout, (direction_number,)) if chunks else []
        if layer_number < len(layers):
            views, bits = layers[layer_number]
            return self._view(views, bits, number, cell_place, self.directions[direction_number])
        if not layers and (reason := self._missing_reason(number, cell_place)):
            raise ValueError(f"place: the cell {cell_place} of level {number} is missing: {reason}")
        return None

    def _missing_reason(self, level: int, place: Place) -> str:
        """Reason why an empty cell may be missing; empty text if the cell is really empty."""
        if not self._is_complete and not self._failed:
            return "the build has not ended"
        reasons = (why for leaf, why in self._failed.items() if tuple(number >> level for number in leaf) == place)
        return next(reasons, "")

    def _view(
        self, views: _core.OrthoViews, bits: NDArray[np.uint8], level: int, place: Place, direction: Direction
    ) -> OrthoView:
        axes, extents = _core.orthoview_axes(direction)
        right, up, toward = (np.array(axis) for axis in axes)
        lengths = np.array(extents) * self._layout.grid.side(level)
        codes = views.depths()[0, ..., 0]
        metres = np.where(codes > 0, (codes - 0.5) * (lengths[2] / self._layout.steps), np.inf).astype(np.float32)
        surfel = _core.orthoview_surfels(bits)[0, ..., 0]
        center = self._layout.grid.box(level, place).mean(axis=0)
        return OrthoView(views.colors()[0], metres, views.vectors()[0], surfel, right, up, toward, lengths, center)

    def _require_finished(self) -> None:
        _store.check_finished(self._attributes, self.path)

    def _require_complete(self) -> None:
        if not self._is_complete:
            raise ValueError(f"path: {self.path} is not complete, build it again")

    @property
    def geometry(self) -> dict[str, Any] | None:
        """Numbers of leaves, triangles and bytes of the geometry, and the greatest error of a position in metres.

        These are the numbers of the build; None for a tree without geometry.
        """
        facts = self._attributes["geometry"]
        return None if facts is None else dict(facts)

    def leaf_glb(self, place: tuple[int, int, int], *, moving: bool = False) -> bytes | None:
        """Read the static or the moving triangles that belong to a leaf, as a GLB in world metres; None if it has none.

        ValueError for numbers out of range, a tree without geometry, or a leaf that is missing because the build is
        unfinished or its source failed; OSError for a file that cannot be read.
        """
        if not self._layout.geometry:
            raise ValueError(f"{self.path}: expected a tree with geometry, see nearfar.orthoview.build")
        leaf = self._place(0, place)
        with formats.guarded(self.path, "orthoviews"):
            content = self._chunks.geometry(names(self._layout.grid, leaf)[check.flag("moving", moving)])
        if content is None and (reason := self._missing_reason(0, leaf)):
            raise ValueError(f"place: the leaf {leaf} is missing: {reason}")
        return content

    def _place(self, level: int, place: tuple[int, int, int]) -> Place:
        counts = self._layout.grid.counts_at(level)
        numbers = check.array("place", place, columns=None, dtype=np.int64)
        if numbers.shape != (3,):
            raise ValueError(f"place: expected 3 whole numbers, got shape {numbers.shape}")
        x, y, z = (check.integer("place", n, 0, count - 1) for n, count in zip(numbers.tolist(), counts, strict=True))
        return x, y, z
