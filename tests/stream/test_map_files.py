"""Colour and range of maps as bytes."""

from __future__ import annotations

import zlib

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

import nearfar as nf
from nearfar.stream import _map_files as codec
from nearfar.stream._map_files import RangeScale


def slowly_decoded(data: bytes, shape: tuple[int, int, int]) -> NDArray[np.int64]:
    """Codes by the description in words, one by one."""
    raw = zlib.decompress(data)
    count = shape[0] * shape[1] * shape[2]
    codes = np.zeros(shape, np.int64)
    for number in range(count):
        folded = 256 * raw[number] + raw[count + number]
        residual = -(folded + 1) // 2 if folded % 2 else folded // 2
        block, y, x = np.unravel_index(number, shape)
        left = codes[block, y, x - 1] if x else 0
        up = codes[block, y - 1, x] if y else 0
        corner = codes[block, y - 1, x - 1] if x and y else 0
        codes[block, y, x] = (left + up - corner + residual) % 65536
    return codes


@given(st.integers(0, 2**32 - 1), st.tuples(*[st.integers(1, 9)] * 3), st.sampled_from([2, 300, 65536]))
def test_codes_come_back_as_described(seed: int, shape: tuple[int, int, int], span: int) -> None:
    codes = np.random.default_rng(seed).integers(65536 - span, 65536, shape).astype(np.uint16)
    data = codec.encode_codes(codes)
    np.testing.assert_array_equal(codec.decode_codes(data, shape), codes)
    np.testing.assert_array_equal(slowly_decoded(data, shape), codes)


@pytest.mark.parametrize(("low", "high", "error"), [(0.1, 1000.0, 2.0**-11), (0.002, 3e6, 1e-5), (5.0, 5.0, 1e-3)])
def test_ranges_have_the_stated_error(low: float, high: float, error: float) -> None:
    ranges = np.geomspace(low, high, 100_000, dtype=np.float32)
    ranges[7] = np.inf
    scale = RangeScale.of(ranges, error)
    shown = scale.ranges(scale.codes(ranges))
    # The error, half a float32 step of the result, and the rounding of both ends of the scale.
    finite = np.isfinite(ranges)
    assert np.abs(shown[finite] / ranges[finite].astype(np.float64) - 1).max() <= scale.error + 2.0**-23
    assert scale.error == pytest.approx(max(error, scale.error))
    assert (scale.error == pytest.approx(error)) == (error > 1e-5)
    np.testing.assert_array_equal(np.isinf(shown), ~finite)


def test_ranges_next_to_zero_and_empty_maps_are_stored() -> None:
    ranges = np.array([0.0, 1e-6, 2.0], np.float32)
    scale = RangeScale.of(ranges, 1e-3)
    assert scale.ranges(scale.codes(ranges)) == pytest.approx([codec.NEAREST, codec.NEAREST, 2.0], rel=1e-3)
    nothing = np.full((1, 2, 2), np.inf, np.float32)
    scale = RangeScale.of(nothing, 1e-3)
    assert np.isinf(scale.ranges(scale.codes(nothing))).all()


def test_damaged_codes_are_refused() -> None:
    data = codec.encode_codes(np.arange(64, dtype=np.uint16).reshape(1, 8, 8))
    for wrong in (b"", b"abc", data[:-5], codec.encode_codes(np.zeros((1, 8, 9), np.uint16))):
        with pytest.raises(ValueError, match=r"expected .*ranges"):
            codec.decode_codes(wrong, (1, 8, 8))
    # 10 MB of zeros in 10 kB: what does not fit is not unpacked.
    with pytest.raises(ValueError, match="got more"):
        codec.decode_codes(zlib.compress(bytes(10_000_000)), (1, 8, 8))


def test_lossless_pictures_keep_every_srgb_code() -> None:
    codes = np.random.default_rng(0).integers(0, 256, (5, 7, 3), np.uint8)
    view = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(90, 7 / 5), size=(7, 5))
    linear = codec._LINEAR[codes]
    found = codec.decode_color(codec.encode_color(linear, None), (7, 5))
    np.testing.assert_array_equal(found, linear)
    np.testing.assert_array_equal(nf.Frame(view, color=found).to_image(), codes)


def test_other_pictures_are_refused() -> None:
    data = codec.encode_color(np.zeros((4, 4, 3), np.float32), 80)
    with pytest.raises(ValueError, match="4 × 5 pixels"):
        codec.decode_color(data, (4, 5))
    for wrong in (b"", data[:20], b"\x89PNG\r\n\x1a\n"):
        with pytest.raises(ValueError, match="expected a WebP picture"):
            codec.decode_color(wrong, (4, 4))


def test_tiles_are_parts_of_faces() -> None:
    faces = np.random.default_rng(1).random((6, 12, 12, 3)).astype(np.float32)
    chosen = np.array([0, 5, 8, 9, 53])
    tiles = codec.tiles_of(faces, chosen, 4)
    for number, tile in zip(chosen.tolist(), tiles, strict=True):
        face, row, column = number // 9, number % 9 // 3, number % 3
        np.testing.assert_array_equal(tile, faces[face, 4 * row : 4 * row + 4, 4 * column : 4 * column + 4])
    patched = np.zeros_like(faces)
    codec.put_tiles(patched, chosen, tiles)
    np.testing.assert_array_equal(codec.tiles_of(patched, chosen, 4), tiles)
    assert np.count_nonzero(patched) == np.count_nonzero(tiles)
    sheet = codec.sheet_of(tiles, 3)
    assert sheet.shape == (8, 12, 3)
    np.testing.assert_array_equal(codec.tiles_of_sheet(sheet, 5, 4), tiles)
