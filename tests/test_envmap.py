"""Cube maps against slow definitions written down independently."""

from __future__ import annotations

import dataclasses
import itertools
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp
from numpy.typing import NDArray

import nearfar as nf
from nearfar import _envmap, _exr, _formats
from support import need, valid

# Right and down of each face: Vulkan 1.3 specification, table "Cube map face selection".
AXES = {
    0: ((1, 0, 0), (0, 0, -1), (0, -1, 0)),
    1: ((-1, 0, 0), (0, 0, 1), (0, -1, 0)),
    2: ((0, 1, 0), (1, 0, 0), (0, 0, 1)),
    3: ((0, -1, 0), (1, 0, 0), (0, 0, -1)),
    4: ((0, 0, 1), (1, 0, 0), (0, -1, 0)),
    5: ((0, 0, -1), (-1, 0, 0), (0, -1, 0)),
}


def texel_points(size: int) -> dict[tuple[int, int, int], tuple[int, int, int]]:
    """Centres of all texels on the cube of half edge `size`, which makes them whole numbers."""
    points = {}
    for face, (normal, right, down) in AXES.items():
        for row, column in itertools.product(range(size), repeat=2):
            u, v = 2 * column + 1 - size, 2 * row + 1 - size
            x, y, z = (int(size * n + u * r + v * d) for n, r, d in zip(normal, right, down, strict=True))
            points[x, y, z] = (face, row, column)
    return points


def patches(size: int) -> list[list[tuple[int, int, int]]]:
    """Quads and triangles between neighbouring texel centres: inside faces, across edges, at corners."""
    centers = range(1 - size, size, 2)
    signs = (-size, size)
    found: list[list[NDArray[np.int64]]] = []
    for axis in range(3):
        for sign, a, b in itertools.product(signs, centers[:-1], centers[:-1]):
            quad = [(sign, a, b), (sign, a + 2, b), (sign, a, b + 2), (sign, a + 2, b + 2)]
            found.append([np.roll(corner, axis) for corner in quad])
        for s, t, c in itertools.product((-1, 1), (-1, 1), centers[:-1]):
            rows = [(s * size, t * (size - 1)), (s * (size - 1), t * size)]
            strip = [(*rows[0], c), (*rows[1], c), (*rows[0], c + 2), (*rows[1], c + 2)]
            found.append([np.roll(corner, axis) for corner in strip])
    for octant in itertools.product((-1, 1), repeat=3):
        corner = np.array(octant)
        found.append([corner * (size - 1) + np.eye(3, dtype=int)[axis] * corner[axis] for axis in range(3)])
    return [[(int(x), int(y), int(z)) for x, y, z in patch] for patch in found]


def oracle(faces: NDArray[np.float64], direction: NDArray[np.float64]) -> float:
    """Find the patch that the direction passes through, and interpolate within it."""
    size = faces.shape[1]
    texels = texel_points(size)
    for patch in patches(size):
        p = np.array(patch, float)
        values = np.array([faces[texels[corner]] for corner in patch])
        if len(patch) == 3:
            weights = np.linalg.solve(p.T, direction)
            if weights.sum() > 0 and (weights / weights.sum() >= -1e-9).all():
                return float(weights @ values / weights.sum())
            continue
        # Newton for P(s, t) = k d, from the middle; patches are nearly planar, so that eight steps are plenty.
        unknown = np.array([0.5, 0.5, np.linalg.norm(p.mean(0)) / np.linalg.norm(direction)])
        for _ in range(8):
            s, t, k = unknown
            residual = mix(p, s, t) - k * direction
            ds, dt = mix(p, 1, t) - mix(p, 0, t), mix(p, s, 1) - mix(p, s, 0)
            jacobian = np.stack([ds, dt, -direction], 1)
            if abs(np.linalg.det(jacobian)) < 1e-12:
                break
            unknown = unknown - np.linalg.solve(jacobian, residual)
        s, t, k = unknown
        solved = np.abs(mix(p, s, t) - k * direction).max() < 1e-9 * size
        if solved and k > 0 and -1e-9 <= s <= 1 + 1e-9 and -1e-9 <= t <= 1 + 1e-9:
            return float(mix(values, s, t))
    raise AssertionError(f"no patch for {direction}")


def mix(corners: NDArray[np.float64], s: float, t: float) -> NDArray[np.float64]:
    weights = np.array([(1 - s) * (1 - t), s * (1 - t), (1 - s) * t, s * t])
    return np.asarray(weights @ corners)


@pytest.mark.parametrize("size", [1, 2, 3, 5])
def test_nearest_finds_every_texel(size: int) -> None:
    faces = np.arange(6.0 * size * size).reshape(6, size, size)
    points = texel_points(size)
    directions = np.array(list(points), float)
    expected = [faces[texel] for texel in points.values()]
    np.testing.assert_array_equal(nf.cube_lookup(faces, directions), expected)
    np.testing.assert_array_equal(nf.cube_lookup(faces.astype(np.int32), directions), expected)
    centers = _envmap.cube_directions(size)
    np.testing.assert_array_equal(nf.cube_lookup(faces, centers), faces)
    # Weights are quotients of numbers of size 1: 1e-13 of values up to 150.
    np.testing.assert_allclose(nf.cube_lookup(faces, centers, filter="linear"), faces, rtol=0, atol=2e-11)


@pytest.mark.parametrize("size", [1, 2, 3, 4])
def test_linear_is_the_interpolation_within_patches(size: int) -> None:
    rng = np.random.default_rng(size)
    faces = rng.uniform(-1, 1, (6, size, size))
    directions = rng.normal(size=(60, 3))
    directions[:20, 1] = directions[:20, 0]
    directions[20:25] = np.sign(directions[20:25])
    expected = [oracle(faces, d) for d in directions]
    # The oracle solves for its weights to 1e-9.
    np.testing.assert_allclose(nf.cube_lookup(faces, directions, filter="linear"), expected, atol=1e-8)


def test_errors_at_seams_are_no_larger_than_inside() -> None:
    def smooth(d: NDArray[np.float64]) -> NDArray[np.float64]:
        d = d / np.linalg.norm(d, axis=-1, keepdims=True)
        return np.asarray(np.sin(3 * d[..., 0] - d[..., 1]) + np.cos(2 * d[..., 2] + d[..., 1]))

    size = 64
    faces = smooth(_envmap.cube_directions(size))
    directions = np.random.default_rng(0).uniform(-1, 1, (200_000, 3))
    directions[:20_000] = np.sign(directions[:20_000]) + directions[20_000:40_000] / size
    error = np.abs(nf.cube_lookup(faces, directions, filter="linear") - smooth(directions))
    ordered = np.sort(np.abs(directions), axis=1)
    ratio = ordered[:, :2] / ordered[:, 2:]
    edge = ratio[:, 1] > 1 - 1 / size
    corner = ratio[:, 0] > 1 - 1 / size
    assert edge.sum() > 1000
    assert corner.sum() > 1000
    assert error[edge].max() <= error[~edge].max()
    assert error[corner].max() <= error[~edge].max()


@given(
    st.integers(1, 9),
    hnp.arrays(np.float64, (20, 3), elements=st.floats(-1, 1, allow_subnormal=False)),
    st.sampled_from([np.float32, np.float64]),
    st.sampled_from([np.float32, np.float64]),
)
def test_filters_agree_with_each_other(size: int, directions: NDArray[np.float64], kind: type, along: type) -> None:
    directions = directions[np.abs(directions).max(1) > 1e-3].astype(along)
    faces: NDArray[Any] = np.random.default_rng(size).uniform(0, 1, (6, size, size, 2)).astype(kind)
    result = {name: nf.cube_lookup(faces, directions, filter=name) for name in _envmap.FILTERS}
    assert all(r.dtype == kind and r.shape == (len(directions), 2) for r in result.values())
    # One rounding of the mean in the faces' type.
    rounding = np.finfo(kind).eps
    assert (result["min"] <= result["linear"] + rounding).all()
    assert (result["linear"] <= result["max"] + rounding).all()
    assert np.isin(result["nearest"], faces).all()


def test_ranges_with_infinity_do_not_become_nan() -> None:
    faces = np.full((6, 4, 4), np.inf, np.float32)
    faces[4] = 7
    directions = np.random.default_rng(1).normal(size=(1000, 3))
    for name in _envmap.FILTERS:
        values = nf.cube_lookup(faces, directions, filter=name)
        assert np.isin(values, [7, np.inf]).all()


def test_shapes_follow_the_directions() -> None:
    faces = np.zeros((6, 2, 2, 3), np.float32)
    assert nf.cube_lookup(faces, (0, 0, 1)).shape == (3,)
    assert nf.cube_lookup(faces[..., 0], (0, 0, 1)).shape == ()
    assert nf.cube_lookup(np.zeros((6, 2, 2), np.int32), (0, 0, 1)).shape == ()
    assert nf.cube_lookup(faces, np.ones((4, 5, 3)), filter="linear").shape == (4, 5, 3)
    assert nf.cube_lookup(faces[..., 0], np.ones((4, 5, 3)), filter="max").shape == (4, 5)
    assert nf.cube_lookup(faces[..., 0], np.ones((0, 3))).shape == (0,)


@pytest.mark.parametrize(
    ("faces", "directions", "name", "words"),
    [
        (np.zeros((6, 2, 3)), np.ones((1, 3)), "nearest", "faces: expected shape"),
        (np.zeros((5, 2, 2)), np.ones((1, 3)), "nearest", "faces: expected shape"),
        (np.zeros((6, 0, 0)), np.ones((1, 3)), "nearest", "faces: expected shape"),
        (np.zeros((6, 2, 2)), np.ones((1, 2)), "nearest", "directions: expected shape"),
        (np.zeros((6, 2, 2)), np.zeros((1, 3)), "linear", "directions.*index 0"),
        (np.zeros((6, 2, 2)), [(1, 0, 0), (np.nan, 0, 0)], "nearest", "directions.*index 1"),
        (np.zeros((6, 2, 2)), np.ones((1, 3)), "cubic", "filter: expected one of"),
        (np.zeros((6, 2, 2), np.int32), np.ones((1, 3)), "linear", "filter: expected 'nearest'"),
    ],
)
def test_refuses(faces: NDArray[np.float64], directions: NDArray[np.float64], name: str, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        nf.cube_lookup(faces, directions, filter=name)


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


def test_maps_say_what_they_are(tmp_path: Path) -> None:
    example().save(tmp_path / "env.exr")
    document, parts = _exr.read(tmp_path / "env.exr", "envmap", 1)
    assert tuple(parts) == _envmap.FACES
    assert document["center"] == [1.0, 2.5, -1e6]
    assert document["color_space"] == "linear"
    assert document["units"]["length"] == "metre"
    assert valid(document, "envmap")
    assert not valid(document | {"center": [1.0, 2.5]}, "envmap")


def test_maps_keep_object_names(tmp_path: Path) -> None:
    env = dataclasses.replace(example(), object_names=("Straße", "car", "木"))
    env.save(tmp_path / "env.exr")
    assert nf.EnvMap.load(tmp_path / "env.exr").object_names == ("Straße", "car", "木")
    document, _ = _exr.read(tmp_path / "env.exr", "envmap", 1)
    assert valid(document, "envmap")
    assert nf.EnvMap(env.center, env.color).object_names == ()
    wrongs: list[Any] = ["car", (1, 2)]
    for wrong in wrongs:
        with pytest.raises(TypeError, match="object_names: expected a sequence of strings"):
            dataclasses.replace(env, object_names=wrong)


def test_half_ranges(tmp_path: Path) -> None:
    """Rounded to 11 bits, exact in files, and found by the same lookups."""
    whole = example()
    assert whole.range is not None
    env = dataclasses.replace(whole, range=_envmap.to_half(np.minimum(whole.range, np.float32(65504))))
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
    rounded = float(_envmap.to_half(np.array([metres], np.float32))[0])
    assert abs(rounded - metres) <= 2**-11 * metres


def test_half_ranges_keep_infinity_and_refuse_what_they_cannot_hold() -> None:
    kept = _envmap.to_half(np.array([np.inf, 65504, 0], np.float32))
    np.testing.assert_array_equal(kept, np.array([np.inf, 65504, 0], np.float16))
    # 65,505 would round down to what float16 holds: the limit is stated, and it is the same for every number.
    for beyond in (65505, 7e4, 1e30):
        with pytest.raises(ValueError, match=r"range_dtype: expected float32 .* ends at 65,504 m"):
            _envmap.to_half(np.array([1, beyond, np.inf], np.float32))


@pytest.mark.parametrize("half", [False, True])
def test_openexr_reads_maps(tmp_path: Path, half: bool) -> None:
    need("OpenEXR")
    import OpenEXR

    env = example()
    if half:
        assert env.range is not None
        env = dataclasses.replace(env, range=_envmap.to_half(np.minimum(env.range, np.float32(65504))))
    ranges, numbers = env.range, env.object_id
    assert ranges is not None
    assert numbers is not None
    env.save(tmp_path / "env.exr")
    with OpenEXR.File(str(tmp_path / "env.exr"), separate_channels=True) as file:
        assert tuple(part.name() for part in file.parts) == _envmap.FACES
        for face, part in enumerate(file.parts):
            for axis, name in enumerate("RGB"):
                np.testing.assert_array_equal(part.channels[name].pixels, env.color[face, ..., axis].astype(np.float16))
            read = part.channels["range"].pixels
            assert read.dtype == (np.float16 if half else np.float32)
            np.testing.assert_array_equal(read, ranges[face])
            np.testing.assert_array_equal(part.channels["object_id"].pixels, numbers[face].view(np.uint32))
            # The attribute is float32.
            np.testing.assert_array_equal(part.header["center"], np.array(env.center, np.float32))


def test_loading_refuses_what_is_no_map(tmp_path: Path) -> None:
    path = tmp_path / "env.exr"
    path.write_bytes(b"garbage")
    with pytest.raises(nf.FormatError, match=r"env\.exr"):
        nf.EnvMap.load(path)
    parts = {"px": {name: np.zeros((2, 2), np.float32) for name in "RGB"}}
    _exr.write(path, parts, _formats.header("envmap", _envmap.VERSION + 1, center=[0, 0, 0]))
    with pytest.raises(nf.FormatError, match="version"):
        nf.EnvMap.load(path)
    _exr.write(path, parts, _formats.header("envmap", _envmap.VERSION, center=[0, 0, 0]))
    with pytest.raises(nf.FormatError, match="damaged environment map"):
        nf.EnvMap.load(path)
    face = {name: np.zeros((2, 2), np.float32) for name in "RGB"}
    numbers = {name: np.zeros((2, 2), np.uint32) for name in "RGB"}
    for wrong in (numbers, face | {"object_id": np.ones((2, 2), np.float32)}, face | {"range": numbers["R"]}):
        header = _formats.header("envmap", _envmap.VERSION, center=[0, 0, 0])
        _exr.write(path, dict.fromkeys(_envmap.FACES, wrong), header)
        with pytest.raises(nf.FormatError, match="damaged environment map: expected numbers of kind"):
            nf.EnvMap.load(path)
    nested = path.read_bytes().replace(b'"nearfar.envmap"', b"[" * 16)
    path.write_bytes(nested)
    with pytest.raises(nf.FormatError, match=r"env\.exr"):
        nf.EnvMap.load(path)
    with pytest.raises(FileNotFoundError):
        nf.EnvMap.load(tmp_path / "missing.exr")
    with pytest.raises(TypeError, match="path: expected a string or a path"):
        nf.EnvMap.load(None)  # type: ignore[arg-type]
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
    with pytest.raises(ValueError, match="for range, got 'linear'"):
        env.sample(directions, channel="range", filter="linear")
    with pytest.raises(ValueError, match="expected one of color, which were baked"):
        nf.EnvMap((0, 0, 0), env.color).sample(directions, channel="range")
    with pytest.raises(ValueError, match="read-only"):
        env.color[0] = 0


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"color": np.zeros((6, 2, 2))}, "color: expected shape"),
        ({"color": np.zeros((6, 0, 0, 3))}, "color: expected shape"),
        ({"color": np.zeros((5, 4, 4, 3))}, "color: expected shape"),
        ({"range": np.zeros((6, 3, 3))}, "range: expected shape"),
        ({"object_id": np.zeros((6, 4), np.int32)}, "object_id: expected shape"),
        ({"center": (0, 0, np.nan)}, "center: expected 3 finite"),
        ({"color": np.full((6, 4, 4, 3), np.nan)}, "color: expected finite numbers"),
        ({"range": np.full((6, 4, 4), np.nan, np.float32)}, "range: expected metres"),
        ({"range": np.full((6, 4, 4), -1, np.float32)}, "range: expected metres"),
    ],
)
def test_maps_refuse(change: dict[str, Any], words: str) -> None:
    env = example()
    given: dict[str, Any] = {
        "center": env.center,
        "color": env.color,
        "range": env.range,
        "object_id": env.object_id,
    } | change
    with pytest.raises(ValueError, match=words):
        nf.EnvMap(**given)
