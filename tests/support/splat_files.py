"""Files of Gaussians, read by their specifications: number by number, without the code that writes them."""

from __future__ import annotations

import gzip
import json
import math
import struct
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

HARMONIC = 0.5 * math.sqrt(1 / math.pi)
SPLATS = "KHR_gaussian_splatting"
PACKED = "KHR_gaussian_splatting_compression_spz_2"


@dataclass
class Rows:
    """Gaussians: centres, unit quaternions x, y, z, w, standard deviations, opacities and colours in 0..1."""

    middle: Array
    rotation: Array
    scale: Array
    opacity: Array
    color: Array

    def covariances(self) -> Array:
        """Covariance matrices (N, 3, 3)."""
        axes = np.array([turn(q) for q in self.rotation]) * self.scale[:, None, :]
        return axes @ axes.transpose(0, 2, 1)


def turn(quaternion: Array) -> Array:
    """The rotation matrix of a unit quaternion, as printed in the glTF extension."""
    x, y, z, w = quaternion
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def spz_rows(data: bytes, version: int) -> Rows:
    """The Gaussians of an SPZ file; it must have the version."""
    content = gzip.decompress(data)
    magic, own, count, degree, bits, flags, reserved = struct.unpack("<IIIBBBB", content[:16])
    assert (magic, own, degree, flags, reserved) == (0x5053474E, version, 0, 0, 0)
    at = 16

    def take(size: int) -> list[bytes]:
        nonlocal at
        rows = [content[at + size * n : at + size * (n + 1)] for n in range(count)]
        at += size * count
        return rows

    positions, alphas, colors, scales = take(9), take(1), take(3), take(3)
    rotations = take(3 if version == 2 else 4)
    assert at == len(content)
    read = _three_bytes if version == 2 else _packed_word
    return Rows(
        np.array(
            [[int.from_bytes(p[n : n + 3], "little", signed=True) / 2**bits for n in (0, 3, 6)] for p in positions]
        ),
        np.array([read(q) for q in rotations]),
        np.array([[math.exp(s / 16 - 10) for s in scale] for scale in scales]),
        np.array([alpha[0] / 255 for alpha in alphas]),
        np.array([[0.5 + HARMONIC * (c / 255 - 0.5) / 0.15 for c in color] for color in colors]),
    )


def _three_bytes(code: bytes) -> list[float]:
    x, y, z = (byte / 127.5 - 1 for byte in code)
    return [x, y, z, math.sqrt(max(0.0, 1 - x * x - y * y - z * z))]


def _packed_word(code: bytes) -> list[float]:
    """Two bits name the greatest component; of the others, the last one lowest, nine bits and a sign each."""
    word = int.from_bytes(code, "little")
    greatest, rotation = word >> 30, [0.0] * 4
    for component in (3, 2, 1, 0):
        if component != greatest:
            size = (word & 511) / 511 / math.sqrt(2)
            rotation[component] = -size if word >> 9 & 1 else size
            word >>= 10
    rotation[greatest] = math.sqrt(1 - sum(part * part for part in rotation))
    return rotation


def glb_parts(data: bytes) -> tuple[dict[str, Any], bytes]:
    """The document and the binary chunk of a GLB."""
    magic, version, size, length, kind = struct.unpack("<4sIII4s", data[:20])
    assert (magic, version, size, kind) == (b"glTF", 2, len(data), b"JSON")
    end = 20 + length
    binary, kind = struct.unpack("<I4s", data[end : end + 8])
    assert kind == b"BIN\0"
    assert end + 8 + binary == size
    return json.loads(data[20:end]), data[end + 8 :]


def glb_rows(data: bytes) -> Rows:
    """The Gaussians of a GLB, world metres."""
    document, binary = glb_parts(data)
    ((node,), ((primitive,),)) = document["nodes"], [mesh["primitives"] for mesh in document["meshes"]]
    assert primitive["mode"] == 0
    assert SPLATS in document["extensionsUsed"]
    own = primitive["extensions"][SPLATS]
    assert (own["kernel"], own["colorSpace"]) == ("ellipse", "srgb_rec709_display")
    shift = np.array(node["matrix"]).reshape(4, 4)[3, :3]
    if "extensions" in own:
        view = document["bufferViews"][own["extensions"][PACKED]["bufferView"]]
        rows = spz_rows(binary[: view["byteLength"]], 2)
    else:
        values = {name: _values(document, binary, number) for name, number in primitive["attributes"].items()}
        rows = Rows(
            values["POSITION"],
            values[f"{SPLATS}:ROTATION"],
            values[f"{SPLATS}:SCALE"],
            values[f"{SPLATS}:OPACITY"][:, 0],
            0.5 + HARMONIC * values[f"{SPLATS}:SH_DEGREE_0_COEF_0"],
        )
    described = document["accessors"][primitive["attributes"]["POSITION"]]
    assert described["count"] == len(rows.middle)
    assert np.allclose(
        [described["min"], described["max"]], [rows.middle.min(axis=0), rows.middle.max(axis=0)], atol=0.1
    )
    rows.middle = rows.middle + shift
    return rows


def _values(document: dict[str, Any], binary: bytes, number: int) -> Array:
    accessor = document["accessors"][number]
    view = document["bufferViews"][accessor["bufferView"]]
    assert view["byteOffset"] % 4 == 0
    kind = {5126: "<f4", 5122: "<i2", 5121: "u1"}[accessor["componentType"]]
    width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[accessor["type"]]
    part = binary[view["byteOffset"] : view["byteOffset"] + view["byteLength"]]
    values = np.frombuffer(part, kind).reshape(-1, width).astype(np.float64)
    assert len(values) == accessor["count"]
    return values / {"<i2": 32767.0, "u1": 255.0}[kind] if accessor.get("normalized") else values


@dataclass
class Tile:
    """A tile that has a GLB."""

    path: Path
    box: Array
    """World box (2, 3), y up."""
    error: float
    above: list[Tile]
    """Tiles that it replaces, the nearest one last."""
    is_leaf: bool


def tiles(folder: Path) -> Iterator[Tile]:
    """All tiles with a GLB of a tileset, each after its ancestors."""
    document = json.loads((folder / "tileset.json").read_text())
    assert document["asset"]["version"] == "1.1"
    assert document["geometricError"] > 0
    yield from _below(folder, document["root"], [])


def _below(folder: Path, node: dict[str, Any], above: list[Tile]) -> Iterator[Tile]:
    assert node["refine"] == "REPLACE"
    content, children = node.get("content"), node.get("children", [])
    if content and content["uri"].endswith(".json"):
        path = folder / content["uri"]
        document = json.loads(path.read_text())
        assert not children
        assert document["root"]["boundingVolume"] == node["boundingVolume"]
        assert document["root"]["geometricError"] == node["geometricError"]
        yield from _below(path.parent, document["root"], above)
        return
    box = box_of(node["boundingVolume"]["box"])
    if content:
        path = (folder / content["uri"]).resolve()
        own = Tile(path, box_of(content["boundingVolume"]["box"]), node["geometricError"], above, not children)
        assert (box[0] <= own.box[0] + 1e-9).all()
        assert (own.box[1] <= box[1] + 1e-9).all()
        yield own
        above = [*above, own]
    for child in children:
        inner = box_of(child["boundingVolume"]["box"])
        assert (box[0] <= inner[0] + 1e-6).all()
        assert (inner[1] <= box[1] + 1e-6).all()
        assert child["geometricError"] < node["geometricError"]
        yield from _below(folder, child, above)


def box_of(numbers: list[float]) -> Array:
    """A box of a tileset, z up, converted to the world, y up."""
    middle, axes = np.array(numbers[:3]), np.array(numbers[3:]).reshape(3, 3)
    half = np.abs(axes).sum(axis=0)
    low, high = middle - half, middle + half
    return np.array([[low[0], low[2], -high[1]], [high[0], high[2], -low[1]]])
