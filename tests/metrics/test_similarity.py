"""Tests of structural similarity against its definition and scikit-image, and of difficult inputs."""

from __future__ import annotations

import json
import pickle
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from hypothesis import given, strategies as st
from numpy.typing import NDArray

import nearfar as nf
from tests.support import data, need
from tests.support.similarity_oracle import inner_values, pictures, shrunk, slow_maps, slow_masked, unlimited, weights

TYPES: dict[Any, float] = {np.uint8: 255.0, np.uint16: 65535.0, np.float32: 1.0, np.float64: 1.0}


def typed(kind: type, *, height: int = 23, width: int = 29) -> tuple[NDArray[Any], NDArray[Any], float]:
    """Return two pictures of a type, and their data range."""
    extent = TYPES[kind]
    a, b = pictures(height, width)
    if kind in (np.uint8, np.uint16):
        return np.round(a * extent).astype(kind), np.round(b * extent).astype(kind), extent
    return a.astype(kind), b.astype(kind), extent


@pytest.mark.parametrize("kind", list(TYPES))
@pytest.mark.parametrize(("window", "size"), [("gaussian", 11), ("gaussian", 10), ("uniform", 7), ("uniform", 4)])
def test_similarity_equals_its_definition(kind: type, window: Any, size: int) -> None:
    a, b, extent = typed(kind)
    expected, _ = slow_maps(a, b, weights(window, size), extent)
    mean, found = nf.ssim(a, b, data_range=extent, window=window, size=size, full=True)
    # Float32 holds every difference of 8 and 16 bits, and c2 = 9e-4 of the range keeps some roundings below 1e-6.
    assert found.dtype == (np.float64 if kind == np.float64 else np.float32)
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12 if kind == np.float64 else 2e-6)
    assert mean == pytest.approx(inner_values(expected, size).mean(), abs=1e-13 if kind == np.float64 else 2e-7)


def test_every_convention_equals_its_definition() -> None:
    a, b, extent = typed(np.float64)
    options: dict[str, Any] = {"data_range": extent, "window": "uniform", "size": 5}
    line = weights("uniform", 5)
    whole, _ = slow_maps(a, b, line, extent)
    sample, _ = slow_maps(a, b, line, extent, sample=25 / 24)
    assert nf.ssim(a, b, convention="full", **options) == pytest.approx(whole.mean(), abs=1e-13)
    mean, found = nf.ssim(a, b, convention="skimage", full=True, **options)
    np.testing.assert_allclose(found, sample, rtol=0, atol=1e-12)
    assert mean == pytest.approx(inner_values(sample, 5).mean(), abs=1e-13)
    # Pictures of less than 384 pixels are not downsampled; 900 pixels are, by 4, with boxes that begin a pixel earlier.
    assert nf.ssim(a, b, convention="wang-downsampled", **options) == nf.ssim(a, b, **options)
    large = pictures(900, 1001)
    mean, found = nf.ssim(*large, data_range=1, convention="wang-downsampled", full=True)
    assert found.shape == (225, 251)
    assert mean == pytest.approx(nf.ssim(*(shrunk(p, 4) for p in large), data_range=1), abs=1e-13)


@pytest.mark.parametrize("sample", [False, True])
def test_the_global_window_covers_the_whole_picture(sample: bool) -> None:
    a, b, _ = typed(np.float64)
    c1, c2, factor = 1e-4, 9e-4, a.size / (a.size - 1) if sample else 1.0
    covariance = ((a - a.mean()) * (b - b.mean())).mean() * factor
    expected = (2 * a.mean() * b.mean() + c1) * (2 * covariance + c2)
    expected /= (a.mean() ** 2 + b.mean() ** 2 + c1) * ((a.var() + b.var()) * factor + c2)
    found = nf.ssim(a, b, data_range=1, window="global", convention="skimage" if sample else "wang")
    assert found == pytest.approx(expected, abs=1e-13)


@pytest.mark.parametrize("channels", [0, 3])
def test_similarity_equals_scikit_image(channels: int) -> None:
    need("skimage")
    from skimage.metrics import structural_similarity

    a, b = pictures(90, 131)
    if channels:
        a, b = (np.stack([p, p**2, 1 - p], axis=-1) for p in (a, b))
    axis = {"channel_axis": -1} if channels else {}
    for ours, theirs in [
        ({"window": "gaussian"}, {"gaussian_weights": True, "sigma": 1.5, "use_sample_covariance": False}),
        ({"window": "uniform", "size": 7}, {"win_size": 7, "use_sample_covariance": False}),
        ({"window": "uniform", "size": 7, "convention": "skimage"}, {}),
        ({"window": "gaussian", "convention": "skimage"}, {"gaussian_weights": True}),
    ]:
        options: Any = {**axis, **theirs}  # type: ignore[dict-item]
        mean, found = nf.ssim(a, b, data_range=1, full=True, **ours)  # type: ignore[arg-type]
        expected_mean, expected = structural_similarity(a, b, data_range=1.0, full=True, **options)
        assert abs(mean - expected_mean) < 1e-12
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-10)


def test_the_noisy_camera_picture_has_the_value_of_imdiff() -> None:
    need("data")
    from PIL import Image

    with Image.open(data("iqa/skimage/camera.png")) as image:
        camera = np.asarray(image)
    # The numbers that scikit-image's tests draw; the value is that of IPOL's imdiff, which weighs borders otherwise.
    noise = 20.0 * np.random.RandomState(5).randn(*camera.shape)
    noisy = np.clip(camera + noise, 0, 255).astype(np.uint8)
    assert nf.ssim(camera, noisy, data_range=255) == pytest.approx(0.357959091663361, abs=1e-5)


sizes = st.tuples(st.integers(1, 40), st.integers(1, 40))


@given(sizes, st.sampled_from(list(TYPES)), st.sampled_from(["gaussian", "uniform", "global"]), st.integers(1, 13))
def test_identical_pictures_have_similarity_one(shape: tuple[int, int], kind: type, window: Any, size: int) -> None:
    a, b, extent = typed(kind, height=shape[0], width=shape[1])
    options: dict[str, Any] = {"data_range": extent, "window": window, "size": min(size, *shape)}
    mean, found = nf.ssim(a, b, full=True, **options)
    assert (found <= 1).all()
    assert mean <= 1
    assert nf.ssim(a, a, **options) == 1.0
    assert (nf.ssim(a, a, full=True, **options).map == 1.0).all()
    swapped = nf.ssim(b, a, full=True, **options)
    assert float(swapped) == mean
    np.testing.assert_array_equal(swapped.map, found)
    # Without the map tiles begin elsewhere, and so do levels.
    assert nf.ssim(a, b, **options) == pytest.approx(mean, abs=1e-12 if kind == np.float64 else 1e-6)


@given(st.integers(0, 2**32 - 1), sizes, st.integers(1, 12), st.sampled_from(["gaussian", "uniform"]))
def test_random_pictures_equal_the_definition(seed: int, shape: tuple[int, int], size: int, window: Any) -> None:
    random, size = np.random.default_rng(seed), min(size, *shape)
    a, b = random.normal(random.normal() * 10, 10 ** random.uniform(-3, 2), (2, *shape))
    expected, _ = slow_maps(a, b, weights(window, size), 2.0)
    mean, found = nf.ssim(a, b, **unlimited(a, b, extent=2.0), window=window, size=size, full=True)
    # 2e-14 of the squares that are averaged, over c2 = 3.6e-3 where the variance is less.
    tolerance = 2e-11 * max(1.0, float(np.abs([a, b]).max()) ** 2 / 1e3)
    np.testing.assert_allclose(found, expected, rtol=0, atol=tolerance)
    assert mean == pytest.approx(inner_values(expected, size).mean(), abs=tolerance)


@pytest.mark.parametrize("convention", ["wang", "skimage", "wang-downsampled"])
def test_windows_larger_than_the_picture_are_refused(convention: Any) -> None:
    # pytorch-msssim (issue 23) shrinks the window without a word; scikit-image refuses.
    small = np.random.default_rng(0).random((7, 9))
    for call in (nf.ssim, nf.metrics.ssim_pairs):
        with pytest.raises(ValueError, match=r"size: expected a window of at most 7 pixels, .* got 11; windows of"):
            call(small, small, data_range=1, convention=convention)
        assert call(small, small, data_range=1, convention=convention, size=7) == 1.0
        assert call(small, small, data_range=1, convention="full") == 1.0


def test_masks_select_pixels() -> None:
    a, b = pictures()
    mask = np.zeros(a.shape, bool)
    mask[10:20, 15:30] = True
    mask[12, 17] = False
    _, found = nf.ssim(a, b, data_range=1, full=True)
    mean, same = nf.ssim(a, b, data_range=1, mask=mask, full=True)
    assert mean == pytest.approx(found[mask].mean(), abs=1e-14)
    # Local means are those of the mask.
    np.testing.assert_allclose(same, found, rtol=0, atol=1e-14)
    assert nf.ssim(a, b, data_range=1, mask=mask) == pytest.approx(mean, abs=1e-14)
    assert nf.ssim(a, b, data_range=1, mask=mask.astype(np.int64) * 7) == pytest.approx(mean, abs=1e-14)
    # Pixels that no window of the mask contains do not matter.
    broken = a.copy()
    broken[30:] = np.nan
    assert nf.ssim(broken, b, data_range=1, mask=mask) == pytest.approx(mean, abs=1e-14)
    border = np.zeros(a.shape, bool)
    border[0, 0] = True
    with pytest.raises(ValueError, match="mask: expected at least one pixel"):
        nf.ssim(a, b, data_range=1, mask=border)
    assert nf.ssim(a, b, data_range=1, mask=border, convention="full") == pytest.approx(found[0, 0], abs=1e-14)


@given(st.integers(0, 2**32 - 1), sizes, st.integers(1, 12), st.sampled_from([np.float32, np.float64]))
def test_windows_within_the_mask_equal_the_definition(seed: int, shape: tuple[int, int], size: int, kind: type) -> None:
    random = np.random.default_rng(seed)
    a, b = random.uniform(0, 1, (2, *shape)).astype(kind)
    mask = random.uniform(size=shape) < random.uniform(0.05, 1)
    mask[random.integers(shape[0]), random.integers(shape[1])] = True
    expected = slow_masked(a, b, mask, weights("gaussian", size), 1.0)
    outside: NDArray[Any] = np.where(mask, a, np.nan).astype(kind)
    mean, found = nf.ssim(outside, b, data_range=1, size=size, mask=mask, masking="windows", full=True)
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-11 if kind == np.float64 else 1e-7)
    assert mean == pytest.approx(np.nanmean(expected), abs=1e-11)
    assert nf.ssim(outside, b, data_range=1, size=size, mask=mask, masking="windows") == mean
    seen = [p[mask].astype(np.float64) for p in (a, b)]
    alone = nf.ssim(outside, b, data_range=1, window="global", mask=mask, masking="windows")
    assert alone == pytest.approx(nf.ssim(*(p[None] for p in seen), data_range=1, window="global"), abs=1e-7)


def layouts(a: NDArray[Any]) -> Iterator[NDArray[Any]]:
    """Return the same values in other memory layouts."""
    yield np.asfortranarray(a)
    yield np.repeat(np.repeat(a, 2, axis=0), 3, axis=1)[::2, ::3]
    yield a[::-1, ::-1].copy()[::-1, ::-1]
    yield a.astype(a.dtype.newbyteorder())
    frozen = a.copy()
    frozen.flags.writeable = False
    yield frozen
    shifted = np.empty(a.nbytes + 1, np.uint8)[1:].view(a.dtype).reshape(a.shape)
    shifted[:] = a
    yield shifted
    yield np.broadcast_to(a[None], (3, *a.shape))[1]
    record = np.zeros(a.shape, [("flag", np.uint8), ("value", a.dtype)])
    record["value"] = a
    yield record["value"]


@pytest.mark.parametrize("kind", list(TYPES))
def test_any_layout_has_the_same_bits(kind: type) -> None:
    a, b, extent = typed(kind, height=61, width=140)
    mask = np.add.outer(np.arange(61), np.arange(140)) % 3 == 0
    expected = nf.ssim(a, b, data_range=extent)
    masked = nf.ssim(a, b, data_range=extent, mask=mask)
    noise = nf.metrics.rmse(a, b)
    for layout, other in zip(layouts(a), layouts(mask.view(np.uint8)), strict=True):
        assert nf.ssim(layout, b, data_range=extent) == expected
        assert nf.ssim(b, layout, data_range=extent) == expected
        assert nf.ssim(a, b, data_range=extent, mask=other) == masked
        assert nf.metrics.rmse(layout, b) == pytest.approx(noise, rel=1e-14)
    for channels in (np.stack([a, b], axis=-1), np.moveaxis(np.stack([a, b]), 0, -1)):
        found = nf.ssim(channels, channels[..., ::-1], data_range=extent, channel_axis=-1, full=True)
        # Tiles of maps begin elsewhere, and round otherwise.
        assert float(found) == pytest.approx(expected, abs=1e-14 if kind == np.float64 else 1e-8)
        assert found.map.shape == (61, 140, 2)


def test_axes_of_one_pixel_may_have_any_step() -> None:
    line = np.linspace(0, 1, 50)[None]
    back = line[::-1]
    assert nf.ssim(back, line, data_range=1, window="global") == nf.metrics.rmse(back, line) + 1 == 1.0
    one = np.zeros((1, 5, 3), [("flag", np.uint8), ("value", np.float32)])["value"][0, :1, :1]
    assert nf.metrics.rmse(one, one + 1) == 1.0


def test_mixed_types_use_the_smallest_common_type() -> None:
    a, b, _ = typed(np.uint8)
    exact = nf.ssim(a, b, data_range=255)
    for kind in (np.uint16, np.int16, np.int64, np.float16, np.float32, np.float64):
        assert nf.ssim(a, b.astype(kind), data_range=255) == pytest.approx(exact, abs=1e-6)
    assert nf.ssim(a > 127, b > 127, data_range=1) == nf.ssim((a > 127).astype(np.uint8), b > 127, data_range=1)


def test_values_beyond_float32_are_computed_in_float64() -> None:
    a, b, _ = typed(np.float32)
    expected = nf.ssim(a, b, data_range=1)
    for scale in (1e-18, 1e-8, 1e10, 1e30):
        small = [p * np.float32(scale) for p in (a, b)]
        assert nf.ssim(*small, data_range=scale) == pytest.approx(expected, abs=1e-5)
        assert nf.ssim(*(p.astype(np.float64) for p in small), data_range=scale) == pytest.approx(expected, abs=1e-5)


def test_pairs_equal_single_calls() -> None:
    random = np.random.default_rng(0)
    views = random.uniform(size=(4, 1, 30, 41))
    levels = np.clip(views + 0.1 * random.normal(size=(4, 3, 30, 41)), 0, 1)
    silhouettes = random.uniform(size=(4, 1, 30, 41)) < 0.3
    for kind in (np.float32, np.float64):
        first, second = views.astype(kind), levels.astype(kind)
        for options in ({}, {"window": "uniform", "size": 4}, {"window": "global"}, {"convention": "skimage"}):
            found = nf.metrics.ssim_pairs(first, second, data_range=1, **options)
            assert found.shape == (4, 3)
            for i, j in np.ndindex(4, 3):
                assert found[i, j] == nf.ssim(first[i, 0], second[i, j], data_range=1, **options)
        for masking in ("mean", "windows"):
            found = nf.metrics.ssim_pairs(first, second, data_range=1, masks=silhouettes, masking=masking)
            for i, j in np.ndindex(4, 3):
                mask = silhouettes[i, 0]
                assert found[i, j] == nf.ssim(first[i, 0], second[i, j], data_range=1, mask=mask, masking=masking)
    one = nf.metrics.ssim_pairs(views[0, 0], levels[0], data_range=1)
    assert one.shape == (3,)
    empty = np.zeros((3, 30, 41), bool)
    empty[1, 15, 15] = True
    np.testing.assert_array_equal(
        np.isnan(nf.metrics.ssim_pairs(views[0, 0], levels[0], data_range=1, masks=empty)), [1, 0, 1]
    )
    assert nf.metrics.ssim_pairs(views[0, 0], levels[0, 0], data_range=1).shape == ()
    assert nf.metrics.ssim_pairs(views[:0], levels[:0], data_range=1).shape == (0, 3)


def test_multiple_scales_equal_their_definition() -> None:
    a, b = pictures(181, 193)
    line, exponents = weights("gaussian", 11), np.array([0.0448, 0.2856, 0.3001, 0.2363, 0.1333])
    first, second, factors = a, b, []
    for scale in range(5):
        similar, contrast = (inner_values(values, 11).mean() for values in slow_maps(first, second, line, 1.0))
        factors.append(similar if scale == 4 else contrast)
        first, second = shrunk(first, 2), shrunk(second, 2)
    assert nf.metrics.ms_ssim(a, b, data_range=1) == pytest.approx((np.array(factors) ** exponents).prod(), abs=1e-12)
    assert nf.metrics.ms_ssim(a, a, data_range=1) == 1.0
    assert nf.metrics.ms_ssim(a, b, data_range=1, weights=[1.0]) == pytest.approx(
        nf.ssim(a, b, data_range=1), abs=1e-14
    )
    double = nf.metrics.ms_ssim(np.stack([a, a]), np.stack([b, a]), data_range=1, channel_axis=0)
    assert double == pytest.approx((nf.metrics.ms_ssim(a, b, data_range=1) + 1) / 2, abs=1e-14)
    byte = [np.round(255 * p).astype(np.uint8) for p in (a, b)]
    assert nf.metrics.ms_ssim(*byte, data_range=255) == pytest.approx(nf.metrics.ms_ssim(a, b, data_range=1), abs=1e-3)
    # Negative means count as 0.
    assert nf.metrics.ms_ssim(a, 1 - a, data_range=1) == 0.0
    with pytest.raises(ValueError, match="reference: expected windows of 11 pixels"):
        nf.metrics.ms_ssim(a[:150], b[:150], data_range=1)


def test_sequences_are_read_lazily() -> None:
    a, b = pictures()
    read = []

    def frames() -> Iterator[NDArray[np.float64]]:
        for number, picture in enumerate((a, a, b, a)):
            read.append(number)
            yield picture

    continuity = nf.metrics.visual_continuity(frames(), data_range=1)
    assert next(continuity) == 1.0
    assert read == [0, 1]
    change = nf.ssim(a, b, data_range=1, window="global")
    assert list(continuity) == [change, change]
    assert list(nf.metrics.visual_continuity([a], data_range=1)) == []
    with pytest.raises(ValueError, match="data_range"):
        list(nf.metrics.visual_continuity([a, b]))

    def same_memory() -> Iterator[NDArray[np.float64]]:
        buffer = np.empty_like(a)
        for picture in (a, b):
            buffer[:] = picture
            yield buffer

    assert list(nf.metrics.visual_continuity(same_memory(), data_range=1)) == [change]


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"convention": "skimage", "size": 1}, "size"),
        ({"masking": "windows", "convention": "skimage"}, "masking"),
        ({"masking": "windows", "convention": "wang-downsampled"}, "masking: expected 'mean'"),
    ],
)
def test_settings_that_exclude_each_other_are_refused(settings: dict[str, Any], message: str) -> None:
    a, b = pictures()
    with pytest.raises(ValueError, match=message):
        nf.ssim(a, b, data_range=1, mask=a > 0, **settings)


def test_numbers_of_pairs_must_agree() -> None:
    a, b = pictures()
    with pytest.raises(ValueError, match="tests, masks: expected axes"):
        nf.metrics.ssim_pairs([a] * 2, [b] * 3, data_range=1)


def test_settings_compare_as_keywords_do() -> None:
    a, b = pictures()
    settings = nf.SsimSettings(window="uniform", size=4, k1=0.02)
    expected = nf.ssim(a, b, data_range=1, window="uniform", size=7, k1=0.02)
    assert nf.ssim(a, b, data_range=1, settings=settings, size=7) == expected
    assert nf.metrics.ssim_pairs(a, b, data_range=1, settings=settings, size=7) == pytest.approx(float(expected))
    by_keywords = nf.metrics.ms_ssim(a, b, data_range=1, weights=[1.0], window="uniform", size=4, k1=0.02)
    assert nf.metrics.ms_ssim(a, b, data_range=1, weights=[1.0], settings=settings) == by_keywords
    with pytest.raises(ValueError, match="convention: expected 'wang' for several scales, got 'full'"):
        nf.metrics.ms_ssim(a, b, data_range=1, convention="full")


def test_a_similarity_is_a_float_that_carries_its_map() -> None:
    a, b = pictures(40, 50)
    alone, full = nf.ssim(a, b, data_range=1), nf.ssim(a, b, data_range=1, full=True)
    assert isinstance(alone, float)
    assert float(alone) == pytest.approx(float(full), abs=1e-12)
    assert f"{alone:.3f}" == f"{float(alone):.3f}"
    assert json.dumps([alone]) == json.dumps([float(alone)])
    mean, similarities = full
    assert type(mean) is float
    assert similarities is full.map
    assert similarities.shape == a.shape
    again = pickle.loads(pickle.dumps(full))
    assert again == full
    np.testing.assert_array_equal(again.map, full.map)
    with pytest.raises(ValueError, match="full=True"):
        _ = alone.map
