"""Replaces missing views of a cut by what was drawn before, by finer cells, or by parts of coarser views."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from nearfar.orthoview._cut import GEOMETRY, Part
from nearfar.orthoview._grid import Grid, Place

Cell = tuple[int, Place]
"""Level and place."""

PartsByCell = dict[Cell, list[Part]]
"""Parts from which each cell of a cut should be drawn, nearest direction first."""


@dataclass(frozen=True)
class Piece:
    """A view to draw, or the part of a coarser view that replaces a smaller cell."""

    part: Part
    within: Cell | None = None
    """Cell to which a coarser view is clipped; None for a whole view."""


@dataclass(frozen=True)
class PicturePieces:
    """Pieces of views and leaves from which a picture is drawn."""

    cells: dict[Cell, list[Piece]] = field(default_factory=dict)
    """Cells drawn from their own views, or from parts of coarser cells' views."""
    leaves: dict[Place, list[Part]] = field(default_factory=dict)
    """Leaves drawn as geometry, with the files of each: its own and those of its guests."""
    missing: int = 0
    """Number of cells of the cut that lack a part."""
    empty: int = 0
    """Number of these cells for which nothing is drawn."""

    def parts(self) -> set[Part]:
        """All parts in use."""
        pieces = {piece.part for pieces in self.cells.values() for piece in pieces}
        return pieces.union(*self.leaves.values())


class StandIns:
    """Chooses the pieces to draw, at most `views` views of a cell.

    `directions` are unit vectors (D, 3). `is_read` says whether the newest version of a part has been read. `drawable`
    returns the directions of a cell's views of which any version has been read, and `GEOMETRY` for a leaf whose
    geometry has been read.
    """

    def __init__(
        self,
        grid: Grid,
        directions: NDArray[np.float64],
        is_read: Callable[[Part], bool],
        drawable: Callable[[Cell], Collection[int]],
        views: int,
    ) -> None:
        self._grid, self._units, self._is_read, self._drawable, self._views = grid, directions, is_read, drawable, views

    def choose_pieces(
        self, parts_by_cell: PartsByCell, previous: PicturePieces, eye: NDArray[np.float64]
    ) -> PicturePieces:
        """Choose how wanted cells are drawn from the parts that have been read.

        If all parts of a cell have been read, it is drawn from them. Otherwise the first possible rule applies:

        1. The cell stays as it was drawn in the previous picture.
        2. Descendants that the previous picture shows stay; rules 3 and 4 draw the remaining volume.
        3. The views of the finest ancestor that has any replace the cell, clipped to it.
        4. The cell is drawn from those of its own views that have been read.
        """
        picture = PicturePieces()
        missing = empty = 0
        descendants = self._descendants(previous)
        for cell, parts in parts_by_cell.items():
            if all(map(self._is_read, parts)):
                if parts[0][2] == GEOMETRY:
                    picture.leaves[cell[1]] = parts
                else:
                    picture.cells[cell] = [Piece(part) for part in parts]
                continue
            missing += 1
            kept_cells = self._keep(picture, descendants.get(cell, ()), previous)
            ancestors = {ancestor for kept_cell in kept_cells for ancestor in self._with_ancestors(kept_cell)}
            for uncovered in self._uncovered(cell, kept_cells, ancestors):
                if pieces := self._replacement(uncovered, eye):
                    picture.cells[uncovered] = pieces
            empty += not kept_cells and cell not in picture.cells
        return PicturePieces(picture.cells, picture.leaves, missing, empty)

    def _can_draw(self, part: Part) -> bool:
        level, place, direction = part
        return direction in self._drawable((level, place))

    def _descendants(self, previous: PicturePieces) -> dict[Cell, list[Cell]]:
        """Map each cell to its descendants, itself included, that the previous picture drew from their own parts.

        Cells drawn from parts of coarser views are left out, since better views may have been read by now.
        """
        drawn_cells = [cell for cell, pieces in previous.cells.items() if pieces[0].within is None]
        descendants: dict[Cell, list[Cell]] = {}
        for level, place in (*drawn_cells, *((0, place) for place in previous.leaves)):
            cell = (level, place)
            for ancestor in self._with_ancestors(cell):
                descendants.setdefault(ancestor, []).append(cell)
        return descendants

    def _with_ancestors(self, cell: Cell) -> Iterable[Cell]:
        """A cell and its ancestors, lowest first."""
        level, (x, y, z) = cell
        for up in range(self._grid.levels - level):
            yield level + up, (x >> up, y >> up, z >> up)

    def _uncovered(self, cell: Cell, kept_cells: Collection[Cell], ancestors: Collection[Cell]) -> Iterator[Cell]:
        """Largest cells in a cell that contain no kept cell; `ancestors` has all kept cells and their ancestors."""
        if cell not in ancestors:
            yield cell
        elif cell not in kept_cells:
            for _, child in self._grid.children(*cell):
                yield from self._uncovered((cell[0] - 1, child), kept_cells, ancestors)

    def _keep(self, picture: PicturePieces, cells: Iterable[Cell], previous: PicturePieces) -> set[Cell]:
        """Draw cells as before from parts that are still cached; return the cells that have such parts."""
        kept_cells: set[Cell] = set()
        for cell in cells:
            _, place = cell
            leaf = previous.leaves.get(place) if cell[0] == 0 else None
            if leaf and all(self._can_draw(part) for part in leaf):
                picture.leaves[place] = leaf
                kept_cells.add(cell)
                continue
            pieces = [
                piece for piece in previous.cells.get(cell, []) if piece.within is None and self._can_draw(piece.part)
            ]
            if pieces:
                picture.cells[cell] = pieces
                kept_cells.add(cell)
        return kept_cells

    def _replacement(self, cell: Cell, eye: NDArray[np.float64]) -> list[Piece]:
        """Views of the finest ancestor that has any, clipped to the cell; failing that, the cell's own views."""
        _, *ancestors = self._with_ancestors(cell)
        for ancestor in ancestors:
            if views := self._nearest(ancestor, eye):
                return [Piece(part, cell) for part in views]
        return [Piece(part) for part in self._nearest(cell, eye)]

    def _nearest(self, cell: Cell, eye: NDArray[np.float64]) -> list[Part]:
        """Views of a cell that have been read, those nearest to the viewer's direction first."""
        level, place = cell
        directions = [direction for direction in self._drawable(cell) if direction != GEOMETRY]
        if not directions:
            return []
        to_viewer = eye - self._grid.box(level, place).mean(axis=0)
        directions.sort(key=lambda direction: (-float(self._units[direction] @ to_viewer), direction))
        return [(level, place, direction) for direction in directions[: self._views]]
