"""Instances of an i3dm: position, rotation and scale of each copy of its model."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nearfar._base.errors import UnusableError
from nearfar._scene.frames import east_north_up, geodetic
from nearfar._scene.tileset import values
from nearfar._scene.tileset.frames import Floats
from nearfar._scene.tileset.tables import Features


def rotations_depend_on_location(features: Features) -> bool:
    """Whether instances stand upright on the Earth, so that their rotations depend on the tile's location."""
    return features.flag("EAST_NORTH_UP") and not _has_axes(features)


def transforms(features: Features, to_earth: Floats) -> Floats:
    """Transforms instance→tile (N, 4, 4) of a feature table; `to_earth` (4, 4) is the transform tile→Earth."""
    number = features.count("INSTANCES_LENGTH")
    positions = _positions(features, number)
    matrices = np.tile(np.eye(4), (number, 1, 1))
    matrices[:, :3, :3] = _rotations(features, number, positions, to_earth) * _scales(features, number)[:, None, :]
    matrices[:, :3, 3] = positions
    return matrices


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
    if not (np.abs(positions) <= values.FARTHEST).all():
        raise UnusableError("feature table, POSITION: expected coordinates within ±1e10")
    return positions


def _scales(features: Features, number: int) -> Floats:
    scales = np.ones((number, 3))
    if "SCALE" in features:
        scales *= features.rows("SCALE", number, 1, np.float32)
    if "SCALE_NON_UNIFORM" in features:
        scales *= features.rows("SCALE_NON_UNIFORM", number, 3, np.float32)
    if not (np.abs(scales) <= values.FARTHEST).all():
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
