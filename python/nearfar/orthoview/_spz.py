"""Encodes SPZ files (Niantic, versions 2 and 3): Gaussians in 19 or 20 bytes, then gzip.

A file has a header, then the positions, opacities, colours, scales and rotations of all. The axes are those of glTF.
"""

from __future__ import annotations

import gzip
import math
import struct

import numpy as np
from numpy.typing import NDArray

from nearfar._base.errors import UnusableError
from nearfar.orthoview._gaussians import Gaussians

MAGIC = 0x5053474E
"""The letters NGSP."""

HEADER = struct.Struct("<IIIBBBB")
"""Magic number, version, number of Gaussians, degree of spherical harmonics, fraction bits, flags, reserved byte."""

MAX = 10_000_000
"""Maximum number of Gaussians that the reference implementation reads."""

SECTIONS = ("positions", "alphas", "colors", "scales", "rotations")
"""Sections in file order."""

_MAX_CODE = (1 << 23) - 1
_MAX_FRACTION_BITS = 20
_STEPS_PER_SIGMA = 32
"""Least number of steps of positions in the smallest standard deviation along a surface."""

_HARMONIC = 0.282_094_791_773_878_1
"""Spherical harmonic of degree 0."""

_COLOR_FACTOR = 0.15
"""Factor by which files scale coefficients of degree 0."""

_COLOR_CODES = np.rint(((np.arange(256) / 255.0 - 0.5) / _HARMONIC * _COLOR_FACTOR + 0.5) * 255.0).astype(np.uint8)
_LARGEST_OF_THREE = math.sqrt(0.5)


def header(version: int, count: int, bits: int) -> bytes:
    """Encode a file's header; positions are multiples of 2^−bits."""
    return HEADER.pack(MAGIC, version, count, 0, bits, 0, 0)


def fraction_bits(reach: float, finest: float) -> int:
    """Number of fraction bits for 24-bit coordinates up to `reach`, but no more than the splats need.

    `finest` is the smallest standard deviation along a surface. Raises UnusableError if the integer part alone does not
    fit in 24 bits.
    """
    max_bits = math.floor(math.log2(_MAX_CODE / max(reach, 2.0**-_MAX_FRACTION_BITS)))
    if max_bits < 0:
        raise UnusableError(f"coordinates up to {reach:.3g} m do not fit into the whole numbers of an SPZ file")
    return max(0, min(max_bits, math.ceil(math.log2(_STEPS_PER_SIGMA / finest)), _MAX_FRACTION_BITS))


def encode_sections(gaussians: Gaussians, bits: int, version: int) -> dict[str, bytes]:
    """Encode some Gaussians by section, for files with `bits` fraction bits."""
    fixed = np.rint(gaussians.middle.astype(np.float64) * 2.0**bits).clip(-_MAX_CODE, _MAX_CODE).astype("<i4")
    scales = np.rint((np.log(np.maximum(gaussians.scale, 1e-30)) + 10.0) * 16.0).clip(0, 255).astype(np.uint8)
    rotations = _first_three(gaussians.rotation) if version == 2 else _smallest_three(gaussians.rotation)
    return {
        "positions": fixed.view(np.uint8).reshape(-1, 3, 4)[:, :, :3].tobytes(),
        "alphas": b"\xff" * len(gaussians),
        "colors": _COLOR_CODES[gaussians.color].tobytes(),
        "scales": scales.tobytes(),
        "rotations": rotations.tobytes(),
    }


def encode(gaussians: Gaussians, *, version: int = 3) -> bytes:
    """Encode Gaussians as a file, relative to their frame's origin."""
    reach = float(np.abs(gaussians.middle).max(initial=0.0))
    bits = fraction_bits(reach, float(gaussians.scale[:, :2].min(initial=1.0)))
    content = encode_sections(gaussians, bits, version)
    data = b"".join([header(version, len(gaussians), bits), *(content[name] for name in SECTIONS)])
    return gzip.compress(data, 6, mtime=0)


def _first_three(rotation: NDArray[np.float32]) -> NDArray[np.uint8]:
    """Encode x, y and z as bytes (N, 3); w must not be negative."""
    return np.asarray(np.rint(rotation[:, :3] * 127.5 + 127.5).clip(0, 255), np.uint8)


def _smallest_three(rotation: NDArray[np.float32]) -> NDArray[np.uint32]:
    """Pack into 32 bits (N,): the index of the greatest component, w, then sign and nine bits of x, y and z."""
    scaled = np.abs(rotation[:, :3]) * (511.0 / _LARGEST_OF_THREE)
    # As w is the greatest component, the others exceed √½ only by rounding.
    magnitude = np.rint(scaled).clip(0, 511).astype(np.uint32)
    codes = (rotation[:, :3] < 0).astype(np.uint32) << np.uint32(9) | magnitude
    x, y, z = codes.T
    return np.asarray(np.uint32(3 << 30) | x << np.uint32(20) | y << np.uint32(10) | z, "<u4")
