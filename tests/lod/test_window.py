"""Scores with the thesis' window: against the plain definition, and against `measure` with Wang's window."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.lod import window
from nearfar.lod._measure.views import Screen
from tests.support.lod_cases import FOV, SMALL, Array, levels


def weights(options: dict[str, Any]) -> Array:
    """Return a window's weights, in the middle of its pixels."""
    size = options.get("size", 11)
    if "window" in options:
        return np.full((size, size), 1 / size**2)
    across = np.exp(-((np.arange(size) - (size - 1) / 2) ** 2) / (2 * 1.5**2))
    both = np.outer(across, across)
    return np.asarray(both / both.sum())


def plain(base: Array, other: Array, mask: NDArray[np.bool_], options: dict[str, Any]) -> float:
    """Evaluate Wang's Eq. 13 window by window; an even one extends one pixel further up and left."""
    weight = weights(options)
    side = len(weight)
    before = side // 2
    found = []
    for row, column in np.argwhere(mask):
        top, left = row - before, column - before
        if top < 0 or left < 0 or top + side > mask.shape[0] or left + side > mask.shape[1]:
            continue
        x, y = (picture[top : top + side, left : left + side] for picture in (base, other))
        mean_x, mean_y = (weight * x).sum(), (weight * y).sum()
        var_x, var_y = (weight * (x - mean_x) ** 2).sum(), (weight * (y - mean_y) ** 2).sum()
        both = (weight * (x - mean_x) * (y - mean_y)).sum()
        c1, c2 = (0.01 * 255) ** 2, (0.03 * 255) ** 2
        found.append(
            (2 * mean_x * mean_y + c1) * (2 * both + c2) / ((mean_x**2 + mean_y**2 + c1) * (var_x + var_y + c2))
        )
    return float(np.mean(found))


@pytest.mark.parametrize("name", window.WINDOWS)
def test_windows_equal_their_definition(name: str) -> None:
    random = np.random.default_rng(0)
    base, other = random.uniform(0, 255, (2, 24, 30))
    mask = random.random((24, 30)) < 0.4
    options = window.WINDOWS[name]
    found = nf.ssim_pairs(base, other, data_range=255.0, masks=mask, **options)
    assert float(found) == pytest.approx(plain(base, other, mask, options), abs=1e-12)


def test_our_window_equals_that_of_measure() -> None:
    own = levels(12, 8, 5)
    model = nf.lod.measure(own, **SMALL, step=None, saturated=None, cache=False)
    found = window.scores(own, Screen.from_arguments(None, FOV, (128, 128)), (1, 2, 4), 8, 1)
    assert model.samples is not None
    assert model.samples.views is not None
    np.testing.assert_allclose(found[0], model.samples.views[1:, [0, 1, 3]], rtol=0, atol=1e-7)
    # The other windows differ a little.
    for other in found[1:]:
        assert 0 < np.abs(other - found[0]).max() < 0.2
    (gaussian, uniform) = window.rows("ball", found)
    assert gaussian[:2] == ["ball", "Gaussian, 10 × 10"]
    assert float(gaussian[3]) < float(uniform[3])
