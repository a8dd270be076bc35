"""Writes the subtrees of a tileset (3D Tiles 1.1): availability bits of tiles, and a bounding box for each tile.

Levels of a tileset count from the root. A subtree holds the cells of some levels below one cell, each level in Morton
order: the bits of x, y and z interleaved, x lowest. Cells are numbered as in the grid.

Triangles reach beyond the cell that they belong to. The metadata TILE_BOUNDING_BOX has the box of all content of a cell
and of the cells below it. Viewers that read it do not cull triangles that are visible at the edge of the picture.
"""

from __future__ import annotations

import json
import struct
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import files
from nearfar.orthoview._grid import Place, places_of

Floats = NDArray[np.float64]

_LEVELS = (4, 5, 6)
"""Allowed numbers of levels of a subtree."""

NAME = "{level}.{x}.{y}.{z}.subtree"
"""Name of a subtree's file by its first cell."""

CLASS, PROPERTY = "tile", "box"
"""Names of the metadata's class and property."""

_BOX_TYPE = {"type": "SCALAR", "componentType": "FLOAT64", "array": True, "count": 12}
_BOX_PROPERTY = {**_BOX_TYPE, "required": True, "semantic": "TILE_BOUNDING_BOX"}
SCHEMA: dict[str, Any] = {"id": "nearfar", "classes": {CLASS: {"properties": {PROPERTY: _BOX_PROPERTY}}}}

_HEADER = struct.Struct("<4sIQQ")
_TO_Z_UP = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])


def subtree_levels(levels: int) -> int:
    """Return the levels of a subtree: as many as possible in the lowest subtrees, which are most of the files."""
    return max(_LEVELS, key=lambda count: (levels - 1) % count)


def write(folder: Path, levels: int, leaves: NDArray[np.int64], box_of: Callable[[Place], Floats]) -> Floats:
    """Write all subtrees of a tree, from the leaves up; return the bounding box (2, 3) of all leaves.

    `leaves` (N, 3) are the leaves that have content, at least one, without duplicates. `box_of` is called once for each
    and returns the bounding box (2, 3) of its content, world, metres.
    """
    cells: NDArray[np.int64] = leaves
    boxes: Floats | None = None
    levels_of_subtree = subtree_levels(levels)
    for first_level in range((levels - 1) // levels_of_subtree * levels_of_subtree, -1, -levels_of_subtree):
        depth = min(levels - 1 - first_level, levels_of_subtree)
        roots = cells >> depth
        numbers = morton(cells - (roots << depth), depth)
        order = np.lexsort((numbers, *roots.T[::-1]))
        starts = np.flatnonzero(np.diff(roots[order], axis=0, prepend=-1).any(axis=1))
        root_boxes = np.empty((len(starts), 2, 3))
        for number, rows in enumerate(np.split(order, starts[1:])):
            cell_boxes = np.array([box_of(place) for place in places_of(cells[rows])]) if boxes is None else boxes[rows]
            data, root_boxes[number] = _encode(
                numbers[rows], depth, levels_of_subtree, cell_boxes, has_content=boxes is None
            )
            x, y, z = roots[rows[0]].tolist()
            files.write(folder / NAME.format(level=first_level, x=x, y=y, z=z), data)
        cells, boxes = roots[order[starts]], root_boxes
    assert boxes is not None
    return np.asarray(boxes[0])


def morton(cells: NDArray[np.int64], bits: int) -> NDArray[np.int64]:
    """Morton numbers (N,) of cells (N, 3) whose coordinates have `bits` bits."""
    numbers = np.zeros(len(cells), np.int64)
    for bit in range(bits):
        for axis in range(3):
            numbers |= (cells[:, axis] >> bit & 1) << (3 * bit + axis)
    return numbers


def volume(box: Floats) -> list[float]:
    """Convert a box (2, 3) of the world, y up, to a tileset's, z up: the centre, then half of each edge."""
    z_up = box @ _TO_Z_UP.T
    half_edges = np.abs(z_up[1] - z_up[0]) / 2
    return [*z_up.mean(axis=0).tolist(), *np.diag(half_edges).ravel().tolist()]


def _encode(
    numbers: NDArray[np.int64], depth: int, levels: int, boxes: Floats, *, has_content: bool
) -> tuple[bytes, Floats]:
    """Encode a subtree; also return the bounding box of its content.

    `numbers` are the Morton numbers, ascending, of the cells that exist `depth` levels below the subtree's first cell:
    leaves, which have content, or roots of child subtrees, one level below the subtree's own levels.
    """
    numbers_by_depth, boxes_by_depth = [numbers], [boxes]
    while len(numbers_by_depth) <= depth:
        parents, starts = np.unique(numbers_by_depth[-1] >> 3, return_index=True)
        low = np.minimum.reduceat(boxes_by_depth[-1][:, 0], starts)
        high = np.maximum.reduceat(boxes_by_depth[-1][:, 1], starts)
        numbers_by_depth.append(parents)
        boxes_by_depth.append(np.stack([low, high], axis=1))
    root = boxes_by_depth[-1][0]
    if not has_content:
        del numbers_by_depth[0], boxes_by_depth[0]
    tiles = np.concatenate([start_of(level) + found for level, found in enumerate(reversed(numbers_by_depth))])
    rows = np.array([volume(box) for level in reversed(boxes_by_depth) for box in level])
    views = _Views()
    document = {
        "tileAvailability": views.bits(tiles, start_of(levels)),
        "contentAvailability": [views.bits(start_of(depth) + numbers if has_content else None, start_of(levels))],
        "childSubtreeAvailability": views.bits(None if has_content else numbers, 8**levels),
        "tileMetadata": 0,
        "propertyTables": [
            {"class": CLASS, "count": len(tiles), "properties": {PROPERTY: {"values": views.add(rows.tobytes())}}}
        ],
    }
    return views.encoded(document), root


def start_of(level: int) -> int:
    """Number of a subtree's cells above a level, which is also the index of the level's first cell."""
    return ((1 << 3 * level) - 1) // 7


class _Views:
    """Buffer and buffer views of a subtree."""

    def __init__(self) -> None:
        self._data = b""
        self._views: list[dict[str, int]] = []

    def add(self, data: bytes) -> int:
        """Append bytes, padded to a multiple of eight; return the index of their buffer view."""
        self._views.append({"buffer": 0, "byteOffset": len(self._data), "byteLength": len(data)})
        self._data += data + bytes(-len(data) % 8)
        return len(self._views) - 1

    def bits(self, numbers: NDArray[np.int64] | None, count: int) -> dict[str, int]:
        """Add a bitstream of `count` bits that are set at `numbers`; None sets none."""
        if numbers is None:
            return {"constant": 0}
        flags = np.zeros(count, bool)
        flags[numbers] = True
        return {"bitstream": self.add(np.packbits(flags, bitorder="little").tobytes()), "availableCount": len(numbers)}

    def encoded(self, document: dict[str, Any]) -> bytes:
        complete = {"buffers": [{"byteLength": len(self._data)}], "bufferViews": self._views, **document}
        text = json.dumps(complete, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 8)
        return _HEADER.pack(b"subt", 1, len(text), len(self._data)) + text + self._data
