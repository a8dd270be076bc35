"""The `StoredTree` class: the cells, views and leaf geometry in the store of an open tree."""

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
from nearfar.orthoview._grid import Direction, Place, place_of
from nearfar.orthoview._layout import check_zarr
from nearfar.orthoview._unfinished import UnfinishedFiles, open_store, unbuilt_leaves
from nearfar.orthoview._view import OrthoView


class StoredTree:
    """Store of a tree in a folder or behind a URL; for errors see `OrthoTree`."""

    def __init__(self, path: str | os.PathLike[str]) -> None:
        check_zarr()
        self._files, self._attributes, self._layout = open_store(files_at(path))
        with formats.guarded(f"{self.path}/{_store.DOCUMENT}"):
            self._is_complete = bool(self._attributes["complete"])
            self._has_ended = not isinstance(self._files, UnfinishedFiles) and _store.has_ended(self._attributes)
            self._failed = {place_of(name): str(reason) for name, reason in self._attributes["failed"].items()}
            self._chunks, _ = _store.open_generation(self._files, self._layout, self.generation)

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
        """Directions from a cell to the viewer of each of its views: −1, 0 or 1 along each axis."""
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
    def unbuilt(self) -> int:
        """Number of leaves that the build had not reached when the tree was opened; some of them may be empty.

        0 once the build has ended. Until then the tree shows what was built; open it again, or call `Flight.refresh`,
        to see more.
        """
        return unbuilt_leaves(self._files)

    @property
    def failed(self) -> dict[tuple[int, int, int], str]:
        """Errors of the source by leaf: these leaves, and the cells above them, are empty or lack a part."""
        return dict(self._failed)

    @property
    def held(self) -> dict[str, int]:
        """Number of `cells` and `leaves` that are not empty, of their `chunks`, and of the chunks' `bytes`."""
        return dict(self._attributes["held"])

    @property
    def done(self) -> dict[str, int]:
        """Counts of the work of the build, or of the last update.

        Leaves "drawn" and found "empty", and cells "composed"; after an update also chunks "reloaded" from the store.
        Interruptions of a build do not change its counts.
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
        self._require_records()
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
        """Reason why a cell without views may be missing from the store; empty text for a cell that shows nothing."""
        if not self._has_ended and not (
            isinstance(self._files, UnfinishedFiles) and self._files.has_built(level, place)
        ):
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

    def _require_records(self) -> None:
        """Raise a ValueError for a store behind a URL without the list of records, which a build writes at its end."""
        if (
            not (self._has_ended or isinstance(self._files, UnfinishedFiles))
            and self._files.read(_store.RECORDS_FILE) is None
        ):
            how = "open its folder, or the address of `nearfar serve`, to see what there is"
            raise ValueError(f"path: the build of {self.path} has not ended; {how}")

    def _require_complete(self) -> None:
        """Raise a ValueError that counts the missing leaves of an incomplete tree."""
        _store.check_complete(self._attributes, self.path, self.unbuilt)

    @property
    def geometry(self) -> dict[str, Any] | None:
        """Counts of leaves, triangles and bytes of the geometry, and the greatest error of a position in metres.

        They describe the first generation; None for a tree without geometry.
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
        self._require_records()
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
