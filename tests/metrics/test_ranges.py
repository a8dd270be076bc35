"""Tests of the check of pictures' values against `data_range`, by NumPy over all pixels in windows."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given, strategies as st
from numpy.typing import NDArray

import nearfar as nf

Picture = NDArray[Any]

INTERVALS: dict[type, list[tuple[float, float]]] = {
    np.uint8: [(0, 100), (100, 200)],
    np.uint16: [(0, 255), (100, 355), (9000, 9255)],
    np.float32: [(0, 1), (-0.5, 0.5), (-1, 1), (100, 300)],
    np.float64: [(0, 1), (-0.5, 0.5), (-1, 1), (100, 300), (1e6, 1e6 + 1)],
}
"""Minimum and maximum value of pictures of each type, whose difference is `data_range`."""

METRICS: dict[str, Callable[..., Any]] = {
    "ssim": nf.ssim,
    "ssim, even window": lambda a, b, **options: nf.ssim(a, b, size=8, window="uniform", **options),
    "ssim, full": lambda a, b, **options: nf.ssim(a, b, convention="full", **options),
    "ssim, map": lambda a, b, **options: nf.ssim(a, b, full=True, **options),
    "ssim_pairs": nf.ssim_pairs,
    "ms_ssim": lambda a, b, **options: nf.ms_ssim(a, b, size=3, **options),
}

SHAPES = st.tuples(st.integers(60, 200), st.integers(80, 290))
"""Shapes of pictures of one tile and of several."""


def between(random: np.random.Generator, kind: type, shape: tuple[int, int], ends: tuple[float, float]) -> Picture:
    """Return two pictures with values in an interval, whose ends both occur."""
    values = random.uniform(*ends, (2, *shape))
    both: Picture = np.asarray(np.round(values) if np.issubdtype(kind, np.integer) else values, kind)
    for picture in both:
        places = random.choice(picture.size, 2, replace=False)
        picture.flat[places] = ends
    return both


def refusal(values: Picture, extent: float) -> str | None:
    """Return the expected message for values in windows; None if they lie within the range."""
    least, greatest = float(np.nanmin(values)), float(np.nanmax(values))
    allowed = 0.0
    if values.dtype.kind == "f":
        allowed = 1e-6 * extent + float(np.finfo(values.dtype).eps) * (abs(least) + abs(greatest))
    if greatest - least <= extent + allowed:
        return None
    return (
        f"data_range: expected at least {greatest - least:.9g}, because the pictures' values reach from {least:.9g} to "
        f"{greatest:.9g}, got {extent:.9g}"
    )


def check(metric: Callable[..., Any], both: Picture, seen: Any, extent: float, **options: Any) -> bool:
    """Compare a metric's answer with NumPy's; returns whether it accepts the pictures."""
    expected = refusal(both[:, seen], extent)
    if expected is None:
        assert np.isfinite(np.mean(metric(*both, data_range=extent, **options)))
        return True
    with pytest.raises(ValueError, match=f"^{re.escape(expected)}$"):
        metric(*both, data_range=extent, **options)
    return False


@given(st.integers(0, 2**32 - 1), SHAPES, st.sampled_from(sorted(METRICS)), st.sampled_from(list(INTERVALS)))
def test_values_may_lie_in_any_interval_as_long_as_the_range(
    seed: int, shape: tuple[int, int], name: str, kind: type
) -> None:
    random = np.random.default_rng(seed)
    is_whole = np.issubdtype(kind, np.integer)
    for ends in INTERVALS[kind]:
        extent, metric = ends[1] - ends[0], METRICS[name]
        both = between(random, kind, shape, ends)
        assert check(metric, both, ..., extent)
        both[both == 0] = kind(-0.0)
        assert check(metric, both, ..., extent)
        # Steps beyond either end, small and great, in parts far from each other and in either picture.
        step = 1 if is_whole else random.choice([2e-6, 0.01, 1]) * extent
        beyond = both.copy()
        for end, sign in zip(ends, (-1, 1), strict=True):
            if random.integers(2) and (end + sign * step >= 0 or not is_whole):
                beyond[int(random.integers(2))].flat[random.integers(both[0].size)] = end + sign * step
        check(metric, beyond, ..., extent)


@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_values_below_zero_and_at_the_range_are_combined(kind: type) -> None:
    both: Picture = np.full((2, 200, 300), 0.5, kind)
    both[0, 10, 10], both[1, 190, 290] = -0.25, 1
    assert not check(nf.ssim, both, ..., 1.0)
    assert check(nf.ssim, both, ..., 1.25)
    both[0, 10, 10] = 0.5
    both[1, 190, 290] = 1.25
    assert check(nf.ssim, both, ..., 1.0)
    both[1, 10, 290] = 0
    assert not check(nf.ssim, both, ..., 1.0)


@given(
    st.integers(0, 2**32 - 1),
    SHAPES,
    st.sampled_from(list(INTERVALS)),
    st.sampled_from(["mean", "windows"]),
    st.booleans(),
)
def test_messages_cover_only_windows_of_a_mask(
    seed: int, shape: tuple[int, int], kind: type, masking: str, full: bool
) -> None:
    random = np.random.default_rng(seed)
    mask, seen = np.zeros((2, *shape), bool)
    for row, column in zip(*(random.integers(5, length - 5, 4) for length in shape), strict=True):
        mask[row, column] = True
        seen[row - 5 : row + 6, column - 5 : column + 6] = True
    options: dict[str, Any] = {"mask": mask, "masking": masking, "full": full}
    named = mask if masking == "windows" else seen

    def metric(a: Picture, b: Picture, **more: Any) -> float:
        return float(nf.ssim(a, b, **more))

    is_whole = np.issubdtype(kind, np.integer)
    for ends in INTERVALS[kind]:
        both = between(random, kind, shape, ends)
        extent = ends[1] - ends[0]
        assert check(metric, both, named, extent, **options)
        for place in random.integers(0, both[0].size, 6):
            both[int(random.integers(2))].flat[place] = 0 if is_whole else -0.75 * extent
        # Values outside all windows are arbitrary.
        both[0].flat[random.choice(np.flatnonzero(~named))] = np.iinfo(kind).max if is_whole else np.nan
        check(metric, both, named, extent, **options)
        both[1].flat[random.choice(np.flatnonzero(named))] = ends[1] + (1 if is_whole else extent)
        check(metric, both, named, extent, **options)
