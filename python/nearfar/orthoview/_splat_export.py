"""Exports trees for splat viewers, as an SPZ or GLB file or as tiles of Gaussians; see `OrthoTree.export_splats`."""

from __future__ import annotations

import gzip
import math
import shutil
from collections.abc import Callable, Iterator, Mapping
from contextlib import closing
from functools import partial
from pathlib import Path
from tempfile import TemporaryFile
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check, files, progress, side_by_side
from nearfar._base.errors import UnusableError
from nearfar.orthoview import _splat_gltf as gltf, _splat_tiles, _spz as spz
from nearfar.orthoview._gaussians import SIGMA, SUN, Gaussians
from nearfar.orthoview._splat_cells import Cell, Cells, Sun

FORMATS = ("spz", "gltf", "tiles")
SUFFIXES = {".spz": "spz", ".glb": "gltf", "": "tiles"}

_PIECE = 1 << 22
"""Bytes copied between two checks for Ctrl-C."""

_GZIP_LEVEL = 6
"""Compression level of gzip."""


def export(
    cells: Cells,
    target: Path,
    *,
    format: str | None,  # noqa: A002 - a public name
    level: int,
    compression: str | None,
) -> dict[str, int]:
    """Write cells of a tree for splat viewers; the arguments are those of `OrthoTree.export_splats`."""
    kind = format_of(target) if format is None else check.choice("format", format, FORMATS)
    packed = compression is not None and check.choice("compression", compression, ("spz",)) == "spz"
    if packed and kind == "spz":
        raise ValueError('compression: expected None for format="spz", whose files are SPZ anyway')
    extras: Mapping[str, Any] = {"light": "none" if cells.sun is None else {"sun": list(cells.sun)}}
    is_folder, is_gltf, folder = kind == "tiles", kind == "gltf", target.parent
    replacing = files.atomic_folder(target, marker=_splat_tiles.TILESET) if is_folder else files.atomic_file(target)
    try:
        with replacing as path:
            if is_folder:
                counts = _splat_tiles.write(path, cells, level, packed=packed, extras=extras)
            else:
                packed |= not is_gltf
                counts = _write_file(path, folder, cells, level, packed=packed, is_gltf=is_gltf, extras=extras)
            if not counts["splats"]:
                raise ValueError("aabb: expected a box in which views show something")
    except UnusableError as error:
        raise ValueError(f"level: {error}") from None
    return counts


def format_of(path: Path) -> str:
    """Return the format for a file's suffix."""
    if path.suffix.lower() not in SUFFIXES:
        raise ValueError(f"path: expected a file .spz or .glb, or a folder without a suffix, got {path.name}")
    return SUFFIXES[path.suffix.lower()]


def sun_of(light: str | ArrayLike | None) -> Sun:
    """Return the unit vector towards the sun for the argument `light`; None for no light."""
    if light is None:
        return None
    if isinstance(light, str):
        check.choice("light", light, ("sun",))
        return SUN
    x, y, z = check.vector("light", light)
    length = math.sqrt(x * x + y * y + z * z)
    if not 0.0 < length < math.inf:
        raise ValueError(f"light: expected a direction that is not 0, got {check.value_or_type(light)}")
    return x / length, y / length, z / length


class _Sections:
    """Sections of a file, each in an anonymous temporary file, which disappears with the process."""

    def __init__(self, folder: Path, names: tuple[str, ...]) -> None:
        self._files = {name: TemporaryFile(dir=folder) for name in names}  # noqa: SIM115 - `close` closes them
        self.count = self.pixels = self.cells = 0
        self.extent = np.array([[np.inf] * 3, [-np.inf] * 3])
        """Least and greatest coordinates (2, 3) of the centres."""

    def add(self, sections: Mapping[str, bytes], cell: Cell, extent: NDArray[np.float64]) -> None:
        """Append the sections of a cell's Gaussians; `extent` (2, 3) is the box of their centres."""
        for name, data in sections.items():
            self._files[name].write(data)
        self.cells += 1
        self.count += len(cell.gaussians)
        self.pixels += cell.pixels
        self.extent = np.array([np.minimum(self.extent[0], extent[0]), np.maximum(self.extent[1], extent[1])])

    def close(self) -> None:
        for file in self._files.values():
            file.close()

    def copy_to(self, target: Any) -> None:
        """Write all sections to a file, one after the other."""
        for file in self._files.values():
            file.seek(0)
            while piece := file.read(_PIECE):
                progress.look()
                target.write(piece)


def _write_file(
    path: Path, folder: Path, cells: Cells, level: int, *, packed: bool, is_gltf: bool, extras: Mapping[str, Any]
) -> dict[str, int]:
    """Write the cells of a level into an empty file; ValueError if it does not hold all splats.

    Temporary files are made in `folder`. With `packed` and `is_gltf` the file is an SPZ in a GLB, with `packed` alone
    an SPZ, with `is_gltf` alone a GLB with plain attributes. `extras` are entries for the GLB's `extras`. Returns the
    numbers of `cells`, of `splats`, of the `pixels` that they represent, and of `bytes`; 0 splats for an empty box.
    """
    bounds = cells.bounds()
    center = np.rint(bounds.mean(axis=0)) if is_gltf else np.zeros(3)
    pitch, version = cells.layout.grid.side(level) / cells.layout.size, 2 if is_gltf else 3
    names, encode, limit = tuple(gltf.ATTRIBUTES), gltf.encode_attributes, (1 << 32) - 1
    if packed:
        bits = spz.fraction_bits(float(np.abs(bounds - center).max()), SIGMA * pitch)
        names, encode, limit = spz.SECTIONS, partial(spz.encode_sections, bits=bits, version=version), spz.MAX
    with closing(_Sections(folder, names)) as sections, path.open("wb") as file:
        _collect(sections, cells, level, center, encode, limit)
        count, extent = sections.count, sections.extent
        if count and not packed:
            file.write(gltf.plain_start(count, extent, center, extras))
            sections.copy_to(file)
        elif count and not is_gltf:
            _compress(file, spz.header(version, count, bits), sections)
        elif count:
            with TemporaryFile(dir=folder) as inner:
                _compress(inner, spz.header(version, count, bits), sections)
                size = inner.tell()
                inner.seek(0)
                file.write(gltf.packed_start(count, size, extent, center, extras))
                shutil.copyfileobj(inner, file, _PIECE)
                file.write(bytes(gltf.padding(size)))
        size = file.tell()
    return {"cells": sections.cells, "splats": count, "pixels": sections.pixels, "bytes": size}


def _collect(
    sections: _Sections,
    cells: Cells,
    level: int,
    center: NDArray[np.float64],
    encode: Callable[[Gaussians], dict[str, bytes]],
    limit: int,
) -> None:
    """Collect the sections of all cells of a level, relative to a common centre."""

    def encode_cell(chunks: Any, place: Any) -> tuple[Cell, dict[str, bytes], Gaussians]:
        cell = cells.to_gaussians(level, place, chunks)
        gaussians = cell.gaussians.translate(cell.center - center)
        return cell, encode(gaussians), gaussians

    def jobs() -> Iterator[Any]:
        for _, place in cells.cells_of_level(level):
            yield partial(encode_cell, cells.chunks(level, place), place)

    grid = cells.layout.grid
    total, exported_leaves = math.prod(grid.counts), 0
    with progress.bar("exporting") as report:
        for cell, cell_sections, gaussians in side_by_side.results(jobs()):
            if len(gaussians):
                sections.add(cell_sections, cell, gltf.extent_of(gaussians))
            if sections.count > limit:
                raise ValueError(
                    f"level: expected one with at most {limit:,} splats in the box, level {level} has more; "
                    'take a higher one, a smaller aabb or format="tiles"'
                )
            exported_leaves += grid.leaves(level, cell.place)
            report(exported_leaves, total)


def _compress(file: BinaryIO | Any, header: bytes, sections: _Sections) -> None:
    with gzip.GzipFile("", "wb", _GZIP_LEVEL, file, mtime=0) as target:
        target.write(header)
        sections.copy_to(target)
