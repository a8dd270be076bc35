"""Draws a cut some of whose views are missing: as drawn before, from finer cells, or from parts of coarser ones."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from nearfar.orthoview._cut import GEOMETRY, Part
from nearfar.orthoview._grid import Grid, Place

Cell = tuple[int, Place]
"""Level and place."""

Wanted = dict[Cell, list[Part]]
"""Parts that each cell of a cut is to be drawn from, best direction first."""


@dataclass(frozen=True)
class Piece:
    """A view to draw, or the part of a coarser view that replaces a smaller cell."""

    part: Part
    within: Cell | None = None


@dataclass(frozen=True)
class Shown:
    """Parts that a picture is drawn from."""

    cells: dict[Cell, list[Piece]] = field(default_factory=dict)
    """Cells drawn from views: each from its own views or from parts of coarser cells' views."""
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
    """Chooses the parts to draw.

    Parameters
    ----------
    directions
        Unit vectors (D, 3) of the tree's directions.
    held
        Whether a part has been read in its newest version.
    drawable
        Directions from which a cell can be drawn, and `GEOMETRY` for the file of a leaf: parts that have been read,
        in any version.
    views
        Greatest number of views of a cell.
    """

    def __init__(
        self,
        grid: Grid,
        directions: NDArray[np.float64],
        held: Callable[[Part], bool],
        drawable: Callable[[Cell], Collection[int]],
        views: int,
    ) -> None:
        self._grid, self._units, self._held, self._drawable, self._views = grid, directions, held, drawable, views

    def choose_pieces(self, wanted: Wanted, before: Shown, eye: NDArray[np.float64]) -> Shown:
        """Choose how wanted cells are drawn from the parts that have been read.

        A cell all of whose parts have been read is drawn from them. Otherwise, in this order: it stays as it was drawn
        before; its descendants that were drawn before stay, and the rest of it is drawn as follows; the finest ancestor
        with views replaces it, clipped to the cell; it is drawn from those of its own views that have been read.
        """
        found = Shown()
        missing = empty = 0
        below = self._below(before)
        for cell, parts in wanted.items():
            if all(map(self._held, parts)):
                if parts[0][2] == GEOMETRY:
                    found.leaves[cell[1]] = parts
                else:
                    found.cells[cell] = [Piece(part) for part in parts]
                continue
            missing += 1
            kept = self._keep(found, below.get(cell, ()), before)
            rest = list(self._beside(cell, kept, {above for one in kept for above in self._up(one)}))
            found.cells.update({each: pieces for each in rest if (pieces := self._standing(each, eye))})
            empty += not kept and cell not in found.cells
        return Shown(found.cells, found.leaves, missing, empty)

    def _can_draw(self, part: Part) -> bool:
        level, place, direction = part
        return direction in self._drawable((level, place))

    def _below(self, before: Shown) -> dict[Cell, list[Cell]]:
        """Map each cell to its descendants, itself included, that were drawn before from their own parts.

        Cells drawn from parts of coarser views are left out: a better choice may exist by now.
        """
        own = [cell for cell, pieces in before.cells.items() if pieces[0].within is None]
        found: dict[Cell, list[Cell]] = {}
        for level, place in (*own, *((0, place) for place in before.leaves)):
            cell = (level, place)
            for above in self._up(cell):
                found.setdefault(above, []).append(cell)
        return found

    def _up(self, cell: Cell) -> Iterable[Cell]:
        """A cell and its ancestors, lowest first."""
        level, (x, y, z) = cell
        for up in range(self._grid.levels - level):
            yield level + up, (x >> up, y >> up, z >> up)

    def _beside(self, cell: Cell, kept: Collection[Cell], above: Collection[Cell]) -> Iterator[Cell]:
        """Largest cells within one that contain no kept cell; `above` has the kept cells and all their ancestors."""
        if cell not in above:
            yield cell
        elif cell not in kept:
            for _, child in self._grid.children(*cell):
                yield from self._beside((cell[0] - 1, child), kept, above)

    def _keep(self, found: Shown, cells: Iterable[Cell], before: Shown) -> set[Cell]:
        """Draw cells as before from the parts that remain; return the cells that have any."""
        kept: set[Cell] = set()
        for cell in cells:
            _, place = cell
            leaf = before.leaves.get(place) if cell[0] == 0 else None
            if leaf and all(self._can_draw(part) for part in leaf):
                found.leaves[place] = leaf
                kept.add(cell)
                continue
            pieces = [
                piece for piece in before.cells.get(cell, []) if piece.within is None and self._can_draw(piece.part)
            ]
            if pieces:
                found.cells[cell] = pieces
                kept.add(cell)
        return kept

    def _standing(self, cell: Cell, eye: NDArray[np.float64]) -> list[Piece]:
        """Views of the finest ancestor that has any, clipped to the cell; else the cell's own views."""
        own, *above = self._up(cell)
        for other in above:
            if views := self._nearest(other, eye):
                return [Piece(part, cell) for part in views]
        return [Piece(part) for part in self._nearest(own, eye)]

    def _nearest(self, cell: Cell, eye: NDArray[np.float64]) -> list[Part]:
        """Views of a cell that have been read, those nearest to the viewer's direction first."""
        level, place = cell
        held = [direction for direction in self._drawable(cell) if direction != GEOMETRY]
        if not held:
            return []
        to = eye - self._grid.box(level, place).mean(axis=0)
        held.sort(key=lambda direction: (-float(self._units[direction] @ to), direction))
        return [(level, place, direction) for direction in held[: self._views]]
