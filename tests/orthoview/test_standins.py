"""Tests of stand-ins: what is drawn of a cut with missing parts."""

from __future__ import annotations

import itertools
from collections.abc import Collection, Iterable

import numpy as np
from hypothesis import given, strategies as st
from numpy.typing import NDArray

from nearfar.orthoview._cut import GEOMETRY, Part
from nearfar.orthoview._grid import OCTANTS, Grid, Place
from nearfar.orthoview._standins import Cell, PartsByCell, PicturePieces, Piece, StandIns

GRID = Grid((0.0, 0.0, 0.0), 1.0, (4, 4, 4))
TOP: Cell = (2, (0, 0, 0))
UNITS = np.array([[1, 0, 0], [0, 0, 1], [-1, 0, 0], [0, 0, -1], [0, 1, 0]], np.float64)
EYE = np.array([30.0, 20.0, 1.0])
"""An eye for which the directions 0, 4, 1, 3 and 2 are nearest to a cell, in this order: x > y > z."""

CELLS = [(level, place) for level in range(3) for place in itertools.product(range(4 >> level), repeat=3)]
DIRECTIONS = range(5)


class Memory:
    """Loaded parts, and the parts among them that an update has changed."""

    def __init__(self, parts: Iterable[Part] = (), old: Collection[Part] = ()) -> None:
        self.parts, self.old = set(parts), set(old)

    def stand_ins(self, views: int = 2) -> StandIns:
        return StandIns(GRID, UNITS, self.holds, self.drawable, views)

    def holds(self, part: Part) -> bool:
        return part in self.parts and part not in self.old

    def drawable(self, cell: Cell) -> set[int]:
        return {direction for level, place, direction in self.parts if (level, place) == cell}

    def choose(
        self, wanted: PartsByCell, before: PicturePieces | None = None, eye: NDArray[np.float64] = EYE
    ) -> PicturePieces:
        return self.stand_ins().choose_pieces(wanted, before or PicturePieces(), eye)


def views(cell: Cell, *directions: int) -> list[Part]:
    return [(*cell, direction) for direction in directions]


def wish(*cells: Cell) -> PartsByCell:
    return {cell: views(cell, 0, 4) for cell in cells}


def leaf(place: Place, *guests: Place) -> PartsByCell:
    return {(0, place): [(0, one, GEOMETRY) for one in (place, *guests)]}


def pieces(cell: Cell, *directions: int, within: Cell | None = None) -> list[Piece]:
    return [Piece(part, within) for part in views(cell, *directions)]


LOW: Cell = (0, (0, 0, 0))
MIDDLE: Cell = (1, (0, 0, 0))
OTHER: Cell = (1, (1, 0, 0))


def test_loaded_parts_are_drawn() -> None:
    wanted = wish(MIDDLE, OTHER) | leaf((0, 3, 0), (1, 3, 0))
    memory = Memory(part for parts in wanted.values() for part in parts)
    shown = memory.choose(wanted)
    assert shown.cells == {MIDDLE: pieces(MIDDLE, 0, 4), OTHER: pieces(OTHER, 0, 4)}
    assert shown.leaves == {(0, 3, 0): [(0, (0, 3, 0), GEOMETRY), (0, (1, 3, 0), GEOMETRY)]}
    assert (shown.missing, shown.empty) == (0, 0)
    assert shown.parts() == memory.parts


def test_empty_cells_are_not_drawn() -> None:
    shown = Memory().choose(wish(MIDDLE, OTHER) | leaf((0, 3, 0)))
    assert shown == PicturePieces(missing=3, empty=3)
    assert shown.parts() == set()


def test_a_cell_keeps_its_views() -> None:
    """The directions are no longer the nearest ones, though cells above have those."""
    memory = Memory([*views(MIDDLE, 2, 3), *views(MIDDLE, 0), *views(TOP, 0, 4)])
    before = PicturePieces({MIDDLE: pieces(MIDDLE, 2, 3)})
    shown = memory.choose(wish(MIDDLE), before)
    assert shown == PicturePieces({MIDDLE: pieces(MIDDLE, 2, 3)}, missing=1)
    memory.parts.remove(views(MIDDLE, 2)[0])
    assert memory.choose(wish(MIDDLE), shown).cells == {MIDDLE: pieces(MIDDLE, 3)}
    memory.parts.remove(views(MIDDLE, 3)[0])
    assert memory.choose(wish(MIDDLE), shown).cells == {MIDDLE: pieces(TOP, 0, 4, within=MIDDLE)}


def test_older_views_stay_until_newer_ones_are_loaded() -> None:
    wanted = wish(MIDDLE) | leaf((2, 0, 0))
    parts = [part for parts in wanted.values() for part in parts]
    memory = Memory(parts)
    first = memory.choose(wanted)
    memory.old = set(parts[1:])
    shown = memory.choose(wanted, first)
    assert (shown.cells, shown.leaves) == (first.cells, first.leaves)
    assert (shown.missing, shown.empty) == (2, 0)
    memory.old = set()
    assert memory.choose(wanted, shown) == first


def test_finer_cells_stay_and_cells_above_fill_the_rest() -> None:
    """One leaf stays as views, one as geometry; the other six octants are parts of the whole world's views."""
    near: Place = (1, 1, 1)
    memory = Memory([*views(LOW, 0, 4), (0, near, GEOMETRY), *views(TOP, 0, 4, 1)])
    before = PicturePieces({LOW: pieces(LOW, 0, 4)}, {near: [(0, near, GEOMETRY)]})
    shown = memory.choose(wish(MIDDLE), before)
    assert shown.leaves == before.leaves
    assert (shown.missing, shown.empty) == (1, 0)
    rest: list[Cell] = [(0, place) for place in OCTANTS if place not in (LOW[1], near)]
    assert shown.cells == before.cells | {cell: pieces(TOP, 0, 4, within=cell) for cell in rest}
    # Again: stand-ins are chosen afresh, and finer parts are preferred.
    memory.parts |= set(views(MIDDLE, 4))
    again = memory.choose(wish(MIDDLE), shown)
    assert again.cells == before.cells | {cell: pieces(MIDDLE, 4, within=cell) for cell in rest}
    # Then the cell itself is loaded.
    memory.parts |= set(views(MIDDLE, 0))
    assert memory.choose(wish(MIDDLE), again) == PicturePieces({MIDDLE: pieces(MIDDLE, 0, 4)})


def test_the_rest_of_a_large_cell_is_drawn_in_the_largest_parts() -> None:
    memory = Memory([*views(LOW, 0), *views(TOP, 0)])
    shown = memory.choose(wish(TOP), PicturePieces({LOW: pieces(LOW, 0)}))
    beside: list[Cell] = [(level, place) for level in (0, 1) for place in OCTANTS if place != (0, 0, 0)]
    assert shown.cells == {LOW: pieces(LOW, 0)} | {cell: pieces(TOP, 0, within=cell) for cell in beside}


def test_geometry_stays_only_with_all_its_guests() -> None:
    parts: list[Part] = [(0, (0, 0, 0), GEOMETRY), (0, (1, 0, 0), GEOMETRY)]
    memory = Memory(parts)
    before = PicturePieces({}, {(0, 0, 0): parts})
    assert memory.choose(wish(LOW), before) == PicturePieces({}, {(0, 0, 0): parts}, missing=1)
    memory.parts = {parts[0]}
    assert memory.choose(wish(LOW), before) == PicturePieces(missing=1, empty=1)


def test_the_finest_cell_above_stands_in() -> None:
    memory = Memory([*views(TOP, 0, 4), *views(MIDDLE, 3)])
    shown = memory.choose(wish(LOW, (0, (3, 3, 3))))
    assert shown.cells == {
        LOW: pieces(MIDDLE, 3, within=LOW),
        (0, (3, 3, 3)): pieces(TOP, 0, 4, within=(0, (3, 3, 3))),
    }
    assert (shown.missing, shown.empty) == (2, 0)


def test_stand_ins_do_not_stay() -> None:
    memory = Memory(views(TOP, 0, 4))
    first = memory.choose(wish(LOW))
    assert first.cells == {LOW: pieces(TOP, 0, 4, within=LOW)}
    memory.parts |= set(views(MIDDLE, 1))
    assert memory.choose(wish(LOW), first).cells == {LOW: pieces(MIDDLE, 1, within=LOW)}


def test_a_cell_without_stand_ins_is_drawn_from_some_of_its_views() -> None:
    memory = Memory(views(LOW, 4))
    assert memory.choose(wish(LOW)) == PicturePieces({LOW: pieces(LOW, 4)}, missing=1)
    memory.parts |= set(views(TOP, 1))
    assert memory.choose(wish(LOW)).cells == {LOW: pieces(TOP, 1, within=LOW)}


def test_stand_ins_use_the_nearest_directions() -> None:
    memory = Memory(views(TOP, *DIRECTIONS))
    for eye in np.random.default_rng(0).normal(0, 30, (30, 3)):
        cosines = UNITS @ (eye - 2.0)
        order = sorted(DIRECTIONS, key=lambda direction, cosines=cosines: -cosines[direction])  # type: ignore[misc]
        for count in (1, 2, 3, 5):
            shown = memory.stand_ins(count).choose_pieces(wish(LOW), PicturePieces(), eye)
            assert shown.cells == {LOW: pieces(TOP, *order[:count], within=LOW)}
    assert memory.choose(wish(LOW)).cells == {LOW: pieces(TOP, 0, 4, within=LOW)}


def test_geometry_does_not_stand_in_for_views() -> None:
    memory = Memory([(0, (0, 0, 0), GEOMETRY)])
    assert memory.choose(wish(LOW)) == PicturePieces(missing=1, empty=1)


def leaves_of(cell: Cell) -> set[Place]:
    """Places of the leaves in a cell."""
    level, place = cell
    ranges = [range(number << level, (number + 1) << level) for number in place]
    return set(itertools.product(*ranges))  # type: ignore[arg-type]


def covered_leaves(cells: Iterable[Cell]) -> list[Place]:
    """Counts of the leaves in cells, by place."""
    return sorted(place for cell in cells for place in leaves_of(cell))


def shown_cells(shown: PicturePieces) -> list[Cell]:
    return [*shown.cells, *((0, place) for place in shown.leaves)]


@st.composite
def cuts(draw: st.DrawFn) -> PartsByCell:
    """A random cut through some of the world, with random directions and geometry."""
    wanted: PartsByCell = {}

    def visit(cell: Cell) -> None:
        level, place = cell
        choice = draw(st.sampled_from(["none", "draw", "draw", "open", "open", "open"]))
        if choice == "none" and cell != TOP:
            return
        if level and choice != "draw":
            for _, child in GRID.children(level, place):
                visit((level - 1, child))
        elif level == 0 and draw(st.booleans()):
            wanted.update(leaf(place))
        else:
            wanted[cell] = views(
                cell, *draw(st.lists(st.sampled_from(DIRECTIONS), min_size=1, max_size=2, unique=True))
            )

    visit(TOP)
    return wanted


parts = st.tuples(st.sampled_from(CELLS), st.sampled_from([GEOMETRY, *DIRECTIONS]))
memories = st.lists(parts, max_size=60).map(
    lambda chosen: {(*cell, direction) for cell, direction in chosen if cell[0] == 0 or direction != GEOMETRY}
)


@given(st.lists(st.tuples(cuts(), memories, memories, st.booleans()), min_size=1, max_size=5), st.booleans())
def test_every_place_is_drawn_exactly_once(
    steps: list[tuple[PartsByCell, set[Part], set[Part], bool]], has_top: bool
) -> None:
    """Holds for any sequence of cuts, of loaded and evicted parts, and of updated parts.

    Drawn cells share no leaf and lie in wanted cells. If views of the whole world are loaded, the drawn cells cover
    all wanted ones. All drawn parts are loaded, and wanted parts that are loaded are drawn as wanted.
    """
    before = PicturePieces()
    for wanted, held, old, is_whole in steps:
        memory = Memory(held | (set(views(TOP, 1)) if has_top else set()), old - set(views(TOP, 1)))
        if is_whole:
            memory.parts |= {part for parts in wanted.values() for part in parts}
        shown = memory.choose(wanted, before)
        is_there = {cell: all(map(memory.holds, parts)) for cell, parts in wanted.items()}
        places, all_places = covered_leaves(shown_cells(shown)), covered_leaves(wanted)
        assert len(set(places)) == len(places)
        assert set(places) <= set(all_places)
        if has_top:
            assert places == all_places
            assert shown.empty == 0
        assert shown.parts() <= memory.parts
        assert all(shown.cells.values())
        for cell, own in shown.cells.items():
            for piece in own:
                level, place, direction = piece.part
                assert direction != GEOMETRY
                assert piece.within in (None, cell)
                assert leaves_of((level, place)) >= leaves_of(cell)
                assert (piece.within is None) == ((level, place) == cell)
        for cell, own_parts in wanted.items():
            if is_there[cell] and own_parts[0][2] == GEOMETRY:
                assert shown.leaves[cell[1]] == own_parts
            elif is_there[cell]:
                assert shown.cells[cell] == [Piece(part) for part in own_parts]
        assert shown.missing == list(is_there.values()).count(False)
        drawn = set(places)
        assert shown.empty == sum(not is_there[cell] and leaves_of(cell).isdisjoint(drawn) for cell in wanted)
        if all(is_there.values()):
            assert set(shown_cells(shown)) == set(wanted)
        before = shown
