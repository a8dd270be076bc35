"""A tree of orthoviews that is open."""

from __future__ import annotations

import os
from dataclasses import dataclass
from functools import cached_property
from typing import Any, SupportsIndex

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import check
from nearfar.orthoview import _codec, _store
from nearfar.orthoview._grid import Place
from nearfar.orthoview._layout import CHANNELS, Layout


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
        self._attributes = _store.read(self._path)
        self._layout = Layout.from_described(self._attributes["layout"])

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
        return bool(self._attributes["complete"])

    @property
    def failed(self) -> dict[str, str]:
        """Leaves that the source failed to give, as ``x_y_z``, with the reasons."""
        return dict(self._attributes.get("failed", {}))

    @property
    def counts(self) -> dict[str, int]:
        """What the last build did: cells drawn, empty, composed; chunks and bytes written; chunks reloaded."""
        return dict(self._attributes.get("counts", {}))

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
            Numbers out of range.
        OSError
            A shard that cannot be read.
        """
        number = check.integer("level", level, 0, self.levels - 1)
        at, seen = self._place(number, place), check.integer("direction", direction, 0, len(self.directions) - 1)
        stored = [self._arrays[self._layout.array(number, seen, channel)][at] for channel in CHANNELS]
        color, depth, normal = (np.asarray(values) for values in stored)
        if not depth.any():
            return None
        return self._view(color, depth, normal, number, at, seen)

    def _view(self, color: Any, depth: Any, normal: Any, level: int, place: Place, direction: int) -> OrthoView:
        directions = (self.directions[direction],)
        views, bits = _codec.from_stored(color[None], depth[None], normal[None], self._layout, directions)
        codes = views.depths()[0, ..., 0]
        axes, extents = _core.orthoview_axes(directions[0])
        right, up, toward = (np.array(axis) for axis in axes)
        lengths = np.array(extents) * self._layout.grid.side(level)
        metres = np.where(codes > 0, (codes - 0.5) * (lengths[2] / views.steps), np.inf).astype(np.float32)
        surfel = _core.orthoview_surfels(bits)[0, ..., 0]
        center = self._layout.grid.box(level, place).mean(axis=0)
        return OrthoView(color, metres, views.vectors()[0], surfel, right, up, toward, lengths, center)

    @cached_property
    def _arrays(self) -> Any:
        import zarr

        return zarr.open_group(str(self._path), mode="r")

    def _place(self, level: int, place: tuple[int, int, int]) -> Place:
        counts = self._layout.grid.counts_at(level)
        x, y, z = (check.integer("place", number, 0, count - 1) for number, count in zip(place, counts, strict=True))
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
