"""Writes GLBs with arrays of any layout, including random ones."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.support.gltf_cases import COMPONENTS, encode

KINDS = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}


class Writer:
    """Collects arrays of random layouts in the buffer of a GLB."""

    def __init__(self, rng: np.random.Generator) -> None:
        self.rng, self.data = rng, b""
        self.accessors: list[dict[str, Any]] = []
        self.views: list[dict[str, Any]] = []

    def rows(self, kind: type, count: int, width: int, *, tight: bool = False) -> int:
        """Random rows with a gap after each, unless `tight`; returns the accessor's number."""
        is_float = kind is np.float32
        info = None if is_float else np.iinfo(kind)
        values = (
            self.rng.integers(-40, 40, (count, width)).astype(kind) / kind(8)
            if info is None
            else self.rng.integers(info.min, info.max, (count, width), kind, endpoint=True)
        )
        normalized = not is_float and (width != 3 or bool(self.rng.integers(2)))
        return self.add(np.asarray(values, kind), normalized=normalized, tight=tight)

    def add(self, values: NDArray[Any], *, normalized: bool = False, tight: bool = True) -> int:
        size = values.itemsize * values.shape[1]
        gap = 0 if tight else int(self.rng.integers(3)) * 4 + -size % 4
        self.data += bytes(-len(self.data) % 4)
        view: dict[str, Any] = {"buffer": 0, "byteOffset": len(self.data)}
        self.data += b"".join(row.tobytes() + bytes(gap) for row in values)
        view["byteLength"] = len(self.data) - view["byteOffset"]
        if gap:
            view["byteStride"] = size + gap
        self.views.append(view)
        accessor = {"bufferView": len(self.views) - 1, "componentType": COMPONENTS[values.dtype.str[1:]]}
        self.accessors.append(
            accessor | {"count": len(values), "type": KINDS[values.shape[1]], "normalized": normalized}
        )
        return len(self.accessors) - 1

    def glb(self, **document: Any) -> bytes:
        whole = {"asset": {"version": "2.0"}, "accessors": self.accessors, "bufferViews": self.views, **document}
        return encode(whole | {"buffers": [{"byteLength": len(self.data)}]}, self.data)


def glb_of(arrays: Iterable[NDArray[Any]], normalized: str = "iu", **document: Any) -> bytes:
    """A GLB whose accessors are arrays (N, K) with gaps between rows; `normalized` are the normalised kinds."""
    writer = Writer(np.random.default_rng(0))
    for rows in arrays:
        writer.add(rows, normalized=rows.dtype.kind in normalized, tight=False)
    return writer.glb(**{"scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}]} | document)


def random_glb(rng: np.random.Generator) -> bytes:
    """Meshes of primitives that share vertices, placed several times each, of random types and attributes."""
    writer = Writer(rng)
    pools = [_attributes(writer, 3 * int(rng.integers(1, 5))) for _ in range(2)]
    meshes = []
    for _ in range(int(rng.integers(1, 4))):
        chosen = [pools[int(rng.integers(2))] for _ in range(int(rng.integers(1, 4)))]
        meshes.append({"primitives": [_primitive(writer, *pool) for pool in chosen]})
    nodes: list[dict[str, Any]] = []
    for number in range(int(rng.integers(1, 6))):
        scale = rng.choice([-2.0, 1.0, 1.0, 0.5], 3).tolist()
        place = {"translation": rng.integers(-9, 9, 3).tolist(), "scale": scale} if rng.integers(3) else {}
        nodes.append({"name": f"n{number}", "mesh": int(rng.integers(len(meshes))), **place})
    materials = [{"pbrMetallicRoughness": {"baseColorFactor": [n / 4, 0.5, 1.0, 1.0]}} for n in range(3)]
    return writer.glb(meshes=meshes, nodes=nodes, materials=materials, scenes=[{"nodes": list(range(len(nodes)))}])


def _attributes(writer: Writer, count: int) -> tuple[dict[str, int], int]:
    rng = writer.rng
    kinds = (np.float32, np.float32, np.int16, np.uint8)
    found = {"POSITION": writer.rows(kinds[int(rng.integers(4))], count, 3)}
    if rng.integers(2):
        found["NORMAL"] = writer.rows((np.float32, np.int8)[int(rng.integers(2))], count, 3)
    if rng.integers(2):
        kind = (np.uint8, np.uint16, np.float32)[int(rng.integers(3))]
        found["COLOR_0"] = writer.rows(kind, count, int(rng.integers(3, 5)))
    return found, count


def _primitive(writer: Writer, found: dict[str, int], count: int) -> dict[str, Any]:
    rng = writer.rng
    made: dict[str, Any] = {"attributes": found, "mode": 4} if rng.integers(2) else {"attributes": dict(found)}
    if rng.integers(4):
        first = int(rng.integers(count))
        corners = rng.integers(first, count, (3 * int(rng.integers(1, 4)), 1))
        made["indices"] = writer.add(corners.astype((np.uint8, np.uint16, np.uint32)[int(rng.integers(3))]))
    if rng.integers(3):
        made["material"] = int(rng.integers(3))
    return made
