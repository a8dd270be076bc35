"""Writes a source as a folder of tiles, cell by cell."""

from __future__ import annotations

import os
import time
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, SupportsFloat

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check, files, progress
from nearfar._base.errors import SceneError
from nearfar._scene.moving_rows import moving_rows
from nearfar._scene.scene import Scene
from nearfar._source.protocol import SceneSource, bounds_of, source_of, unread_in
from nearfar._source.tile_index import DOCUMENT, Tile, TileIndex

_UPDATE_SECONDS = 10.0
"""Seconds between updates of the index; after a crash the next call repeats the work since the last update."""

MAX_CELLS = 1 << 20
"""Maximum number of cells of a grid."""

MAX_FAILED_CELLS = 1000
"""Number of cells that a source may fail to give before the writing stops."""

_MARGIN = 1e-12
"""Width added to a cell's box on each side, as a share of the greatest coordinate. Rounding in float64 may move a
triangle's centroid out of the cell, by less than a hundredth of this margin."""


def write_tiles(
    source: SceneSource,
    folder: str | os.PathLike[str],
    *,
    cell: SupportsFloat,
    aabb: ArrayLike | None = None,
    detail: SupportsFloat = 0.0,
) -> dict[tuple[int, int], str]:
    """Write a source as a folder of tiles, which `nearfar.open_source` opens.

    Each triangle is in exactly one tile: the tile of the cell that contains its centroid. The source is queried cell by
    cell, so that memory is bounded by a cell, not by the world. A call that was interrupted, by Ctrl-C or a crash, is
    resumed by another call with the same arguments.

    A cell that the source fails to give, or of which it cannot read a part, is incomplete: its tile has what there is.
    Returns the reasons by cell, named by the multiples of its width along x and z. The same call later writes these
    cells again; until then queries of the folder that touch them say so in a note. ValueError for an unbounded world
    without `aabb`, too many cells, numbers out of range, and a folder of tiles that were written with other arguments;
    TypeError for a value that is not a source, and values that are not numbers; SceneError for a source that failed for
    a thousand cells; OSError for a folder with other files, and files that cannot be written.

    Parameters
    ----------
    source
        World with `bounds` and `query`.
    folder
        The folder: new, empty, or partly written by this function. It gets GLB files, which other programs can read,
        too, and ``tiles.json`` with the box of each.
    cell
        Width of the square cells in the ground plane, metres.
    aabb
        World box (2, 3); only triangles whose centroids lie in it are written. By default all triangles.
    detail
        Maximum geometric error of the tiles in metres.
    """
    source, target = source_of("source", source), check.path("folder", folder)
    size, error = check.positive("cell", cell), check.at_least_zero("detail", detail)
    bounds = bounds_of(source)
    region = None if aabb is None else check.box("aabb", aabb)
    box = _intersection(bounds, region)
    if np.isinf(box).any() and (box[0] <= box[1]).all():
        raise ValueError("aabb: expected a finite box for an unbounded source")
    grid = Grid.from_bounds(box, size)
    settings = {"cell": size, "detail": error, "bounds": _box_as_json(bounds), "aabb": _box_as_json(region)}
    index = _open_index(target, settings, len(grid))
    return _TileWriter(source, target, grid, region, error).run(index).failed_cells


def _intersection(bounds: NDArray[np.float64], region: NDArray[np.float64] | None) -> NDArray[np.float64]:
    """Return the intersection of the source's box and the region; from +∞ to −∞ if it is empty."""
    if region is None:
        return bounds
    common = np.array([np.maximum(bounds[0], region[0]), np.minimum(bounds[1], region[1])])
    return common if (common[0] <= common[1]).all() else np.array([[np.inf] * 3, [-np.inf] * 3])


def _box_as_json(box: NDArray[np.float64] | None) -> list[list[float | None]] | None:
    """Convert a box for JSON: infinite coordinates become null."""
    if box is None:
        return None
    return [[coordinate if np.isfinite(coordinate) else None for coordinate in corner] for corner in box.tolist()]


def _open_index(folder: Path, settings: dict[str, Any], cells: int) -> TileIndex:
    """Return the index of a partly written folder, or a new one."""
    if (folder / DOCUMENT).is_file():
        index = TileIndex.read(folder)
        if index.settings != settings:
            raise ValueError(f"folder: expected tiles in {folder} made with these arguments, got {index.settings}")
        return index
    folder.mkdir(exist_ok=True)
    if any(folder.iterdir()):
        raise FileExistsError(f"{folder}: holds other files (no {DOCUMENT}), expected a new or empty folder")
    return TileIndex((0.0, 0.0, 0.0), settings, 0, cells, None, (), ())


@dataclass(frozen=True)
class Grid:
    """Square cells at multiples of their width; outer cells extend infinitely."""

    cell: float
    """Width of a cell, metres."""
    first: tuple[int, int]
    """Multiple of the width at which the first cell begins, along x and z."""
    counts: tuple[int, int]
    """Number of cells along x and z."""

    @classmethod
    def from_bounds(cls, bounds: NDArray[np.float64], cell: float) -> Grid:
        """Return the grid over a world box; ValueError if it would have too many cells."""
        if not np.isfinite(bounds[:, (0, 2)]).all():
            return cls(cell, (0, 0), (0, 0))
        with np.errstate(over="ignore", invalid="ignore"):  # a width near 0 gives infinitely many cells
            first, last = np.floor(bounds[:, (0, 2)] / cell)
            counts = last - first + 1
            total = counts.prod()
        if not total <= MAX_CELLS:
            got = f"{cell:g} m, {total:.3g} cells"
            raise ValueError(f"cell: expected a width with at most {MAX_CELLS:,} cells, got {got}")
        x, z = first.astype(np.int64).tolist()
        columns, rows = counts.astype(np.int64).tolist()
        return cls(cell, (x, z), (columns, rows))

    def __len__(self) -> int:
        """Return the number of cells."""
        return self.counts[0] * self.counts[1]

    def name(self, number: int) -> str:
        """Name a cell by its multiples of the width, so that grids of the same width name a cell alike."""
        row, column = divmod(number, self.counts[0])
        return f"{self.first[0] + column}_{self.first[1] + row}"

    def number(self, name: str) -> int:
        """Number of a cell by its name."""
        x, z = map(int, name.split("_"))
        return x - self.first[0] + (z - self.first[1]) * self.counts[0]

    def box(self, number: int) -> NDArray[np.float64]:
        """Return a world box (2, 3) that touches all triangles with centroids in a cell; unbounded in height."""
        row, column = divmod(number, self.counts[0])
        box = np.array([[-np.inf] * 3, [np.inf] * 3])
        for axis, index, first, count in zip((0, 2), (column, row), self.first, self.counts, strict=True):
            low, high = (first + index) * self.cell, (first + index + 1) * self.cell
            margin = _MARGIN * max(abs(low), abs(high))
            if index > 0:
                box[0, axis] = low - margin
            if index < count - 1:
                box[1, axis] = high + margin
        return box

    def cells_of_triangles(self, scene: Scene) -> NDArray[np.int64]:
        """Return the number (T,) of the cell that contains each triangle's centroid, or is nearest to it."""
        centroids = scene.triangles().mean(axis=1, dtype=np.float64) + scene.origin
        indices = np.floor(centroids[:, (0, 2)] / self.cell).astype(np.int64) - self.first
        column, row = np.clip(indices, 0, np.array(self.counts) - 1).T
        return np.asarray(column + row * self.counts[0])


class _TileWriter:
    """Writes the tiles of `write_tiles`, cell by cell."""

    def __init__(
        self, source: SceneSource, folder: Path, grid: Grid, region: NDArray[np.float64] | None, detail: float
    ) -> None:
        self._source, self._folder, self._grid = source, folder, grid
        self._region, self._detail = region, detail

    def run(self, index: TileIndex) -> TileIndex:
        """Write the tiles of the incomplete cells of the index, and of those that follow its cells."""
        saved_at, total = time.monotonic(), len(self._grid)
        repeated = sorted(map(self._grid.number, index.failed))
        done = index.written_cells - len(repeated)
        try:
            with progress.bar("tiles") as report:
                for count, number in enumerate((*repeated, *range(index.written_cells, total)), done):
                    report(count, total)
                    index = self._write_cell(index, number)
                    if len(index.failed) >= MAX_FAILED_CELLS:
                        reason = list(index.failed.values())[-1]
                        raise SceneError(
                            f"source: it failed for {len(index.failed):,} cells, the last one with {reason}"
                        )
                    if time.monotonic() - saved_at > _UPDATE_SECONDS:
                        index.write(self._folder)
                        saved_at = time.monotonic()
        finally:
            index.write(self._folder)
        return index

    def _write_cell(self, index: TileIndex, cell_number: int) -> TileIndex:
        """Write the tile of a cell, and return the index with it; a cell without triangles has no tile."""
        name = self._grid.name(cell_number)
        file, cell_scene, unread = f"tile_{name}.glb", None, []
        try:
            cell_scene = self._source.query(self._grid.box(cell_number), self._detail)
            unread = unread_in(self._source, cell_scene)
        except Exception as error:  # a source may raise anything; the other cells are still written
            unread = [f"{type(error).__name__}: {error}"]
        failed = {cell: why for cell, why in index.failed.items() if cell != name}
        if unread:
            failed[name] = check.one_line("; ".join(unread), 180)
        index = replace(
            index,
            written_cells=max(index.written_cells, cell_number + 1),
            tiles=tuple(tile for tile in index.tiles if tile.file != file),
            failed=failed,
        )
        if cell_scene is not None and cell_scene.triangle_count:
            cell_scene = self._triangles_of_cell(cell_scene, cell_number)
        if cell_scene is None or not cell_scene.triangle_count:
            (self._folder / file).unlink(missing_ok=True)  # an earlier call may have got a part of the cell
            return index
        names = cell_scene._names.source
        # An incomplete cell is not noted for good: its tile may be written again.
        notes = [note for note in cell_scene.report.notes if note not in unread]
        tiles = (*index.tiles, self._write_tile(cell_scene, file))
        return replace(
            index,
            origin=tuple(cell_scene.origin.tolist()) if not index.tiles else index.origin,
            nameless_objects=names if isinstance(names, int) else None,
            notes=tuple(dict.fromkeys((*index.notes, *notes))),
            tiles=tuple(sorted(tiles, key=lambda tile: self._grid.number(tile.file[len("tile_") : -len(".glb")]))),
        )

    def _triangles_of_cell(self, cell_scene: Scene, cell_number: int) -> Scene:
        in_cell = self._grid.cells_of_triangles(cell_scene) == cell_number
        if self._region is not None:
            centroids = cell_scene.triangles().mean(axis=1, dtype=np.float64) + cell_scene.origin
            in_cell &= ((centroids >= self._region[0]) & (centroids <= self._region[1])).all(axis=1)
        return cell_scene if in_cell.all() else cell_scene.subset(triangles=in_cell)

    def _write_tile(self, cell_scene: Scene, file: str) -> Tile:
        from nearfar._scene import glb

        with files.atomic_file(self._folder / file) as temporary:
            files.write(temporary, glb.encode(cell_scene._core, cell_scene.object_names, cell_scene._undrawn))
        moving = tuple(moving_rows(cell_scene)) if len(cell_scene._load_placements) else ()
        return Tile(file, cell_scene.bounds, cell_scene.triangle_count, moving)
