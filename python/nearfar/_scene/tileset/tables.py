"""Headers and feature tables of the tiles of 3D Tiles 1.0, and the placements of an i3dm's instances."""

from __future__ import annotations

import struct
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check, glb
from nearfar._base.errors import UnusableError
from nearfar._scene.entries import TILE_FARTHEST, coordinates, integer
from nearfar._scene.frames import Floats, east_north_up, geodetic
from nearfar._scene.gltf.nodes import compose_transforms

_COMMON = struct.Struct("<4sII")
_LENGTHS = struct.Struct("<IIII")
_VERSION = 1


@dataclass(frozen=True)
class Parts:
    """Parts of a tile's file."""

    features: Features
    has_properties: bool
    """Whether its batch table has properties, which are not drawn."""
    format: int
    """Format of an i3dm's model: 0 for a URI of a glTF file, 1 for an embedded GLB."""
    body: bytes
    """Bytes after the tables."""


def first_tile(data: bytes) -> bytes:
    """Return the bytes of the tile at the start of `data`; UnusableError if its header does not match."""
    if len(data) < _COMMON.size:
        raise UnusableError(f"it ends within its header, after {len(data)} bytes")
    magic, version, length = _COMMON.unpack_from(data)
    name = magic.decode("latin-1")
    if version != _VERSION:
        raise UnusableError(f"it is {name} of version {version}, and only version 1 is read")
    if not _COMMON.size <= length <= len(data):
        raise UnusableError(f"its header states {length:,} bytes, and it has {len(data):,}")
    return data[:length]


def split(data: bytes, *, has_format: bool) -> Parts:
    """Split a b3dm or, with `has_format`, an i3dm."""
    data = first_tile(data)
    start = _COMMON.size + _LENGTHS.size + 4 * has_format
    if len(data) < start:
        raise UnusableError(f"it ends within its header of {start} bytes")
    lengths = _LENGTHS.unpack_from(data, _COMMON.size)
    ends = [start, *(start + sum(lengths[: n + 1]) for n in range(4))]
    if ends[-1] > len(data):
        sizes = " + ".join(f"{length:,}" for length in lengths)
        raise UnusableError(f"its header states tables of {sizes} bytes, and {len(data) - start:,} follow it")
    text, binary, properties, _ = (data[a:b] for a, b in pairwise(ends))
    kind = int.from_bytes(data[start - 4 : start], "little") if has_format else 1
    document = glb.json_object(text) if text.strip(b" \0") else {}
    return Parts(Features(document, binary), len(properties.strip(b" \0")) > 2, kind, data[ends[-1] :])


class Features:
    """Feature table: values for the whole tile, and rows, one for each feature."""

    def __init__(self, document: dict[str, Any], binary: bytes) -> None:
        self._document, self._binary = document, binary

    def __contains__(self, name: str) -> bool:
        return self._document.get(name) is not None

    def count(self, name: str) -> int:
        """A number of features or instances."""
        value = self._document.get(name)
        if isinstance(value, dict):
            value = int(self.rows(name, 1, 1, np.uint32)[0, 0])
        return integer(value, 0, (1 << 32) - 1, f"feature table, {name}")

    def flag(self, name: str) -> bool:
        """A boolean value."""
        return self._document.get(name) is True

    def vector(self, name: str, width: int = 3) -> NDArray[np.float64]:
        """A vector (K,) for the whole tile, in the document or in the binary part."""
        value = self._document.get(name)
        if isinstance(value, dict):
            value = self.rows(name, 1, width, np.float32)[0].astype(float).tolist()
        return coordinates(value, width, f"feature table, {name}")

    def rows(self, name: str, count: int, width: int, kind: type[np.generic]) -> NDArray[Any]:
        """Rows (N, K), one for each feature, from the binary part or from a list."""
        value = self._document.get(name)
        json_path = f"feature table, {name}"
        if isinstance(value, list):
            if len(value) != count * width:
                raise UnusableError(f"{json_path}: expected {count * width:,} numbers, got {len(value):,}")
            return np.array(coordinates(value, count * width, json_path), kind).reshape(count, width)
        if not isinstance(value, dict):
            raise UnusableError(f"{json_path}: expected a list or a byteOffset, got {check.shortened(value)}")
        start = integer(value.get("byteOffset"), 0, len(self._binary), f"{json_path}.byteOffset")
        byte_count = count * width * np.dtype(kind).itemsize
        if start + byte_count > len(self._binary):
            available = f"from byte {start:,}, and the table has {len(self._binary):,}"
            raise UnusableError(f"{json_path}: {count:,} rows take {byte_count:,} bytes {available}")
        return np.frombuffer(self._binary, np.dtype(kind).newbyteorder("<"), count * width, start).reshape(count, width)


def rotations_depend_on_location(features: Features) -> bool:
    """Whether instances stand upright on the Earth, so that their rotations depend on the tile's location."""
    return features.flag("EAST_NORTH_UP") and not _has_axes(features)


def instance_transforms(features: Features, to_earth: Floats) -> Floats:
    """Transforms instance→tile (N, 4, 4) of a feature table; `to_earth` (4, 4) is the transform tile→Earth."""
    number = features.count("INSTANCES_LENGTH")
    positions = _positions(features, number)
    return compose_transforms(positions, _rotations(features, number, positions, to_earth), _scales(features, number))


def _positions(features: Features, number: int) -> Floats:
    """Positions (N, 3) in the tile's frame."""
    if "POSITION" in features:
        positions = features.rows("POSITION", number, 3, np.float32).astype(np.float64)
    elif "POSITION_QUANTIZED" in features:
        steps = features.rows("POSITION_QUANTIZED", number, 3, np.uint16) / 65535.0
        positions = features.vector("QUANTIZED_VOLUME_OFFSET") + steps * features.vector("QUANTIZED_VOLUME_SCALE")
    else:
        raise UnusableError(f"feature table: expected a POSITION for each of {number:,} instances, got none")
    if "RTC_CENTER" in features:
        positions = positions + features.vector("RTC_CENTER")
    if not (np.abs(positions) <= TILE_FARTHEST).all():
        raise UnusableError("feature table, POSITION: expected coordinates within ±1e10")
    return positions


def _scales(features: Features, number: int) -> Floats:
    scales = np.ones((number, 3))
    if "SCALE" in features:
        scales *= features.rows("SCALE", number, 1, np.float32)
    if "SCALE_NON_UNIFORM" in features:
        scales *= features.rows("SCALE_NON_UNIFORM", number, 3, np.float32)
    if not (np.abs(scales) <= TILE_FARTHEST).all():
        raise UnusableError("feature table, SCALE: expected factors within ±1e10")
    return scales


def _rotations(features: Features, number: int, positions: Floats, to_earth: Floats) -> Floats:
    """Rotations (N, 3, 3); columns are the directions of the model's right, up and forward axes."""
    if _has_axes(features):
        return _rotations_from_axes(_axis(features, "NORMAL_RIGHT", number), _axis(features, "NORMAL_UP", number))
    if features.flag("EAST_NORTH_UP"):
        geodetic_positions = geodetic(positions @ to_earth[:3, :3].T + to_earth[:3, 3])
        return np.asarray(np.linalg.inv(_normalized_axes(to_earth)) @ east_north_up(geodetic_positions))
    return np.tile(np.eye(3), (number, 1, 1))


def _normalized_axes(matrix: Floats) -> Floats:
    """Linear part of a transform, with its columns normalised."""
    linear = matrix[:3, :3]
    lengths = np.sqrt((linear**2).sum(axis=0))
    if not np.linalg.det(linear / np.where(lengths > 0, lengths, 1)):
        raise UnusableError("its tile's transform is singular, so that EAST_NORTH_UP defines no rotation")
    return np.asarray(linear / lengths)


def _has_axes(features: Features) -> bool:
    return any(all(f"{axis}{kind}" in features for axis in ("NORMAL_UP", "NORMAL_RIGHT")) for kind in ("", "_OCT32P"))


def _axis(features: Features, name: str, number: int) -> Floats:
    if name in features:
        return features.rows(name, number, 3, np.float32).astype(np.float64)
    return from_octahedron(features.rows(f"{name}_OCT32P", number, 2, np.uint16))


def from_octahedron(codes: NDArray[np.uint16]) -> Floats:
    """Decode unit vectors (N, 3) from 16-bit pairs (N, 2) in octahedral encoding (Cigolle et al. 2014)."""
    x, y = (codes / 65535.0 * 2 - 1).T
    z = 1 - np.abs(x) - np.abs(y)
    is_below = z < 0
    signs = np.where(x < 0, -1.0, 1.0), np.where(y < 0, -1.0, 1.0)
    x, y = np.where(is_below, (1 - np.abs(y)) * signs[0], x), np.where(is_below, (1 - np.abs(x)) * signs[1], y)
    vectors = np.stack([x, y, z], axis=1)
    return np.asarray(vectors / np.linalg.norm(vectors, axis=1, keepdims=True))


def _rotations_from_axes(right: Floats, up: Floats) -> Floats:
    """Rotations (N, 3, 3) from axes (N, 3) that need not be exactly perpendicular; the forward axis is right × up."""
    with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
        right = right / np.linalg.norm(right, axis=1, keepdims=True)
        forward = np.cross(right, up)
        forward /= np.linalg.norm(forward, axis=1, keepdims=True)
        rotations = np.stack([right, np.cross(forward, right), forward], axis=2)
    is_invalid = ~np.isfinite(rotations).all(axis=(1, 2))
    if is_invalid.any():
        raise UnusableError(
            f"feature table, NORMAL_UP: expected axes of instance {int(is_invalid.argmax())} that span a plane"
        )
    return rotations
