"""The index of a folder of tiles: `tiles.json` with the box of each tile."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check, formats

NAME = "tiles"
"""Name of the document's format without "nearfar."."""
VERSION = 1
DOCUMENT = "tiles.json"
"""Name of the index file in a folder of tiles."""

_CELL_NAME = re.compile(r"-?[0-9]{1,12}_-?[0-9]{1,12}")
_FILE_NAME = re.compile(r"tile_-?[0-9]{1,12}_-?[0-9]{1,12}\.glb")


@dataclass(frozen=True)
class Tile:
    """A tile, one file of a folder."""

    file: str
    """File name."""
    box: NDArray[np.float64]
    """Tight world box (2, 3) of its triangles, metres."""
    triangles: int
    moving: Sequence[dict[str, Any]] = ()
    """Rows of moving instances; see `moving_rows`."""


@dataclass(frozen=True)
class TileIndex:
    """Content of `tiles.json`."""

    origin: tuple[float, float, float]
    """World position to which the float32 coordinates in the files are relative."""
    settings: dict[str, Any]
    """Arguments of `write_tiles`: `cell`, `detail`, `bounds`, `aabb`. Only a call with equal values resumes the
    work."""
    written_cells: int
    """Number of cells whose tiles are written."""
    cell_count: int
    """Number of all cells."""
    nameless_objects: int | None
    """Number of objects if these have no names; None if the tiles contain names."""
    notes: tuple[str, ...]
    """Parts of the source that are not drawn or drawn differently."""
    tiles: tuple[Tile, ...]
    failed: dict[str, str] = field(default_factory=dict)
    """Reasons why cells are incomplete, by name."""

    def write(self, folder: Path) -> None:
        """Write the file, atomically."""
        document = formats.header(
            NAME,
            VERSION,
            origin=list(self.origin),
            color_space="linear",
            settings=self.settings,
            done=self.written_cells,
            cells=self.cell_count,
            object_names=self.nameless_objects,  # a count, as in `reduced.json`
            notes=list(self.notes),
            tiles=[_tile_row(tile) for tile in self.tiles],
            failed=self.failed,
        )
        formats.write_json(folder / DOCUMENT, document)

    @classmethod
    def read(cls, folder: Path) -> TileIndex:
        """Read the file of a folder; FormatError if it is damaged or too new, OSError if it is missing."""
        path = folder / DOCUMENT
        document = formats.read_json(path, NAME, VERSION)
        with formats.guarded(path):
            nameless_objects = document["object_names"]
            cells = check.integer("cells", document["cells"], 0, 2**53)
            index = cls(
                check.vector("origin", document["origin"]),
                check.instance("settings", document["settings"], dict),
                check.integer("done", document["done"], 0, cells),
                cells,
                None if nameless_objects is None else check.integer("object_names", nameless_objects, 0, 2**31 - 1),
                tuple(check.texts("notes", document["notes"])),
                tuple(_tile_from_row(row) for row in check.instance("tiles", document["tiles"], list)),
                dict(check.mapping("failed", document["failed"], "reasons by cells")),
            )
            check.positive("cell", index.settings["cell"])
            index.failed_boxes()
            return index

    @property
    def failed_cells(self) -> dict[tuple[int, int], str]:
        """Reasons why cells are incomplete, by the multiples of their width along x and z."""
        return {_cell_of(name): reason for name, reason in self.failed.items()}

    def failed_boxes(self) -> NDArray[np.float64]:
        """World boxes (N, 2, 3) of the incomplete cells, unbounded in height, in the order of `failed`."""
        width, infinite = self.settings["cell"], np.inf
        boxes = [
            [[x * width, -infinite, z * width], [(x + 1) * width, infinite, (z + 1) * width]]
            for x, z in self.failed_cells
        ]
        return np.array(boxes, np.float64).reshape(-1, 2, 3)

    @property
    def bounds(self) -> NDArray[np.float64]:
        """World box (2, 3) of all tiles; from +∞ to −∞ if there are none."""
        boxes = self.boxes
        return np.array([boxes[:, 0].min(axis=0, initial=np.inf), boxes[:, 1].max(axis=0, initial=-np.inf)])

    @property
    def boxes(self) -> NDArray[np.float64]:
        """World boxes (N, 2, 3) of the tiles."""
        return np.array([tile.box for tile in self.tiles], np.float64).reshape(-1, 2, 3)


def _cell_of(name: str) -> tuple[int, int]:
    """Parse the name of a cell; ValueError for anything else."""
    if not _CELL_NAME.fullmatch(name):
        raise ValueError(f"failed: expected names of cells such as 0_0, got {check.shortened(name)}")
    x, z = map(int, name.split("_"))
    return x, z


def _tile_row(tile: Tile) -> dict[str, Any]:
    row: dict[str, Any] = {"file": tile.file, "box": tile.box.tolist(), "triangles": tile.triangles}
    return row | {"moving": list(tile.moving)} if tile.moving else row


def _tile_from_row(row: dict[str, Any]) -> Tile:
    file = check.text("file", row["file"])
    if not _FILE_NAME.fullmatch(file):
        raise ValueError(f"file: expected names such as tile_0_0.glb, got {check.shortened(file)}")
    box = check.box("box", row["box"])
    if not np.isfinite(box).all():
        raise ValueError(f"box: expected finite numbers, got {box.tolist()}")
    return Tile(file, box, check.integer("triangles", row["triangles"], 1, 2**62), tuple(row.get("moving", ())))
