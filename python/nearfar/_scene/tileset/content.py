"""Decodes tiles (b3dm, i3dm, cmpt and glTF) to shapes placed in the tile's frame."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from nearfar._base import check, glb
from nearfar._base.errors import UnusableError
from nearfar._scene.budget import Budget
from nearfar._scene.content import Content, Nodes, Shape, translation
from nearfar._scene.entries import TILE_FARTHEST, coordinates
from nearfar._scene.frames import TO_Z_UP, Floats
from nearfar._scene.gltf.document import read as read_gltf
from nearfar._scene.gltf.nodes import INSTANCE_BYTES
from nearfar._scene.materials import Materials
from nearfar._scene.tileset import tables
from nearfar._scene.tileset.files import Files

_OTHERS = {b"pnts": "points", b"vctr": "vectors", b"geom": "geometries"}
"""Kinds of tiles without triangles."""

_RTC = "CESIUM_RTC"
"""glTF extension that states where the glTF's origin is in the tile's frame."""

_MAX_NESTED = 32
"""Maximum nesting depth of composite tiles."""


@dataclass
class TileContent:
    """Content of one file of a tile."""

    content: Content
    """Shapes, placed in the tile's frame, z up."""
    has_properties: bool = False
    depends_on_place: bool = False
    """Whether its orientation depends on the tile's place on the Earth."""

    @property
    def triangles(self) -> int:
        """Number of triangles of all placed shapes."""
        sizes = {name: len(shape.faces) for name, shape in self.content.shapes.items()}
        return sum(sizes[name] * number for name, number in Counter(self.content.nodes.shapes).items())

    @property
    def nbytes(self) -> int:
        """Bytes of all arrays."""
        shapes = self.content.shapes.values()
        arrays = [a for s in shapes for a in (s.vertices, s.faces, s.uvs, s.colors, s.normals) if a is not None]
        return int(sum(array.nbytes for array in arrays) + self.content.nodes.transforms.nbytes)


@dataclass(frozen=True)
class Reader:
    """Reads files of tiles; `budget` counts unpacked bytes."""

    files: Files
    budget: Budget
    materials: Materials

    def read(self, name: str, data: bytes, up: str, to_earth: Floats, depth: int = 0) -> TileContent:
        """Decode the bytes of a file, whose `name` is a path or URL; may raise any exception if they are unusable.

        `up` is the up axis of its glTF: X, Y or Z. `to_earth` (4, 4) is the transform from the tile to the tileset,
        `depth` the number of composite tiles around it.
        """
        data = self.budget.unpacked_if_gzip(data)
        match bytes(data[:4]):
            case b"":
                raise UnusableError("it is empty")
            case b"b3dm":
                return self._batched(name, data, up)
            case b"i3dm":
                return self._instanced(name, data, up, to_earth)
            case b"cmpt":
                return self._composite(name, data, up, to_earth, depth)
            case magic if magic in _OTHERS:
                tables.first_tile(data)
                return TileContent(Content(name, {}, Nodes.from_rows([]), [f"tile of {_OTHERS[magic]} ignored"]))
            case magic if magic == b"glTF" or data.lstrip().startswith(b"{"):
                return TileContent(self._gltf(name, data, up))
            case magic:
                raise UnusableError(f"it begins with {check.shortened(magic)}, and is no b3dm, i3dm, cmpt or glTF")

    def _batched(self, name: str, data: bytes, up: str) -> TileContent:
        parts = tables.split(data, has_format=False)
        if "BATCH_LENGTH" in parts.features:
            parts.features.count("BATCH_LENGTH")
        content = self._gltf(name, parts.body, up)
        if "RTC_CENTER" in parts.features:
            content.nodes.transforms[:, :3, 3] += parts.features.vector("RTC_CENTER")
        return TileContent(content, parts.has_properties)

    def _instanced(self, name: str, data: bytes, up: str, to_earth: Floats) -> TileContent:
        parts = tables.split(data, has_format=True)
        placed = tables.instance_transforms(parts.features, to_earth)
        if parts.format == 0:
            model_name = self.files.resolve(name, parts.body.rstrip(b" \0").decode())
            model = self._gltf(model_name, self.files.read(model_name, self.budget), up)
        elif parts.format == 1:
            model = self._gltf(name, parts.body, up)
        else:
            raise UnusableError(f"it states the format {parts.format} of its model, and 0 and 1 are known")
        nodes = model.nodes
        self.budget.count_arrays(len(placed) * len(nodes.objects) * INSTANCE_BYTES)
        transforms = (placed[:, None] @ nodes.transforms[None]).reshape(-1, 4, 4)
        is_single = len(nodes.objects) == 1
        objects = [str(n) if is_single else f"{n}/{node}" for n in range(len(placed)) for node in nodes.objects]
        content = replace(model, label=name, nodes=Nodes(objects, transforms, nodes.shapes * len(placed)))
        return TileContent(content, parts.has_properties, tables.rotations_depend_on_location(parts.features))

    def _composite(self, name: str, data: bytes, up: str, to_earth: Floats, depth: int) -> TileContent:
        if depth >= _MAX_NESTED:
            raise UnusableError("its parts are nested too deeply")
        inner = [self.read(name, part, up, to_earth, depth + 1) for part in _tiles(tables.first_tile(data))]
        content = join_contents(name, [(str(n), f"{n}/", part.content) for n, part in enumerate(inner)])
        return TileContent(
            content, any(part.has_properties for part in inner), any(part.depends_on_place for part in inner)
        )

    def _gltf(self, name: str, data: bytes, up: str) -> Content:
        kind = "glb" if data.startswith(b"glTF") else "gltf"
        if kind == "glb" and data[4:8] == b"\1\0\0\0":
            raise UnusableError("it holds glTF 1.0, and only glTF 2 is read; 3d-tiles-tools (upgrade) converts it")
        resolver = _Resolver(self.files, name, self.budget)
        # Without stored meshes, because tiles are counted, rotated and joined by their shapes.
        content = read_gltf(name, data, kind, resolver, self.materials, self.budget, stores=False)
        _check_vertices(content)
        turn = translation(_center(data, kind)) @ TO_Z_UP[up]
        content.nodes = replace(content.nodes, transforms=turn @ content.nodes.transforms)
        content.notes = [other for other in content.notes if other != f"extension {_RTC} ignored"]
        return content


class _Resolver:
    """Trimesh resolver for the files that a tile's glTF refers to."""

    def __init__(self, files: Files, name: str, budget: Budget) -> None:
        self._files, self._name, self._budget = files, name, budget
        self.parent = os.path.dirname(name)
        self._content: dict[str, bytes] = {}

    def get(self, uri: str) -> bytes:
        """Bytes of a file, by its URI relative to the tile."""
        if uri not in self._content:
            self._content[uri] = self._files.read(self._files.resolve(self._name, uri), self._budget)
        return self._content[uri]


def _tiles(data: bytes) -> Iterator[bytes]:
    """Split a composite tile into its tiles."""
    if len(data) < 16:
        raise UnusableError("it ends within its header of 16 bytes")
    count, start = int.from_bytes(data[12:16], "little"), 16
    for index in range(count):
        if start >= len(data):
            raise UnusableError(f"it states {count:,} tiles, and ends after {index:,}")
        part = tables.first_tile(data[start:])
        yield part
        start += len(part)


def _center(data: bytes, kind: str) -> Floats:
    """Position (3,) of a glTF file's origin from the extension; 0 without it."""
    if _RTC.encode() in data:
        document = glb.header(data)[0] if kind == "glb" else glb.json_object(data)
        extension = document.get("extensions", {}).get(_RTC)
        if extension is not None:
            return coordinates(extension.get("center"), 3, f"extensions.{_RTC}.center")
    return np.zeros(3)


def _check_vertices(content: Content) -> None:
    """Reject finite coordinates beyond any place on the Earth; others are handled later, as for all files."""
    for name, shape in content.shapes.items():
        if shape.vertices.size:
            reach = max(float(shape.vertices.max()), -float(shape.vertices.min()))
            if TILE_FARTHEST < reach < np.inf:
                raise UnusableError(f"mesh {check.shortened(name)} has coordinates beyond 1e10")


def join_contents(label: str, parts: Sequence[tuple[str, str, Content]]) -> Content:
    """Join contents; each part comes with a prefix for object names and a prefix for shape names.

    Parts with the same shape prefix have the same content and share its shapes.
    """
    shapes: dict[str, Shape] = {}
    objects: list[str] = []
    shape_names: list[str] = []
    note_counts = Counter[str]()
    for object_prefix, shape_prefix, content in parts:
        for name, shape in content.shapes.items():
            shapes.setdefault(f"{shape_prefix}{name}", replace(shape))
        names = content.nodes.objects
        objects += [object_prefix if len(names) == 1 else f"{object_prefix}/{name}" for name in names]
        shape_names += [f"{shape_prefix}{name}" for name in content.nodes.shapes]
        note_counts.update(content.notes)
    transforms = np.concatenate([np.zeros((0, 4, 4)), *(content.nodes.transforms for *_, content in parts)])
    notes = [note if number == 1 else f"{note} ({number:,} times)" for note, number in note_counts.items()]
    return Content(label, shapes, Nodes(objects, transforms, shape_names), notes)
