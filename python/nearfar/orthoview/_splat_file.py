"""Writes the cells of a level as one file of Gaussians, SPZ or GLB; sections gather in temporary files."""

from __future__ import annotations

import gzip
import os
import shutil
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

from nearfar._base import files, progress, side_by_side
from nearfar.orthoview import _splat_gltf as gltf, _spz as spz
from nearfar.orthoview._gaussians import SIGMA, Gaussians
from nearfar.orthoview._splat_cells import Cell, Cells

_PIECE = 1 << 22
"""Bytes copied between two checks for Ctrl-C."""

_LEVEL = 6
"""Compression level of gzip."""


class _Gathered:
    """Sections of a file, each in a temporary file."""

    def __init__(self, folder: Path, names: tuple[str, ...]) -> None:
        self._paths = {name: folder / str(number) for number, name in enumerate(names)}
        self._files: dict[str, BinaryIO] = {name: path.open("wb") for name, path in self._paths.items()}
        self.count = 0
        self.pixels = 0
        self.cells = 0
        self.extent = np.array([[np.inf] * 3, [-np.inf] * 3])
        """Least and greatest coordinates (2, 3) of the centres."""

    def add(self, sections: Mapping[str, bytes], cell: Cell, extent: NDArray[np.float64]) -> None:
        """Append the sections of a cell's Gaussians, whose centres have an extent (2, 3)."""
        for name, data in sections.items():
            self._files[name].write(data)
        self.cells += 1
        self.count += len(cell.gaussians)
        self.pixels += cell.pixels
        self.extent = np.array([np.minimum(self.extent[0], extent[0]), np.maximum(self.extent[1], extent[1])])

    def close(self) -> None:
        """Close all temporary files."""
        for file in self._files.values():
            file.close()

    def pour(self, target: Any) -> None:
        """Write all sections, one after the other."""
        self.close()
        for path in self._paths.values():
            with path.open("rb") as file:
                while piece := file.read(_PIECE):
                    progress.look()
                    target.write(piece)


def write(
    path: Path, target: Path, cells: Cells, level: int, *, packed: bool, is_gltf: bool, extras: Mapping[str, Any]
) -> dict[str, int]:
    """Write the cells of a level into an empty file; ValueError if it does not hold all splats.

    Temporary files are made beside `target`, the final file. Both `packed` and `is_gltf` give SPZ in a GLB, one of them
    SPZ alone or a GLB with plain attributes. `extras` are entries for the GLB's `extras`. Returns the numbers of
    `cells`, of `splats`, of the `pixels` that they represent, and of `bytes`; no splats if nothing is in the box.
    """
    bounds = cells.bounds()
    center = np.rint(bounds.mean(axis=0)) if is_gltf else np.zeros(3)
    with _folder_beside(target) as folder:
        if not packed:
            gathered = _gather(cells, level, center, folder, tuple(gltf.ATTRIBUTES), gltf.columns)
            if gathered.count:
                with path.open("wb") as file:
                    file.write(gltf.plain_start(gathered.count, gathered.extent, center, extras))
                    gathered.pour(file)
        else:
            pitch = cells.layout.grid.side(level) / cells.layout.size
            bits = spz.fraction_bits(float(np.abs(bounds - center).max()), SIGMA * pitch)
            version = 2 if is_gltf else 3
            encode = partial(spz.sections, bits=bits, version=version)
            gathered = _gather(cells, level, center, folder, spz.SECTIONS, encode, limit=spz.MAX)
            if gathered.count:
                inner = folder / "spz" if is_gltf else path
                _compress(inner, spz.header(version, gathered.count, bits), gathered)
                if is_gltf:
                    _wrap(inner, path, gathered, center, extras)
    size = path.stat().st_size
    return {"cells": gathered.cells, "splats": gathered.count, "pixels": gathered.pixels, "bytes": size}


@contextmanager
def _folder_beside(target: Path) -> Iterator[Path]:
    """Temporary folder beside the target, on the same disk; first removes folders that killed processes left."""
    parts = target.with_name(f"{target.name[:100]}.parts")
    files.clear(parts)
    with files.temporary_beside(parts, folder=True) as folder:
        try:
            yield folder
        finally:
            shutil.rmtree(folder, ignore_errors=True)


def _gather(
    cells: Cells,
    level: int,
    center: NDArray[np.float64],
    folder: Path,
    names: tuple[str, ...],
    encode: Callable[[Gaussians], dict[str, bytes]],
    limit: int = (1 << 32) - 1,
) -> _Gathered:
    """Gather the sections of all cells of a level, relative to a common centre."""

    def encode_cell(chunks: Any, place: Any) -> tuple[Cell, dict[str, bytes], Gaussians]:
        cell = cells.to_gaussians(level, place, chunks)
        gaussians = cell.gaussians.translate(cell.center - center)
        return cell, encode(gaussians), gaussians

    def jobs() -> Iterator[Any]:
        for _, place in cells.cells_of_level(level):
            yield partial(encode_cell, cells.chunks(level, place), place)

    grid, gathered = cells.layout.grid, _Gathered(folder, names)
    total, done = grid.leaves(grid.levels - 1, (0, 0, 0)), 0
    try:
        with progress.bar("exporting") as report:
            for cell, sections, moved in side_by_side.results(jobs()):
                if len(moved):
                    gathered.add(sections, cell, gltf.extent_of(moved))
                if gathered.count > limit:
                    raise ValueError(
                        f"level: expected one with at most {limit:,} splats in the box, level {level} has more; "
                        'take a higher one, a smaller aabb or format="tiles"'
                    )
                done += grid.leaves(level, cell.place)
                report(done, total)
    finally:
        gathered.close()
    return gathered


def _compress(path: Path, header: bytes, gathered: _Gathered) -> None:
    with path.open("wb") as file, gzip.GzipFile("", "wb", _LEVEL, file, mtime=0) as target:
        target.write(header)
        gathered.pour(target)


def _wrap(inner: Path, path: Path, gathered: _Gathered, center: NDArray[np.float64], extras: Mapping[str, Any]) -> None:
    """Wrap an SPZ file in a GLB."""
    size = os.stat(inner).st_size
    with inner.open("rb") as file, path.open("wb") as target:
        target.write(gltf.packed_start(gathered.count, size, gathered.extent, center, extras))
        shutil.copyfileobj(file, target, _PIECE)
        target.write(bytes(gltf.padding(size)))
