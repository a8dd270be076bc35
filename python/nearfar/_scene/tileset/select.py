"""Selects the tiles that show a tileset: by geometric error, or by a triangle budget."""

from __future__ import annotations

import heapq
import itertools
from collections.abc import Callable, Iterable, Sequence, Set as AbstractSet
from dataclasses import dataclass

from nearfar._base.errors import UnusableError
from nearfar._scene.arrays import touching
from nearfar._scene.frames import Floats
from nearfar._scene.tileset.tile import Tile

MAX_TILES = 100_000
"""Maximum number of visited tiles; a whole planet has more."""

_REFERENCE_COST = 10
"""Number of tiles that the root of an external tileset counts as, because its file must be read."""

Touches = Callable[[Tile], bool]


@dataclass(frozen=True)
class Selection:
    """Tiles that show a tileset."""

    tiles: list[Tile]
    error: float
    """Greatest geometric error in metres of tiles whose children are not shown."""
    triangles: int = 0
    """Number of triangles of the tiles, if they were counted."""


class Visits:
    """Finds tiles that touch the requested part of the world, and limits the number of visited tiles."""

    def __init__(self, touches: Touches) -> None:
        self._touches = touches
        self._count = 0

    def touching(self, tiles: Iterable[Tile]) -> list[Tile]:
        """Return the tiles that touch the part."""
        return [tile for tile in tiles if self._touches(tile)]

    def children(self, tile: Tile) -> list[Tile]:
        """Return and count the children of a tile that touch the part; UnusableError beyond the limit."""
        children = self.touching(tile.children)
        self._count += len(children) * (_REFERENCE_COST if tile.is_reference else 1)
        if self._count > MAX_TILES:
            raise UnusableError(f"more than {MAX_TILES:,} tiles show it: state a larger error")
        return children


def box_test(box: Floats | None, to_scene: Floats) -> Touches:
    """Return a test of whether a tile's volume touches a box (2, 3) of the scene; without a box, all pass it."""
    if box is None:
        return lambda tile: True
    return lambda tile: bool(touching(tile.bounds(to_scene)[None], box)[0])


def by_error(
    root: Tile,
    error: float,
    touches: Touches,
    unrefined: AbstractSet[Tile] = frozenset(),
    *,
    refines_empty: bool = False,
) -> Selection:
    """Select tiles with content that show a tileset within a geometric error in metres, in document order.

    An error of 0 refines every tile with children. Tiles that do not touch the requested part of the world are left
    out; children of `unrefined` tiles cannot be shown. Tiles without content are refined only if nothing would be shown
    otherwise, or always with `refines_empty`.
    """
    visits = Visits(touches)
    selected: list[Tile] = []
    worst = 0.0
    pending = visits.touching([root])
    while pending:
        tile = pending.pop()
        is_coarse = tile.error > error or error == 0.0 or tile.is_reference or (refines_empty and not tile.has_content)
        refines = is_coarse and tile not in unrefined
        children = visits.children(tile) if refines else []
        if tile.has_content and not (tile.replaces and refines and tile.children):
            selected.append(tile)
        if not (refines or tile.is_leaf):
            worst = max(worst, tile.error)
        pending += reversed(children)
    if not (selected or refines_empty):
        return by_error(root, error, touches, unrefined, refines_empty=True)
    return Selection(selected, worst)


def touches_full_detail(root: Tile, touches: Touches) -> bool:
    """Whether a tile that shows content in full detail touches the requested part."""
    visits = Visits(touches)
    pending = visits.touching([root])
    while pending:
        tile = pending.pop()
        if tile.has_content and not (tile.replaces and tile.children):
            return True
        pending += reversed(visits.children(tile))
    return False


def substitute(tile: Tile) -> Tile | None:
    """Tile to show instead of one whose content cannot be read: its nearest ancestor with content.

    None if there is no such ancestor, or if it is shown together with its children anyway.
    """
    ancestor = tile.parent
    while ancestor is not None and not ancestor.has_content:
        ancestor = ancestor.parent
    return ancestor if ancestor is not None and ancestor.replaces else None


def by_triangles(
    root: Tile, max_count: int, touches: Touches, count: Callable[[Sequence[Tile]], Sequence[int | None]]
) -> Selection:
    """Select tiles with at most `max_count` triangles: tiles are refined by descending error while that fits.

    Tiles that do not touch the requested part of the world are left out. `count` returns the numbers of triangles of
    tiles, None for one whose content cannot be read. The selection has more triangles if the coarsest tiles do.
    """
    visits = Visits(touches)
    selected: dict[Tile, int] = {}
    order = itertools.count()
    heap: list[tuple[float, int, Tile]] = []
    total = 0
    worst = 0.0

    def show(tiles: dict[Tile, int]) -> None:
        nonlocal total
        selected.update(tiles)
        total += sum(tiles.values())
        for tile in tiles:
            heapq.heappush(heap, (-tile.error, next(order), tile))

    def readable(tiles: Sequence[Tile], *, descends: bool) -> dict[Tile, int] | None:
        """Return the number of triangles of each tile with content; empty if no tile touches the part.

        An unreadable tile is replaced by its children if `descends`; otherwise the result is None.
        """
        readable_sizes: dict[Tile, int] = {}
        pending = _with_content(visits.touching(tiles), visits)
        while pending:
            sizes = count(pending)
            failed = [tile for tile, size in zip(pending, sizes, strict=True) if size is None]
            if failed and not descends:
                return None
            readable_sizes |= {tile: size for tile, size in zip(pending, sizes, strict=True) if size is not None}
            pending = _with_content([child for tile in failed for child in visits.children(tile)], visits)
        return readable_sizes

    show(readable([root], descends=True) or {})
    while heap and total <= max_count:
        tile = heapq.heappop(heap)[2]
        children = readable(visits.children(tile), descends=not tile.replaces)
        removed = selected[tile] if tile.replaces else 0
        if children and total - removed + sum(children.values()) <= max_count:
            if tile.replaces:
                total -= selected.pop(tile)
            show(children)
        elif children != {}:
            worst = max(worst, tile.error)
    return Selection(list(selected), worst, total)


def _with_content(tiles: Sequence[Tile], visits: Visits) -> list[Tile]:
    """Tiles with content; the others are replaced by their descendants with content."""
    with_content: list[Tile] = []
    pending = [*reversed(tiles)]
    while pending:
        tile = pending.pop()
        if tile.has_content:
            with_content.append(tile)
        else:
            pending += reversed(visits.children(tile))
    return with_content
