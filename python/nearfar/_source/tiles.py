"""A folder of tiles as a source: reads only tiles that touch a box, and caches the most recently used ones."""

from __future__ import annotations

import os
from collections import OrderedDict
from pathlib import Path
from threading import Lock
from typing import Any, SupportsFloat

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import background, check, formats
from nearfar._base.errors import FormatError
from nearfar._scene.arrays import touching
from nearfar._scene.joined import join_scenes
from nearfar._scene.moving_rows import frames_of
from nearfar._scene.names import Names
from nearfar._scene.report import Unread
from nearfar._scene.scene import Scene
from nearfar._scene.serialize import empty_core
from nearfar._source.tile_index import DOCUMENT, Tile, TileIndex


class TileFolder:
    """World in a folder written by `nearfar.write_tiles`."""

    def __init__(self, folder: Path, cache_bytes: int) -> None:
        self._folder, self._cache_bytes = folder, cache_bytes
        self._index = TileIndex.read(folder)
        if self._index.written_cells < self._index.cell_count:
            part = f"{self._index.written_cells} of {self._index.cell_count} cells"
            hint = "write_tiles with the same arguments writes the others"
            raise FormatError(f"{os.fspath(folder / DOCUMENT)}: expected all tiles, got only {part}; {hint}")
        self._boxes = self._index.boxes
        self._failed_boxes = self._index.failed_boxes()
        nameless = self._index.nameless_objects
        self._names = None if nameless is None else Names(nameless)
        self._cache: OrderedDict[str, Scene] = OrderedDict()
        self._lock = Lock()

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle the folder's path: another process reads the tiles itself."""
        return TileFolder, (self._folder.absolute(), self._cache_bytes)

    @property
    def bounds(self) -> NDArray[np.float64]:
        """World box (2, 3) of all triangles; from +∞ to −∞ without triangles."""
        return self._index.bounds

    @property
    def origin(self) -> NDArray[np.float64]:
        """World position (3,) that float32 coordinates are relative to."""
        return np.array(self._index.origin)

    @property
    def triangle_count(self) -> int:
        """Number of triangles of all tiles."""
        return sum(tile.triangles for tile in self._index.tiles)

    @property
    def failed(self) -> dict[tuple[int, int], str]:
        """Reasons why cells are incomplete, by the multiples of their width along x and z; see `write_tiles`.

        Queries that touch them have a note that says so.
        """
        return self._index.failed_cells

    @property
    def cached_bytes(self) -> int:
        """Memory of the cached tiles, with their search trees."""
        with self._lock:
            return sum(scene._core.bytes() for scene in self._cache.values())

    def query(self, aabb: ArrayLike, detail: SupportsFloat = 0.0) -> Scene:
        """Return a scene of the triangles that touch a box, whole; see `nearfar.SceneSource`.

        Tiles that touch the box are read unless they are cached. They always have full detail, whatever the `detail`.
        """
        box = check.box("aabb", aabb)
        check.at_least_zero("detail", detail)
        tiles = [self._index.tiles[number] for number in np.flatnonzero(touching(self._boxes, box))]
        parts = [part for part in (self._tile(tile).query(box) for tile in tiles) if part.triangle_count]
        self._evict()
        unread = self._unread(box)
        if unread or not parts:
            names = Names(()) if self._names is None else self._names
            parts.append(Scene(empty_core(self._index.origin), names, notes=(*self._index.notes, *unread)))
        return join_scenes(parts)

    def touches(self, aabb: ArrayLike) -> bool:
        """Return False if no tile's box, and no incomplete cell, touches a box; see `nearfar.SceneSource`.

        Reads nothing.
        """
        box = check.box("aabb", aabb)
        return bool(touching(self._boxes, box).any() or touching(self._failed_boxes, box).any())

    def _unread(self, box: NDArray[np.float64]) -> list[Unread]:
        """Notes on incomplete cells that touch a box."""
        cells = list(self._index.failed.items())
        touched = np.flatnonzero(touching(self._failed_boxes, box)).tolist()
        return [Unread(f"the tile of cell {cells[n][0]} is incomplete: {cells[n][1]}") for n in touched]

    def _tile(self, tile: Tile) -> Scene:
        """Return a tile, from the cache or from its file."""
        with self._lock:
            if tile.file in self._cache:
                self._cache.move_to_end(tile.file)
                return self._cache[tile.file]
        scene = background.run(lambda: self._read(tile))
        with self._lock:
            self._cache[tile.file] = scene
        self._evict(min_count=1)
        return scene

    def _read(self, tile: Tile) -> Scene:
        from nearfar._scene import glb

        path = self._folder / tile.file
        data = path.read_bytes()
        with formats.guarded(path, "tile"):
            decoder = glb.Decoder(data, self._names)
            core, names, undrawn = decoder.decode(), decoder.names, decoder.undrawn
            if core.triangle_count != tile.triangles:
                raise ValueError(f"expected {tile.triangles} triangles as in {DOCUMENT}, got {core.triangle_count}")
            frames, placements = frames_of(tile.moving, names, core.moving_placements(), tile.file)
        return Scene(core, names, frames=frames, load_placements=placements, notes=self._index.notes, undrawn=undrawn)

    def _evict(self, min_count: int = 0) -> None:
        """Evict the least recently used tiles until the others fit; search trees are counted once they are built."""
        with self._lock:
            sizes = {file: scene._core.bytes() for file, scene in self._cache.items()}
            total = sum(sizes.values())
            while total > self._cache_bytes and len(self._cache) > min_count:
                file, _ = self._cache.popitem(last=False)
                total -= sizes[file]

    def __len__(self) -> int:
        return len(self._index.tiles)

    def __repr__(self) -> str:
        return f"<nearfar source: {len(self):,} tiles, {self.triangle_count:,} triangles in {self._folder}>"
