"""A slow reader of glTF, number by number: triangles of each node in the world, without code of the package."""

from __future__ import annotations

import base64
import json
import struct
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import numpy as np

FORMATS = {5120: "b", 5121: "B", 5122: "h", 5123: "H", 5125: "I", 5126: "f"}
FULL = {5120: 127, 5121: 255, 5122: 32767, 5123: 65535}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
Row = tuple[float, ...]


class Document:
    """A file without compressed arrays."""

    def __init__(self, path: Path) -> None:
        data, self._folder, self._binary = path.read_bytes(), path.parent, b""
        if path.suffix == ".glb":
            length = int.from_bytes(data[12:16], "little")
            self._binary = data[28 + length :]
            data = data[20 : 20 + length]
        self.json: dict[str, Any] = json.loads(data)

    def buffer(self, number: int) -> bytes:
        uri = self.json["buffers"][number].get("uri")
        if uri is None:
            return self._binary
        return self._file(uri)

    def image(self, number: int) -> bytes:
        described = self.json["images"][number]
        if "uri" in described:
            return self._file(described["uri"])
        view = self.json["bufferViews"][described["bufferView"]]
        start = view.get("byteOffset", 0)
        return self.buffer(view["buffer"])[start : start + view["byteLength"]]

    def _file(self, uri: str) -> bytes:
        if uri.startswith("data:"):
            return base64.b64decode(uri.partition(",")[2])
        return (self._folder / unquote(uri)).read_bytes()

    def numbers(self, view: int, start: int, kind: int, count: int, width: int) -> list[Row]:
        described = self.json["bufferViews"][view]
        size = struct.calcsize(FORMATS[kind])
        data = self.buffer(described["buffer"])
        first, step = described.get("byteOffset", 0) + start, described.get("byteStride", size * width)
        return [struct.unpack_from(f"<{width}{FORMATS[kind]}", data, first + row * step) for row in range(count)]

    def accessor(self, number: int) -> list[Row]:
        item = self.json["accessors"][number]
        kind, count, width = item["componentType"], item["count"], WIDTHS[item["type"]]
        rows: list[Row] = [(0.0,) * width] * count
        if "bufferView" in item:
            rows = self.numbers(item["bufferView"], item.get("byteOffset", 0), kind, count, width)
        if "sparse" in item:
            places, values, changed = (item["sparse"][key] for key in ("indices", "values", "count"))
            at = self.numbers(places["bufferView"], places.get("byteOffset", 0), places["componentType"], changed, 1)
            new = self.numbers(values["bufferView"], values.get("byteOffset", 0), kind, changed, width)
            for (place,), row in zip(at, new, strict=True):
                rows[int(place)] = row
        if item.get("normalized"):
            return [tuple(max(value / FULL[kind], -1.0) for value in row) for row in rows]
        return rows

    def corners(self, primitive: dict[str, Any]) -> list[tuple[int, int, int]]:
        """Vertex numbers of each triangle; none of points and lines."""
        count = self.json["accessors"][primitive["attributes"]["POSITION"]]["count"]
        order = [int(row[0]) for row in self.accessor(primitive["indices"])] if "indices" in primitive else None
        order = list(range(count)) if order is None else order
        mode = primitive.get("mode", 4)
        if mode == 4:
            return [(order[i], order[i + 1], order[i + 2]) for i in range(0, len(order), 3)]
        if mode == 5:
            steps = ((order[i], order[i + 1 + i % 2], order[i + 2 - i % 2]) for i in range(len(order) - 2))
        elif mode == 6:
            steps = ((order[i + 1], order[i + 2], order[0]) for i in range(len(order) - 2))
        else:
            return []
        return [face for face in steps if len(set(face)) == 3]

    def nodes(self) -> list[tuple[int, Any]]:
        """Numbers and transforms node→world (4, 4) of all nodes of the scene."""
        found: list[tuple[int, Any]] = []

        def visit(number: int, above: Any) -> None:
            world = above @ local(self.json["nodes"][number])
            found.append((number, world))
            for child in self.json["nodes"][number].get("children", []):
                visit(child, world)

        for root in self.json["scenes"][self.json.get("scene", 0)]["nodes"]:
            visit(root, np.eye(4))
        return found

    def triangles(self) -> list[Any]:
        """Corners (3, 3) of all triangles, placed by all nodes and instances."""
        found = []
        for number, world in self.nodes():
            node = self.json["nodes"][number]
            if "mesh" not in node:
                continue
            for matrix in self.instances(node):
                for primitive in self.json["meshes"][node["mesh"]]["primitives"]:
                    rows = self.accessor(primitive["attributes"]["POSITION"])
                    for face in self.corners(primitive):
                        found.append([(world @ matrix @ [*rows[corner], 1.0])[:3] for corner in face])
        return found

    def instances(self, node: dict[str, Any]) -> list[Any]:
        attributes = node.get("extensions", {}).get("EXT_mesh_gpu_instancing", {}).get("attributes")
        if attributes is None:
            return [np.eye(4)]
        names = {"TRANSLATION": "translation", "ROTATION": "rotation", "SCALE": "scale"}
        rows = {names[name]: self.accessor(number) for name, number in attributes.items() if name in names}
        count = len(next(iter(rows.values())))
        return [local({name: values[row] for name, values in rows.items()}) for row in range(count)]


def local(node: dict[str, Any]) -> Any:
    """The transform (4, 4) that a node states."""
    if "matrix" in node:
        return np.array(node["matrix"], float).reshape(4, 4).T
    x, y, z, w = node.get("rotation", (0.0, 0.0, 0.0, 1.0))
    matrix = np.eye(4)
    for axis, scale in enumerate(node.get("scale", (1.0, 1.0, 1.0))):
        # q v q*, by v + 2 r × (r × v + w v) with the vector part r.
        unit, part = np.eye(3)[axis], np.array([x, y, z])
        matrix[:3, axis] = scale * (unit + 2 * np.cross(part, np.cross(part, unit) + w * unit))
    matrix[:3, 3] = node.get("translation", (0.0, 0.0, 0.0))
    return matrix
