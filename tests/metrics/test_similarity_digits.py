"""Tests of the precision of structural similarity: high means, outliers, extreme values."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from tests.support.similarity_oracle import pictures, slow_maps, slow_masked, unlimited, weights


def hard_pictures() -> Iterator[tuple[str, NDArray[np.float32], NDArray[np.float32], float]]:
    """Return float32 pictures whose variance is easily lost in rounding."""
    a, b = (p.astype(np.float32) for p in pictures(150, 210))
    for offset in (10.0, 1e3, 1e4):
        yield f"offset {offset:g}", a + np.float32(offset), b + np.float32(offset), 1.0
    dot = np.full((150, 210), 0.5, np.float32)
    dot[70, 100] += np.float32(1e-3)
    yield "a pixel", np.full_like(dot, 0.5), dot, 1.0
    yield "constants", np.full_like(dot, 0.25), np.full_like(dot, 0.75), 1.0
    edge = np.where(np.arange(210) < 90, 0, 1).astype(np.float32) * np.ones_like(dot)
    yield "an edge", edge, edge * np.float32(0.98), 1.0
    yield "high dynamic range", np.exp(8 * a), np.exp(8 * b), 1.0
    yield "sixteen bits", np.round(60_000 + 4000 * a), np.round(60_000 + 4000 * b), 65_535.0


@pytest.mark.parametrize("case", list(hard_pictures()), ids=lambda case: case[0])
def test_float32_agrees_with_float64(case: tuple[str, NDArray[np.float32], NDArray[np.float32], float]) -> None:
    _, a, b, extent = case
    windows: list[dict[str, Any]] = [{}, {"window": "uniform", "size": 7}, {"window": "gaussian", "size": 10}]
    for window in windows:
        options = {**window, **unlimited(a, b, extent=extent)}
        mean, found = nf.ssim(a, b, full=True, **options)
        exact_mean, exact = nf.ssim(*(p.astype(np.float64) for p in (a, b)), full=True, **options)
        assert abs(mean - exact_mean) < 1e-6
        assert np.abs(found - exact).max() < 1e-5


def outliers(kind: type) -> Iterator[tuple[str, NDArray[Any], NDArray[Any]]]:
    """Return pictures whose values lie far apart, so that no value is near their mean."""
    random = np.random.default_rng(3)
    base = 0.5 + 0.1 * random.random((100, 140))
    noisy = base + 0.02 * random.random(base.shape)
    y, x = np.mgrid[:100, :140]
    sun = np.hypot(y - 40, x - 60) < 12
    for value in (1e3, 65504.0, 1e6, 1e9, 1e20):
        for name, (a, b) in {
            "a sun": [np.where(sun, value, p) for p in (base, noisy)],
            "a pixel": [np.where((y == 56) & (x == 56), value, p) for p in (base, noisy)],
            "half raised": [p + np.where(x < 50, value, 0) for p in (base, noisy)],
        }.items():
            yield f"{name} {value:g}", a.astype(kind), b.astype(kind)
    yield "values that squares of float32 lose", (1e10 * base).astype(kind), (2.5e9 * noisy).astype(kind)


@pytest.mark.parametrize("kind", [np.float32, np.float64])
@pytest.mark.parametrize("window", ["gaussian", "uniform"])
def test_precision_is_kept_beside_outliers(kind: type, window: Any) -> None:
    size = 11 if window == "gaussian" else 4
    part = np.s_[36:66, 42:72]  # crosses the edges of all areas of outliers
    for name, a, b in outliers(kind):
        exact, _ = slow_maps(a[part], b[part], weights(window, size), 1.0)
        exact, options = exact[size:-size, size:-size], unlimited(a, b)
        _, found = nf.ssim(a, b, **options, window=window, size=size, full=True)
        np.testing.assert_allclose(
            found[part][size:-size, size:-size], exact, rtol=0, atol=1e-5 if kind == np.float32 else 1e-10, err_msg=name
        )
        near = np.abs(a[part]) < 1
        if not near.any():
            continue
        seen = nf.ssim(a[part], b[part], **options, mask=near, masking="windows", full=True).map
        expected = slow_masked(a[part], b[part], near, weights("gaussian", 11), 1.0)
        np.testing.assert_allclose(seen, expected, rtol=0, atol=1e-10 if kind == np.float64 else 1e-6, err_msg=name)
        whole = np.ones(a.shape, bool)
        both = nf.ssim(a, b, **options, mask=whole, masking="windows", full=True).map[60:, 80:]
        alone = nf.ssim(a[40:, 60:], b[40:, 60:], **options, mask=whole[40:, 60:], masking="windows", full=True).map
        np.testing.assert_allclose(
            both, alone[20:, 20:], rtol=0, atol=1e-9 if kind == np.float64 else 1e-6, err_msg=name
        )


@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_pixels_outside_windows_of_a_mask_have_no_effect(kind: type) -> None:
    for name, a, b in outliers(kind):
        # Far from all outliers, though these lie within the mask's box.
        far = np.abs(a) > 1
        for _ in range(6):
            grown = np.pad(far, 1)
            far = grown[1:-1, 1:-1] | grown[2:, 1:-1] | grown[:-2, 1:-1] | grown[1:-1, 2:] | grown[1:-1, :-2]
            grown = np.pad(far, 1)
            far = far | grown[2:, 2:] | grown[:-2, :-2] | grown[2:, :-2] | grown[:-2, 2:]
        if far.all():
            continue
        plain: list[NDArray[Any]] = [np.where(np.abs(a) > 1, 0.5, p).astype(kind) for p in (a, b)]
        options = unlimited(a, b)
        expected = nf.ssim(*plain, **options, mask=~far)
        # Local means differ, and with them rounding.
        tolerance = 1e-12 if kind == np.float64 else 1e-6
        assert nf.ssim(a, b, **options, mask=~far) == pytest.approx(expected, abs=tolerance), name


def test_uniform_areas_far_from_the_mean_stay_exact() -> None:
    # Two halves of one tile: rounding is the same for all windows of a half and does not average out.
    left = np.arange(128) < 64
    random = np.random.default_rng(0)

    def apart(a: NDArray[Any], b: NDArray[Any], k1: float = 0.01) -> float:
        single = [p.astype(np.float32) for p in (a, b)]
        double = [p.astype(np.float64) for p in single]
        options = unlimited(a, b)
        options["k1"] *= k1 / 0.01
        return float(abs(nf.ssim(*single, **options) - nf.ssim(*double, **options)))

    for dark, bright in ((4.3e-3, 2.161), (4.3e-3, 1.04), (1e-6, 0.5), (0.02, 900.0)):
        for k1 in (0.01, 1e-3, 1e-6):
            a, b = (np.where(left, factor * dark, bright) * np.ones((40, 1)) for factor in (1, 2.97))
            assert apart(a, b, k1=k1) < 1e-6, (dark, bright, k1)
    for _ in range(40):
        share, level = random.uniform(0.1, 0.7), random.uniform(1, 60)
        steps = random.integers(0, 2, (40, 128)) * random.choice([0.05, 2])
        assert apart(np.where(left, -level, level) + steps, np.where(left, -level, level) + share * steps) < 1e-6


def test_values_around_zero_and_beyond_the_range_keep_their_luminance() -> None:
    random = np.random.default_rng(1)
    noise = random.standard_normal((60, 150))
    other = noise + 0.5 * random.standard_normal(noise.shape)
    for scale in (1, 10, 100):
        for step in (0, 30, 5000):
            a, b = ((scale * p + np.where(np.arange(150) < 64, 0, step)).astype(np.float32) for p in (noise, other))
            options = unlimited(a, b)
            found = nf.ssim(a, b, **options, full=True).map
            exact = nf.ssim(a.astype(np.float64), b.astype(np.float64), **options, full=True).map
            np.testing.assert_allclose(found, exact, rtol=0, atol=1e-5, err_msg=f"{scale} {step}")


def test_extreme_contrasts_are_not_treated_as_zero() -> None:
    checks = (np.indices((60, 80)).sum(axis=0) % 2) * 2.0 - 1.0
    for kind in (np.float32, np.float64):
        # At greater scales the rounding of the mean exceeds c1, and the similarity is undefined.
        for scale in (1.0, 1e10, 1e20):
            a = (checks * scale).astype(kind)
            assert nf.ssim(a, -a, **unlimited(a), window="uniform", size=8) == pytest.approx(-1.0, abs=1e-2)
            assert nf.ssim(a, -a, **unlimited(a), window="global") == pytest.approx(-1.0, abs=1e-2)


@pytest.mark.parametrize(("size", "sigma"), [(10, 0.01), (11, 0.01), (10, 1e-200), (4, 1e3), (1, 0.1)])
def test_windows_of_any_width_have_weights(size: int, sigma: float) -> None:
    a, b = pictures(23, 29)
    offsets = np.abs(np.arange(size) - (size - 1) / 2)
    line = (
        weights("gaussian", size, sigma)
        if sigma > 0.05
        else (offsets == offsets.min()) / (offsets == offsets.min()).sum()
    )
    expected, _ = slow_maps(a, b, line, 1.0)
    found = nf.ssim(a, b, data_range=1, size=size, sigma=sigma, full=True).map
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12)


def test_float64_keeps_the_variance_at_any_level() -> None:
    a, b = pictures(40, 50)
    # Multiples of 2⁻²⁰ survive adding 10⁸, so that the shifted pictures differ only by their mean.
    a, b = (np.round(p * 2**20) / 2**20 for p in (a, b))
    shifted, _ = slow_maps(a + 1e8, b + 1e8, weights("gaussian", 11), 1.0)
    found = nf.ssim(a + 1e8, b + 1e8, **unlimited(a + 1e8), full=True).map
    np.testing.assert_allclose(found, shifted, rtol=0, atol=1e-9)


@pytest.mark.parametrize("masking", ["mean", "windows"])
def test_pixels_outside_windows_of_a_mask_change_no_bit(masking: Any) -> None:
    random = np.random.default_rng(0)
    for _ in range(50):
        height, width = random.integers(30, 60, 2)
        a = random.uniform(0, 255, (height, width))
        b = np.clip(a + random.normal(0, 20, a.shape), 0, 255)
        mask, seen = np.zeros(a.shape, bool), np.zeros(a.shape, bool)
        for row, column in zip(random.integers(5, height - 5, 3), random.integers(5, width - 5, 3), strict=True):
            mask[row, column] = True
            seen[row - 5 : row + 6, column - 5 : column + 6] = True
        found = [
            nf.ssim(one, other, data_range=255, mask=mask, masking=masking)
            for one, other in ((a, b), (np.where(seen, a, 0), np.where(seen, b, 0)))
        ]
        assert float(found[0]) == float(found[1])
