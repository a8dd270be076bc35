"""Objects of half a million triangles and more, as the scenes of Liebisch (2021) must have contained."""

from __future__ import annotations

import numpy as np
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from nearfar.lod._simplify.surface import Base, Surface

MIN = 500_000
"""Least number of triangles of an object; since each round quadruples them, most have less than 1.6 million."""
ROUGHNESS = 0.05
"""Maximum displacement of a midpoint along each axis, as a share of its edge's length."""
_MIX = np.array([0x9E3779B1, 0x85EBCA77, 0xC2B2AE3D], np.uint32)
"""Odd multipliers, so that no bit of a coordinate is lost."""


def densify(scene: nf.Scene, least: int = MIN) -> nf.Scene:
    """Split every triangle into four at the displaced midpoints of its edges, until there are enough; flat normals."""
    base = Base(scene)
    base.with_normals("flat")
    surface = base.surface
    while len(surface.faces) < least:
        surface = _split(surface)
    return base.scene_of(surface)


def _split(surface: Surface) -> Surface:
    """Split every triangle once. Midpoints at the same place move alike, so that seams of the texture stay closed."""
    own = surface.positions.astype(np.float64)
    squares = (own * own).sum(axis=1, keepdims=True)
    attributes = {key: values.astype(np.float64) for key, values in surface.attributes.items()}
    positions, faces, means = trimesh.remesh.subdivide(own, surface.faces, vertex_attributes=attributes | {"": squares})
    new = positions[len(own) :]
    # |a − b|² = 4 ((|a|² + |b|²)/2 − |(a + b)/2|²)
    lengths = 2 * np.sqrt(np.maximum(means.pop("")[len(own) :] - (new * new).sum(axis=1, keepdims=True), 0))
    new += ROUGHNESS * lengths * _noise(new)
    return Surface(
        np.ascontiguousarray(positions, np.float32),
        np.ascontiguousarray(faces, np.uint32),
        np.repeat(surface.materials, 4),
        {key: np.ascontiguousarray(values, surface.attributes[key].dtype) for key, values in means.items()},
    )


def _noise(places: NDArray[np.float64]) -> NDArray[np.float64]:
    """Numbers from −1 to 1 for each axis (N, 3) that depend on the position only."""
    bits = np.ascontiguousarray(places + 0.0, np.float32).view(np.uint32)
    mixed = (bits * _MIX).sum(axis=1, dtype=np.uint32)[:, None] * _MIX
    mixed ^= mixed >> np.uint32(15)
    mixed *= _MIX[::-1]
    mixed ^= mixed >> np.uint32(13)
    noise: NDArray[np.float64] = mixed / np.float64(2**31) - 1
    return noise
