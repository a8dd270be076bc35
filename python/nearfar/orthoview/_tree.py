"""A tree of orthoviews that is open."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, SupportsIndex

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import check, formats
from nearfar.orthoview import _codec, _store
from nearfar.orthoview._grid import Place
from nearfar.orthoview._layout import CHANNELS, Layout, check_zarr


@dataclass(frozen=True)
class OrthoView:
    """A cell seen along parallel rays."""

    color: NDArray[np.uint8]
    """sRGB without light (size, size, 3)."""
    depth: NDArray[np.float32]
    """Metres behind the front of the cell's extent along the view (size, size); infinite where nothing is."""
    normal: NDArray[np.float32]
    """Unit normals towards the viewer, world axes (size, size, 3); NaN where nothing is."""
    surfel: NDArray[np.bool_]
    """Whether a pixel is a piece of a plane (size, size); others are balls."""
    right: NDArray[np.float64]
    """Unit vector along a row."""
    up: NDArray[np.float64]
    """Unit vector against a column."""
    toward: NDArray[np.float64]
    """Unit vector towards the viewer."""
    extents: NDArray[np.float64]
    """Extents of the picture to the right and upwards, and of depths, metres."""
    center: NDArray[np.float64]
    """World position of the cell's centre, metres."""

    def points(self) -> NDArray[np.float64]:
        """World positions (size, size, 3) of the surfaces, metres; NaN where nothing is."""
        place = (np.arange(len(self.depth)) + 0.5) / len(self.depth) - 0.5
        across, down = np.meshgrid(place, place)
        behind = np.where(np.isfinite(self.depth), self.depth, np.nan).astype(np.float64)
        width, height, depth = self.extents
        points: NDArray[np.float64] = (
            self.center
            + (across * width)[..., None] * self.right
            - (down * height)[..., None] * self.up
            + (depth / 2 - behind)[..., None] * self.toward
        )
        return points


class OrthoTree:
    """A world as an octree of orthographic depth images, which `nearfar.orthoview.build` makes.

    Parameters
    ----------
    path
        The folder that it wrote.

    Raises
    ------
    FileNotFoundError
        A folder without a store.
    FormatError
        A store of another kind, or of a newer version.
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self._path = check.path("path", path)
        self._arrays: dict[str, Any] = {}
        self._attributes = _store.read(self._path)
        with formats.guarded(self._path / _store.DOCUMENT):
            self._layout = Layout.from_described(self._attributes["layout"])
            self._is_complete = bool(self._attributes["complete"])
            self._failed = {_store.place_of(name): str(reason) for name, reason in self._attributes["failed"].items()}

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
        """−1, 0 or 1 along each axis: the sides that cells are seen from."""
        return self._layout.directions

    @property
    def is_complete(self) -> bool:
        """Whether all cells are there."""
        return self._is_complete

    @property
    def failed(self) -> dict[tuple[int, int, int], str]:
        """Reasons why the source did not give leaves, by their places; the cells above them are missing, too."""
        return dict(self._failed)

    @property
    def held(self) -> dict[str, int]:
        """Number of cells and leaves in which something is, of their chunks, and of the chunks' bytes.

        Those of subtrees that are complete: 8 × 8 × 8 leaves or cells of levels 3, 6 and so on.
        """
        return dict(self._attributes["held"])

    @property
    def done(self) -> dict[str, int]:
        """What the build that ended last did: leaves drawn and found empty, cells composed, chunks reloaded."""
        return dict(self._attributes["done"])

    def cells(self, level: SupportsIndex) -> tuple[int, int, int]:
        """Return the number of a level's cells along each axis."""
        return self._layout.grid.counts_at(check.integer("level", level, 0, self.levels - 1))

    def box(self, level: SupportsIndex, place: tuple[int, int, int]) -> NDArray[np.float64]:
        """Return the world box (2, 3) of a cell, metres."""
        number = check.integer("level", level, 0, self.levels - 1)
        return self._layout.grid.box(number, self._place(number, place))

    def view(self, level: SupportsIndex, place: tuple[int, int, int], direction: SupportsIndex) -> OrthoView | None:
        """Read a view.

        Parameters
        ----------
        level, place
            The cell.
        direction
            Number of the direction in `directions`.

        Returns
        -------
        OrthoView or None
            None if it shows nothing.

        Raises
        ------
        ValueError
            Numbers out of range, and a cell that is missing because the build did not end or its source failed.
        FormatError
            A shard that is damaged.
        OSError
            One that cannot be read.
        """
        number = check.integer("level", level, 0, self.levels - 1)
        at, seen = self._place(number, place), check.integer("direction", direction, 0, len(self.directions) - 1)
        with formats.guarded(self._path, "orthoviews"):
            stored = [self._array(self._layout.array(number, seen, channel))[at] for channel in CHANNELS]
            color, depth, normal = (np.asarray(values) for values in stored)
            if depth.any():
                return self._view(color, depth, normal, number, at, seen)
        if reason := self._missing(number, at):
            raise ValueError(f"place: the cell {at} of level {number} is missing: {reason}")
        return None

    def _missing(self, level: int, place: Place) -> str:
        """Why a cell that shows nothing may be missing; empty if it does show nothing."""
        if not self._is_complete and not self._failed:
            return "the build has not ended"
        reasons = (why for leaf, why in self._failed.items() if tuple(number >> level for number in leaf) == place)
        return next(reasons, "")

    def _view(self, color: Any, depth: Any, normal: Any, level: int, place: Place, direction: int) -> OrthoView:
        directions = (self.directions[direction],)
        views, bits = _codec.from_stored(color[None], depth[None], normal[None], self._layout, directions)
        codes = views.depths()[0, ..., 0]
        axes, extents = _core.orthoview_axes(directions[0])
        right, up, toward = (np.array(axis) for axis in axes)
        lengths = np.array(extents) * self._layout.grid.side(level)
        metres = np.where(codes > 0, (codes - 0.5) * (lengths[2] / self._layout.steps), np.inf).astype(np.float32)
        surfel = _core.orthoview_surfels(bits)[0, ..., 0]
        center = self._layout.grid.box(level, place).mean(axis=0)
        return OrthoView(color, metres, views.vectors()[0], surfel, right, up, toward, lengths, center)

    def _array(self, name: str) -> Any:
        """An array of the store, whose document is read once."""
        if name not in self._arrays:
            check_zarr()
            import zarr

            self._arrays[name] = zarr.open_array(str(self._path / name), mode="r")
        return self._arrays[name]

    def _place(self, level: int, place: tuple[int, int, int]) -> Place:
        counts = self._layout.grid.counts_at(level)
        numbers = check.array("place", place, columns=None, dtype=np.int64)
        if numbers.shape != (3,):
            raise ValueError(f"place: expected 3 whole numbers, got shape {numbers.shape}")
        x, y, z = (check.integer("place", n, 0, count - 1) for n, count in zip(numbers.tolist(), counts, strict=True))
        return x, y, z

    def __repr__(self) -> str:
        """Return a line."""
        state = "" if self.is_complete else ", incomplete"
        return (
            f"OrthoTree({self._path.name!r}, {self.levels} levels of {self.cells(0)} leaves of {self.cell:g} m, "
            f"{len(self.directions)} directions of {self.size} × {self.size} pixels{state})"
        )


def open(path: str | os.PathLike[str]) -> OrthoTree:  # noqa: A001 - the name of the public face
    """Open a store of orthoviews.

    Parameters
    ----------
    path
        The folder that `nearfar.orthoview.build` wrote.

    Raises
    ------
    FileNotFoundError
        A folder without a store.
    FormatError
        A store of another kind, or of a newer version.
    """
    return OrthoTree(path)
