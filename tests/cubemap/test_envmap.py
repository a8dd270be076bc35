"""Tests of environment maps: files, channels, lookup."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, strategies as st

import nearfar as nf
from nearfar._base import exr, formats
from nearfar._cubemap import envmap
from nearfar._cubemap.lookup import FILTERS
from tests.support import need, valid


def example(size: int = 4) -> nf.EnvMap:
    rng = np.random.default_rng(size)
    ranges = rng.uniform(1, 1e5, (6, size, size)).astype(np.float32)
    ranges[0, 0, 0] = np.inf
    return nf.EnvMap(
        (1.0, 2.5, -1e6),
        rng.uniform(0, 1, (6, size, size, 3)).astype(np.float32),
        ranges,
        rng.integers(-1, 2**31 - 1, (6, size, size)).astype(np.int32),
    )


@pytest.mark.parametrize("half", [False, True])
def test_maps_survive_files(tmp_path: Path, half: bool) -> None:
    env = example()
    env.save(tmp_path / "env.exr", half=half)
    back = nf.EnvMap.load(tmp_path / "env.exr")
    assert back.center == env.center
    assert back.channels == ("color", "range", "object_id")
    # Half floats have 11 bits and are rounded to the nearest; below 2⁻¹⁴ their step is constant.
    np.testing.assert_allclose(back.color, env.color, rtol=2**-11 if half else 0, atol=2**-25 if half else 0)
    np.testing.assert_array_equal(back.range, env.range)
    np.testing.assert_array_equal(back.object_id, env.object_id)
    plain = nf.EnvMap(env.center, env.color)
    plain.save(tmp_path / "env.exr")
    assert nf.EnvMap.load(tmp_path / "env.exr").channels == ("color",)


def test_maps_describe_themselves(tmp_path: Path) -> None:
    example().save(tmp_path / "env.exr")
    document, parts = exr.read(tmp_path / "env.exr", "envmap", 1)
    assert tuple(parts) == envmap.FACES
    assert document["center"] == [1.0, 2.5, -1e6]
    assert document["color_space"] == "linear"
    assert document["units"]["length"] == "metre"
    assert valid(document, "envmap")
    assert not valid(document | {"center": [1.0, 2.5]}, "envmap")


def test_maps_keep_object_names(tmp_path: Path) -> None:
    env = dataclasses.replace(example(), object_names=("Straße", "car", "木"))
    env.save(tmp_path / "env.exr")
    assert nf.EnvMap.load(tmp_path / "env.exr").object_names == ("Straße", "car", "木")
    document, _ = exr.read(tmp_path / "env.exr", "envmap", 1)
    assert valid(document, "envmap")
    assert nf.EnvMap(env.center, env.color).object_names == ()


def test_half_ranges(tmp_path: Path) -> None:
    """Ranges of float16 are rounded to 11 bits, exact in files, and looked up by the same code."""
    whole = example()
    assert whole.range is not None
    env = dataclasses.replace(whole, range=envmap.to_half(np.minimum(whole.range, np.float32(65504))))
    env.save(tmp_path / "env.exr")
    back = nf.EnvMap.load(tmp_path / "env.exr")
    assert env.range is not None
    assert back.range is not None
    assert back.range.dtype == np.float16
    np.testing.assert_array_equal(back.range, env.range)
    directions = np.random.default_rng(0).normal(size=(50, 3))
    for chosen in ("nearest", "min", "max"):
        exact = nf.cube_lookup(np.minimum(whole.range, np.float32(65504)), directions, filter=chosen)
        found = back.sample(directions, channel="range", filter=chosen)
        assert found.dtype == np.float32
        # Half floats are rounded to the nearest of 11 bits; min and max pick one of the rounded values.
        np.testing.assert_allclose(found, exact, rtol=2**-11)


@given(st.floats(2**-14, 65504, width=32))
def test_half_ranges_are_off_by_their_stated_error(metres: float) -> None:
    rounded = float(envmap.to_half(np.array([metres], np.float32))[0])
    assert abs(rounded - metres) <= 2**-11 * metres


def test_half_ranges_keep_infinity_and_refuse_overflow() -> None:
    kept = envmap.to_half(np.array([np.inf, 65504, 0], np.float32))
    np.testing.assert_array_equal(kept, np.array([np.inf, 65504, 0], np.float16))
    # 65,505 would round down to a float16; the documented limit applies to all values above 65,504.
    for beyond in (65505, 7e4, 1e30):
        with pytest.raises(ValueError, match=r"range_dtype: expected float32 .* ends at 65,504 m"):
            envmap.to_half(np.array([1, beyond, np.inf], np.float32))


@pytest.mark.parametrize("half", [False, True])
def test_openexr_reads_maps(tmp_path: Path, half: bool) -> None:
    need("OpenEXR")
    import OpenEXR

    env = example()
    if half:
        assert env.range is not None
        env = dataclasses.replace(env, range=envmap.to_half(np.minimum(env.range, np.float32(65504))))
    ranges, numbers = env.range, env.object_id
    assert ranges is not None
    assert numbers is not None
    env.save(tmp_path / "env.exr")
    with OpenEXR.File(str(tmp_path / "env.exr"), separate_channels=True) as file:
        assert tuple(part.name() for part in file.parts) == envmap.FACES
        for face, part in enumerate(file.parts):
            for axis, name in enumerate("RGB"):
                np.testing.assert_array_equal(part.channels[name].pixels, env.color[face, ..., axis].astype(np.float16))
            read = part.channels["range"].pixels
            assert read.dtype == (np.float16 if half else np.float32)
            np.testing.assert_array_equal(read, ranges[face])
            np.testing.assert_array_equal(part.channels["object_id"].pixels, numbers[face].view(np.uint32))
            # The attribute is float32.
            np.testing.assert_array_equal(part.header["center"], np.array(env.center, np.float32))


def test_loading_refuses_files_that_are_no_map(tmp_path: Path) -> None:
    path = tmp_path / "env.exr"
    path.write_bytes(b"garbage")
    with pytest.raises(nf.FormatError, match=r"env\.exr"):
        nf.EnvMap.load(path)
    parts = {"px": {name: np.zeros((2, 2), np.float32) for name in "RGB"}}
    exr.write(path, parts, formats.header("envmap", envmap.VERSION + 1, center=[0, 0, 0]))
    with pytest.raises(nf.FormatError, match="version"):
        nf.EnvMap.load(path)
    exr.write(path, parts, formats.header("envmap", envmap.VERSION, center=[0, 0, 0]))
    with pytest.raises(nf.FormatError, match="damaged environment map"):
        nf.EnvMap.load(path)
    face = {name: np.zeros((2, 2), np.float32) for name in "RGB"}
    numbers = {name: np.zeros((2, 2), np.uint32) for name in "RGB"}
    for wrong in (numbers, face | {"object_id": np.ones((2, 2), np.float32)}, face | {"range": numbers["R"]}):
        header = formats.header("envmap", envmap.VERSION, center=[0, 0, 0])
        exr.write(path, dict.fromkeys(envmap.FACES, wrong), header)
        with pytest.raises(nf.FormatError, match="damaged environment map: expected numbers of kind"):
            nf.EnvMap.load(path)
    nested = path.read_bytes().replace(b'"nearfar.envmap"', b"[" * 16)
    path.write_bytes(nested)
    with pytest.raises(nf.FormatError, match=r"env\.exr"):
        nf.EnvMap.load(path)
    with pytest.raises(FileNotFoundError):
        nf.EnvMap.load(tmp_path / "missing.exr")
    with pytest.raises(ValueError, match="half: expected False"):
        nf.EnvMap((0, 0, 0), np.full((6, 1, 1, 3), 1e6, np.float32)).save(path)
    with pytest.raises(ValueError, match=r"ending in \.exr"):
        example().save(tmp_path / "env.png")
    with pytest.raises(OSError, match="nowhere"):
        example().save(tmp_path / "nowhere" / "env.exr")


def test_samples_by_channel() -> None:
    env = example()
    directions = np.random.default_rng(0).normal(size=(5, 7, 3))
    np.testing.assert_array_equal(env.sample(directions), nf.cube_lookup(env.color, directions, filter="linear"))
    assert env.range is not None
    assert env.object_id is not None
    np.testing.assert_array_equal(env.sample(directions, channel="range"), nf.cube_lookup(env.range, directions))
    np.testing.assert_array_equal(
        env.sample(directions, channel="object_id"), nf.cube_lookup(env.object_id, directions)
    )
    assert (env.sample(directions, channel="range", filter="max") >= env.sample(directions, channel="range")).all()
    for mixing in ("linear", "cubic"):
        with pytest.raises(ValueError, match=f"for range, got '{mixing}'"):
            env.sample(directions, channel="range", filter=mixing)
    for mixed in FILTERS[1:]:
        with pytest.raises(ValueError, match=f"expected 'nearest' for object_id, got '{mixed}'"):
            env.sample(directions, channel="object_id", filter=mixed)
    widest = env.sample(directions, channel="range", filter="max", radius=0.3)
    np.testing.assert_array_equal(widest, nf.cube_lookup(env.range, directions, filter="max", radius=0.3))
    with pytest.raises(ValueError, match=r"channel: expected a baked one \(color\)"):
        nf.EnvMap((0, 0, 0), env.color).sample(directions, channel="range")
    with pytest.raises(ValueError, match="read-only"):
        env.color[0] = 0
