"""Tests of environment map layouts: directions of texels, and conversion between layouts."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, strategies as st
from numpy.typing import NDArray

import nearfar as nf
from nearfar._cubemap.layouts import Layout
from nearfar._cubemap.lookup import Filter

LAYOUTS: tuple[Layout, ...] = ("cube", "equirectangular", "octahedral")
Array = NDArray[np.float64]


def smooth(d: Array) -> Array:
    d = d / np.linalg.norm(d, axis=-1, keepdims=True)
    return np.asarray(np.sin(3 * d[..., 0] - d[..., 1]) + np.cos(2 * d[..., 2] + d[..., 1]))


@pytest.mark.parametrize("layout", LAYOUTS)
@pytest.mark.parametrize("size", [1, 2, 3, 10, 33])
def test_directions_and_texels_are_inverses(layout: Layout, size: int) -> None:
    directions = nf.envmap_directions(size, layout=layout)
    shape = {"cube": (6, size, size), "equirectangular": (size, 2 * size), "octahedral": (size, size)}[layout]
    assert directions.shape == (*shape, 3)
    numbers = np.arange(directions.size // 3).reshape(shape)
    for scale in (1, 1e-300, 1e300):
        np.testing.assert_array_equal(nf.envmap_texels(directions * scale, size=size, layout=layout), numbers)
    np.testing.assert_array_equal(nf.envmap_texels(directions.astype(np.float32), size=size, layout=layout), numbers)


def equirectangular(d: Array, height: int, width: int) -> tuple[float, float]:
    """Row and column of a direction."""
    x, y, z = d / np.linalg.norm(d)
    return (0.5 - math.asin(y) / math.pi) * height, (math.atan2(x, -z) / (2 * math.pi) + 0.5) * width


def octahedral(d: Array, size: int) -> tuple[float, float]:
    x, y, z = d / np.abs(d).sum()
    if y < 0:
        x, z = math.copysign(1 - abs(z), x), math.copysign(1 - abs(x), z)
    return (z + 1) / 2 * size, (x + 1) / 2 * size


@given(st.integers(1, 40), st.integers(0, 2**32 - 1))
def test_texel_directions_equal_the_formulas(size: int, seed: int) -> None:
    for d in np.random.default_rng(seed).normal(size=(20, 3)):
        for layout in ("equirectangular", "octahedral"):
            number = int(nf.envmap_texels(d, size=size, layout=layout))
            width = 2 * size if layout == "equirectangular" else size
            row, column = equirectangular(d, size, width) if layout == "equirectangular" else octahedral(d, size)
            # Directions on a border of texels, up to rounding, are left out.
            if all(abs(p - round(p)) > 1e-9 for p in (row, column)):
                assert number == int(row) * width + int(column)


def test_orientation() -> None:
    """Six marked directions, checked by eye: front −z, right +x, up +y."""
    marks = {"front": (0, 0, -1), "right": (1, 0, 0), "back": (0, 0, 1), "left": (-1, 0, 0), "up": (0, 1, 0)}
    cube = np.zeros((6, 3, 3), np.int32)
    for number, face in enumerate((5, 0, 4, 1, 2, 3), 1):
        cube[face] = number
    front, right, back, left, up, down = range(1, 7)
    around = nf.convert_envmap(cube, source="cube", target="equirectangular", size=(9, 16), filter="nearest")
    assert around[4].tolist() == [back] * 2 + [left] * 4 + [front] * 4 + [right] * 4 + [back] * 2
    assert (around[0] == up).all()
    assert (around[8] == down).all()
    octahedron = nf.convert_envmap(cube, source="cube", target="octahedral", size=7, filter="nearest")
    # Seen from above: x to the right, z down, −y at the corners.
    assert octahedron[3].tolist() == [left, left, up, up, up, right, right]
    assert octahedron[:, 3].tolist() == [front, front, up, up, up, back, back]
    assert {octahedron[i, j] for i in (0, 6) for j in (0, 6)} == {down}
    pictures: dict[Layout, Any] = {"equirectangular": around, "octahedral": octahedron}
    for layout, picture in pictures.items():
        again = nf.convert_envmap(picture, source=layout, target="cube", size=1, filter="nearest")
        for number, mark in enumerate(marks.values(), 1):
            assert nf.cube_lookup(again, mark) == number
        assert again.dtype == np.int32


@pytest.mark.parametrize("source", LAYOUTS)
@pytest.mark.parametrize("target", LAYOUTS)
def test_errors_of_smooth_pictures(source: Layout, target: Layout) -> None:
    """Errors in all directions, including every edge and pole: a wrong neighbour would be off by a texel, 0.1."""
    size = 48
    values = smooth(nf.envmap_directions(size, layout=source))
    truth = smooth(nf.envmap_directions(40, layout=target))
    linear, cubic, nearest = (
        np.abs(nf.convert_envmap(values, source=source, target=target, size=40, filter=name) - truth).max()
        for name in ("linear", "cubic", "nearest")
    )
    # Texels in radians: 2/S in the middle of a face, π/S at the equator; octahedra take steps of √2 · 2/S at a distance
    # of down to 1/√3. Gradients are up to √10 + √5 = 5.4, second derivatives in two directions up to 10 + 5, third ones
    # up to 32 + 11. The folds of an octahedron are kinks, of which a quarter of a texel is lost.
    width = {"cube": 2, "equirectangular": math.pi, "octahedral": 5}[source] / size
    kink = 5.4 * width / 4 if source == "octahedral" else 0.0
    assert linear <= 15 * width**2 / 8 + kink
    # Keys' error is (2s³ − 3s² + s)/12, at most 0.008, of the third derivative in each direction, and higher orders.
    assert cubic <= 2 * (2 * 0.008 * 43) * width**3 + kink
    # The greatest distance to a texel's centre is half a diagonal.
    assert nearest <= 5.4 * width * math.sqrt(0.5)


@pytest.mark.parametrize("layout", LAYOUTS)
def test_round_trips(layout: Layout) -> None:
    values = smooth(nf.envmap_directions(64)).astype(np.float32)
    there = nf.convert_envmap(values, source="cube", target=layout, size=256, filter="cubic")
    back = nf.convert_envmap(there, source=layout, target="cube", size=64, filter="linear")
    assert there.dtype == back.dtype == np.float32
    # Two conversions with the errors above: cubic at a width of 2/64 gives 3e-4; linear at 4/256 gives 1.1e-3, and
    # 1.3e-2 at folds.
    assert np.abs(back - values).max() < (1.5e-2 if layout == "octahedral" else 1.5e-3)
    same = nf.convert_envmap(there, source=layout, target=layout, size=256, filter="linear")
    # At texel centres nothing is mixed, up to the rounding of angles: 1e-15 · 256 of slopes.
    np.testing.assert_allclose(same, there, rtol=0, atol=3e-7)


@pytest.mark.parametrize("source", LAYOUTS)
def test_nearest_and_extremes_pick_texels(source: Layout) -> None:
    rng = np.random.default_rng(0)
    shape = nf.envmap_directions(9, layout=source).shape[:-1]
    values = rng.uniform(-1, 1, (*shape, 2))
    for target in LAYOUTS:
        d = nf.envmap_directions(11, layout=target)
        numbers = nf.envmap_texels(d, size=9, layout=source)
        results = {
            name: nf.convert_envmap(values, source=source, target=target, size=11, filter=name)
            for name in ("nearest", "linear", "min", "max")
        }
        np.testing.assert_array_equal(results["nearest"], values.reshape(-1, 2)[numbers])
        assert np.isin(results["min"], values).all()
        assert np.isin(results["max"], values).all()
        # Up to three texels with weights below 1e-10 are mixed but not searched; they differ by up to 2.
        assert (results["min"] <= results["linear"] + 6e-10).all()
        assert (results["linear"] <= results["max"] + 6e-10).all()
        if source == "cube":
            for name in ("linear", "min", "max"):
                np.testing.assert_array_equal(results[name], nf.cube_lookup(values, d, filter=name))


@pytest.mark.parametrize("source", LAYOUTS)
def test_infinite_ranges_do_not_become_nan(source: Layout) -> None:
    values = np.full(nf.envmap_directions(8, layout=source).shape[:-1], np.inf, np.float32)
    values[0] = 7
    for name in ("nearest", "linear", "min", "max"):
        samples = 1 if name == "nearest" else 3
        for target in LAYOUTS:
            found = nf.convert_envmap(values, source=source, target=target, size=6, filter=name, samples=samples)
            assert np.isin(found, [7, np.inf]).all()


@pytest.mark.parametrize("target", LAYOUTS)
def test_samples_equal_means_of_finer_pictures(target: str) -> None:
    """The 3 × 3 samples lie at the texel centres of a map three times as fine."""
    values = np.random.default_rng(0).uniform(-1, 1, (32, 64))
    for name, choose in (("linear", np.mean), ("cubic", np.mean), ("min", np.min), ("max", np.max)):
        settings: dict[str, Any] = {"source": "equirectangular", "target": target, "filter": name}
        fine = nf.convert_envmap(values, size=30, **settings)
        blocks = fine.reshape(*fine.shape[:-2], fine.shape[-2] // 3, 3, -1, 3)
        expected = choose(blocks, axis=(-3, -1))
        found = nf.convert_envmap(values, size=10, samples=3, **settings)
        # Positions agree up to rounding, times slopes of about 50 per unit.
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12)


@pytest.mark.parametrize("name", ["nearest", "min", "max"])
@pytest.mark.parametrize(
    ("layout", "shape"),
    [
        ("equirectangular", (6, 10)),
        ("equirectangular", (100, 64)),
        ("equirectangular", (3, 32768)),
        ("octahedral", (7, 7)),
        ("octahedral", (300, 300)),
        ("cube", (6, 1, 1)),
        ("cube", (6, 49, 49)),
    ],
)
def test_picked_texels_survive_conversion_to_the_same_layout(
    layout: Layout, shape: tuple[int, ...], name: Filter
) -> None:
    """At a texel's centre its neighbours have no weight, up to rounding."""
    values = np.random.default_rng(0).uniform(size=shape)
    values[..., ::5] = np.nan
    size: Any = shape if layout == "equirectangular" else shape[-1]
    same = nf.convert_envmap(values, source=layout, target=layout, size=size, filter=name)
    np.testing.assert_array_equal(same, values)


@pytest.mark.parametrize("source", ["equirectangular", "octahedral"])
def test_extremes_skip_nan(source: str) -> None:
    """The search covers the texels to which the linear filter gives weight."""
    shape = (4, 8) if source == "equirectangular" else (6, 6)
    count = math.prod(shape)
    values = np.random.default_rng(0).uniform(-1, 1, shape)
    values[np.random.default_rng(1).uniform(size=shape) < 0.6] = np.nan
    settings: dict[str, Any] = {"source": source, "target": "cube", "size": 9}
    weights = nf.convert_envmap(np.eye(count).reshape(*shape, count), **settings)
    texels = np.broadcast_to(values.ravel(), weights.shape)
    mixed = (weights > 1e-9) & ~np.isnan(texels)
    for name, choose, nothing in (("min", np.min, np.inf), ("max", np.max, -np.inf)):
        expected = choose(np.where(mixed, texels, nothing), axis=-1)
        expected[~mixed.any(-1)] = np.nan
        assert np.isnan(expected).any()
        np.testing.assert_array_equal(nf.convert_envmap(values, **settings | {"filter": name}), expected)


def test_errors_at_octahedral_folds_are_of_first_order() -> None:
    """Errors at folds and elsewhere equal those that the documentation states."""
    found = []
    for size in (64, 128, 256):
        values = smooth(nf.envmap_directions(size, layout="octahedral"))
        d = nf.envmap_directions(4 * size, layout="octahedral")
        there = nf.convert_envmap(values, source="octahedral", target="octahedral", size=4 * size)
        error, away = np.abs(there - smooth(d)), np.abs(d).min(-1) * size / 2
        found.append((error[away < 0.5].max(), error[away > 2].max()))
    ratios = np.array(found)[:-1] / np.array(found)[1:]
    assert (np.abs(ratios - (2, 4)) < 0.2).all()
    assert found[-1] == pytest.approx((0.01, 0.0006), rel=0.1)


def test_shapes_and_types_follow_the_values() -> None:
    values = np.zeros((4, 8, 3, 2), np.float32)
    assert nf.convert_envmap(values, source="equirectangular", target="cube", size=5).shape == (6, 5, 5, 3, 2)
    assert nf.convert_envmap(values, source="equirectangular", target="octahedral", size=5).dtype == np.float32
    empty = nf.convert_envmap(values[..., :0], source="equirectangular", target="equirectangular", size=(3, 4))
    assert empty.shape == (3, 4, 3, 0)
    wide = np.arange(8.0).reshape(2, 4)[:, ::-1]
    same = nf.convert_envmap(wide, source="equirectangular", target="equirectangular", size=2, filter="nearest")
    np.testing.assert_array_equal(same, wide)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"values": np.zeros((4, 5)), "source": "equirectangular"}, "even W"),
        ({"values": np.zeros((4, 6)), "source": "octahedral"}, r"values: expected shape \(S, S"),
        ({"values": np.zeros((6, 2, 2), np.int32)}, "filter: expected 'nearest' for values of type int32"),
        ({"filter": "nearest", "samples": 2}, "samples: expected 1"),
        ({"target": "equirectangular", "size": (4, 5)}, "size: expected an even W"),
        ({"target": "equirectangular", "size": (4, 5, 6)}, "size: expected"),
    ],
)
def test_refuses(change: dict[str, Any], words: str) -> None:
    given: dict[str, Any] = {"values": np.zeros((6, 2, 2)), "source": "cube", "target": "cube", "size": 4} | change
    with pytest.raises(ValueError, match=words):
        nf.convert_envmap(given.pop("values"), **given)


def test_refuses_zero_directions_and_other_types() -> None:
    with pytest.raises(ValueError, match=r"directions.*index 1"):
        nf.envmap_texels([(1, 0, 0), (0, 0, 0)], size=4, layout="octahedral")
    for layout, size in (("cube", (4, 8)), ("cube", np.array([4, 8])), ("equirectangular", np.array([4.5, 8.0]))):
        with pytest.raises(TypeError, match="size: expected a whole number"):
            nf.envmap_directions(size, layout=layout)  # type: ignore[arg-type]
    shape = nf.envmap_directions(np.array([3, 6]), layout="equirectangular").shape  # type: ignore[arg-type]
    assert shape == (3, 6, 3)
