"""Writers of 3D Tiles for tests: glTF, b3dm, i3dm, cmpt, subtrees and tilesets, and what their files may refer to."""

from __future__ import annotations

import json
import struct
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from tests.support.gltf_cases import encode

Y_UP_TO_Z_UP = np.array([[1.0, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]])


def glb(vertices: Any = None, faces: Any = None, **changes: Any) -> bytes:
    """A GLB of one mesh, by default a unit cube about (0, 0, 0); `changes` replace entries of its document."""
    if vertices is None:
        box = trimesh.creation.box((1, 1, 1))
        vertices, faces = box.vertices, box.faces
    corners = np.ascontiguousarray(vertices, np.float32)
    rows = np.ascontiguousarray(faces, np.uint32)
    low, high = corners.min(axis=0).tolist(), corners.max(axis=0).tolist()
    document: dict[str, Any] = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": len(corners), "type": "VEC3", "min": low, "max": high},
            {"bufferView": 1, "componentType": 5125, "count": rows.size, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": corners.nbytes},
            {"buffer": 0, "byteOffset": corners.nbytes, "byteLength": rows.nbytes},
        ],
        "buffers": [{"byteLength": corners.nbytes + rows.nbytes}],
    }
    return encode(document | changes, corners.tobytes() + rows.tobytes())


def _text(document: Any, start: int) -> bytes:
    """JSON that ends at a multiple of eight bytes from `start`; empty for None."""
    data = b"" if document is None else json.dumps(document).encode()
    return data + b" " * (-(start + len(data)) % 8) if data else data


def b3dm(model: bytes, features: Any = None, binary: bytes = b"", batch: Any = None) -> bytes:
    """A batched tile: header, feature table, batch table, model."""
    table = _text({"BATCH_LENGTH": 0} if features is None else features, 28)
    properties = _text(batch, 0)
    size = 28 + len(table) + len(binary) + len(properties) + len(model)
    header = struct.pack("<4s6I", b"b3dm", 1, size, len(table), len(binary), len(properties), 0)
    return header + table + binary + properties + model


def i3dm(model: bytes, features: dict[str, Any], binary: bytes = b"", *, embedded: bool = True) -> bytes:
    """An instanced tile; without `embedded` the model is a reference to a file."""
    table = _text(features, 32)
    size = 32 + len(table) + len(binary) + len(model)
    header = struct.pack("<4s7I", b"i3dm", 1, size, len(table), len(binary), 0, 0, int(embedded))
    return header + table + binary + model


def instanced(model: bytes, count: int, *, embedded: bool = True, **rows: Any) -> bytes:
    """An instanced tile with arrays in its binary part by their names, and other values in its feature table."""
    features: dict[str, Any] = {"INSTANCES_LENGTH": count}
    binary = b""
    for name, value in rows.items():
        if isinstance(value, np.ndarray):
            features[name] = {"byteOffset": len(binary)}
            binary += value.tobytes() + bytes(-value.nbytes % 8)
        else:
            features[name] = value
    return i3dm(model, features, binary, embedded=embedded)


def cmpt(*tiles: bytes) -> bytes:
    """A composite tile."""
    return struct.pack("<4s3I", b"cmpt", 1, 16 + sum(map(len, tiles)), len(tiles)) + b"".join(tiles)


def bits(values: Sequence[bool] | NDArray[np.bool_]) -> bytes:
    """A bitstream, filled up to eight bytes."""
    data = np.packbits(np.asarray(values, bool), bitorder="little").tobytes()
    return data + bytes(-len(data) % 8)


def subtree(tiles: Any, contents: Any, children: Any, *, binary: bool = True) -> tuple[bytes, bytes]:
    """A subtree of availabilities, each True, False or flags, and its second file, which the JSON form has."""
    data = b""
    views: list[dict[str, int]] = []

    def availability(flags: Any) -> dict[str, Any]:
        nonlocal data
        if isinstance(flags, bool):
            return {"constant": int(flags)}
        stream = bits(flags)
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": (len(flags) + 7) // 8})
        data += stream
        return {"bitstream": len(views) - 1, "availableCount": int(np.sum(flags))}

    document: dict[str, Any] = {
        "tileAvailability": availability(tiles),
        "contentAvailability": [availability(contents)],
        "childSubtreeAvailability": availability(children),
        "bufferViews": views,
        "buffers": [{"byteLength": len(data)} | ({} if binary else {"uri": "bits.bin"})],
    }
    if not binary:
        return json.dumps(document).encode(), data
    text = _text(document, 24)
    return struct.pack("<4sIQQ", b"subt", 1, len(text), len(data)) + text + data, b""


def box(low: Any, high: Any) -> dict[str, list[float]]:
    """A bounding volume between corners, z up."""
    low, high = np.asarray(low, float), np.asarray(high, float)
    return {"box": [*((low + high) / 2).tolist(), *np.diag((high - low) / 2).ravel().tolist()]}


def tile(error: float, content: str | None = None, volume: Any = None, **more: Any) -> dict[str, Any]:
    """A tile, by default with a volume that holds everything near (0, 0, 0)."""
    described: dict[str, Any] = {
        "boundingVolume": box((-100, -100, -100), (100, 100, 100)) if volume is None else volume,
        "geometricError": error,
    }
    if content is not None:
        described["content"] = {"uri": content}
    return described | more


def tileset(root: dict[str, Any], version: str = "1.1", **more: Any) -> bytes:
    """A tileset's document."""
    return json.dumps({"asset": {"version": version}, "geometricError": 1000, "root": root} | more).encode()


def write(folder: Path, files: dict[str, bytes]) -> Path:
    """Write files; returns the path of the first one."""
    for name, data in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)
    return folder / next(iter(files))


def levels(depth: int, name: Callable[[int, str], str], error: float = 64.0, key: str = "") -> dict[str, Any]:
    """A quadtree of replacing tiles whose errors halve from level to level."""
    below = [levels(depth - 1, name, error / 2, f"{key}{n}") for n in range(4)] if depth else []
    return tile(
        error if depth else 0.0, name(len(key), key), refine="REPLACE", **({"children": below} if below else {})
    )


QUAD: dict[str, Any] = {
    "subdivisionScheme": "QUADTREE",
    "subtreeLevels": 2,
    "availableLevels": 4,
    "subtrees": {"uri": "s.subtree"},
}
"""An implicit tiling of four levels."""

LONGEST = 2.0
"""CPU seconds allowed for any bad file."""


def refusal(path: Path) -> str:
    """The reason why a file is refused."""
    start = time.process_time()
    with pytest.raises(nf.SceneError) as caught:
        nf.Scene.load(path)
    assert time.process_time() - start < LONGEST
    sentence = str(caught.value)
    assert sentence.startswith(f"{path}: ")
    assert "\n" not in sentence
    assert len(sentence) < len(str(path)) + 700
    return sentence.removeprefix(f"{path}: ")
