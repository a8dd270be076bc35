"""Maps of rings: each shows the objects of later rings; colour and range as bytes."""

from __future__ import annotations

import contextlib
import zlib
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from numpy.typing import NDArray

import nearfar as nf
from nearfar._render.bake import bake
from nearfar.stream import _map_files as codec
from nearfar.stream._map_files import RangeScale
from tests.support.ranges_oracle import Decoder

CENTER = (3.0, 1.7, -2.0)
RADII = (10.0, 22.0, 63.0)
SIZE = 48


def ranges(env: nf.EnvMap) -> NDArray[Any]:
    assert env.range is not None
    return env.range


@pytest.fixture(scope="module")
def rings() -> nf.stream.Rings:
    return nf.stream.assign(nf.datasets.city(blocks=3, detail=1), center=CENTER, radii=RADII)


@pytest.mark.parametrize("samples", [1, 4])
def test_each_map_shows_the_objects_of_later_rings(rings: nf.stream.Rings, samples: int) -> None:
    maps = nf.stream.bake_maps(rings, face_size=SIZE, samples=samples, object_id=True)
    for ring in range(rings.count + 1):
        later = [name for number in range(ring + 1, rings.count + 2) for name in rings.objects(number)]
        settings: dict[str, Any] = {"size": SIZE, "samples": samples, "half": False, "device": None}
        whole, _ = bake(rings.scene.subset(objects=later), CENTER, 0.0, channels=("range", "object_id"), **settings)
        found = maps.map(ring)
        np.testing.assert_array_equal(found.range, whole.range)
        np.testing.assert_array_equal(found.object_id, whole.object_id)
        # Equal up to rounding: textures of parts may lie elsewhere, but their texels are the same.
        np.testing.assert_allclose(found.color, whole.color, atol=2e-6)
        assert found.center == CENTER


def test_only_texels_that_change_are_traced_again(rings: nf.stream.Rings) -> None:
    maps = nf.stream.bake_maps(rings, face_size=SIZE, samples=1)
    before = maps.map(0)
    for ring in range(1, rings.count + 1):
        after = maps.map(ring)
        differs = np.ravel(ranges(after) != ranges(before))
        texels = maps.changes[ring - 1]["texels"]
        assert set(np.flatnonzero(differs)) == set(texels.tolist()), "ranges grow where an object leaves"
        assert (ranges(after) >= ranges(before)).all()
        before = after
    changed = sum(len(change["texels"]) for change in maps.changes)
    assert maps.rays == 6 * SIZE**2 + changed < 3 * 6 * SIZE**2


def test_changed_tiles_contain_all_changed_texels(rings: nf.stream.Rings) -> None:
    maps = nf.stream.bake_maps(rings, face_size=100)
    for ring in range(1, rings.count + 1):
        tiles = maps.changed_tiles(ring)
        assert tiles.shape == (6, 2, 2)
        changed = np.zeros(6 * 100 * 100, bool)
        changed[maps.changes[ring - 1]["texels"]] = True
        faces = changed.reshape(6, 100, 100)
        expected = [
            [[faces[f, 64 * y : 64 * y + 64, 64 * x : 64 * x + 64].any() for x in (0, 1)] for y in (0, 1)]
            for f in range(6)
        ]
        np.testing.assert_array_equal(tiles, expected)


def test_a_ring_without_objects_changes_nothing() -> None:
    corners = np.array([[-5, -5, -80], [5, -5, -80], [5, 5, -80]], np.float32)
    far = nf.Scene.from_arrays(corners, [[0, 1, 2]], face_object=[0])
    rings = nf.stream.assign(far, center=(0, 0, 0), radii=(10.0, 20.0, 100.0))
    maps = nf.stream.bake_maps(rings, face_size=16)
    assert [len(change["texels"]) for change in maps.changes[:2]] == [0, 0]
    assert len(maps.changes[2]["texels"]) > 0
    assert np.isinf(ranges(maps.map(3))).all()
    np.testing.assert_array_equal(maps.map(2).color, maps.map(0).color)


# Maps as bytes --------------------------------------------------------------------------------------------------------
STEP = 2.0**-10


@dataclass
class Maps:
    """Two maps of faces (N, S, S) as codes: the second differs in listed tiles of 4² texels."""

    before: NDArray[np.uint16]
    after: NDArray[np.uint16]
    changed: NDArray[np.bool_]
    tiles: NDArray[np.int64]

    @classmethod
    def random(cls, seed: int, count: int, size: int, noise: int) -> Maps:
        """Slanted walls with noise and holes, some of them replaced by others."""
        rng = np.random.default_rng(seed)
        before, after = (walls(rng, count, size, noise) for _ in range(2))
        listed = rng.random((count, size // 4, size // 4)) < 0.5
        changed = listed.repeat(4, axis=1).repeat(4, axis=2) & (rng.random((count, size, size)) < 0.6)
        tiles = np.flatnonzero(listed)
        return cls(before, np.where(changed, after, before), changed, tiles)

    def encoded(self, is_delta: bool) -> bytes:
        return codec.encode_ranges(
            self.after, self.before if is_delta else None, self.changed, self.tiles, tile=4, step=STEP
        )

    def decoded(self, data: bytes, is_delta: bool) -> tuple[NDArray[np.uint16], NDArray[np.bool_]]:
        count, size = self.after.shape[:2]
        before = self.before if is_delta else None
        return codec.decode_ranges(data, before, count, size, self.tiles, tile=4, step=STEP)


def walls(rng: np.random.Generator, count: int, size: int, noise: int) -> NDArray[np.uint16]:
    """Codes of planes that meet at random columns."""
    face, y, x = np.indices((count, size, size))
    u, v = (2 * x + 1) / size - 1, (2 * y + 1) / size - 1
    wall = 2 * face + (x > rng.integers(0, size))
    across, up = rng.uniform(-0.3, 0.3, (2, 2 * count))[:, wall]
    depth = 1 / (rng.uniform(0.7, 3, 2 * count)[wall] + across * u + up * v)
    codes = 3000 + np.log(depth * np.sqrt(1 + u * u + v * v)) / STEP + rng.integers(0, noise, u.shape)
    return np.where(rng.random(u.shape) < 0.1 * (noise > 1), 65535, np.clip(codes, 0, 65534)).astype(np.uint16)


@settings(deadline=None, max_examples=40)
@given(
    st.integers(0, 2**32 - 1),
    st.tuples(st.integers(1, 3), st.sampled_from([4, 12, 24])),
    st.sampled_from([1, 2, 400, 60000]),
    st.booleans(),
)
def test_ranges_are_decoded_as_documented(seed: int, shape: tuple[int, int], noise: int, is_delta: bool) -> None:
    maps = Maps.random(seed, *shape, noise)
    data = maps.encoded(is_delta)
    codes, changed = maps.decoded(data, is_delta)
    np.testing.assert_array_equal(codes, maps.after)
    np.testing.assert_array_equal(changed, maps.changed)
    slowly = Decoder(data, maps.before if is_delta else None, *shape, maps.tiles, 4, STEP)
    np.testing.assert_array_equal(slowly.codes, maps.after)
    np.testing.assert_array_equal(slowly.changed, maps.changed)


@given(st.booleans(), st.data())
def test_damaged_ranges_are_refused_or_read_as_others(is_delta: bool, draw: st.DataObject) -> None:
    maps = Maps.random(3, 2, 12, 5)
    raw = bytearray(zlib.decompress(maps.encoded(is_delta)))
    for place in draw.draw(st.lists(st.integers(0, len(raw) - 1), min_size=1, max_size=4)):
        raw[place] = draw.draw(st.integers(0, 255))
    with contextlib.suppress(ValueError):
        codes, changed = maps.decoded(zlib.compress(raw), is_delta)
        assert codes.shape == changed.shape == maps.after.shape


@pytest.mark.parametrize("is_delta", [False, True])
def test_truncated_and_endless_ranges_are_refused(is_delta: bool) -> None:
    maps = Maps.random(5, 1, 12, 5)
    data = maps.encoded(is_delta)
    raw = zlib.decompress(data)
    # 10 MB of zeros in 10 kB: data that does not fit is not unpacked.
    wrong = [b"", b"abc", data[:-5], data + b"a", zlib.compress(raw[:-1]), zlib.compress(raw + b"a")]
    for bad in [*wrong, zlib.compress(bytes(10_000_000))]:
        with pytest.raises(ValueError, match=r"expected .*ranges|ranges: expected"):
            maps.decoded(bad, is_delta)


def test_changes_outside_listed_tiles_are_refused() -> None:
    maps = Maps.random(6, 1, 12, 5)
    beside = np.ones_like(maps.changed)
    with pytest.raises(ValueError, match="tiles"):
        codec.encode_ranges(maps.after, maps.before, beside, maps.tiles[:1], tile=4, step=STEP)
    with pytest.raises(ValueError, match="changed"):
        codec.encode_ranges(maps.after, maps.before, ~beside, maps.tiles, tile=4, step=STEP)


def test_a_map_takes_fewer_bytes_as_changes() -> None:
    maps = Maps.random(7, 1, 128, 2)
    maps.changed[:, 40:] = False
    maps.after = np.where(maps.changed, maps.after, maps.before)
    assert len(maps.encoded(True)) < 0.5 * len(maps.encoded(False))


def test_neighbours_of_marked_texels_are_marked() -> None:
    mask = np.random.default_rng(0).random((2, 9, 9)) < 0.05
    wide = np.pad(mask, ((0, 0), (1, 1), (1, 1)))
    expected = [wide[:, y : y + 9, x : x + 9] for y in range(3) for x in range(3)]
    np.testing.assert_array_equal(codec.with_neighbours(mask), np.any(expected, axis=0))


@pytest.mark.parametrize(("low", "high", "error"), [(0.1, 1000.0, 2.0**-11), (0.002, 3e6, 1e-5), (5.0, 5.0, 1e-3)])
def test_ranges_have_the_stated_error(low: float, high: float, error: float) -> None:
    ranges = np.geomspace(low, high, 100_000, dtype=np.float32)
    ranges[7] = np.inf
    scale = RangeScale.fit(ranges, error)
    shown = scale.ranges(scale.codes(ranges))
    # The error, half a float32 step of the result, and the rounding of both ends of the scale.
    finite = np.isfinite(ranges)
    assert np.abs(shown[finite] / ranges[finite].astype(np.float64) - 1).max() <= scale.error + 2.0**-23
    assert scale.error == pytest.approx(max(error, scale.error))
    assert (scale.error == pytest.approx(error)) == (error > 1e-5)
    np.testing.assert_array_equal(np.isinf(shown), ~finite)


def test_ranges_next_to_zero_and_empty_maps_are_stored() -> None:
    ranges = np.array([0.0, 1e-6, 2.0], np.float32)
    scale = RangeScale.fit(ranges, 1e-3)
    assert scale.ranges(scale.codes(ranges)) == pytest.approx([codec.MIN_RANGE, codec.MIN_RANGE, 2.0], rel=1e-3)
    nothing = np.full((1, 2, 2), np.inf, np.float32)
    scale = RangeScale.fit(nothing, 1e-3)
    assert np.isinf(scale.ranges(scale.codes(nothing))).all()


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
