"""SPZ files of Gaussians against a reader written from the format's description."""

from __future__ import annotations

import gzip
import math
import struct
from pathlib import Path

import numpy as np
import pytest

from nearfar._base.errors import UnusableError
from nearfar.orthoview import _spz
from nearfar.orthoview._gaussians import NO_GAUSSIANS, Gaussians, matrices
from tests.support import need
from tests.support.reader_cases import answer_of
from tests.support.splat_files import Rows, spz_rows, turn


def some(count: int, reach: float = 60.0) -> Gaussians:
    """Random Gaussians whose quaternions have w as the largest component."""
    rng = np.random.default_rng(7)
    rotation = rng.normal(size=(count, 4))
    rotation /= np.linalg.norm(rotation, axis=1, keepdims=True)
    at = np.abs(rotation).argmax(axis=1)
    rotation[np.arange(count), at], rotation[:, 3] = rotation[:, 3], rotation[np.arange(count), at]
    rotation *= np.sign(rotation[:, 3:])
    return Gaussians(
        rng.uniform(-reach, reach, (count, 3)).astype(np.float32),
        rotation.astype(np.float32),
        np.exp(rng.uniform(-5, 3, (count, 3))).astype(np.float32),
        rng.integers(0, 256, (count, 3), dtype=np.uint8),
    )


def check(got: Rows, right: Gaussians, bits: int, degrees: float) -> None:
    """Check numbers within half a step, and rotations within some degrees."""
    # Positions are float32 before they are rounded.
    assert np.abs(got.middle - right.middle).max() <= 2.0**-bits / 2 + 1e-6 * np.abs(right.middle).max()
    assert np.abs(np.log(got.scale / right.scale)).max() <= 1 / 32 + 1e-6
    assert np.abs(got.color - right.color / 255).max() <= 0.5 / 255 * 0.282095 / 0.15 + 1e-9
    assert (got.opacity == 1).all()
    for quaternion, matrix in zip(got.rotation, matrices(right.rotation), strict=True):
        cosine = (np.trace(turn(quaternion).T @ matrix) - 1) / 2
        assert math.degrees(math.acos(min(cosine, 1))) <= degrees


# A component of version 2 is off by 1/255 at most and w by as much for each of the others, each at most as great as w:
# 2 asin of the length of all four, √(3 + 3²)/255, is 1.6°. A step of version 3 is √½/511.
@pytest.mark.parametrize(("version", "degrees"), [(2, 1.6), (3, 0.3)])
def test_values_are_restored_within_half_a_step(version: int, degrees: float) -> None:
    gaussians = some(400)
    data = _spz.encode(gaussians, version=version)
    bits = gzip.decompress(data)[13]
    assert 10 <= bits <= 17  # A reach of 60 m needs 6 of 23 bits.
    check(spz_rows(data, version), gaussians, bits, degrees)


def test_a_file_consists_of_header_and_sections() -> None:
    data = _spz.encode(some(3))
    content = gzip.decompress(data)
    assert struct.unpack_from("<III", content) == (0x5053474E, 3, 3)
    assert len(content) == 16 + 3 * (9 + 1 + 3 + 3 + 4)
    assert data[4:8] == bytes(4)  # No time stamp, so that the same splats give the same bytes.
    assert data == _spz.encode(some(3))


def test_fraction_bits_cover_the_reach_and_are_as_few_as_needed() -> None:
    for reach in (0.5, 60.0, 20_000.0, 8e6):
        bits = _spz.fraction_bits(reach, 0.01)
        assert reach * 2**bits <= 2**23 - 1
        assert reach * 2 ** (bits + 1) > 2**23 - 1 or 2**bits >= 32 / 0.01
    assert _spz.fraction_bits(10.0, 1.0) == 5
    with pytest.raises(UnusableError, match="do not fit"):
        _spz.fraction_bits(2e7, 1.0)


def test_a_file_may_be_empty() -> None:
    for version in (2, 3):
        assert len(spz_rows(_spz.encode(NO_GAUSSIANS, version=version), version).middle) == 0


@pytest.mark.slow
def test_the_reference_implementation_agrees(tmp_path: Path) -> None:
    need("browser")
    gaussians = some(200)
    versions = (2, 3)
    for version in versions:
        (tmp_path / f"{version}.spz").write_bytes(_spz.encode(gaussians, version=version))
    (tmp_path / "profile").mkdir()
    job = {"files": [f"/bundles/a/{version}.spz" for version in versions]}
    answer = answer_of("spz.mjs", job, tmp_path / "profile", {"a": tmp_path})
    for version, own in zip(versions, answer["files"], strict=True):
        right = spz_rows((tmp_path / f"{version}.spz").read_bytes(), version)
        assert (own["count"], own["degree"]) == (200, 0)
        assert np.allclose(np.reshape(own["positions"], (-1, 3)), right.middle, atol=1e-5)
        assert np.allclose(np.reshape(own["scales"], (-1, 3)), right.scale, rtol=1e-5)
        assert np.allclose(np.reshape(own["rotations"], (-1, 4)), right.rotation, atol=1e-5)
        # It returns colours in 0..1, computed with three digits of the spherical harmonic.
        assert np.allclose(np.reshape(own["colors"], (-1, 3)), right.color, atol=5e-4)
        assert own["alphas"] == [1] * 200
