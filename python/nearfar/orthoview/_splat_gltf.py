"""Encodes Gaussians as GLB files: the glTF extension KHR_gaussian_splatting, plain or with an SPZ file inside."""

from __future__ import annotations

import json
import struct
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base.errors import UnusableError
from nearfar._base.version import __version__
from nearfar._scene.srgb import to_linear
from nearfar.orthoview import _spz
from nearfar.orthoview._gaussians import Gaussians

SPLATS = "KHR_gaussian_splatting"
PACKED = "KHR_gaussian_splatting_compression_spz_2"
"""Draft extension; its SPZ file has version 2."""

ATTRIBUTES: dict[str, tuple[int, str, int, bool]] = {
    "POSITION": (5126, "VEC3", 12, False),
    f"{SPLATS}:ROTATION": (5122, "VEC4", 8, True),
    f"{SPLATS}:SCALE": (5126, "VEC3", 12, False),
    f"{SPLATS}:OPACITY": (5126, "SCALAR", 4, False),
    f"{SPLATS}:SH_DEGREE_0_COEF_0": (5126, "VEC3", 12, False),
    "COLOR_0": (5121, "VEC4", 4, True),
}
"""Attributes: component type, element type, bytes, and whether integers are normalised to 0..1 or −1..1."""

_PLACEHOLDERS: dict[str, tuple[int, str, bool]] = {
    "POSITION": (5126, "VEC3", False),
    "COLOR_0": (5121, "VEC4", True),
    f"{SPLATS}:SCALE": (5126, "VEC3", False),
    f"{SPLATS}:ROTATION": (5126, "VEC4", False),
}
"""Accessors without data, which readers fill from the SPZ file: component type, element type, normalisation."""

MAX_BYTES = (1 << 32) - 1
"""Greatest size of a GLB."""

_SH_DEGREE_0 = 0.282_094_791_773_878_1
_CODES = np.arange(256) / 255.0
_COEFFICIENTS = ((_CODES - 0.5) / _SH_DEGREE_0).astype("<f4")
_LINEAR = np.rint(to_linear(_CODES) * 255.0).astype(np.uint8)

Extent = NDArray[np.float64]
"""Least and greatest coordinates (2, 3) of the centres."""


def encode_attributes(gaussians: Gaussians) -> dict[str, bytes]:
    """Encode the attributes of some Gaussians."""
    alpha = np.full((len(gaussians), 1), 255, np.uint8)
    values = {
        "POSITION": gaussians.middle.astype("<f4"),
        f"{SPLATS}:ROTATION": np.rint(gaussians.rotation * 32767.0).astype("<i2"),
        f"{SPLATS}:SCALE": gaussians.scale.astype("<f4"),
        f"{SPLATS}:OPACITY": np.ones(len(gaussians), "<f4"),
        f"{SPLATS}:SH_DEGREE_0_COEF_0": _COEFFICIENTS[gaussians.color],
        "COLOR_0": np.concatenate([_LINEAR[gaussians.color], alpha], axis=1),
    }
    return {name: np.ascontiguousarray(values[name]).tobytes() for name in ATTRIBUTES}


def plain_start(count: int, extent: Extent, center: NDArray[np.float64], extras: Mapping[str, Any]) -> bytes:
    """Return the start of a GLB, up to the attributes of `encode_attributes`, which must follow one after the other.

    `center` is the world position (3,) that the Gaussians are relative to, metres.
    """
    views, accessors, offset = [], [], 0
    for number, (component, kind, width, is_normalized) in enumerate(ATTRIBUTES.values()):
        views.append({"buffer": 0, "byteOffset": offset, "byteLength": width * count, "target": 34962})
        accessors.append({"bufferView": number, **_accessor(component, kind, is_normalized, count)})
        offset += width * count
    accessors[0] |= _corners(extent)
    body = {"accessors": accessors, "bufferViews": views, "buffers": [{"byteLength": offset}]}
    return _start(_document({}, list(ATTRIBUTES), center, extras) | body, offset)


def encode_plain(gaussians: Gaussians, center: NDArray[np.float64], extras: Mapping[str, Any]) -> bytes:
    """Encode Gaussians as a GLB with plain attributes."""
    start = plain_start(len(gaussians), extent_of(gaussians), center, extras)
    return b"".join([start, *encode_attributes(gaussians).values()])


def packed_start(
    count: int, size: int, extent: Extent, center: NDArray[np.float64], extras: Mapping[str, Any]
) -> bytes:
    """Return the start of a GLB, up to an SPZ file of `size` bytes, which must follow with `padding` bytes."""
    accessors = [_accessor(*placeholder, count) for placeholder in _PLACEHOLDERS.values()]
    accessors[0] |= _corners(extent)
    padded_size = size + padding(size)
    body = {
        "accessors": accessors,
        "bufferViews": [{"buffer": 0, "byteLength": size}],
        "buffers": [{"byteLength": padded_size}],
        "extensionsRequired": [SPLATS, PACKED],
    }
    packing = {"extensions": {PACKED: {"bufferView": 0}}}
    return _start(_document(packing, list(_PLACEHOLDERS), center, extras) | body, padded_size)


def encode_packed(gaussians: Gaussians, center: NDArray[np.float64], extras: Mapping[str, Any]) -> bytes:
    """Encode Gaussians as a GLB with an SPZ file inside."""
    data = _spz.encode(gaussians, version=2)
    start = packed_start(len(gaussians), len(data), extent_of(gaussians), center, extras)
    return start + data + bytes(padding(len(data)))


def padding(size: int) -> int:
    """Number of bytes that pad a chunk to a multiple of 4."""
    return -size % 4


def extent_of(gaussians: Gaussians) -> Extent:
    """Least and greatest coordinates of the centres."""
    return np.array([gaussians.middle.min(axis=0), gaussians.middle.max(axis=0)], np.float64)


def _accessor(component: int, kind: str, is_normalized: bool, count: int) -> dict[str, Any]:
    accessor: dict[str, Any] = {"componentType": component, "count": count, "type": kind}
    return accessor | ({"normalized": True} if is_normalized else {})


def _corners(extent: Extent) -> dict[str, Any]:
    return {"min": extent[0].tolist(), "max": extent[1].tolist()}


def _document(
    packing: dict[str, Any], attributes: list[str], center: NDArray[np.float64], extras: Mapping[str, Any]
) -> dict[str, Any]:
    """Return the document shared by all files: one node with one mesh of points."""
    splats = {
        "kernel": "ellipse",
        "colorSpace": "srgb_rec709_display",
        "sortingMethod": "cameraDistance",
        "projection": "perspective",
    }
    primitive = {
        "attributes": {name: number for number, name in enumerate(attributes)},
        "mode": 0,
        "extensions": {SPLATS: splats | packing},
    }
    # Some viewers read only a node's matrix, not its translation.
    matrix = np.eye(4)
    matrix[3, :3] = center
    return {
        "asset": {"version": "2.0", "generator": f"nearfar {__version__}", "extras": dict(extras)},
        "extensionsUsed": [SPLATS, *([PACKED] if packing else [])],
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "matrix": matrix.ravel().tolist()}],
        "meshes": [{"primitives": [primitive]}],
    }


def _start(document: dict[str, Any], size: int) -> bytes:
    """Encode a GLB's header, its document, and the header of a binary chunk of `size` bytes."""
    text = json.dumps(document, separators=(",", ":"), allow_nan=False).encode()
    text += b" " * padding(len(text))
    total_size = 12 + 8 + len(text) + 8 + size
    if total_size > MAX_BYTES:
        raise UnusableError(f"a GLB holds at most {MAX_BYTES:,} bytes, this one would have {total_size:,}")
    head = struct.pack("<4sII", b"glTF", 2, total_size) + struct.pack("<I4s", len(text), b"JSON")
    return head + text + struct.pack("<I4s", size, b"BIN\0")
