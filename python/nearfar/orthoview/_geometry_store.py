"""Stores the geometry of a tree's leaves as a tileset of 3D Tiles, in a folder of the tree's store.

A leaf's files are written under temporary names and then renamed, so that an interrupted build leaves only whole files.
`finish` finds them by listing the folders, so the build needs no other record of them.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from itertools import chain
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check, files, formats, glb
from nearfar._base.errors import FormatError
from nearfar._base.version import __version__
from nearfar._scene.scene import Scene
from nearfar.orthoview import _availability as availability
from nearfar.orthoview._geometry import Images, cell_glb, moving_glb, step_of
from nearfar.orthoview._grid import Grid, Place

FOLDER = "geometry"
"""Name of the geometry's folder in a store."""

TILESET, MOVING, SUBTREES = "tileset.json", "moving.json", "subtrees"

IMAGES = "images"
"""Name of the folder of textures."""

SHARED_FOLDERS = (SUBTREES, IMAGES)
"""Folders shared by all leaves."""

STATIC_FOLDER, MOVING_FOLDER = "content", "moving"
"""Folders of static and of moving triangles."""

KIND, VERSION = "orthoview_moving", 1
"""Kind and version of the list of moving objects."""

_NAME = "{level}/{x}/{y}/{z}.glb"
_FIRST_SUBTREE = availability.NAME.format(level=0, x=0, y=0, z=0)
_NUMBER = re.compile(r"0|[1-9][0-9]{0,9}")
_GLB_START = 20
"""Bytes of a GLB before its JSON document."""


class Facts(NamedTuple):
    """Properties of a leaf's GLB, read from the file itself."""

    bytes: int
    triangles: int
    error: float
    box: NDArray[np.float64]
    moving: list[dict[str, Any]]


def names(grid: Grid, place: Place) -> tuple[str, str]:
    """File names of a leaf's static and moving triangles, below the store."""
    static, moving = (f"{FOLDER}/{_name(grid, folder, place)}" for folder in (STATIC_FOLDER, MOVING_FOLDER))
    return static, moving


def _name(grid: Grid, folder: str, place: Place) -> str:
    x, y, z = place
    return f"{folder}/{_NAME.format(level=grid.levels - 1, x=x, y=y, z=z)}"


class GeometryStore:
    """Writes the geometry of a tree's leaves below the store's folder."""

    def __init__(self, store: Path, grid: Grid) -> None:
        self._folder, self._grid = store / FOLDER, grid
        self._images = Images(self._folder / IMAGES)

    def write(self, part: Scene, place: Place) -> int:
        """Write the triangles that belong to a leaf; return the number of bytes.

        `part` is the result of querying the leaf's box. Writing a leaf again gives the same bytes.
        """
        written = 0
        for folder, encode in ((STATIC_FOLDER, cell_glb), (MOVING_FOLDER, moving_glb)):
            data = encode(part, self._grid, place, self._images)
            path = self._path(folder, place)
            if data is None:
                path.unlink(missing_ok=True)  # an earlier build may have read only a part of the leaf
            else:
                path.parent.mkdir(parents=True, exist_ok=True)
                with files.atomic_file(path) as temporary:
                    files.write(temporary, data)
                written += len(data)
        return written

    def finish(self) -> dict[str, Any]:
        """Write the tileset of all leaves that have files, and the list of moving objects.

        Returns the numbers of `leaves`, `triangles` and `bytes` of static geometry, counts of `moving` geometry, the
        greatest `error` of a position along an axis and the `step` of positions, metres. Raises FormatError for a file
        that is damaged or belongs to no leaf, OSError for files that cannot be read or written.
        """
        total = {"leaves": 0, "triangles": 0, "bytes": 0, "error": 0.0}

        def box_of(place: Place) -> NDArray[np.float64]:
            facts = self._facts(STATIC_FOLDER, place)
            total["leaves"] += 1
            total["triangles"] += facts.triangles
            total["bytes"] += facts.bytes
            total["error"] = max(total["error"], facts.error)
            return facts.box

        self._folder.mkdir(parents=True, exist_ok=True)
        leaves = np.fromiter(chain.from_iterable(self._listed_leaves(STATIC_FOLDER)), np.int64).reshape(-1, 3)
        box = None
        if len(leaves):
            with files.atomic_folder(self._folder / SUBTREES, marker=_FIRST_SUBTREE) as temporary:
                box = availability.write(temporary, self._grid.levels, leaves, box_of)
        places = {_name(self._grid, MOVING_FOLDER, place): place for place in self._listed_leaves(MOVING_FOLDER)}
        movers = {name: self._facts(MOVING_FOLDER, place) for name, place in places.items()}
        self._write_movers(movers)
        document = self._tileset(box, {name: facts.box for name, facts in movers.items()})
        formats.write_json(self._folder / TILESET, document)
        moving = {
            "files": len(movers),
            "triangles": sum(facts.triangles for facts in movers.values()),
            "bytes": sum(facts.bytes for facts in movers.values()),
            "objects": len({row["object"] for facts in movers.values() for row in facts.moving}),
        }
        error = max([total["error"], *(facts.error for facts in movers.values())])
        return {**total, "error": error, "step": step_of(self._grid), "moving": moving}

    def _tileset(self, box: NDArray[np.float64] | None, movers: dict[str, NDArray[np.float64]]) -> dict[str, Any]:
        """Return the tileset document: the tree, and a tile for each file of moving triangles."""
        levels = self._grid.levels
        # Cells above the leaves have no content, so a cell whose children are not drawn is off by its whole diagonal.
        error = math.sqrt(3.0) * self._grid.side(levels - 1)
        children: list[dict[str, Any]] = []
        if box is not None:
            children.append(
                {
                    "boundingVolume": {"box": self._cube()},
                    "geometricError": error,
                    "refine": "ADD",
                    "content": {"uri": f"{STATIC_FOLDER}/{_NAME}"},
                    "implicitTiling": {
                        "subdivisionScheme": "OCTREE",
                        "subtreeLevels": availability.subtree_levels(levels),
                        "availableLevels": levels,
                        "subtrees": {"uri": f"{SUBTREES}/{availability.NAME}"},
                    },
                }
            )
        for name, box_of_file in movers.items():
            tile = {"boundingVolume": {"box": availability.volume(box_of_file)}, "geometricError": 0.0}
            children.append({**tile, "content": {"uri": name}, "extras": {"moving": True}})
        boxes = [*([] if box is None else [box]), *movers.values()]
        root_box = self._grid.box(levels - 1, (0, 0, 0))
        if boxes:
            root_box = np.array([np.min(boxes, axis=0)[0], np.max(boxes, axis=0)[1]])
        root = {"boundingVolume": {"box": availability.volume(root_box)}, "geometricError": error, "refine": "ADD"}
        return {
            "asset": {"version": "1.1", "extras": {"generator": f"nearfar {__version__}"}},
            "geometricError": error,
            "schema": availability.SCHEMA,
            "root": {**root, **({"children": children} if children else {})},
        }

    def _cube(self) -> list[float]:
        """Box of the root's cell with the grid's axes, so that cells have the same numbers in tree and tileset."""
        half = self._grid.side(self._grid.levels - 1) / 2
        x, y, z = (low + half for low in self._grid.origin)
        return [x, 0.0 - z, y, half, 0.0, 0.0, 0.0, 0.0, half, 0.0, -half, 0.0]

    def _write_movers(self, movers: dict[str, Facts]) -> None:
        rows = [
            {"file": name, "triangles": facts.triangles, "box": facts.box.tolist(), "instances": facts.moving}
            for name, facts in movers.items()
        ]
        formats.write_json(self._folder / MOVING, formats.header(KIND, VERSION) | {"files": rows})

    def _path(self, folder: str, place: Place) -> Path:
        return self._folder / _name(self._grid, folder, place)

    def _listed_leaves(self, folder: str) -> Iterator[Place]:
        """Leaves that have a file in a folder, in ascending order."""
        top = self._folder / folder / str(self._grid.levels - 1)
        for x, column in _numbered(top, ""):
            for y, layer in _numbered(column, ""):
                for z, path in _numbered(layer, ".glb"):
                    if not all(number < count for number, count in zip((x, y, z), self._grid.counts, strict=True)):
                        raise FormatError(f"{path}: expected a leaf among {self._grid.counts}")
                    yield x, y, z

    def _facts(self, folder: str, place: Place) -> Facts:
        path = self._path(folder, place)
        with path.open("rb") as file, formats.guarded(path, "geometry"):
            start = file.read(_GLB_START)
            head = start + file.read(int.from_bytes(start[12:16], "little"))
            size = file.seek(0, 2)
            extras = glb.header(head, formats.from_json)[0]["asset"]["extras"]
            if (stated := int.from_bytes(head[8:12], "little")) != size:
                raise ValueError(f"expected {stated} bytes, got {size}")
            rows = check.items("moving", extras["moving"], dict, "rows") if folder == MOVING_FOLDER else []
            triangles = check.integer("triangles", extras["triangles"], 1, 1 << 40)
            error = check.at_least_zero("error", extras["error"])
            return Facts(size, triangles, error, check.box("box", extras["box"]), list(rows))


def _numbered(folder: Path, suffix: str) -> Iterator[tuple[int, Path]]:
    """Entries of a folder named by a number and a suffix, ascending; none if the folder does not exist."""
    if not folder.is_dir():
        return
    names = (path.name.removesuffix(suffix) for path in folder.iterdir() if path.name.endswith(suffix))
    for number in sorted(int(name) for name in names if _NUMBER.fullmatch(name)):
        yield number, folder / f"{number}{suffix}"
