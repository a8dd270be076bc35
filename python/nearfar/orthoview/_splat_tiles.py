"""Writes a tree as tiles of Gaussians: a tileset of 3D Tiles 1.1 with a GLB for each cell of each level.

Children replace their parent (refinement REPLACE). To keep documents small in any world, each document lists at most
four levels of tiles and refers to other documents for the levels below. Cells are written after their descendants, and
memory holds only tiles whose parents have not been written.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import files, formats, progress, side_by_side
from nearfar._base.version import __version__
from nearfar.orthoview import _splat_gltf as gltf
from nearfar.orthoview._availability import volume
from nearfar.orthoview._codec import Encoded
from nearfar.orthoview._grid import Place, widest
from nearfar.orthoview._splat_cells import Cells

TILESET = "tileset.json"

_LEVELS = 4
"""Maximum number of levels of a document."""

ERROR = 8.0
"""A cell's geometric error in pixels of its views. With a viewer's usual bound of 16 screen pixels, a view's pixel is
at most 2 screen pixels wide."""

_TO_ROOT = "../../../../"
"""Relative path from a document to the export's folder."""


@dataclass(frozen=True)
class _Tile:
    level: int
    place: Place
    box: NDArray[np.float64] | None
    """World box (2, 3) of its Gaussians, metres; None if it has none."""
    pixels: int
    """Number of non-empty pixels of its views within the box."""
    splats: int
    data: bytes
    """Content of its file."""


class _Tree:
    """Assembles tiles into documents; each tile is added after its descendants."""

    def __init__(self, folder: Path, cells: Cells, finest: int, contents: list[str]) -> None:
        self._folder, self._grid, self._finest, self._contents = folder, cells.layout.grid, finest, contents
        self._pixel = self._grid.cell * widest(cells.layout.directions) / cells.layout.size
        self._roots: dict[tuple[int, Place], tuple[dict[str, Any], NDArray[np.float64]]] = {}
        """Tiles whose parents have not been added, each with the box of itself and its descendants."""

    def add(self, tile: _Tile) -> None:
        """Add a tile; its children must have been added."""
        key, children, boxes = (tile.level, tile.place), [], [] if tile.box is None else [tile.box]
        if tile.level > self._finest:
            for _, child in self._grid.children(*key):
                if (root := self._roots.pop((tile.level - 1, child), None)) is not None:
                    children.append(root[0])
                    boxes.append(root[1])
        if not boxes:
            return
        box = np.array([np.min(boxes, axis=0)[0], np.max(boxes, axis=0)[1]])
        # A tile without children cannot be refined.
        error = ERROR * self._pixel * 2.0**tile.level if children else 0.0
        node: dict[str, Any] = {"boundingVolume": {"box": volume(box)}, "geometricError": error, "refine": "REPLACE"}
        if tile.box is not None:
            node["content"] = {"uri": _name("content", *key, "glb"), "boundingVolume": {"box": volume(tile.box)}}
        if children:
            node["children"] = children
        is_top = tile.level == self._grid.levels - 1
        if not is_top and (tile.level - self._finest) % _LEVELS == _LEVELS - 1:
            node = self._write_separately(key, node)
        self._roots[key] = node, box

    def _write_separately(self, key: tuple[int, Place], node: dict[str, Any]) -> dict[str, Any]:
        """Write a tile and its descendants into a separate document; return a tile that refers to it."""
        name = _name("tilesets", *key, "json")
        self._write(name, _with_rewritten_uris(node), node["geometricError"])
        shared = {part: node[part] for part in ("boundingVolume", "geometricError", "refine")}
        return shared | {"content": {"uri": name}}

    def finish(self) -> None:
        """Write the root document, if there is any tile."""
        top = (self._grid.levels - 1, (0, 0, 0))
        if top in self._roots:
            self._write(TILESET, self._roots[top][0], math.sqrt(3.0) * self._grid.side(top[0]))

    def _write(self, name: str, root: dict[str, Any], error: float) -> None:
        named = {"extensionsUsed": self._contents, "extensionsRequired": self._contents}
        document = {
            "asset": {"version": "1.1", "extras": {"generator": f"nearfar {__version__}"}},
            "extensionsUsed": ["3DTILES_content_gltf"],
            "extensions": {"3DTILES_content_gltf": named},
            "geometricError": error,
            "root": root,
        }
        _write_file(self._folder / name, formats.to_json(document, compact=True).encode())


def write(folder: Path, cells: Cells, finest: int, *, packed: bool, extras: Mapping[str, Any]) -> dict[str, int]:
    """Write the tiles of all levels from `finest` upwards into an empty folder; with `packed` they hold SPZ files.

    The GLB of each tile gets the entries `extras`. Returns the numbers of `tiles`, of `splats`, of the `pixels` that
    they represent, and of `bytes` of contents; all are 0 if nothing is in the box.
    """
    contents = [gltf.SPLATS, gltf.PACKED] if packed else [gltf.SPLATS]
    tree = _Tree(folder, cells, finest, contents)
    total = {"tiles": 0, "splats": 0, "pixels": 0, "bytes": 0}
    encode = partial(gltf.encode_packed if packed else gltf.encode_plain, extras=extras)
    size, done = math.prod(cells.layout.grid.counts), 0

    def jobs() -> Iterator[Callable[[], _Tile]]:
        for level, place in cells.cells_down_to(finest):
            yield partial(_encode_tile, cells, cells.chunks(level, place), level, place, encode)

    with progress.bar("exporting") as report:
        for tile in side_by_side.results(jobs()):
            total["pixels"] += tile.pixels
            if tile.data:
                # Jobs do not write files: after Ctrl-C running jobs would write into a folder that is being removed.
                _write_file(folder / _name("content", tile.level, tile.place, "glb"), tile.data)
                total["tiles"] += 1
                total["splats"] += tile.splats
                total["bytes"] += len(tile.data)
            tree.add(tile)
            if tile.level == finest:
                done += cells.layout.grid.leaves(tile.level, tile.place)
                report(done, size)
    tree.finish()
    return total


def _encode_tile(cells: Cells, chunks: Encoded, level: int, place: Place, encode: Callable[..., bytes]) -> _Tile:
    cell = cells.to_gaussians(level, place, chunks)
    splats = cell.gaussians
    if not len(splats):
        return _Tile(level, place, None, cell.pixels, 0, b"")
    box = splats.box() + cell.center
    return _Tile(level, place, box, cell.pixels, len(splats), encode(splats, cell.center))


def _write_file(path: Path, data: bytes) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    files.write(path, data)


def _name(folder: str, level: int, place: Place, suffix: str) -> str:
    x, y, z = place
    return f"{folder}/{level}/{x}/{y}/{z}.{suffix}"


def _with_rewritten_uris(node: dict[str, Any]) -> dict[str, Any]:
    """Copy a tile with URIs rewritten for a document in a subfolder."""
    rewritten = dict(node)
    if "content" in node:
        rewritten["content"] = node["content"] | {"uri": _TO_ROOT + node["content"]["uri"]}
    if "children" in node:
        rewritten["children"] = [_with_rewritten_uris(child) for child in node["children"]]
    return rewritten
