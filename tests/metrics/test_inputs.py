"""Tests of pictures and value ranges that metrics accept, and of refused inputs."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given, strategies as st
from numpy.typing import NDArray
from PIL import Image

import nearfar as nf
from tests.support.reduce_cases import CENTER, camera, street
from tests.support.similarity_oracle import pictures

Metric = Callable[..., float]


def pairwise(a: Any, b: Any, **options: Any) -> float:
    return float(nf.metrics.ssim_pairs(a, b, convention="full", **options))


def continuity(a: Any, b: Any, **options: Any) -> float:
    return next(nf.metrics.visual_continuity([a, b], **options))


METRICS: dict[str, Metric] = {
    "psnr": nf.psnr,
    "ssim": lambda a, b, **options: nf.ssim(a, b, size=1, **options),
    "ssim, global": lambda a, b, **options: nf.ssim(a, b, window="global", **options),
    "ssim, map": lambda a, b, **options: nf.ssim(a, b, full=True, convention="full", **options),
    "ssim, downsampled": lambda a, b, **options: nf.ssim(a, b, convention="wang-downsampled", size=1, **options),
    "ssim_pairs": pairwise,
    "ms_ssim": lambda a, b, **options: nf.metrics.ms_ssim(a, b, size=3, **options),
    "visual_continuity": continuity,
}


@pytest.mark.parametrize("name", sorted(METRICS.keys() - {"ssim_pairs"}))
def test_frames_refuse_a_data_range(name: str) -> None:
    frames = [nf.render(street(), camera(CENTER, (1, y, 0)), channels=("color",)) for y in (0, 0.02)]
    assert np.isfinite(METRICS[name](*frames))
    for wrong in (255, 1.0):
        with pytest.raises(ValueError, match="data_range: expected none for frames, whose values"):
            METRICS[name](*frames, data_range=wrong)


# range of values ------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("name", METRICS)
@pytest.mark.parametrize("kind", [np.uint8, np.uint16, np.float32, np.float64])
def test_values_that_differ_by_more_than_the_range_are_refused(name: str, kind: type) -> None:
    both: list[NDArray[Any]] = [np.asarray(np.round(200 * p), kind) for p in pictures(300, 400)]
    lowest, highest = (float(f(both)) for f in (np.min, np.max))
    for level in (0, 50) if kind is np.uint8 else (0, 9000) if kind is np.uint16 else (0, 9000, -100, -200):
        shifted = [p + kind(level) for p in both]
        assert np.isfinite(METRICS[name](*shifted, data_range=highest - lowest))
        for wrong in (1, highest - lowest - 0.01):
            message = (
                f"data_range: expected at least {highest - lowest:g}, .* from {lowest + level:g} to .*, got {wrong:g}"
            )
            with pytest.raises(ValueError, match=message):
                METRICS[name](*shifted, data_range=wrong)


@given(
    st.integers(0, 2**32 - 1),
    st.tuples(st.integers(1, 210), st.integers(1, 300)),
    st.sampled_from(sorted(METRICS.keys() - {"ms_ssim"})),
    st.sampled_from([np.uint8, np.float32, np.float64]),
    st.sampled_from(["rows", "columns"]),
)
def test_every_pixel_is_checked(seed: int, shape: tuple[int, int], name: str, kind: type, layout: str) -> None:
    random = np.random.default_rng(seed)
    a, b = (np.asarray(p, order="C" if layout == "rows" else "F") for p in random.integers(60, 161, (2, *shape)))
    one: NDArray[Any] = np.asarray(a, kind)
    other: NDArray[Any] = np.asarray(b, kind)
    # Equal pictures, which small ones may be, have an infinite PSNR.
    assert not np.isnan(METRICS[name](one, other, data_range=100))
    place = tuple(int(random.integers(length)) for length in shape)
    (one, other)[seed % 2][place] = 30 if seed % 3 else 190
    lowest, highest = min(one.min(), other.min()), max(one.max(), other.max())
    if highest - lowest > 100:
        with pytest.raises(ValueError, match="data_range: expected at least"):
            METRICS[name](one, other, data_range=100)


def test_rounding_is_tolerated_and_overshoots_are_not() -> None:
    white = np.ones((20, 30), np.float32)
    luma = white + np.finfo(np.float32).eps
    assert nf.psnr(luma, 0 * white, data_range=1) == pytest.approx(0.0, abs=1e-5)
    assert nf.ssim(luma.astype(np.float64), 0 * white, data_range=1) < 1e-3
    # Float32 steps at 9,000 are a thousandth.
    level = white * np.float32(9000.1)
    nf.ssim(level, level + np.float32(1.0), data_range=1)
    for overshoot in (1e-3, 1e-5):
        with pytest.raises(ValueError, match=r"data_range: expected at least 1\.0"):
            nf.ssim(white + np.float32(overshoot), 0 * white, data_range=1)


@pytest.mark.parametrize("masking", ["mean", "windows"])
@pytest.mark.parametrize("window", ["gaussian", "uniform", "global"])
def test_only_pixels_in_windows_of_a_mask_are_checked(masking: Any, window: Any) -> None:
    a, b = pictures(60, 300)
    mask = np.zeros(a.shape, bool)
    mask[20:23, 20] = mask[40, 200:230] = True
    options: dict[str, Any] = {"data_range": 1, "mask": mask, "masking": masking, "window": window, "size": 6}
    expected = nf.ssim(a, b, **options)
    # Windows of 6 pixels extend 3 up and left and 2 down and right.
    near = {(20, 20): True, (17, 17): True, (24, 22): True, (42, 231): True, (16, 17): False, (42, 232): False}
    for place, is_near in near.items():
        sun = a.copy()
        sun[place] = 50
        is_seen = mask[place] if masking == "windows" else is_near or window == "global"
        if is_seen:
            with pytest.raises(ValueError, match="data_range: expected at least"):
                nf.ssim(sun, b, **options)
        else:
            assert nf.ssim(sun, b, **options) == pytest.approx(expected, abs=1e-12)
            found = nf.metrics.ssim_pairs([sun, a], b, data_range=1, masks=mask, masking=masking, window=window, size=6)
            np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12)


def test_masks_of_downsampled_pictures_choose_boxes() -> None:
    a, b = pictures(600, 700)
    mask = np.zeros(a.shape, bool)
    mask[300:340, 300:340] = True
    options: dict[str, Any] = {"data_range": 1, "convention": "wang-downsampled", "mask": mask}
    expected = nf.ssim(a, b, **options)
    a[100, 650] = 3
    assert nf.ssim(a, b, **options) == pytest.approx(expected, abs=1e-12)
    a[320, 320] = 3
    with pytest.raises(ValueError, match="data_range"):
        nf.ssim(a, b, **options)


def test_pairs_are_checked_one_by_one() -> None:
    a, b = pictures(30, 40)
    levels = np.array([0.0, 50.0, 1000.0])[:, None, None]
    np.testing.assert_allclose(nf.metrics.ssim_pairs(a + levels, a + levels, data_range=1), 1.0)
    with pytest.raises(ValueError, match="data_range: expected at least 5"):
        nf.metrics.ssim_pairs(a + levels, b + levels * [[[1]], [[1.1]], [[1]]], data_range=1)


# channels -------------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("name", ["ssim", "ms_ssim", "visual_continuity"])
def test_the_channel_axis_is_the_last_one_or_explicit(name: str) -> None:
    a, b = (np.stack([p, p**2, 1 - p]) for p in pictures(60, 80))
    metric = METRICS[name]
    expected = metric(np.moveaxis(a, 0, -1), np.moveaxis(b, 0, -1), data_range=1)
    for axis in (0, 1, 2, -1, -2, -3):
        moved = [np.moveaxis(p, 0, axis) for p in (a, b)]
        assert metric(*moved, data_range=1, channel_axis=axis) == pytest.approx(expected, abs=1e-12)
    alone = metric(a[0], b[0], data_range=1)
    assert metric(a[0, ..., None], b[0, ..., None], data_range=1) == alone
    for wrong in (a, b[:, None], np.stack([a[0]] * 8), np.stack([a[0]] * 5, axis=-1)):
        message = r"channel_axis: expected the axis .* nearfar\.metrics\.ssim_pairs compares stacks of pictures"
        with pytest.raises(ValueError, match=message):
            metric(wrong, wrong, data_range=1)
    for axis, picture in ((3, a), (-4, a), (-1, a[0]), (0, a[None])):
        with pytest.raises(ValueError, match="channel_axis"):
            metric(picture, picture, data_range=1, channel_axis=axis)


def test_maps_have_the_pictures_axes() -> None:
    a, b = (np.stack([p, 1 - p]) for p in pictures(20, 30))
    expected = np.stack([nf.ssim(x, y, data_range=1, full=True).map for x, y in zip(a, b, strict=True)])
    for axis in (0, 1, 2):
        moved = [np.moveaxis(p, 0, axis) for p in (a, b)]
        found = nf.ssim(*moved, data_range=1, channel_axis=axis, full=True).map
        np.testing.assert_array_equal(found, np.moveaxis(expected, 0, axis))


@pytest.mark.parametrize("name", ["psnr", "ssim", "ms_ssim", "visual_continuity", "rmse"])
@pytest.mark.parametrize("channels", [2, 4])
def test_alpha_is_refused(name: str, channels: int) -> None:
    metric: Metric = nf.metrics.rmse if name == "rmse" else METRICS[name]
    options = {} if name == "rmse" else {"data_range": 255}
    a, b = np.random.default_rng(0).integers(0, 256, (2, 40, 50, channels), np.uint8)
    a[..., -1] = b[..., -1] = 255
    with pytest.raises(ValueError, match="reference: expected pictures without alpha"):
        metric(a, b, **options)
    assert np.isfinite(metric(a[..., : channels - 1], b[..., : channels - 1], **options))
    if name in ("ssim", "ms_ssim", "visual_continuity"):
        assert np.isfinite(metric(a, b, channel_axis=-1, **options))
    else:
        assert np.isfinite(metric(a.reshape(40, -1), b.reshape(40, -1), **options))


def test_colour_channels_are_distinguished_from_stacks() -> None:
    a, b = np.random.default_rng(0).random((2, 5, 30, 40, 3))
    with pytest.raises(ValueError, match="references: expected shape"):
        nf.metrics.ssim_pairs(a, b, data_range=1)
    each = nf.metrics.ssim_pairs(*(np.moveaxis(p, -1, -3) for p in (a, b)), data_range=1)
    np.testing.assert_allclose(each.mean(axis=1), [nf.ssim(x, y, data_range=1) for x, y in zip(a, b, strict=True)])


# Pillow ---------------------------------------------------------------------------------------------------------------
def of_mode(mode: str, values: NDArray[np.uint8]) -> Any:
    if mode.startswith("I;16"):
        return Image.fromarray(values.astype(np.uint16) * 257).convert(mode)
    return Image.fromarray(values).convert("RGB").convert(mode)


@pytest.mark.parametrize("mode", ["1", "L", "RGB", "I", "F", "I;16"])
def test_images_of_grey_and_rgb_are_their_values(mode: str) -> None:
    values = np.random.default_rng(0).integers(0, 256, (2, 20, 30), np.uint8)
    a, b = (of_mode(mode, picture) for picture in values)
    extent = {"1": 1, "I;16": 65_535}.get(mode, 255)
    exact = [np.asarray(image).astype(np.float64) for image in (a, b)]
    assert nf.ssim(a, b, data_range=extent) == pytest.approx(nf.ssim(*exact, data_range=extent), abs=1e-6)
    assert nf.psnr(a, b, data_range=extent) == pytest.approx(nf.psnr(*exact, data_range=extent), abs=1e-9)


@pytest.mark.parametrize("mode", ["P", "PA", "RGBA", "LA", "RGBX", "CMYK", "YCbCr", "HSV", "LAB"])
def test_images_of_other_modes_are_refused(mode: str) -> None:
    values = np.random.default_rng(0).integers(0, 256, (2, 20, 30), np.uint8)
    a, b = (of_mode(mode, picture) for picture in values)
    calls: list[Callable[[], Any]] = [
        *(lambda metric=metric: metric(a, b, data_range=255) for metric in METRICS.values()),
        lambda: nf.metrics.rmse(a, b),
        lambda: nf.metrics.ssim_pairs([a, a], [b, b], data_range=255),
    ]
    for call in calls:
        with pytest.raises(ValueError, match="expected an image of mode 1, L, RGB"):
            call()
    with pytest.raises(ValueError, match="test: expected an image of mode"):
        nf.metrics.rmse(np.asarray(a), b)
