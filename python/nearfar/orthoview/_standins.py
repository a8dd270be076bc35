"""Drawing a cut whose views are not all there: what was drawn before, finer cells, parts of coarser ones."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from nearfar.orthoview._grid import Grid, Place
from nearfar.orthoview._parts import GEOMETRY, Part

Cell = tuple[int, Place]
"""Level and place."""

Wanted = dict[Cell, list[Part]]
"""The parts that each cell of a cut is to be drawn from, the best direction first."""


@dataclass(frozen=True)
class Piece:
    """A view that is drawn, or the part of one that stands for a smaller cell."""

    part: Part
    within: Cell | None = None


@dataclass(frozen=True)
class Shown:
    """The parts that a picture is drawn from."""

    cells: dict[Cell, list[Piece]] = field(default_factory=dict)
    """Cells that are drawn from views, each from some of its own or from parts of those above it."""
    leaves: dict[Place, list[Part]] = field(default_factory=dict)
    """Leaves that are drawn as geometry, with the files of each: its own and those of its guests."""
    missing: int = 0
    """Cells of the cut that lack a part."""
    empty: int = 0
    """Cells of these in whose place nothing is shown."""

    def parts(self) -> set[Part]:
        """All parts that are drawn."""
        pieces = {piece.part for pieces in self.cells.values() for piece in pieces}
        return pieces.union(*self.leaves.values())


class StandIns:
    """Chooses what is drawn.

    Parameters
    ----------
    grid
        The tree's cells.
    directions
        Its directions as unit vectors (D, 3).
    held
        Whether a part is there as it is now.
    drawable
        The directions from which a cell can be drawn, and `GEOMETRY` for the file of a leaf: parts that are there,
        those included that an update has changed.
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

    def shown(self, wanted: Wanted, before: Shown, eye: NDArray[np.float64]) -> Shown:
        """Choose how wanted cells are drawn from what is there.

        A cell whose parts are all there is drawn from them. Otherwise, in this order: it stays as it was drawn before;
        cells below it that were drawn before stay, and its rest is drawn as follows; the finest cell above it that is
        there stands for it, but only what lies within the cell; it is drawn from those of its views that are there.
        """
        found = Shown()
        missing = empty = 0
        below = self._below(before)
        for cell, parts in wanted.items():
            if all(map(self._held, parts)):
                self._put(found, cell, parts)
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

    def _put(self, found: Shown, cell: Cell, parts: Sequence[Part]) -> None:
        if parts[0][2] == GEOMETRY:
            found.leaves[cell[1]] = list(parts)
        else:
            found.cells[cell] = [Piece(part) for part in parts]

    def _below(self, before: Shown) -> dict[Cell, list[Cell]]:
        """By each cell those that were drawn before within it, itself included, if that is still there.

        Parts of coarser views that stood for a cell are not among them: a better choice may be there by now.
        """
        own = [cell for cell, pieces in before.cells.items() if pieces[0].within is None]
        found: dict[Cell, list[Cell]] = {}
        for level, place in (*own, *((0, place) for place in before.leaves)):
            cell = (level, place)
            for above in self._up(cell):
                found.setdefault(above, []).append(cell)
        return found

    def _up(self, cell: Cell) -> Iterable[Cell]:
        """A cell and those above it, the lowest first."""
        level, (x, y, z) = cell
        for up in range(self._grid.levels - level):
            yield level + up, (x >> up, y >> up, z >> up)

    def _beside(self, cell: Cell, kept: Collection[Cell], above: Collection[Cell]) -> Iterator[Cell]:
        """The greatest cells within one that share nothing with those that stay; `above` has these and all above."""
        if cell not in above:
            yield cell
        elif cell not in kept:
            for _, child in self._grid.children(*cell):
                yield from self._beside((cell[0] - 1, child), kept, above)

    def _keep(self, found: Shown, cells: Iterable[Cell], before: Shown) -> set[Cell]:
        """Draw cells as before, from what of it is there; those of which something is."""
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
        """The views of the finest cell above that is there, as far as they lie within the cell; else its own views."""
        own, *above = self._up(cell)
        for other in above:
            if views := self._nearest(other, eye):
                return [Piece(part, cell) for part in views]
        return [Piece(part) for part in self._nearest(own, eye)]

    def _nearest(self, cell: Cell, eye: NDArray[np.float64]) -> list[Part]:
        """The views of a cell that are there whose directions are nearest to the viewer's."""
        level, place = cell
        held = [direction for direction in self._drawable(cell) if direction != GEOMETRY]
        if not held:
            return []
        to = eye - self._grid.box(level, place).mean(axis=0)
        held.sort(key=lambda direction: (-float(self._units[direction] @ to), direction))
        return [(level, place, direction) for direction in held[: self._views]]
