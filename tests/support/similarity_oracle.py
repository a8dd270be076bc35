"""Structural similarity by its definition, window by window, and pictures for tests."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def pictures(height: int = 37, width: int = 53) -> tuple[Array, Array]:
    """Two smooth pictures in 0..1 that differ a little, without random numbers."""
    y, x = np.mgrid[:height, :width].astype(np.float64)
    first = 0.5 + 0.3 * np.sin(0.31 * x + 0.02 * x * y) + 0.2 * np.cos(0.23 * y)
    return first, np.clip(first + 0.05 * np.sin(1.7 * x - 0.9 * y), 0, 1)


def unlimited(*pictures: NDArray[Any], extent: float = 1.0) -> dict[str, Any]:
    """Arguments of `ssim` with the constants of a data range, but with a range that contains all values."""
    holds = max(extent, 2.0 * max(float(np.abs(picture[np.isfinite(picture)]).max()) for picture in pictures))
    return {"data_range": holds, "k1": 0.01 * extent / holds, "k2": 0.03 * extent / holds}


def weights(window: str, size: int, sigma: float = 1.5) -> Array:
    """Weights along one direction, which sum to 1."""
    offsets = np.arange(size) - (size - 1) / 2
    values = np.exp(-0.5 * (offsets / sigma) ** 2) if window == "gaussian" else np.ones(size)
    return np.asarray(values / values.sum())


def of_window(x: Array, y: Array, window: Array, c1: float, c2: float, sample: float = 1.0) -> tuple[float, float]:
    """Wang et al. (2004), Eq. 13, and its second factor; `sample` is a factor of covariances."""
    mx, my = (window * x).sum(), (window * y).sum()
    vx, vy = (window * (x - mx) ** 2).sum() * sample, (window * (y - my) ** 2).sum() * sample
    cov = (window * (x - mx) * (y - my)).sum() * sample
    contrast = (2 * cov + c2) / (vx + vy + c2)
    return float((2 * mx * my + c1) / (mx**2 + my**2 + c1) * contrast), float(contrast)


def slow_maps(a: Any, b: Any, line: Array, extent: float, sample: float = 1.0) -> tuple[Array, Array]:
    """Similarity and its second factor around each pixel, pictures mirrored at their borders."""
    size = len(line)
    before = size // 2
    padded = [np.pad(np.asarray(p, np.float64), [(before, size - 1 - before)] * 2, mode="symmetric") for p in (a, b)]
    window, constants = np.outer(line, line), ((0.01 * extent) ** 2, (0.03 * extent) ** 2)
    out = np.empty((2, *np.shape(a)))
    for i, j in np.ndindex(*np.shape(a)):
        x, y = (picture[i : i + size, j : j + size] for picture in padded)
        out[:, i, j] = of_window(x, y, window, *constants, sample)
    return out[0], out[1]


def inner_values(values: Array, size: int) -> Array:
    """Values of windows within the picture; all if there is none."""
    before, after = size // 2, size - 1 - size // 2
    rows, columns = (slice(before, length - after) for length in values.shape)
    kept = values[rows, columns]
    return kept if kept.size else values


def slow_masked(a: Any, b: Any, mask: NDArray[np.bool_], line: Array, extent: float) -> Array:
    """Similarity of a mask's pixels, with weights scaled to a sum of 1; NaN elsewhere."""
    size = len(line)
    pads = [(size // 2, size - 1 - size // 2)] * 2
    x, y = (np.pad(np.where(mask, p, 0).astype(np.float64), pads) for p in (a, b))
    named, window = np.pad(mask.astype(np.float64), pads), np.outer(line, line)
    out = np.full(mask.shape, np.nan)
    for i, j in np.argwhere(mask):
        part = (slice(i, i + size), slice(j, j + size))
        seen = window * named[part]
        out[i, j], _ = of_window(x[part], y[part], seen / seen.sum(), (0.01 * extent) ** 2, (0.03 * extent) ** 2)
    return out


def shrunk(picture: Any, factor: int) -> Array:
    """Every `factor`-th pixel of box means of that width, as MATLAB's imfilter(…, 'symmetric') computes them."""
    reach = (factor - 1) // 2
    padded = np.pad(np.asarray(picture, np.float64), [(reach, factor - 1 - reach)] * 2, mode="symmetric")
    views = np.lib.stride_tricks.sliding_window_view(padded, (factor, factor))
    return np.asarray(views[::factor, ::factor].mean(axis=(-2, -1)))
