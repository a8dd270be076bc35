"""Layout of a tree, and the places of its parts in the store.

A store is a group of Zarr v3. The array ``L/D`` has the views of level L from direction D: X × Y × Z cells with one
chunk each. A chunk is a whole view, so that a reader gets it by one request. A subtree, the unit of work of a build,
has m levels, with 2ᵐ cells along each axis on the lowest one; tiers of subtrees follow each other from the leaves to
the root. A shard holds the chunks of a subtree in one array.

A view's bytes are the colours of all its layers, then the planes of depth bytes, the lowest first, then the normals.
Depths compress better in planes of bytes (by 4 % of a view), colours and normals better pixel by pixel.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, fields, replace
from functools import cached_property
from math import prod
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import check
from nearfar.orthoview._grid import MAX_CELLS, Direction, Grid, Place
from nearfar.orthoview._zstd import COMPRESSION

Key = tuple[int, Place, str]
"""Level, place and array of a chunk."""

ViewKey = tuple[int, Place, int]
"""Level, place and direction of a view."""

SubtreeKey = tuple[int, Place]
"""Tier and place of a subtree."""

Chunk = tuple[int, int]
"""First byte and length of a chunk in its shard."""

CONNECTION_BITS = 4
"""Number of bits below a depth, for the connections to the neighbours to the right, below, below right, below left."""

FOLDER = "nearfar"
"""Folder in a store for files that are not part of Zarr."""


def check_zarr() -> None:
    """Raise an ImportError that says what to install if zarr or one of its dependencies is missing."""
    try:
        import google_crc32c
        import numcodecs
        import zarr
    except ImportError as error:
        raise ImportError(
            f'orthoviews need the Python package {error.name}: pip install "nearfar[orthoview]"'
        ) from None
    del google_crc32c, numcodecs, zarr


class Channels(NamedTuple):
    """Channels of a view's layers, each layer size × size pixels."""

    color: NDArray[np.uint8]
    """Colours, sRGB (layers, size, size, 3)."""
    depth: NDArray[np.uint32]
    """Depths with the connections below them (layers, size, size); 0 for empty pixels."""
    normal: NDArray[np.uint8]
    """Packed normals (layers, size, size, 2 or 3)."""


@dataclass(frozen=True)
class Layout:
    """Cells, directions and format of a tree."""

    grid: Grid
    directions: tuple[Direction, ...]
    size: int
    """Width and height of a view, pixels."""
    depth_bits: int
    normal_bits: int
    """Bits of both components of a normal together."""
    subtree: int
    """Levels of a subtree."""
    color: str = "zstd"
    """Compression of colours: zstd or webp."""
    quality: int | None = None
    """WebP quality, 0 to 100; None for lossless files."""
    geometry: bool = False
    """Whether the store also has the geometry of leaves."""
    layers: int = 1
    """1, or 2 to store also a second surface behind that of each pixel."""

    @property
    def format(self) -> tuple[int, int, int]:
        """Format of views, as an argument of the core."""
        return self.size, self.depth_bits, self.normal_bits

    @property
    def lossless(self) -> Layout:
        """The same layout with lossless colours."""
        return replace(self, color="zstd", quality=None)

    @property
    def tiers(self) -> int:
        """Number of tiers of subtrees from the leaves to the root."""
        return -(-self.grid.levels // self.subtree)

    @cached_property
    def names(self) -> tuple[str, ...]:
        """Names of the directions: axes with p (positive) or n (negative), such as ``px_py``."""
        return tuple(
            "_".join(
                f"{'p' if number > 0 else 'n'}{axis}" for axis, number in zip("xyz", direction, strict=True) if number
            )
            for direction in self.directions
        )

    def shard_side(self, level: int) -> int:
        """Cells of a shard of a level, along each axis."""
        return 1 << (self.subtree - level % self.subtree)

    def shard_of(self, level: int, place: Place) -> tuple[Place, Place]:
        """Place of the shard that holds a cell, and the cell's place in the shard."""
        side = self.shard_side(level)
        (x, y, z), (u, v, w) = ([divmod(number, side)[part] for number in place] for part in (0, 1))
        return (x, y, z), (u, v, w)

    def key(self, view: ViewKey) -> Key:
        """Key of a view's chunk."""
        level, place, direction = view
        return level, place, f"{level}/{self.names[direction]}"

    def shard_path(self, key: Key) -> str:
        """Path of the shard that holds a chunk, below the store."""
        level, place, array = key
        shard, _ = self.shard_of(level, place)
        return "/".join(map(str, (array, "c", *shard, 0)))

    def subtree_of(self, shard_path: str) -> SubtreeKey:
        """Tier and place of the subtree whose shard has a path."""
        level, _, _, x, y, z, _ = shard_path.split("/")
        return int(level) // self.subtree, (int(x), int(y), int(z))

    def keys(self, level: int, place: Place, numbers: Iterable[int] | None = None) -> dict[int, Key]:
        """Keys of a cell's chunks by direction number (default all)."""
        directions = range(len(self.directions)) if numbers is None else numbers
        return {number: self.key((level, place, number)) for number in directions}

    @property
    def color_bytes(self) -> int:
        """Bytes of the colours at the beginning of a view."""
        return self.layers * self.size**2 * 3

    @property
    def view_bytes(self) -> int:
        """Bytes of an uncompressed view."""
        return sum(map(prod, self._shapes))

    @property
    def _shapes(self) -> tuple[tuple[int, ...], ...]:
        """Shapes of the colours, of the planes of depths, and of the normals."""
        layer = self.layers, self.size, self.size
        planes = -(-(self.depth_bits + CONNECTION_BITS) // 8)
        return (*layer, 3), (planes, *layer), (*layer, self.normal_bits // 8)

    def join(self, channels: Channels) -> NDArray[np.uint8]:
        """Bytes of a view."""
        _, (planes, *_), _ = self._shapes
        depths = [(channels.depth >> 8 * plane).astype(np.uint8) for plane in range(planes)]
        return np.concatenate([part.reshape(-1) for part in (channels.color, *depths, channels.normal)])

    def split(self, content: NDArray[np.uint8]) -> Channels:
        """Channels of a view, from its bytes."""
        ends = np.cumsum([prod(shape) for shape in self._shapes])[:-1]
        parts = (part.reshape(shape) for part, shape in zip(np.split(content, ends), self._shapes, strict=True))
        color, planes, normal = parts
        depth = np.zeros(planes.shape[1:], np.uint32)
        for number, plane in enumerate(planes):
            depth |= plane.astype(np.uint32) << 8 * number
        return Channels(color, depth, normal)

    @property
    def steps(self) -> int:
        """Number of steps of a depth range."""
        return _core.orthoview_steps(self.format)

    def create(self, path: Path, attributes: dict[str, Any]) -> None:
        """Create the store's group and its arrays, without chunks."""
        import zarr

        group = zarr.create_group(str(path), attributes=attributes)
        for level in range(self.grid.levels):
            side = self.shard_side(level)
            for number in range(len(self.directions)):
                _, _, array = self.key((level, (0, 0, 0), number))
                group.create_array(
                    array,
                    shape=(*self.grid.counts_at(level), self.view_bytes),
                    chunks=(1, 1, 1, self.view_bytes),
                    shards=(side, side, side, self.view_bytes),
                    dtype="u1",
                    fill_value=0,
                    **self._coding,
                    dimension_names=("x", "y", "z", "byte"),
                )

    @property
    def _coding(self) -> dict[str, Any]:
        """Codecs of chunks, as arguments of zarr."""
        from zarr.codecs import Crc32cCodec, ZstdCodec

        if self.color == "zstd":
            return {"compressors": [ZstdCodec(**COMPRESSION)]}
        from nearfar.orthoview._webp_codec import WebpViewCodec

        return {
            "serializer": WebpViewCodec(self.size, self.layers, self.quality),
            "compressors": [Crc32cCodec()],
        }

    def to_json(self) -> dict[str, Any]:
        return {
            "origin": list(self.grid.origin),
            "cell": self.grid.cell,
            "counts": list(self.grid.counts),
            "levels": self.grid.levels,
            "directions": [list(direction) for direction in self.directions],
            "names": list(self.names),
            **{field.name: getattr(self, field.name) for field in fields(self)[2:]},
        }

    @classmethod
    def from_json(cls, described: dict[str, Any]) -> Layout:
        """Return the layout that `to_json` encoded; KeyError, TypeError or ValueError for anything else."""
        x, y, z = (check.number("origin", value) for value in described["origin"])
        columns, layers, rows = (check.integer("counts", value, 1, MAX_CELLS) for value in described["counts"])
        grid = Grid((x, y, z), check.positive("cell", described["cell"]), (columns, layers, rows))
        directions = tuple((int(x), int(y), int(z)) for x, y, z in described["directions"])
        quality = described["quality"]
        layout = cls(
            grid,
            directions,
            check.integer("size", described["size"], 4, 4096),
            check.integer("depth_bits", described["depth_bits"], 8, 16),
            check.integer("normal_bits", described["normal_bits"], 16, 24),
            check.integer("subtree", described["subtree"], 1, 8),
            color=check.choice("color", described["color"], ("zstd", "webp")),
            quality=None if quality is None else check.integer("quality", quality, 0, 100),
            geometry=check.flag("geometry", described["geometry"]),
            layers=check.integer("layers", described["layers"], 1, 2),
        )
        for direction in directions:
            _core.orthoview_axes(direction)
        _core.orthoview_steps(layout.format)
        if described != layout.to_json():
            raise ValueError("the fields of its layout contradict each other")
        return layout
